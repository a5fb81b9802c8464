"""What a file of code says beside the functions that are judged, by its tree.

    function a = other(theta, l, g) ...     a function that is no part of a judged one
    theta_ddot = g/l*sin(theta);            a line that gives a moving quantity, or is made of such
    f = @(t, y) -rate(t, y);                a function without a name that is no plain call

Plots, what is printed, solvers and numbers of parameters say nothing of the motion.
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from typing import Any

from mechanics.claims.code import cpp_functions, julia, matlab
from mechanics.claims.code.python_page import named, safe, tree, within, words
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
PROGRAM = frozenset(("main", "setup", "loop"))
"""Functions that only use others."""
LONGEST = 60


def not_judged(text: str, suffix: str, judged: Collection[str], naming: Naming) -> tuple[str, ...]:
    """Functions and lines of a file that are neither judged nor a part of what is.

    Parameters
    ----------
    text : str
    suffix : str
        Of the file: ``.m``, ``.jl``, or one of C or C++.
    judged : collection of str
        Names of the functions that are.
    naming : Naming
        Tells what moves.
    """
    language, title = LANGUAGES.get(suffix, (cpp_functions.language, str))
    grammar = {".m": "tree-sitter-matlab", ".jl": "tree-sitter-julia"}.get(suffix)
    root = tree(language, text, grammar or "tree-sitter-cpp")
    functions = dict(_functions(root, suffix))
    parts = {name: {*_names(node, title)} & functions.keys() - {name}
             for name, node in functions.items()}  # fmt: skip
    own = _reached(judged, parts)
    users = {name for name in functions if _reached({name}, parts) & {*judged}}
    found = []
    for name, node in functions.items():
        if _only_shows(node):
            continue
        changed = name in users and name not in own and _joins(node, own, title)
        if changed or not (name in own or name in users or name in PROGRAM):
            found.append(f"function {name}")
    if suffix in LANGUAGES:
        inert = own | users
        for one in _lines(root, functions):
            if _says(one, inert, own, naming, title, judged):
                found.append(" ".join(words(one).split())[:LONGEST])
    return tuple(dict.fromkeys(found))


def _plain(text: str) -> str:
    letters, order = julia.plain(text.replace("!", ""))
    return safe(letters + julia.DOTS.get(order, "")) if letters.isidentifier() else text


LANGUAGES: dict[str, tuple[Callable[[], object], Callable[[str], str]]] = {
    ".m": (matlab.language, safe), ".jl": (julia.language, _plain),
}  # fmt: skip
"""Grammars of languages in which lines of a file are statements, and names as Python has them."""


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


def _reached(starts: Collection[str], parts: Mapping[str, Collection[str]]) -> set[str]:
    found, todo = {*starts}, [*starts]
    while todo:
        new = {*parts.get(todo.pop(), ())} - found
        found |= new
        todo += new
    return found


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


def _is_call(node: Any, functions: Collection[str], title: Callable[[str], str]) -> bool:
    """Whether it is a plain call of one of some functions, with nothing computed beside it."""
    return (
        node.type in CALLS
        and title(_called(node)) in functions
        and not any(within(part, *NAMELESS) for part in named(node))
    )


def _joins(node: Any, functions: Collection[str], title: Callable[[str], str]) -> bool:
    """Whether what a function returns is made into something else: -rate(t, y)."""
    calls = (one for one in within(node, *CALLS) if title(_called(one)) in functions)
    return any(one.parent is not None and one.parent.type in JOINED for one in calls)


def _says(
    line: Any, plain: Collection[str], own: Collection[str], naming: Naming,
    title: Callable[[str], str], judged: Collection[str],
) -> bool:  # fmt: skip
    """Whether a line outside of functions says something of the motion."""
    target, value = _target(line)
    if target is not None and _names(target, title) & {*judged}:
        return False  # the function without a name that is judged
    for one in within(line, *NAMELESS):
        body = named(one)[-1] if named(one) else one
        while body.type in ("parenthesized_expression", "parenthesis") and len(named(body)) == 1:
            (body,) = named(body)
        if not _is_call(body, plain, title):
            return True
    if line.type in CALLS and _called(line) in SHOWN:
        return bool(within(line, "assignment"))
    if _joins(line, own, title):
        return True
    if target is not None and any(_order(n, naming) == 2 for n in _names(target, title)):
        return not (value is not None and _is_call(value, plain, title))
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
