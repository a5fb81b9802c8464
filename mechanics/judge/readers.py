"""Whatever a person has, as statements: text, files, SymPy's objects, code."""

import inspect
import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import casadi
from sympy import Eq, Expr, SympifyError, sympify

from mechanics.claims.assemble import Reading
from mechanics.claims.code.arguments import UnexplainedError
from mechanics.claims.code.around.callers import callers
from mechanics.claims.code.around.unjudged_code import unjudged_code
from mechanics.claims.code.read import read_c, read_casadi, read_function
from mechanics.claims.code.sympy_objects import is_sympy, read_sympy, sides_of
from mechanics.claims.code.trace.tracing import OtherKindError
from mechanics.claims.code.translation.cpp_functions import SUFFIXES, without_users
from mechanics.claims.code.translation.read_arrays import (
    LANGUAGES,
    has_function,
    may_be_code,
    read_arrays,
    read_cpp,
)
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.read import decoded, file_text, read_file, read_source
from mechanics.claims.statement import Statement
from mechanics.errors import InputError, WrongKindError
from mechanics.judge.sources import (
    COMPUTED,
    Another,
    Around,
    Aside,
    Beside,
    NotRead,
    Numbers,
    WholeFile,
    values_of,
)
from mechanics.judge.special_case import values_in
from mechanics.scene import Scene

FILE = re.compile(
    r"[\w~./\\ :-]{1,400}\.(tex|txt|m|jl|mo|c|cc|cpp|cxx|h|hh|hpp|ino|py|ipynb|md)", re.IGNORECASE
)
"""What no equation looks like, and a file's name does."""


def spread(equations: Any) -> list[Any]:
    """The things that a person passes, one by one.

    What `sympy.solve` returns, ``{x.diff(t, 2): ...}``, is an equation for each entry. All objects
    of SymPy's are one thing: a name means the same in all of them.
    """
    found = list(_flat(equations))
    objects = tuple(thing for thing in found if is_sympy(thing))
    if len(objects) < 2:
        return found
    first = next(k for k, thing in enumerate(found) if is_sympy(thing))
    others = [thing for thing in found if not is_sympy(thing)]
    return [*others[:first], objects, *others[first:]]


def _flat(thing: Any) -> Iterator[Any]:
    if isinstance(thing, list | tuple) and thing:
        for one in thing:
            yield from _flat(one)
    elif isinstance(thing, Mapping) and thing and all(isinstance(k, Expr) for k in thing):
        yield from (Eq(k, _expression(k, v), evaluate=False) for k, v in thing.items())
    else:
        yield thing


def _expression(name: Expr, value: Any) -> Expr:
    try:
        found = sympify(value, strict=True)
    except SympifyError:
        found = None
    if not isinstance(found, Expr):
        raise InputError(f"check: {name} is given as {type(value).__name__}: pass an expression")
    return found


def read(
    scene: Scene,
    thing: Any,
    names: Mapping[str, str] | None,
    notation: str | None,
    about: str | None,
    function: str | None = None,
) -> Reading:
    """Statements of one thing.

    Parameters
    ----------
    thing : str, bytes, Path, SymPy object or a tuple of them, CasADi Function, callable, Beside, \
            NotRead, Another or Around
    names, notation, about
        As for `mechanics.check`.
    function : str, optional
        Which function of a C file.

    Raises
    ------
    InputError
        When it cannot be read.
    WrongKindError
        For another kind of thing.
    """
    if isinstance(thing, Beside | Around | WholeFile):
        return Reading((), (), ())
    if isinstance(thing, Numbers):
        told = (f"{name}: {COMPUTED}" for name in thing.names)
        return Reading((), (), (), tuple(told))
    if isinstance(thing, NotRead):
        return _not_read(thing)
    if isinstance(thing, Aside):
        return _aside(scene, thing, names)
    if isinstance(thing, Another):
        return _another(scene, thing, names)
    if isinstance(thing, Path):
        if thing.suffix.lower() == ".ipynb":
            raise InputError(f"file {thing}: a notebook has cells: mechanics grade reads them")
        if thing.suffix in (".c", ".h", *SUFFIXES):
            text, origin = file_text(thing), str(thing)
            c = thing.suffix not in SUFFIXES
            used = text if function == "main" else without_users(text, function, c=c)
            found = _read_c_file(scene, used, thing.suffix, function, names, about, origin)
            return _with_rest(found, scene, thing, text, names, function)
        options = {"names": names, "notation": notation, "about": about}
        known = thing.suffix in LANGUAGES and notation is None
        text = file_text(thing) if known else ""
        if known and has_function(text):
            found = read_arrays(scene, text, thing.suffix, function, names, about, str(thing))
            return _with_rest(found, scene, thing, text, names, function)
        if known and may_be_code(text, thing.suffix):
            with suppress(InputError):  # else a page of equations
                found = read_arrays(scene, text, thing.suffix, function, names, about, str(thing))
                return _with_rest(found, scene, thing, text, names, function)
        return read_file(scene, thing, **options)
    if isinstance(thing, bytes):
        thing = decoded(thing, "bytes")
    if isinstance(thing, str):
        _no_path(thing)
        if notation == "c":
            return read_c(scene, thing, function, names, about)
        return read_source(scene, thing, names=names, notation=notation, about=about)
    if isinstance(thing, casadi.Function):
        return read_casadi(scene, thing, names, about)
    if is_sympy(thing) or (isinstance(thing, tuple) and all(map(is_sympy, thing))):
        return read_sympy(scene, thing, names, about)
    if isinstance(thing, ModuleType) or not callable(thing):
        raise WrongKindError(
            f"check: {type(thing).__name__} found: pass LaTeX, text, a Path, a SymPy object, a"
            " CasADi Function or a Python function"
        )
    try:
        found = read_function(scene, thing, names, about)
    except OtherKindError:
        if (objects := _returned(thing)) is None:
            raise
        return read_sympy(scene, objects, names, about)
    return _with_values(found, scene, values_of(thing, _words(scene, names)), names)


INCLUDED = re.compile(r'#include "[^"]*" is not supported')
WHOLE = re.compile(r"\babs\s*\(")
"""A function of integers in C, and of real numbers in C++."""


def _read_c_file(
    scene: Scene, text: str, suffix: str, function: str | None, names: Mapping[str, str] | None,
    about: str | None, origin: str,
) -> Reading:  # fmt: skip
    if suffix in SUFFIXES:
        return read_cpp(scene, text, function, names, about, origin)
    try:
        return read_c(scene, text, function, names, about, origin)
    except InputError as error:
        absent = INCLUDED.search(str(error)) or "is not declared" in str(error)
        if not absent or WHOLE.search(text):
            raise
        try:  # with names that nothing declares as arguments
            return read_cpp(scene, text, function, names, about, origin)
        except InputError:
            raise error from None


def _with_rest(
    found: Reading, scene: Scene, path: Path, text: str, names: Mapping[str, str] | None,
    function: str | None,
) -> Reading:  # fmt: skip
    """What was read of a file of code, and what stands in it beside that."""
    naming = _single(scene, names)
    beside = unjudged_code(text, path.suffix, found, naming, chosen=function is not None)
    judged = {s.source.partition(":")[0] for s in found.statements}
    remarks = (*found.remarks, *callers(text, path.suffix, judged))
    return replace(_with_values(found, scene, text, names), beside=beside, remarks=remarks)


def _with_values(
    found: Reading, scene: Scene, text: str, names: Mapping[str, str] | None
) -> Reading:
    """The reading of code with what its text gives values to, and that it does not take."""
    taken = {word for match in found.names for word in match.meaning.split()}
    values = values_in(text, scene, _single(scene, names)).items()
    unused = tuple((s, v) for s, v in values if str(s) not in taken)
    statements = tuple(replace(s, file_values=unused) for s in found.statements)
    return replace(found, statements=statements)


def _single(scene: Scene, names: Mapping[str, str] | None) -> Naming:
    """Names of numbers; what code calls a vector is no name of the lines around it."""
    vocabulary = Vocabulary(scene)
    single = {
        n: m for n, m in (names or {}).items() if m == "t" or vocabulary.target(m) is not None
    }
    return Naming(vocabulary, single)


def _words(scene: Scene, names: Mapping[str, str] | None) -> set[str]:
    """What may be called a parameter or an input."""
    return {*(names or {}), *(symbol.name for symbol in (*scene.parameters, *scene.input_symbols))}


def _not_read(thing: NotRead) -> Reading:
    words = f"{thing.part} is not read: {thing.why}"
    return Reading((Statement(None, thing.part, thing.part, doubt=words),), (), ())


def _aside(scene: Scene, thing: Aside, names: Mapping[str, str] | None) -> Reading:
    """A formula beside others, which may be an attempt that was given up: it is never REFUTED."""
    title = f"{thing.where}, {' '.join(thing.text.split())[:60]!r}"
    if "=" not in thing.text:
        words = Vocabulary(scene)
        told = (words.lookup(name) for name in re.findall(r"[^\W\d]\w*", thing.text))
        moves = any(one is not None and one[0] in words.functions for one in told)
        return Reading((), (), (), (f"{title}: an expression, not judged",) if moves else ())
    try:
        found = read_source(scene, thing.text, names=names)
    except InputError as error:
        return _not_read(NotRead(title, str(error)))
    unsure = (f"{title} is about something else",)
    return replace(found, statements=tuple(replace(s, unsure=unsure) for s in found.statements))


def _another(scene: Scene, thing: Another, names: Mapping[str, str] | None) -> Reading:
    """A function that may be about something else, so that it is never REFUTED.

    One whose arguments are no names of the scene, or that returns no numbers, says nothing of it.
    """
    try:
        found = read_function(scene, thing.function, names)
    except (UnexplainedError, OtherKindError):
        words = "its arguments are no names of the scene, or it returns no numbers"
        return Reading((), (), (f"function {thing.name} is not judged: {words}",))
    except InputError as error:
        return _not_read(NotRead(f"function {thing.name}", str(error)))
    unsure = (f"{thing.name} is about something else",)
    return replace(found, statements=tuple(replace(s, unsure=unsure) for s in found.statements))


def _returned(function: Any) -> Any:
    """SymPy's objects that a function without arguments returns each time; None for others."""
    wanted = inspect.signature(function).parameters.values()
    if any(
        p.default is p.empty and p.kind not in (p.VAR_POSITIONAL, p.VAR_KEYWORD) for p in wanted
    ):
        return None
    first, again = tuple(_flat(function())), tuple(_flat(function()))
    if not first or not all(map(is_sympy, (*first, *again))):
        return None
    same = [*map(sides_of, first)] == [*map(sides_of, again)]
    return first if same else None


def _no_path(text: str) -> None:
    """Refuse the name of a file where its text is wanted.

    Raises
    ------
    InputError
    """
    if FILE.fullmatch(text.strip()) is None:
        return
    name = text.strip()
    if name.lower().endswith((".py", ".ipynb")):
        words = "import it and pass its function"
        raise InputError(f"text, line 1, column 1: {name!r} is the name of a file: {words}")
    words = f"pass pathlib.Path({name!r})"
    raise InputError(
        f"text, line 1, column 1: {name!r} is the name of a file, not its text: {words}"
    )
