"""What a solver of SciPy is told beside the law: how exactly it solves, or something else.

solve_ivp(f, span, y0, rtol=1e-8)       how exactly
solve_ivp(f, span, y0, jac=jac)         what nothing compares with the rates
solve_ivp(f, span, y0, **options)       anything, where nothing here says what is in it
"""

import ast
import builtins
from collections.abc import Collection, Iterator, Mapping, Sequence

from mechanics.claims.code.around.library_names import is_library
from mechanics.claims.code.around.python_form import (
    STATE_FIRST,
    TIME_FIRST,
    arguments_of,
    defaults_of,
    word,
)

SOLVERS = frozenset((*TIME_FIRST, *STATE_FIRST))
OPTIONS = frozenset(
    ("fun", "func", "t_span", "y0", "t0", "t", "t_bound", "method", "t_eval", "dense_output",
     "events", "vectorized", "rtol", "atol", "max_step", "first_step", "min_step", "jac_sparsity",
     "lband", "uband", "args", "tfirst", "full_output", "printmessg", "mxstep", "hmax", "hmin",
     "h0", "ixpr", "mxhnil", "mxordn", "mxords", "tcrit", "ml", "mu", "col_deriv")
)  # fmt: skip
"""What leaves the law as it is, or is looked at itself."""
BY_PLACE = {"ode": 1, "odeint": 4}
"""How many arguments have a place before that of a Jacobian."""


def told_more(tree: ast.AST) -> Iterator[ast.Call]:
    """Calls of solvers that tell them what is not known to leave the law as it is.

    Parameters
    ----------
    tree : ast.Module
    """
    nodes = [*ast.walk(tree)]
    values, given_as, known = _values(nodes), _given_as(nodes), _of_scipy(nodes)
    passed = {n.args.kwarg.arg for n in nodes if isinstance(n, ast.FunctionDef) and n.args.kwarg}
    told = {k.arg for n in nodes if isinstance(n, ast.Call) for k in n.keywords}
    if told & {"jac", "Dfun", "mass"}:
        passed = set()  # they may go to a solver by ``**options`` of a function
    for one in nodes:
        if isinstance(one, ast.Call) and word(one.func) in SOLVERS:
            given = {k.arg: k.value for k in one.keywords if k.arg}
            whole = [k.value for k in one.keywords if k.arg is None]
            more = len(one.args) > BY_PLACE.get(word(one.func), len(one.args))
            if (
                more
                or any(not _is_told(name, value) for name, value in given.items())
                or not ("method" not in given or _is_method(given["method"], given_as, known))
                or not all(word(w) in passed or _holds_options(w, values) for w in whole)
            ):
                yield one


def _is_told(name: str, value: ast.expr) -> bool:
    return name in OPTIONS or (isinstance(value, ast.Constant) and value.value in (None, False))


def _of_scipy(nodes: Sequence[ast.AST]) -> set[str]:
    """Names that are no solver but SciPy's: of SciPy, of Python, and arguments."""
    known = {*dir(builtins), *(n.arg for n in nodes if isinstance(n, ast.arg))}
    for one in nodes:
        if isinstance(one, ast.Import):
            known |= {
                (a.asname or a.name).partition(".")[0] for a in one.names if is_library(a.name)
            }
        elif isinstance(one, ast.ImportFrom) and is_library(one.module or ""):
            known |= {a.asname or a.name for a in one.names}
    return known - {n.name for n in nodes if isinstance(n, ast.ClassDef)}


def _given_as(nodes: Sequence[ast.AST]) -> dict[str, list[ast.expr]]:
    """What names may be: assigned, one by one in a loop, an argument's default, or given."""
    found: dict[str, list[ast.expr]] = {}
    takes = {n.name: arguments_of(n.args) for n in nodes if isinstance(n, ast.FunctionDef)}
    for one in nodes:
        pairs: list[tuple[str, ast.expr]] = []
        match one:
            case ast.Assign(targets=targets, value=value):
                pairs = [(word(t), value) for target in targets for t in ast.walk(target)]
            case ast.For(target=target, iter=value) | ast.comprehension(target=target, iter=value):
                pairs = [(word(t), value) for t in ast.walk(target)]
            case ast.FunctionDef(args=args) | ast.Lambda(args=args):
                pairs = defaults_of(args)
            case ast.Call(func=func, args=args, keywords=keywords):
                pairs = [*zip(takes.get(word(func), ()), args, strict=False)]
                pairs += [(k.arg, k.value) for k in keywords if k.arg]
        for name, value in pairs:
            found.setdefault(name, []).append(value)
    return found


def _is_method(
    value: ast.expr, given: Mapping[str, Sequence[ast.expr]], known: Collection[str],
    seen: frozenset[str] = frozenset(),
) -> bool:  # fmt: skip
    """Whether a method can be none but SciPy's: a text, of which it knows its own, or a class."""
    names = {n.id for n in ast.walk(value) if isinstance(n, ast.Name)} - seen
    return all(
        (name in known or name in given)
        and all(_is_method(one, given, known, seen | {name}) for one in given.get(name, ()))
        for name in names
    )


def _values(nodes: Sequence[ast.AST]) -> dict[str, list[ast.expr]]:
    found: dict[str, list[ast.expr]] = {}
    for one in nodes:
        match one:
            case ast.Assign(targets=targets, value=value):
                for target in targets:
                    if isinstance(target, ast.Subscript):
                        entry = ast.Dict([target.slice], [value])
                        found.setdefault(word(target.value), []).append(entry)
                    else:
                        found.setdefault(word(target), []).append(value)
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                found.setdefault(word(target), []).append(value)
            case ast.Call(func=ast.Attribute(attr="update" | "setdefault", value=base)):
                found.setdefault(word(base), []).append(one)
    return found


def _holds_options(node: ast.expr, values: Mapping[str, Sequence[ast.expr]]) -> bool:
    """Whether what is spread holds known options, and no arguments of the law."""
    known = OPTIONS - {"args", "fun", "func", "y0"}
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            made = values.get(name, ())
            return bool(made) and all(
                not isinstance(one, ast.Name) and _holds_options(one, values) for one in made
            )
        case ast.Dict(keys=keys):
            return all(isinstance(k, ast.Constant) and k.value in known for k in keys)
        case ast.Call(func=ast.Name(id="dict"), args=[], keywords=given):
            return all(k.arg in known for k in given)
    return False
