"""Functions and methods of C++ as Python, where they are more than C: their trees, line by line.

    std::vector<double> Cart::operator()(std::vector<double> x) const { return {x[1], -k/m*x[0]}; }
    ->  def operator(x, k, m): return block((x[1],), (...,))

Members that nothing gives a value are arguments, an argument of a struct is its fields in their
order, and Eigen's q(1) an entry.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from mechanics.claims.code import array_language
from mechanics.claims.code.python_page import (
    Page,
    Unread,
    first_error,
    joined,
    line_of,
    named,
    refuse,
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
OPERATIONS = {"+": "plus", "-": "minus", "*": "times"}
CONSTANTS = {"M_PI": "np.pi", "true": "True", "false": "False", "PI": "np.pi"}
COMPARED = ("<", ">", "<=", ">=", "==", "!=")
INTEGERS = ("int", "long", "unsigned", "size_t", "short")

NUMBER = re.compile(r"[-+.\deE]+[fFlL]?")
WHOLE = re.compile(r"\{?\s*(?:\d+[uUlL]*|[\w.]+\.size\(\))\s*\}?")


@dataclass
class Scope:
    """What one function knows.

    Attributes
    ----------
    arguments : list of str
    fields : dict of str to list of str
        Of arguments that are structs.
    """

    arguments: list[str]
    fields: dict[str, list[str]]
    functions: set[str]
    constants: dict[str, str] = field(default_factory=dict)
    locals: set[str] = field(default_factory=set)
    integers: set[str] = field(default_factory=set)
    aliases: dict[str, str] = field(default_factory=dict)
    filled: dict[str, None] = field(default_factory=dict)
    free: dict[str, None] = field(default_factory=dict)
    returns: bool = True


def _language() -> object:
    import tree_sitter_cpp

    return tree_sitter_cpp.language()


def in_python(text: str, origin: str, wanted: str | None) -> tuple[Callable[..., Any], ...]:
    """The functions of a file of C++ that no other one calls, or the one that is asked for.

    Raises
    ------
    Unread
        For what is not read, by line and column.
    """
    root = tree(_language, text, "tree-sitter-cpp")
    nodes = {_title(node): node for node in within(root, "function_definition")}
    if not nodes or (wanted and wanted not in nodes):
        raise Unread(f"there is no function {wanted or ''} in it")
    if (wrong := first_error(root)) is not None:
        raise refuse(wrong)
    used = {words(one) for node in nodes.values() for one in within(node, "identifier")}
    for one in (*within(root, "preproc_def"), *within(root, "preproc_function_def")):
        value = words(one.child_by_field_name("value") or one).strip()
        if words(one.child_by_field_name("name")) in used and not NUMBER.fullmatch(value):
            raise refuse(one, "a macro that is no number is not read")
    types = [s for s in within(root, "struct_specifier") if s.child_by_field_name("body")]
    structs = {words(s.child_by_field_name("name")): _fields(s) for s in types}
    calls = {name: _calls(node, nodes) for name, node in nodes.items()}
    called = {other for others in calls.values() for other in others}
    chosen = [wanted] if wanted else [n for n in nodes if n not in called]
    if called:
        raise refuse(nodes[min(called)], "functions that call each other are not read")
    page, constants = Page(), dict[str, str]()
    for name in (n for n in nodes if n in chosen):
        scope = _scope(nodes[name], structs, {*nodes})
        _function(page, nodes[name], name, scope)
        constants |= scope.constants
    for name, value in constants.items():
        page.put(0, 0, f"{name} = {value}")
    own = {name: part for name, part in vars(array_language).items() if callable(part)}
    space = page.module(origin, own)
    return tuple(space[name] for name in chosen)


def _declarator(node: Any) -> Any:
    found = node.child_by_field_name("declarator")
    while found is not None and found.type != "function_declarator":
        found = found.child_by_field_name("declarator")
    if found is None:
        raise refuse(node)
    return found


def _title(node: Any) -> str:
    name = _declarator(node).child_by_field_name("declarator")
    return re.sub(r"\W", "", words(name).split("::")[-1])


def _fields(struct: Any) -> list[str]:
    return [safe(words(one)) for one in within(struct, "field_identifier")]


def _calls(node: Any, functions: dict[str, Any]) -> set[str]:
    names = {words(one).split("::")[-1] for call in within(node, "call_expression")
             for one in [call.child_by_field_name("function")]}  # fmt: skip
    return {name for name in names if name in functions and name != _title(node)}


def _variable(declarator: Any) -> str:
    """The name that a declarator declares."""
    found = within(declarator, "identifier")
    if not found:
        raise refuse(declarator)
    return safe(words(found[0]))


def _scope(node: Any, structs: dict[str, list[str]], functions: set[str]) -> Scope:
    parameters = _declarator(node).child_by_field_name("parameters")
    arguments: list[str] = []
    fields: dict[str, list[str]] = {}
    outputs = []
    for one in named(parameters):
        declarator = one.child_by_field_name("declarator")
        if declarator is None:
            continue
        arguments.append(_variable(declarator))
        kind = words(one.child_by_field_name("type"))
        if kind in structs:
            fields[arguments[-1]] = structs[kind]
        if "const" not in words(one).split() and declarator.type != "identifier":
            outputs.append(arguments[-1])
    scope = Scope(arguments, fields, functions)
    kind = words(node.child_by_field_name("type") or node)
    changed = {
        _root(one.child_by_field_name("left")) for one in within(node, "assignment_expression")
    }
    scope.locals = changed - {*arguments}
    if kind in ("void", "int"):
        scope.returns = False
        scope.filled = dict.fromkeys(o for o in outputs if o in changed)
        scope.arguments = [a for a in arguments if a not in scope.filled]
        scope.locals |= scope.filled.keys()
    return scope


def _root(target: Any) -> str:
    return safe(words(within(target, "identifier")[0])) if within(target, "identifier") else ""


def _function(page: Page, node: Any, name: str, scope: Scope) -> None:
    body = Page()
    for one in named(node.child_by_field_name("body")):
        _statement(body, one, 1, scope)
    used = {safe(words(one)) for one in within(node.child_by_field_name("body"), "identifier")}
    given = [a for a in scope.arguments if a in used]
    extra = [n for n in scope.free if n not in given]
    page.put(line_of(node), 0, f"def {name}({joined([*given, *extra])}):", opens=True)
    start = page.lines
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
        outputs = [n for n in scope.filled if n in used]
        page.compound = True
        page.put(len(start), 1, f"return {joined([f'vector({n})' for n in outputs])}")
    page.compound = True


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
        case "expression_statement" if named(node):
            page.put(line, depth, _changed(named(node)[0], scope))
        case "return_statement":
            if scope.returns:
                value = _value(named(node)[0], scope)
                page.put(
                    line, depth, f"return {f'vector({value})' if value in scope.filled else value}"
                )
            else:
                page.put(line, depth, "pass")
        case "if_statement":
            condition = node.child_by_field_name("condition").child_by_field_name("value")
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
    plain = re.fullmatch(r"(\w+)\s*<\s*(\w+)", words(until))
    counter = plain[1] if plain else ""
    start = re.fullmatch(rf"(?:int|size_t|unsigned)\s+{counter}\s*=\s*(\d+)\s*;", words(first))
    if not (plain and start and words(step) in (f"++{counter}", f"{counter}++")):
        raise refuse(node)
    scope.locals.add(counter)
    scope.integers.add(counter)
    return f"for {counter} in range({start[1]}, {plain[2]}):"


def _declaration(page: Page, node: Any, depth: int, scope: Scope) -> None:
    kind = words(node.child_by_field_name("type"))
    for one in node.children_by_field_name("declarator"):
        declarator = one.child_by_field_name("declarator") if one.type == "init_declarator" else one
        value = one.child_by_field_name("value") if one.type == "init_declarator" else None
        line = line_of(one)
        if declarator.type == "structured_binding_declarator":
            names = [safe(words(part)) for part in named(declarator)]
            scope.locals |= {*names}
            page.put(line, depth, f"{joined(names)} = {_value(value, scope)}")
            continue
        name = _variable(declarator)
        if declarator.type == "reference_declarator" and "const" not in words(node).split():
            raise refuse(one, "a second name of a variable is not read")
        if kind in INTEGERS:
            if value is not None and not WHOLE.fullmatch(words(value)):
                raise refuse(one, "what is rounded to an integer is not read")
            scope.integers.add(name)
        target = value and _pointed(value, scope)
        if target:
            scope.aliases[name] = target
            continue
        if value is not None and value.type == "number_literal" and name not in scope.locals:
            scope.constants[name] = _number(value)
            continue
        scope.locals.add(name)
        if value is None or (value.type == "argument_list" and not _is_scalar(kind)):
            page.put(line, depth, f"{name} = None")
        elif value.type == "initializer_list" and _is_scalar(kind):
            inner = named(value)
            page.put(line, depth, f"{name} = {_value(inner[0], scope) if inner else '0.0'}")
        else:
            page.put(line, depth, f"{name} = {_value(value, scope)}")


def _is_scalar(kind: str) -> bool:
    return kind in ("double", "float", "auto", *INTEGERS)


def _pointed(value: Any, scope: Scope) -> str:
    """The argument that a pointer of another type points to."""
    cast = value.type == "cast_expression" or words(value).startswith(
        ("static_cast", "reinterpret_")
    )
    names = [safe(words(one)) for one in within(value, "identifier")]
    return names[-1] if cast and "*" in words(value) and names[-1] in scope.arguments else ""


def _changed(node: Any, scope: Scope) -> str:
    if node.type == "update_expression":
        name = _read(_root(node), scope)
        return f"{name} = {name} {words(node.child_by_field_name('operator'))[0]} 1"
    if node.type != "assignment_expression":
        raise refuse(node)
    left, right = (node.child_by_field_name(f) for f in ("left", "right"))
    sign, value = words(node.child_by_field_name("operator")), _value(right, scope)
    if sign != "=":
        if sign[0] not in OPERATIONS:
            raise refuse(node)
        value = f"{OPERATIONS[sign[0]]}({_value(left, scope)}, {value})"
    if left.type == "identifier":
        name = safe(words(left))
        scope.locals.add(name)
        return f"{name} = {value}"
    name, indices = _entry(left, scope)
    if name in scope.arguments or name in scope.fields:
        raise refuse(left)
    if name not in scope.locals or name not in scope.filled:
        scope.locals.add(name)
        scope.filled.setdefault(name)
    return f"{name} = put({joined([name, value, *(f'({i}) + 1' for i in indices)])})"


def _entry(node: Any, scope: Scope) -> tuple[str, list[str]]:
    """x[1], x.at(1) and x(1) as an array and its indices."""
    if node.type == "subscript_expression":
        head, given = node.child_by_field_name("argument"), node.child_by_field_name("indices")
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
    return words(node).rstrip("fFlLuU").replace("'", "")


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
    if node.type == "number_literal":
        return words(node).isdigit()
    if node.type in (
        "identifier",
        "parenthesized_expression",
        "unary_expression",
        "binary_expression",
    ):
        parts = [p for p in named(node) if p.type != "operator"]
        if node.type == "identifier":
            return words(node) in scope.integers
        return bool(parts) and all(_whole(part, scope) for part in parts)
    return False


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
            return f"({'not ' if sign == '!' else sign}{inner})"
        case "binary_expression":
            return _binary(node, scope)
        case "conditional_expression":
            parts = (
                node.child_by_field_name(f) for f in ("consequence", "condition", "alternative")
            )
            yes, condition, no = (_value(part, scope) for part in parts)
            return f"({yes} if {condition} else {no})"
        case "initializer_list":
            return f"block({joined([f'({_value(part, scope)},)' for part in named(node)])})"
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


def _binary(node: Any, scope: Scope) -> str:
    sides = [node.child_by_field_name(f) for f in ("left", "right")]
    sign = words(node.child_by_field_name("operator"))
    left, right = (_value(side, scope) for side in sides)
    if sign in OPERATIONS:
        return f"{OPERATIONS[sign]}({left}, {right})"
    if sign == "/":
        if all(_whole(side, scope) for side in sides):
            return f"quotient({left}, {right})"
        return f"({left} / {right})"
    if sign in (*COMPARED, "&&", "||"):
        return f"({left} {({'&&': 'and', '||': 'or'}).get(sign, sign)} {right})"
    raise refuse(node)


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
        return f"{name}[{joined(indices)}]"
    return f"get({joined([name, *(f'({i}) + 1' for i in indices)])})"


def _call(node: Any, scope: Scope) -> str:
    head, given = (node.child_by_field_name(f) for f in ("function", "arguments"))
    if head.type == "field_expression" or head.type == "subscript_expression":
        return _place(node, scope)
    name = words(head).split("::")[-1]
    if words(head).startswith(("static_cast<double>", "static_cast<float>")):
        return _value(named(given)[0], scope)
    plain = name[:-1] if name.endswith("f") and name[:-1] in {*LIBRARY, "pow"} else name
    if plain == "pow":
        base, power = (_value(part, scope) for part in named(given))
        return f"power({base}, {power})"
    if plain in LIBRARY:
        return f"np.{LIBRARY[plain]}({joined([_value(part, scope) for part in named(given)])})"
    if head.type == "identifier" and name not in scope.functions:
        return _place(node, scope)
    raise refuse(node)
