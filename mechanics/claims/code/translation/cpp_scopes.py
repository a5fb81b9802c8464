"""Names of C++ that stand for several things, by the places where they are declared.

const double s = -1;   { double s = 1; }   s        a block, and the file around it
struct Gains { double s = 1; };   struct Rod { double s; ... }    two classes
::s,  N::s,  this->s                                beside a variable s of the function

Python has one of each where C++ has several: such a name is refused, and not looked up.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from mechanics.claims.code.translation.python_page import named, refuse, within, words

BLOCKS = ("compound_statement", "for_statement", "if_statement", "for_range_loop",
          "lambda_expression", "while_statement", "switch_statement")  # fmt: skip
AROUND = ("class_specifier", "struct_specifier", "namespace_definition", "union_specifier")
LIBRARIES = ("std", "Eigen", "boost", "M_PI")


@dataclass(frozen=True)
class Outside:
    """What is declared outside of functions.

    Attributes
    ----------
    context : str
        The class or namespace around it; empty for the file.
    signature : str
        Kinds of the arguments of a function.
    has_value : bool
        Whether it is more than a member that objects have.
    """

    context: str
    signature: str
    has_value: bool


def refuse_ambiguous(root: Any, functions: dict[str, Any]) -> None:
    """Refuse names that functions use and that are declared in several places.

    Parameters
    ----------
    root : node
        Of the file.
    functions : dict of str to node
        That are read.

    Raises
    ------
    Unread
    """
    table: dict[str, set[Outside]] = {}
    for name, one in _outside(root):
        table.setdefault(name, set()).add(one)
    gone = {
        words(one.child_by_field_name("argument") or one).strip()
        for one in within(root, "preproc_call")
        if words(one.child_by_field_name("directive") or one).strip() == "#undef"
    }
    for function in functions.values():
        own = {name for name, _ in _declared(function)} | {*_parameters(function)}
        _refuse_inner(function)
        body = function.child_by_field_name("body")
        for one in within(body, "identifier", "field_identifier"):
            name, parent = words(one), one.parent
            if name in gone:
                raise refuse(one, f"{name} is a macro up to some line: rename it")
            qualified = parent.type == "qualified_identifier"
            if qualified and words(parent).split("::")[0].strip() in LIBRARIES:
                continue
            this = parent.type == "field_expression" and (
                parent.child_by_field_name("argument").type == "this"
            )  # fmt: skip
            if one.type == "field_identifier" and not this:
                continue
            if name in own and (qualified or this):
                raise refuse(one, f"{name} is a variable of the function, too: rename one")
            if name not in own:
                _refuse_several(one, name, table.get(name, set()))


def _refuse_several(node: Any, name: str, places: set[Outside]) -> None:
    contexts = {one.context for one in places}
    signatures = {(one.context, one.signature) for one in places}
    if len(contexts) > 1 and any(one.has_value for one in places):
        raise refuse(node, f"{name} is declared in several classes or namespaces: rename one")
    if len(signatures) > len(contexts):
        raise refuse(node, f"{name} is declared for several kinds of arguments: rename one")


def _outside(root: Any) -> Iterator[tuple[str, Outside]]:
    """Names that are declared outside of functions, and where."""
    for one in within(root, "declaration", "field_declaration", "function_definition"):
        if _function_around(one) is not None:
            continue
        context = _context(one)
        for declarator in one.children_by_field_name("declarator"):
            value = declarator.type == "init_declarator" or (
                one.child_by_field_name("default_value") is not None
            )
            heads = within(declarator, "function_declarator")
            known = heads[0].child_by_field_name("declarator") if heads else declarator
            parts = within(known, "identifier", "field_identifier")
            if not parts:
                continue
            around = words(known).split("::")[:-1] if "qualified" in known.type else []
            owner = around[-1].strip() if around else context
            kinds = _signature(heads[0]) if heads else ""
            yield words(parts[-1]), Outside(owner, kinds, bool(value or heads))


def _signature(declarator: Any) -> str:
    parameters = named(declarator.child_by_field_name("parameters"))
    kinds = []
    for one in parameters:
        kind, shape = (one.child_by_field_name(f) for f in ("type", "declarator"))
        sign = shape.type.partition("_")[0] if shape is not None else ""
        kinds.append(f"{words(kind) if kind else words(one)} {sign.replace('identifier', '')}")
    return ", ".join(kinds)


def _context(node: Any) -> str:
    outer = node.parent
    while outer is not None and outer.type not in AROUND:
        outer = outer.parent
    if outer is None:
        return ""
    name = outer.child_by_field_name("name")
    return words(name) if name is not None else f"at {outer.start_byte}"


def _function_around(node: Any) -> Any:
    outer = node.parent
    while outer is not None and outer.type not in ("function_definition", "lambda_expression"):
        if outer.type in ("class_specifier", "struct_specifier"):
            return None
        outer = outer.parent
    return outer


def _parameters(function: Any) -> Iterator[str]:
    for one in within(function.child_by_field_name("declarator"), "parameter_declaration"):
        yield from map(words, within(one, "identifier")[:1])


def _declared(function: Any) -> Iterator[tuple[str, Any]]:
    """Variables of a function, and where their declaration stands."""
    for one in within(function.child_by_field_name("body"), "declaration"):
        for declarator in one.children_by_field_name("declarator"):
            inner = declarator.child_by_field_name("declarator")
            place = inner if declarator.type == "init_declarator" else declarator
            several = "binding" in place.type
            parts = within(place, "identifier")
            yield from ((words(part), one) for part in (parts if several else parts[:1]))


def _refuse_inner(function: Any) -> None:
    """Refuse a variable of a block whose name stands before or behind that, too."""
    body = function.child_by_field_name("body")
    spans: dict[str, list[tuple[int, int]]] = {}
    for name, one in _declared(function):
        block = one.parent
        while block != body and block.type not in BLOCKS:
            block = block.parent
        spans.setdefault(name, []).append((one.start_byte, block.end_byte))
    for part in within(body, "identifier"):
        name = words(part)
        inside = any(first <= part.start_byte < last for first, last in spans.get(name, ()))
        if name in spans and not inside:
            raise refuse(part, f"{name} is another variable here than in a block: rename one")
