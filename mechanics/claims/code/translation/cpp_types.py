"""Types of a file of C++ that change what they are given: they are not read as numbers or fields.

    typedef int Q;                            Q a = 2.9;     ->  Q is an integer type
    struct D { double v; D(double x): v(2*x) {} operator double() {...} };   D a = 1;   ->  refused

A class may copy what it is given into its first members, in their order.
"""

import re
from collections.abc import Mapping
from typing import Any

from mechanics.claims.code.translation.python_page import named, refuse, within, words

CLASSES = ("class_specifier", "struct_specifier", "union_specifier")
INTEGERS = re.compile(
    r"\b(?:int|long|short|signed|unsigned|char|bool|boolean|byte|word"
    r"|(?:s?size|ptrdiff|u?int\w*|wchar|char\d+)_t|(?:Row)?(?:Matrix|Vector|Array)[\dX]+i)\b"
)
NAMES = ("identifier", "type_identifier")
REALS = re.compile(
    r"GL(?:float|double)|real(?:32|64)?_[tT]|float(?:32|64)_t|dReal|btScalar|mjtNum|qreal"
    r"|vector|array|span|valarray|pair|tuple|initializer_list"
    r"|Ref|(?:Row)?(?:Matrix|Vector|Array)(?:[\dX]+[df]?)?|MatrixBase|Vectord|Matrixd|string"
)
"""Types of others that are real numbers, and arrays of what they are said to hold."""
STORAGE = ("const", "constexpr", "static", "inline", "volatile", "override", "noexcept", "final")
"""What is said of a variable and changes no value, or is asked for where it is declared."""


def is_integral(kind: str) -> bool:
    """Whether a type is one of integers, or holds them."""
    kind = kind.replace("long double", "double")
    return INTEGERS.search(kind.partition("<")[2] or kind) is not None


def member_key(name: str) -> str:
    """A member or an argument as they are spelled alike: m_, _m, m0 and m."""
    return re.sub(r"^m_(?=\w)|^_+|_+$|_(?:in|init)$|(?<=\w)0$", "", name).lower()


def tokens_of(node: Any) -> list[Any]:
    """The parts of a tree that have no parts, in the order of the text."""
    parts = node.children
    return [leaf for part in parts for leaf in tokens_of(part)] if parts else [node]


def own_types(root: Any) -> set[str]:
    """Names of types that the file makes: classes, other names, and what templates leave open."""
    made = within(root, *CLASSES, "enum_specifier", "type_definition", "alias_declaration",
                  "type_parameter_declaration", "optional_type_parameter_declaration",
                  "preproc_def")  # fmt: skip
    heads = (h for one in made for h in (one.child_by_field_name("name"),
             *one.children_by_field_name("declarator"), *one.named_children[:1]))  # fmt: skip
    lists = within(root, "template_parameter_list")
    open_ones = (one.child_by_field_name("declarator") for part in lists
                 for one in within(part, "parameter_declaration"))  # fmt: skip
    return {words(n) for head in (*heads, *open_ones) if head is not None
            for n in [head, *within(head, "type_identifier")] if n.type in NAMES}  # fmt: skip


def strange_type(node: Any, own: set[str]) -> Any:
    """The first type in a tree that neither the file makes nor `REALS` has; None without one."""
    for leaf in within(node, "type_identifier"):
        known = re.fullmatch(f"{REALS.pattern}|{INTEGERS.pattern}", words(leaf))
        if words(leaf) not in own and known is None:
            return leaf
    return None


def refuse_types(root: Any, nodes: Mapping[str, Any], types: Mapping[str, str]) -> None:
    """Refuse functions that use a type of `unread_types`, one that is not here, or of expressions.

    Raises
    ------
    Unread
    """
    own = own_types(root)
    for node in nodes.values():
        head = within(node, "function_declarator")[0]
        parts = (node.child_by_field_name("type"), head.child_by_field_name("parameters"),
                 node.child_by_field_name("body"))  # fmt: skip
        for leaf in (strange_type(part, own) for part in parts if part is not None):
            if leaf is not None:
                raise refuse(
                    leaf, f"nothing says what the type {words(leaf)} is: declare it in the file"
                )
        for one in within(node, "storage_class_specifier", "type_qualifier"):
            if words(one) not in STORAGE:
                raise refuse(one, f"{words(one)} is not read")
        for end in within(node, "trailing_return_type"):
            if is_integral(words(end)):
                raise refuse(end, "what is rounded to an integer is not read")
        for leaf in tokens_of(node):
            name = words(leaf)
            if name in ("decltype", "typeof", "__typeof__"):
                raise refuse(leaf, f"{name} is not read: write the type")
            if name in types and leaf.type != "namespace_identifier":
                raise refuse(leaf, types[name])


def unread_types(root: Any) -> dict[str, str]:
    """Names of types that are not read, and why: those made of them, too."""
    why: dict[str, str] = {}
    parts: dict[str, set[str]] = {}
    for node in within(root, "type_definition", "alias_declaration", "preproc_def"):
        kind = node.child_by_field_name("value" if node.type == "preproc_def" else "type")
        if kind is None:
            continue
        heads = [node.child_by_field_name("name"), *node.children_by_field_name("declarator")]
        for head in (one for one in heads if one is not None):
            name = words(within(head, *NAMES)[0]) if within(head, *NAMES) else words(head)
            if kind.type in CLASSES and kind.child_by_field_name("body"):
                why |= _changing(kind, name)
                parts[name] = {words(kind.child_by_field_name("name") or head)} - {name}
            elif is_integral(words(kind)):
                why[name] = f"{name} is an integer type under another name: write that"
            else:
                parts[name] = {*re.findall(r"\w+", words(kind))} - {name}
    for node in within(root, *CLASSES):
        head = node.child_by_field_name("name")
        if head is not None and node.child_by_field_name("body"):
            why |= _changing(node, words(head))
            if node.type == "union_specifier":
                why[words(head)] = f"{words(head)} is a union: not read"
            bases = [one for one in node.children if one.type == "base_class_clause"]
            parts[words(head)] = {words(n) for b in bases for n in within(b, "type_identifier")}
    why |= _of_operators(root)
    for node in within(root, "optional_type_parameter_declaration"):
        if words(node.child_by_field_name("default_type")) not in ("double", "float"):
            name = words(node.child_by_field_name("name"))
            why[name] = f"{name} is a type that is not read where nothing says another"
    for node in within(root, "template_instantiation"):
        if is_integral(words(node).replace("double", "")):
            why |= {words(one): "a template is made for integers: not read"
                    for one in within(node, "identifier")[:1]}  # fmt: skip
    while more := {n: f"{n} is made of a type that is not read" for n in parts.keys() - why.keys()
                   if parts[n] & why.keys()}:  # fmt: skip
        why |= more
    return why


def integer_members(root: Any, types: Mapping[str, str]) -> set[str]:
    """Members of classes, variables of the file and enumerators, that are no real numbers."""
    own = own_types(root)
    found = {words(one.child_by_field_name("name")) for one in within(root, "enumerator")}
    for node in within(root, "field_declaration", "declaration"):
        kind = node.child_by_field_name("type")
        if kind is not None and (is_integral(words(kind)) or words(kind) in types
                                 or strange_type(kind, own) is not None):  # fmt: skip
            for one in node.children_by_field_name("declarator"):
                found |= {words(n) for n in within(one, "identifier", "field_identifier")[:1]}
    return found


def _said(name: str) -> dict[str, str]:
    return {name: f"class {name} has conversions or operators of its own: not read"}


def _changing(node: Any, name: str) -> dict[str, str]:
    """Why a class is not read: a constructor that does more than copy."""
    body = node.child_by_field_name("body")
    members = [
        member_key(words(one))
        for part in named(body) if part.type == "field_declaration"
        for one in within(part, "field_identifier")
    ]  # fmt: skip
    root = node
    while root.parent is not None:
        root = root.parent
    for one in within(root, "function_definition", "declaration"):
        if one.child_by_field_name("type") is None and _maker(one) == name:
            within_class = any(one == part or one.parent == part for part in (*named(body), body))
            outside = bool(within(one, "qualified_identifier"))
            if (within_class or outside) and not _copies(one, members):
                return _said(name)
    return {}


def _maker(node: Any) -> str:
    """The class whose constructor a definition is; nothing for what is none."""
    head = (within(node, "function_declarator") or [None])[0]
    name = head and head.child_by_field_name("declarator")
    return words(name).split("::")[-1] if name is not None else ""


def _copies(node: Any, members: list[str]) -> bool:
    """Whether a constructor copies its arguments into the first members, in their order."""
    if within(node, "default_method_clause", "delete_method_clause"):
        return True
    head = within(node, "function_declarator")[0].child_by_field_name("parameters")
    names = [words(within(one, "identifier")[-1]) for one in
             within(head, "parameter_declaration", "optional_parameter_declaration")
             if within(one.child_by_field_name("declarator") or one, "identifier")]  # fmt: skip
    body = node.child_by_field_name("body")
    if body is None and node.type == "declaration":
        return True  # its definition, where there is one, is judged by itself
    rest = [one for one in named(body) if one.type != "comment"] if body is not None else []
    changes = [*within(node, "field_initializer"), *within(node, "assignment_expression")]
    if any(one.type != "expression_statement" or named(one)[0].type != "assignment_expression"
           for one in rest):  # fmt: skip
        return False
    made = set()
    for one in changes:
        first, *_, last = named(one)
        value = re.sub(r"^[({]\s*|\s*[)}]$", "", words(last))
        if value in names and member_key(value) == member_key(re.split(r"->|\.", words(first))[-1]):
            made.add(value)
        elif names or not re.fullmatch(r"[-+.\deE]*", value):
            return False
    return made == {*names} and [member_key(n) for n in names] == members[: len(names)]


def _of_operators(root: Any) -> dict[str, str]:
    """Classes with operators and conversions, in them or beside them."""
    found: dict[str, str] = {}
    for node in within(root, "operator_name", "operator_cast"):
        owner = node
        while owner.parent is not None and owner.type not in ("function_definition", "declaration",
                                                              "field_declaration"):  # fmt: skip
            owner = owner.parent
        names = {words(n) for n in within(owner, "namespace_identifier")[:1]}
        names = names if node.parent.type == "qualified_identifier" else set()
        if within(owner, "default_method_clause", "delete_method_clause"):
            continue
        kinds = within(owner, "parameter_declaration")
        if any("ostream" in words(one) for one in kinds):
            continue
        if re.sub(r"\s", "", words(node)) != "operator()":
            names |= {words(n) for one in kinds for n in within(one, "type_identifier")}
        while owner is not None and owner.type not in CLASSES:
            owner = owner.parent
        head = owner and (
            owner.child_by_field_name("name") or owner.parent.child_by_field_name("declarator")
        )  # typedef struct {...} State
        for name in (*names, *([words(head)] if head is not None else [])):
            found |= _said(name)
    return found
