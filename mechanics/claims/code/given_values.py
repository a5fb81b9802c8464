"""What the lines of a file of code say that its names are, wherever they stand.

a = 2*L    L, a = 1, 2    {a: 2*L}    Eq(a, 2*L)    f(a=2*L)    f(th, 2*L) of def f(th, a)
parameter Real a(start=2*L)    #define a (2*L)    double a{2*L}    a = 2L

Nothing is run: a value is its text. Python is read by its tree, other languages by their signs.
"""

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

WORD = r"[^\W\d]\w*"
SIGN = re.compile(
    rf"(?P<name>{WORD})(?:\s*\([^()=]*\bstart)?\s*(?::=|=(?![=>])|\{{(?=[^{{}};]*\}}\s*;))"
    r"\s*(?=(?P<value>[^;\n]*))"
)
MACRO = re.compile(rf"^[ \t]*#[ \t]*define[ \t]+(?P<name>{WORD})[ \t]+(?P<value>[^\n]+)", re.M)
SEVERAL = re.compile(rf"(?P<names>{WORD}(?:\s*,\s*{WORD})+)\s*[\])]?\s*=(?![=>])(?P<value>[^;\n]*)")
CALL = re.compile(rf"(?P<name>{WORD})\s*\(")
STRING = re.compile(r"\"(?:\\.|[^\"\\\n])*\"|(?<![\w)\]}'.])'(?:\\.|[^'\\\n])*'")
NUMBER = re.compile(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?P<of>(?=[^\W\d]))?")
KEYWORD = re.compile(rf"\b{WORD}\s*=(?!=)")
PATH = re.compile(rf"{WORD}(?:(?:\.|->){WORD})*")
CALLED = re.compile(rf"{PATH.pattern}\s*(?=\()")
CASTS = re.compile(
    r"(?<![\w.])(?:np\.|numpy\.)?(?:float(?:64|32)?|double|asarray|abs|int|to_numpy)\s*\("
)
PLACED = re.compile(rf"{PATH.pattern}(?:\s*\[[^\[\]]*\])+|{WORD}(?:(?:\.|->){WORD})+")
"""An entry or a part of something that is handed in."""
CONSTANTS = frozenset(("pi", "inf", "nan", "True", "False", "None", "true", "false", "M_PI"))
DECLARES = re.compile(
    r"[-+]?[\d.]+(?:[eE][-+]?\d+)?|(?:\w+\.)?(?:[Ss]ymbols?|dynamicsymbols|Function|parameter)\b.*",
    re.DOTALL,
)
OPERATOR = re.compile(r"[-+*/^]")


@dataclass(frozen=True)
class Given:
    """What one place gives a name.

    Attributes
    ----------
    name : str
    value : str
        As it is written.
    alone : bool
        Whether it gives the name a value of its own, as an assignment does, and no argument.
    """

    name: str
    value: str
    alone: bool = True

    @property
    def declares(self) -> bool:
        """Whether its value is a number or a symbol of its own."""
        return DECLARES.fullmatch(self.value.strip("() ")) is not None

    @property
    def words(self) -> str:
        """As it is told."""
        return " ".join(f"{self.name} = {self.value}".split())[:60]


def given_values(code: str, suffix: str) -> list[Given]:
    """All that a file gives its names.

    Parameters
    ----------
    code : str
        Without comments.
    suffix : str
        Of its file.
    """
    if suffix == ".py":
        try:
            tree = ast.parse(code)
        except (SyntaxError, ValueError, RecursionError):
            return []
        heads = {n.name: [a.arg for a in (*n.args.posonlyargs, *n.args.args)]
                 for n in ast.walk(tree) if isinstance(n, ast.FunctionDef)}  # fmt: skip
        return [one for node in ast.walk(tree) for one in _of_python(node, heads)]
    return [*_of_signs(STRING.sub('""', code))]


def _of_python(node: ast.AST, heads: Mapping[str, list[str]]) -> Iterator[Given]:
    match node:
        case ast.Assign(targets=targets, value=value):
            for target in targets:
                yield from _paired(target, value)
        case ast.AnnAssign(target=target, value=ast.expr() as value):
            yield from _paired(target, value)
        case ast.AugAssign(target=target, op=op, value=value):
            plain = isinstance(value, ast.Constant)
            joined = ast.BinOp(ast.Name("_", ast.Load()), op, value)
            yield from _paired(target, value if plain else joined)
        case ast.NamedExpr(target=target, value=value):
            yield from _paired(target, value)
        case ast.Dict(keys=keys, values=values):
            for key, value in zip(keys, values, strict=True):
                if key is not None:
                    yield from _paired(key, value)
        case ast.Tuple(elts=[ast.Name() as name, value], ctx=ast.Load()):
            yield from (Given(g.name, g.value, alone=False) for g in _paired(name, value))
        case ast.keyword(arg=str() as name, value=value):
            yield Given(name, ast.unparse(value), alone=False)
        case ast.FunctionDef(args=ast.arguments(args=args, defaults=defaults)):
            for one, value in zip(args[len(args) - len(defaults) :], defaults, strict=True):
                yield Given(one.arg, ast.unparse(value), alone=False)
        case ast.Call(func=function, args=args):
            called = getattr(function, "id", getattr(function, "attr", ""))
            pairs = [*zip(heads.get(called, ()), args, strict=False)]
            if called not in heads and len(args) == 2 and isinstance(args[0], ast.Name):
                pairs = [(args[0].id, args[1])]  # Eq(a, 2*L), .subs(a, 2*L)
            yield from (Given(name, ast.unparse(value), alone=False) for name, value in pairs)


def _paired(target: ast.expr, value: ast.expr) -> Iterator[Given]:
    match target, value:
        case (
            (ast.Tuple(elts=names) | ast.List(elts=names)),
            (ast.Tuple(elts=values) | ast.List(elts=values)),
        ) if len(names) == len(values):
            for name, part in zip(names, values, strict=True):
                yield from _paired(name, part)
        case ((ast.Tuple(elts=names) | ast.List(elts=names)), _):
            for name in names:
                yield from _paired(name, value)
        case ast.Name(id=name), _:
            yield Given(name, ast.unparse(value))
        case ast.Attribute(attr=name), _:
            yield Given(name, ast.unparse(value))
        case ast.Constant(value=str(name)), _:
            yield Given(name, ast.unparse(value))
        case ast.Subscript(slice=ast.Constant(value=str(name))), _:
            yield Given(name, ast.unparse(value))


def _of_signs(code: str) -> Iterator[Given]:
    for one in MACRO.finditer(code):
        yield Given(one["name"], one["value"].strip())
    several = [*SEVERAL.finditer(code)]
    for one in several:
        names = [name.strip() for name in one["names"].split(",")]
        inside = one["value"].strip()
        inner = inside[inside.find("(") + 1 : inside.rfind(")")] if "(" in inside else inside
        values = _split(inner)
        for k, name in enumerate(names[:-1] if len(values) != len(names) else names):
            if len(values) == len(names):
                yield Given(name, values[k])
    apart = {one.end("names") for one in several}
    for one in SIGN.finditer(code):
        if one.end("name") not in apart:
            yield Given(one["name"], _split(one["value"].rstrip("} "))[0])
    calls = [(m["name"], _split(_bracket(code, m.end()))) for m in CALL.finditer(code)]
    for (name, head), (_, args) in (
        (one, other) for one in calls for other in calls
        if one[0] == other[0] and one[1] != other[1] and len(one[1]) == len(other[1])
    ):  # fmt: skip
        own = [re.search(rf"({WORD})\s*$", part) for part in head]
        if name and all(own):
            yield from (
                Given(m[1], value, alone=False)
                for m, value in zip(own, args, strict=True) if m is not None
            )  # fmt: skip


def _bracket(code: str, start: int) -> str:
    """What stands in a bracket that opens before a place."""
    depth = 1
    for k in range(start, len(code)):
        depth += (code[k] in "([{") - (code[k] in ")]}")
        if depth == 0:
            return code[start:k]
    return code[start:]


def _split(text: str) -> list[str]:
    """Parts between commas, up to a bracket that closes what is open before the text."""
    parts, depth = [""], 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        if depth < 0:
            break
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts]


def is_formula(given: Given, own: frozenset[str], every: Mapping[str, list[Given]]) -> bool:
    """Whether a value says that a name is made of other ones.

    Parameters
    ----------
    given : Given
    own : frozenset of str
        What the name may be called: a value of these says nothing new.
    every : mapping of str to list of Given
        Of the file, by their names; a name that stands alone is what it is given.
    """
    seen, todo = {given.name, *own}, [given.value]
    while todo:
        value = CASTS.sub("(", STRING.sub(" ", todo.pop())).strip("() ")
        if re.fullmatch(WORD, value):
            todo += [one.value for one in every.get(value, ()) if one.alone and value not in seen]
            seen.add(value)
        elif _joins(value):
            return True
    return False


def _joins(value: str) -> bool:
    """Whether a value is made of names: 2*L, sqrt(L), 2*p.L, and neither p.L, y[1] nor pi/2."""
    scaled = any(m["of"] is not None for m in NUMBER.finditer(value))
    rest = KEYWORD.sub(" ", CALLED.sub(" ", NUMBER.sub(" ", value)))
    parts = [m[0].split(".")[-1] for m in PLACED.finditer(rest)]
    rest = PLACED.sub(" ", rest)
    names = {m[0] for m in PATH.finditer(rest)} - CONSTANTS
    joined = scaled or OPERATOR.search(rest) is not None
    return bool(names or (joined and {*parts} - CONSTANTS))
