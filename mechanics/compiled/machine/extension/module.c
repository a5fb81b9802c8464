static struct PyModuleDef module = {
    PyModuleDef_HEAD_INIT, .m_name = "mechanics_direct", .m_size = -1,
};

PyMODINIT_FUNC PyInit_mechanics_direct(void)
{
    import_array();
    PyObject *made = PyModule_Create(&module);
    if (made == NULL)
        return NULL;
    if (PyModule_AddType(made, &CallerType) < 0 || PyModule_AddType(made, &BoundType) < 0
        || PyModule_AddType(made, &StatesType) < 0)
        Py_CLEAR(made);
    return made;
}
