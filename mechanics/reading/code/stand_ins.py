"""What a function that is traced finds in place of `math`, `numpy` and `float`.

    math.sin(x) -> x.sin()        np.zeros(4) -> an array of objects        np.linalg.solve -> exact

A function is not changed: a copy of it is made whose names mean these.
"""

import builtins
import math
import random
import types
from collections.abc import Callable, Iterable
from operator import methodcaller
from typing import Any

import numpy as np
import sympy

from mechanics.errors import InputError
from mechanics.reading.code.objects import methods_used, with_methods
from mechanics.reading.code.traced import ELEMENTARY, Explorer, Traced, expression_of
from mechanics.reading.code.unwrapped import unwrapped

ALIASES = {
    "asin": "arcsin", "acos": "arccos", "atan": "arctan", "asinh": "arcsinh", "acosh": "arccosh",
    "atanh": "arctanh",
}  # fmt: skip
SIGN = methodcaller("sign")
DEEPEST = 6
"""Functions that call functions."""


def _elementary(name: str, original: Callable[..., Any]) -> Callable[..., Any]:
    def apply(x: Any, *rest: Any) -> Any:
        return getattr(x, name)() if isinstance(x, Traced) and not rest else original(x, *rest)

    return apply


class Module:
    """A module some of whose names mean something else."""

    def __init__(self, module: types.ModuleType, names: dict[str, Any]) -> None:
        self._module, self._names = module, names

    def __getattr__(self, name: str) -> Any:
        if name in self._names:
            return self._names[name]
        return getattr(self._module, name)


def _exact_system(a: Any, b: Any) -> np.ndarray:
    """Solve a linear system of traced numbers by Cramer's rule, for few unknowns."""
    matrix, right = np.asarray(a, dtype=object), np.asarray(b, dtype=object)
    explorer = _explorer([*matrix.flat, *right.flat])
    if explorer is None:
        return np.linalg.solve(np.asarray(a, dtype=float), np.asarray(b, dtype=float))
    if len(matrix) > 4:
        raise InputError("a linear system of more than four unknowns cannot be traced")
    left = sympy.Matrix(len(matrix), len(matrix), [expression_of(x, explorer) for x in matrix.flat])
    columns = right.reshape(len(matrix), -1)
    adjugate, determinant = left.adjugate(), left.det(method="berkowitz")
    target = sympy.Matrix(*columns.shape, [expression_of(x, explorer) for x in columns.flat])
    found = adjugate * target / determinant
    return np.array([Traced(x, explorer) for x in found], dtype=object).reshape(right.shape)


def _inverse(a: Any) -> np.ndarray:
    return _exact_system(a, np.eye(len(a), dtype=int).astype(object))


def _explorer(entries: Iterable[Any]) -> Explorer | None:
    return next((x.explorer for x in entries if isinstance(x, Traced)), None)


def _objects(make: Callable[..., np.ndarray]) -> Callable[..., np.ndarray]:
    """An array whose entries may be traced numbers, whatever type was asked for."""

    def apply(x: Any, *rest: Any, **options: Any) -> Any:
        kept = {k: v for k, v in options.items() if k not in ("dtype", "copy")}
        positional = [r for r in rest if not isinstance(r, type | np.dtype)]
        return make(x, *positional, dtype=object, **kept)

    return apply


def _identity(x: Any = 0.0, *rest: Any, **options: Any) -> Any:
    return x if isinstance(x, Traced) else float(x)


def _signs(x: Any) -> Any:
    """NumPy compares objects with zero to find their sign, and calls no method."""
    entries = np.asarray(x)
    if entries.dtype != object:
        return np.sign(x)
    signs = [SIGN(e) if isinstance(e, Traced) else np.sign(e) for e in entries.flat]
    found = np.array(signs, dtype=object)
    return found.reshape(entries.shape) if entries.shape else found[0]


RANDOM = (random.Random, np.random.RandomState, np.random.Generator)
CHANGING = ("random", "numpy.random", "secrets", "time", "datetime", "uuid")
"""Modules whose functions return something else at each call."""
OUTSIDE = ("input", "open", "eval", "exec", "globals")


class Changing:
    """What returns something else at each call, or reads what is no argument."""

    def __init__(self, name: str) -> None:
        self.__name__ = name

    def __call__(self, *_: Any, **__: Any) -> Any:
        """Refuse it.

        Raises
        ------
        InputError
        """
        raise InputError(
            f"it calls {self.__name__}: its result depends on more than its arguments: leave that"
            " out, or make it an argument"
        )

    def __getattr__(self, name: str) -> Any:
        return Changing(f"{self.__name__}.{name}")


NUMPY: dict[str, Any] = {
    **{name: _objects(getattr(np, name)) for name in (
        "array", "asarray", "zeros", "ones", "empty", "eye", "zeros_like", "empty_like",
        "ones_like", "full", "identity", "ascontiguousarray",
    )},
    **{name: _identity for name in ("float64", "float32", "double")},
    "random": Changing("np.random"),
    "linalg": Module(np.linalg, {"solve": _exact_system, "inv": _inverse}),
    "arctan2": lambda y, x: y.arctan2(x) if isinstance(y, Traced) else np.arctan2(y, x),
    "sign": _signs,
}  # fmt: skip
MATH: dict[str, Any] = {
    **{name: _elementary(name, getattr(math, name, abs)) for name in ELEMENTARY},
    **{short: _elementary(long, getattr(math, short)) for short, long in ALIASES.items()},
    "atan2": NUMPY["arctan2"],
    "pow": lambda x, y: x**y,
    "hypot": lambda x, y: NUMPY["sqrt_of"](x * x + y * y),
}
NUMPY["sqrt_of"] = MATH["sqrt"]


def _changing(value: Any) -> str:
    """A name of what returns something else at each call; empty for other things."""
    owner = getattr(value, "__self__", None)
    if isinstance(value, RANDOM) or isinstance(owner, RANDOM):
        return f"random numbers ({getattr(value, '__name__', type(value).__name__)})"
    if isinstance(value, types.ModuleType):
        return value.__name__ if value.__name__ in CHANGING else ""
    module, name = getattr(value, "__module__", None), getattr(value, "__name__", "")
    return f"{module}.{name}" if module in CHANGING and callable(value) else ""


def stand_in(value: Any, depth: int = 0) -> Any:
    """What a name of a traced function means."""
    value = unwrapped(value)
    if name := _changing(value):
        return Changing(name)
    if value is math:
        return Module(math, MATH)
    if value is np:
        return Module(np, NUMPY)
    if value is float:
        return _identity
    if value is np.sign:
        return _signs
    if isinstance(value, types.BuiltinFunctionType) and value.__module__ == "math":
        return MATH.get(value.__name__, value)
    for name, replacement in NUMPY.items():
        if value is getattr(np, name, None) and not isinstance(value, np.ufunc):
            return replacement
    if isinstance(value, types.FunctionType) and not _foreign(value):
        return copy_of(value, depth + 1)
    return value


def _foreign(function: types.FunctionType) -> bool:
    return (function.__module__ or "").partition(".")[0] in ("numpy", "scipy", "sympy", "casadi")


def copy_of(function: Callable[..., Any], depth: int = 0) -> Callable[..., Any]:
    """A copy of a Python function whose names mean the stand-ins.

    Raises
    ------
    InputError
        When it is no Python function, or calls go too deep.
    """
    if isinstance(function, types.MethodType):
        return _method(function.__func__, function.__self__, depth)
    if not isinstance(function, types.FunctionType):
        called = type(function).__call__
        if isinstance(called, types.FunctionType):
            return _method(called, function, depth)
        raise InputError(f"{function!r} is no Python function: its code cannot be traced")
    if depth > DEEPEST:
        return function
    table = dict(function.__globals__)
    table["float"] = _identity
    for name in _used(function.__code__):
        if name in table and table[name] is not function and name != "float":
            table[name] = stand_in(table[name], depth)
        elif name == "abs":
            table[name] = builtins.abs
        elif name in OUTSIDE and name not in table:
            table[name] = Changing(name)
    cells = tuple(
        types.CellType(stand_in(cell.cell_contents, depth)) for cell in function.__closure__ or ()
    )
    copied = types.FunctionType(
        function.__code__, table, function.__name__, function.__defaults__, cells or None
    )
    copied.__kwdefaults__ = function.__kwdefaults__
    # It calls its copy, not itself.
    table[function.__name__] = copied
    return copied


def _method(function: Callable[..., Any], bound: Any, depth: int) -> Callable[..., Any]:
    """A copy of a method, of an object whose other methods are copies, too."""
    if isinstance(function, types.FunctionType):
        others = methods_used(bound, [function])
        bound = with_methods(bound, {n: copy_of(f, depth + 1) for n, f in others.items()})
    return types.MethodType(copy_of(function, depth), bound)


def _used(code: types.CodeType) -> set[str]:
    inner = [_used(c) for c in code.co_consts if isinstance(c, types.CodeType)]
    return set(code.co_names).union(*inner)
