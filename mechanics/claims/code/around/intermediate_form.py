"""Statements of C, C++, MATLAB and Julia in one form, as far as they move numbers about.

    y[0] += h*k[1];   y(1) = y(1) + h*k(2)        set(entry(y, 1), ...)
    @(t, y) rate(t, y)                            handle(t y, call(rate, t, y))

What has no such form is `other`, with its parts, so that the names in it are still seen.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from mechanics.claims.code.around.whole_arithmetic import is_whole, limits_of, type_of
from mechanics.claims.code.translation import cpp_functions, matlab
from mechanics.claims.code.translation.python_page import named, within, words

BLOCKS = ("block", "compound_statement", "expression_statement", "source_file", "else_clause",
          "elseif_clause", "macro_argument_list", "let_statement", "argument",
          "translation_unit", "comma_expression")  # fmt: skip
LISTS = ("matrix", "row", "vector_expression", "matrix_expression", "matrix_row",
         "initializer_list", "tuple_expression", "open_tuple", "cell",
         "multioutput_variable")  # fmt: skip
BRACKETS = ("parenthesis", "parenthesized_expression", "condition_clause", "postfix_operator",
            "adjoint_expression", "typed_expression")  # fmt: skip
COMMAND = re.compile(r"([^\W\d]\w*)\s*([-+*/])=\s*(.+)", re.DOTALL)
"""``x += 2``, which the grammar of MATLAB takes for a command."""
KEY = re.compile(r"(?::(?=\w)|\")([^\W\d]\w*)\"?")
"""``:m`` and ``"m"``, keys of a record of Julia."""
SHORT = ("&&", "||", "and", "or")
"""Whose right side may not be run."""
CHANGED = ("assignment_expression", "compound_assignment_expression", "update_expression",
           "assignment", "call_expression")  # fmt: skip
SHARES = re.compile(r"span|view|reference_wrapper|iterator|\bMap\b|\bRef\b")
"""Types that share the entries of what they are made of."""
INTEGER = re.compile(r"\b(int\w*|long|short|char|unsigned|bool)\b")
NARROW = 2**15
"""Types of integers that hold no more are watched for numbers that are too large."""
SHAPES = {"pointer_declarator": "*", "reference_declarator": "&", "array_declarator": "[]"}
ROWS = re.compile(
    r"(?:double|float|int|long|auto|\w+_t|\w+(?=.*=\s*&))\s*"
    r"\(\s*([*&])\s*(\w+)\s*\)\s*\[[^]]*\](?:\s*=(?!=)|$)"
)
"""``double (*p)[2] = &y``, which the grammar of C++ takes for an entry of what a call gives."""
NUMBERS = re.compile(r"[\d.eEfFuUlL\s()+*/-]*\d[\d.eEfFuUlL\s()+*/-]*[*/+-][\d.eEfFuUlL\s()+*/-]*")
LOOPS = ("for_statement", "while_statement", "do_statement", "for_range_loop")
CHANGES = ("copy", "collect", "vec", "deepcopy", "double")
"""Calls that leave a value as it is."""


EITHER = "either"
"""The name of a choice whose value is that of one of its parts."""


@dataclass(frozen=True)
class Term:
    """A statement or a formula.

    Attributes
    ----------
    kind : str
        number, name, entry, field, call, minus, binary, list, handle, whole, range, other; set,
        loop, case, block, return, jump (break, continue, goto), choice (one of its parts, or what
        is made of them). Of C, too: integer (what a type of integers, its limits the name, holds of
        a number). Of Python, too: star and absent (arguments that are spread, and left
        out), item (of such), turn (an angle brought back into one turn, and what that is). Of C:
        type (what a name is declared with; its parts are what the name is another one of).
    name : str
        Or the operation, or names of what a handle takes.
    parts : tuple of Term
    text : str
        As its author wrote it.
    """

    kind: str
    name: str = ""
    parts: tuple["Term", ...] = ()
    text: str = ""

    def all(self) -> Iterator["Term"]:
        """It and all that it is made of."""
        yield self
        for part in self.parts:
            yield from part.all()

    def names(self) -> set[str]:
        """Names of what it uses, calls included."""
        return {one.name for one in self.all() if one.kind in ("name", "call", "field")}


def term(node: Any) -> Term:
    """A node of one of the three grammars."""
    text = " ".join(words(node).split())
    return replace(_term(node, text), text=text)


def with_names(one: Term, title: Callable[[str], str]) -> Term:
    """A term with its names as Python has them."""
    parts = tuple(with_names(part, title) for part in one.parts)
    if one.kind in ("name", "call", "field", "loop"):
        return replace(one, name=title(one.name), parts=parts)
    if one.kind == "handle":
        return replace(one, name=" ".join(map(title, one.name.split())), parts=parts)
    return replace(one, parts=parts)


def _parts(nodes: list[Any]) -> tuple[Term, ...]:
    return tuple(map(term, nodes))


def _term(node: Any, text: str) -> Term:
    parts = [p for p in named(node) if p.type != "operator"]
    match node.type:
        case "identifier" | "field_identifier":
            return Term("name", text)
        case "number" | "number_literal" | "integer_literal" | "float_literal":
            return Term("number", text.rstrip("fFlL"))
        case "range" | "range_expression" if len(parts) == 2:
            return Term("range", "", _parts(parts))
        case "spread_operator":
            return Term("whole")
        case kind if kind in BLOCKS:
            return Term("block", "", _parts(parts))
        case kind if kind in BRACKETS and len(parts) == 1:
            return term(parts[0])
        case kind if kind in BRACKETS:
            return Term("block", "", _parts(parts))
        case "cast_expression" if INTEGER.search(words(parts[0])) and "*" not in words(parts[0]):
            return Term("other", "", (term(parts[-1]),))
        case "cast_expression" if words(parts[0]) in ("float", "half"):
            return Term("call", "float", (term(parts[-1]),))
        case "cast_expression":
            return term(parts[-1])
        case kind if kind in LISTS:
            flat: list[Term] = []
            for part in parts:
                one = Term("whole") if words(part) == ":" else term(part)
                flat += one.parts if part.type in ("row", "matrix_row") else [one]
            return Term("list", "", tuple(flat))
        case "unary_operator" | "unary_expression" if text[0] in "+-" and len(parts) == 1:
            return Term("minus", "", _parts(parts)) if text[0] == "-" else term(parts[0])
        case "binary_operator" | "binary_expression" if len(parts) == 2:
            sign = next((words(c) for c in node.children if not c.is_named), "")
            sign = next((words(c) for c in named(node) if c.type == "operator"), sign)
            if sign in SHORT:
                return Term("choice", "", _parts(parts))
            return _arithmetic(node, sign.strip("."), parts)
        case "juxtaposition_expression" if len(parts) == 2:
            return Term("binary", "*", _parts(parts))
        case "function_call" | "call_expression" | "broadcast_call_expression" if parts:
            return _copied(_call(parts))
        case "assignment_expression" | "subscript_expression" if row := ROWS.match(text):
            return _row_pointer(row, parts if node.type == "assignment_expression" else [])
        case "index_expression" | "subscript_expression" if len(parts) == 2:
            places = [Term("whole") if words(p) == ":" else term(p) for p in _inside(parts[1])]
            base = term(parts[0])
            if len(places) == 1 and (key := KEY.fullmatch(places[0].text)) is not None:
                return Term("field", key[1], (base,))
            if base.kind == "entry":
                return Term("entry", "", (*base.parts, *places))
            return Term("entry", "", (base, *places))
        case "field_expression" if len(parts) == 2:
            return Term("field", words(parts[1]), (term(parts[0]),))
        case "handle_operator":
            return term(parts[0])
        case "pointer_expression" if parts[0].type == "identifier":
            return term(parts[0])
        case "lambda" | "arrow_function_expression" if parts:
            taken = " ".join(re.findall(r"[^\W\d]\w*|~", words(parts[0]))) if parts[1:] else ""
            return Term("handle", taken, (term(parts[-1]),))
        case "lambda_expression":
            lists = [p for p in parts if p.type == "abstract_function_declarator"]
            taken = " ".join(re.findall(r"([^\W\d]\w*)\s*(?:\[\w*\]\s*)?[,)]",
                                        words(lists[0]))) if lists else ""  # fmt: skip
            return Term("handle", taken, (term(parts[-1]),))
        case "assignment" | "assignment_expression" | "compound_assignment_expression":
            return _set(node, parts)
        case "command" if (found := COMMAND.fullmatch(words(node))) is not None:
            name, sign, value = found.groups()
            root = matlab.parsed(f"{name} = {name} {sign} ({value});")
            return term(named(root)[0])
        case "update_expression":
            sign = "+" if "++" in text else "-"
            return Term("set", sign, (term(parts[0]), Term("number", "1")))
        case "labeled_statement":
            return Term("block", "", _parts(parts[1:]))
        case "declaration":
            return Term("block", "", tuple(_declared(node)))
        case "let_binding" if len(parts) == 2:
            return Term("set", "", _parts(parts))
        case "named_field" | "initializer_pair" | "named_argument" if len(parts) == 2:
            return Term("set", "", (Term("name", words(parts[0]).strip(".")), term(parts[1])))
        case kind if kind in LOOPS:
            return _loop(node, parts)
        case "if_statement" | "switch_statement" | "try_statement":
            return Term("case", "", _parts(parts))
        case "break_statement" | "continue_statement" | "goto_statement":
            return Term("jump", node.type.partition("_")[0])
        case "return_statement":
            return Term("return", "", _parts(parts))
        case "macrocall_expression" if words(parts[0]) in ("@test", "@assert"):
            return Term("call", words(parts[0])[1:], _parts(parts[1:]))
        case "macrocall_expression":
            return Term("block", "", _parts(parts[1:]))
        case "preproc_def" if len(parts) == 2:
            return Term("set", "", (Term("name", words(parts[0])), _macro(words(parts[1]))))
        case "string" if re.fullmatch(r"(['\"])[^\W\d]\w*\1", text):  # ode45('rate', ...)
            return Term("name", text[1:-1])
        case "function_definition" | "string" | "string_literal" | "comment" | "line_comment":
            return Term("other")
        case _:
            return Term("other", "", _parts(named(node)))


def _macro(text: str) -> Term:
    """The value of a macro, as far as it is a formula of numbers."""
    if not NUMBERS.fullmatch(text):
        return Term("number", text)
    root = cpp_functions.parsed(f"auto macro = {text.rstrip(';')};")
    return next(one.parts[1] for one in term(root).all() if one.kind == "set")


POWERS = frozenset(("^", ".^"))


def _arithmetic(node: Any, sign: str, parts: list[Any]) -> Term:
    """An operation; of two integers of C it is another one: 1/6 is 0, 10^2 no power."""
    of_c = node.child_by_field_name("operator") is not None
    inner = {words(c) for c in parts[0].children} if parts[0].type == "binary_expression" else {}
    if not of_c and sign in POWERS and POWERS & {*inner}:
        return Term("other", "", _parts(parts))  # of Julia, whose tree has (2^1)^2 for 2^1^2
    whole = of_c and all(map(is_whole, parts))
    name = {"\u00f7": "div", "//": "/"}.get(sign, sign)
    made = Term(
        "binary", {"/": "div", "^": "xor"}.get(name, name) if whole else name, _parts(parts)
    )
    if whole and sign == "*":
        return _held(made, limits_of(node, "int"), whole=True)
    return made


def _held(value: Term, limits: tuple[int, int] | None, *, whole: bool) -> Term:
    """What an integer type holds of a number; a small number that is written out is as it is."""
    if limits is None or (whole and value.kind != "binary" and limits[1] > NARROW):
        return value
    if value.kind == "number" and value.name.isdigit() and int(value.name) <= min(1, limits[1]):
        return value
    return Term("integer", f"{limits[0]} {limits[1]}", (value,), value.text)


def _inside(node: Any) -> list[Any]:
    return [p for p in named(node) if p.type not in ("operator",) or words(p) == ":"]


def _call(parts: list[Any]) -> Term:
    head, *rest = parts
    inside = [p for one in rest for p in (_inside(one) if "argument" in one.type else [one])]
    name = words(head)
    given = _parts(inside)
    named_one = (
        name == "str2func" and given and given[0].kind == "name" and given[0].text[0] in "'\""
    )
    if (name in CHANGES and len(given) == 1) or named_one:
        return given[0]
    if name.endswith(".data") and not given and name.count(".") == 1:  # of a vector of C++
        return Term("name", name.removesuffix(".data"))
    if name == "Dict" and all(p.kind == "binary" and p.name == "=>" for p in given):
        pairs = [(KEY.fullmatch(p.parts[0].text), p) for p in given]
        return Term("list", "", tuple(
            Term("set", "", (Term("name", key[1]), p.parts[1]), p.text) if key else p
            for key, p in pairs
        ))  # fmt: skip
    if name == "deal" and len(given) > 1:
        return Term("list", "", given)
    if head.type == "identifier" or "::" in name or "." in name:
        return Term("call", re.split(r"::", name)[-1], given)
    return Term("other", "", (term(head), *given))


def _copied(call: Term) -> Term:
    """A copy of a whole array of C as what it is: memcpy(y, z, sizeof y) is y[:] = z."""
    if call.name not in ("memcpy", "memmove") or len(call.parts) != 3:
        return call
    target, value, size = call.parts
    whole = re.fullmatch(r"sizeof\s*\(?\s*(\w+)\s*\)?", size.text)
    plain = target.kind == value.kind == "name" and target.text == target.name
    if not plain or whole is None or whole[1] not in (target.name, value.name):
        return call
    return Term("set", "", (Term("entry", "", (target, Term("whole")), target.text), value))


def _set(node: Any, parts: list[Any]) -> Term:
    sign = next((words(c) for c in node.children if words(c).endswith("=")), "=")
    text, target = " ".join(words(node).split()), term(parts[0])
    if sign.startswith(".") and target.kind == "name":  # y .+= x
        target = Term("entry", "", (target, Term("whole")), target.text)
    sign, value = sign.strip(".").rstrip("="), term(parts[-1])
    kind = type_of(parts[0]) if parts[0].type == "identifier" else ""
    limits = limits_of(node, kind) if kind else None
    if limits is not None and not is_whole(parts[-1]):
        value = Term("binary", sign, (target, value)) if sign else value
        return _assignment("", target, _held(value, limits, whole=False), text)
    return _assignment(sign, target, value, text)


def _assignment(sign: str, target: Term, value: Term, text: str) -> Term:
    inner = value.parts if value.kind == "block" else (value,)
    if inner and inner[-1].kind == "set":  # a = b = c
        return Term("block", "", (*inner, Term("set", sign, (target, inner[-1].parts[0]), text)))
    return Term("set", sign, (target, value), text)


def _declared(node: Any) -> Iterator[Term]:
    kind = node.child_by_field_name("type")
    for one in node.children_by_field_name("declarator"):
        names = [n for part in within(one, "structured_binding_declarator") for n in named(part)]
        if names:  # auto &[theta, omega] = state;
            shared = term(one.child_by_field_name("value"))
            yield from (Term("type", words(name), (shared,), "auto &") for name in names)
            continue
        yield _type(kind, one)
        if one.type != "init_declarator":
            continue
        target, value = (one.child_by_field_name(f) for f in ("declarator", "value"))
        while target.type != "identifier" and (inner := _unqualified(target)):
            target = inner[0]
        made = term(value)
        if kind is not None and value.type != "initializer_list" and target.type == "identifier":
            made = _held(made, limits_of(kind, words(kind)), whole=is_whole(value))
        yield _assignment("", term(target), made, " ".join(words(node).split()))


def _row_pointer(found: re.Match[str], parts: list[Any]) -> Term:
    """A pointer, or a reference, to an array: its type, and what it begins with."""
    sign, name = found.groups()
    made = Term("type", name, (), f"double[]{sign}")
    lines = [Term("set", "", (Term("name", name, (), name), term(p)), words(p)) for p in parts[1:]]
    return Term("block", "", (made, *lines))


def _unqualified(declarator: Any) -> list[Any]:
    """What a declarator is made of, without ``const``."""
    return [p for p in named(declarator) if p.type != "type_qualifier"]


def _type(kind: Any, declarator: Any, *shared: Term) -> Term:
    """A type that a name is declared with, its pointers, references and arrays behind it."""
    shape, one = words(kind) if kind is not None else "", declarator
    if declarator.type == "function_declarator" and SHARES.search(shape):  # std::span<double> s(y)
        given = within(declarator.child_by_field_name("parameters"), "type_identifier")
        shared = tuple(Term("name", words(name)) for name in given)
    while one.type != "identifier" and (inner := _unqualified(one)):
        shape += SHAPES.get(one.type, "")
        one = inner[0]
    return Term("type", words(one), shared, shape)


def _loop(node: Any, parts: list[Any]) -> Term:
    body = node.child_by_field_name("body")
    blocks = [body] if body is not None else [p for p in parts if p.type == "block"]
    heads = [p for p in parts if p.type in ("iterator", "for_binding")]
    counter = ""
    limits: tuple[Term, ...] = ()
    pointers: list[Term] = []
    if heads:
        pair = [p for p in named(heads[0]) if p.type != "operator"]
        counter, limits = words(pair[0]), _parts(_inside(pair[-1]))
        blocks = blocks or [p for p in parts if p not in heads]
    elif body is not None and node.type == "for_statement":
        fields = ("initializer", "condition", "update")
        start, stop, step = (node.child_by_field_name(f) for f in fields)
        sets = [one for one in term(start).all() if one.kind == "set"] if start else []
        pointers = [replace(one, parts=(line.parts[1],)) for line in sets
                    for one in term(start).all() if one.kind == "type"
                    if one.name == line.parts[0].name and "*" in one.text]  # fmt: skip
        ends = named(stop) if stop is not None and stop.type == "binary_expression" else []
        counter = sets[0].parts[0].name if sets else ""
        counts = step is not None and step.type == "update_expression" and "++" in words(step)
        if sets and len(ends) == 2 and counts:
            last = Term("binary", "-", (term(ends[1]), Term("number", "1")))
            last = {"<": last, "<=": term(ends[1])}.get(words(stop.children[1]), Term("other"))
            limits = (sets[0].parts[1], last)
    elif not blocks:
        blocks = parts[1:]
    tests = [node.child_by_field_name("condition"), node.child_by_field_name("update")]
    tests = [one for one in tests if one is not None and within(one, *CHANGED)]
    lines = _parts([*blocks, *tests] if not limits else blocks)
    if node.type == "for_range_loop":
        kind, one, of = (node.child_by_field_name(f) for f in ("type", "declarator", "right"))
        shared = (term(of),) if one.type == "reference_declarator" else ()
        lines = (_type(kind, one, *shared), *lines)
    lines = (*pointers, *lines)
    return Term("loop", counter, (Term("list", "", limits), Term("block", "", lines)))
