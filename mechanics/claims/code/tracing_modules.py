"""What a function that is traced finds in place of `math`, `numpy` and `float`.

    math.sin(x) -> x.sin()        np.zeros(4) -> an array of objects        np.linalg.solve -> exact

A function is not changed: a copy of it is made whose names mean these.
"""

import builtins
import math
import operator
import random
import sys
import types
from collections.abc import Callable
from operator import methodcaller
from typing import Any

import numpy as np
import sympy
from sympy import Expr

from mechanics.claims.code import linear_systems
from mechanics.claims.code.closure_numbers import content, foreign, named
from mechanics.claims.code.exact import ELEMENTARY, PI, TAU, E, Exact, exact, is_plain
from mechanics.claims.code.objects import methods_used, with_methods
from mechanics.claims.code.tracer import Traced
from mechanics.claims.code.wrappers import unwrapped
from mechanics.errors import InputError

ALIASES = {
    "asin": "arcsin", "acos": "arccos", "atan": "arctan", "asinh": "arcsinh", "acosh": "arccosh",
    "atanh": "arctanh",
}  # fmt: skip
SIGN = methodcaller("sign")
DEEPEST = 6
"""Functions that call functions."""


def _elementary(name: str, original: Callable[..., Any]) -> Callable[..., Any]:
    """A function of one number, or of the entries of an array: traced, exact, else as it was."""

    def of(x: Any) -> Any:
        if isinstance(x, Traced):
            return getattr(x, name)()
        return exact(ELEMENTARY[name], original, x) if is_plain(x) else original(x)

    def apply(x: Any, *rest: Any, **options: Any) -> Any:
        if rest or options:
            return original(x, *rest, **options)
        if isinstance(x, np.ndarray | list | tuple) and np.asarray(x).dtype == object:
            return np.vectorize(of, otypes=[object])(np.asarray(x))
        return of(x)

    return apply


def _of_two(
    traced: Callable[[Any, Any], Any], formula: Callable[[Expr, Expr], Expr],
    original: Callable[..., Any],
) -> Callable[..., Any]:  # fmt: skip
    """A function of two numbers: traced, exact, else as it was."""

    def apply(x: Any, y: Any, *rest: Any, **options: Any) -> Any:
        if rest or options:
            return original(x, y, *rest, **options)
        if is_plain(x) and is_plain(y):
            return exact(formula, original, x, y)
        return traced(x, y)

    return apply


def _hypot(x: Any, *others: Any) -> Any:
    return NUMPY["sqrt"](sum((y * y for y in others), x * x))


class Module:
    """A module some of whose names mean something else."""

    def __init__(self, module: types.ModuleType, names: dict[str, Any]) -> None:
        self._module, self._names = module, names

    def __getattr__(self, name: str) -> Any:
        if name in self._names:
            return self._names[name]
        found = getattr(self._module, name)
        inside = getattr(found, "__name__", "") if isinstance(found, types.ModuleType) else ""
        return Module(found, MODULES[inside]) if inside in MODULES else found


def _objects(make: Callable[..., np.ndarray]) -> Callable[..., np.ndarray]:
    """An array whose entries may be traced numbers, whatever type was asked for."""

    def apply(x: Any, *rest: Any, **options: Any) -> Any:
        kept = {k: v for k, v in options.items() if k not in ("dtype", "copy")}
        positional = [r for r in rest if not isinstance(r, type | np.dtype)]
        return make(x, *positional, dtype=object, **kept)

    return apply


class _Kind(type):
    """A traced number is one of the kind, and stays what it is where it is made one."""

    def __instancecheck__(cls, thing: object) -> bool:
        return isinstance(thing, Traced | float)

    def __call__(cls, x: Any = 0.0, *_: Any, **__: Any) -> Any:
        return x if isinstance(x, Traced | Exact) else float(x)


class Float(metaclass=_Kind):
    """In place of `float`: ``isinstance(x, float)``, ``float(x)``, ``np.zeros(2, float)``."""


def _signs(x: Any) -> Any:
    """NumPy compares objects with zero to find their sign, and calls no method."""
    entries = np.asarray(x)
    if entries.dtype != object:
        return np.sign(x)
    signs = [SIGN(e) if isinstance(e, Traced) else np.sign(e) for e in entries.flat]
    found = np.array(signs, dtype=object)
    return found.reshape(entries.shape) if entries.shape else found[0]


def _selected(conditions: Any, choices: Any, default: Any = 0) -> Any:
    """`np.select`, which wants conditions that are known."""
    if any(np.ndim(part) for part in (*conditions, *choices, default)):
        parts = np.broadcast_arrays(*(np.asarray(p, object) for p in (*conditions, *choices)))
        base = np.broadcast_to(np.asarray(default, object), parts[0].shape)
        found, k = np.empty(base.shape, dtype=object), len(conditions)
        for place in np.ndindex(base.shape):
            row = [part[place] for part in parts]
            found[place] = _selected(row[:k], row[k:], base[place])
        return found
    return next((c for known, c in zip(conditions, choices, strict=True) if known), default)


METHODS = (types.BuiltinFunctionType, types.MethodType)
RANDOM = (random.Random, np.random.RandomState, np.random.Generator)
CHANGING = ("random", "numpy.random", "secrets", "time", "datetime", "uuid", "os")
"""Modules whose functions return something else at each call, or elsewhere."""
OUTSIDE = ("input", "open", "eval", "exec", "globals", "hash", "id")
OF_NUMBERS = frozenset((
    "__future__", "abc", "bisect", "builtins", "cmath", "collections", "contextlib", "copy",
    "dataclasses", "decimal", "enum", "fractions", "functools", "heapq", "itertools", "logging",
    "math", "numbers", "operator", "re", "statistics", "string", "textwrap", "types", "typing",
    "warnings",
))  # fmt: skip
"""Standard modules that show nothing of who calls, or when; all others may."""
FRAMES = frozenset((
    "__traceback__", "tb_frame", "f_back", "f_globals", "f_locals", "f_code", "gi_frame",
    "__globals__", "__code__", "__closure__", "__subclasses__",
))  # fmt: skip
"""Attributes that lead to the caller, or out of what a function is given."""


def _refused(name: str) -> str:
    return (
        f"it calls {name}: its result depends on more than its arguments: leave that out, or make"
        " it an argument"
    )


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
        raise InputError(_refused(self.__name__))

    def __getattr__(self, name: str) -> Any:
        return Changing(f"{self.__name__}.{name}")

    __contains__ = __getitem__ = __iter__ = __eq__ = __ne__ = __bool__ = __str__ = __call__
    __hash__ = None  # type: ignore[assignment]


NUMPY: dict[str, Any] = {
    **{name: _objects(getattr(np, name)) for name in (
        "array", "asarray", "zeros", "ones", "empty", "eye", "zeros_like", "empty_like",
        "ones_like", "full", "identity", "ascontiguousarray",
    )},
    **{name: Float for name in ("float64", "float32", "double")},
    **{name: _elementary(name, getattr(np, name)) for name in ELEMENTARY},
    "pi": PI, "e": E,
    "random": Changing("np.random"),
    "linalg": Module(np.linalg, linear_systems.NUMPY),
    "hypot": _hypot,
    "arctan2": _of_two(
        lambda y, x: y.arctan2(x) if isinstance(y, Traced) else np.arctan2(y, x), sympy.atan2,
        np.arctan2,
    ),
    "power": _of_two(np.power, operator.pow, np.power),
    "sign": _signs, "select": _selected,
    "finfo": lambda kind: np.finfo(float if kind is Float else kind),
}  # fmt: skip
MATH: dict[str, Any] = {
    **{name: _elementary(name, getattr(math, name)) for name in ELEMENTARY if hasattr(math, name)},
    **{short: _elementary(long, getattr(math, short)) for short, long in ALIASES.items()},
    "pi": PI,
    "e": E,
    "tau": TAU,
    "atan2": NUMPY["arctan2"],
    "pow": lambda x, y: x**y,
    "fmod": lambda x, y: x.fmod(y) if isinstance(x, Traced) else math.fmod(x, y),
    "hypot": _hypot,
}
LINEAR = {"numpy.linalg": linear_systems.NUMPY, "scipy.linalg": linear_systems.SCIPY}
CASADI: dict[str, Any] = {
    **{name: NUMPY[name] for name in ELEMENTARY if name in NUMPY},
    **{short: NUMPY[long] for short, long in ALIASES.items() if long in NUMPY},
    "pi": PI, "fabs": NUMPY.get("fabs", abs), "atan2": NUMPY["arctan2"],
    "vertcat": lambda *parts: np.concatenate([np.atleast_1d(np.asarray(p, object)) for p in parts]),
    "horzcat": lambda *parts: np.array([parts], dtype=object),
    "mtimes": np.dot, "solve": linear_systems.NUMPY["solve"], "inv": linear_systems.NUMPY["inv"],
}  # fmt: skip
"""Of CasADi on numbers; its own symbols are those of a `Function`."""
MODULES: dict[str, dict[str, Any]] = {
    "math": MATH, "numpy": NUMPY, "scipy": {}, "casadi": CASADI, **LINEAR,
}  # fmt: skip


def _changing(value: Any) -> str:
    """A name of what returns something else at each call; empty for other things."""
    # Nothing else is asked for its attributes: a person's object may answer anything.
    if isinstance(value, types.ModuleType):
        return value.__name__ if value.__name__ in CHANGING or _outside(value.__name__) else ""
    owner = value.__self__ if isinstance(value, METHODS) else None
    if isinstance(value, RANDOM) or isinstance(owner, RANDOM):
        return f"random numbers ({getattr(value, '__name__', type(value).__name__)})"
    if isinstance(value, dict | list):
        return next((f"sys.{n}" for n, own in vars(sys).items() if own is value), "")
    if not isinstance(value, type | types.FunctionType | types.BuiltinFunctionType):
        return ""
    place = value.__module__ or ""
    # A person's file may have the name of a standard module.
    its = getattr(sys.modules.get(place), value.__name__, None) is value
    return f"{place}.{value.__name__}" if place in CHANGING or (its and _outside(place)) else ""


def _outside(module: str) -> bool:
    """Whether it is a standard module that may show who calls."""
    root = module.partition(".")[0]
    return root in sys.stdlib_module_names and root.lstrip("_") not in OF_NUMBERS


def stand_in(value: Any, depth: int = 0) -> Any:
    """What a name of a traced function means."""
    value = unwrapped(value)
    if name := _changing(value):
        return Changing(name)
    if isinstance(value, types.ModuleType) and value.__name__ in MODULES:
        return Module(value, MODULES[value.__name__])
    if value is float:
        return Float
    if value is math.pi:
        return PI
    if isinstance(value, types.BuiltinFunctionType) and value.__module__ == "math":
        return MATH.get(value.__name__, value)
    for name, replacement in NUMPY.items():
        if value is getattr(np, name, None):
            return replacement
    if isinstance(value, types.FunctionType) and value.__module__ == "casadi.casadi":
        return CASADI.get(value.__name__, value)
    if found := _of_linear_systems(value):
        return found
    if isinstance(value, types.FunctionType) and not foreign(value):
        return copy_of(value, depth + 1)
    if isinstance(value, types.MethodType) and isinstance(value.__func__, types.FunctionType):
        return value if foreign(value.__func__) else copy_of(value, depth + 1)
    return value


def _of_linear_systems(value: Any) -> Any:
    """What stands for ``from numpy.linalg import solve``; None for other things."""
    for place, table in LINEAR.items():
        module = sys.modules.get(place)
        for name, replacement in table.items():
            if module is not None and value is getattr(module, name, None):
                return replacement
    return None


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
    names = _used(function.__code__)
    around = [n for n in named(function.__code__) if n[:2] == "__" and n in function.__globals__]
    if outside := sorted({*around, *FRAMES.intersection(names)}):
        raise InputError(f"function {function.__name__}: {_refused(outside[0])}")
    table = dict(function.__globals__)
    table["float"] = Float
    table.setdefault("print", _printed)
    table["__builtins__"] = {**vars(builtins), "__import__": _imported}
    for name in names:
        if name in table and table[name] is not function and name != "float":
            table[name] = stand_in(table[name], depth)
        elif name == "abs":
            table[name] = builtins.abs
        elif name in OUTSIDE and name not in table:
            table[name] = Changing(name)
    cells = tuple(
        types.CellType(stand_in(content(cell), depth)) for cell in function.__closure__ or ()
    )
    copied = types.FunctionType(
        function.__code__, table, function.__name__, function.__defaults__, cells or None
    )
    copied.__kwdefaults__ = function.__kwdefaults__
    # It calls its copy, not itself.
    table[function.__name__] = copied
    return copied


def _printed(*words: Any, file: Any = None, **options: Any) -> None:
    """What is printed to be seen changes nothing, and is left out; what is kept is not."""
    if file is not None:
        print(*words, file=file, **options)


def _imported(*arguments: Any, **options: Any) -> Any:
    """What ``import`` inside of a function finds."""
    return stand_in(builtins.__import__(*arguments, **options))


def _method(function: Callable[..., Any], bound: Any, depth: int) -> Callable[..., Any]:
    """A copy of a method, of an object whose other methods are copies, too."""
    if isinstance(function, types.FunctionType):
        others = methods_used(bound, [function])
        bound = with_methods(bound, {n: copy_of(f, depth + 1) for n, f in others.items()})
    return types.MethodType(copy_of(function, depth), bound)


def _used(code: types.CodeType) -> set[str]:
    inner = [_used(c) for c in code.co_consts if isinstance(c, types.CodeType)]
    return set(code.co_names).union(*inner)
