"""Records of a file whose fields are taken by their places: these have an order.

S = namedtuple("S", "w th");  th, w = s;  accel(*s)         is another order than that of the fields
"""

import ast
from collections.abc import Callable, Iterator, Mapping, Sequence

from mechanics.claims.code.python_form import arguments_of, word

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
    fields = {**_of_classes(nodes), **_of_calls(nodes)}
    made = _instances(nodes, fields)
    takes = {n.name: arguments_of(n.args) for n in nodes if isinstance(n, ast.FunctionDef)}
    for one in nodes:
        match one:
            case ast.Assign(targets=[ast.Tuple(elts=targets)], value=value) | ast.For(
                target=ast.Tuple(elts=targets), iter=value):  # fmt: skip
                names = [word(t) for t in targets]
                if _differs(names, _fields_of(value, made, fields), meaning):
                    yield one
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


def _differs(names: Sequence[str], fields: Sequence[str], meaning: Callable[[str], str]) -> bool:
    """Whether names stand for other fields than they are called."""
    pairs = [(a, b) for a, b in zip(names, fields, strict=False) if a and a != b]
    return any(
        a in fields or ((one := meaning(a)) and (other := meaning(b)) and one != other)
        for a, b in pairs
    )


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


def _of_calls(nodes: Sequence[ast.AST]) -> dict[str, list[str]]:
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
