"""Which formulas of C and C++ are integers, by what is declared around them.

const int DT_MS = 10;     DT_MS / 1000  is 0        DT_MS / 1000.0  is 0.01
unsigned long now = millis();     (now - last) / 1000  has no part of a second
"""

import re
from collections.abc import Iterator
from typing import Any

from mechanics.claims.code.translation.cpp_integers import kind_of
from mechanics.claims.code.translation.cpp_types import is_integral
from mechanics.claims.code.translation.python_page import named, within, words

INTEGER = re.compile(r"(?:0[xXbB][\da-fA-F']+|\d[\d']*)[uUlLzZ]*")
GIVEN = frozenset(
    ("millis", "micros", "analogRead", "digitalRead", "random", "rand", "map", "atoi", "atol",
     "strlen", "parseInt", "size", "clock", "count", "available", "HAL_GetTick",
     "xTaskGetTickCount", "stoi", "stol", "lround", "lrint")
)  # fmt: skip
"""Calls that give integers."""
SAME = frozenset(("abs", "labs", "min", "max", "constrain", "clamp", "sq"))
"""Calls that give an integer where they are given integers alone."""
COMPARED = frozenset(("<", ">", "<=", ">=", "==", "!=", "&&", "||"))
SCOPES = ("compound_statement", "for_statement", "translation_unit", "preproc_ifdef", "preproc_if",
          "preproc_else", "namespace_definition", "declaration_list", "linkage_specification",
          "if_statement", "case_statement")  # fmt: skip
HEADS = ("function_definition", "lambda_expression")
SKETCH = {"setup", "loop"}


def is_whole(node: Any) -> bool:
    """Whether a formula of C is one of integers.

    Parameters
    ----------
    node : Node
        Of a tree of C++; nothing of another language is one.
    """
    match node.type:
        case "number_literal":
            return INTEGER.fullmatch(words(node)) is not None
        case "char_literal" | "sizeof_expression":
            return True
        case "parenthesized_expression" | "update_expression":
            return len(named(node)) == 1 and is_whole(named(node)[0])
        case "unary_expression":
            return words(node)[0] == "!" or is_whole(named(node)[-1])
        case "binary_expression":
            sides = [node.child_by_field_name(f) for f in ("left", "right")]
            sign = words(node.child_by_field_name("operator"))
            return sign in COMPARED or all(map(is_whole, sides[: 1 if sign in ("<<", ">>") else 2]))
        case "conditional_expression":
            ends = [node.child_by_field_name(f) for f in ("consequence", "alternative")]
            return all(end is not None and is_whole(end) for end in ends)
        case "cast_expression":
            return _is_integer_type(node, words(node.child_by_field_name("type")))
        case "call_expression":
            return _gives_integer(node)
        case "subscript_expression":
            return is_whole(node.child_by_field_name("argument"))
        case "field_expression":
            return _is_integer_field(node, words(node.child_by_field_name("field")))
        case "identifier":
            return _is_integer_name(node)
    return False


def limits_of(node: Any, kind: str) -> tuple[int, int] | None:
    """The least and the largest number of a type; None for one that is not of integers."""
    if not _is_integer_type(node, kind) or "*" in kind or "<" in kind:
        return None
    return kind_of(_aliased(node, kind), bits_of_int(node)).limits


def type_of(node: Any) -> str:
    """The type that a name is declared with, nearest first; empty where nothing says it."""
    found = next(_declarations(node, words(node)), None)
    return "" if found is None else words(found.child_by_field_name("type") or found)


def bits_of_int(node: Any) -> int:
    """Bits of an int: 16 in a sketch, as on the smallest boards, 32 elsewhere."""
    heads = {words(named(one)[0]) for one in within(_root(node), "function_declarator")}
    return 16 if heads >= SKETCH else 32


def _root(node: Any) -> Any:
    while node.parent is not None:
        node = node.parent
    return node


def _gives_integer(node: Any) -> bool:
    head = node.child_by_field_name("function")
    given = named(node.child_by_field_name("arguments"))
    name = re.split(r"::|\.|->", words(head))[-1]
    if cast := re.fullmatch(r"static_cast\s*<(.*)>", words(head)):
        return _is_integer_type(node, cast[1])
    if name in SAME:
        return bool(given) and all(map(is_whole, given))
    if name in GIVEN or is_integral(name):
        return True
    kinds = [
        one.child_by_field_name("type") for one in within(_root(node), "function_definition")
        if name in (words(named(d)[0]) for d in within(one, "function_declarator")[:1])
    ]  # fmt: skip
    return bool(kinds) and all(k is not None and _is_integer_type(k, words(k)) for k in kinds)


def _is_integer_field(node: Any, name: str) -> bool:
    fields = [
        one for one in within(_root(node), "field_declaration")
        if name in map(words, within(one, "field_identifier"))
    ]  # fmt: skip
    kinds = [words(one.child_by_field_name("type")) for one in fields]
    return bool(kinds) and all(_is_integer_type(node, kind) for kind in kinds)


def _is_integer_name(node: Any) -> bool:
    found = next(_declarations(node, words(node)), None)
    if found is None:
        return False
    if found.type == "enumerator":
        return True
    if found.type in ("preproc_def", "init_declarator"):  # of auto, too
        value = found.child_by_field_name("value")
        if found.type == "preproc_def":
            return value is not None and INTEGER.fullmatch(words(value).strip("() ")) is not None
        return bool(value is not None and is_whole(value))
    return _is_integer_type(node, words(found.child_by_field_name("type")))


def _declarations(node: Any, name: str) -> Iterator[Any]:
    """What declares a name, nearest first: a declaration, the value of an auto, or a macro."""
    scope = node.parent
    while scope is not None:
        if scope.type in HEADS:
            for one in within(scope, "parameter_declaration", "optional_parameter_declaration"):
                if name in map(words, within(one, "identifier")):
                    yield one
        elif scope.type in SCOPES:
            yield from _declared_in(scope, name)
        scope = scope.parent


def _declared_in(scope: Any, name: str) -> Iterator[Any]:
    for one in scope.children:
        if one.type == "preproc_def" and words(one.child_by_field_name("name")) == name:
            yield one
        if one.type in SCOPES[3:6] and scope.type == "translation_unit":
            yield from _declared_in(one, name)
        for part in within(one, "enumerator") if one.type != "function_definition" else ():
            if words(part.child_by_field_name("name")) == name:
                yield part
        if one.type != "declaration":
            continue
        for each in one.children_by_field_name("declarator"):
            value = each.type == "init_declarator"
            inner = each.child_by_field_name("declarator") if value else each
            if name in map(words, within(inner, "identifier")[:1]):
                auto = words(one.child_by_field_name("type") or one) in ("auto", "auto const")
                yield each if auto and value else one


def _is_integer_type(node: Any, kind: str) -> bool:
    return "*" not in kind and is_integral(_aliased(node, kind))


def _aliased(node: Any, kind: str) -> str:
    """The type that another name of one stands for."""
    for one in within(_root(node), "type_definition", "alias_declaration"):
        names = [one.child_by_field_name("name"), *one.children_by_field_name("declarator")]
        if kind in (words(n) for n in names if n is not None):
            return words(one.child_by_field_name("type"))
    return kind
