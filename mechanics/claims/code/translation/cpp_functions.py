"""Functions and methods of C++ as Python, where they are more than C: their trees, line by line.

    std::vector<double> Cart::operator()(std::vector<double> x) const { return {x[1], -k/m*x[0]}; }
    ->  def operator(x, k, m): return block((x[1],), (...,))

Members that nothing gives a value are arguments, an argument of a struct is its fields in their
order, and Eigen's q(1) an entry.
"""

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import reduce
from typing import Any

from mechanics.claims.code import array_language
from mechanics.claims.code.c.plain import ROUNDED, made_single, smooth, with_float
from mechanics.claims.code.reachability import reachable
from mechanics.claims.code.translation.cpp_integers import (
    Kind,
    joined_kind,
    kind_of,
    kind_of_literal,
    promoted,
)
from mechanics.claims.code.translation.cpp_scopes import refuse_ambiguous
from mechanics.claims.code.translation.cpp_types import (
    INTEGERS,
    integer_members,
    is_integral,
    member_key,
    refuse_types,
    tokens_of,
    unread_types,
)
from mechanics.claims.code.translation.python_page import (
    EXACT,
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

LIBRARY = {
    **{name: name for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "sqrt", "exp", "log",
                               "floor", "ceil", "hypot", "abs")},
    "fabs": "abs", "asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2",
    "fmod": "fmod", "max": "maximum", "min": "minimum", "fmax": "maximum", "fmin": "minimum",
}  # fmt: skip
PAIRS = ("make_pair", "make_tuple")
"""Functions that return what they are given, side by side."""
OPERATIONS = {"+": "plus", "-": "minus", "*": "times"}
CONSTANTS = {"M_PI": "np.pi", "true": "True", "false": "False", "PI": "np.pi"}
UNREAD = frozenset(("constrain", "map", "degrees", "radians"))
"""Calls of Arduino that are not read."""
SQUARE = "sq"
"""Its macro for the square of a number."""
COMPARED = ("<", ">", "<=", ">=", "==", "!=")

OWN_KIND = re.compile(
    rf"\btypedef\s+(?:{INTEGERS.pattern}\s+)+(\w+)\s*;"
    rf"|\busing\s+(\w+)\s*=\s*(?:{INTEGERS.pattern}\s*)+;"
)
"""A name of the file for a kind of integers."""
ROW = r"(?:std::)?(?:vector|valarray)\s*<\s*double\s*>"
OWN_ROW = re.compile(rf"\btypedef\s+({ROW})\s+(\w+)\s*;|\busing\s+(\w+)\s*=\s*({ROW})\s*;")
"""A name of the file for a row of numbers."""
OVERLOADED = re.compile(r"\busing\s+(?:namespace\s+std|std::abs)\b|<(?:math|stdlib)\.h>")
"""Where abs is that of real numbers, too."""
LIBRARIES = re.compile(r'"(?:Eigen|boost|casadi|gsl|rbdl|kdl|armadillo|glm)\b')
"""Whose headers declare no name of a formula."""
SIZED = re.compile(r"\b(?:vector|valarray|(?:Row)?(?:Vector|Array|Matrix)X\w*|\w*_(?:type|t))\b")
"""Types of which what they are made of is their size."""
SMALL = ".ino"
"""Of processors whose integers may have 16 bits."""
SMALL_BITS = 16
SKETCH = frozenset(("setup", "loop"))
"""Functions of a sketch for such a one."""
SUFFIXES = (".cpp", ".cc", ".cxx", ".hpp", ".hh", ".ino")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[fFlLuU]*")
WHOLE = re.compile(r"[-+]?\d+[uUlL]*")
CHANGES = ("assignment_expression", "update_expression")
EIGEN = re.compile(r"\bEigen::|^(?:Row)?(?:Vector|Matrix)(?:[1-9]|X)[df]$")
"""Types of Eigen."""
SECOND = re.compile(r"\b(?:Ref|Map|Block|VectorBlock)\s*<")
"""Types whose objects are parts of others, or these by another name."""
ENTRYWISE = re.compile(r"\bArray(?:<[^<>,]*,[^<>,]*,(?!\s*1\s*>)|\d\d|XX|\dX|X\d)")
"""Types of Eigen whose product is that of entries, but for columns."""
DECOMPOSED = frozenset(
    ("householderQr", "colPivHouseholderQr", "fullPivHouseholderQr", "partialPivLu", "fullPivLu",
     "lu", "completeOrthogonalDecomposition")
)  # fmt: skip
"""By what it solves with a whole matrix: others read one half of it."""
WHOLES = {"inverse": "inverse", "transpose": "transposed"}
COORDINATES = ("x", "y", "z", "w")
"""Methods of vectors of Eigen for their first entries."""
VECTOR = re.compile(r"(?:const )?(?:Eigen::)?(?:Vector|Array)([234])d")
"""Columns of doubles of Eigen that are made of their entries: Vector2d(1.0, 2.0)."""
PARTS = {"segment": 2, "head": 1, "tail": 1}
"""Parts of a vector, and how many numbers say which."""
TEMPLATED = re.compile(r"\.(segment|head|tail)(?=<\w+>\()")
"""Eigen's y.segment<2>(2), which the grammar takes for two comparisons."""


@dataclass
class Scope:
    """What one function knows.

    Attributes
    ----------
    arguments : list of str
    fields : dict of str to list of str
        Of arguments that are structs.
    functions : dict of str to node
    printed : dict of str to Scope
        Of functions that it may call.
    references : set of str
        Numbers that it writes where its caller says.
    changed : set of str
        What it assigns.
    kinds : dict of str to Kind
        Of its integers, and of arrays of these.
    whole : Kind or None
        The kind of integers that it returns.
    zeros : set of str
        Its arrays whose entries are 0 where nothing else is said.
    eigen : set of str
        Its matrices and vectors of Eigen.
    lazy : dict of str to set of str
        Of what each of its names is computed again wherever it is used: auto t = 2*x.
    granted : dict of str to None
        Functions that are not here, and are called last: they may change what it has set.
    blank : tuple of str
        Matrices of its object of which it sets some entries, and others nowhere.
    record : tuple of str
        Fields of the structure that it returns, where it is the one that is judged.
    """

    arguments: list[str]
    fields: dict[str, list[str]]
    functions: dict[str, Any]
    printed: dict[str, "Scope"]
    constants: dict[str, str] = field(default_factory=dict)
    locals: set[str] = field(default_factory=set)
    kinds: dict[str, Kind] = field(default_factory=dict)
    aliases: dict[str, str] = field(default_factory=dict)
    filled: dict[str, None] = field(default_factory=dict)
    free: dict[str, None] = field(default_factory=dict)
    references: set[str] = field(default_factory=set)
    shapes: dict[str, int] = field(default_factory=dict)
    outputs: list[str] = field(default_factory=list)
    changed: set[str] = field(default_factory=set)
    open: set[str] = field(default_factory=set)
    pointers: set[str] = field(default_factory=set)
    defaults: dict[str, str] = field(default_factory=dict)
    bits: int = 32
    overloaded: bool = False
    returns: bool = True
    whole: Kind | None = None
    numbers: bool = False
    zeros: set[str] = field(default_factory=set)
    eigen: set[str] = field(default_factory=set)
    lazy: dict[str, set[str]] = field(default_factory=dict)
    granted: dict[str, None] = field(default_factory=dict)
    blank: tuple[str, ...] = ()
    record: tuple[str, ...] = ()

    @property
    def is_sketch(self) -> bool:
        """Whether it is for a processor of Arduino's."""
        return self.bits == SMALL_BITS


def language() -> object:
    """The grammar of C++."""
    import tree_sitter_cpp

    return tree_sitter_cpp.language()


def with_plain_types(text: str) -> str:
    """The text with ``int`` and ``vector`` for names that it gives to them."""
    plain = [("".join(own), "int") for own in OWN_KIND.findall(text)]
    plain += [(last or first, kind or row) for kind, last, first, row in OWN_ROW.findall(text)]
    for name, kind in plain:
        text = re.sub(rf"\b{name}\b(?=[\s*&]+\w)", kind, text)
    return text


@dataclass(frozen=True)
class Translated:
    """What a file of C++ is in Python.

    Attributes
    ----------
    functions : tuple of callable
    rounded : str
        What is rounded to single precision among doubles; empty for nothing.
    granted : tuple of str
        What has to be so for it to mean what it is in Python, in words.
    """

    functions: tuple[Callable[..., Any], ...]
    rounded: str = ""
    granted: tuple[str, ...] = ()


def in_python(text: str, origin: str, wanted: str | None) -> Translated:
    """The functions of a file of C++ that no other one calls, or the one that is asked for.

    Raises
    ------
    Unread
        For what is not read, by line and column.
    """
    root = parsed(text)
    nodes, twice = functions_of(root)
    if origin.endswith(SMALL) and not wanted and nodes.keys() > SKETCH:
        others = [name for name in nodes if name not in SKETCH]
        raise Unread(f"setup and loop return nothing: name one, --function {others[0]}")
    if not nodes:
        raise Unread("there is no function in it")
    if wanted:
        refuse_absent(wanted, nodes)
    _refuse_outside(root)
    _refuse_conditions(root)
    calls = {name: _calls(node, nodes) for name, node in nodes.items()}
    called = {other for others in calls.values() for other in others}
    chosen = [safe(wanted)] if wanted else [n for n in nodes if n not in called]
    order = _callees_first(chosen, calls, nodes)
    for name in order:  # what stands in others says nothing of these
        if (wrong := twice.get(name) or first_error(nodes[name])) is not None:
            raise wrong if isinstance(wrong, Unread) else refuse(wrong)
    used, unread = {name: nodes[name] for name in order}, unread_types(root)
    refuse_types(root, used, unread)
    refuse_ambiguous(root, used)
    _refuse_constructors(root, used)
    _refuse_destructors(root)
    rounded = _single(root, used)
    bits = SMALL_BITS if origin.endswith(SMALL) else 32
    constants, kinds = _numbers(root, used, bits)
    members = integer_members(root, unread)
    types = [s for s in within(root, "struct_specifier") if s.child_by_field_name("body")]
    heads = (
        (s.child_by_field_name("name") or s.parent.child_by_field_name("declarator"), s)
        for s in types
    )  # typedef struct {...} State
    structs = {words(head): s for head, s in heads if head is not None}
    scopes: dict[str, Scope] = {}
    bodies: dict[str, Page] = {}
    for name in order:
        _refuse_shadows(nodes[name], _meant_otherwise(root, nodes[name]))
        scope = _scope(nodes[name], structs, nodes, scopes, bits)
        scope.constants, scope.kinds = {**constants}, {**kinds, **scope.kinds}
        if shared := {*scope.outputs} & scope.constants.keys():
            raise refuse(nodes[name], f"{joined(sorted(shared))} of the file is changed: pass it")
        scope.overloaded = scope.is_sketch or OVERLOADED.search(text) is not None
        kind = words(nodes[name].child_by_field_name("type") or nodes[name])
        scope.record = tuple(_fields(structs[kind])) if kind in structs and name in chosen else ()
        bodies[name] = Page()
        _set_once(nodes[name], scope.outputs)
        for one in named(nodes[name].child_by_field_name("body")):
            _statement(bodies[name], one, 1, scope)
        _learn_kind(nodes[name], scope)
        if whole := sorted(members & {*scope.free, *scope.outputs}):
            raise refuse(
                nodes[name],
                f"{whole[0]} is an integer, or of a type that is not here: it is not read",
            )
        scopes[name] = scope
    page = Page()
    for name in (n for n in nodes if n in bodies):
        _function(page, nodes[name], name, scopes[name], bodies[name], name in chosen)
    page.constants({n: s.constants for n, s in scopes.items()} or {"": constants})
    own = {name: part for name, part in vars(array_language).items() if callable(part)}
    space = page.module(origin, own)
    called_last = dict.fromkeys(f"{n}()" for name in order for n in scopes[name].granted)
    granted = [f"{joined([*called_last])}, not here, changes nothing of the object"]
    granted = granted if called_last else []
    granted += [f"entries of {n} that {name} does not set are 0"
                for name in order for n in scopes[name].blank]  # fmt: skip
    return Translated(tuple(space[name] for name in chosen), rounded, tuple(granted))


def absent_headers(text: str) -> list[str]:
    """Files of the person's own that a file includes, which may define any name as a macro.

    Parameters
    ----------
    text : str
    """
    paths = (one.child_by_field_name("path") for one in within(parsed(text), "preproc_include"))
    own = [words(path) for path in paths if path is not None and path.type != "system_lib_string"]
    return [path for path in own if not LIBRARIES.match(path)]


def parsed(text: str) -> Any:
    """The tree of a file, where ``(a[1]) - (b)`` is no cast to a type a[1]."""
    text = TEMPLATED.sub(r".template \1", text)
    root = tree(language, text, "tree-sitter-cpp")
    data = bytearray(text.encode())
    for node in within(root, "cast_expression"):
        kind, value = (node.child_by_field_name(f) for f in ("type", "value"))
        name = within(kind, "type_identifier")
        signed = name and "*" not in words(kind) and words(value)[0] in "+-*&"
        if signed and not INTEGERS.search(words(name[0])):
            data[node.start_byte] = data[kind.end_byte] = ord(" ")
    return parsed(data.decode()) if data != text.encode() else root


def without_users(text: str, function: str | None = None, *, c: bool = False) -> str:
    """The text with blanks for functions that only use others; as it is without these.

    ``main`` is one. In C, where all that a file says is read, so is what the function that is asked
    for does not call; where none is asked for, what advances a state by another function that it
    hands numbers. Declarations that nothing else uses go with them. A variable of the file that
    these alone set loses the value that the file begins with.

    Parameters
    ----------
    text : str
    function : str, optional
        Which is asked for.
    c : bool
        Whether it is C, not C++.
    """
    root = tree(language, text, "tree-sitter-cpp")
    nodes = [n for n in within(root, "function_definition") if n.child_by_field_name("type")]
    users = [n for n in nodes if _title(n) == "main"]
    if len(users) > 1:
        return text
    if c:
        calls = {_title(n): {words(i) for i in within(n, "identifier")} for n in nodes}
        kept = reachable({function}, calls) if function in calls else None
        users += [n for n in nodes if n not in users and (
            _is_example(n, calls.keys()) if kept is None else _title(n) not in kept
        )]  # fmt: skip
    users = [n for n in users if not n.has_error]
    if not users or len(users) == len(nodes):
        return text
    others = {name for node in nodes if node not in users for name in _written(node)}
    changed = {name for node in users for name in _written(node)} - others
    parts = [part for part in named(root) if part.type in ("declaration", "type_definition")]
    values = [
        one for part in parts if part.type == "declaration"
        for one in within(part, "init_declarator") if words(within(one, "identifier")[0]) in changed
    ]  # fmt: skip
    spans = [(one.child_by_field_name("declarator").end_byte, one.end_byte) for one in values]
    spans += [(one.start_byte, one.end_byte) for one in users]
    left = _blanked(text, spans)
    for part in parts if c else ():
        span = (part.start_byte, part.end_byte)
        rest = _blanked(left, [span])
        names = {words(within(d, "identifier", "type_identifier")[0])
                 for d in part.children_by_field_name("declarator")}  # fmt: skip
        if not any(re.search(rf"\b{re.escape(name)}\b", rest) for name in names):
            left = rest
    return left


def _blanked(text: str, spans: Iterable[tuple[int, int]]) -> str:
    """The text with blanks for some of its bytes."""
    data = bytearray(text.encode())
    for start, end in spans:
        for k in range(start, end):
            data[k] = data[k] if data[k] in b"\n\r" else ord(" ")
    return data.decode()


def _is_example(node: Any, functions: Collection[str]) -> bool:
    """Whether a function changes what it is given, by another one that it hands numbers."""
    changed = [one.child_by_field_name("left") for one in within(node, "assignment_expression")
               if words(one.child_by_field_name("operator")) != "="]  # fmt: skip
    given = {words(i) for one in within(node, "parameter_declaration")
             for i in within(one, "identifier")}  # fmt: skip
    return any(words(i) in given for one in changed for i in within(one, "identifier")) and any(
        one.type == "number_literal"
        for call in within(node, "call_expression")
        if words(call.child_by_field_name("function")) in functions
        for one in named(call.child_by_field_name("arguments"))
    )


def _written(node: Any) -> set[str]:
    """Names of others that a function sets, or of which it takes the address."""
    own = {
        words(within(one, "identifier")[0])
        for part in within(node, "declaration", "parameter_declaration")
        for one in part.children_by_field_name("declarator") if within(one, "identifier")
    }  # fmt: skip
    places = [one.child_by_field_name("left") for one in within(node, "assignment_expression")]
    places += [one.child_by_field_name("argument") for one in within(node, "update_expression")]
    places += [
        one.child_by_field_name("argument") for one in within(node, "pointer_expression")
        if words(one).startswith("&")
    ]  # fmt: skip
    return {words(i) for place in places for i in (place, *within(place, "identifier"))} - own


def functions_of(root: Any) -> tuple[dict[str, Any], dict[str, Unread]]:
    """Functions by their names, without those that only make objects.

    And what is to be said of two of one name, and of one of the library's.
    """
    nodes: dict[str, Any] = {}
    twice: dict[str, Unread] = {}
    for node in within(root, "function_definition"):
        if node.child_by_field_name("type") is None:
            continue
        name = _title(node)
        if name in nodes or name in LIBRARY or name == "pow":
            twice[name] = refuse(node, f"{name} is the name of two functions: rename it")
        nodes[name] = node
    return nodes, twice


def _refuse_constructors(root: Any, nodes: dict[str, Any]) -> None:
    """Refuse objects that begin with something else in a member than what is passed by its name."""
    parts = ("identifier", "field_identifier")
    used = {words(one) for node in nodes.values() for one in within(node, *parts)}
    members = {words(one) for one in within(root, "field_identifier")}
    for node in within(root, "function_definition"):
        if node.child_by_field_name("type") is not None or words(node).startswith("operator"):
            continue
        for call in within(node, "call_expression"):
            head, given = (call.child_by_field_name(f) for f in ("function", "arguments"))
            own = (head.type == "identifier" and not named(given)) or words(head).startswith("this")
            inside = {words(part) for part in within(given, *parts)}
            if call.parent.type == "expression_statement" and (own or inside & members & used):
                raise refuse(call, "what an object begins with may be changed by it")
        for one in within(node, *CHANGES):
            sign = words(one.child_by_field_name("operator"))
            if sign != "=" and {words(part) for part in within(one, *parts)} & used & members:
                raise refuse(one, "a member of an object is not what is passed by that name")
        for one in within(node, "field_initializer", "assignment_expression"):
            first, *_, last = named(one)
            member = words(within(first, *parts)[-1]) if within(first, *parts) else ""
            values = [words(name) for name in within(last, *parts)]
            key, value = member_key(member), values[-1] if values else ""
            initial = value not in members and value[:1] == key  # m(mass)
            same = bool(value) and (member_key(value) == key or initial)
            plain = not within(last, "binary_expression", "unary_expression", "call_expression")
            if member in used and values and not (same and plain):
                raise refuse(one, f"{member} of an object is not what is passed by that name")


def _refuse_destructors(root: Any) -> None:
    """Refuse what runs where an object ends, which no line says."""
    for node in within(root, "function_definition"):
        declarator, body = (node.child_by_field_name(n) for n in ("declarator", "body"))
        lines = [one for one in named(body) if "comment" not in one.type] if body else []
        if lines and declarator is not None and within(declarator, "destructor_name"):
            raise refuse(node, "a destructor runs where an object ends: it is not read")


def _refuse_outside(root: Any) -> None:
    """Refuse what the grammar does not know outside of functions, and functions of others.

    Raises
    ------
    Unread
    """
    for one in within(root, "ERROR"):
        inside = [one]
        while inside[-1].parent is not None:
            inside.append(inside[-1].parent)
        if not {"function_definition", "template_declaration"} & {node.type for node in inside}:
            raise refuse(one)
    for one in within(root, "using_declaration"):
        space, _, name = words(one).removeprefix("using").strip(" ;").rpartition("::")
        if space not in ("", "std") and (name in LIBRARY or name == "pow"):
            raise refuse(one, f"{name} has another meaning here")


def _refuse_conditions(root: Any) -> None:
    """Refuse what is compiled in some places only, but a guard, a default and C's linkage."""
    for node in within(root, "preproc_if", "preproc_ifdef", "preproc_else", "preproc_elif"):
        name = node.child_by_field_name("name")
        inside = [one for one in named(node) if one != name]
        first = inside[0] if inside else None
        guard = (
            node.type == "preproc_ifdef" and first is not None
            and first.type == "preproc_def"
            and words(first.child_by_field_name("name")) == words(name)
        )  # fmt: skip
        if not guard and (name is None or words(name) != "__cplusplus"):
            raise refuse(node, "what is compiled depends on a condition: write one branch")


def _single(root: Any, nodes: Mapping[str, Any]) -> str:
    """What is rounded to single precision among doubles, in functions and what they use.

    Raises
    ------
    Unread
        Where something is decided as well, or rounded to an integer.
    """
    names = {words(one) for node in nodes.values() for one in within(node, "identifier")}
    outside = [
        one for one in within(root, "declaration", "field_declaration")
        if _owner(one) is None and names & {
            words(n) for n in within(one, "identifier", "field_identifier")
        }
    ]  # fmt: skip
    parts = [*((one, words(one)) for one in outside), *((f, _used_part(f)) for f in nodes.values())]
    doubles = " double" * any(re.search(r"\bdouble\b", text) for _, text in parts)
    parts = [(part, with_float(text, words(root))) for part, text in parts]
    whole = "\n".join(text for _, text in parts)
    tried = [*((part, text + doubles) for part, text in parts), *((p, whole) for p, _ in parts[:1])]
    for part, text in tried:  # the whole: of a call
        if (found := made_single(text)) is not None:
            if not smooth(whole):
                raise refuse(part, f"{found[0]} {ROUNDED}")
            return " ".join(found[0].split())
    return ""


def _used_part(node: Any) -> str:
    """A function without arguments that it does not use."""
    text, body = words(node), node.child_by_field_name("body")
    used = {words(one) for one in within(body, "identifier")}
    for one in within(_declarator(node), "parameter_declaration"):
        names = {words(name) for name in within(one, "identifier")}
        text = text if names & used else text.replace(words(one), "", 1)
    return text


def _numbers(root: Any, nodes: dict[str, Any], bits: int) -> tuple[dict[str, str], dict[str, Kind]]:
    """Macros and constants of the file and of its classes, and the kinds of those of integers.

    Members that are no constants are arguments: a value that objects begin with is none of theirs.
    """
    constants: dict[str, str] = {}
    kinds: dict[str, Kind] = {}
    used = {words(one) for node in nodes.values() for one in within(node, "identifier")}
    tokens = {words(leaf) for node in nodes.values() for leaf in tokens_of(node)}
    for one in within(root, "preproc_def", "preproc_function_def"):
        name = words(one.child_by_field_name("name"))
        body = one.child_by_field_name("value")
        number = words(body).partition("//")[0].partition("/*")[0].strip() if body else ""
        number = number[1:-1].strip() if number[:1] == "(" and number[-1:] == ")" else number
        if name not in tokens or (name not in used and number in (name, "double", "float")):
            continue
        if name not in used or not NUMBER.fullmatch(number) or name in constants:
            raise refuse(one, "a macro that is no number is not read")
        constants[safe(name)] = number.rstrip("fFlLuU")
        if (literal := kind_of_literal(number.lstrip("+-"), bits)) is not None:
            _refuse_inexact(one, number)
            kinds[safe(name)] = literal
    scope = Scope([], {}, {}, {}, constants=constants, kinds=kinds, bits=bits)
    judged = {node.start_byte for node in nodes.values()}
    changed = {
        name for node in within(root, "function_definition") if node.start_byte not in judged
        for name in _written(node)
    }  # fmt: skip
    for node in within(root, "declaration", "field_declaration"):
        fixed = {"const", "constexpr"} & {*words(node).split()}
        if _owner(node) if node.type == "declaration" else not fixed:
            continue
        if node.child_by_field_name("type") is None:  # of a constructor
            continue
        kind = words(node.child_by_field_name("type"))
        values = node.children_by_field_name("default_value")
        for declarator in node.children_by_field_name("declarator"):
            value = declarator.child_by_field_name("value") or (values[0] if values else None)
            if value is None or len(values) > 1:
                continue
            title = words(within(declarator, "identifier", "field_identifier")[0])
            if title in changed and node.type == "declaration":
                continue  # what it begins with is not what it holds
            name = safe(title)
            own = replace(scope, free={}, numbers=True)
            try:
                number = _constant(node, declarator, value, own)
            except Unread:
                if name in used:
                    raise
                continue
            if name in constants:
                raise refuse(node, f"{name} is the name of two numbers: rename one")
            if own.free and name not in used:
                continue
            scope.free |= own.free
            whole = _kind(value, own)
            if is_integral(kind):
                number = _held(node, number, name, kind_of(kind, bits), whole)
                kinds[name] = kind_of(kind, bits)
            elif kind == "auto" and whole:
                kinds[name] = promoted(whole, bits)
            constants[name] = number
    if unknown := scope.free:
        raise refuse(root, f"{', '.join(unknown)}: nothing gives it a value")
    return constants, kinds


def _held(node: Any, value: str, name: str, kind: Kind, given: Kind | None) -> str:
    """A value where an integer of this kind is kept.

    Raises
    ------
    Unread
        For a real number, and for an integer that does not fit.
    """
    if given is None:
        raise refuse(node, "what is rounded to an integer is not read")
    (low, high), what = kind.limits, f"{name} is {kind.words}"
    if WHOLE.fullmatch(value):
        if not low <= int(value) <= high:
            raise refuse(node, f"{what}: {int(value)} does not fit: write it as double")
        return value
    return f"held({value}, {what!r}, {low}, {high})"


def _refuse_inexact(node: Any, number: str) -> None:
    """Refuse an integer that no double is."""
    if WHOLE.fullmatch(number) and abs(int(number.rstrip("uUlL"))) > EXACT:
        raise refuse(node, f"{number} is more than a double holds exactly: write it with a point")


def _meant_otherwise(root: Any, node: Any) -> set[str]:
    """Macros, and functions of the library that are called: no variable can have their names."""
    macros = {
        words(one.child_by_field_name("name"))
        for one in within(root, "preproc_def", "preproc_function_def")
    }
    called = {words(c.child_by_field_name("function")) for c in within(node, "call_expression")}
    return macros | (called & {*LIBRARY, "pow"})


def _refuse_shadows(node: Any, outside: set[str]) -> None:
    """Refuse a name that a block declares again: Python has one variable where C has two.

    Raises
    ------
    Unread
    """
    for one in named(node):
        inside = one.type in ("compound_statement", "for_statement", "if_statement")
        if one.type in ("declaration", "parameter_declaration"):
            for declarator in one.children_by_field_name("declarator"):
                if declarator.type == "init_declarator":
                    declarator = declarator.child_by_field_name("declarator")
                names = within(declarator, "identifier")
                for name in map(words, names[: None if "binding" in declarator.type else 1]):
                    if name in outside:
                        raise refuse(one, f"{name} is declared twice: rename one")
                    outside.add(name)
        else:
            _refuse_shadows(one, {*outside} if inside else outside)


def _constant(node: Any, declarator: Any, value: Any, scope: Scope) -> str:
    """The number that a constant of the file is.

    Raises
    ------
    Unread
    """
    parts = named(value) if value.type == "initializer_list" else [value]
    if len(parts) != 1 or within(declarator, "array_declarator", "function_declarator"):
        raise refuse(node)
    return _value(parts[0], scope)


def _owner(node: Any) -> Any:
    """The function that a declaration stands in; None for one of the file."""
    while node is not None and node.type not in ("function_definition", "lambda_expression"):
        node = node.parent
    return node


def _callees_first(
    chosen: list[str], calls: dict[str, set[str]], nodes: dict[str, Any]
) -> list[str]:
    """The functions that are wanted and those that they call, each behind what it calls.

    Raises
    ------
    Unread
        For one that calls itself.
    """
    order: list[str] = []

    def visit(name: str, above: tuple[str, ...]) -> None:
        if name in above:
            raise refuse(nodes[name], f"{name} calls itself")
        for other in sorted(calls[name]):
            if other not in order:
                visit(other, (*above, name))
        if name not in order:
            order.append(name)

    for name in chosen or list(nodes):
        visit(name, ())
    return order


def _declarator(node: Any) -> Any:
    found = node.child_by_field_name("declarator")
    while found is not None and found.type != "function_declarator":
        found = found.child_by_field_name("declarator")
    if found is None:
        raise refuse(node)
    return found


def arguments_of(node: Any) -> list[str]:
    """Names of what a function takes."""
    parameters = named(_declarator(node).child_by_field_name("parameters"))
    declarators = [one.child_by_field_name("declarator") for one in parameters]
    return [_variable(one) if one is not None else "" for one in declarators]


def shared_of(node: Any) -> set[str]:
    """Arguments that its caller sees changed."""
    parameters = named(_declarator(node).child_by_field_name("parameters"))
    declarators = [one.child_by_field_name("declarator") for one in parameters]
    return {
        _variable(declarator)
        for one, declarator in zip(parameters, declarators, strict=True)
        if declarator is not None and declarator.type != "identifier"
        and "const" not in words(one).split()
    }  # fmt: skip


def _title(node: Any) -> str:
    name = _declarator(node).child_by_field_name("declarator")
    return re.sub(r"\W", "", words(name).split("::")[-1])


def _fields(struct: Any) -> list[str]:
    for one in within(struct, "field_declaration"):
        if is_integral(words(one.child_by_field_name("type"))):
            raise refuse(one, "integers of a struct are not read")
    return [safe(words(one)) for one in within(struct, "field_identifier")]


def _calls(node: Any, functions: dict[str, Any]) -> set[str]:
    heads = (call.child_by_field_name("function") for call in within(node, "call_expression"))
    declared = (one.child_by_field_name("declarator") for one in within(node, "declaration"))
    arrays = {words(name) for one in declared for name in within(one, "identifier")[:1]}
    return {name for head in heads if (name := _called(head)) in functions and name not in arrays}


def _called(head: Any) -> str:
    """f, this->f and Cart::f as the name of a function."""
    return re.split(r"::|this->", words(head))[-1]


def _variable(declarator: Any) -> str:
    """The name that a declarator declares."""
    found = within(declarator, "identifier")
    if not found:
        raise refuse(declarator)
    return safe(words(found[0]))


def _scope(
    node: Any, structs: dict[str, Any], functions: dict[str, Any], printed: dict[str, Scope],
    bits: int,
) -> Scope:  # fmt: skip
    parameters = _declarator(node).child_by_field_name("parameters")
    arguments: list[str] = []
    fields: dict[str, list[str]] = {}
    outputs, references, kinds = [], set(), {}
    open_ones, pointers, defaults = set(), set(), {}
    eigen: set[str] = set()
    for one in named(parameters):
        declarator = one.child_by_field_name("declarator")
        if declarator is None:
            continue
        arguments.append(_variable(declarator))
        if declarator.type in ("pointer_declarator", "array_declarator"):
            pointers.add(arguments[-1])
        kind = words(one.child_by_field_name("type"))
        if kind in structs:
            fields[arguments[-1]] = _fields(structs[kind])
        if EIGEN.search(kind):
            eigen.add(arguments[-1])
        if is_integral(kind):
            kinds[arguments[-1]] = kind_of(kind, bits)
        if kind == "auto" or _is_type(one.child_by_field_name("type")):
            open_ones.add(arguments[-1])
        if (default := one.child_by_field_name("default_value")) is not None:
            defaults[arguments[-1]] = words(default)
        if "const" not in words(one).split() and declarator.type != "identifier":
            outputs.append(arguments[-1])
            if declarator.type == "reference_declarator" and kind in ("double", "float"):
                references.add(arguments[-1])
    parts = [*arguments, *(part for own in fields.values() for part in own)]
    if twice := [n for k, n in enumerate(parts) if n in parts[:k]]:
        raise refuse(node, f"{twice[0]} is the name of two numbers that it takes: rename one")
    scope = Scope(arguments, fields, functions, printed, kinds=kinds, bits=bits)
    scope.references, scope.eigen = references, eigen
    scope.open, scope.pointers, scope.defaults = open_ones, pointers, defaults
    kind = words(node.child_by_field_name("type") or node)
    scope.blank = _blank(node, arguments)
    scope.zeros |= {*scope.blank}
    changed = {
        _root(one.child_by_field_name("left")) for one in within(node, "assignment_expression")
    } | {_root(one) for one in within(node, "update_expression")}
    streamed = {_root(one.child_by_field_name("left")) for one in _streams(node)}
    scope.changed, scope.locals = changed | streamed, changed - {*arguments}
    scope.whole = kind_of(kind, bits) if is_integral(kind) else None
    members = [] if any(o in changed for o in outputs) else _members(node, arguments)
    if members and kind in ("void", "bool"):
        scope.returns, scope.whole, scope.outputs = False, None, members
        scope.references, scope.arguments = references | {*members}, [*arguments, *members]
    elif kind in ("void", "int"):
        scope.returns = False
        scope.outputs = [o for o in outputs if o in changed]
        scope.filled = dict.fromkeys(scope.outputs)
        scope.arguments = [a for a in arguments if a not in scope.filled]
        scope.locals |= scope.filled.keys()
    return scope


def _members(node: Any, arguments: Iterable[str]) -> list[str]:
    """Numbers of its object that a method changes, in the order in which it does first."""
    name = _declarator(node).child_by_field_name("declarator")
    if name.type not in ("qualified_identifier", "field_identifier"):
        return []
    own = {*arguments}
    for one in within(node, "declaration"):
        for declarator in one.children_by_field_name("declarator"):
            own |= {safe(words(part)) for part in within(declarator, "identifier")[:1]}
    found = [
        one.child_by_field_name("left") for one in within(node, "assignment_expression")
        if one.child_by_field_name("left").type == "identifier"
    ]  # fmt: skip
    return [n for n in dict.fromkeys(safe(words(one)) for one in found) if n not in own]


def _blank(node: Any, arguments: Iterable[str]) -> tuple[str, ...]:
    """Matrices that a method has not declared, with entries M(1, 1) that it sets nowhere."""
    name = _declarator(node).child_by_field_name("declarator")
    if name.type not in ("qualified_identifier", "field_identifier"):
        return ()
    own = {*arguments}
    own |= {safe(words(i)) for d in within(node, "declaration") for i in within(d, "identifier")}
    found: dict[str, set[tuple[int, ...]] | None] = {}
    for one in within(node, "assignment_expression"):
        left = one.child_by_field_name("left")
        place = ENTRY.fullmatch(words(left))
        plain = place is not None and words(one.child_by_field_name("operator")) == "="
        if place is None or not plain or one.parent.type != "expression_statement":
            found[_root(left)] = None  # of what is set otherwise nothing is said
        elif (known := found.setdefault(safe(place[1]), set())) is not None:
            known.add((int(place[2]), int(place[3])))
    return tuple(
        one for one, places in found.items()
        if places and one not in own and not _is_set_elsewhere(node, one)
        and len(places) < (max(i for i, _ in places) + 1) * (max(k for _, k in places) + 1)
    )  # fmt: skip


def _is_set_elsewhere(node: Any, name: str) -> bool:
    """Whether the file has a name of a function's object in more than its plain declaration."""
    root = node
    while root.parent is not None:
        root = root.parent
    own = range(node.start_byte, node.end_byte)
    others = [i for i in within(root, "identifier", "field_identifier") if i.start_byte not in own]
    return any(
        one.parent.type != "field_declaration" or one.parent.child_by_field_name("default_value")
        for one in others if safe(words(one)) == name
    )  # fmt: skip


ENTRY = re.compile(r"(\w+)\s*\(\s*(\d)\s*,\s*(\d)\s*\)")


def _streams(node: Any) -> list[Any]:
    """f << a"""
    return [
        one for one in within(node, "binary_expression")
        if words(one.child_by_field_name("operator")) == "<<"
    ]  # fmt: skip


def _lazy(value: Any, scope: Scope) -> set[str]:
    """Vectors and matrices of Eigen of which auto keeps no numbers but how to compute them."""
    found: set[str] = set()
    for one in within(value, "identifier"):
        name, above = safe(words(one)), one.parent
        if above.type not in ("call_expression", "subscript_expression") and name in scope.eigen:
            found |= {name, *scope.lazy.get(name, ())}
    return found


def _changes_later(node: Any, names: set[str]) -> bool:
    """Whether what stands behind a declaration changes one of these names, or a loop is around."""
    function = node
    while function.type != "function_definition":
        function = function.parent
        if function.type in ("for_statement", "while_statement", "do_statement", "for_range_loop"):
            return True
    targets = [one.child_by_field_name("left") for one in (
        *within(function, "assignment_expression"), *_streams(function)
    )]  # fmt: skip
    targets += within(function, "update_expression")
    return any(one.start_byte > node.start_byte and _root(one) in names for one in targets)


def _root(target: Any) -> str:
    return safe(words(within(target, "identifier")[0])) if within(target, "identifier") else ""


def _learn_kind(node: Any, scope: Scope) -> None:
    """The kind of integers that a function returns whose type is what it returns."""
    if words(node.child_by_field_name("type")) != "auto":
        return
    returned = within(node.child_by_field_name("body"), "return_statement")
    kinds = {_kind(named(one)[0], scope) for one in returned if named(one)}
    if len(kinds) > 1:
        raise refuse(node, "what it returns is of several types")
    scope.whole = scope.whole or next(iter(kinds), None)


def _function(page: Page, node: Any, name: str, scope: Scope, body: Page, main: bool) -> None:
    body_of = node.child_by_field_name("body")
    sizes = {
        one.id for new in within(body_of, "new_expression") for one in within(new, "identifier")
    }
    used = {safe(words(one)) for one in within(body_of, "identifier") if one.id not in sizes}
    if not main and scope.references & scope.changed:
        raise refuse(node, f"{name} changes a number of another function: return it")
    if not main and not scope.returns:
        raise refuse(node, f"{name} returns no number, and another function calls it")
    given = [a for a in scope.arguments if a in used or not main]
    if main and (whole := [a for a in given if a in scope.kinds]):
        raise refuse(node, f"{whole[0]} is an integer: it is not read as a number")
    extra = [n for n in scope.free if n not in given]
    page.put(line_of(node), 0, f"def {name}({joined([*given, *extra])}):", opens=True)
    for one, parts in scope.fields.items():
        if one in given:
            page.put(line_of(node), 1, f"{joined(parts)}{',' * (len(parts) == 1)} = {one}")
    for one in scope.filled:
        page.put(line_of(node), 1, f"{one} = None")
    page.compound = False
    for number, text in enumerate(body.lines, start=1):
        if text.strip():
            depth = (len(text) - len(text.lstrip())) // 4
            page.put(number, depth, text.strip(), opens=text.rstrip().endswith(":"))
    if not scope.returns:
        page.compound = True
        page.put(len(page.lines), 1, _end(scope))
    page.compound = True


def _set_once(node: Any, outputs: Iterable[str]) -> None:
    """Refuse an entry of what is filled that is set twice in one block, the first time in vain.

    Raises
    ------
    Unread
    """
    for block in within(node, "compound_statement"):
        done: set[str] = set()
        for line in named(block):
            inner = named(line)[:1] if line.type == "expression_statement" else []
            plain = inner and inner[0].type == "assignment_expression" and (
                words(inner[0].child_by_field_name("operator")) == "="
            )  # fmt: skip
            left, right = (
                (inner[0].child_by_field_name(f) for f in ("left", "right"))
                if plain
                else (None, line)
            )
            used = {safe(words(i)) for i in (right, *within(right, "identifier"))} & {*outputs}
            done -= {key for key in done if key.partition("[")[0] in used}
            if within(line, "return_statement"):
                done = set()
            if left is not None and left.type == "subscript_expression" and _root(left) in outputs:
                key = "".join(words(left).split())
                if key in done:
                    raise refuse(left, f"{key} is set twice: leave one")
                done.add(key)


def _end(scope: Scope) -> str:
    """What a function that returns no number ends with: what it has written."""
    whole = [f"{n} = vector({n})" for n in scope.outputs if n not in scope.references]
    return "; ".join([*whole, f"return {joined(scope.outputs)}"])


def _statement(page: Page, node: Any, depth: int, scope: Scope) -> None:
    line = line_of(node)
    match node.type:
        case "compound_statement":
            for part in named(node):
                _statement(page, part, depth, scope)
            if not named(node):
                page.put(line, depth, "pass")
        case "declaration":
            _declaration(page, node, depth, scope)
        case "using_declaration" | "alias_declaration":
            page.put(line, depth, "pass")
        case "throw_statement":
            page.put(line, depth, "raise ValueError")
        case "expression_statement" if re.fullmatch(r"\(\s*void\s*\)\s*\w+\s*;", words(node)):
            page.put(line, depth, "pass")
        case "expression_statement" if named(node):
            page.put(line, depth, _changed(named(node)[0], scope))
        case "return_statement":
            if scope.returns:
                given = named(node)[0]
                value = _value(given, scope)
                if scope.whole:
                    value = _held(node, value, "what is returned", scope.whole, _kind(given, scope))
                if value in scope.filled:
                    value = f"vector({value})"
                if scope.record:
                    value = f"record({joined([value, *map(repr, scope.record)])})"
                page.put(line, depth, f"return {value}")
            else:
                called = [_called(c.child_by_field_name("function"))
                          for c in within(node, "call_expression")]  # fmt: skip
                scope.granted |= dict.fromkeys(c for c in called if c not in scope.functions)
                if known := [c for c in called if c in scope.functions]:
                    raise refuse(node, f"{known[0]} is called where nothing is returned")
                page.put(line, depth, _end(scope))
        case "if_statement":
            clause = node.child_by_field_name("condition")
            if clause.child_by_field_name("initializer") is not None:
                raise refuse(clause, "put what is done before the condition into a line above")
            condition = clause.child_by_field_name("value")
            page.put(line, depth, f"if {_value(condition, scope)}:", opens=True)
            _statement(page, node.child_by_field_name("consequence"), depth + 1, scope)
            other = node.child_by_field_name("alternative")
            if other is not None:
                page.put(line_of(other), depth, "else:", opens=True)
                _statement(page, named(other)[0], depth + 1, scope)
        case "for_statement":
            page.put(line, depth, _counting(node, scope), opens=True)
            _statement(page, node.child_by_field_name("body"), depth + 1, scope)
        case _:
            raise refuse(node)


def _counting(node: Any, scope: Scope) -> str:
    """for (int i = 0; i < n; ++i)"""
    first, until, step = (
        node.child_by_field_name(f) for f in ("initializer", "condition", "update")
    )
    if first is None or until is None or step is None:
        raise refuse(node)
    plain = re.fullmatch(r"(\w+)\s*<\s*(\w+)", words(until))
    counter = plain[1] if plain else ""
    start = re.fullmatch(rf"(int|size_t|unsigned)\s+{counter}\s*=\s*(\d+)\s*;", words(first))
    if not (plain and start and words(step) in (f"++{counter}", f"{counter}++")):
        raise refuse(node)
    body = node.child_by_field_name("body")
    changed = {_root(one.child_by_field_name("left") or one) for one in within(body, *CHANGES)}
    if changed & {counter, plain[2]}:
        raise refuse(node, "a loop that changes its counter is not read")
    scope.locals.add(counter)
    scope.kinds[counter] = kind_of(start[1], scope.bits)
    return f"for {counter} in range({start[2]}, {plain[2]}):"


def _declaration(page: Page, node: Any, depth: int, scope: Scope) -> None:
    kind = words(node.child_by_field_name("type"))
    for one in node.children_by_field_name("declarator"):
        declarator = one.child_by_field_name("declarator") if one.type == "init_declarator" else one
        value = one.child_by_field_name("value") if one.type == "init_declarator" else None
        line = line_of(one)
        if declarator.type == "structured_binding_declarator":
            names = [safe(words(part)) for part in named(declarator)]
            if _kind(value, scope) is not None:
                raise refuse(one, "integers of a structure are not read: write them with a point")
            scope.locals |= {*names}
            page.put(line, depth, f"{joined(names)} = {_value(value, scope)}")
            continue
        name = _variable(declarator)
        if declarator.type == "reference_declarator" and "const" not in words(node).split():
            raise refuse(one, "a second name of a variable is not read")
        if is_integral(kind):
            whole = value is None or _whole(value, scope)
            if not whole or ("bool" in kind and (value is None or name in scope.changed)):
                raise refuse(one, "what is rounded to an integer is not read")
            if "bool" in kind and re.search(r"\d", words(value)) and not _compared(value):
                raise refuse(one, "what is rounded to an integer is not read")
            scope.kinds[name] = kind_of(kind, scope.bits)
        inner_names = {safe(words(n)) for n in within(value, "identifier")} if value else set()
        second = declarator.type in ("reference_declarator", "pointer_declarator")
        if second and (value is None or value.type != "new_expression") and (
            scope.changed & {name, *inner_names}
        ):  # fmt: skip
            raise refuse(one, "a second name of a variable is not read")
        lasting = "static" in words(node).split()
        if lasting and (name in scope.changed or inner_names & {*scope.arguments, *scope.locals}):
            raise refuse(one, "a static variable keeps what a call leaves: pass it")
        made = value is not None and _eigen(value, scope) is not None
        if SECOND.search(kind):
            raise refuse(one, "a second name of a variable is not read")
        if ENTRYWISE.search(kind):
            raise refuse(one, "an Array of rows and columns multiplies entries: use a Matrix")
        lazy = _lazy(value, scope) if kind == "auto" and value is not None else set()
        lazy |= inner_names if made and kind == "auto" else set()
        if lazy and _changes_later(one, {name, *lazy}):
            raise refuse(one, "auto keeps no numbers of Eigen: write the type")
        if EIGEN.search(kind) or lazy:
            scope.eigen.add(name)
            scope.lazy[name] = lazy
        target = value and _pointed(value, scope)
        if target:
            scope.aliases[name] = target
            continue
        given = _kind(value, scope) if kind == "auto" and value is not None else None
        if given is not None:
            scope.kinds[name] = promoted(given, scope.bits)
        array = declarator.type == "array_declarator"
        inner = named(value) if value is not None and value.type == "initializer_list" else []
        number = inner[0] if len(inner) == 1 and _is_scalar(kind) and not array else value
        plain = value is None or (number is not None and number.type == "number_literal")
        if plain and any(name in parts for parts in scope.fields.values()):
            raise refuse(one, f"{name} is a field of what it takes, too: rename one")
        if number is not None and number.type == "number_literal" and name not in scope.locals:
            text = _number(number)
            if is_integral(kind):
                text = _held(one, text, name, scope.kinds[name], _kind(number, scope))
            if scope.constants.get(name, text) != text:
                raise refuse(one, f"{name} is the name of two numbers: rename one")
            scope.constants[name] = text
            continue
        if side := re.search(r"\bMatrix([234])[df]|, *(\d+) *>", kind):
            scope.shapes[name] = int(side[1] or side[2])
        scope.locals.add(name)
        given = value if value is not None and value.type == "argument_list" else None
        entries = None if given is None or array else _made_of_entries(kind, given, scope)
        if entries is not None:
            page.put(line, depth, f"{name} = {entries}")
            continue
        if value is not None and value.type == "argument_list" and not _is_scalar(kind):
            sizes = named(value)
            if len(sizes) == 2 and re.fullmatch(r"0(?:\.0*)?", words(sizes[1])):
                sizes = sizes[:1]  # entries of 0
            many = len(sizes) > (2 if "Matrix" in kind else 1)
            if many or not SIZED.search(kind) or not all(_whole(n, scope) for n in sizes):
                raise refuse(one, "what an object is made of is not read: set its entries")
        new = value if value is not None and value.type == "new_expression" else None
        if new is not None and new.child_by_field_name("arguments") is not None:
            raise refuse(one, "what an object is made of is not read: set its entries")
        bare = value is not None and value.type == "initializer_list" and not inner
        if value is not None and (bare or value.type != "new_expression") and "X" not in kind:
            scope.zeros.add(name)
        empty = value is not None and (
            value.type == "new_expression" or (bare and not _is_scalar(kind))
        )
        if value is None or empty or (value.type == "argument_list" and not _is_scalar(kind)):
            page.put(line, depth, f"{name} = None")
        else:
            if value.type == "initializer_list" and _is_scalar(kind) and not array:
                text = _value(inner[0], scope) if inner else "0" if is_integral(kind) else "0.0"
            elif array and inner and all(n.type != "initializer_list" for n in inner) and (
                declarator.child_by_field_name("declarator").type == "array_declarator"
            ):  # fmt: skip
                raise refuse(one, "put each row of a matrix into brackets of its own")
            else:
                nested = len(inner) == 1 and inner[0].type == "initializer_list"
                text = _value(inner[0] if nested and "array<" in kind else value, scope)
            if is_integral(kind) and not _compared(value):
                text = _held(one, text, name, scope.kinds[name], _kind(value, scope))
            if text != name and any(name in parts for parts in scope.fields.values()):
                raise refuse(one, f"{name} is a field of what it takes, too: rename one")
            page.put(line, depth, f"{name} = {text}")


def _is_scalar(kind: str) -> bool:
    return kind in ("double", "float", "auto") or (is_integral(kind) and "<" not in kind)


def _compared(node: Any) -> bool:
    """Whether it is true or false."""
    if node.type == "parenthesized_expression":
        return _compared(named(node)[0])
    sign = node.child_by_field_name("operator")
    return sign is not None and words(sign) in (*COMPARED, "&&", "||", "!")


def _pointed(value: Any, scope: Scope) -> str:
    """The argument that a pointer of another type points to."""
    cast = value.type == "cast_expression" or words(value).startswith(
        ("static_cast", "reinterpret_")
    )
    names = [safe(words(one)) for one in within(value, "identifier")]
    return names[-1] if cast and "*" in words(value) and names[-1] in scope.arguments else ""


def _changed(node: Any, scope: Scope) -> str:
    if node.type == "update_expression":
        name, sign = _read(_root(node), scope), words(node.child_by_field_name("operator"))[0]
        if node.child_by_field_name("argument").type != "identifier":
            raise refuse(node)
        value = f"({name} {sign} 1)"
        if name in scope.kinds:
            value = _held(node, value, name, scope.kinds[name], scope.kinds[name])
        return f"{name} = {value}"
    if node.type in ("comma_expression", "binary_expression"):
        return _streamed(node, scope)
    if node.type == "call_expression" and (name := _called(named(node)[0])) not in scope.functions:
        raise refuse_call(node, name, named(node)[1:])
    if node.type != "assignment_expression":
        raise refuse(node)
    left, right = (node.child_by_field_name(f) for f in ("left", "right"))
    sign, value = words(node.child_by_field_name("operator")), _value(right, scope)
    if sign != "=":
        if sign[0] not in OPERATIONS:
            raise refuse(node)
        value = _computed(sign[0], (left, right), (_value(left, scope), value), scope)
    if (kind := scope.kinds.get(_root(left))) is not None:
        value = _held(node, value, words(left), kind, _kind(right, scope))
    if left.type == "identifier":
        name = safe(words(left))
        if name in scope.pointers:
            raise refuse(node, f"{name} is another array from here on: write its entries")
        scope.locals.add(name)
        return f"{name} = {value}"
    part = _part(left, scope)
    name, indices = part if part is not None else _entry(left, scope)
    if name in scope.arguments or name in scope.fields:
        raise refuse(left)
    if name not in scope.locals or name not in scope.filled:
        scope.locals.add(name)
        scope.filled.setdefault(name)
    if part is not None:
        unset = ["0"] if name in scope.zeros else []
        return f"{name} = laid({joined([name, value, *indices, *unset])})"
    put = "put" if name in scope.zeros else "lay"
    return f"{name} = {put}({joined([name, value, *(f'({i}) + 1' for i in indices)])})"


def _streamed(node: Any, scope: Scope) -> str:
    """f << a, b"""
    first = node
    parts: list[Any] = []
    while first.type == "comma_expression":
        if parts:
            raise refuse(node)
        first, rest = (first.child_by_field_name(f) for f in ("left", "right"))
        while rest.type == "comma_expression":
            parts.append(rest.child_by_field_name("left"))
            rest = rest.child_by_field_name("right")
        parts.append(rest)
    if first.type != "binary_expression":
        raise refuse(node)
    name = safe(words(first.child_by_field_name("left")))
    if words(first.child_by_field_name("operator")) != "<<" or name not in scope.locals:
        raise refuse(node)
    values = [_value(one, scope) for one in (first.child_by_field_name("right"), *parts)]
    width = scope.shapes.get(name, 1)
    rows = (values[k : k + width] for k in range(0, len(values), width))
    return f"{name} = block({joined([f'({joined(row)},)' for row in rows])})"


def _entry(node: Any, scope: Scope) -> tuple[str, list[str]]:
    """x[1], x.at(1), x(1) and x.y() as an array and its indices."""
    found = _method(node)
    if found is not None and found[1] in COORDINATES and not found[2]:
        owner = safe(words(found[0]))
        if found[0].type != "identifier" or owner not in scope.eigen:
            raise refuse(node)
        return scope.aliases.get(owner, owner), [str(COORDINATES.index(found[1]))]
    if node.type == "subscript_expression":
        head, given = node.child_by_field_name("argument"), node.child_by_field_name("indices")
        if len(named(given)) != 1:
            raise refuse(node, "a[i, j] is a[j], by the operator with a comma: write a[i][j]")
    elif node.type == "call_expression":
        head, given = (node.child_by_field_name(f) for f in ("function", "arguments"))
        if head.type == "field_expression" and words(head).endswith(".at"):
            head = head.child_by_field_name("argument")
    else:
        raise refuse(node)
    if head.type == "subscript_expression":
        name, before = _entry(head, scope)
    elif head.type == "identifier":
        name, before = safe(words(head)), []
    else:
        raise refuse(node)
    return scope.aliases.get(name, name), [*before, *(_value(part, scope) for part in named(given))]


def _number(node: Any) -> str:
    text = words(node).replace("'", "")
    if not NUMBER.fullmatch(text):
        raise refuse(node)
    _refuse_inexact(node, text)
    return text.rstrip("fFlLuU")


def _read(name: str, scope: Scope) -> str:
    name = scope.aliases.get(name, name)
    own = name in scope.locals or name in scope.arguments or name in scope.constants
    if name in CONSTANTS and not own:
        return CONSTANTS[name]
    if not own:
        scope.free.setdefault(name)
    return name


def _whole(node: Any, scope: Scope) -> bool:
    """Whether it is an integer of C."""
    return _kind(node, scope) is not None


def _kind(node: Any, scope: Scope) -> Kind | None:
    """The kind of an integer; None for what is no integer."""
    parts: list[Any] = []
    plain = Kind("int", scope.bits)
    match node.type:
        case "number_literal":
            return kind_of_literal(words(node).replace("'", ""), scope.bits)
        case "true" | "false":
            return plain
        case "identifier" | "qualified_identifier":
            return scope.kinds.get(safe(words(node).split("::")[-1]))
        case "subscript_expression":
            return scope.kinds.get(_root(node))
        case "field_expression" if node.child_by_field_name("argument").type == "this":
            return scope.kinds.get(words(node.child_by_field_name("field")))
        case "unary_expression" | "binary_expression" if _compared(node):
            return plain
        case "parenthesized_expression" | "initializer_list" | "binary_expression":
            parts = named(node)
        case "unary_expression":
            parts = [node.child_by_field_name("argument")]
        case "conditional_expression":
            parts = [node.child_by_field_name(f) for f in ("consequence", "alternative")]
        case "call_expression":
            name = _called(node.child_by_field_name("function"))
            if name.endswith(".size"):
                return kind_of("size_t", scope.bits)
            if name in scope.printed:
                return scope.printed[name].whole
            if name in scope.locals and name in scope.kinds:  # v(1) of an array
                return scope.kinds[name]
            if name in ("abs", "max", "min"):
                parts = named(node.child_by_field_name("arguments"))
    kinds = [_kind(part, scope) for part in parts]
    if node.type == "initializer_list" and not kinds:
        return plain
    if not kinds or None in kinds:
        return None
    return reduce(lambda a, b: joined_kind(a, b, scope.bits), kinds, kinds[0])


def _value(node: Any, scope: Scope) -> str:
    match node.type:
        case "number_literal":
            return _number(node)
        case "true" | "false":
            return words(node).title()
        case "identifier":
            return _read(safe(words(node)), scope)
        case "qualified_identifier":
            return _read(safe(words(node).split("::")[-1]), scope)
        case "parenthesized_expression":
            return f"({_value(named(node)[0], scope)})"
        case "unary_expression":
            sign = words(node.child_by_field_name("operator"))
            inner = _value(node.child_by_field_name("argument"), scope)
            if sign not in ("+", "-", "!"):
                raise refuse(node)
            value = f"({'not ' if sign == '!' else sign}{inner})"
            kind = _kind(node, scope) if sign == "-" else None
            return _limited(value, kind) if kind else value
        case "binary_expression":
            return _binary(node, scope)
        case "conditional_expression":
            parts = [
                node.child_by_field_name(f) for f in ("consequence", "condition", "alternative")
            ]
            if None in parts:  # a ?: b
                raise refuse(node)
            yes, condition, no = (_value(part, scope) for part in parts)
            return f"({yes} if {condition} else {no})"
        case "initializer_list":
            rows = [named(part) for part in named(node) if part.type == "initializer_list"]
            if rows and len(rows) < len(named(node)):
                raise refuse(node)
            return _block(rows or [[part] for part in named(node)], scope)
        case "compound_literal_expression" if is_integral(words(node.child_by_field_name("type"))):
            raise refuse(node, "what is made an integer is not read: write it as double")
        case "compound_literal_expression":
            return _value(node.child_by_field_name("value"), scope)
        case "cast_expression" if words(node.child_by_field_name("type")) in ("double", "float"):
            return _value(node.child_by_field_name("value"), scope)
        case "field_expression":
            return _field(node, scope)
        case "subscript_expression":
            return _place(node, scope)
        case "call_expression":
            return _call(node, scope)
    raise refuse(node)


def _block(rows: Sequence[Sequence[Any]], scope: Scope) -> str:
    """An array of its entries, row by row."""
    entries = (joined([_value(part, scope) for part in row]) for row in rows)
    return f"block({joined([f'({row},)' for row in entries])})"


def _made_of_entries(kind: str, given: Any, scope: Scope) -> str | None:
    """A vector of Eigen that is made of all its entries; None for what is made otherwise."""
    size, parts = VECTOR.fullmatch(kind), named(given)
    if size is None or len(parts) != int(size[1]):
        return None
    return _block([[part] for part in parts], scope)


def _binary(node: Any, scope: Scope) -> str:
    sides = [node.child_by_field_name(f) for f in ("left", "right")]
    sign = words(node.child_by_field_name("operator"))
    left, right = (_value(side, scope) for side in sides)
    if sign in OPERATIONS:
        return _computed(sign, (sides[0], sides[1]), (left, right), scope)
    one, other = (_kind(side, scope) for side in sides)
    if one is not None and other is not None and sign in (*COMPARED, "/"):
        both = joined_kind(one, other, scope.bits)
        if both.unsigned:  # C++ makes both so
            left, right = _limited(left, both), _limited(right, both)
    if sign == "/":
        if all(_whole(side, scope) for side in sides):
            return f"quotient({left}, {right})"
        return f"({left} / {right})"
    if sign in ("&&", "||"):  # in Python one of the sides, in C++ true or false
        return f"(True if {left} {'and' if sign == '&&' else 'or'} {right} else False)"
    if sign in COMPARED:
        return f"({left} {sign} {right})"
    raise refuse(node)


def _computed(sign: str, sides: tuple[Any, Any], values: tuple[str, str], scope: Scope) -> str:
    """A sum, difference or product, in the kind of integers that C++ computes it in."""
    one, other = (_kind(side, scope) for side in sides)
    both = None if one is None or other is None else joined_kind(one, other, scope.bits)
    left, right = (_limited(v, both) if both and both.unsigned else v for v in values)
    plain = f"({left} {sign} {right})"
    value = plain if scope.numbers else f"{OPERATIONS[sign]}({left}, {right})"
    return _limited(value, both) if both else value


def _limited(value: str, kind: Kind) -> str:
    """A value that is computed in a kind of integers, and not changed by that."""
    what = "a number without a sign (unsigned)" if kind.unsigned else f"{kind.bits} bits"
    low, high = kind.limits
    return f"held({value}, {what!r}, {low}, {high})"


def _field(node: Any, scope: Scope) -> str:
    head, part = (
        node.child_by_field_name("argument"),
        safe(words(node.child_by_field_name("field"))),
    )
    if head.type == "this":
        return _read(part, scope)
    name = safe(words(head))
    if part in scope.fields.get(name, ()):
        return part
    if head.type == "identifier" and name in scope.arguments:
        return f"{name}.{part}"
    raise refuse(node)


def _place(node: Any, scope: Scope) -> str:
    name, indices = _entry(node, scope)
    name = _read(name, scope)
    if name in scope.arguments or name in scope.free:
        if node.type == "call_expression" and len(indices) == 2 and indices[1] == "0":
            indices = indices[:1]  # a column
        return f"{name}[{joined(indices)}]"
    return f"get({joined([name, *(f'({i}) + 1' for i in indices)])})"


def _method(node: Any) -> tuple[Any, str, list[Any]] | None:
    """x.head<2>() as x, head and what says which; None for no call of a method."""
    head = node.child_by_field_name("function") if node.type == "call_expression" else None
    if head is None or head.type != "field_expression":
        return None
    field_of = head.child_by_field_name("field")
    given = named(node.child_by_field_name("arguments"))
    if field_of.type == "dependent_name":
        (field_of,) = named(field_of)
    if field_of.type == "template_method":
        name, *kinds = named(field_of)
        given = [*given, *(part for kind in kinds for part in named(kind))]
        field_of = name
    return head.child_by_field_name("argument"), words(field_of), given


def _part(node: Any, scope: Scope) -> tuple[str, list[str]] | None:
    """x.segment(1, 2), which is set, as x, its first place and how many it has."""
    found = _method(node)
    if found is None or found[1] not in ("segment", "head"):
        return None
    owner, what, given = found
    if safe(words(owner)) not in scope.eigen or len(given) != PARTS[what]:
        raise refuse(node)
    values = [_value(part, scope) for part in given]
    return safe(words(owner)), values if what == "segment" else ["0", *values]


def _eigen(node: Any, scope: Scope) -> str | None:
    """What Eigen has of vectors and matrices; None for other things."""
    found = _method(node)
    if found is None:
        return None
    owner, what, given = found
    if what == "solve" and len(given) == 1:
        inner = _method(owner)
        if inner is None or inner[1] not in DECOMPOSED or inner[2]:
            return None
        matrix = _of_eigen(inner[0], scope)
        return None if matrix is None else f"under({matrix}, {_value(given[0], scope)})"
    if (what not in PARTS and what not in WHOLES) or len(given) != PARTS.get(what, 0):
        return None
    array = _of_eigen(owner, scope)
    if array is None or what in WHOLES:
        return array and f"{WHOLES[what]}({array})"
    texts = [words(part) for part in given]
    values = [_value(part, scope) for part in given]
    if array in scope.arguments and all(WHOLE.fullmatch(text) for text in texts):
        first, count = (0, int(texts[0])) if what != "segment" else map(int, texts)
        part = f"-{count}:" if what == "tail" else f"{first}:{first + count}"
        return f"exactly({array}[{part}], {count})"
    if what == "tail":
        return f"segment({array}, size({array}, 0, 1) - {values[0]}, {values[0]})"
    return f"segment({joined([array, *(['0'] if what == 'head' else []), *values])})"


def _of_eigen(node: Any, scope: Scope) -> str | None:
    """An array of Eigen, by its name or made of others."""
    if node.type == "identifier" and safe(words(node)) in scope.eigen:
        return _read(safe(words(node)), scope)
    return _eigen(node, scope)


def _call(node: Any, scope: Scope) -> str:
    head, given = (node.child_by_field_name(f) for f in ("function", "arguments"))
    name = _called(head)
    if (found := _eigen(node, scope)) is not None:
        return found
    if name in scope.printed and name not in scope.locals:
        return _call_of(name, node, scope)
    if head.type == "field_expression" or head.type == "subscript_expression":
        return _place(node, scope)
    if (entries := _made_of_entries(words(head), given, scope)) is not None:
        return entries
    casts = ("static_cast<double>", "static_cast<float>", "double", "float")
    if (words(head).startswith(casts) or _is_type(head)) and len(named(given)) == 1:
        return _value(named(given)[0], scope)
    if "::" in words(head) and not re.match(r"(?:std|Eigen|this)?::", words(head)):
        raise refuse(node)
    plain = name[:-1] if name.endswith("f") and name[:-1] in {*LIBRARY, "pow"} else name
    if plain == "pow":
        base, power = (_value(part, scope) for part in named(given))
        return f"power({base}, {power})"
    if name in PAIRS:
        if any(_whole(part, scope) and words(part) != "0" for part in named(given)):
            raise refuse(node, "integers of a structure are not read: write them with a point")
        return f"block({joined([f'({_value(part, scope)},)' for part in named(given)])})"
    if words(head) == "abs" and not (scope.overloaded or _whole(named(given)[0], scope)):
        raise refuse(node, "abs may be the one of integers here: write std::abs")
    if plain in LIBRARY:
        return f"np.{LIBRARY[plain]}({joined([_value(part, scope) for part in named(given)])})"
    own = {*scope.functions, *scope.locals, *scope.arguments}
    if name == SQUARE and scope.is_sketch and name not in own and len(named(given)) == 1:
        if _whole(named(given)[0], scope):
            raise refuse(node, "the square of an integer is one, too: write it with a point")
        return f"power({_value(named(given)[0], scope)}, 2)"
    if name in {*UNREAD, SQUARE} - own:
        raise refuse(node, f"the call {name}() is not supported")
    if head.type == "identifier" and name not in scope.functions:
        return _place(node, scope)
    raise refuse(node)


def _is_type(name: Any) -> bool:
    """Whether a name is what a template leaves open: T in template <typename T>."""
    node = name
    while node is not None and node.type != "template_declaration":
        node = node.parent
    parameters = node and node.child_by_field_name("parameters")
    return bool(parameters) and words(name) in map(
        words, within(parameters, "type_identifier", "identifier")
    )


def _call_of(name: str, node: Any, scope: Scope) -> str:
    """A call of a function of the file, which is passed the members that it reads."""
    callee, given = scope.printed[name], named(node.child_by_field_name("arguments"))
    for argument, value in zip(callee.arguments, given, strict=False):
        if argument in callee.open and _whole(value, scope):
            raise refuse(value, f"{argument} of {name} is an integer here: write its type")
    left = [callee.defaults.get(argument, "") for argument in callee.arguments[len(given) :]]
    if strange := [text for text in left if not NUMBER.fullmatch(text)]:
        raise refuse(node, f"{strange[0] or 'an argument'} of {name} is not read: pass it")
    passed = [n for n in callee.free if n not in callee.arguments]
    numbers = {words(i) for one in within(_owner(node), "declaration")
               for d in one.children_by_field_name("declarator")
               for i in within(d, "identifier")[:1]}  # fmt: skip
    own = {*scope.locals, *scope.arguments, *map(safe, numbers)}
    if hidden := [n for n in passed if n in own]:
        raise refuse(node, f"{', '.join(hidden)} means two things: rename one")
    passed_values = [
        _held(v, _value(v, scope), argument, callee.kinds[argument], _kind(v, scope))
        if argument in callee.kinds and argument in callee.arguments else _value(v, scope)
        for argument, v in zip(callee.arguments, given, strict=False)
    ]  # fmt: skip
    for argument, text in zip(callee.arguments[len(given) :], left, strict=True):
        if argument in callee.kinds:
            _held(node, text, argument, callee.kinds[argument], kind_of_literal(text, scope.bits))
    values = [*passed_values, *left, *(_read(n, scope) for n in passed)]
    return f"{name}({joined(values)})"
