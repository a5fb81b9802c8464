"""What a solver of SciPy is told beside the law: how exactly it solves, or something else.

solve_ivp(f, span, y0, rtol=1e-8)       how exactly
solve_ivp(f, span, y0, jac=jac)         what nothing compares with the rates
solve_ivp(f, span, y0, **options)       anything, where nothing here says what is in it
"""

import ast
from collections.abc import Iterator, Mapping, Sequence

from mechanics.claims.code.python_form import STATE_FIRST, TIME_FIRST, word

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
    values = _values(nodes)
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
                or not all(word(w) in passed or _holds_options(w, values) for w in whole)
            ):
                yield one


def _is_told(name: str, value: ast.expr) -> bool:
    return name in OPTIONS or (isinstance(value, ast.Constant) and value.value in (None, False))


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
