"""Statements of Python in the intermediate form.

y[i + 1] = y[i] + h*rate(t, y[i], g=g)      set(entry(y, ...), ...), arguments in their order
self.w, s["w"]                              names with a dot
solve_ivp(rate, span, y0, args=(m, l))      solve_ivp(handle(t y, call(rate, t, y, m, l)), ...)
"""

import ast
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from mechanics.claims.code.around.intermediate_form import EITHER, Term

SIGNS: dict[type[ast.operator], str] = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "^", ast.Mod: "%",
    ast.MatMult: "@", ast.FloorDiv: "//",
}  # fmt: skip
SAME = frozenset(
    ("array", "asarray", "float", "copy", "deepcopy", "float64", "list", "tuple", "ravel",
     "flatten", "squeeze", "tolist", "item", "atleast_1d", "hstack", "concatenate")
)  # fmt: skip
"""Calls that leave a value as it is."""
VIEWS = frozenset(("asarray", "asanyarray", "ascontiguousarray", "ravel", "squeeze", "atleast_1d",
                   "view", "reshape", "transpose"))  # fmt: skip
"""Calls that give the same array, not another one."""
PARSED = frozenset(("float", "int", "loads", "float64", "float32", "Fraction", "Decimal",
                    "literal_eval", "complex", "int64"))  # fmt: skip
"""Calls that read a number from a text."""
MODULES = frozenset(("np", "numpy", "math", "jnp", "plt", "scipy", "sp", "copy", "integrate", "la"))
TIME_FIRST = ("solve_ivp", "RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA", "ode")
STATE_FIRST = ("odeint",)
ARCTANGENTS = (["arctan2", "sin", "cos"], ["atan2", "sin", "cos"])
DEFINED = (ast.FunctionDef, ast.AsyncFunctionDef)
SILENT = (*DEFINED, ast.ClassDef, ast.Import, ast.ImportFrom, ast.Pass, ast.Global, ast.Nonlocal,
          ast.Raise)  # fmt: skip
"""Statements that compute nothing where they stand."""
NOW, NEXT = Term("number", "1007"), Term("number", "1008")
"""Two times, one after the other."""
SOLVED = (Term("name", "solver.t", (), "solver.t"), Term("name", "solver.y", (), "solver.y"))
"""What a solver calls a function with."""
ABSENT = Term("absent")
"""An argument that a call leaves to its default."""


def word(node: ast.AST) -> str:
    """The last name of a name or attribute."""
    return getattr(node, "id", "") or getattr(node, "attr", "")


@dataclass(frozen=True)
class PythonFile:
    """What the form of a statement depends on.

    Attributes
    ----------
    takes : mapping of str to sequence of str
        Names of arguments of the functions of the file.
    lines : sequence of str
        Its text.
    calls : mapping of str to str
        Functions that objects are when they are called.
    started : str
        What ``ode`` of SciPy is handed.
    lists : frozenset of str
        Names of lists, of which y[:] is a copy.
    records : mapping of str to sequence of str
        Named tuples of the file, with their fields in order.
    """

    takes: Mapping[str, Sequence[str]]
    lines: Sequence[str] = ()
    calls: Mapping[str, str] = field(default_factory=dict)
    started: str = ""
    lists: frozenset[str] = frozenset()
    records: Mapping[str, Sequence[str]] = field(default_factory=dict)


def block(body: Sequence[ast.stmt], file: PythonFile) -> Term:
    """Statements, one after the other."""
    return Term("block", "", tuple(statement(one, file) for one in body))


def statement(node: ast.stmt, file: PythonFile) -> Term:
    """A statement, with the line in which it begins."""
    return _with_text(_statement(node, file), _first_line(node, file))


def _first_line(node: ast.stmt, file: PythonFile) -> str:
    first = file.lines[node.lineno - 1] if 0 < node.lineno <= len(file.lines) else ""
    return " ".join(first.split()) or ast.unparse(node).partition("\n")[0]


def _with_text(term: Term, text: str) -> Term:
    """A statement with its line; so are those that it is made of and that have no own line."""
    if term.kind == "block":
        term = replace(term, parts=tuple(p if p.text else _with_text(p, text) for p in term.parts))
    return replace(term, text=text)


def _statement(node: ast.stmt, file: PythonFile) -> Term:
    def of(part: ast.expr) -> Term:
        return expression(part, file)

    def head(part: ast.expr) -> Term:
        return replace(of(part), text=_first_line(node, file))

    match node:
        case ast.Assign(targets=[target], value=value):
            return Term("set", "", (of(target), of(value)))
        case ast.Assign(targets=[*targets, last], value=value):
            sets = [Term("set", "", (of(last), of(value)))]
            sets += [Term("set", "", (of(target), of(last))) for target in targets]
            return Term("block", "", tuple(sets))
        case ast.AnnAssign(target=target, value=ast.expr() as value):
            return Term("set", "", (of(target), of(value)))
        case ast.AugAssign(target=target, op=op, value=value):
            return Term("set", SIGNS.get(type(op), "?"), (of(target), of(value)))
        case ast.Expr(value=value):
            return of(value)
        case ast.Return(value=value):
            return Term("return", "", (of(value),) if value is not None else ())
        case ast.For() | ast.AsyncFor() | ast.While():
            loop = replace(_loop(node, file), text=_first_line(node, file))
            return Term("block", "", (loop, block(node.orelse, file))) if node.orelse else loop
        case ast.If(test=test, body=body, orelse=other):
            return Term("case", "", (head(test), block(body, file), block(other, file)))
        case ast.Match(subject=subject, cases=cases):
            heads = [head(subject), *(head(c.guard) for c in cases if c.guard is not None)]
            names = [Term("set", "", (Term("name", n), Term("other"))) for n in _captured(cases)]
            return Term("case", "", (*heads, *names, *(block(c.body, file) for c in cases)))
        case ast.With(items=items, body=body) | ast.AsyncWith(items=items, body=body):
            return Term("block", "", (*(head(i.context_expr) for i in items), block(body, file)))
        case ast.Try() | ast.TryStar():
            others = [block(handler.body, file) for handler in node.handlers]
            parts = (block(lines, file) for lines in (node.body, node.orelse, node.finalbody))
            return Term("block", "", (*parts, Term("case", "", tuple(others))))
        case ast.Assert(test=test):
            return Term("call", "assert", (of(test),))
        case ast.Break() | ast.Continue():
            return Term("jump", type(node).__name__.lower())
        case _ if isinstance(node, (*SILENT, ast.AnnAssign)):
            return Term("block")
        case _:
            inside = [n for n in ast.iter_child_nodes(node) if isinstance(n, ast.expr)]
            return Term("other", "", tuple(map(of, inside)))


def _captured(cases: Sequence[ast.match_case]) -> list[str]:
    """Names that patterns give a value."""
    inside = [n for one in cases for n in ast.walk(one.pattern)]
    names = [getattr(n, "rest" if isinstance(n, ast.MatchMapping) else "name", None)
             for n in inside if isinstance(n, ast.pattern)]  # fmt: skip
    return [name for name in names if name]


def _loop(node: ast.For | ast.AsyncFor | ast.While, file: PythonFile) -> Term:
    body = block(node.body, file)
    if isinstance(node, ast.While):
        test = replace(expression(node.test, file), text=_first_line(node, file))
        return Term("loop", "", (Term("list"), Term("block", "", (test, *body.parts))))
    target, over = node.target, node.iter
    if (pair := _neighbours(target, over)) is not None:
        grid = expression(pair[2], file)
        sets = (
            Term("set", "", (expression(part, file), Term("entry", "", (grid, place))))
            for part, place in zip(pair[:2], (NOW, NEXT), strict=True)
        )
        return Term("loop", "", (Term("list"), Term("block", "", (*sets, body))))
    counter = target.id if isinstance(target, ast.Name) else ""
    limits: tuple[Term, ...] = (expression(over, file),)
    ends = over.args[:2] if isinstance(over, ast.Call) and word(over.func) == "linspace" else ()
    values = over.elts if isinstance(over, ast.List | ast.Tuple) else ends
    if values and isinstance(target, ast.Name):
        entry = Term("choice", EITHER, tuple(expression(part, file) for part in values))
        first = Term("set", "", (expression(target, file), entry))
        return Term("loop", "", (Term("list"), Term("block", "", (first, *body.parts))))
    match target, over:
        case ast.Name(), ast.Call(func=ast.Name(id="range"), args=args) if len(args) < 3:
            given = [expression(arg, file) for arg in args]
            first = given[0] if len(given) == 2 else Term("number", "0")
            limits = (first, Term("binary", "-", (given[-1], Term("number", "1"))))
        case ast.Tuple(elts=[ast.Name(id=counter), *_]), ast.Call(func=ast.Name(id="enumerate")):
            pass
        case _:
            counter = ""
    # What a loop takes from something is not what had the same name before.
    names = {n.id for n in ast.walk(target) if isinstance(n, ast.Name)} - {counter}
    sets = (Term("set", "", (Term("name", name), Term("other"))) for name in sorted(names))
    body = Term("block", "", (*sets, *body.parts))
    return Term("loop", counter, (Term("list", "", limits), body))


def _neighbours(target: ast.expr, over: ast.expr) -> tuple[ast.expr, ast.expr, ast.expr] | None:
    """What a loop over pairs of times sets: for a, b in zip(ts[:-1], ts[1:])."""
    match target, over:
        case ast.Tuple(elts=[before, after]), ast.Call(
            func=ast.Name(id="zip"), args=[ast.Subscript(value=grid), other]
        ) if ast.unparse(over.args[0]) == f"{ast.unparse(grid)}[:-1]" and (
            ast.unparse(other) in (f"{ast.unparse(grid)}[1:]", ast.unparse(grid))):  # fmt: skip
            return before, after, grid
    return None


def expression(node: ast.expr, file: PythonFile) -> Term:
    """A formula; what is only another view of an array is written as the array."""
    made = _expression(node, file)
    return made if _is_view(node, file) else replace(made, text=ast.unparse(node))


def _is_view(node: ast.expr, file: PythonFile) -> bool:
    """Whether it is the whole of an array, no copy: y.ravel(), np.asarray(y), y.T, y[:]."""
    match node:
        case ast.Attribute(attr="T"):
            return True
        case ast.Subscript(
            value=base, slice=ast.Slice(lower=None, upper=None, step=None), ctx=ast.Load()
        ):
            return word(base) not in file.lists
        case ast.Call(func=func):
            return word(func) in VIEWS and word(func) not in file.takes
    return False


def _expression(node: ast.expr, file: PythonFile) -> Term:
    def of(part: ast.expr) -> Term:
        return expression(part, file)

    match node:
        case ast.Constant(value=bool()):
            return Term("other")
        case ast.Constant(value=int() | float() as value):
            return Term("number", str(value))
        case ast.Name(id=name):
            return Term("name", name)
        case ast.Attribute(value=base, attr="T"):
            return of(base)
        case ast.Attribute(value=base, attr=attribute):
            return _part(of(base), attribute)
        case ast.Subscript() if (entry := _written_entry(node)) is not None:
            return of(entry)
        case ast.Subscript(value=base, slice=ast.Constant(value=str(key))):
            return _part(of(base), key)
        case ast.Subscript(value=base) if _is_view(node, file):
            return of(base)
        case ast.Subscript(value=base, slice=index):
            inner = of(base)
            places = index.elts if isinstance(index, ast.Tuple) else [index]
            if any(isinstance(p, ast.Slice) and p.step is not None for p in places):
                return Term("other", "", (inner,))
            before = inner.parts if inner.kind == "entry" else (inner,)
            return Term("entry", "", (*before, *(_place(p, file) for p in places)))
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return Term("minus", "", (of(inner),))
        case ast.UnaryOp(op=ast.UAdd(), operand=inner):
            return of(inner)
        case ast.BinOp() | ast.Call() if (angle := unwrapped_angle(node)) is not None:
            return Term("turn", "", tuple(map(of, angle)))
        case ast.BinOp(left=left, op=op, right=right):
            return Term("binary", SIGNS.get(type(op), "?"), (of(left), of(right)))
        case ast.List(elts=parts) | ast.Tuple(elts=parts):
            return Term("list", "", tuple(map(of, parts)))
        case ast.Dict(keys=keys, values=values):
            pairs = zip(keys, values, strict=True)
            return Term("list", "", tuple(
                Term("set", "", (Term("name", k.value), of(v)))
                if isinstance(k, ast.Constant) and isinstance(k.value, str)
                else Term("other", "", (of(v),)) for k, v in pairs
            ))  # fmt: skip
        case ast.NamedExpr(target=target, value=value):
            return Term("block", "", (Term("set", "", (of(target), of(value))),))
        case ast.ListComp() | ast.SetComp() | ast.GeneratorExp():
            return Term("list", "", (_of_each(node.elt, node.generators, file),))
        case ast.IfExp(test=test, body=yes, orelse=no):
            return Term("choice", EITHER, (of(yes), of(no), Term("choice", "", (of(test),))))
        case ast.BoolOp(values=values):
            return Term("choice", EITHER, tuple(map(of, values)))
        case ast.Compare() | ast.JoinedStr() | ast.FormattedValue():
            inside = [n for n in ast.iter_child_nodes(node) if isinstance(n, ast.expr)]
            return Term("choice", "", tuple(map(of, inside)))
        case ast.UnaryOp(op=ast.Not(), operand=inner):
            return Term("choice", "", (of(inner),))
        case ast.Starred(value=value):
            return Term("star", "", (of(value),))
        case ast.Lambda(args=args, body=body):
            return Term("handle", " ".join(arguments_of(args)), (of(body),))
        case ast.Call():
            return _call(node, file)
        case _:
            inside = [n for n in ast.iter_child_nodes(node) if isinstance(n, ast.expr)]
            return Term("other", "", tuple(map(of, inside)))


def _written_entry(node: ast.Subscript) -> ast.expr | None:
    """The entry that is taken of what is written out there: [0.5, 1.0][-1], dict(l=1)["l"]."""
    try:
        match node.value, ast.literal_eval(node.slice):
            case ast.List(elts=parts) | ast.Tuple(elts=parts), int(place):
                spread = any(isinstance(part, ast.Starred) for part in parts)
                return None if spread else parts[place]
            case ast.Call(func=ast.Name(id="dict"), args=[], keywords=given), str(key):
                return {k.arg: k.value for k in given}.get(key)
            case ast.Dict(keys=keys, values=values), key:
                words = [k.value if isinstance(k, ast.Constant) else None for k in keys]
                return dict(zip(words, values, strict=True)).get(key)
    except (ValueError, IndexError, TypeError):
        return None
    return None


def _of_each(node: ast.expr, generators: Sequence[ast.comprehension], file: PythonFile) -> Term:
    """An entry of a list, with entries of what it is made of."""
    made = expression(node, file)
    for one in reversed(generators):
        match one.target, expression(one.iter, file):
            case ast.Name(id=name), over if over.kind != "call" or over.name in file.takes:
                entry = Term("entry", "", (over, Term("other")), over.text)
                made = _with(made, name, entry)
    return made


def _with(term: Term, name: str, other: Term) -> Term:
    """A term with another one for a name."""
    if term.kind == "name" and term.name == name:
        return other
    return replace(term, parts=tuple(_with(part, name, other) for part in term.parts))


def _part(base: Term, name: str) -> Term:
    if base.kind == "name":
        return Term("name", f"{base.name}.{name}")
    return Term("field", name, (base,))


def _place(node: ast.expr, file: PythonFile) -> Term:
    match node:
        case ast.Slice(lower=None, upper=None, step=None):
            return Term("whole")
        case ast.Slice(lower=lower, upper=upper, step=None):
            first = Term("number", "0") if lower is None else expression(lower, file)
            last = Term("whole") if upper is None else Term(
                "binary", "-", (expression(upper, file), Term("number", "1"))
            )  # fmt: skip
            return Term("range", "", (first, last))
    return expression(node, file)


def arguments_of(args: ast.arguments) -> list[str]:
    """Names of arguments, without that of the object."""
    names = [a.arg for a in (*args.posonlyargs, *args.args, *args.kwonlyargs)]
    return [n for n in names if n not in ("self", "cls")]


def defaults_of(args: ast.arguments) -> list[tuple[str, ast.expr]]:
    """Arguments that a call may leave out, with what they are then."""
    placed = [*args.posonlyargs, *args.args]
    pairs = [*zip(placed[::-1], args.defaults[::-1], strict=False)]
    pairs += [(a, v) for a, v in zip(args.kwonlyargs, args.kw_defaults, strict=True) if v]
    return [(a.arg, value) for a, value in pairs]


def _call(node: ast.Call, file: PythonFile) -> Term:
    name, owner = word(node.func), _owner(node, file)
    match node.args:
        case [ast.Constant(value=str(text))] if name in PARSED and name not in file.takes:
            return _number_in(text, file)
        case [ast.Name(id="float") as kind, ast.List(elts=parts) | ast.Tuple(elts=parts)] if (
            name == "map" and name not in file.takes):  # fmt: skip
            made = [expression(ast.Call(kind, [part], []), file) for part in parts]
            return Term("list", "", tuple(made))
    given = [expression(arg, file) for arg in node.args]
    if name in SAME | VIEWS and name not in file.takes:
        if len(given) + len(owner) == 1 and (name in SAME or not node.keywords):
            return (*owner, *given)[0]
        if name == "reshape" and owner and ast.unparse(node.args[0]) == "-1":
            return owner[0]
    name = file.calls.get(ast.unparse(node.func), name)
    if name in file.records and name not in file.takes:
        return Term(
            "list", "", tuple(_in_order(file.records[name], node.args, node.keywords, file))
        )
    if name in file.takes:
        ordered = _in_order(file.takes[name], node.args, node.keywords, file)
        return Term("call", name, tuple(ordered))
    if name == "partial" and given and (handed := word(node.args[0])) in file.takes:
        return _partial(handed, node.args[1:], node.keywords, file)
    options = [_option(k, file) for k in node.keywords]
    laws = [*node.args[:1], *(k.value for k in node.keywords if k.arg in ("fun", "func"))]
    if name in (*TIME_FIRST, *STATE_FIRST) and laws:
        given = [_handed(name, laws[0], node, file), *given[1:]]
        options = [one for one in options if one.parts[0].name not in ("fun", "func", "events")]
    if name == "set_f_params" and file.started:
        called = Term("call", file.started, (*SOLVED, *given))
        given = [Term("handle", " ".join(one.name for one in SOLVED), (called,))]
    if not name:
        return Term("other", "", (expression(node.func, file), *given, *options))
    return Term("call", name, (*owner, *given, *options))


def _number_in(text: str, file: PythonFile) -> Term:
    """The number that a text is, or what it holds: float("-0.5"), json.loads('{"l": 1}')."""
    try:
        return Term("number", str(Fraction(text)))
    except (ValueError, ZeroDivisionError):
        pass
    try:
        return (
            _expression(ast.parse(text, mode="eval").body, file) if "{" in text else Term("other")
        )
    except SyntaxError:
        return Term("other")


def _owner(node: ast.Call, file: PythonFile) -> tuple[Term, ...]:
    """The object whose method a call is; nothing for a function of a module."""
    if not isinstance(node.func, ast.Attribute) or word(node.func.value) in MODULES:
        return ()
    return (expression(node.func.value, file),)


def _option(keyword: ast.keyword, file: PythonFile) -> Term:
    value = expression(keyword.value, file)
    if keyword.arg is None:
        return Term("star", "", (value,))
    return Term("set", "", (Term("name", keyword.arg), value))


def _in_order(
    takes: Sequence[str], args: Sequence[ast.expr], keywords: Sequence[ast.keyword],
    file: PythonFile,
) -> list[Term]:  # fmt: skip
    """Arguments of a call in the order in which the function has them."""
    made = [expression(arg, file) for arg in args]
    given: dict[str, Term] = {}
    for keyword in keywords:
        match keyword:
            case ast.keyword(arg=str(name), value=value):
                given[name] = expression(value, file)
            case ast.keyword(value=ast.Call(func=ast.Name(id="dict"), keywords=inner)):
                given |= {k.arg: expression(k.value, file) for k in inner if k.arg}
    if any(part.kind == "star" for part in made):
        return [*made, *(_option(k, file) for k in keywords if k.arg)]
    last = max((k for k, name in enumerate(takes) if name in given), default=-1)
    return made + [given.get(name, ABSENT) for name in takes[len(made) : last + 1]]


def _partial(
    name: str, args: Sequence[ast.expr], keywords: Sequence[ast.keyword], file: PythonFile
) -> Term:
    takes = file.takes[name]
    made = _in_order(takes, args, keywords, file)
    open_ = [n for k, n in enumerate(takes) if k >= len(made) or made[k] is ABSENT][:2]
    whole = [
        made[k] if k < len(made) and made[k] is not ABSENT
        else Term("name", n, (), n) if n in open_ else ABSENT
        for k, n in enumerate(takes)
    ]  # fmt: skip
    return Term("handle", " ".join(open_), (Term("call", name, tuple(whole)),))


def _handed(name: str, first: ast.expr, node: ast.Call, file: PythonFile) -> Term:
    """What a solver is handed, as a function without a name of time, state and parameters."""
    options = {k.arg: k.value for k in node.keywords if k.arg}
    if name == "odeint" and len(node.args) > 3:
        options.setdefault("args", node.args[3])
    if name == "solve_ivp" and len(node.args) > 8:
        options.setdefault("args", node.args[8])
    late = name in STATE_FIRST and not (
        isinstance(tfirst := options.get("tfirst"), ast.Constant) and tfirst.value is True
    )
    made = expression(first, file)
    handed = file.calls.get(ast.unparse(first), word(first))
    if made.kind == "handle":
        takes = made.name.split()
        return replace(made, name=" ".join([*takes[:2][::-1], *takes[2:]] if late else takes))
    if isinstance(first, ast.Call):
        handed = file.calls.get(word(first.func), "")
    if not handed:
        return made
    given = [*(SOLVED[::-1] if late else SOLVED)]
    if "args" in options:
        given.append(Term("star", "", (expression(options["args"], file),)))
    return Term("handle", "solver.t solver.y", (Term("call", handed, tuple(given)),))


def unwrapped_angle(node: ast.expr) -> tuple[ast.expr, ...] | None:
    """The angle of which another one is taken, and the turn: (x + pi) % (2*pi) - pi."""
    match node:
        case ast.BinOp(left=ast.BinOp(left=ast.BinOp(left=inner, op=ast.Add(), right=half),
                                      op=ast.Mod(), right=turn),
                       op=ast.Sub(), right=again) if (
            _is_pi(half) and _is_pi(again) and _is_turn(turn)):  # fmt: skip
            return inner, turn
        case ast.BinOp(left=inner, op=ast.Mod(), right=turn) if _is_turn(turn):
            return inner, turn
        case ast.Call(args=[ast.Call(args=[inner]) as sine, ast.Call(args=[same]) as cosine]) if (
            [word(n) for n in (node.func, sine.func, cosine.func)] in ARCTANGENTS
            and ast.unparse(inner) == ast.unparse(same)):  # fmt: skip
            return (inner,)
    return None


def _is_pi(node: ast.expr) -> bool:
    return word(node) == "pi"


def _is_turn(node: ast.expr) -> bool:
    match node:
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return _is_pi(left) or _is_pi(right)
    return word(node) == "tau"
