"""When two sets of equations agree: they give the same accelerations.

    [[M1, -B1], [A1, 0]] (u', lambda1) = (f1, b1)    and    M2 u' = f2 + B2 lambda2,  A2 u' = b2

M and f are never compared entry by entry: rows may be scaled and combined at will. Points are free
first (the routes agree off the constraint manifold too), and on the manifold where they do not.
"""

from collections.abc import Callable, Mapping
from itertools import combinations

from sympy import Matrix

from mechanics.equations import Equations
from mechanics.errors import SingularError
from mechanics.exact import Arithmetic, Finding, Number, decide, independent_rows
from mechanics.kinematics.manifold import settle
from mechanics.scene import Scene

Pairs = list[tuple[Number, Number]]

LARGEST_PROOF = 5
"""Number of speeds up to which the normal form is tried: beyond, it outgrows its limit anyway."""


def proof_pays(scene: Scene) -> bool:
    """Whether to try for a proof, or be content with a certificate."""
    return len(scene.u) <= LARGEST_PROOF


def require_regular(equations: Equations) -> None:
    """Refuse equations that do not determine the accelerations.

    Raises
    ------
    SingularError
        Naming the route, the rank, and the rows that depend on the others.
    """
    left, _ = equations.system
    rows = independent_rows(left.tolist())
    if len(rows) < left.cols or left.rows != left.cols:
        dependent = [i for i in range(left.rows) if i not in rows]
        raise SingularError(
            f"{equations.scene.name}, route {equations.route}: rank {len(rows)} for {left.cols}"
            f" unknowns; rows {dependent} depend on the others: is a mass or inertia missing?"
        )


def solve(a: Arithmetic, equations: Equations) -> list[Number]:
    """Values of (u', lambda) in an arithmetic."""
    left, right = equations.system
    rows = [[a.value(entry) for entry in left[i, :]] for i in range(left.rows)]
    return a.solve(rows, [a.value(entry) for entry in right])


def compare_pairs(routes: Mapping[str, Equations]) -> dict[tuple[str, str], Finding]:
    """Compare the accelerations of every pair of routes.

    Returns
    -------
    dict of (str, str) to Finding
    """
    return {(one, two): compare(routes[one], routes[two]) for one, two in combinations(routes, 2)}


def compare(one: Equations, two: Equations) -> Finding:
    """Whether two sets of equations give the same accelerations."""
    subject = f"{one.route} = {two.route}: accelerations"
    scene, pays = one.scene, proof_pays(one.scene)
    free = decide(subject, _accelerations(one, two, lambda a: None), try_normal=pays)
    if free.shown or not scene.constraints:
        return free
    settled = _accelerations(one, two, lambda a: settle(scene, a))
    return decide(subject, settled, try_normal=pays)


def _accelerations(
    one: Equations, two: Equations, prepare: Callable[[Arithmetic], None]
) -> Callable[[Arithmetic], Pairs]:
    size = len(one.scene.u)

    def experiment(a: Arithmetic) -> Pairs:
        prepare(a)
        first = solve(a, one)[:size]
        if two.multipliers:
            return list(zip(first, solve(a, two)[:size], strict=True))
        # Without multipliers, putting u' into the rows saves a second elimination.
        mass: Matrix = two.mass.col_join(two.constraint_matrix)
        right: Matrix = two.forcing.col_join(two.constraint_bias)
        return [(product(a, mass[i, :], first), a.value(right[i, 0])) for i in range(mass.rows)]

    return experiment


def product(a: Arithmetic, row: Matrix, numbers: list[Number]) -> Number:
    """Scalar product of a row of expressions with numbers."""
    total = a.rational(0)
    for entry, number in zip(row, numbers, strict=True):
        if entry != 0:
            total = total + a.value(entry) * number
    return total
