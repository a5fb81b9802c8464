/*
 * Many states: arrays of any strides.
 *
 *     States(address, inputs, size, fewest, checked, keep)(q, u, inputs, p, out) -> array, or None
 *
 * The kernel is int (*)(size_t count, const double *const *arg, double *const *res, const ptrdiff_t
 * *steps), see mechanics.compiled.c.strided, with one output of `size` entries. Each input is
 * (size, shared or not, default array or None).
 * It takes arrays of aligned doubles, (states, size) with any strides, (size,) and contiguous for
 * shared inputs, None for a default or to make the output here. Whatever else it gets, fewer than
 * `fewest` states, an output that overlaps an input, and where it is checked and the kernel has met
 * anything that is to be looked at, it gives None: the way that explains is taken then.
 */
typedef int (*BatchKernel)(size_t, const double *const *, double *const *, const ptrdiff_t *);

typedef struct {
    npy_intp size;
    int shared;
    const double *standard;
} BatchInput;

typedef struct {
    PyObject_HEAD
    vectorcallfunc vectorcall;
    BatchKernel kernel;
    PyObject *keep;
    Py_ssize_t ins;
    npy_intp size, fewest;
    int checked;
    BatchInput in[MOST];
} States;

/* Aligned doubles in the machine's order, and strides that are whole numbers of them. */
static PyArrayObject *readable(PyObject *given, int dimensions, npy_intp size)
{
    if (!PyArray_CheckExact(given))
        return NULL;
    PyArrayObject *array = (PyArrayObject *)given;
    if (PyArray_NDIM(array) != dimensions || PyArray_TYPE(array) != NPY_DOUBLE
        || !PyArray_ISALIGNED(array) || !PyArray_ISNOTSWAPPED(array)
        || PyArray_DIM(array, dimensions - 1) != size)
        return NULL;
    for (int k = 0; k < dimensions; ++k)
        if (PyArray_STRIDE(array, k) % (npy_intp)sizeof(double))
            return NULL;
    return array;
}

static void steps_of(PyArrayObject *array, ptrdiff_t *steps)
{
    for (int k = 0; k < 2; ++k)
        steps[k] = PyArray_STRIDE(array, k) / (npy_intp)sizeof(double);
}

/* First and last byte that an array of states may touch. */
static void span(const double *data, const ptrdiff_t *steps, npy_intp count, npy_intp size,
    const double **low, const double **high)
{
    *low = *high = data;
    const ptrdiff_t reach[2] = {steps[0] * (count - 1), steps[1] * (size - 1)};
    for (int k = 0; k < 2; ++k)
        *(reach[k] < 0 ? low : high) += reach[k];
}

static PyObject *states_call(PyObject *object, PyObject *const *args, size_t nargsf,
    PyObject *names)
{
    const States *self = (const States *)object;
    const double *arg[MOST];
    ptrdiff_t steps[2 * MOST + 2];
    npy_intp count = -1, sizes[MOST];
    int lanes = 1;
    Py_ssize_t n = 0;
    if (PyVectorcall_NARGS(nargsf) != self->ins + 1 || names != NULL) {
        PyErr_Format(PyExc_TypeError, "%zd inputs and the output expected", self->ins);
        return NULL;
    }
    for (Py_ssize_t i = 0; i < self->ins; ++i) {
        const BatchInput *in = &self->in[i];
        if (in->size == 0) {
            if (args[i] != Py_None)
                Py_RETURN_NONE;
            continue;
        }
        steps[2 * n] = 0;
        steps[2 * n + 1] = 1;
        sizes[n] = in->size;
        if (in->shared) {
            PyArrayObject *array = readable(args[i], 1, in->size);
            arg[n] = args[i] == Py_None ? in->standard : NULL;
            if (array != NULL && PyArray_ISCARRAY_RO(array))
                arg[n] = (const double *)PyArray_DATA(array);
        } else {
            PyArrayObject *array = readable(args[i], 2, in->size);
            if (array == NULL || (count >= 0 && PyArray_DIM(array, 0) != count))
                Py_RETURN_NONE;
            count = PyArray_DIM(array, 0);
            arg[n] = (const double *)PyArray_DATA(array);
            steps_of(array, steps + 2 * n);
            lanes = lanes && steps[2 * n] == 1;
        }
        if (arg[n] == NULL)
            Py_RETURN_NONE;
        n += 1;
    }
    if (count < self->fewest)
        Py_RETURN_NONE;
    npy_intp shape[2] = {count, self->size};
    PyArrayObject *out = NULL;
    if (args[self->ins] == Py_None) {
        out = (PyArrayObject *)PyArray_EMPTY(2, shape, NPY_DOUBLE, lanes);
        if (out == NULL)
            return NULL;
        steps_of(out, steps + 2 * n);
    } else {
        out = readable(args[self->ins], 2, self->size);
        if (out == NULL || PyArray_DIM(out, 0) != count || !PyArray_ISWRITEABLE(out))
            Py_RETURN_NONE;
        const double *low, *high, *from, *to;
        steps_of(out, steps + 2 * n);
        span((const double *)PyArray_DATA(out), steps + 2 * n, count, self->size, &low, &high);
        for (Py_ssize_t i = 0; i < n; ++i) {
            span(arg[i], steps + 2 * i, count, sizes[i], &from, &to);
            if (from <= high && low <= to)
                Py_RETURN_NONE;
        }
        Py_INCREF(out);
    }
    double *const res[1] = {(double *)PyArray_DATA(out)};
    int met;
    Py_BEGIN_ALLOW_THREADS
    met = self->kernel((size_t)count, arg, res, steps);
    Py_END_ALLOW_THREADS
    if (!met || !self->checked)
        return (PyObject *)out;
    Py_DECREF(out);
    Py_RETURN_NONE;
}

static int read_states_inputs(States *self, PyObject *inputs)
{
    self->ins = PyTuple_GET_SIZE(inputs);
    for (Py_ssize_t i = 0; i < self->ins; ++i) {
        PyObject *standard;
        BatchInput *in = &self->in[i];
        if (!PyArg_ParseTuple(PyTuple_GET_ITEM(inputs, i), "npO", &in->size, &in->shared,
                &standard))
            return -1;
        in->standard = NULL;
        if (standard == Py_None)
            continue;
        PyArrayObject *array = readable(standard, 1, in->size);
        if (array == NULL || !PyArray_ISCARRAY_RO(array)) {
            PyErr_Format(PyExc_ValueError, "input %zd: the default does not fit", i);
            return -1;
        }
        in->standard = (const double *)PyArray_DATA(array);
    }
    return 0;
}

static PyObject *states_new(PyTypeObject *type, PyObject *args, PyObject *names)
{
    unsigned long long address;
    PyObject *inputs, *keep;
    Py_ssize_t size, fewest;
    int checked;
    (void)names;
    if (!PyArg_ParseTuple(args, "KO!nnpO", &address, &PyTuple_Type, &inputs, &size, &fewest,
            &checked, &keep))
        return NULL;
    if (PyTuple_GET_SIZE(inputs) > MOST) {
        PyErr_Format(PyExc_ValueError, "at most %d inputs", MOST);
        return NULL;
    }
    States *self = (States *)type->tp_alloc(type, 0);
    if (self == NULL)
        return NULL;
    self->vectorcall = states_call;
    self->kernel = (BatchKernel)(uintptr_t)address;
    self->size = size;
    self->fewest = fewest;
    self->checked = checked;
    /* Default arrays are among the inputs. */
    self->keep = PyTuple_Pack(2, inputs, keep);
    if (self->keep == NULL || read_states_inputs(self, inputs) < 0)
        Py_CLEAR(self);
    return (PyObject *)self;
}

static void states_dealloc(States *self)
{
    Py_XDECREF(self->keep);
    Py_TYPE(self)->tp_free((PyObject *)self);
}

static PyMemberDef states_members[] = {
    {"__vectorcalloffset__", T_PYSSIZET, offsetof(States, vectorcall), READONLY, NULL},
    {NULL, 0, 0, 0, NULL},
};

static PyTypeObject StatesType = {
    PyVarObject_HEAD_INIT(NULL, 0)
    .tp_name = "mechanics_direct.States",
    .tp_basicsize = sizeof(States),
    .tp_flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL,
    .tp_new = states_new,
    .tp_dealloc = (destructor)states_dealloc,
    .tp_call = PyVectorcall_Call,
    .tp_vectorcall_offset = offsetof(States, vectorcall),
    .tp_members = states_members,
};
