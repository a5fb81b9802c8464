/*
 * Bound(address, inputs, outputs, keep)()
 *
 * Inputs and outputs are addresses; keep is what they belong to.
 */
typedef struct {
    PyObject_HEAD
    vectorcallfunc vectorcall;
    Kernel kernel;
    PyObject *keep;
    const double *arg[MOST];
    double *res[MOST];
} Bound;

static PyObject *bound_call(PyObject *object, PyObject *const *args, size_t nargsf, PyObject *names)
{
    Bound *self = (Bound *)object;
    (void)args;
    if (PyVectorcall_NARGS(nargsf) != 0 || names != NULL) {
        PyErr_SetString(PyExc_TypeError, "no arguments expected: the arrays are bound");
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    self->kernel(self->arg, self->res);
    Py_END_ALLOW_THREADS
    Py_RETURN_NONE;
}

static int read_addresses(PyObject *addresses, void **into)
{
    if (PyTuple_GET_SIZE(addresses) > MOST) {
        PyErr_Format(PyExc_ValueError, "at most %d inputs and outputs", MOST);
        return -1;
    }
    for (Py_ssize_t i = 0; i < PyTuple_GET_SIZE(addresses); ++i) {
        into[i] = PyLong_AsVoidPtr(PyTuple_GET_ITEM(addresses, i));
        if (into[i] == NULL && PyErr_Occurred())
            return -1;
    }
    return 0;
}

static PyObject *bound_new(PyTypeObject *type, PyObject *args, PyObject *names)
{
    unsigned long long address;
    PyObject *inputs, *outputs, *keep;
    (void)names;
    if (!PyArg_ParseTuple(args, "KO!O!O", &address, &PyTuple_Type, &inputs, &PyTuple_Type, &outputs,
            &keep))
        return NULL;
    Bound *self = (Bound *)type->tp_alloc(type, 0);
    if (self == NULL)
        return NULL;
    self->vectorcall = bound_call;
    self->kernel = (Kernel)(uintptr_t)address;
    self->keep = Py_NewRef(keep);
    if (read_addresses(inputs, (void **)self->arg) < 0
        || read_addresses(outputs, (void **)self->res) < 0)
        Py_CLEAR(self);
    return (PyObject *)self;
}

static void bound_dealloc(Bound *self)
{
    Py_XDECREF(self->keep);
    Py_TYPE(self)->tp_free((PyObject *)self);
}

static PyMemberDef bound_members[] = {
    {"__vectorcalloffset__", T_PYSSIZET, offsetof(Bound, vectorcall), READONLY, NULL},
    {NULL, 0, 0, 0, NULL},
};

static PyTypeObject BoundType = {
    PyVarObject_HEAD_INIT(NULL, 0)
    .tp_name = "mechanics_direct.Bound",
    .tp_basicsize = sizeof(Bound),
    .tp_flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL,
    .tp_new = bound_new,
    .tp_dealloc = (destructor)bound_dealloc,
    .tp_call = PyVectorcall_Call,
    .tp_vectorcall_offset = offsetof(Bound, vectorcall),
    .tp_members = bound_members,
};
