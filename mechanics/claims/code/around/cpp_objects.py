"""Objects of the class that a judged method of C++ is a part of, as a file makes them.

Rod rod(1, 2, 9.81);        Rod rod{m, l, g};        a parameter for another one says otherwise
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from mechanics.claims.code.around.intermediate_form import Term, term
from mechanics.claims.code.around.interpreter_values import JudgedFunction
from mechanics.claims.code.translation.python_page import named, within, words


def objects(
    root: Any, judged: JudgedFunction, meaning: Any
) -> Iterator[tuple[JudgedFunction, Term]]:
    """How the class is called, and each call of it.

    Parameters
    ----------
    root : tree_sitter.Node
    judged : JudgedFunction
        The method.
    meaning : callable
        The word of the scene that a name is; empty for none.
    """
    for kind in within(root, "class_specifier", "struct_specifier"):
        name, body = (kind.child_by_field_name(f) for f in ("name", "body"))
        if name is None or body is None:
            continue
        makers = list(_methods(body, words(name)))
        if not [*_methods(body, judged.name)]:
            continue
        orders = [_arguments(one) for one in makers] or [_fields(body)]
        for call in _calls(root, words(name)):
            fitting = [o for o in orders if len(o) == len(call.parts)] or (
                [] if makers else [orders[0]]
            )
            for takes in fitting[:1]:
                meanings = {n: (w,) for n in takes if (w := meaning(n) or meaning(n.strip("_")))}
                yield replace(
                    judged, name=words(name), takes=takes, meanings=meanings, fills=(), gives=()
                ), call  # fmt: skip


def _methods(body: Any, name: str) -> Iterator[Any]:
    for one in named(body):
        head = one.child_by_field_name("declarator")
        called = head is not None and head.type == "function_declarator"
        if called and words(head.child_by_field_name("declarator")) == name:
            yield head


def _arguments(head: Any) -> tuple[str, ...]:
    given = named(head.child_by_field_name("parameters"))
    return tuple(words(i) for one in given for i in within(one, "identifier")[:1])


def _fields(body: Any) -> tuple[str, ...]:
    lines = (one for one in named(body) if one.type == "field_declaration")
    return tuple(words(i) for one in lines for i in within(one, "field_identifier"))


def _calls(root: Any, kind: str) -> Iterator[Term]:
    for one in within(root, "declaration"):
        if words(one.child_by_field_name("type")) != kind:
            continue
        text = " ".join(words(one).split())
        for value in one.children_by_field_name("declarator"):
            given = value.child_by_field_name("value") or value.child_by_field_name("parameters")
            if given is not None and given.type in (
                "argument_list", "initializer_list", "parameter_list"
            ):  # fmt: skip
                yield Term("call", kind, tuple(map(_given, named(given))), text)
    for one in within(root, "call_expression"):
        if words(one.child_by_field_name("function")) == kind:
            given = one.child_by_field_name("arguments")
            yield Term("call", kind, tuple(map(_given, named(given))), words(one))


def _given(node: Any) -> Term:
    """``Rod rod(l, m)`` may be read as a function that takes an l and an m."""
    if node.type == "parameter_declaration":
        return Term("name", words(node))
    return term(node)
