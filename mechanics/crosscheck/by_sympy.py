"""SymPy's own `KanesMethod` and `LagrangesMethod` as witnesses beside the routes of the same name.

kane = kane_sympy,    lagrange = lagrange_sympy        the same accelerations

The pairs with other routes follow. A scene that SymPy would not finish has no such column, and the
column says why.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

from mechanics.checks.agreement import subject_of
from mechanics.clock import timed
from mechanics.compiled import Model, compile
from mechanics.crosscheck.programs import Programs, same_motion
from mechanics.crosscheck.sympy_table import too_large
from mechanics.equations import Equations
from mechanics.kernel import Finding, follows
from mechanics.report.result import RouteResult
from mechanics.routes import kane_sympy, lagrange_sympy
from mechanics.scene import Scene

METHODS: Mapping[str, tuple[str, Callable[[Scene], Equations]]] = {
    "kane": ("kane_sympy", kane_sympy.derive),
    "lagrange": ("lagrange_sympy", lagrange_sympy.derive),
}
"""By route: the name of its witness, and what derives it."""


@dataclass(frozen=True)
class BySympy:
    """Columns of SymPy's methods, and what became of each beside every route."""

    columns: Mapping[str, RouteResult]
    pairs: Mapping[tuple[str, str], Finding]


def by_sympy(
    scene: Scene,
    programs: Programs,
    routes: Mapping[tuple[str, str], Finding],
    stage: Callable[[str], None],
) -> BySympy:
    """Derive by SymPy's methods and compare.

    Parameters
    ----------
    programs : Programs
        Of the routes.
    routes : mapping of (str, str) to Finding
        Pairs of routes.
    """
    columns: dict[str, RouteResult] = {}
    pairs: dict[tuple[str, str], Finding] = {}
    for route, (name, derive) in METHODS.items():
        if route not in programs.routes:
            continue
        if why_not := too_large(programs.mechanism, name):
            columns[name] = RouteResult(None, 0.0, 0, absent=why_not)
            continue
        stage(f"deriving by {name}")
        equations, seconds = timed(partial(derive, scene))
        pairs[route, name] = same_motion(subject_of(route, name), programs, route, equations)
        columns[name] = RouteResult(None, seconds, matrix_operations(compile(equations)))
    for route, name in [*pairs]:
        known = {**routes, **pairs}
        for (one, two), finding in known.items():
            premises = [finding, known[route, name]]
            if route in (one, two) and name not in (one, two) and all(p.shown for p in premises):
                other = two if one == route else one
                pairs[other, name] = follows(subject_of(other, name), premises)
    return BySympy(columns, pairs)


def matrix_operations(model: Model) -> int:
    """Operations of M and f, common subexpressions shared."""
    return sum(model.casadi[name].n_instructions() for name in ("mass_matrix", "forcing"))
