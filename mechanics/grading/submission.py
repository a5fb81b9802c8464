"""What a student hands in, as things that `check` reads.

    a.tex, a.txt, a.md, a.m    text        a.c, a.h    C        a.ipynb    its cells
    a.py    its last function that is no part of another, or the one asked for, which is run;
            of a script without one its equations in SymPy's objects

Code in Python is only run where that is allowed.
"""

import ast
import inspect
import json
import re
import sys
from collections.abc import Collection, Mapping, Sequence
from dis import get_instructions
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

import sympy
from sympy import Basic, Eq
from sympy.matrices import MatrixBase

from mechanics.claims.code.around.python_lines import integrators, reached
from mechanics.claims.code.comments import comments
from mechanics.claims.code.python.file_names import unsettled
from mechanics.claims.code.python.python_call import Unsaid
from mechanics.claims.read import file_text
from mechanics.errors import InputError
from mechanics.grading.absent_modules import FOLDER, standing_in
from mechanics.grading.asides import asides_of, outputs_of
from mechanics.grading.casadi_values import names_of_results
from mechanics.grading.cells import Cell, is_inert, runnable
from mechanics.grading.file_level import libraries_unchanged, used_by
from mechanics.grading.lost_values import KEEP, keeper, keeping, numbers_of_formulas
from mechanics.grading.other_functions import passing, unjudged_functions
from mechanics.grading.other_values import SHOW, WHY, Showing, equations_in, unread_values
from mechanics.grading.script_formulas import claims_of, is_name
from mechanics.grading.unset_attributes import with_unset
from mechanics.judge.sources import (
    Another,
    Around,
    Beside,
    NotRead,
    Numbers,
    WholeFile,
    on_the_file,
)

GONE = re.compile(
    r"<!--.*?(?:-->|\Z)|~~.*?~~|^\[//\]: #[^\n]*"
    r"|<(?P<struck>del|s|strike)\b[^>]*>.*?</(?P=struck)>",
    re.DOTALL | re.MULTILINE,
)
"""What a page in Markdown does not show, and what its author has struck out."""
RUN = "Python is only run where that is allowed: --run-python (run_python=True)"


def things_in(path: Path, *, function: str | None = None, run_python: bool = False) -> list[Any]:
    """Texts, paths, functions and words beside these, in order.

    Parameters
    ----------
    function : str, optional
        Of a Python file or notebook; when not given, the last one that is no part of another.
    run_python : bool
        Whether code in Python may be run.

    Raises
    ------
    InputError
        When there is nothing that can be read.
    """
    suffix = path.suffix.lower()
    if suffix == ".py":
        return _functions(path, file_text(path), function, run_python)
    if suffix == ".ipynb":
        return _cells(path, function, run_python)
    if suffix == ".md" and (code := BLOCK.findall(page := file_text(path))):
        blocks = [Cell("code", text, f"block {k} of code") for k, text in enumerate(code, start=1)]
        if not run_python:
            return [path, *(NotRead(b.name, RUN) for b in blocks if not is_inert(b.text))]
        prose = Cell("markdown", BLOCK.sub("", page), "page")
        return _parts(path, [prose, *blocks], function, run_python)
    return [path]


BLOCK = re.compile(r"^```[ \t]*(?:python|py)[ \t]*\n(.*?)^```[ \t]*$", re.DOTALL | re.MULTILINE)
"""Code in Python on a page in Markdown."""
FENCE = re.compile(
    r"^[ \t]*(?P<marks>`{3,}|~{3,})[^\n]*\n(?P<text>.*?)(?:^[ \t]*(?P=marks)[^\n]*$|\Z)",
    re.DOTALL | re.MULTILINE,
)
"""Code in any language on a page."""


def _cells(path: Path, function: str | None, run_python: bool) -> list[Any]:
    """All cells: the prose of those of Markdown, what those of code define, what is not read."""
    try:
        cells = json.loads(file_text(path))["cells"]
        own = [
            Cell(
                cell["cell_type"],
                "".join(cell["source"]),
                f"{cell['cell_type']} cell {k}",
                outputs_of(cell),
            )
            for k, cell in enumerate(cells, start=1)
        ]
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(f"file {path}: it is no notebook: {type(error).__name__}") from None
    return _parts(path, own, function, run_python)


def _parts(path: Path, cells: list[Cell], function: str | None, run_python: bool) -> list[Any]:
    """The prose of cells together, what their code defines, and what is not read of them."""
    pages = (FENCE.sub("", cell.text) for cell in cells if cell.kind == "markdown")
    shown = (GONE.sub("", text) for text in pages)
    prose = "\n\n".join(text for text in shown if text.strip())
    code = [cell for cell in cells if cell.kind == "code"]
    beside = [cell.text for cell in cells if cell.kind == "raw"]
    blocks = [words for cell in code for words in comments(cell.text, ".py")]
    beside += [line for words in blocks for line in words.splitlines()]
    # Commented code is no equation that is handed in.
    said = (text for text in beside if "=" not in text)
    found: list[Any] = ["\n\n".join((prose, *said))] if "=" in prose else []
    claiming = [cell for cell in code if not is_inert(cell.text)]
    whole = "\n".join(runnable(cell.text) for cell in code)
    if claiming and (run_python or not found):
        try:
            found += _functions(path, whole, function, run_python)
        except NothingError as error:
            if not found:
                raise
            found += [NotRead(cell.name, error.why) for cell in claiming]
        words = "\n".join((prose, *beside)).strip()
        found += [Beside(words)] if words else []
    elif claiming:
        found += [NotRead(cell.name, RUN) for cell in claiming]
    if not found:
        raise InputError(f"file {path}: no cell has an equation or a function")
    found += [NotRead(cell.name, NO_CLAIM) for cell in cells if _is_unread(cell)]
    return [*found, *asides_of(code)]


NOT_JUDGED = "it is neither judged nor called by what is judged: leave it out, or hand it in"
NO_CLAIM = "it may hold an equation, and is neither prose nor code that is run"


def _is_unread(cell: Cell) -> bool:
    """Whether a cell that is neither code nor prose, or code on a page, may claim a thing."""
    if cell.kind == "markdown":
        return any("=" in found["text"] for found in FENCE.finditer(cell.text))
    return cell.kind != "code" and "=" in cell.text


class NothingError(InputError):
    """Code has no function and no equation."""

    def __init__(self, path: Path, why: str) -> None:
        super().__init__(f"file {path}: {why}")
        self.why = why


def _functions(path: Path, code: str, function: str | None, run_python: bool) -> list[Any]:
    """The function of a file, or its equations in SymPy's objects."""
    if not run_python:
        raise InputError(f"file {path}: {RUN}")
    page = _compiled(path, code)
    try:
        names, shown_things, lost = standing_in(lambda: _run(path, page))
    except InputError as error:
        raise InputError(f"file {path}: {error}") from None
    except Exception as error:  # a person's lines run here, and may raise anything
        raise InputError(f"file {path}: it ends in {type(error).__name__}: {error}") from None
    whole = names
    own = [
        n for n, v in names.items() if isinstance(v, FunctionType) and v.__module__ == "submission"
    ]
    gone = [
        NotRead(words, "it is overwritten or deleted later, and nothing uses it") for words in lost
    ]
    shown, solved = _returning(code)
    if not (function in own if function else any(n in shown and _takes(names[n]) for n in own)):
        held, methods = _methods(path, names)
        if methods or not own:
            names, own = held, methods
    own = [n for n in own if n == function or n not in integrators(ast.parse(code))] or own
    best = [n for n in own if n in solved] or [n for n in own if n in shown] or own
    chosen = function or (_last(names, best) if best else "")
    if not (own or function):
        held_ones = {n for n, v in _own(whole).items() if isinstance(v, HOLDING)}
        if strange := unsettled(ast.parse(code), held_ones, whole):
            raise InputError(f"file {path}: {strange}")
        claims = _equations(whole)
        lines, unread = claims_of(code, _own(whole))
        if not claims and lines and not unread:
            claims = ["\n".join(lines)]
        claims += [one for one in equations_in(shown_things) if one not in claims]
        if claims:
            left = [NotRead(name, WHY) for name in unread_values(_own(whole), set())]
            words = Beside("\n".join(comments(code, ".py")))
            return [*claims, *left, *gone, words, WholeFile(code)]
    if chosen not in own:
        told = f"it has {', '.join(own)}" if own else "it has none"
        raise NothingError(path, f"there is no function {chosen or 'to check'}: {told}")
    if names is not whole and len(twice := _classes_with(whole, chosen)) > 1:
        raise InputError(
            f"file {path}: {chosen} is a method of {' and of '.join(twice)}: leave one"
        )
    others = [] if function else _others(names, own, chosen, shown, passing(code))
    used = set().union(*(used_by(whole, n) for n in (chosen, *(other.name for other in others))))
    if strange := unsettled(ast.parse(code), used, whole, used):
        raise InputError(f"file {path}: {strange}")
    lines, unread = claims_of(code, _own(whole))
    formulas: list[Any] = ["\n".join(lines)] if lines and not unread else []
    loose = [NotRead(name, "it is a formula that no equation uses") for name in unread]
    judged = frozenset((chosen, *(other.name for other in others)))
    again = names_of_results(code, whole, judged)
    values = [name for name in unread_values(_own(whole), used) if name not in again]
    if not function:
        known = {chosen, *(o.name for o in others), *(type(whole[n]).__name__ for n in values)}
        deleted = {getattr(one, "name", "") for one in ast.parse(code).body} - {*whole}
        loose += [NotRead(p, NOT_JUDGED) for p in unjudged_functions(code, known | deleted)]
    loose += [NotRead(name, WHY) for name in values]
    formulas += equations_in(shown_things)
    numbers = tuple(numbers_of_formulas(code, whole, used))
    formulas += [Numbers(numbers)] if numbers else []
    around: list[Any] = [] if _is_alone(code, judged) else [Around(code, judged)]
    if not around and any(map(_gives, ast.parse(code).body)):
        around = [WholeFile(code)]
    return [names[chosen], *on_the_file(code), *others, *formulas, *loose, *gone, *around]


def _is_alone(code: str, judged: Collection[str]) -> bool:
    """Whether a file has nothing but judged functions, what they call, imports and numbers."""
    tree = ast.parse(code)
    own = reached(tree, judged)
    rest = (n for n in tree.body if not (isinstance(n, ast.FunctionDef) and n.name in own))
    return all(is_inert(ast.unparse(line)) for line in rest)


def _gives(line: ast.stmt) -> bool:
    """Whether a line of a file may give a name a value."""
    return not isinstance(line, ast.FunctionDef | ast.Import | ast.ImportFrom | ast.Expr)


def _others(
    names: Mapping[str, Any],
    own: Sequence[str],
    chosen: str,
    shown: Collection[str],
    passing_on: Collection[str],
) -> list[Another]:
    """Functions with arguments that are no parts of the one that is judged, and do not use it."""
    codes = {n: getattr(names[n], "__func__", names[n]).__code__ for n in own}
    parts = {n: _spoken(code) & {*own} - {n} for n, code in codes.items()}

    def reached(start: str) -> set[str]:
        found, todo = {start}, [start]
        while todo:
            new = parts[todo.pop()] - found
            found |= new
            todo += new
        return found

    near = {*reached(chosen), *(n for n in own if chosen in reached(n))}
    # A function that is only passed on is no part of what does that.
    used = {part for n in own if n not in passing_on for part in parts[n]}
    return [
        Another(names[n], n) for n in own
        if n not in near and n not in used and (n in shown or codes[n].co_name == "<lambda>")
        and _takes(names[n]) and n != "__call__"
    ]  # fmt: skip


def _own(names: Mapping[str, Any]) -> dict[str, Any]:
    """Names of a script without those of SymPy's that it takes over."""
    return {n: v for n, v in names.items() if getattr(sympy, n, None) is not v}


HOLDING = (Basic, MatrixBase, list, tuple, dict)
"""What holds equations of a script."""


def _equations(names: Mapping[str, Any]) -> list[Any]:
    """Equations of a script in SymPy's objects; none where it has other formulas beside them."""
    held = [[*v.values()] if isinstance(v, dict) else v for v in _own(names).values()]
    values = [part for v in held for part in (v if isinstance(v, list | tuple) else [v])]
    claims = [v for v in values if isinstance(v, Basic | MatrixBase) and not is_name(v)]
    return list(dict.fromkeys(claims)) if all(isinstance(v, Eq) for v in claims) else []


def _classes_with(names: Mapping[str, Any], method: str) -> list[str]:
    """Classes of a file with a method of their own of that name that does more than refuse."""
    classes = [v for v in names.values() if isinstance(v, type) and v.__module__ == "submission"]
    own = {c.__name__: vars(c).get(method) for c in classes}
    return [n for n, f in own.items() if isinstance(f, FunctionType) and not _is_empty(f)]


def _is_empty(function: FunctionType) -> bool:
    """Whether it only says that others have it: pass, ..., raise NotImplementedError."""
    code = function.__code__
    loads = {one.opname for one in get_instructions(code)} & {"LOAD_FAST", "LOAD_ATTR"}
    return not loads or "NotImplementedError" in code.co_names


def _compiled(path: Path, code: str) -> CodeType:
    """A file that tells what its lines show, and formulas that it loses, as it is run."""
    try:
        page = ast.fix_missing_locations(Showing().visit(keeping(ast.parse(code, str(path)))))
        return compile(page, str(path), "exec")
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise InputError(f"file {path}: it ends in {type(error).__name__}: {error}") from None


def _run(path: Path, page: CodeType) -> tuple[dict[str, Any], list[Any], dict[str, None]]:
    """The names of a file that is run, what its lines show, and formulas that it loses."""
    module = ModuleType("submission")
    names = vars(module)
    names["__file__"], names["__package__"] = str(path), FOLDER
    shown: list[Any] = []
    lost: dict[str, None] = {}

    def remembered(thing: Any) -> Any:
        shown.append(thing)
        return thing

    before = sys.modules.get("submission")
    sys.modules["submission"] = module  # where a dataclass looks for what its annotations say
    try:
        with libraries_unchanged():
            names[SHOW], names[KEEP] = remembered, keeper(lost)
            exec(page, names)  # in a worker, as the caller allows
    finally:
        del sys.modules["submission"]
        if before is not None:
            sys.modules["submission"] = before
    del names[SHOW], names[KEEP]
    return names, shown, lost


SOLVERS = re.compile(r"solve_ivp|odeint|^ode$|^RK45$|^LSODA$|^rk4|runge", re.IGNORECASE)
"""What solves equations that it is given as a function."""


def _returning(code: str) -> tuple[set[str], set[str]]:
    """Functions and methods of a file that may return numbers, and those that are solved."""
    shown: set[str] = set()
    solved: set[str] = set()
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.FunctionDef):
            inner = [part for part in ast.walk(node) if isinstance(part, ast.Return)]
            truths = (ast.Compare, ast.BoolOp)
            if any(r.value is not None and not isinstance(r.value, truths) for r in inner):
                shown.add(node.name)
            elif any(isinstance(p, ast.Subscript) and isinstance(p.ctx, ast.Store)
                     for p in ast.walk(node)):  # fmt: skip
                shown.add(node.name)  # it fills an array
        elif isinstance(node, ast.Call) and node.args:
            called = getattr(node.func, "id", getattr(node.func, "attr", ""))
            first = node.args[0]
            if SOLVERS.search(called):
                solved |= {p.id for p in ast.walk(first) if isinstance(p, ast.Name)}
                solved |= {p.attr for p in ast.walk(first) if isinstance(p, ast.Attribute)}
                if isinstance(first, ast.Name) and first.id == "self":
                    solved.add("__call__")
    return shown, solved


def _last(names: Mapping[str, Any], own: Sequence[str]) -> str:
    """The last function that no other one speaks of, as these are parts of it."""
    parts = {
        name
        for one in own
        if isinstance(names[one], FunctionType)
        for name in _spoken(names[one].__code__) - {one}
    }
    return next((n for n in reversed(own) if n not in parts and _takes(names[n])), own[-1])


def _spoken(code: CodeType) -> set[str]:
    """Names of others in a function, and in those that are defined in it."""
    inner = [_spoken(part) for part in code.co_consts if isinstance(part, CodeType)]
    return {*code.co_names}.union(*inner)


def _takes(thing: Any) -> bool:
    """Whether it has an argument; a function without one is a program."""
    return not isinstance(thing, FunctionType) or thing.__code__.co_argcount > 0


def _placeholders(kind: type, names: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers for what an object is made with, for which the scene's parameters are to stand.

    What is to be of a class of the file is one that is made so.
    """
    found: dict[str, Any] = {}
    for name, one in inspect.signature(kind).parameters.items():
        if one.kind is not one.POSITIONAL_OR_KEYWORD or one.default is not one.empty:
            continue
        inner = names.get(one.annotation, one.annotation)
        if isinstance(inner, type) and inner.__module__ == "submission" and inner is not kind:
            found[name] = inner(**_placeholders(inner, names))
        else:
            found[name] = _unsaid(name, len(found))
    return found


def _unsaid(name: str, count: int) -> Unsaid:
    found = Unsaid(1.5 + count * 0.37)
    found.name = name
    return found


def _methods(path: Path, names: dict[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """Methods of the last class, of an object that is made with numbers that nobody said."""
    classes = [v for v in names.values() if isinstance(v, type) and v.__module__ == "submission"]
    if not classes:
        return names, []
    own = [
        n for n, v in vars(classes[-1]).items()
        if isinstance(v, FunctionType) and (n[0] != "_" or n == "__call__")
    ]  # fmt: skip
    if not own:
        return names, []
    try:
        made = classes[-1](**_placeholders(classes[-1], names))
        with_unset(made, _unsaid)
    except Exception as error:  # so may what makes an object of a person's class
        words = f"{classes[-1].__name__}() ends in {type(error).__name__}: {error}"
        raise InputError(f"file {path}: {words}: have a function, or values for all") from None
    return {name: getattr(made, name) for name in own}, own
