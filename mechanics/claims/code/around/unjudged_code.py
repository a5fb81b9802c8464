"""What a file of code says beside the functions that are judged, by its tree.

    function a = other(theta, l, g) ...     a function that is no part of a judged one
    theta_ddot = g/l*sin(theta);            a line that gives a moving quantity, or is made of such
    f = @(t, y) -rate(t, y);                a function without a name that is no plain call

Plots, what is printed, solvers and numbers of parameters say nothing of the motion.
"""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from mechanics.claims.assemble import Reading
from mechanics.claims.code.around.call_sites import (
    changed_numbers,
    concerns,
    function_lines,
    lines_of,
    misuses,
)
from mechanics.claims.code.around.cpp_objects import objects
from mechanics.claims.code.around.intermediate_form import Term, term, with_names
from mechanics.claims.code.around.interpreter_values import (
    FileFunction,
    JudgedFunction,
    Language,
    names_of,
    root_of,
)
from mechanics.claims.code.around.references import without_references
from mechanics.claims.code.around.run import Run
from mechanics.claims.code.around.state_changes import changes_elsewhere, state_changes
from mechanics.claims.code.reachability import reachable
from mechanics.claims.code.translation import cpp_functions, julia, matlab
from mechanics.claims.code.translation.manipulator_parts import parts_of
from mechanics.claims.code.translation.python_page import named, safe, within, words
from mechanics.claims.names import Naming
from mechanics.errors import InputError
from mechanics.scene.symbols import plain_symbol

SHOWN = matlab.SHOWN | julia.SHOWN | frozenset(
    ("plot", "plot3", "plot!", "subplot", "title", "title!", "xlabel", "xlabel!", "ylabel",
     "ylabel!", "zlabel", "legend", "axis", "grid", "line", "scatter", "scatter!", "comet",
     "savefig", "saveas", "print", "display", "sprintf", "xlim", "ylim", "xlims!", "ylims!",
     "lines", "lines!", "set", "exportgraphics", "pause", "surf", "contour", "quiver", "annotate!",
     "printf", "@printf", "@show", "@info", "@assert", "@test")
)  # fmt: skip
"""Calls that show something."""
CALLS = ("function_call", "call_expression", "broadcast_call_expression", "command",
         "macrocall_expression")  # fmt: skip
JOINED = ("binary_operator", "binary_expression", "comparison_operator", "juxtaposition_expression",
          "unary_operator", "unary_expression", "postfix_operator",
          "compound_assignment_expression")  # fmt: skip
"""Where values are made into others."""
NAMELESS = ("lambda", "arrow_function_expression", "lambda_expression")
SENDS = frozenset(
    ("push", "append", "push_back", "emplace_back", "fputs", "puts", "fwrite", "fflush", "fopen",
     "fclose", "write", "begin", "delay", "millis", "micros", "println", "size", "length", "numel")
)  # fmt: skip
"""Calls that change nothing of what they take."""
PROGRAM = frozenset(("main", "setup", "loop"))
"""Functions that only use others."""
LONGEST = 200
SETS = re.compile(r"\+\+|--|(?<![=<>!])=(?!=)|(?:<<|>>)=")
"""Of C."""
ROWS: dict[str, Language] = {
    ".m": Language("MATLAB", 1, brackets=True, shows=SHOWN | SENDS),
    ".jl": Language("Julia", 1, shows=SHOWN | SENDS),
    ".cpp": Language("C", pointers=True, integers=True, shows=SHOWN | SENDS),
}
"""Languages by the suffixes of their files."""


def unjudged_code(
    text: str, suffix: str, found: Reading, naming: Naming, *, chosen: bool = False
) -> tuple[str, ...]:
    """Functions and lines of a file that are neither judged nor a part of what is.

    Parameters
    ----------
    text : str
    suffix : str
        Of the file: ``.m``, ``.jl``, or one of C or C++.
    found : Reading
        Of the functions that are judged.
    naming : Naming
        Tells what moves.
    chosen : bool
        Whether somebody said which function is meant: others that do not use it are left alone.
    """
    judged = {s.source.partition(":")[0] for s in found.statements}
    _, title = LANGUAGES.get(suffix, (cpp_functions.parsed, str))
    root = _root(text, suffix)
    functions = dict(_functions(root, suffix))
    every = {**dict(_idle(root, suffix)), **functions}
    parts = {name: {*_names(node, title)} & every.keys() - {name} for name, node in every.items()}
    own = reachable({n for one in judged for n in parts_of(one, every)}, parts)
    users = {name for name in every if reachable({name}, parts) & {*judged}} - own
    lines = [*_lines(root, every)]
    others = {n: _own(node, suffix, title) for n, node in every.items()}
    seen = _seen(judged, found, others, lines, naming, title)
    if (node := every.get(seen.name)) is not None:
        seen = replace(seen, single="double" not in words(node))
    names = names_of(naming)
    around = (others, users, names, ROWS.get(suffix, ROWS[".cpp"]))
    terms = [with_names(term(node), title) for node in lines]
    uses = Run({seen.name: seen}, *around, Term("block", "", tuple(terms)))
    said: list[str] = []
    if suffix not in LANGUAGES:
        made = objects(root, seen, names.meaning)
        said += (
            call.text for kind, call in made if misuses(Run({kind.name: kind}, *around), call, {})
        )
    known: dict[str, Any] = {}
    for node, line in zip(lines, terms, strict=True):
        concerned = suffix in LANGUAGES and concerns(uses, line, known)
        quoted = lines_of(uses, line, known)
        if suffix not in LANGUAGES:
            continue
        if not (quoted or concerned or chosen) and _says(node, own, users, naming, title, judged):
            quoted = [line.text]
        said += quoted
    said += _macros(root, judged)
    free = {n for name in own & others.keys() for n in others[name].free()}
    during = _called_by_solvers(terms, others)
    for name in (n for n in every if n not in own and suffix != ".jl"):
        shared = free if suffix not in LANGUAGES else free & _global(every[name], title)
        numbers = changed_numbers(uses, others[name], shared, during=name in during)
        said += (f"{name}: {line}" for line in numbers)
    for name in (n for n in every if n in users | uses.memory.explained - own):
        said += (f"{name}: {line}" for line in function_lines(uses, others[name], known))
        said += (f"{name}: {line}" for line in state_changes(
            uses, others[name].body, name not in ("main", "setup")
        ))  # fmt: skip
    if suffix in LANGUAGES:
        said += state_changes(uses, uses.block)
    else:
        apart = every.keys() - own - users - uses.memory.explained - PROGRAM
        said += changes_elsewhere(uses, users, sorted(apart))
    for name, node in functions.items():
        other = not (chosen or name in own | users | PROGRAM | uses.memory.explained)
        if other and not _only_shows(node):
            said.insert(0, f"function {name}")
    return tuple(dict.fromkeys(one[:LONGEST] for one in said))


def _global(node: Any, title: Callable[[str], str]) -> set[str]:
    """Names of MATLAB that a function shares with others."""
    return {name for one in within(node, "global_operator") for name in _names(one, title)}


def _called_by_solvers(lines: Iterable[Term], others: Mapping[str, FileFunction]) -> set[str]:
    """Functions that options of MATLAB's solvers name: odeset('OutputFcn', @show)."""
    bodies = (*lines, *(one.body for one in others.values()))
    options = (t for body in bodies for t in body.all() if t.kind == "call" and t.name == "odeset")
    return {name for one in options for name in one.names()} & others.keys()


def spans_of_functions(text: str, suffix: str) -> dict[str, tuple[int, int]]:
    """First and last lines of the functions of a file, by their names.

    Parameters
    ----------
    text : str
    suffix : str
        As of `unjudged_code`.
    """
    root = _root(text, suffix)
    nodes = {**dict(_idle(root, suffix)), **dict(_functions(root, suffix))}
    return {name: (n.start_point[0] + 1, n.end_point[0] + 1) for name, n in nodes.items()}


def _root(text: str, suffix: str) -> Any:
    parsed, _ = LANGUAGES.get(suffix, (cpp_functions.parsed, str))
    return parsed(text)


def _macros(root: Any, judged: Collection[str]) -> list[str]:
    """Macros of C that are made of judged functions, or that set something."""
    values = [
        (node, node.child_by_field_name("value"))
        for node in within(root, "preproc_function_def", "preproc_def")
    ]
    return [
        words(node)
        for node, value in values
        if value is not None
        and ({*judged} & {*re.findall(r"\w+", words(value))} or SETS.search(words(value)))
    ]


def _plain(text: str) -> str:
    letters, order = julia.plain(text.replace("!", ""))
    return safe(letters + julia.DOTS.get(order, "")) if letters.isidentifier() else text


LANGUAGES: dict[str, tuple[Callable[[str], Any], Callable[[str], str]]] = {
    ".m": (matlab.parsed, safe), ".jl": (julia.parsed, _plain),
}  # fmt: skip
"""Trees of languages in which lines of a file are statements, and names as Python has them."""


def _functions(root: Any, suffix: str) -> Iterator[tuple[str, Any]]:
    """Functions of a file that give something, by their names."""
    if suffix == ".jl":
        for one in julia.functions_of(root):
            if one.takes or named(named(one.call)[1]):
                yield julia.name_of(named(one.call)[0]), one.node
    elif suffix == ".m":
        for node in within(root, "function_definition"):
            if matlab.outputs_of(node):
                yield safe(words(node.child_by_field_name("name"))), node
    else:
        yield from cpp_functions.functions_of(root)[0].items()


def _idle(root: Any, suffix: str) -> Iterator[tuple[str, Any]]:
    """Functions of a file that only use others: they take or give nothing."""
    if suffix == ".jl":
        yield from ((julia.name_of(named(f.call)[0]), f.node) for f in julia.functions_of(root))
    elif suffix == ".m":
        for node in within(root, "function_definition"):
            yield safe(words(node.child_by_field_name("name"))), node


def _own(node: Any, suffix: str, title: Callable[[str], str]) -> FileFunction:
    """A function, as its callers see it."""
    gives: tuple[str, ...] = ()
    shared: set[str] = set()
    if suffix == ".m":
        takes, gives = matlab.arguments_of(node), tuple(matlab.outputs_of(node))
        body = [c for c in node.children if c.type == "block"]
    elif suffix == ".jl":
        (one,) = (f for f in julia.functions_of(node) if f.node == node)
        given = (within(part, "identifier")[:1] for part in named(named(one.call)[1]))
        takes = [words(name) for names in given for name in names]
        body = [c for part in one.body for c in (named(part) if part.type == "block" else [part])]
    else:
        takes = cpp_functions.arguments_of(node)
        shared = cpp_functions.shared_of(node)
        body = [node.child_by_field_name("body")]
    made = Term("block", "", (*_converted(node, suffix), *(term(part) for part in body)))
    if suffix == ".jl" and made.parts:
        last = made.parts[-1]
        value = last.parts[0] if last.kind == "set" else last
        if last.kind not in ("loop", "case", "return", "block"):
            before = made.parts if last.kind == "set" else made.parts[:-1]
            made = replace(made, parts=(*before, Term("return", "", (value,), last.text)))
        entries = [t.parts[0] for t in made.all() if t.kind == "set" and t.parts[0].kind == "entry"]
        shared = {words(i) for i in within(node, "identifier")} & {t.parts[0].name for t in entries}
        shared |= {*takes[:1]} if words(named(one.call)[0]).endswith("!") else set()
    made = without_references(made)
    own = FileFunction(tuple(map(title, takes)), gives, with_names(made, title))
    return replace(own, shared=frozenset(map(title, shared & {*takes})))


def _converted(node: Any, suffix: str) -> Iterator[Term]:
    """Arguments of MATLAB that a function makes into another class, as assignments."""
    for one, kind in matlab.conversions_of(node) if suffix == ".m" else ():
        name = Term("name", words(named(one)[0]))
        yield Term("set", "", (name, Term("call", kind, (name,))), words(one))


def _seen(
    judged: Collection[str], found: Reading, functions: Mapping[str, FileFunction],
    lines: Iterable[Any], naming: Naming, title: Callable[[str], str],
) -> JudgedFunction:  # fmt: skip
    """The judged function, as its callers see it."""
    name = next(iter(judged), "")
    takes: tuple[str, ...] = ()
    fills: Collection[str] = ()
    if name in functions:
        takes, fills = functions[name].takes, functions[name].shared
    for line in (with_names(term(one), title) for one in lines if name not in functions):
        if line.kind == "set" and line.parts[0].name == name and line.parts[1].kind == "handle":
            takes = tuple(line.parts[1].name.split())
    meanings = {m.name: tuple(m.meaning.split()) for m in found.names if m.name in takes}
    moments = [n for n, words in meanings.items() if words == ("t",)]  # the time
    meanings = {n: words for n, words in meanings.items() if n not in moments}
    scene = naming.vocabulary.scene
    rates = dict(zip(map(str, scene.u), map(str, scene.q), strict=False))
    rates |= dict(zip(map(str, scene.ud), map(str, scene.u), strict=True))
    tags = [s.tag for s in found.statements]
    gives = tuple(rates[t] for t in tags) if all(t in rates for t in tags) else ()
    filled = tuple(
        n for n in takes if n in fills and n not in meanings and _is_set(functions[name], n)
    )
    single = {m.name: m.meaning for m in found.names if m.name not in takes}
    around = {n: m for n, m in single.items() if " " not in m and name in functions}
    used = functions[name].body.names() if name in functions else ()
    time = next((n for n in moments if n in used), "")
    places = _by_place(functions[name]) if name in functions else frozenset()
    return JudgedFunction(name, takes, meanings, filled, gives, around, time=time, places=places)


def _by_place(function: FileFunction) -> frozenset[str]:
    """Arguments of which a function takes entries by their places: m, c = p; p[1]."""
    lines = [*function.body.all()]
    by_name = {one for t in lines if t.text.startswith("@unpack") for one in t.all()}
    unpacked = {t.parts[1].name for t in lines if t.kind == "set" and t.parts[0].kind == "list"
                and t not in by_name and not t.parts[0].text.startswith("(;")}  # fmt: skip
    entries = {root_of(t) for t in lines if t.kind == "entry" and t.parts[1].kind == "number"}
    return frozenset((unpacked | entries) & {*function.takes})


def _is_set(function: FileFunction, name: str) -> bool:
    return name in function.fills or any(
        one.kind == "call" and any(part.name == name for part in one.parts)
        for one in function.body.all()
    )  # fmt: skip


def _names(node: Any, title: Callable[[str], str]) -> set[str]:
    return {title(words(one)) for one in within(node, "identifier", "field_identifier")}


def _lines(root: Any, functions: Mapping[str, Any]) -> Iterator[Any]:
    """Statements outside of functions."""
    whole = {node.id for node in functions.values()}
    for one in named(root):
        if one.type == "module_definition":
            yield from _lines(one, functions)
        elif one.id in whole or "comment" in one.type or one.type in (
            "function_definition", "string_literal", "struct_definition", "import_statement",
            "using_statement", "export_statement",
        ):  # fmt: skip
            continue
        elif not any(inner.id in whole for inner in within(one, "function_definition")):
            yield one


def _called(node: Any) -> str:
    """The name of what a call calls."""
    parts = named(node)
    return words(parts[0]).strip() if parts else ""


def _only_shows(node: Any) -> bool:
    """Whether a function computes nothing: all that it has is shown."""
    if within(node, *JOINED, *NAMELESS, "assignment"):
        return False
    shown = {one.id for call in within(node, *CALLS) if _called(call) in SHOWN
             for one in within(call, *CALLS)}  # fmt: skip
    head = within(node, "signature")
    inside = {one.id for part in head for one in within(part, *CALLS)}
    return bool(shown) and all(one.id in shown | inside for one in within(node, *CALLS))


def _says(
    line: Any, own: Collection[str], users: Collection[str], naming: Naming,
    title: Callable[[str], str], judged: Collection[str],
) -> bool:  # fmt: skip
    """Whether a line outside of functions that does not use the judged one speaks of the motion."""
    target, _ = _target(line)
    if target is not None and _names(target, title) & {*judged}:
        return False  # the function without a name that is judged
    if within(line, *NAMELESS):
        return True
    if line.type in CALLS and _called(line) in SHOWN:
        return bool(within(line, "assignment"))
    if target is not None and any(_order(n, naming) == 2 for n in _names(target, title)):
        return True
    return any(
        _order(name, naming) is not None
        for one in within(line, *JOINED)
        for name in _names(one, title)
    )


def _target(line: Any) -> tuple[Any, Any]:
    """What a line assigns, and the value."""
    if line.type != "assignment":
        return None, None
    left, *_, right = named(line)
    return left, right


def _order(name: str, naming: Naming) -> int | None:
    """Which derivative of a coordinate a name is; None for what is neither that nor a speed."""
    try:
        found = naming.lookup(name)
    except (InputError, KeyError):
        return None
    scene = naming.vocabulary.scene
    inputs, speeds = (
        {plain_symbol(f).name for f in some}
        for some in (scene.inputs, [u for u, _ in scene.speeds])
    )
    if found is None or found[0] not in naming.vocabulary.functions or found[0] in inputs:
        return None
    return found[1] + (found[0] in speeds)
