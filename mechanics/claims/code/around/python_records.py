"""Records of a file whose fields are taken by their places: these have an order.

S = namedtuple("S", "w th");  th, w = s;  accel(*s)         is another order than that of the fields
"""

import ast
from collections.abc import Callable, Iterator, Mapping, Sequence

from mechanics.claims.code.around.python_form import arguments_of, word

Fields = Mapping[str, Sequence[str]]
SPREADS = frozenset(("astuple", "tuple", "list", "array", "asarray"))


def taken_otherwise(tree: ast.Module, meaning: Callable[[str], str]) -> Iterator[ast.AST]:
    """Lines that take fields of a record in another order than it has them.

    Parameters
    ----------
    tree : ast.Module
    meaning : callable
        The word of the scene that a name is; empty for none.
    """
    nodes = [*ast.walk(tree)]
    fields = {**_of_classes(nodes), **named_tuples(nodes)}
    made = _instances(nodes, fields)
    takes = {n.name: arguments_of(n.args) for n in nodes if isinstance(n, ast.FunctionDef)}
    for one in nodes:
        match one:
            case ast.Assign(targets=[ast.Tuple() as target], value=value):
                if _differs(_names(target), _fields_of(value, made, fields), meaning):
                    yield one
            case (ast.For(target=ast.Tuple() as target, iter=value)
                  | ast.comprehension(target=ast.Tuple() as target, iter=value)):  # fmt: skip
                if _differs(_names(target), _fields_of_each(value, made, fields), meaning):
                    yield target
            case ast.Call(func=func, args=[*args]):
                names = [*takes.get(word(func), ())]
                for k, part in enumerate(args):
                    if isinstance(part, ast.Starred) and _differs(
                        names[k:], _fields_of(part.value, made, fields), meaning
                    ):  # fmt: skip
                        yield one
                own = fields.get(word(func))
                if own and _differs([word(a) for a in args], own, meaning):
                    yield one


def _names(target: ast.Tuple) -> list[str]:
    return [word(part) for part in target.elts]


def _differs(names: Sequence[str], fields: Sequence[str], meaning: Callable[[str], str]) -> bool:
    """Whether names stand for other fields than they are called."""
    pairs = [(a, b) for a, b in zip(names, fields, strict=False) if a and a != b]
    return any(
        a in fields or ((one := meaning(a)) and (other := meaning(b)) and one != other)
        for a, b in pairs
    )


def _fields_of_each(
    value: ast.expr, made: Mapping[str, str], fields: Fields
) -> Sequence[str]:  # fmt: skip
    """Fields of the records that a list holds."""
    match value:
        case ast.List(elts=[first, *_]) | ast.Tuple(elts=[first, *_]) | ast.ListComp(elt=first):
            return _fields_of(first, made, fields)
        case ast.Name(id=name):
            return fields.get(made.get(f"{name}[]", ""), ())
    return ()


def _of_classes(nodes: Sequence[ast.AST]) -> dict[str, list[str]]:
    """Fields of data classes and named tuples."""
    found = {}
    for one in nodes:
        if isinstance(one, ast.ClassDef):
            marks = [d.func if isinstance(d, ast.Call) else d for d in one.decorator_list]
            if {"dataclass", "NamedTuple", "define", "frozen"} & {*map(word, (*marks, *one.bases))}:
                found[one.name] = [
                    line.target.id for line in one.body
                    if isinstance(line, ast.AnnAssign) and isinstance(line.target, ast.Name)
                ]  # fmt: skip
    return found


def named_tuples(nodes: Sequence[ast.AST]) -> dict[str, list[str]]:
    """Fields of what namedtuple makes."""
    found: dict[str, list[str]] = {}
    for one in nodes:
        match one:
            case ast.Assign(
                targets=[ast.Name(id=name)], value=ast.Call(func=func, args=[_, names, *_])
            ) if word(func) == "namedtuple":
                match names:
                    case ast.Constant(value=str(text)):
                        found[name] = text.replace(",", " ").split()
                    case ast.List(elts=parts) | ast.Tuple(elts=parts):
                        found[name] = [str(getattr(p, "value", "")) for p in parts]
    return found


def _instances(nodes: Sequence[ast.AST], fields: Fields) -> dict[str, str]:
    """Names of objects of these classes."""
    found: dict[str, str] = {}
    for one in nodes:
        match one:
            case ast.Assign(targets=[target], value=ast.Call(func=func)):
                base = func.value if isinstance(func, ast.Attribute) else func
                for kind in {word(func), word(base)} & fields.keys():
                    found[word(target)] = kind
            case ast.Assign(
                targets=[target],
                value=ast.List(elts=[ast.Call(func=func), *_])
                | ast.ListComp(elt=ast.Call(func=func)),
            ) if word(func) in fields:  # fmt: skip
                found[f"{word(target)}[]"] = word(func)
            case ast.arg(arg=name, annotation=ast.expr() as kind) if word(kind) in fields:
                found[name] = word(kind)
    return found


def _fields_of(value: ast.expr, made: Mapping[str, str], fields: Fields) -> Sequence[str]:
    """Fields of the record that something is, in their order; none where it is no record."""
    match value:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return fields.get(made.get(name, ""), ())
        case ast.Call(func=func, args=[inner]) if word(func) in SPREADS:
            return _fields_of(inner, made, fields)
        case ast.Call(func=func):
            return fields.get(word(func), ())
    return ()
