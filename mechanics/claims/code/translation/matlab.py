"""MATLAB's and Octave's functions as Python: their trees, printed line by line.

    function dx = f(t, x, p)            def f(t, x, p):
    m = p.m;                                m = p.m
    dx = [x(2); -p.k/m*x(1)];               dx = block((x[1],), (...,)); return dx

Numbers that are assigned once are constants of the file: `m = 0.5;` stands for the scene's m.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from mechanics.claims.code import array_language
from mechanics.claims.code.translation.matlab_casadi import as_it_makes
from mechanics.claims.code.translation.python_page import (
    Page,
    Unread,
    first_error,
    joined,
    line_of,
    named,
    refuse,
    refuse_absent,
    refuse_call,
    safe,
    tree,
    within,
    words,
)

ELEMENTWISE = {
    **{name: name for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "sqrt", "exp", "log",
                               "floor", "ceil", "sign")},
    "abs": "abs", "asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2",
    "hypot": "hypot", "max": "maximum", "min": "minimum", "mod": "mod",
}  # fmt: skip
"""Functions and what NumPy calls them."""
RECIPROCAL = {"sec": "cos", "csc": "sin", "cot": "tan"}
WHOLES = {"inv": "inverse", "pinv": "inverse", "det": "determinant", "transpose": "transposed"}
"""Functions of matrices as a whole."""
ARRAYS = ("zeros", "ones", "eye", "diag", "sum", "dot", "cross", "norm")
LISTED = re.compile(
    r"\[[\w\s,~]*\]\s*=\s*(?:deal\(\s*)?\w+\{:\}(?:\s*\))?"
    r"|(?P<name>\w+)\s*=\s*sym\(\s*(['\"])(?P=name)\2(?:\s*,\s*['\"]\w+['\"])*\s*\)"
)
TRUTHS = ("comparison_operator", "boolean_operator", "not_operator", "boolean", "parenthesis")
"""What is true or false by itself."""
CONSTANTS = {"pi": "np.pi", "true": "True", "false": "False"}
OPERATIONS = {
    "+": "plus", "-": "minus", "*": "times", ".*": "each_times", "./": "each_over",
}  # fmt: skip
COMPARED = {"==": "==", "~=": "!=", "!=": "!=", "<": "<", ">": ">", "<=": "<=", ">=": ">="}
BOTH = {"&&": "and", "||": "or", "&": "and", "|": "or"}
SHOWN = frozenset(
    {"disp", "fprintf", "printf", "clc", "clear", "close", "format", "hold", "figure", "plot",
     "syms", "error", "warning", "assert", "tic", "toc", "drawnow"}
)  # fmt: skip
"""Commands that change no number."""
SETS = ("=", "+=", "-=", "*=", "/=", "^=", "++", "--")
"""What Octave sets inside of what is shown, disp(x = 2)."""
SOLVERS = ("ode", "lsode", "integral")
DECIMAL = re.compile(r"(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
OCTAVE = re.compile(r"\bend(?:function|if|for|switch|while)\b")
"""How Octave ends a block."""


@dataclass
class Scope:
    """What one function knows.

    Attributes
    ----------
    arguments, locals, constants : set of str
    functions : dict of str to int
        Those of the file, and how many outputs each has.
    outputs : list of str
    main : bool
        Whether it is the function that is judged: it is called with all of its arguments.
    free : dict of str to str
        Names that nothing gives a value, and what they are fields of.
    flags : set of str
        Arguments that are asked whether they are true.
    handles : frozenset of str
        Its names of anonymous functions, which are nothing else.
    anew : frozenset of str
        Names that it gives a value which is no field of that name.
    """

    arguments: list[str]
    locals: set[str]
    functions: dict[str, int]
    constants: dict[str, str]
    outputs: list[str]
    scalar: Callable[[str], bool]
    main: bool = True
    free: dict[str, str | None] = field(default_factory=dict)
    flags: set[str] = field(default_factory=set)
    handles: frozenset[str] = frozenset()
    anew: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Translated:
    """Functions of a file, as Python.

    Attributes
    ----------
    functions : tuple of callable
        Those that no other one calls, in their order.
    remarks : tuple of str
    elsewhere : tuple of str
        Names that nothing here gives a value, where a file that is not here may.
    assumed : tuple of str
        What has to be so for it to be right, where the file is cut.
    """

    functions: tuple[Callable[..., Any], ...]
    remarks: tuple[str, ...]
    elsewhere: tuple[str, ...] = ()
    assumed: tuple[str, ...] = ()


def parsed(text: str) -> Any:
    """The tree of a file.

    Parameters
    ----------
    text : str
    """
    return tree(language, text, "tree-sitter-matlab")


def in_python(
    text: str, origin: str, known: Callable[[str], bool], chosen: str | None = None
) -> Translated:
    """The functions of a file of MATLAB: those that are solved, or that no other one calls.

    Parameters
    ----------
    text, origin : str
    known : callable
        Whether a name is one of the scene.
    chosen : str, optional
        The one that is asked for.

    Raises
    ------
    Unread
        For what is not read, by line and column.
    """
    text = as_it_makes(OCTAVE.sub(lambda m: "end".ljust(len(m[0])), text))
    root = parsed(text)
    _refuse_comments(root, text)
    nodes = {safe(words(_name(node))): node for node in within(root, "function_definition")}
    if not nodes and chosen is None:
        return _solved_handle(root, origin, known)
    if chosen is not None:
        refuse_absent(chosen, nodes)
    calls = {name: _calls(node, nodes) for name, node in nodes.items()}
    solved = {n for name, node in nodes.items() if _solves(node) for n in calls[name]}
    around = {n: _around(node) for n, node in nodes.items()}
    returning = {n: calls[n] for n, node in nodes.items() if outputs_of(node)} or calls
    tops = [safe(chosen)] if chosen else [n for n in nodes if n in solved] or _uncalled(returning)
    wanted = list(tops)
    for name in wanted:
        wanted += [other for other in calls[name] if other not in wanted]
    for wrong in map(first_error, (nodes[name] for name in wanted)):
        if wrong is not None:
            raise refuse(wrong)
    _refuse_shared({name: nodes[name] for name in wanted})
    page = Page()
    flags: dict[str, None] = {}
    counts = {name: len(outputs_of(node)) for name, node in nodes.items()}
    scopes = {name: _scope(nodes[name], counts, known) for name in wanted}
    bodies = [(name, node) for name, node in nodes.items() if name in wanted]
    for name, node in bodies:
        caller = next((n for n in nodes if name in solved and name in calls[n]), "")
        before = _before(around[name] or nodes.get(caller), node, scopes[name], known)
        _function(page, node, scopes[name], tops, before)
        flags |= dict.fromkeys(scopes[name].flags)
    page.constants({name: scopes[name].constants for name, _ in bodies})
    space = page.module(origin, _arrays())
    remarks = tuple(f"{name} is read as true" for name in flags)
    own = ((n, outputs_of(nodes[n]), scopes[n].outputs) for n in tops)
    assumed = tuple(
        f"{n} returns {joined(last)}, which it computes last, and not {joined(wanted)}, which"
        " it does not set" for n, wanted, last in own if wanted != last
    )  # fmt: skip
    runs = any(words(_name(one)) == "run" for one in within(root, "function_call"))
    free = (
        dict.fromkeys(n for name, _ in bodies for n, of in scopes[name].free.items() if not of)
        if runs
        else ()
    )
    return Translated(tuple(space[name] for name in tops), remarks, tuple(free), assumed)


def _refuse_shared(nodes: dict[str, Any]) -> None:
    """Refuse what is global and set by one of several functions.

    Raises
    ------
    Unread
    """
    shared = [
        (name, safe(words(i)))
        for name, node in nodes.items()
        for one in within(node, "global_operator")
        for i in within(one, "identifier")
    ]
    for name, node in nodes.items():
        for target, _ in _targets(node):
            if any(other != name and own == _base(target) for other, own in shared):
                raise refuse(target, f"{_base(target)} is global, and set here: pass it")


def _refuse_comments(root: Any, text: str) -> None:
    """Refuse comments of several lines that begin behind something: MATLAB ends them there.

    Raises
    ------
    Unread
    """
    lines = text.splitlines()
    for one in within(root, "comment"):
        several = one.start_point[0] != one.end_point[0] and words(one)[1:2] == "{"
        if several and lines[one.start_point[0]].strip() not in ("%{", "#{"):
            raise refuse(one, "a comment of several lines begins in a line of its own")


def _solved_handle(root: Any, origin: str, known: Callable[[str], bool]) -> Translated:
    """The handle that a script has solved: ``f = @(t, y) [...]; ode45(f, ...)``.

    What it uses is what the script assigns once.
    """
    table: dict[str, list[Any]] = {}
    for one in within(root, "assignment"):
        left, right = (one.child_by_field_name(f) for f in ("left", "right"))
        for part in named(left) if left.type == "multioutput_variable" else [left]:
            plain = part == left and one.parent == root
            table.setdefault(_base(part), []).append(right if plain else None)
    calls = [c for c in within(root, "function_call") if words(_name(c)).startswith(SOLVERS)]
    first = [named(a)[0] for c in calls for a in c.children if a.type == "arguments" and named(a)]
    handles = {
        safe(words(f)): table[safe(words(f))] for f in first
        if f.type == "identifier" and safe(words(f)) in table
    }  # fmt: skip
    if len(handles) != 1:
        raise Unread("there is no function in it, and no handle that is solved")
    ((name, values),) = handles.items()
    if len(values) != 1 or values[0] is None or values[0].type != "lambda":
        raise Unread(f"nothing says plainly what {name} is")
    node = values[0]
    if (wrong := first_error(node)) is not None:
        raise refuse(wrong)
    given = next((c for c in node.children if c.type == "arguments"), None)
    arguments = [safe(words(one)) for one in within(given, "identifier")] if given else []
    scope = Scope(arguments, set(), {}, {}, [], known)
    value = expression(node.child_by_field_name("expression"), scope)
    before: list[str] = []
    todo, done = list(scope.free), set(arguments)
    while todo:
        one = todo.pop()
        if one in done or one not in table:
            continue
        done.add(one)
        if len(table[one]) > 1 or table[one][0] is None:
            raise Unread(f"{one} is assigned twice, or beside others: leave one")
        scope.free.pop(one, None)
        (right,) = table[one]
        if right.type == "number":
            scope.constants[one] = _number(right)
        else:
            before.insert(0, f"{one} = {expression(right, scope)}")
        todo += list(scope.free)
    used = [a for a in arguments if re.search(rf"\b{a}\b", value)]
    page = Page()
    extra = [n for n in scope.free if n not in used]
    page.put(line_of(node), 0, f"def {name}({joined([*used, *extra])}):", opens=True)
    for text in before:
        page.lines.append(f"    {text}")
    page.put(line_of(node) + 1, 1, f"return vector({value})")
    page.constants({name: scope.constants})
    return Translated((page.module(origin, _arrays())[name],), ())


def _arrays() -> dict[str, Any]:
    """What MATLAB's arrays can, by name."""
    return {name: value for name, value in vars(array_language).items()
            if callable(value) or name == "ALL"}  # fmt: skip


def language() -> object:
    """The grammar of MATLAB."""
    import tree_sitter_matlab

    return tree_sitter_matlab.language()


def _name(function: Any) -> Any:
    return function.child_by_field_name("name")


def _around(node: Any) -> Any:
    """The function inside of which a node stands; None for one of the file."""
    outer = node.parent
    while outer is not None and outer.type != "function_definition":
        outer = outer.parent
    return outer


def _before(caller: Any, node: Any, scope: Scope, known: Callable[[str], bool]) -> list[Any]:
    """What the function that has another one solved, or is around it, computes for it."""
    if caller is None:
        return []
    outer = _scope(caller, scope.functions, known)
    table = {
        _base(t): t.parent for t, _ in _targets(caller)
        if t.type == "identifier" and t.parent.type == "assignment"
    }  # fmt: skip
    found: dict[str, Any] = {}
    todo = [a for a in scope.arguments if a in table and _is_passed(caller, node, a)]
    if caller == _around(node):
        used = {safe(words(one)) for one in within(node, "identifier")} - scope.locals
        todo = [name for name in table if name in used - {*scope.arguments}]
    while todo:
        name = todo.pop()
        if name in found or name in outer.constants:
            continue
        found[name] = table[name]
        todo += [n for one in within(table[name], "identifier") if (n := safe(words(one))) in table]
    names = [_base(target) for target, _ in _targets(caller)]
    whole = {one.id for block in caller.children if block.type == "block" for one in named(block)}
    uses = [call.start_byte for call in within(caller, "function_call", "handle_operator", "lambda")
            if words(_name(node)) in words(call)]  # fmt: skip
    for name, line in found.items():
        late = uses and line.start_byte > min(uses)
        if names.count(name) > 1 or line.id not in whole or (late and caller != _around(node)):
            raise refuse(line, f"{name} is set under a condition, or several times: pass its value")
        inner = {safe(words(i)) for i in within(line, "identifier")} - {name}
        if again := [n for n in inner if names.count(n) > 1]:
            raise refuse(line, f"{again[0]} is set several times: leave one")
    numbers = outer.constants
    if caller != _around(node):
        inside = {safe(words(i)) for one in found.values() for i in within(one, "identifier")}
        own = {safe(words(i)) for i in within(node, "identifier")} - {*scope.arguments}
        if twice := sorted(inside & own & {*numbers, *found} - scope.locals):
            raise refuse(node, f"{twice[0]} is a variable of the caller, too: pass it")
        handed = {a for a in scope.arguments if a in numbers and _is_passed(caller, node, a)}
        numbers = {name: value for name, value in numbers.items() if name in inside | handed}
    scope.constants |= numbers
    scope.locals |= found.keys()
    return sorted(found.values(), key=lambda one: int(one.start_byte))


def _is_passed(caller: Any, function: Any, argument: str) -> bool:
    """Whether a function hands its own variable of this name to another one, wherever it does.

    A solver does so with what stands behind its options: ode45(@rate, span, x0, [], m).
    """
    place, name = arguments_of(function).index(argument), words(_name(function))
    given = []
    for call in within(caller, "function_call"):
        parts = [p for c in call.children if c.type == "arguments" for p in named(c)]
        if words(_name(call)) == name:
            given.append(parts)
        elif parts and words(parts[0]) == f"@{name}":
            given.append([*parts[:1], *parts[:1], *parts[4:]])
    return bool(given) and all(
        len(parts) > place and safe(words(parts[place])) == argument for parts in given
    )


def _calls(node: Any, functions: dict[str, Any]) -> list[str]:
    own = safe(words(_name(node)))
    names = (safe(words(one)) for one in within(node, "identifier"))
    return list(dict.fromkeys(name for name in names if name in functions and name != own))


def _solves(node: Any) -> bool:
    """Whether it only has other functions solved."""
    called = (words(_name(one)) for one in within(node, "function_call"))
    return any(name.startswith(SOLVERS) for name in called)


def _uncalled(calls: dict[str, list[str]]) -> list[str]:
    found = [n for n in calls if not any(n in others for others in calls.values())]
    return found or list(calls)[:1]


def outputs_of(node: Any) -> list[str]:
    """Names of what a function returns."""
    found = next((c for c in node.children if c.type == "function_output"), None)
    return [safe(words(one)) for one in within(found, "identifier")] if found else []


def arguments_of(node: Any) -> list[str]:
    """Names of what a function takes."""
    found = next((c for c in node.children if c.type == "function_arguments"), None)
    return [safe(words(one)) for one in within(found, "identifier")] if found else []


def conversions_of(node: Any) -> Iterator[tuple[Any, str]]:
    """What the ``arguments`` of a function, or the properties of its class, make no double."""
    blocks = [c for c in node.children if c.type == "arguments_statement"]
    around = node.parent
    while around is not None:
        blocks += [c for c in around.children if c.type == "properties"]
        around = around.parent
    for one in (part for block in blocks for part in within(block, "property")):
        kinds = [words(c) for c in named(one)[1:] if c.type in ("identifier", "property_name")]
        if kinds and kinds[-1] not in ("double", "sym"):
            yield one, kinds[-1]


def _targets(node: Any) -> Iterator[tuple[Any, Any]]:
    """What is assigned in a function, and its value."""
    for one in within(node, "assignment"):
        left = one.child_by_field_name("left")
        if _around(one) != node or _is_list(one):
            continue
        parts = named(left) if left.type == "multioutput_variable" else [left]
        for part in parts:
            yield part, one.child_by_field_name("right")


def _is_list(node: Any) -> bool:
    """[m, g] = p{:} and m = sym('m'), which say nothing but that m is a name."""
    return LISTED.fullmatch(words(node)) is not None


def _base(target: Any) -> str:
    first = target
    while first.type in ("function_call", "field_expression"):
        first = first.child_by_field_name("name") or first.child_by_field_name("object")
    return safe(words(first))


def _scope(node: Any, functions: dict[str, int], known: Callable[[str], bool]) -> Scope:
    arguments, outputs = arguments_of(node), outputs_of(node)
    targets = list(_targets(node))
    names = [_base(target) for target, _ in targets]
    outputs = _last_computed(node, targets) if not {*outputs} & {*names, *arguments} else outputs
    counted = {safe(words(i)) for loop in within(node, "iterator") for i in named(loop)[:1]}
    constants = {
        _base(target): _number(value)
        for target, value in targets
        if value.type == "number" and target.type == "identifier"
        and _uses(node, target) == _uses(target.parent.parent, target)  # under its condition
        and names.count(_base(target)) == 1 and _base(target) not in (*arguments, *outputs)
    }  # fmt: skip
    inside = {*names, *counted} - {*constants}
    kinds: dict[str, set[str]] = {}
    for target, value in targets:
        kinds.setdefault(_base(target), set()).add(value.type)
    handles = {n for n, kind in kinds.items() if kind == {"lambda"}} - {*arguments, *outputs}
    anew = {
        _base(target) for target, value in targets
        if value.type != "field_expression" or words(value).rpartition(".")[2] != words(target)
    }  # fmt: skip
    return Scope(
        arguments, inside, functions, constants, outputs, known, handles=frozenset(handles),
        anew=frozenset(anew),
    )  # fmt: skip


def _last_computed(node: Any, targets: Sequence[tuple[Any, Any]]) -> list[str]:
    """What a function computes last and uses nowhere, which one that is cut would return."""
    last = targets[-1][0] if targets else None
    if last is None or last.type != "identifier" or _uses(node, last) > 1:
        return outputs_of(node)
    return [safe(words(last))] if len(outputs_of(node)) == 1 else outputs_of(node)


def _uses(block: Any, target: Any) -> int:
    """How often a block has the name that is assigned."""
    return sum(words(one) == words(target) for one in within(block, "identifier"))


def _function(page: Page, node: Any, scope: Scope, chosen: list[str], before: list[Any]) -> None:
    name = safe(words(_name(node)))
    for one, kind in conversions_of(node):
        raise refuse(one, f"the class {kind} changes what is given: write double")
    main = name in chosen
    body = Page()
    for one in before:
        _statement(body, one, 1, scope)
    blocks = [c for c in node.children if c.type == "block"]
    for one in blocks:
        _statements(body, one, 1, replace_scope(scope, main))
    passed = {_base(one.child_by_field_name("left")) for one in before}
    arguments = [a for a in scope.arguments if not main or a not in {*scope.flags, *passed}]
    if main:
        arguments = [a for a in arguments if words_used(a, node)]
    extra = [n for n in scope.free if n not in arguments]
    if not main and extra:
        raise refuse(node, f"{', '.join(extra)} of {name}: nothing gives it a value")
    if not scope.outputs:
        raise refuse(node, f"{name} returns nothing")
    start = line_of(before[0]) - 1 if before else line_of(node)
    page.put(start, 0, f"def {name}({joined([*arguments, *extra])}):", opens=True)
    filled = (_base(t) for t, _ in _targets(node) if t.type == "function_call")
    empty = [n for n in dict.fromkeys(filled) if n not in arguments]
    for one in empty:
        page.put(line_of(node), 1, f"{one} = None")
    page.compound = False
    for number, text in enumerate(body.lines, start=1):
        if text.strip():
            depth = (len(text) - len(text.lstrip())) // 4
            page.put(number, depth, text.strip(), opens=text.rstrip().endswith(":"))
    page.compound = True
    _set_once(node, scope)
    outputs = [f"{o} = vector({o})" for o in scope.outputs] if main else []
    returned = "; ".join([*outputs, f"return {joined(scope.outputs)}"])
    page.put(len(page.lines), 1, returned)
    page.compound = True


def _set_once(node: Any, scope: Scope) -> None:
    """Refuse an entry of what is returned that is set twice in one block, the first time in vain.

    Raises
    ------
    Unread
    """
    done: set[tuple[int, str]] = set()
    for target, value in _targets(node):
        name = _base(target)
        if target.type != "function_call" or name not in scope.outputs:
            continue
        key = (target.parent.parent.id, "".join(words(target).split()))
        if key in done and not _uses_name(value, name):
            raise refuse(target, f"{key[1]} is set twice: leave one")
        done.add(key)


def _uses_name(node: Any, name: str) -> bool:
    return any(safe(words(one)) == name for one in (node, *within(node, "identifier")))


def words_used(argument: str, node: Any) -> bool:
    """Whether a function uses an argument, and not its fields alone."""
    uses = [one for one in within(node, "identifier") if safe(words(one)) == argument]
    whole = [one for one in uses if "{:}" not in words(one.parent)]
    return sum(one.parent.child_by_field_name("object") != one for one in whole) > 1


def replace_scope(scope: Scope, main: bool) -> Scope:
    """The scope, whose entries of parameters are arguments in the main function alone."""
    return scope if main else replace(scope, scalar=lambda name: False, main=False)


def _statements(page: Page, node: Any, depth: int, scope: Scope) -> None:
    parts = named(node)
    if not parts:
        page.put(line_of(node), depth, "pass")
    for part in parts:
        _statement(page, part, depth, scope)


def _block(page: Page, owner: Any, depth: int, scope: Scope) -> None:
    found = next((c for c in owner.children if c.type == "block"), None)
    if found is None:
        page.put(line_of(owner), depth, "pass")
    else:
        _statements(page, found, depth, scope)


def _statement(page: Page, node: Any, depth: int, scope: Scope) -> None:
    line, kind = line_of(node), node.type
    match kind:
        case "function_definition":
            pass
        case "assignment" if _is_list(node):
            page.put(line, depth, "pass")
        case "assignment":
            left, right = (node.child_by_field_name(f) for f in ("left", "right"))
            page.put(line, depth, _assignment(left, right, scope))
        case "if_statement":
            condition = _condition(node.child_by_field_name("condition"), scope)
            page.put(line, depth, f"if {condition}:", opens=True)
            _block(page, node, depth + 1, scope)
            for part in named(node):
                if part.type == "elseif_clause":
                    condition = _condition(part.child_by_field_name("condition"), scope)
                    page.put(line_of(part), depth, f"elif {condition}:", opens=True)
                    _block(page, part, depth + 1, scope)
                if part.type == "else_clause":
                    page.put(line_of(part), depth, "else:", opens=True)
                    _block(page, part, depth + 1, scope)
        case "for_statement":
            (iterator,) = (c for c in node.children if c.type == "iterator")
            counter, steps = named(iterator)
            if steps.type not in ("range", "number") and not _is_row(steps):
                raise refuse(iterator, "a loop goes through columns: loop over a range, as 1:3")
            page.put(line, depth, f"for {safe(words(counter))} in {_list(steps, scope)}:",
                     opens=True)  # fmt: skip
            _block(page, node, depth + 1, scope)
        case "return_statement" if node == _last(_around(node)):
            page.put(line, depth, "pass")
        case "return_statement":
            raise refuse(node)
        case "global_operator" | "persistent_operator":
            own = {safe(words(one)) for one in within(node, "identifier")} & {*scope.arguments}
            if own:
                raise refuse(node, f"{joined(sorted(own))} is an argument: it cannot be both")
        case _ if re.match(r"clear(?:vars)?\b", words(node)) and scope.arguments:
            raise refuse(node, "clear removes names, arguments too: leave it out")
        case "command" if words(node).startswith("syms") and (
            {*words(node).split()} & {*scope.arguments, *scope.locals}
        ):  # fmt: skip
            raise refuse(node, "what syms makes a symbol has a value already")
        case "function_call" if words(_name(node)) == "run" and node == _first(_around(node)):
            page.put(line, depth, "pass")  # the file gives values to the scene's names
        case "function_call" if words(_name(node)) == "error":
            page.put(line, depth, "raise ValueError", opens=False)
        case "function_call" if words(_name(node)) in SHOWN and not within(node, *SETS):
            page.put(line, depth, "pass")
        case "command" if words(named(node)[0]) in SHOWN:
            page.put(line, depth, "pass")
        case "identifier" if words(node) in SHOWN:
            page.put(line, depth, "pass")
        case "function_call" if safe(words(_name(node))) not in scope.functions:
            raise refuse_call(node, words(_name(node)))
        case _:
            raise refuse(node)


def _first(function: Any) -> Any:
    """The first statement of a function, before which no name has a value but the arguments."""
    blocks = [c for c in function.children if c.type == "block"] if function is not None else []
    return next((part for b in blocks for part in named(b) if part.type != "comment"), None)


def _last(function: Any) -> Any:
    """The last statement of a function, behind which it ends anyway."""
    blocks = [c for c in function.children if c.type == "block"] if function is not None else []
    return next(reversed([part for block in blocks for part in named(block)]), None)


def _assignment(left: Any, right: Any, scope: Scope) -> str:
    if left.type == "identifier" and right.type == "lambda":
        return f"{safe(words(left))} = {_handle(right, scope)}"
    if right.type == "field_expression" and left.type == "identifier" and _idle(left, scope):
        return "pass"
    value = expression(right, scope)
    if left.type == "identifier":
        name = safe(words(left))
        if name in scope.constants:
            return "pass"
        if value == name:  # m = p.m, where p.m is the argument m
            return "pass"
        return f"{name} = {value}"
    if left.type == "function_call" and _name(left).type == "identifier":
        name = safe(words(_name(left)))
        return f"{name} = put({joined([name, value, *_indices(left, name, scope)])})"
    if left.type == "multioutput_variable":
        targets = [safe(words(part)) for part in named(left)]
        if all(part.type == "identifier" for part in named(left)):
            return f"{joined(targets)} = {value}"
    raise refuse(left)


def _idle(target: Any, scope: Scope) -> bool:
    """Whether nothing uses what is assigned."""
    function = _around(target)
    if function is None or safe(words(target)) in scope.outputs:
        return False
    same = [one for one in within(function, "identifier") if words(one) == words(target)]
    fields = [one for one in same if one.parent.type == "field_expression"
              and one.parent.child_by_field_name("object") != one]  # fmt: skip
    return len(same) - len(fields) == 1


def _handle(node: Any, scope: Scope) -> str:
    """@(q) a*q, which keeps what its other names are when it is made."""
    given = next((c for c in node.children if c.type == "arguments"), None)
    parts = named(given) if given is not None else []
    if any(part.type != "identifier" for part in parts):
        raise refuse(node)
    own = [safe(words(part)) for part in parts]
    inner = replace(
        scope,
        arguments=[a for a in scope.arguments if a not in own],
        locals=scope.locals | {*own},
        constants={n: v for n, v in scope.constants.items() if n not in own},
        handles=scope.handles - {*own},
    )
    value = expression(node.child_by_field_name("expression"), inner)
    held = (*scope.arguments, *sorted(scope.locals), *scope.free)
    around = [n for n in held if n not in own]
    kept = [n for n in dict.fromkeys(around) if re.search(rf"(?<![\w.]){n}\b", value)]
    if wrong := [n for n in own if n in scope.free]:
        raise refuse(node, f"{wrong[0]} means two things: rename one")
    return f"(lambda {joined([*own, *(f'{n}={n}' for n in kept)])}: {value})"


def _condition(node: Any, scope: Scope) -> str:
    if node.type == "parenthesis":
        return _condition(named(node)[0], scope)
    if node.type == "identifier" and words(node) in scope.arguments:
        scope.flags.add(safe(words(node)))
        return "True"
    if node.type == "comparison_operator":
        left, right = named(node)
        if "true" in (words(left), words(right)) and "==" in words(node):
            asked = left if words(right) == "true" else right
            if asked.type not in TRUTHS and scope.scalar(safe(words(asked))):
                raise refuse(node, "a number that is compared with true is compared with 1")
            if asked.type not in (*TRUTHS, "identifier"):
                raise refuse(node)
            return _condition(asked, scope)
    return expression(node, scope)


def _is_row(node: Any) -> bool:
    """Whether a matrix is written as one row of numbers."""
    rows = named(node) if node.type == "matrix" else []
    return len(rows) == 1 and all(part.type == "number" for part in named(rows[0]))


def _list(node: Any, scope: Scope) -> str:
    """A range of whole numbers."""
    if node.type == "range":
        parts = [expression(part, scope) for part in named(node)]
        first, last = parts[0], parts[-1]
        step = parts[1] if len(parts) == 3 else "1"
        return f"steps({first}, {step}, {last})"
    if node.type == "matrix":
        return (
            f"[{joined([expression(part, scope) for row in named(node) for part in named(row)])}]"
        )
    return expression(node, scope)


def _indices(call: Any, name: str, scope: Scope) -> list[str]:
    arguments = [c for c in call.children if c.type == "arguments"]
    if not arguments:
        raise refuse(call)
    parts = named(arguments[0])
    found = []
    for axis, part in enumerate(parts):
        if part.type == "spread_operator" or words(part) == ":":
            found.append("ALL")
            continue
        text = _list(part, scope) if part.type in ("range", "matrix") else expression(part, scope)
        found.append(text.replace("end_keyword", f"size({name}, {axis}, {len(parts)})"))
    return found


def expression(node: Any, scope: Scope) -> str:
    """A formula as Python.

    Raises
    ------
    Unread
    """
    match node.type:
        case "number":
            return _number(node)
        case "identifier":
            return _variable(node, scope)
        case "boolean":
            return "True" if words(node) == "true" else "False"
        case "end_keyword":
            return "end_keyword"
        case "parenthesis":
            return f"({expression(named(node)[0], scope)})"
        case "unary_operator":
            sign, inner = words(node.children[0]), expression(named(node)[0], scope)
            if sign not in "+-" or inner.startswith(f"({sign}"):  # --x is less by 1 in Octave
                raise refuse(node)
            return f"({sign}{inner})"
        case "not_operator":
            return f"(not {expression(named(node)[0], scope)})"
        case "postfix_operator":
            return f"transposed({expression(named(node)[0], scope)})"
        case "binary_operator":
            return _binary(node, scope)
        case "comparison_operator" | "boolean_operator":
            left, right = (expression(part, scope) for part in named(node))
            sign = next(words(c) for c in node.children if not c.is_named)
            if sign in BOTH:  # in Python one of the sides, in MATLAB true or false
                return f"(True if {left} {BOTH[sign]} {right} else False)"
            return f"({left} {COMPARED[sign]} {right})"
        case "matrix":
            rows = ["(" + "".join(expression(p, scope) + ", " for p in named(row)) + ")"
                    for row in named(node)]  # fmt: skip
            return f"block({joined(rows)})"
        case "range":
            return f"block(tuple({_list(node, scope)}))"
        case "function_call":
            return _call(node, scope)
        case "field_expression":
            return _field(node, scope)
    raise refuse(node)


def _number(node: Any) -> str:
    """A number in digits: 0x10 is an integer of 8 bits."""
    if not DECIMAL.fullmatch(words(node)):
        raise refuse(node)
    return words(node)


def _binary(node: Any, scope: Scope) -> str:
    first, second = named(node)
    sign = next(words(c) for c in node.children if not c.is_named)
    if sign in ("^", ".^"):
        if second.type == "binary_operator":
            raise refuse(node, "a power of a power is not read: write brackets")
        before = ""
        while first.type == "unary_operator":  # the grammar has (-m)^2 for -m^2
            before += words(first.children[0])
            (first,) = named(first)
        power = "each_power" if sign == ".^" else "power"
        return f"({before}{power}({expression(first, scope)}, {expression(second, scope)}))"
    left, right = expression(first, scope), expression(second, scope)
    if sign in OPERATIONS:
        return f"{OPERATIONS[sign]}({left}, {right})"
    if sign == "/":
        return f"over({left}, {right})"
    if sign == "\\":
        return f"under({left}, {right})"
    raise refuse(node)


def _variable(node: Any, scope: Scope) -> str:
    name = safe(words(node))
    if name in scope.locals or name in scope.arguments or name in scope.constants:
        return name
    if name in scope.functions:
        return f"{name}(){_first_outputs(node, scope.functions[name])}"
    if name in CONSTANTS:
        return CONSTANTS[name]
    if name == "nargin" and scope.main:
        return str(len(scope.arguments))
    scope.free[name] = None
    return name


def _field(node: Any, scope: Scope) -> str:
    """p.m, where p is an argument: m, by the name that the code gives to it or its own."""
    base = _base(node)
    parts = [safe(words(part)) for part in named(node)]
    elsewhere = base not in scope.arguments and base not in scope.functions
    if base in scope.locals or base in scope.constants or (elsewhere and scope.scalar(base)):
        raise refuse(node)
    inner = node
    if any(part.type not in ("identifier",) for part in named(inner)[1:]):
        raise refuse(node)
    parent = node.parent
    name = parts[-1]
    if parent is not None and parent.type == "assignment":
        left = parent.child_by_field_name("left")
        if left.type == "identifier" and left != node:
            local = safe(words(left))
            # m1 = p.first.m is one of several; l = p.first.m is not.
            several = len(parts) > 2 and local.startswith(name)
            one = not several or f".{local}" in words(_around(node))
            if local != name and one and scope.scalar(local) and scope.scalar(name):
                raise refuse(node, f"{local} has the value of {name}: write {name} itself")
            if scope.scalar(local) or not scope.scalar(name):
                name = local
                scope.locals.discard(name)
    copied = parent is not None and parent.type == "assignment" and (
        words(parent.child_by_field_name("left")) == name
    )  # fmt: skip
    if name == parts[-1] and name in scope.anew and not copied:
        raise refuse(node, f"{name} is a field and another name: rename one")
    owner = ".".join(parts[:-1])
    if (scope.free.get(name) or owner) != owner:
        raise refuse(node, f"{name} is a field of {scope.free[name]} and of {owner}: rename one")
    scope.free[name] = owner
    return name


def _call(node: Any, scope: Scope) -> str:
    head = _name(node)
    if head is None:
        raise refuse(node)
    if head.type == "field_expression":
        return _entry(node, _field(head, scope), scope)
    name = safe(words(head))
    if name in scope.constants:
        raise refuse(node, f"{name} is a number here: leave out what stands in brackets behind it")
    if (name in scope.locals or name in scope.arguments) and name not in scope.handles:
        return _entry(node, name, scope)
    arguments = [c for c in node.children if c.type == "arguments"]
    given = [expression(part, scope) for part in named(arguments[0])] if arguments else []
    if name in scope.handles:
        return f"{name}({joined(given)})"
    if name in scope.functions:
        return f"{name}({joined(given)}){_first_outputs(node, scope.functions[name])}"
    if name in ELEMENTWISE:
        return f"np.{ELEMENTWISE[name]}({joined(given)})"
    if name in RECIPROCAL:
        return f"(1/np.{RECIPROCAL[name]}({joined(given)}))"
    if name in WHOLES:
        return f"{WHOLES[name]}({joined(given)})"
    if name in ARRAYS:
        return f"{'total' if name == 'sum' else name}({joined(given)})"
    if name in ("length", "numel") and given and given[0].isidentifier():
        return f"{name}({joined(given)})"
    if name == "wrapToPi" and len(given) == 1:  # of pi it is the same angle, -pi
        return f"minus(np.mod(plus({given[0]}, np.pi), 2*np.pi), np.pi)"
    if name == "single":
        raise refuse(node, "single precision is not read: write double")
    if name in ("deg2rad", "double", "simplify"):
        return f"({given[0]}*np.pi/180)" if name == "deg2rad" else given[0]
    scope.free[name] = None
    return _entry(node, name, scope)


def _first_outputs(call: Any, count: int) -> str:
    """Which of the outputs of a function are used: of several that nothing asks for, the first."""
    parent = call.parent
    asked = 1
    if parent.type == "assignment" and parent.child_by_field_name("right") == call:
        left = parent.child_by_field_name("left")
        asked = len(named(left)) if left.type == "multioutput_variable" else 1
    if count < 2 or asked == count:
        return ""
    return "[0]" if asked == 1 else f"[:{asked}]"


def _entry(node: Any, name: str, scope: Scope) -> str:
    """x(2): an entry, or a parameter of this number."""
    indices = _indices(node, name, scope)
    if indices[1:] in (["ALL"], ["1"]) and name in scope.arguments and not _is_matrix(node, name):
        del indices[1]  # of a column
    whole = len(indices) == 1 and indices[0].isdigit()
    outside = name in scope.free or (name in scope.arguments and name not in scope.locals)
    if whole and outside and (one := _numbered(name, indices[0], scope)):
        scope.free.pop(name, None)
        scope.free[one] = None
        return one
    if whole and outside:
        return f"{name}[{int(indices[0]) - 1}]"
    return f"get({joined([name, *indices])})"


def _is_matrix(node: Any, name: str) -> bool:
    """Whether the file takes entries of a further column of a name."""
    root = node
    while root.parent is not None:
        root = root.parent
    return re.search(rf"\b{name}\s*\([^,()]*,\s*[2-9]\s*\)", words(root)) is not None


def _numbered(name: str, number: str, scope: Scope) -> str:
    """L(1) as L1 or L_1, where the scene has it and no L."""
    if name in scope.arguments:
        return ""
    return next((n for n in (name + number, f"{name}_{number}") if scope.scalar(n)), "")
