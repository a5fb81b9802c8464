"""Forms of forward dynamics: algebra that is equal and rounds differently.

    elimination    M = L D L^T; where K is not symmetric, along pivots that were tried
    primitive      the same after common factors were divided out of rows and columns
    rearranged     pivots d_i = m_i / m_(i+1), minors written without a subtraction where they can
    fewest         nested polynomials, in quotients or eliminated, if they take fewer operations
    composite      M by composite bodies, then L D L^T
    articulated    articulated bodies, joint by joint, without M
    recursive      Gauss's function of a tree made least, from its leaves to its root and back
    sparse         the same with the constraints of closed loops, where few entries fill in

Each solves K x = k, K = [[M, -B], [A, 0]], x = (u', lambda), is shown to, and its graph is proved
to. The last four start from the bodies and need no matrix that is written out; elimination takes
the rows of a program where there is none.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import casadi as ca
from sympy import Matrix

from mechanics.compiled.forms.bodies import no_joint_tree, no_loops, no_spanning_tree, no_tree
from mechanics.compiled.forms.entries import entry_polynomials, nested_entries
from mechanics.compiled.forms.factor import Pivots, solve_general
from mechanics.compiled.forms.fewest import nested_quotients
from mechanics.compiled.forms.leading_minors import MOST, trailing_minors
from mechanics.compiled.forms.operations import operations
from mechanics.compiled.forms.primitive import primitive
from mechanics.compiled.forms.system import System
from mechanics.compiled.forms.weigh import MOST as MOST_DIGITS
from mechanics.compiled.forms.weigh import ROUNDINGS, digits_lost
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError
from mechanics.kernel.ring import TooLarge


def _always(equations: Equations) -> str:
    return ""


@dataclass(frozen=True)
class Form:
    """One way to write the solution of K x = k.

    Attributes
    ----------
    name : str
    meaning : str
        In a phrase.
    unsuited : callable
        Why a set of equations cannot be solved in this form; empty where it can.
    solve : callable or None
        From K and k to the graph of x; None for a form that starts from the bodies.
    """

    name: str
    meaning: str
    unsuited: Callable[[Equations], str]
    solve: Callable[[System], ca.SX] | None = None

    def ways(self, system: System) -> list[ca.SX]:
        """The graphs of x in this form, each shown to be a solution."""
        if self.solve is None:
            return system.from_bodies(self.name)
        graph = self.solve(system)
        return [graph] if system.solved_by(graph) else []


def named_form(name: str, equations: Equations) -> Form:
    """The form of a name.

    Raises
    ------
    InputError
        If there is no such form, or the equations have no such one; it names those that they have.
    """
    for form in FORMS:
        if form.name == name:
            if why := form.unsuited(equations):
                suited = ", ".join(f.name for f in FORMS if not f.unsuited(equations))
                raise InputError(f"form {name!r}: {why}: choose among {suited}, or 'auto'")
            return form
    raise InputError(f"form {name!r}: the forms are auto, {', '.join(f.name for f in FORMS)}")


def preferred(equations: Equations) -> Form:
    """The first form of `PREFERRED` that suits the equations."""
    return next(form for form in PREFERRED if not form.unsuited(equations))


def _few(equations: Equations) -> str:
    n = equations.system[0].rows
    return f"{n} unknowns, at most {MOST} can be written out" if n > MOST else ""


def _readable(equations: Equations) -> str:
    try:
        primitive(*equations.system)
    except TooLarge as error:
        return f"the entries have no normal form that is small enough ({error})"
    return ""


def _small_and_readable(equations: Equations) -> str:
    return _few(equations) or _readable(equations)


def _elimination(system: System) -> ca.SX:
    """Along pivots that were tried, or the regular ones where those lose digits."""
    usual = system.solve(system.graphs[1])
    if not system.regular or system.error(usual) < ROUNDINGS:
        return usual
    return _roundest(system, [usual])


def _roundest(system: System, graphs: list[ca.SX]) -> ca.SX:
    """What loses fewest digits; of several what is regular wherever K is, then what is cheap.

    Off the constraints K is singular at some of the states that are tried, and no form is told
    from another by its errors there.
    """

    def weight(graph: ca.SX) -> tuple[float, bool, int]:
        digits = min(digits_lost(system.error(graph)), MOST_DIGITS)
        return digits, all(graph is not one for one in regular), operations(graph)

    regular = system.regular
    return min([*graphs, *regular], key=weight)


def _primitive(system: System) -> ca.SX:
    left, right, scale = _scaled(system)
    pivots = _along(left) if system.symmetric else system.choose(left, right)
    return solve_general(left, right, pivots, system.translate.exact) / scale


def _rearranged(system: System) -> ca.SX:
    left, right, scale = _scaled(system)
    minors = system.translate.column(trailing_minors(system.primitive.left))
    exact = system.translate.exact
    return solve_general(left, right, _along(left), exact, ca.vertsplit(minors)) / scale


def _along(matrix: ca.SX) -> Pivots:
    """Pivots along the diagonal, from the last unknown to the first."""
    return [(i, i) for i in reversed(range(matrix.shape[0]))]


def _fewest(system: System) -> ca.SX:
    """The cheapest that rounds well; where none does, the cheapest of those that round best."""
    usual = system.solve(system.graphs[1])
    least, poor = operations(usual), [usual]
    for candidate in _candidates(system):
        if operations(candidate) < least and system.solved_by(candidate):
            if system.error(candidate) < ROUNDINGS:
                return candidate
            poor.append(candidate)
    if system.error(usual) < ROUNDINGS:
        return usual
    # Terms that cancel may have a factor in common: without it they do not.
    if not _readable(system.equations):
        poor.append(_primitive(system))
    if not _small_and_readable(system.equations):
        poor.append(_rearranged(system))
    solved = [graph for graph in poor if system.solved_by(graph)] or [usual]
    return _roundest(system, solved)


def _candidates(system: System) -> Iterator[ca.SX]:
    """Quotients of a small system, the cheapest first; then elimination of nested entries."""
    equations = system.equations
    left, right = equations.system
    try:
        quotients = nested_quotients(left, right, equations.unknowns, system.symmetric)
    except TooLarge:  # a large system has no short quotients
        quotients = []
    for way in quotients:
        graphs = way.graphs(system.translate)
        yield ca.vertcat(*(graphs[unknown] for unknown in equations.unknowns))
    entries = nested_entries(left.as_immutable(), right.as_immutable()).graphs(system.translate)
    n = left.rows
    matrix, column = ca.SX(n, n), ca.SX(n, 1)
    for (i, j), graph in entries.items():
        if j < n:
            matrix[i, j] = graph
        else:
            column[i] = graph
    yield system.eliminated(matrix, ca.densify(column))


def _nestable(equations: Equations) -> str:
    left, right = equations.system
    try:
        entry_polynomials(left.as_immutable(), right.as_immutable())
    except (TooLarge, ExpressionError) as error:
        return str(error)
    return ""


def _scaled(system: System) -> tuple[ca.SX, ca.SX, ca.SX]:
    p, translate = system.primitive, system.translate
    return (
        translate.matrix(p.left),
        translate.matrix(p.right),
        translate.matrix(Matrix(p.scale)),
    )


def _matrices(unsuited: Callable[[Equations], str]) -> Callable[[Equations], str]:
    """What a form asks of M and f, once these are written out."""

    def asked(equations: Equations) -> str:
        if equations.textbook is None:
            return f"the equations of {equations.scene.name} are too long to be written out"
        return unsuited(equations)

    return asked


ELIMINATION = Form("elimination", "L D Lᵀ, or Gaussian elimination", _always, _elimination)
PRIMITIVE = Form(
    "primitive", "elimination without common factors", _matrices(_readable), _primitive
)
REARRANGED = Form(
    "rearranged", "pivots without subtraction", _matrices(_small_and_readable), _rearranged
)
FEWEST = Form(
    "fewest", "nested polynomials, in quotients or eliminated", _matrices(_nestable), _fewest
)
COMPOSITE = Form("composite", "M by composite bodies, then L D Lᵀ", no_spanning_tree)
ARTICULATED = Form("articulated", "articulated bodies, without M", no_joint_tree)
RECURSIVE = Form("recursive", "bodies from leaves to root and back", no_tree)
SPARSE = Form("sparse", "bodies and constraints, where few entries fill in", no_loops)

FORMS: tuple[Form, ...] = (
    ELIMINATION, PRIMITIVE, REARRANGED, FEWEST, COMPOSITE, ARTICULATED, RECURSIVE, SPARSE,
)  # fmt: skip
PREFERRED: tuple[Form, ...] = (FEWEST, ELIMINATION)
"""Of the forms that start from K and k, what ``"auto"`` takes: the first that suits."""
