r"""Julia's functions as Python: their trees, printed line by line.

    function f!(du, u, p, t)            def f(u, p, t):
        θ, ω = u                            theta, omega = u
        du[2] = -3g/(2l)*sin(θ)             du = put(du, ..., 2); return du

What the file assigns once outside of functions is known inside of them. Each entry that is set
makes another array here: code in which two names may be one array that changes is not read.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any
from unicodedata import normalize

from numpy import float32

from mechanics.claims.code import array_language
from mechanics.claims.code.arguments import OF_TIME
from mechanics.claims.code.translation.matlab import ELEMENTWISE, RECIPROCAL, Translated
from mechanics.claims.code.translation.python_page import (
    LONGEST,
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
from mechanics.claims.text.letters import plain

FUNCTIONS = {**ELEMENTWISE, "rad2deg": "rad2deg", "deg2rad": "deg2rad"}
"""Functions of numbers and what NumPy calls them."""
OF_TWO = ("hypot", "max", "min", "mod", "atan")
OF_NUMBERS = frozenset((*FUNCTIONS, *RECIPROCAL, *OF_TWO, "abs2", "Float64", "float"))
"""Functions that a dot may stand behind."""
NEW = ("vector_expression", "matrix_expression", "binary_expression", "unary_expression",
       "juxtaposition_expression", "broadcast_call_expression", "integer_literal",
       "float_literal")  # fmt: skip
"""What makes an array of its own."""
MAKES = ("zeros", "ones", "similar", "zero", "copy", "collect", "vcat", "inv")
"""Functions that do."""
OWN = {"inv": "inverse", "det": "determinant", "transpose": "transposed", "dot": "dot",
       "cross": "cross", "norm": "norm", "diagm": "diag", "Diagonal": "diag",
       "sum": "np.sum"}  # fmt: skip
"""Functions of arrays."""
KINDS = frozenset(
    ("SA", "SVector", "MVector", "SMatrix", "MMatrix", "SArray", "Float64", "Float32", "Real",
     "Vector", "Array", "collect", "copy", "vec", "view", "views", "inbounds", "fastmath", "time")
)  # fmt: skip
"""Kinds of numbers and arrays, and what else changes no value."""
OPERATIONS = {
    "+": "plus", ".+": "plus", "-": "minus", ".-": "minus", "*": "times", ".*": "each_times",
    "/": "over", "./": "each_over", "\\": "under", "^": "power", ".^": "each_power", "⋅": "dot",
    "×": "cross", "//": "over",
}  # fmt: skip
POWERS = ("^", ".^")
COMPARED = {
    "==": "==", "!=": "!=", "<": "<", ">": ">", "<=": "<=", ">=": ">=", "≤": "<=", "≥": ">=",
    "≠": "!=", "&&": "and", "||": "or",
}  # fmt: skip
CONSTANTS = {"π": "np.pi", "pi": "np.pi", "true": "True", "false": "False", "nothing": "None"}
SHOWN = frozenset(("println", "print", "show", "info", "warn", "debug", "assert", "printf"))
"""Calls and macros that change no number."""
MACROS = KINDS | SHOWN | frozenset(
    (".", "inline", "noinline", "propagate_inbounds", "simd", "unpack", "UnPack", "doc", "time",
     "elapsed", "btime", "benchmark", "test", "testset", "named", "variables", "parameters",
     "independent_variables", "constants", "mtkbuild", "mtkcompile", "mtkmodel", "kwdef",
     "with_kw", "sprintf", "isdefined", "animate", "gif", "layout", "recipe", "L_str", "brownian",
     "connector", "component", "syms", "SVector", "SMatrix", "SArray", "MVector", "MMatrix",
     "polyvar", "tturbo", "turbo", "muladd", "static", "model", "variable", "objective")
)  # fmt: skip
"""Macros outside of functions, and on these, that give no name another meaning."""
EVALUATES = frozenset(("eval", "evalfile", "include_string"))
"""Calls that run any text as code."""
SOLVES = re.compile(r"ode", re.IGNORECASE)
"""In the name of what solves equations: ODEProblem, ode78, CoupledODEs."""
BRACKET = re.compile(r"(?<=\d)([-+*/\\^]|\.[-+*/\\^])\(")
"""The grammar takes 2*(x) for 2 times a call of *, but not 2* (x)."""
SILENT = re.compile(
    r"^[ \t]*(?:@(?:inline|noinline|propagate_inbounds|inbounds|fastmath|views)[ \t]+)+",
    re.MULTILINE,
)
"""Macros that leave a statement as it is. The grammar splits a + 3u behind a macro in two."""
ASSIGNED = ("assignment", "compound_assignment_expression")
OPERATED = ("binary_expression", "unary_expression", "juxtaposition_expression")
HIDING = ("let_statement", "module_definition", "for_statement", "while_statement")
UNSURE = ("if_statement", "try_statement")
"""Blocks whose names are not those of the file, and that may not be run."""
TUPLES = ("open_tuple", "tuple_expression")
NUMBERS = ("integer_literal", "float_literal")
CLAUSES = {"elseif_clause": "elif", "else_clause": "else"}
DOTS = {0: "", 1: "_dot", 2: "_ddot"}


WHOLE = re.compile(r"U?Int(?:eger|\d+)?|Bool")
"""Kinds of integers."""
REALS = frozenset(
    ("Float64", "Float32", "BigFloat", "Real", "Number", "AbstractFloat", "Any", "Nothing", "Tuple",
     "Vector", "Matrix", "Array", "AbstractVector", "AbstractMatrix", "AbstractArray", "SVector",
     "MVector", "SMatrix", "MMatrix", "StaticArray")
)  # fmt: skip
"""Kinds to which what is real is converted as it is."""
SINGLE = re.compile(r"\bFloat32\b|\d\.?f-?\d|\bSA_F32\b")
LIBRARIES = frozenset(("Base", "LinearAlgebra", "StaticArrays", "Core", "DifferentialEquations"))
"""Whose functions are what they are called."""


@dataclass
class Function:
    """One function of a file.

    Attributes
    ----------
    node, call : node
        The whole, and its name with its arguments.
    body : list of node
    defaults : dict of str to str
        Numbers of arguments.
    filled : str
        The argument that it fills; empty where it returns something.
    takes : bool
        Whether an argument has a name.
    constants : dict of str to str
        Numbers that it assigns once.
    free : dict of str to None
        Names that nothing gives a value.
    known : dict of str to Function
        Those that it may call, which are printed already.
    records : dict of str to str
        Fields, and the arguments that they are of.
    passed : set of int
        Places where it passes such an argument on, of which the other one takes fields alone.
    """

    node: Any
    call: Any
    body: list[Any]
    arguments: list[str] = field(default_factory=list)
    defaults: dict[str, str] = field(default_factory=dict)
    locals: set[str] = field(default_factory=set)
    constants: dict[str, str] = field(default_factory=dict)
    filled: str = ""
    takes: bool = False
    free: dict[str, None] = field(default_factory=dict)
    scalar: Callable[[str], bool] = bool
    others: frozenset[str] = frozenset()
    known: dict[str, "Function"] = field(default_factory=dict)
    records: dict[str, str] = field(default_factory=dict)
    passed: set[int] = field(default_factory=set)


def parsed(text: str) -> Any:
    """The tree of a file.

    Parameters
    ----------
    text : str
    """
    plain_text = SILENT.sub(lambda found: " " * len(found[0]), text)
    return tree(language, BRACKET.sub(r"\1 (", plain_text), "tree-sitter-julia")


def in_python(
    text: str, origin: str, known: Callable[[str], bool], chosen: str | None = None
) -> Translated:
    """The functions of a file of Julia: those that are solved, or that no other one calls.

    Parameters
    ----------
    text, origin : str
    known : callable
        Whether a name is one of the scene.
    chosen : str, optional
        The one that is asked for, with its exclamation mark or without.

    Raises
    ------
    Unread
        For what is not read, by line and column.
    """
    root = parsed(text)
    functions: dict[str, Function] = {}
    twice: set[str] = set()
    for one in functions_of(root):
        name = name_of(named(one.call)[0])
        twice |= {name} & functions.keys()
        functions[name] = one
    if not functions:
        raise Unread("there is no function in it")
    if chosen is not None:
        chosen = chosen.replace("!", "")
        refuse_absent(chosen, functions)
    # A name of a type is no call of what its objects are called with.
    known_ones = {n for n, one in functions.items() if named(one.call)[0].type == "identifier"}
    calls = {name: _names(one.node) & known_ones - {name} for name, one in functions.items()}
    of_file = [n for n in functions if n in _solved(root)] or _uncalled(functions, calls)
    tops = [safe(chosen)] if chosen else of_file
    wanted = list(tops)
    for name in wanted:
        wanted += [other for other in functions if other in calls[name] and other not in wanted]
    page = Page()
    bodies = [(name, functions[name]) for name in functions if name in wanted]
    _own_names(root, [one.node for _, one in bodies])
    printed: dict[str, tuple[Page, Page]] = {}
    for name in _callees_first(wanted, calls):
        one = functions[name]
        if name in twice:
            raise refuse(one.call, f"{name} has several methods: leave one")
        if (wrong := first_error(one.node)) is not None:
            raise refuse(wrong)
        _learn(one, known, frozenset(functions))
        one.known = {other: functions[other] for other in printed}
        printed[name] = _bodies(one, name in tops)
    for name, one in bodies:
        _function(page, name, one, name in tops, *printed[name])
    page.constants({name: one.constants for name, one in bodies})
    own = {name: getattr(array_language, name) for name in vars(array_language)
           if callable(getattr(array_language, name)) or name == "ALL"}  # fmt: skip
    space = page.module(origin, own)
    remarks: tuple[str, ...] = ()
    if any(SINGLE.search(words(functions[name].node)) for name in wanted):
        remarks = (*remarks, "single precision (Float32) is read as exact numbers")
    includes = any(words(named(one)[0]) == "include" for one in within(root, "call_expression"))
    free = dict.fromkeys(n for _, one in bodies for n in one.free) if includes else ()
    return Translated(tuple(space[name] for name in tops), remarks, tuple(free))


def language() -> object:
    """The grammar of Julia."""
    import tree_sitter_julia

    return tree_sitter_julia.language()


def name_of(node: Any) -> str:
    """A name in plain letters, dots above it as ``_dot``; of ``(s::Rod)`` that of the type.

    Raises
    ------
    Unread
    """
    if _of_objects(node):
        node = within(node, "identifier")[-1]
    letters, order = plain(words(node).replace("!", ""))
    if order not in DOTS or not letters.isidentifier():
        raise refuse(node)
    return safe(letters + DOTS[order])


def _of_objects(head: Any) -> bool:
    """Whether it is what objects of a type are called with: ``(s::Rod)(du, u, p, t)``."""
    inner = named(head)[0] if named(head) else head
    return head.type == "parenthesized_expression" and inner.type == "typed_expression" and (
        [part.type for part in named(inner)] == ["identifier", "identifier"]
    )  # fmt: skip


def _callees_first(chosen: list[str], calls: dict[str, set[str]]) -> list[str]:
    """Functions behind those that they call; one that calls itself as it comes."""
    order: list[str] = []

    def visit(name: str, above: tuple[str, ...]) -> None:
        for other in sorted(calls[name] - {*above, *order}):
            visit(other, (*above, name))
        if name not in order:
            order.append(name)

    for name in chosen:
        visit(name, ())
    return order


def functions_of(root: Any) -> Iterator[Function]:
    """Those with a name of their own: ``function f(x) ... end`` and ``f(x) = ...``."""
    ours = {words(target) for target, _, one in _assigned(root) if _around(one) is None}
    for node in within(root, "function_definition", "assignment"):
        parts = named(node)
        head = parts[0]
        while head.type in ("signature", "where_expression", "typed_expression"):
            head = named(head)[0]
        first = named(head)[0] if head.type == "call_expression" else None
        if first is None or not (first.type == "identifier" or _of_objects(first)):
            continue
        if node.parent.type == "macro_argument_list" and node != named(node.parent)[-1]:
            raise refuse(node.parent, "what stands behind a function in a macro is not read")
        body = parts[1:] if node.type == "function_definition" else parts[-1:]
        if _makes(body) and not ours & {words(i) for i in within(named(head)[1], "identifier")}:
            continue  # of values for the one inside, which has their names
        one = Function(node, head, body)
        one.takes = any(part.type != "unary_typed_expression" for part in named(named(head)[1]))
        yield one


def _makes(body: list[Any]) -> bool:
    """Whether a function only returns one that is defined in it."""
    inside = [part for one in body for part in (named(one) if one.type == "block" else [one])]
    kinds = [part.type for part in inside if part.type not in ("string_literal", "line_comment")]
    return kinds == ["function_definition"]


def _argument(one: Function, node: Any) -> None:
    default = ""
    if node.type in ("named_argument", "keyword_parameters"):
        parts = [part for part in named(node) if part.type != "operator"]
        if len(parts) != 2:
            raise refuse(node)
        node, default = parts[0], _number(parts[1]) if parts[1].type in NUMBERS else ""
    if node.type == "unary_typed_expression":
        return
    if node.type == "splat_expression":
        names = {words(i) for part in one.body for i in within(part, "identifier")}
        if names & {words(i) for i in within(node, "identifier")}:
            raise refuse(node)
        return  # nothing uses it
    if node.type == "typed_expression":
        node = named(node)[0]
    if node.type != "identifier":
        raise refuse(node)
    if default:
        one.defaults[name_of(node)] = default
    one.arguments.append(name_of(node))


def _own_names(root: Any, nodes: list[Any]) -> None:
    """Refuse what gives names that are known here another meaning, and two names that look alike.

    Raises
    ------
    Unread
    """
    for macro in within(root, "macro_definition"):
        raise refuse(macro, "macros of one's own are not read")
    for macro in within(root, "macrocall_expression"):
        if _around(macro) is None and _macro(macro).rpartition("@")[2] not in MACROS:
            raise refuse(macro, f"what the macro {words(named(macro)[0])} makes of it is not known")
    for call in within(root, "call_expression"):
        if words(named(call)[0]).rpartition(".")[2] in EVALUATES:
            raise refuse(call, "what is run as code from a text may give names another meaning")
    for one in within(root, "assignment"):
        if named(one)[0].type in OPERATED:
            raise refuse(one, "an operator has another meaning here")
    known = {*FUNCTIONS, *OWN, *KINDS, *RECIPROCAL, *CONSTANTS, *MAKES, "sincos", "abs2"}
    _refuse_imports(root, known)
    for node in within(root, "function_definition", "assignment"):
        head = node
        while head.type in ("function_definition", "assignment", "signature", "where_expression"):
            head = named(head)[0]
        called = head.type == "call_expression"
        inner = named(head)[0] if called else head
        ours = not called and _around(node) is None and words(inner) in known
        if ours or (called and (inner.type == "operator" or words(inner).startswith("Base"))):
            raise refuse(head, f"{words(inner)} has another meaning here")
    written: dict[str, str] = {}
    for one in (i for node in nodes for i in within(node, "identifier") if _is_name(i)):
        text = normalize("NFC", words(one))
        if written.setdefault(name_of(one), text) != text:
            raise refuse(one, f"{text} and {written[name_of(one)]} are one name here: rename one")


def _open_kinds(node: Any) -> set[str]:
    """T of ``where {T}``."""
    wheres = within(node, "where_expression")
    return {words(i) for w in wheres for part in named(w)[1:] for i in _tree_names(part)}


def _tree_names(node: Any) -> list[Any]:
    return [node] if node.type == "identifier" else within(node, "identifier")


def _refuse_imports(root: Any, known: set[str]) -> None:
    """Refuse a name that is known here and comes from somewhere else.

    Raises
    ------
    Unread
    """
    for one in within(root, "selected_import"):
        first, *names = named(one)
        for name in names:
            own = words(_tree_names(name)[-1]) if _tree_names(name) else words(name)
            elsewhere = words(first) not in LIBRARIES or name.type == "import_alias"
            if own in known and elsewhere:
                raise refuse(one, f"{own} has another meaning here")


def _names(node: Any) -> set[str]:
    return {name_of(one) for one in within(node, "identifier") if _is_name(one)}


def _is_name(node: Any) -> bool:
    return plain(words(node).replace("!", ""))[0].isidentifier()


def _solved(root: Any) -> set[str]:
    """Functions that are passed to what solves them."""
    found: set[str] = set()
    for call in within(root, "call_expression"):
        head, *rest = named(call)
        if SOLVES.search(words(head)) and rest:
            found |= {name_of(p) for p in named(rest[0]) if p.type == "identifier" and _is_name(p)}
    return found


def _uncalled(functions: dict[str, Function], calls: dict[str, set[str]]) -> list[str]:
    called = set().union(*calls.values())
    found = [name for name, one in functions.items() if one.takes]
    return [name for name in found if name not in called] or found


def _pairs(target: Any, value: Any) -> Iterator[tuple[Any, Any]]:
    """What is assigned to what: ``a, b = 1, 2`` is two assignments, ``a, b = u`` has no values."""
    if target.type == "typed_expression":
        target = named(target)[0]
    if target.type not in TUPLES:
        yield target, value
        return
    parts = named(target)
    values: list[Any] = [None] * len(parts)
    if value is not None and value.type in (*TUPLES, "vector_expression"):
        values = named(value) if len(named(value)) == len(parts) else values
    for part, one in zip(parts, values, strict=True):
        yield from _pairs(part, one)


def _assigned(node: Any) -> Iterator[tuple[Any, Any, Any]]:
    """Targets of a tree, their values where they have their own, and the assignment."""
    for one in within(node, *ASSIGNED):
        left, *_, right = named(one)
        if left.type != "call_expression":
            yield from ((part, value, one) for part, value in _pairs(left, right))


def _around(node: Any) -> Any:
    """The function inside of which a node stands; None for one of the file."""
    outer = node.parent
    while outer is not None and outer.type != "function_definition":
        outer = outer.parent
    return outer


def _base(target: Any) -> Any:
    while target.type == "index_expression":
        target = named(target)[0]
    return target


def _learn(one: Function, known: Callable[[str], bool], others: frozenset[str]) -> None:
    """What a function assigns, fills and finds around it."""
    one.scalar, one.others = known, others
    for part in named(named(one.call)[1]):
        _argument(one, part)
    if (head := named(one.call)[0]).type != "identifier":
        one.arguments.append(name_of(within(head, "identifier")[0]))
    for number in within(one.node, "float_literal"):
        if (text := words(number)) and re.search(r"\df-?\d", text) and not _is_single(text):
            raise refuse(number, f"{text} is rounded to single precision: write it as a double")
    for typed in within(one.node, "typed_expression"):
        inner, kind = named(typed)[0], words(named(typed)[-1])
        argument = typed.parent is not None and typed.parent.type == "argument_list"
        argument = argument or typed.parent == named(one.call)[0]
        if WHOLE.fullmatch(kind) and not (argument and not known(words(inner))):
            raise refuse(typed, f"what is converted to {kind} is not read")
        reals = REALS - {"Float32"} | _open_kinds(one.node)
        if not (argument or {*re.findall(r"[^\W\d]\w*", kind)} <= reals):
            raise refuse(typed, f"what is converted to {kind} is not read")
    targets = [t for t in _assigned(one.node) if _around(t[2]) == one.node]
    if one.node.type == "assignment":
        targets = []
    counted = [named(b)[0] for b in within(one.node, "for_binding")]
    for counter in counted:
        if _is_outside(counter, one.node):
            raise refuse(counter, f"{words(counter)} is another name in its loop: rename one")
    names = [name_of(_base(t)) for t, _, _ in targets]
    for target, value, whole in targets:
        name = name_of(_base(target))
        alone = names.count(name) == 1 and name not in one.arguments
        blocks = (one.node, *(s for s in one.body if s.type == "local_statement"))
        is_number = target.type == "identifier" and value is not None and value.type in NUMBERS
        if alone and is_number and whole.parent in blocks:
            one.constants[name] = _number(value)
    one.locals = {*names, *map(name_of, counted)}.difference(one.constants)
    _refuse_captured(one)
    entries = {
        name_of(_base(t)) for t, _, w in targets if t.type == "index_expression" or _fills(w)
    }
    outside = [name for name in one.arguments if name in entries]
    if len(outside) > 1 or (outside and outside[0] != one.arguments[0]):
        raise refuse(one.call, f"{outside[-1]} is changed and is no output: copy it")
    one.filled = outside[0] if outside else ""
    for target, value, whole in targets:
        if target.type == "identifier" and not _fills(whole):
            if name_of(target) in one.arguments[:1] and _is_output(one, value):
                lost = f"{name_of(target)} is another array from here on"
                raise refuse(whole, f"{lost}, which the caller does not see: write .=")
            alike = _same(named(whole)[-1] if value is None else value)
            if alike & entries or (name_of(target) in entries and alike):
                raise refuse(whole, f"{joined(sorted(alike))} may be one array with it: copy it")


def _refuse_captured(one: Function) -> None:
    """Refuse a function inside that gives a variable of the one around it a value.

    Raises
    ------
    Unread
    """
    for inner in within(one.node, "function_definition", "arrow_function_expression"):
        if inner == one.node:
            continue
        for target, _, whole in _assigned(inner):
            name = name_of(_base(target))
            held = name in one.locals or name in one.arguments or name in one.constants
            if held and _around(whole) != one.node:
                raise refuse(whole, f"{name} is a variable of the function around it: rename it")


def _is_outside(counter: Any, function: Any) -> bool:
    """Whether the name of what a loop counts stands outside of such loops, where it is another."""
    loops = [
        loop for loop in within(function, "for_statement")
        if words(counter) in {words(named(b)[0]) for b in within(loop, "for_binding")}
    ]  # fmt: skip
    if not loops:
        return False
    return any(
        words(name) == words(counter)
        and not any(loop.start_byte <= name.start_byte < loop.end_byte for loop in loops)
        for name in within(function, "identifier")
        if name.parent.type != "field_expression" or named(name.parent)[0] == name
    )


def _is_output(one: Function, value: Any) -> bool:
    """Whether what the first argument is set to was to be its entries: f!(du, u, p, t)."""
    made = value is not None and value.type == "vector_expression" and len(one.arguments) > 3
    return made or bool(one.filled) or _in_place(one)


def _in_place(one: Function) -> bool:
    return words(named(one.call)[0]).endswith("!")


def _same(value: Any) -> set[str]:
    """Names whose array a value may be."""
    if value.type in NEW or (value.type == "index_expression" and _is_entry(value)):
        return set()
    if value.type == "macrocall_expression" and _macro(value).startswith("S"):
        return set()
    if value.type == "call_expression" and words(named(value)[0]) in MAKES:
        return set()
    return _names(value)


def _is_entry(node: Any) -> bool:
    """u[1] is a number, u[1:2] a copy, SA[...] another array; a field of a record is neither."""
    return bool(named(node)[0].type == "identifier")


def _fills(assignment: Any) -> bool:
    """Whether it sets the entries of an array that is there: ``du .= ...``."""
    return any(words(c) == ".=" for c in assignment.children if c.type == "operator")


def _around_it(one: Function) -> dict[str, list[Any]]:
    """What the file, and functions around this one, assign."""
    own: dict[str, list[Any]] = {}
    top = one.node
    while top.parent is not None:
        top = top.parent
    owners = []
    outer = _around(one.node)
    while outer is not None:
        owners.append(outer)
        outer = _around(outer)
    for target, value, whole in _assigned(top):
        if not _is_name(_base(target)):
            continue
        name, here = name_of(_base(target)), _around(whole) in (None, *owners)
        changed = target.type != "identifier" or words(whole.parent).startswith("global")
        around = _blocks_around(whole)
        if any(block.type in HIDING and block not in _blocks_around(one.node) for block in around):
            continue
        records = [block for block in around if block.type == "struct_definition"]
        changed |= any(_is_made(top, record) for record in records)
        changed |= any(block.type in UNSURE for block in around)
        if here or (changed and name not in _kept(whole)):
            own.setdefault(name, []).append((None if changed else value, whole))
    for call in within(top, "call_expression"):
        head, *rest = named(call)
        if words(head).endswith("!") and _around(call) in (None, *owners):
            for given in (i for part in rest for i in within(part, "identifier") if _is_name(i)):
                own.get(name_of(given), []).append((None, call))
    return own


def _blocks_around(node: Any) -> list[Any]:
    found, outer = [], node.parent
    while outer is not None:
        found.append(outer)
        outer = outer.parent
    return found


def _is_made(top: Any, record: Any) -> bool:
    """Whether a file makes an object of a type with values of its own: Params(k = 3.0)."""
    names = within(named(record)[0], "identifier") or named(record)[:1]
    return any(
        words(named(call)[0]).partition("{")[0] == words(names[0]) and bool(named(named(call)[-1]))
        for call in within(top, "call_expression")
    )


def _kept(node: Any) -> set[str]:
    """Names that are the own ones of the function around a node: it assigns or takes them."""
    outer = _around(node)
    if outer is None:
        return set()
    head = named(outer)[0]
    own = {name_of(i) for i in within(head, "identifier") if _is_name(i)}
    shared = {words(i) for one in within(outer, "global_statement") for i in _tree_names(one)}
    for target, _, whole in _assigned(outer):
        plain_name = target.type == "identifier" and _is_name(target)
        if plain_name and words(target) not in shared and _around(whole) == outer:
            own.add(name_of(target))
    return own


def _before(page: Page, one: Function) -> None:
    """What is computed around a function and used in it."""
    table = _around_it(one)
    done: list[str] = []

    def write(name: str) -> None:
        if name in done or name not in table:
            return
        done.append(name)
        if len(table[name]) > 1:
            raise refuse(table[name][1][1], f"{name} is assigned twice: leave one")
        ((value, whole),) = table[name]
        if value is None:
            raise refuse(whole)
        one.free.pop(name, None)
        if value.type in NUMBERS:
            one.constants[name] = _number(value)
            return
        code = expression(value, one)
        for other in [free for free in one.free if free in table]:
            write(other)
        one.locals.add(name)
        page.put(0, 1, f"{name} = {code}")

    for name in list(one.free):
        write(name)


def _bodies(one: Function, main: bool) -> tuple[Page, Page]:
    """What a function does, and what is computed before around it."""
    body, before = Page(), Page()
    *first, last = one.body or [None]
    for part in first:
        _statement(body, part, 1, one)
    _last(body, last, one, main)
    _before(before, one)
    return body, before


def _function(page: Page, name: str, one: Function, main: bool, body: Page, before: Page) -> None:
    used = {name_of(i) for part in one.body for i in within(part, "identifier") if _is_name(i)}
    arguments = [a for a in one.arguments if a != one.filled and a not in one.defaults]
    if main:
        arguments = [a for a in arguments if a in used and _whole(a, one)]
    extra = [n for n in one.free if n not in one.arguments]
    if not main and (open_ones := [n for n in extra if n not in one.records]):
        raise refuse(one.call, f"{joined(open_ones)} of {name}: nothing gives it a value")
    if main and _in_place(one) and not one.filled:
        raise refuse(one.call, f"{words(named(one.call)[0])} sets no entries of its argument")
    if not main and one.filled:
        raise refuse(one.call, f"{name}, which fills an array, is called: let it return one")
    given = [f"{a}={number}" for a, number in one.defaults.items()]
    page.put(
        line_of(one.node), 0, f"def {name}({joined([*arguments, *extra, *given])}):", opens=True
    )
    page.compound = False
    if one.filled:
        page.put(line_of(one.node), 1, f"{one.filled} = {_unset(one)}")
    page.compound = True
    for text in before.lines:
        page.lines.append(text)
    for number, text in enumerate(body.lines, start=1):
        if text.strip():
            depth = (len(text) - len(text.lstrip())) // 4
            page.put(number, depth, text.strip(), opens=text.rstrip().endswith(":"))
    page.compound = True


def _unset(one: Function) -> str:
    """An array whose entries have no value until they are set."""
    places = [named(t)[1] for t, _, _ in _assigned(one.node)
              if t.type == "index_expression" and name_of(_base(t)) == one.filled]  # fmt: skip
    numbers = [words(part) for place in places for part in named(place)]
    if not numbers or not all(number.isdigit() for number in numbers):
        return "None"
    return f"array([{joined(['np.nan'] * min(max(map(int, numbers)), LONGEST))}])"


def _whole(argument: str, one: Function) -> bool:
    """Whether a function uses an argument, and not its fields alone."""
    uses = [i for part in one.body for i in within(part, "identifier")]
    return any(
        name_of(i) == argument and not (_is_field(i) or _is_record(i) or i.id in one.passed)
        for i in uses
        if _is_name(i)
    )


def _is_field(node: Any) -> bool:
    return bool(node.parent is not None and node.parent.type == "field_expression")


def _is_record(node: Any) -> bool:
    """p of ``(; m, g) = p`` and ``@unpack m, g = p``."""
    whole = node.parent
    return whole is not None and whole.type == "assignment" and _record(whole) is not None


def _record(node: Any) -> list[str] | None:
    """Names that are taken out of a record by their own names."""
    left = named(node)[0]
    unpacked = node.parent is not None and node.parent.type == "macro_argument_list" and (
        "unpack" in words(node.parent.parent).split()[0]
    )  # fmt: skip
    if unpacked or re.match(r"\(\s*;", words(left)):
        parts = named(left) if left.type in TUPLES else [left]
        return [name_of(part) for part in parts]
    return None


def _last(page: Page, node: Any, one: Function, main: bool) -> None:
    """The value of a function is that of what it ends with."""
    if node is None:
        raise refuse(one.call, "it has no body")
    if one.filled:
        _statement(page, node, 1, one)
        page.compound = True
        page.put(line_of(node), 1, f"return vector({one.filled})")
        return
    if node.type in ("if_statement", "for_statement", "while_statement"):
        raise refuse(node, "a function that ends with it: write return")
    if node.type in ASSIGNED:
        _statement(page, node, 1, one)
        target = named(node)[0]
        if target.type != "identifier":
            raise refuse(node, "a function that ends with it: write return")
        page.put(line_of(node), 1, f"return {name_of(target)}")
    elif node.type == "return_statement":
        _statement(page, node, 1, one)
    else:
        page.put(line_of(node), 1, f"return {expression(node, one)}")


def _statement(page: Page, node: Any, depth: int, one: Function) -> None:
    line, kind = line_of(node), node.type
    match kind:
        case "assignment" if named(node)[0].type == "call_expression":
            pass
        case "function_definition" | "string_literal" | "line_comment" | "block_comment":
            pass
        case "assignment" | "compound_assignment_expression":
            _assignment(page, node, depth, one)
        case "local_statement" | "const_statement":
            for part in named(node):
                if part.type != "identifier":
                    _statement(page, part, depth, one)
        case "if_statement":
            _condition(page, "if", node, depth, one)
        case "for_statement":
            binding, *rest = named(node)
            counter, steps = [p for p in named(binding) if p.type != "operator"]
            page.put(
                line, depth, f"for {name_of(counter)} in {expression(steps, one)}:", opens=True
            )
            _block(page, node, rest, depth + 1, one)
        case "return_statement":
            value = named(node)
            if one.filled:
                if value and words(value[0]) not in ("nothing", one.filled):
                    raise refuse(node, f"it fills {one.filled} and returns something else")
                page.put(line, depth, f"return vector({one.filled})")
            elif not value:
                raise refuse(node, "it returns nothing")
            else:
                page.put(line, depth, f"return {expression(value[0], one)}")
        case "call_expression" if words(named(node)[0]) in SHOWN and not _changes(node):
            page.put(line, depth, "pass")
        case "call_expression" if words(named(node)[0]) in ("error", "throw"):
            page.put(line, depth, "raise ValueError")
        case "macrocall_expression" if _macro(node) in SHOWN and not _changes(node):
            page.put(line, depth, "pass")
        case "macrocall_expression":
            inner = _inside(node)
            if inner.type == "assignment" and _record(inner) is not None:
                _assignment(page, inner, depth, one)
            elif _macro(node) in KINDS:
                _statement(page, inner, depth, one)
            else:
                raise refuse(node)
        case "identifier" if words(node) in ("nothing", one.filled):
            page.put(line, depth, "pass")
        case "call_expression" if words(named(node)[0]) not in one.others:
            raise refuse_call(node, words(named(node)[0]), named(node)[1:])
        case _:
            raise refuse(node)


def _condition(page: Page, word: str, node: Any, depth: int, one: Function) -> None:
    parts = named(node)
    first = [] if word == "else" else parts[:1]
    inner = [p for p in parts[len(first) :] if not p.type.endswith("_clause")]
    asked = f" {expression(first[0], one)}" if first else ""
    page.put(line_of(node), depth, f"{word}{asked}:", opens=True)
    _block(page, node, inner, depth + 1, one)
    for part in parts:
        if part.type in CLAUSES:
            _condition(page, CLAUSES[part.type], part, depth, one)


def _block(page: Page, owner: Any, parts: list[Any], depth: int, one: Function) -> None:
    if not parts:
        page.put(line_of(owner), depth, "pass")
    for part in parts:
        _statement(page, part, depth, one)


def _assignment(page: Page, node: Any, depth: int, one: Function) -> None:
    left, *middle, right = named(node)
    line = line_of(node)
    if (record := _record(node)) is not None:
        if right.type != "identifier" or name_of(right) not in one.arguments:
            raise refuse(node)
        one.locals -= {*record}
        for name in record:
            _of_record(name, name_of(right), node, one)
        page.put(line, depth, "pass")
        return
    if left.type == "typed_expression":
        left = named(left)[0]
    sign = words(middle[0]) if middle else "="
    if right.type == "assignment":  # du[3] = a = b
        _assignment(page, right, depth, one)
        right = named(right)[0]
    local = name_of(left) if left.type == "identifier" else ""
    if left.type in TUPLES:
        pairs = list(_pairs(left, right))
        own = [name_of(t) if t.type == "identifier" else "" for t, _ in pairs]
        code = [
            "" if v is None else _value(v, one, n) for (_, v), n in zip(pairs, own, strict=True)
        ]
        if "" in code and len(pairs) != len(named(left)):
            raise refuse(node)
        if any(t.type != "identifier" for t, _ in pairs):
            if "" in code or sign != "=" or any(_reads(v, pairs) for _, v in pairs):
                raise refuse(node)
            for (target, _), value in zip(pairs, code, strict=True):
                page.put(line, depth, _set(target, value, "=", one))
            return
        kept = [(name_of(t), c) for (t, _), c in zip(pairs, code, strict=True)
                if c != name_of(t) and name_of(t) not in one.constants]  # fmt: skip
        if "" in code:
            page.put(line, depth, f"{joined([n for n, _ in kept])} = {expression(right, one)}")
        else:
            targets, values = joined([n for n, _ in kept]), joined([c for _, c in kept])
            page.put(line, depth, f"{targets} = {values}" if kept else "pass")
        return
    value = _value(right, one, local if sign == "=" else "")
    page.put(line, depth, _set(left, value, sign, one))


def _reads(value: Any, pairs: list[tuple[Any, Any]]) -> bool:
    return bool(_names(value) & {name_of(_base(t)) for t, _ in pairs})


def _set(left: Any, value: str, sign: str, one: Function) -> str:
    if left.type == "identifier":
        name = name_of(left)
        if name in one.constants or value == name:
            return "pass"
        if sign == ".=":
            return f"{name} = whole({value})"
        if sign != "=":
            value = f"{_operation(left, sign[:-1])}({name}, {value})"
        return f"{name} = {value}"
    if left.type == "index_expression" and _base(left) == named(left)[0]:
        name = name_of(_base(left))
        if name not in one.locals:
            raise refuse(left)
        places = _places(left, name, one)
        if sign not in ("=", ".="):
            value = f"{_operation(left, sign[:-1])}(get({joined([name, *places])}), {value})"
        return f"{name} = put({joined([name, value, *places])})"
    raise refuse(left)


def _operation(node: Any, sign: str) -> str:
    if sign not in OPERATIONS:
        raise refuse(node)
    return OPERATIONS[sign]


def _value(node: Any, one: Function, local: str) -> str:
    """A formula; a field of a record by the scene's name of it, or that of the local name."""
    if node.type != "field_expression":
        return expression(node, one)
    name = _field(node, one)
    if local and local != name and one.scalar(local):
        if one.scalar(name):
            raise refuse(node, f"{local} is the field {name}, and the scene has both: rename one")
        one.free.pop(name, None)
        one.free[local] = None
        one.locals.discard(local)
        return local
    if local == name:
        one.locals.discard(local)
    return name


def _field(node: Any, one: Function) -> str:
    parts = named(node)
    if any(part.type != "identifier" for part in parts) or len(parts) != 2:
        raise refuse(node)
    owner, name = map(name_of, parts)
    if owner not in one.arguments or owner in one.locals:
        raise refuse(node)
    own = name in one.arguments or name in one.constants
    if own or (name in one.locals and not _only_field(name, node, one)):
        raise refuse(node, f"{name} is a field and another name: rename one")
    _of_record(name, owner, node, one)
    return name


def _of_record(name: str, owner: str, node: Any, one: Function) -> None:
    """Know a field of an argument.

    Raises
    ------
    Unread
        Where two have fields of that name.
    """
    if one.records.setdefault(name, owner) != owner:
        raise refuse(node, f"{name} is a field of {one.records[name]} and of {owner}: rename one")
    one.free[name] = None


def _passed(callee: Function, parts: list[Any], given: list[str], one: Function) -> list[str]:
    """What a call passes, with the fields that the other one takes of an argument.

    Raises
    ------
    Unread
        Where these are not those of an argument here.
    """
    fields = {n: owner for n, owner in callee.records.items() if n in callee.free}
    for owner in dict.fromkeys(fields.values()):
        place = callee.arguments.index(owner)
        part = parts[min(place, len(parts) - 1)]
        here = name_of(part) if part.type == "identifier" and place < len(parts) else ""
        if here not in one.arguments or here in one.locals:
            raise refuse(part, f"fields of {owner}: pass an argument")
        if not _whole(owner, callee):
            one.passed.add(part.id)
            given[place] = "None"
        for name in (n for n, of in fields.items() if of == owner):
            if name in one.arguments or name in one.locals or name in one.constants:
                raise refuse(part, f"{name} is a field of {here} and another name: rename one")
            _of_record(name, here, part, one)
    return [*given, *(f"{name}={name}" for name in fields)]


def _only_field(name: str, node: Any, one: Function) -> bool:
    """Whether a local name is that field and nothing else: ``m = p.m``."""
    found = [v for t, v, _ in _assigned(one.node) if name_of(_base(t)) == name]
    return all(v is not None and words(v) == words(node) for v in found)


def _number(node: Any) -> str:
    text = words(node).replace("_", "")
    if not re.fullmatch(r"[\d.]+(?:[ef][-+]?\d+)?", text):
        raise refuse(node)
    return text.replace("f", "e")


def _is_single(text: str) -> bool:
    """Whether a number is one of single precision as it is: 1.5f0."""
    text = text.replace("f", "e").replace("_", "")
    return Fraction(text) == float32(float(text))


def _macro(node: Any) -> str:
    """The name of a macro."""
    return words(named(node)[0]).lstrip("@")


def _changes(node: Any) -> bool:
    """Whether what is shown is changed, too: ``@show x = 2``, ``println(f!(u))``."""
    calls = (words(i) for i in within(node, "identifier"))
    return bool(within(node, *ASSIGNED)) or any("!" in word for word in calls)


def _inside(macro: Any) -> Any:
    """What a macro with one argument is about."""
    parts = [p for part in named(macro) for p in
             (named(part) if part.type == "macro_argument_list" else [part])
             if p.type != "macro_identifier"]  # fmt: skip
    if len(parts) != 1:
        raise refuse(macro)
    return parts[0]


def expression(node: Any, one: Function) -> str:
    """A formula as Python.

    Raises
    ------
    Unread
    """
    match node.type:
        case "integer_literal" | "float_literal":
            return _number(node)
        case "boolean_literal":
            return CONSTANTS[words(node)]
        case "identifier":
            return _variable(node, one)
        case "parenthesized_expression":
            if len(inner := named(node)) != 1:
                raise refuse(node)
            return f"({expression(inner[0], one)})"
        case "unary_expression":
            sign, inner = named(node)
            word = {"+": "+", "-": "-", "!": "not "}.get(words(sign))
            if word is None:
                raise refuse(node)
            return f"({word}{expression(inner, one)})"
        case "juxtaposition_expression":
            first, second = (expression(part, one) for part in named(node))
            return f"times({first}, {second})"
        case "binary_expression":
            return _binary(node, one)
        case "ternary_expression":
            asked, yes, no = (expression(part, one) for part in named(node))
            return f"({yes} if {asked} else {no})"
        case "adjoint_expression":
            return f"transposed({expression(named(node)[0], one)})"
        case "open_tuple" | "tuple_expression":
            return "(" + "".join(f"{expression(part, one)}, " for part in named(node)) + ")"
        case "vector_expression":
            parted = [_row(part, one) for part in named(node)]
            if len(parted) == 1 and len(parted[0]) > 1:  # [a -b], for the grammar a vector
                return f"block(({joined(parted[0])}))"
            if any(len(row) > 1 for row in parted):
                raise refuse(node)
            return f"array([{joined([expression(part, one) for part in named(node)])}])"
        case "matrix_expression":
            rows = ["(" + "".join(f"{part}, " for p in named(row) for part in _row(p, one)) + ")"
                    for row in named(node)]  # fmt: skip
            return f"block({joined(rows)})"
        case "range_expression":
            parts = [expression(part, one) for part in named(node)]
            first, last = parts[0], parts[-1]
            return f"steps({first}, {parts[1] if len(parts) == 3 else '1'}, {last})"
        case "macrocall_expression" if _macro(node) in KINDS:
            return expression(_inside(node), one)
        case "index_expression":
            return _entry(node, one)
        case "call_expression" | "broadcast_call_expression":
            return _call(node, one)
        case "field_expression":
            return _field(node, one)
    raise refuse(node)


def _row(node: Any, one: Function) -> list[str]:
    """Entries of a row: ``a -b`` and ``2 (a)`` are two, which the grammar takes for one."""
    if node.type == "juxtaposition_expression":
        left, right = named(node)
        if left.end_byte < right.start_byte:
            return [*_row(left, one), _entry_of_row(right, one)]
    if node.type != "binary_expression":
        return [_entry_of_row(node, one)]
    left, sign, right = named(node)
    if words(sign) in "+-" and _is_one_sided(left, sign, right):
        return [*_row(left, one), f"({words(sign)}{_entry_of_row(right, one)})"]
    if words(sign) in "+-" and left.type == "binary_expression":
        *before, last = _row(left, one)
        return [*before, f"{OPERATIONS[words(sign)]}({last}, {_entry_of_row(right, one)})"]
    return [_entry_of_row(node, one)]


def _entry_of_row(node: Any, one: Function) -> str:
    """One entry; refused where a blank in it may part two in Julia."""
    if _is_parted(node):
        raise refuse(
            node, f"[{words(node)}] has several columns in Julia: write commas or brackets"
        )
    return expression(node, one)


def _is_parted(node: Any) -> bool:
    if node.type == "juxtaposition_expression":
        left, right = named(node)
        return bool(left.end_byte < right.start_byte) or _is_parted(left) or _is_parted(right)
    if node.type == "binary_expression":
        left, sign, right = named(node)
        parted = words(sign).strip(".") in "+-" and _is_one_sided(left, sign, right)
        return parted or _is_parted(left) or _is_parted(right)
    return node.type == "unary_expression" and _is_parted(named(node)[-1])


def _is_one_sided(left: Any, sign: Any, right: Any) -> bool:
    """Whether a blank stands before a sign and none behind it."""
    return bool(left.end_byte < sign.start_byte and sign.end_byte == right.start_byte)


def _binary(node: Any, one: Function) -> str:
    first, operator, second = named(node)
    sign = words(operator)
    left, right = expression(first, one), expression(second, one)
    if sign in COMPARED:
        if any(p.type == "binary_expression" and words(named(p)[1]) in COMPARED
               and COMPARED[words(named(p)[1])] not in ("and", "or")
               for p in (first, second) if sign not in ("&&", "||")):  # fmt: skip
            raise refuse(node)
        return f"({left} {COMPARED[sign]} {right})"
    if sign in POWERS and first.type == "binary_expression" and words(named(first)[1]) in POWERS:
        # The tree has (2^1)^2 for 2^1^2, and Julia 2^(1^2).
        raise refuse(node, "a power of a power is not read: write brackets")
    if sign in POWERS and first.type == "juxtaposition_expression":  # 2x^2
        factor, base = (expression(part, one) for part in named(first))
        return f"times({factor}, {OPERATIONS[sign]}({base}, {right}))"
    is_call = first.type == "call_expression" and named(first)[0].type == "operator"
    if sign in POWERS and is_call:
        head, arguments = named(first)  # -(x)^2
        base = expression(named(arguments)[0], one)
        return f"({words(head)}{OPERATIONS[sign]}({base}, {right}))"
    return f"{_operation(node, sign)}({left}, {right})"


def _variable(node: Any, one: Function) -> str:
    if words(node) == "end":
        return "end_keyword"
    name = name_of(node)
    if name in one.locals or name in one.arguments or name in one.constants:
        return name
    if words(node) in CONSTANTS:
        return CONSTANTS[words(node)]
    if name in one.others:
        raise refuse(node)
    one.free[name] = None
    return name


def _entry(node: Any, one: Function) -> str:
    head, places = named(node)
    if head.type == "identifier" and words(head) in KINDS and name_of(head) not in one.locals:
        return expression(places, one)
    name = expression(head, one)
    outside = name in one.arguments and name not in one.locals
    entries = named(places)
    numbers = [words(p) for part in entries[:1] for p in (named(part) or [part])]
    if outside and len(entries) == 1 and entries[0].type == "macrocall_expression":
        entries = [_inside(entries[0])]
        numbers = [words(part) for part in named(entries[0])]
    if outside and len(entries) == 1 and all(n.isdigit() for n in numbers):
        if entries[0].type == "vector_expression":
            return f"array([{joined([f'{name}[{int(n) - 1}]' for n in numbers])}])"
        if entries[0].type == "integer_literal":
            return f"{name}[{int(numbers[0]) - 1}]"
        if entries[0].type == "range_expression" and len(numbers) == 2:
            return f"{name}[{int(numbers[0]) - 1}:{int(numbers[1])}]"
    found = _places(node, name, one)
    entry = f"get({joined([name, *found])})"
    return f"vector({entry})" if len(found) == 2 else entry  # a row of a matrix is a vector


def _places(node: Any, name: str, one: Function) -> list[str]:
    parts = named(named(node)[1])
    found = []
    for axis, part in enumerate(parts):
        text = "ALL" if words(part) == ":" else expression(part, one)
        found.append(text.replace("end_keyword", f"size({name}, {axis}, {len(parts)})"))
    return found


def _is_called(name: Any) -> bool:
    call = name.parent
    return call is not None and call.type == "call_expression" and named(call)[0] == name


def _is_time(parts: list[Any], one: Function) -> bool:
    """Whether all that is passed is the argument t."""
    return (
        [words(part) for part in parts] == ["t"] and "t" in one.arguments and "t" not in one.locals
    )


def _call(node: Any, one: Function) -> str:
    head, arguments = named(node)[:2]
    if head.type == "operator" and words(head) in "+-" and len(named(arguments)) == 1:  # -(x)
        return f"({words(head)}{expression(named(arguments)[0], one)})"
    if head.type == "parametrized_type_expression":
        head = named(head)[0]
    if head.type != "identifier":
        raise refuse(node)
    parts = named(arguments)
    if any(part.type in ("named_argument", "splat_expression") for part in parts):
        raise refuse(node)
    name = name_of(head)
    if node.type == "broadcast_call_expression" and (name in one.others or name not in OF_NUMBERS):
        raise refuse(node, f"{name}. of each entry is not read: write it out")
    literal = words(parts[0]) if parts and parts[0].type == "float_literal" else "0"
    if name == "Float32" and not _is_single(literal):
        raise refuse(node, f"{words(node)} is rounded to single precision: write a double")
    given = [expression(part, one) for part in parts]
    if name in one.others and name not in one.locals:
        if name in one.known:
            given = _passed(one.known[name], parts, given, one)
        return f"{name}({joined(given)})"
    if name in one.arguments and name not in one.locals and _is_time(parts, one):
        own = [i for part in one.body for i in within(part, "identifier") if _is_name(i)]
        if not all(_is_called(i) for i in own if name_of(i) == name):
            raise refuse(node, f"{name} is a function and something else: rename one")
        one.passed.add(head.id)
        one.free.setdefault(f"{name}{OF_TIME}")
        return f"{name}{OF_TIME}"
    if name in one.arguments or name in one.locals:
        raise refuse(node)
    if node.type == "call_expression" and name in (*FUNCTIONS, *RECIPROCAL):
        given = [f"single({part})" for part in given]
    if name == "atan" and len(given) == 2:
        return f"np.arctan2({joined(given)})"
    if name == "sincos" and len(given) == 1:
        return f"(np.sin({given[0]}), np.cos({given[0]}))"
    if name in FUNCTIONS:
        if len(given) != 1 and name not in OF_TWO:
            raise refuse(node)
        return f"np.{FUNCTIONS[name]}({joined(given)})"
    if name in RECIPROCAL and len(given) == 1:
        return f"(1/np.{RECIPROCAL[name]}({given[0]}))"
    if name == "abs2":
        return f"power({given[0]}, 2)"
    if name in OWN:
        return f"{OWN[name]}({joined(given)})"
    if name in ("zeros", "ones"):
        return f"{name}({joined(given if len(given) > 1 else [*given, '1'])})"
    if name == "zero" and len(given) == 1:
        return f"({given[0]}*0)"
    if name == "similar" and len(given) == 1:
        return f"({given[0]}*np.nan)"  # until its entries are set
    if name in ("vcat", "SA") or (name in KINDS and len(given) > 1 and name != "view"):
        return f"block({joined([f'({part},)' for part in given])})"
    if name == "view":
        return f"get({joined(given)})"
    if name in KINDS and given:
        return given[0]
    raise refuse(node)
