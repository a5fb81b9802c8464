/*
 * Caller(address, inputs, outputs, checked, keep)(q, u, inputs, p) -> array, tuple, or None
 *
 * Each input is (size, default array or None), each output (rows, columns, dimensions, asked). It
 * gives new arrays for the outputs that are asked, a matrix column by column. It takes
 * one-dimensional arrays of doubles, aligned, contiguous and in the machine's byte order, or None
 * for a default. Whatever else it gets, and where it is checked and a value is not finite, it gives
 * None: the way that explains is taken then.
 */
typedef struct {
    npy_intp size;
    const double *standard;
} Input;

typedef struct {
    npy_intp shape[2], size;
    int dimensions, asked;
} Output;

typedef struct {
    PyObject_HEAD
    vectorcallfunc vectorcall;
    Kernel kernel;
    PyObject *keep;
    Py_ssize_t ins, outs, asked;
    npy_intp unasked;
    int checked;
    Input in[MOST];
    Output out[MOST];
} Caller;

static const double *data_of(PyObject *given, const Input *in)
{
    if (given == Py_None)
        return in->standard;
    if (!PyArray_CheckExact(given))
        return NULL;
    PyArrayObject *array = (PyArrayObject *)given;
    if (PyArray_NDIM(array) != 1 || PyArray_DIM(array, 0) != in->size
        || PyArray_TYPE(array) != NPY_DOUBLE || !PyArray_ISCARRAY_RO(array))
        return NULL;
    return (const double *)PyArray_DATA(array);
}

static int all_finite(const Output *out, Py_ssize_t outs, double *const *data)
{
    for (Py_ssize_t i = 0; i < outs; ++i)
        for (npy_intp k = 0; k < out[i].size; ++k)
            if (!isfinite(data[i][k]))
                return 0;
    return 1;
}

/* Outputs without entries are no arguments of the kernel. */
static void run(Kernel kernel, const double *const *arg, const Output *out, Py_ssize_t outs,
    double *const *data)
{
    double *res[MOST];
    Py_ssize_t count = 0;
    for (Py_ssize_t i = 0; i < outs; ++i)
        if (out[i].size)
            res[count++] = data[i];
    Py_BEGIN_ALLOW_THREADS
    kernel(arg, res);
    Py_END_ALLOW_THREADS
}

static PyObject *result_of(const Caller *self, const double *const *arg, double *scratch)
{
    PyObject *made[MOST];
    double *data[MOST];
    Py_ssize_t count = 0;
    PyObject *result = NULL;
    for (Py_ssize_t i = 0; i < self->outs; ++i) {
        const Output *out = &self->out[i];
        if (!out->asked) {
            data[i] = scratch;
            scratch += out->size;
            continue;
        }
        PyObject *array = PyArray_EMPTY(out->dimensions, (npy_intp *)out->shape, NPY_DOUBLE, 1);
        if (array == NULL)
            goto done;
        made[count++] = array;
        data[i] = (double *)PyArray_DATA((PyArrayObject *)array);
    }
    run(self->kernel, arg, self->out, self->outs, data);
    if (self->checked && !all_finite(self->out, self->outs, data)) {
        result = Py_NewRef(Py_None);
    } else if (count == 1) {
        result = Py_NewRef(made[0]);
    } else if ((result = PyTuple_New(count)) != NULL) {
        for (Py_ssize_t i = 0; i < count; ++i)
            PyTuple_SET_ITEM(result, i, Py_NewRef(made[i]));
    }
done:
    while (count > 0)
        Py_DECREF(made[--count]);
    return result;
}

static PyObject *caller_call(PyObject *object, PyObject *const *args, size_t nargsf,
    PyObject *names)
{
    const Caller *self = (const Caller *)object;
    const double *arg[MOST];
    Py_ssize_t count = 0;
    if (PyVectorcall_NARGS(nargsf) != self->ins || names != NULL) {
        PyErr_Format(PyExc_TypeError, "%zd inputs expected, by position", self->ins);
        return NULL;
    }
    for (Py_ssize_t i = 0; i < self->ins; ++i) {
        const Input *in = &self->in[i];
        const double *data = data_of(args[i], in);
        if (data == NULL && (in->size || args[i] != Py_None))
            Py_RETURN_NONE;
        if (in->size)
            arg[count++] = data;
    }
    if (self->unasked <= SCRATCH) {
        double scratch[SCRATCH];
        return result_of(self, arg, scratch);
    }
    double *scratch = PyMem_New(double, self->unasked);
    if (scratch == NULL)
        return PyErr_NoMemory();
    PyObject *result = result_of(self, arg, scratch);
    PyMem_Free(scratch);
    return result;
}

static int read_inputs(Caller *self, PyObject *inputs)
{
    self->ins = PyTuple_GET_SIZE(inputs);
    for (Py_ssize_t i = 0; i < self->ins; ++i) {
        Py_ssize_t size;
        PyObject *standard;
        if (!PyArg_ParseTuple(PyTuple_GET_ITEM(inputs, i), "nO", &size, &standard))
            return -1;
        self->in[i] = (Input){size, NULL};
        if (standard == Py_None)
            continue;
        self->in[i].standard = data_of(standard, &self->in[i]);
        if (self->in[i].standard == NULL) {
            PyErr_Format(PyExc_ValueError, "input %zd: the default does not fit", i);
            return -1;
        }
    }
    return 0;
}

static int read_outputs(Caller *self, PyObject *outputs)
{
    self->outs = PyTuple_GET_SIZE(outputs);
    for (Py_ssize_t i = 0; i < self->outs; ++i) {
        Py_ssize_t rows, columns;
        int dimensions, asked;
        if (!PyArg_ParseTuple(PyTuple_GET_ITEM(outputs, i), "nnip", &rows, &columns, &dimensions,
                &asked))
            return -1;
        self->out[i] = (Output){{rows, columns}, rows * columns, dimensions, asked};
        if (asked)
            self->asked += 1;
        else
            self->unasked += rows * columns;
    }
    return 0;
}

static PyObject *caller_new(PyTypeObject *type, PyObject *args, PyObject *names)
{
    unsigned long long address;
    PyObject *inputs, *outputs, *keep;
    int checked;
    (void)names;
    if (!PyArg_ParseTuple(args, "KO!O!pO", &address, &PyTuple_Type, &inputs, &PyTuple_Type,
            &outputs, &checked, &keep))
        return NULL;
    if (PyTuple_GET_SIZE(inputs) > MOST || PyTuple_GET_SIZE(outputs) > MOST) {
        PyErr_Format(PyExc_ValueError, "at most %d inputs and outputs", MOST);
        return NULL;
    }
    Caller *self = (Caller *)type->tp_alloc(type, 0);
    if (self == NULL)
        return NULL;
    self->vectorcall = caller_call;
    self->kernel = (Kernel)(uintptr_t)address;
    self->checked = checked;
    /* Default arrays are among the inputs. */
    self->keep = PyTuple_Pack(2, inputs, keep);
    if (self->keep == NULL || read_inputs(self, inputs) < 0 || read_outputs(self, outputs) < 0)
        Py_CLEAR(self);
    return (PyObject *)self;
}

static void caller_dealloc(Caller *self)
{
    Py_XDECREF(self->keep);
    Py_TYPE(self)->tp_free((PyObject *)self);
}

static PyMemberDef caller_members[] = {
    {"__vectorcalloffset__", T_PYSSIZET, offsetof(Caller, vectorcall), READONLY, NULL},
    {NULL, 0, 0, 0, NULL},
};

static PyTypeObject CallerType = {
    PyVarObject_HEAD_INIT(NULL, 0)
    .tp_name = "mechanics_direct.Caller",
    .tp_basicsize = sizeof(Caller),
    .tp_flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL,
    .tp_new = caller_new,
    .tp_dealloc = (destructor)caller_dealloc,
    .tp_call = PyVectorcall_Call,
    .tp_vectorcall_offset = offsetof(Caller, vectorcall),
    .tp_members = caller_members,
};
