"""Whether two routes say the same: the same accelerations wherever they determine any.

Rows that are power-conjugate to u, or that are principles of the same subtrees, are equal one by
one up to order and sign:

    r_i(u', lambda) = +-s_j(u', lambda)        for a bijection of i and j                    (1)

Otherwise the accelerations of both are compared, M and f never entry by entry:

    M_1 (u', lambda) = f_1      M_2 (v', mu) = f_2      u' = v'                                (2)

Points are free: what agrees everywhere agrees where the constraints hold, on every branch.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from mechanics.checks.programs.statements import equal
from mechanics.errors import SingularError
from mechanics.kernel import Finding
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.residues import PRIME, Residues, eliminate
from mechanics.routes.programs.rows import Rows, acceleration_forms, coefficients, remainder


def require_regular(mechanism: Mechanism, rows: Rows, filter_: Residues) -> None:
    """Refuse rows that do not determine the accelerations.

    A determinant that is not zero at a point of a field is not zero.

    Raises
    ------
    SingularError
        Naming the route and the rank.
    """
    matrix, _, unknowns = system(mechanism, rows)
    flat = filter_.values([entry for row in matrix for entry in row])
    width = len(unknowns)
    table = [flat[width * i : width * (i + 1)] for i in range(len(matrix))]
    rank = len(eliminate(table, width))
    if rank < width or len(matrix) != width:
        raise SingularError(
            f"{mechanism.name}, route {rows.route}: rank {rank} for {width} unknowns:"
            " is a mass or inertia missing?"
        )


def system(
    mechanism: Mechanism, rows: Rows
) -> tuple[Sequence[Sequence[Node]], list[Node], list[Node]]:
    """(K, k, unknowns) with K (u', lambda) = k, constraints below the rows."""
    unknowns = [*mechanism.ud, *rows.multipliers]
    every = [*rows.values, *acceleration_forms(mechanism)]
    matrix = coefficients(every, unknowns)
    rest = remainder(mechanism.builder, every, unknowns)
    return matrix, [-entry for entry in rest], unknowns


def compare_pairs(
    mechanism: Mechanism, routes: Mapping[str, Rows]
) -> dict[tuple[str, str], Finding]:
    """Compare every pair of routes.

    Returns
    -------
    dict of (str, str) to Finding
    """
    filter_ = Residues(mechanism.builder)
    return {
        (one, two): compare(mechanism, routes[one], routes[two], filter_)
        for one, two in combinations(routes, 2)
    }


def compare(mechanism: Mechanism, one: Rows, two: Rows, filter_: Residues) -> Finding:
    """Whether two routes give the same accelerations, and the same reactions where these stay."""
    subject = f"{one.route} = {two.route}: accelerations"
    pairing = matched(filter_, one, two)
    if pairing is not None:
        right = [two.values[j] if sign == 1 else -two.values[j] for j, sign in pairing]
        return equal(subject, mechanism, one.values, right)
    left, right_solution = (solution(mechanism, rows) for rows in (one, two))
    count = len(left) if one.multipliers == two.multipliers else len(mechanism.u)
    return equal(subject, mechanism, left[:count], right_solution[:count])


def solution(mechanism: Mechanism, rows: Rows) -> tuple[Node, ...]:
    """(u', multipliers) as the solution of the rows and the constraints."""
    matrix, right, _ = system(mechanism, rows)
    return mechanism.builder.solve(matrix, right)


def matched(filter_: Residues, one: Rows, two: Rows) -> list[tuple[int, int]] | None:
    """For each row of one the row of the other that it equals, and the sign, at a point."""
    if len(one.values) != len(two.values):
        return None
    places = {residue: j for j, residue in enumerate(filter_.values(two.values))}
    found = []
    for residue in filter_.values(one.values):
        for signed, sign in ((residue, 1), (-residue % PRIME, -1)):
            if signed in places:
                found.append((places.pop(signed), sign))
                break
        else:
            return None
    return found
