"""Call the C functions of this folder from Python: one file, which needs nothing but this folder.

    from elastic_pendulum_loader import load

    system = load()                                    # compiles the C files that stand beside it
    found = system.forward_dynamics(q=[0.1, 0.1], u=[0.1, 0.1])
    found.ud

An array is given as a sequence in the order of `ARRAYS`, or as names with values; parameters that
are left out are typical. Results are NumPy arrays where NumPy is installed, else `array.array`,
with matrices column by column. Calls release the lock of the interpreter: use threads as you like.

The functions in `BATCH` are there for many states, too: `system.NAME_batch` takes a row of numbers,
one a state, for each entry of q, u and inputs, and gives such rows. A NumPy array of shape
(entries, states), contiguous and of the right type, is read where it stands. Where the function of
one state raises `StatusError`, that of many goes on: `found.status` has a number for each state,
the place of its word in `STATUS`, and 0 where all is well.
"""

import array
import ctypes
import math
import os
import platform
import shlex
import shutil
import subprocess
import tempfile
from collections import namedtuple
from pathlib import Path
from typing import Any

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

# What was generated.
NAME = "elastic_pendulum"
PREFIXES = {"double": "elastic_pendulum"}
ARRAYS = {
    "q": (("x", "m", ""), ("theta", "rad", "")),
    "u": (("x_dot", "m/s", ""), ("theta_dot", "rad/s", "")),
    "ud": (("x_ddot", "m/s^2", ""), ("theta_ddot", "rad/s^2", "")),
    "inputs": (),
    "p": (
        ("L", "m", "length of the pendulum"),
        ("M", "kg", "mass of the pendulum"),
        ("g", "m/s^2", "acceleration of gravity"),
        ("k", "N/m", "stiffness of each of the two springs"),
        ("m", "kg", "mass of the carriage"),
    ),
    "c": (
        ("M", "kg", "mass of the pendulum"),
        ("g", "m/s^2", "acceleration of gravity"),
        ("c2", "", "made of parameters"),
        ("c3", "", "made of parameters"),
        ("c4", "", "made of parameters"),
        ("c5", "", "made of parameters"),
    ),
    "multipliers": (),
    "reactions": (("T", "N", ""), ("N", "N", ""), ("N1", "N", "")),
    "h": (("h", "s", "length of the step"),),
}
TYPICAL = {"L": 1.0, "M": 1.0, "g": 9.81, "k": 10.0, "m": 1.0}
FUNCTIONS = {
    "forward_dynamics": ((("q", 2), ("u", 2), ("p", 5)), (("ud", (2,)),)),
    "mass_matrix": ((("q", 2), ("u", 2), ("p", 5)), (("mass_matrix", (2, 2)),)),
    "forcing": ((("q", 2), ("u", 2), ("p", 5)), (("forcing", (2,)),)),
    "residual": ((("q", 2), ("u", 2), ("p", 5), ("ud", 2)), (("residual", (2,)),)),
    "inverse_dynamics": ((("q", 2), ("u", 2), ("p", 5), ("ud", 2)), (("forces", (2,)),)),
    "energy": (
        (("q", 2), ("u", 2), ("p", 5)),
        (("kinetic", (1,)), ("potential", (1,)), ("total", (1,))),
    ),
    "momenta": (
        (("q", 2), ("u", 2), ("p", 5)),
        (("linear", (3,)), ("angular", (3,)), ("generalized", (2,))),
    ),
    "coordinate_rates": ((("q", 2), ("u", 2), ("p", 5)), (("qd", (2,)),)),
    "jacobians": (
        (("q", 2), ("u", 2), ("p", 5)),
        (("ud_q", (2, 2)), ("ud_u", (2, 2)), ("ud_p", (2, 5))),
    ),
    "step": (
        (("q", 2), ("u", 2), ("p", 5), ("h", 1)),
        (("q_next", (2,)), ("u_next", (2,))),
    ),
    "reactions": ((("q", 2), ("u", 2), ("p", 5)), (("reactions", (3,)),)),
    "prepare": ((("p", 5),), (("c", (6,)),)),
    "forward_dynamics_prepared": ((("q", 2), ("u", 2), ("c", 6)), (("ud", (2,)),)),
}
BATCH = ("forward_dynamics", "energy", "coordinate_rates")
SOURCES = {"double": ("elastic_pendulum.c", "elastic_pendulum_batch.c")}
# End of what was generated.

STATUS = ("ok", "singular", "overflow", "bad input")
NOT_FINITE = 2  # part of what functions of many states return
TYPES = {"double": (ctypes.c_double, "d"), "single": (ctypes.c_float, "f")}
FLAGS = "-O3"  # for every machine of this kind
NATIVE = "-O3"  # for this machine only
if platform.machine() in ("x86_64", "AMD64"):
    NATIVE = "-O3 -march=native -mprefer-vector-width=512"
SHOWN = 60  # letters of what is given, in a message


class StatusError(ArithmeticError):
    """A function returned a status that is not 0: `status`, and `results` all the same."""

    def __init__(self, function: str, status: int, results: Any) -> None:
        super().__init__(f"{NAME}.{function}: {STATUS[status]}")
        self.status, self.results = status, results


def load(library: Any = None, precision: str = next(iter(PREFIXES), ""), **how: str) -> "System":
    """The functions, from a shared library that is named, or is built now and kept for this run.

    `precision` is a key of `PREFIXES`; `compiler` and `flags` are those of `build`, with all
    instructions of this machine unless told otherwise.
    """
    if precision not in PREFIXES:
        raise ValueError(f"precision {precision!r}: this folder has {', '.join(PREFIXES)}")
    if library is not None:
        return System(Path(library), precision)
    # Vanishes with the object that holds it.
    folder = tempfile.TemporaryDirectory(prefix=f"{NAME}-")
    how = {"flags": NATIVE, **how}
    return System(build(Path(folder.name) / f"{NAME}.so", precision, **how), precision, folder)


def build(target: Any, precision: str = next(iter(PREFIXES), ""), compiler: str | None = None,
          flags: str = FLAGS) -> Path:  # fmt: skip
    """Compile the folder into a shared library; $CC, cc, gcc and clang are tried in turn."""
    names = (compiler,) if compiler else (os.environ.get("CC", ""), "cc", "gcc", "clang")
    found = next((path for name in names if name and (path := shutil.which(name))), None)
    if found is None:
        raise OSError(
            f"no C compiler among {', '.join(filter(None, names))}: build a shared library with"
            f" CMake (-D{NAME.upper()}_SHARED=ON) and give its path to load()"
        )
    here = Path(__file__).resolve().parent
    files = [str(here / file) for file in SOURCES[precision]]
    options = ["-std=c99", "-fPIC", "-shared", "-ffp-contract=off", "-fno-math-errno"]
    command = [found, *options, *shlex.split(flags), *files, "-o", str(target), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise OSError(f"{found} refused {', '.join(SOURCES[precision])}: {done.stderr.strip()}")
    return Path(target)


class System:
    """Every function as a method; `help(system.NAME_OF_FUNCTION)` tells its arrays."""

    def __init__(self, path: Path, precision: str, keep: Any = None) -> None:
        self._library, self._keep = ctypes.CDLL(str(path)), keep
        for name in FUNCTIONS:
            function = self._found(f"{PREFIXES[precision]}_{name}")
            setattr(self, name, _method(name, function, *TYPES[precision]))
        for name in BATCH:
            one = self._found(f"{PREFIXES[precision]}_{name}")
            many = self._found(f"{PREFIXES[precision]}_{name}_batch")
            setattr(self, f"{name}_batch", _batch(name, one, many, *TYPES[precision]))

    def _found(self, symbol: str) -> Any:
        try:
            function = getattr(self._library, symbol)
        except AttributeError:
            path = self._library._name
            raise OSError(
                f"{path} has no {symbol}: build it from the files of this folder"
            ) from None
        function.restype = ctypes.c_int
        return function


def _method(name: str, function: Any, real: Any, code: str) -> Any:
    inputs, outputs = FUNCTIONS[name]
    made = _results(name, [out for out, _ in outputs])

    def call(*arrays: Any, **named: Any) -> Any:
        given = _sorted_out(name, inputs, arrays, named)
        groups = [_given(g, size, given.get(g), real) for g, size in inputs]
        results = [(real * math.prod(shape))() for _, shape in outputs]
        status = function(*groups, *results)
        shaped = [_shaped(r, shape, code) for r, (_, shape) in zip(results, outputs, strict=True)]
        if status != 0:
            raise StatusError(name, status, made(*shaped))
        return made(*shaped)

    call.__name__ = name
    call.__doc__ = (
        f"{name}({', '.join(f'{g}[{n}]' for g, n in inputs)})"
        f" -> {', '.join(f'{out}{list(shape)}' for out, shape in outputs)}"
    )
    return call


def _batch(name: str, one: Any, many: Any, real: Any, code: str) -> Any:
    inputs, outputs = FUNCTIONS[name]
    made = _results(f"{name}_batch", [*(out for out, _ in outputs), "status"])

    def call(*arrays: Any, **named: Any) -> Any:
        given = _sorted_out(name, inputs, arrays, named)
        rows = {g: _rows(g, n, given.get(g), real) for g, n in inputs if g != "p"}
        counts = {g: len(rows[g]) // n for g, n in inputs if g in rows}
        if len(set(counts.values())) != 1:
            words = ", ".join(f"{n} in {g}" for g, n in counts.items())
            raise ValueError(f"{name}_batch: {words}: give as many states in each")
        count = next(iter(counts.values()))
        groups = [rows[g] if g in rows else _given(g, n, given.get(g), real) for g, n in inputs]
        results = [(real * (math.prod(shape) * count))() for _, shape in outputs]
        size = ctypes.c_size_t(count)
        found = many(size, size, *(_address(group, real) for group in groups), *results)
        status = array.array("i", bytes(4 * count))
        if found & NOT_FINITE:
            for i in range(count):
                state = [
                    (real * n)(*(group[i::count] if g in rows else group))
                    for (g, n), group in zip(inputs, groups, strict=True)
                ]
                status[i] = one(*state, *((real * math.prod(shape))() for _, shape in outputs))
        if numpy is None:
            return made(*(array.array(code, result) for result in results), status)
        shaped = (
            numpy.frombuffer(result, real).reshape(math.prod(shape), count)
            for result, (_, shape) in zip(results, outputs, strict=True)
        )
        return made(*shaped, numpy.frombuffer(status, numpy.intc))

    call.__name__ = f"{name}_batch"
    call.__doc__ = f"{name} at many states: a row of numbers, one a state, for each entry."
    return call


def _results(name: str, fields: list[str]) -> Any:
    return namedtuple(name, fields)


def _rows(group: str, size: int, value: Any, real: Any) -> Any:
    """Entry after entry, each at all states."""
    if numpy is not None and isinstance(value, numpy.ndarray) and value.ndim == 2:
        _counted(group, size, value, "rows")
        if value.dtype.kind not in "biuf":
            raise TypeError(f"{group} is an array of {value.dtype}: give an array of numbers")
        return numpy.ascontiguousarray(value, real).ravel()
    names, rows = [name for name, _, _ in ARRAYS[group]], _listed(group, size, value, "rows")
    flat: list[float] = []
    for name, row in zip(names, rows, strict=True):
        if isinstance(row, (str, bytes)) or not hasattr(row, "__len__"):
            found = f"{name} of {group} is {_shown(row)}"
            raise TypeError(f"{found}: give a row of numbers, one a state")
        if len(row) != len(rows[0]):
            words = f"{len(rows[0])} states in {names[0]}, {len(row)} in {name}"
            raise ValueError(f"{group} has {words}: give as many in each")
        flat += [_number(group, name, number) for number in row]
    return (real * len(flat))(*flat)


def _address(group: Any, real: Any) -> Any:
    # The result holds the array.
    is_array = numpy is not None and isinstance(group, numpy.ndarray)
    return group.ctypes.data_as(ctypes.POINTER(real)) if is_array else group


def _sorted_out(name: str, inputs: Any, arrays: tuple, named: dict[str, Any]) -> dict[str, Any]:
    if len(arrays) > len(inputs):
        raise TypeError(f"{name} takes {len(inputs)} arrays, not {len(arrays)}")
    given = {group: value for (group, _), value in zip(inputs, arrays, strict=False)}
    if wrong := [group for group in named if group in given or group not in dict(inputs)]:
        raise TypeError(f"{name}: {wrong[0]!r} is unknown or given twice")
    return given | named


def _given(group: str, size: int, value: Any, real: Any) -> Any:
    listed = _listed(group, size, value, "entries")
    names = (name for name, _, _ in ARRAYS[group])
    return (real * size)(*(_number(group, *one) for one in zip(names, listed, strict=True)))


def _listed(group: str, size: int, value: Any, what: str) -> list[Any]:
    """What is given for each entry, in order."""
    names = [name for name, _, _ in ARRAYS[group]]
    if value is None or hasattr(value, "keys"):
        known = (TYPICAL if group == "p" else {}) | dict(value or {})
        if wrong := [name for name in known if name not in names]:
            raise ValueError(f"{group} has no {wrong[0]!r}: it has {', '.join(names)}")
        if missing := [name for name in names if name not in known]:
            raise ValueError(f"{group} lacks {', '.join(missing)}")
        return [known[name] for name in names]
    if isinstance(value, (str, bytes)) or not hasattr(value, "__len__"):
        wanted = f"{size} {what}, {', '.join(names)}"
        raise TypeError(f"{group} is {_shown(value)}: give {wanted}, or names with values")
    _counted(group, size, value, what)
    return list(value)


def _counted(group: str, size: int, value: Any, what: str) -> None:
    if len(value) != size:
        names = ", ".join(name for name, _, _ in ARRAYS[group])
        raise ValueError(f"{group} has {len(value)} {what}: {names} are {size}")


def _number(group: str, name: str, value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} of {group} is {_shown(value)}: give a number") from None


def _shown(value: Any) -> str:
    words = " ".join(repr(value).split())
    return words if len(words) <= SHOWN else f"{words[:SHOWN]}..."


def _shaped(result: Any, shape: tuple[int, ...], code: str) -> Any:
    if numpy is None:
        return array.array(code, result)
    return numpy.array(result).reshape(shape, order="F")
