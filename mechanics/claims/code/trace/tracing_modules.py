"""What a function that is traced finds in place of `math`, `numpy` and `float`.

    math.sin(x) -> x.sin()        np.zeros(4) -> an array of objects        np.linalg.solve -> exact

A function is not changed: a copy of it is made whose names mean these.
"""

import builtins
import functools
import math
import operator
import random
import sys
import types
from collections.abc import Callable, Mapping
from contextlib import suppress
from itertools import zip_longest
from operator import methodcaller
from typing import Any, cast

import numpy as np
import sympy
from sympy import Expr

from mechanics.claims.code.constants import exact_in_single
from mechanics.claims.code.python.closure_numbers import content, foreign, named
from mechanics.claims.code.python.containers import library, of_library
from mechanics.claims.code.python.instructions import instructions
from mechanics.claims.code.python.objects import class_with_methods, methods_of, with_methods
from mechanics.claims.code.python.wrappers import unwrapped
from mechanics.claims.code.trace import linear_systems
from mechanics.claims.code.trace.exact import ELEMENTARY, PI, TAU, E, Exact, exact, is_plain
from mechanics.claims.code.trace.tracer import Traced
from mechanics.errors import InputError

ALIASES = {
    "asin": "arcsin", "acos": "arccos", "atan": "arctan", "asinh": "arcsinh", "acosh": "arccosh",
    "atanh": "arctanh",
}  # fmt: skip
SIGN = methodcaller("sign")


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
    """An array whose entries may be traced numbers where NumPy makes one of floats.

    One of integers or truth values stays that: it cuts what is put there, adds in its own way, and
    no traced number can be put there.
    """

    def apply(x: Any, *rest: Any, **options: Any) -> Any:
        rest = tuple(map(_of_kind, rest))
        options = {name: _of_kind(option) for name, option in options.items()}
        asked = [o for o in (*rest, options.get("dtype")) if isinstance(o, str | type | np.dtype)]
        if not _is_traced((x, *rest, *options.values())) or (asked and not _floats(asked[0])):
            plain = make(x, *rest, **options)
            if not _floats(plain.dtype) or np.may_share_memory(plain, x):
                return plain
        same = isinstance(x, np.ndarray) and x.dtype == object
        kept = {k: v for k, v in options.items() if k != "dtype" and (k != "copy" or same)}
        positional = [r for r in rest if not isinstance(r, str | type | np.dtype)]
        found = make(x, *positional, dtype=object, **kept)
        kind = np.dtype(asked[0]) if asked else np.dtype(float)
        if kind.kind == "f" and kind.itemsize <= SINGLE_BYTES:
            for entry in found.flat:
                if isinstance(entry, float):
                    exact_in_single(float(entry), kind.type(entry))
        return found

    return apply


def _is_traced(value: Any) -> bool:
    """Whether something holds a traced number."""
    if isinstance(value, np.ndarray):
        return value.dtype == object and any(map(_is_traced, value.flat))
    return isinstance(value, Traced) or (
        isinstance(value, list | tuple) and any(map(_is_traced, value))
    )


def _of_kind(option: Any) -> Any:
    return option.of if isinstance(option, _Kind) else option


def _floats(kind: Any) -> bool:
    """Whether an array is of doubles, or of single precision, whose rounding is not judged."""
    dtype = np.dtype(kind)
    return dtype.kind == "O" or (dtype.kind == "f" and dtype.itemsize >= SINGLE_BYTES)


class _Kind(type):
    """A traced number stays what it is where it is made one of the kind."""

    of: type

    def __instancecheck__(cls, thing: object) -> bool:
        return isinstance(thing, cls.of)

    def __call__(cls, x: Any = 0.0, *_: Any, **__: Any) -> Any:
        if isinstance(x, Traced) and cls is Single:
            x.explorer.notes += [note for note in (SINGLE_NOTE,) if note not in x.explorer.notes]
        if cls is Single and not isinstance(x, Traced):
            exact_in_single(float(x), np.float32(x))
        return x if isinstance(x, Traced | Exact) else float(x)


class Float(metaclass=_Kind):
    """In place of `float`: ``isinstance(x, float)``, ``float(x)``, ``np.zeros(2, float)``."""

    of: type = float


class Float64(Float):
    """In place of `np.float64`."""

    of: type = np.float64


class Single(Float):
    """In place of `np.float32`, whose rounding is said and not judged."""

    of: type = np.float32


SINGLE_BYTES = 4
SINGLE_NOTE = "single precision (np.float32) is read as exact numbers"


SINGLE_WORDS = frozenset(("float32", "float16", "f4", "<f4", "f2", "<f2"))


def names_single(code: types.CodeType) -> bool:
    """Whether code names a precision below that of doubles; ``half`` may be anybody's function."""
    inner = (names_single(part) for part in code.co_consts if isinstance(part, types.CodeType))
    words = {part for part in code.co_consts if isinstance(part, str)}
    return bool(SINGLE_WORDS & {*code.co_names, *words}) or any(inner)


class _Type(_Kind):
    """What depends on the class of a traced number is hidden."""

    def __call__(cls, x: Any = 0.0, *rest: Any, **options: Any) -> Any:
        if isinstance(x, Traced):
            x.is_of(int)
        return type(x, *rest, **options)


class Type(metaclass=_Type):
    """In place of `type`."""

    of = type


def _is_instance(thing: Any, kinds: Any) -> bool:
    if not isinstance(thing, Traced):
        return isinstance(thing, kinds)
    every = kinds if isinstance(kinds, tuple) else getattr(kinds, "__args__", (kinds,))
    return thing.is_of(tuple(kind.of if isinstance(kind, _Kind) else kind for kind in every))


def _has_attribute(thing: Any, name: str) -> bool:
    """`hasattr`, of a traced number as of a float."""
    if isinstance(thing, Traced) and hasattr(np.float64, name) and not hasattr(float, name):
        return thing.is_of(np.float64)
    return hasattr(0.0 if isinstance(thing, Traced) else thing, name)


def _attribute(thing: Any, name: str, *default: Any) -> Any:
    """`getattr`, of a traced number as of a float."""
    if name in FRAMES:
        raise InputError(_refused(name))
    if isinstance(thing, Traced) and name not in vars(Traced):
        if hasattr(0.0, name):
            thing.is_of(np.float64)  # its methods hide formulas
        _has_attribute(thing, name)
        return getattr(0.0, name, *default)
    return getattr(thing, name, *default)


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
OUTSIDE = ("input", "open", "eval", "exec", "globals", "hash", "id", "vars", "dir", "memoryview")
OF_NUMBERS = frozenset((
    "__future__", "abc", "bisect", "builtins", "cmath", "collections", "contextlib", "copy",
    "dataclasses", "decimal", "enum", "fractions", "functools", "heapq", "itertools", "logging",
    "math", "numbers", "operator", "re", "statistics", "string", "textwrap", "types", "typing",
    "warnings",
))  # fmt: skip
"""Standard modules that show nothing of who calls, or when; all others may."""
FRAMES = frozenset((
    "__traceback__", "tb_frame", "f_back", "f_globals", "f_locals", "f_code", "gi_frame",
    "__globals__", "__code__", "__closure__", "__subclasses__", *Traced.__slots__, "is_of",
    "tobytes", "ctypes",
))  # fmt: skip
"""Attributes that lead to the caller, out of what a function is given, or tell who traces it."""
OF_OBJECTS = ("__init__", "__post_init__", "__name__", "__call__", "__len__", "__version__")
OF_NAMES = frozenset((
    "AttributeError", "ImportError", "IndexError", "KeyError", "ModuleNotFoundError", "NameError",
    "StopIteration", "TypeError",
))  # fmt: skip
"""Errors that depend on names and places, and not on numbers."""
NUMBERS = (int, float, np.generic)
OF_ITSELF = ("__class__", "__dict__")
"""Attributes with two underscores that code may ask for: of anything, of its own object."""


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
    "float64": Float64, "double": Float64, "float32": Single, "single": Single,
    **{name: _elementary(name, getattr(np, name)) for name in ELEMENTARY},
    "pi": PI, "e": E,
    **{name: Changing(f"np.{name}") for name in (
        "random", "result_type", "min_scalar_type", "can_cast", "issubdtype", "promote_types",
        "common_type", "typename", "iscomplexobj", "isrealobj",
    )},
    "linalg": Module(np.linalg, linear_systems.NUMPY),
    "hypot": _hypot,
    "arctan2": _of_two(
        lambda y, x: y._arctan2(x) if isinstance(y, Traced) else np.arctan2(y, x), sympy.atan2,
        np.arctan2,
    ),
    "power": _of_two(np.power, operator.pow, np.power),
    "sign": _signs, "select": _selected,
    "finfo": lambda kind: np.finfo(kind.of if isinstance(kind, _Kind) else kind),
}  # fmt: skip
MATH: dict[str, Any] = {
    **{name: _elementary(name, getattr(math, name)) for name in ELEMENTARY if hasattr(math, name)},
    **{short: _elementary(long, getattr(math, short)) for short, long in ALIASES.items()},
    "pi": PI,
    "e": E,
    "tau": TAU,
    "atan2": NUMPY["arctan2"],
    "pow": lambda x, y: x**y,
    "fmod": lambda x, y: x._fmod(y) if isinstance(x, Traced) else math.fmod(x, y),
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
    "operator": {name: Changing(f"operator.{name}") for name in ("attrgetter", "methodcaller")},
}  # fmt: skip


def _changing(value: Any) -> str:
    """A name of what returns something else at each call; empty for other things."""
    # Nothing else is asked for its attributes: a person's object may answer anything.
    if isinstance(value, types.ModuleType):
        return value.__name__ if value.__name__ in CHANGING or outside(value.__name__) else ""
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
    return f"{place}.{value.__name__}" if place in CHANGING or (its and outside(place)) else ""


def outside(module: str) -> bool:
    """Whether it is a standard module that may show who calls, or when."""
    root = module.partition(".")[0]
    return root in sys.stdlib_module_names and root.lstrip("_") not in OF_NUMBERS


Made = dict[int, Any]
"""Copies by the identities of what they are copies of."""


def stand_in(value: Any, made: Made) -> Any:
    """What a name of a traced function means."""
    if isinstance(value, functools._lru_cache_wrapper):
        return _cached(stand_in(value.__wrapped__, made))
    value = unwrapped(value)
    if id(value) in made:
        return made[id(value)]
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
        return copy_of(value, made)
    if isinstance(value, types.MethodType) and isinstance(value.__func__, types.FunctionType):
        return value if foreign(value.__func__) else copy_of(value, made)
    kind = value if isinstance(value, type) else type(value)
    if isinstance(value, types.ModuleType) or of_library(kind):
        return value
    return _class_copy(value, made) if kind is value else _object_copy(value, made)


def _cached(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function whose results are kept: one that can be changed is another one in later calls."""

    def call(*arguments: Any, **options: Any) -> Any:
        result = function(*arguments, **options)
        if isinstance(result, list | dict | set | np.ndarray):
            words = "keeps a result that can be changed: return a tuple, or do not cache it"
            raise InputError(f"{getattr(function, '__name__', 'a cached function')} {words}")
        return result

    return call


def _object_copy(value: Any, made: Made) -> Any:
    """An object of a person's class whose methods are copies."""
    if id(value) not in made:
        made[id(value)] = with_methods(value, _copies(type(value), made))
    return made[id(value)]


def _class_copy(kind: type, made: Made) -> type:
    if id(kind) not in made:
        made[id(kind)] = kind  # its methods may name it
        table = _copies(kind, made)
        made[id(kind)] = class_with_methods(kind, table) if table else kind
    return made[id(kind)]


def _copies(kind: type, made: Made) -> dict[str, Callable[..., Any]]:
    """Copies of the methods of a person's class; what cannot be copied is refused when it runs."""
    found: dict[str, Callable[..., Any]] = {}
    for name, function in methods_of(kind).items():
        if name == "__exit__":
            raise InputError(f"{kind.__name__} catches what a block raises: leave it out")
        if not library(function.__module__ or ""):
            with suppress(InputError):
                found[name] = copy_of(function, made)
    return found


def _of_linear_systems(value: Any) -> Any:
    """What stands for ``from numpy.linalg import solve``; None for other things."""
    for place, table in LINEAR.items():
        module = sys.modules.get(place)
        for name, replacement in table.items():
            if module is not None and value is getattr(module, name, None):
                return replacement
    return None


def copy_of(function: Callable[..., Any], made: Made | None = None) -> Callable[..., Any]:
    """A copy of a Python function whose names mean the stand-ins.

    Raises
    ------
    InputError
        When it is no Python function.
    """
    made = {} if made is None else made
    if isinstance(function, types.MethodType):
        return _method(function.__func__, function.__self__, made)
    if not isinstance(function, types.FunctionType):
        called = type(function).__call__
        if isinstance(called, types.FunctionType):
            return _method(called, function, made)
        raise InputError(f"{function!r} is no Python function: its code cannot be traced")
    if id(function) in made:
        return cast(Callable[..., Any], made[id(function)])
    around = [n for n in named(function.__code__) if n[:2] == "__" and n in function.__globals__]
    if outside := sorted({*around, *_telling(function.__code__, function.__globals__)}):
        raise InputError(f"function {function.__name__}: {_refused(outside[0])}")
    if caught := _catching(function.__code__):
        words = f"it catches {caught}, which may depend on numbers: write a condition"
        raise InputError(f"function {function.__name__}: {words}")
    table = {**function.__globals__, "float": Float}
    table["__builtins__"] = {**vars(builtins), **BUILTINS}  # a function takes them when it is made
    table.setdefault("print", _printed)
    cells = tuple(types.CellType() for _ in function.__closure__ or ())
    copied = types.FunctionType(
        function.__code__, table, function.__name__, function.__defaults__, cells or None
    )
    copied.__kwdefaults__ = function.__kwdefaults__
    made[id(function)] = copied  # it calls its copy, not itself
    for name in _used(function.__code__):
        if name in table and name != "float":
            table[name] = stand_in(table[name], made)
        elif name == "abs":
            table[name] = builtins.abs
        elif name in OUTSIDE and name not in table:
            table[name] = Changing(name)
    for cell, own in zip(cells, function.__closure__ or (), strict=True):
        cell.cell_contents = stand_in(content(own), made)
    return copied


def _printed(*words: Any, file: Any = None, **options: Any) -> None:
    """What is printed to be seen changes nothing, and is left out; what is kept is not."""
    if file is not None:
        print(*words, file=file, **options)


def _imported(*arguments: Any, **options: Any) -> Any:
    """What ``import`` inside of a function finds."""
    return stand_in(builtins.__import__(*arguments, **options), {})


def _method(function: Callable[..., Any], bound: Any, made: Made) -> Callable[..., Any]:
    """A copy of a method, of an object whose other methods are copies, too."""
    if isinstance(function, types.FunctionType) and not isinstance(bound, types.ModuleType):
        bound = stand_in(bound, made)
    return types.MethodType(copy_of(function, made), bound)


BUILTINS: dict[str, Any] = {
    "__import__": _imported, "type": Type, "isinstance": _is_instance,
    "hasattr": _has_attribute, "getattr": _attribute,
}  # fmt: skip


def _telling(code: types.CodeType, table: Mapping[str, Any]) -> set[str]:
    """Attributes and cases by class that may tell who calls; `table` has the names of the file."""
    found, before, kind = set(), "", ""
    every = instructions(code)
    for one, after in zip_longest(every, every[1:]):
        name = str(one.argval)
        if one.opname == "MATCH_CLASS":
            found.add("a case by class")
        if one.opname in ("LOAD_ATTR", "LOAD_METHOD", "STORE_ATTR"):
            dunder = name.startswith("__") and name.endswith("__") and name not in OF_OBJECTS
            if name in FRAMES or (dunder and not (name in OF_ITSELF and before in ("self", "cls"))):
                found.add(name)
            if name == "dtype" and not (after and after.opname in ("KW_NAMES", "LOAD_CONST")):
                found.add(name)  # it is object; ``dtype=y.dtype`` of a new array is none of it
            if name == "data" and after and after.argval in ("format", "itemsize"):
                found.add(f"data.{after.argval}")
        if one.opname == "IS_OP" and not (
            (kind == "LOAD_CONST" and before == "None")
            or (kind == "LOAD_GLOBAL" and not isinstance(table.get(before), NUMBERS))
        ):
            found.add("is, which compares no numbers")
        before, kind = name, one.opname
    inner = (c for c in code.co_consts if isinstance(c, types.CodeType))
    return found.union(*(_telling(part, table) for part in inner))


def _catching(code: types.CodeType) -> str:
    """What code catches that numbers may raise: a traced division raises nothing."""
    every = instructions(code)
    for place, start in enumerate(every):
        if start.opname != "PUSH_EXC_INFO":
            continue
        names = []
        for one in every[place:]:
            if one.opname in ("RERAISE", "WITH_EXCEPT_START"):
                break
            if one.opname == "POP_EXCEPT":
                return "everything"
            if one.opname in ("LOAD_GLOBAL", "LOAD_NAME", "LOAD_ATTR"):
                names.append(str(one.argval))
            if one.opname == "CHECK_EXC_MATCH":
                if not {*names} <= OF_NAMES:
                    return ", ".join(names)
                break
    if "suppress" in code.co_names:
        return "what suppress is told"
    inner = (_catching(c) for c in code.co_consts if isinstance(c, types.CodeType))
    return next(filter(None, inner), "")


def _used(code: types.CodeType) -> set[str]:
    inner = [_used(c) for c in code.co_consts if isinstance(c, types.CodeType)]
    return set(code.co_names).union(*inner)
