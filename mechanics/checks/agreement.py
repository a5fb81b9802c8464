"""Whether two routes say the same: the same accelerations wherever they determine any.

Rows that are power-conjugate to u, or that are principles of the same subtrees, are equal one by
one up to order and sign:

    r_i(u', lambda) = +-s_j(u', lambda)        for a bijection of i and j                    (1)

Otherwise the solution of one is put into the rows of the other, M and f never compared entry by
entry; where the unknown reactions of the two are others, both are solved:

    M_1 (u', lambda) = f_1      =>      s_j(u', lambda) = 0                                    (2)
    M_1 (u', lambda) = f_1      M_2 (v', mu) = f_2      u' = v'                                (3)

Both systems are regular where the constraints hold, which is checked first; of a mechanism with
constraints it is the bordered matrix that is inverted, never M. What agrees at all states agrees on
every branch; what does not is compared where the constraints hold, on the component of the scene's
example. Each route is compared with one of them; the other pairs follow.

Multipliers of Lagrange's method have a sign and a scale of their own; the generalized force
B lambda has not, where the rows of both routes are power-conjugate to u:

    B_1 lambda = B_2 mu                                                                       (4)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

from mechanics.checks.statements import equal
from mechanics.equations import Rows
from mechanics.errors import SingularError
from mechanics.kernel import Finding, follows
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.residues import Residues
from mechanics.program.vectors import dot
from mechanics.routes.rows import (
    acceleration_forms,
    coefficients,
    remainder,
    substitute,
)

REFERENCE = "kane"
"""The route that others are compared with, where it is asked for: its rows are the shortest."""


@dataclass(frozen=True)
class Derived:
    """The rows of a route with the linear system that they and the constraints are.

    Attributes
    ----------
    mechanism : Mechanism
    rows : Rows
    unknowns : tuple of Node
        u', then the multipliers.
    matrix : n x n
    right : n
        matrix (u', lambda) = right.
    """

    mechanism: Mechanism
    rows: Rows
    unknowns: tuple[Node, ...]
    matrix: Sequence[Sequence[Node]]
    right: Sequence[Node]

    @property
    def solution(self) -> tuple[Node, ...]:
        """The unknowns as one operation on the state."""
        return self.mechanism.builder.solve(self.matrix, self.right)

    @property
    def accelerations(self) -> tuple[Node, ...]:
        """u' as one operation on the state."""
        return self.solution[: len(self.mechanism.u)]


def linear_system(mechanism: Mechanism, rows: Rows, filter_: Residues) -> Derived:
    """The system of a route, found regular: a determinant that is not zero at a point is not zero.

    `filter_` is that of the states at which the constraints hold.

    Raises
    ------
    SingularError
        Naming the route and the rank.
    """
    unknowns = (*mechanism.ud, *rows.multipliers)
    every = [*rows.values, *acceleration_forms(mechanism)]
    matrix = coefficients(every, unknowns)
    right = [-entry for entry in remainder(mechanism.builder, every, unknowns)]
    rank = len(filter_.eliminate([filter_.values(row) for row in matrix], len(unknowns)))
    if rank < len(unknowns) or len(matrix) != len(unknowns):
        raise SingularError(
            f"{mechanism.name}, route {rows.route}: rank {rank} for {len(unknowns)} unknowns:"
            " is a mass or inertia missing?"
        )
    return Derived(mechanism, rows, unknowns, matrix, right)


def compare_pairs(routes: Mapping[str, Derived]) -> dict[tuple[str, str], Finding]:
    """Compare every pair of routes of one mechanism.

    Returns
    -------
    dict of (str, str) to Finding
    """
    if not routes:
        return {}
    first = next(iter(routes.values()))
    filter_, _ = first.mechanism.filters
    reference = REFERENCE if REFERENCE in routes else first.rows.route
    direct = {
        name: compare(derived, routes[reference], filter_)
        for name, derived in routes.items()
        if name != reference
    }
    found = {}
    for one, two in combinations(routes, 2):
        premises = [direct[name] for name in (one, two) if name != reference]
        subject = _subject(one, two)
        if not all(premise.shown for premise in premises):
            found[one, two] = compare(routes[one], routes[two], filter_)
        elif len(premises) == 1:
            # The same statement, whichever side is named first.
            found[one, two] = replace(premises[0], subject=subject)
        else:
            found[one, two] = follows(subject, premises)
    return found


def _subject(one: str, two: str) -> str:
    return f"{one} = {two}: accelerations"


def compare(one: Derived, two: Derived, filter_: Residues) -> Finding:
    """Whether two routes give the same accelerations, and the same reactions where these stay."""
    mechanism, subject = one.mechanism, _subject(one.rows.route, two.rows.route)
    pairing = matched(filter_, one.rows, two.rows)
    if pairing is not None:
        right = [two.rows.values[j] if sign == 1 else -two.rows.values[j] for j, sign in pairing]
        return equal(subject, mechanism, one.rows.values, right)
    if one.unknowns == two.unknowns:
        values = dict(zip(two.unknowns, two.solution, strict=True))
        left = substitute(mechanism.builder, one.rows.values, values)
        return equal(subject, mechanism, left, [0] * len(left))
    return equal(subject, mechanism, one.accelerations, two.accelerations)


def check_multipliers(one: Derived, two: Derived) -> Finding:
    """Equation (4): the reactions that maintain the constraints are the same."""
    subject = f"{one.rows.route} = {two.rows.route}: multipliers"
    return equal(subject, one.mechanism, maintaining_forces(one), maintaining_forces(two))


def maintaining_forces(derived: Derived) -> list[Node]:
    """B lambda: what maintains the constraints, as a generalized force in each row."""
    multipliers = derived.rows.multipliers
    sizes = derived.solution[len(derived.mechanism.u) :]
    return [-dot(row, sizes) for row in coefficients(derived.rows.values, multipliers)]


def matched(filter_: Residues, one: Rows, two: Rows) -> list[tuple[int, int]] | None:
    """For each row of one the row of the other that it equals, and the sign, at a point."""
    if len(one.values) != len(two.values):
        return None
    places = {residue: j for j, residue in enumerate(filter_.values(two.values))}
    found = []
    for residue in filter_.values(one.values):
        for signed, sign in ((residue, 1), (-residue % filter_.prime, -1)):
            if signed in places:
                found.append((places.pop(signed), sign))
                break
        else:
            return None
    return found
