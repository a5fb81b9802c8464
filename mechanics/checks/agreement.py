"""Whether two routes say the same: the same accelerations wherever they determine any.

Rows that are power-conjugate to u, or that are principles of the same subtrees, are equal one by
one up to order and sign:

    r_i(u', lambda) = +-s_j(u', lambda)        for a bijection of i and j                    (1)

Multipliers of Lagrange's method have a sign of their own. Rows that are conjugate to u are compared
without them, and so are the columns of these, each where the constraints of its loop hold:

    r = g - B lambda      s = h - C mu        g = h       c_k = +-b_j for a bijection       (2)

Otherwise the solution of one is put into the rows of the other, M and f never compared entry by
entry; where the unknown reactions of the two are others, both are solved:

    M_1 (u', lambda) = f_1      =>      s_j(u', lambda) = 0                                    (3)
    M_1 (u', lambda) = f_1      M_2 (v', mu) = f_2      u' = v'                                (4)

Both systems are regular where the constraints hold, which is checked first; of a mechanism with
constraints it is the bordered matrix that is inverted, never M. What agrees at all states agrees on
every branch; what does not is compared where the constraints hold, on the component of the scene's
example. Each route is compared with one of them; the other pairs follow.

Multipliers have a sign and a scale of their own; the generalized force B lambda has not, where the
rows of both routes are power-conjugate to u:

    B_1 lambda = B_2 mu                                                                       (5)
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

from mechanics.checks.statements import equal
from mechanics.equations import Rows
from mechanics.errors import SingularError
from mechanics.kernel import Finding, follows
from mechanics.mechanism import Mechanism, name_of
from mechanics.program.builder import Builder, Node
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
    rank = filter_.rank(matrix)
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
        subject = subject_of(one, two)
        if not all(premise.shown for premise in premises):
            found[one, two] = compare(routes[one], routes[two], filter_)
        elif len(premises) == 1:
            # The same statement, whichever side is named first.
            found[one, two] = replace(premises[0], subject=subject)
        else:
            found[one, two] = follows(subject, premises)
    return found


def subject_of(one: str, two: str) -> str:
    """What a finding about two routes is called."""
    return f"{one} = {two}: accelerations"


def compare(one: Derived, two: Derived, filter_: Residues) -> Finding:
    """Whether two routes give the same accelerations, and the same reactions where these stay."""
    mechanism, subject = one.mechanism, subject_of(one.rows.route, two.rows.route)
    pairing = matched(filter_, one.rows.values, two.rows.values)
    if pairing is not None:
        return equal(subject, mechanism, one.rows.values, _signed(two.rows.values, pairing))
    if one.rows.conjugate and two.rows.conjugate and mechanism.closure.values:
        premises = _without_multipliers(one.rows, two.rows, mechanism, filter_)
        if premises and all(premise.shown for premise in premises):
            return follows(subject, premises)
    if one.unknowns == two.unknowns:
        values = dict(zip(two.unknowns, two.solution, strict=True))
        left = substitute(mechanism.builder, one.rows.values, values)
        return equal(subject, mechanism, left, [0] * len(left))
    return equal(subject, mechanism, one.accelerations, two.accelerations)


def check_multipliers(one: Derived, two: Derived) -> Finding:
    """Equation (5): the reactions that maintain the constraints are the same."""
    subject = f"{one.rows.route} = {two.rows.route}: multipliers"
    return equal(subject, one.mechanism, maintaining_forces(one), maintaining_forces(two))


def maintaining_forces(derived: Derived) -> list[Node]:
    """B lambda: what maintains the constraints, as a generalized force in each row."""
    multipliers = derived.rows.multipliers
    sizes = derived.solution[len(derived.mechanism.u) :]
    return [-dot(row, sizes) for row in coefficients(derived.rows.values, multipliers)]


def _without_multipliers(
    one: Rows, two: Rows, mechanism: Mechanism, filter_: Residues
) -> list[Finding]:
    """Equation (2): all but the multipliers, and their columns; empty if these are not the same."""
    subject = f"{one.route} = {two.route}"
    build, (_, closed) = mechanism.builder, mechanism.filters
    g, h = (remainder(build, rows.values, rows.multipliers) for rows in (one, two))
    pairing = matched(filter_, g, h)
    if pairing is None:
        return []
    left, right = (
        [list(column) for column in zip(*coefficients(rows.values, rows.multipliers), strict=True)]
        for rows in (one, two)
    )
    right = [_signed(column, pairing) for column in right]
    every = [_together(columns, build) for columns in (left, right)]
    columns = matched(closed, *every)
    if columns is None:
        return []
    moving = {name_of(node) for node in (*mechanism.q, *mechanism.u)}
    holding = [(c, moving & _names(build, [c])) for c in mechanism.closure.configuration]
    loops: dict[tuple[Node, ...], list[tuple[Node, Node]]] = {}
    for column, (j, sign) in zip(left, columns, strict=True):
        other = right[j] if sign == 1 else [-entry for entry in right[j]]
        sides = [(a, b) for a, b in zip(column, other, strict=True) if a != b]
        held = _names(build, [entry for pair in sides for entry in pair])
        loops.setdefault(tuple(c for c, names in holding if names <= held), []).extend(sides)
    rest = equal(f"{subject}: all but multipliers", mechanism, g, _signed(h, pairing))
    findings = []
    for constraints, sides in loops.items():
        if sides:
            closure = replace(mechanism.closure, configuration=constraints, rates=())
            a, b = zip(*sides, strict=True)
            findings.append(equal(f"{subject}: a loop", mechanism, a, b, closure=closure))
    forces = f"{subject}: directions of the multipliers"
    return [rest, *([follows(forces, findings)] if findings else [])]


def _together(columns: Sequence[Sequence[Node]], build: Builder) -> list[Node]:
    """Each column as one node: its entries with weights that no relation between them has."""
    return [dot([build.node(7 + 3**i) for i in range(len(c))], c) for c in columns]


def _names(build: Builder, nodes: Sequence[Node]) -> set[str]:
    return set(build.program({"x": nodes}).inputs) if nodes else set()


def _signed(nodes: Sequence[Node], pairing: Sequence[tuple[int, int]]) -> list[Node]:
    return [nodes[j] if sign == 1 else -nodes[j] for j, sign in pairing]


def matched(
    filter_: Residues, one: Sequence[Node], two: Sequence[Node]
) -> list[tuple[int, int]] | None:
    """For each node of one the node of the other that it equals, and the sign, at a point."""
    if len(one) != len(two):
        return None
    places = {residue: j for j, residue in enumerate(filter_.values(two))}
    found = []
    for residue in filter_.values(one):
        for signed, sign in ((residue, 1), (-residue % filter_.prime, -1)):
            if signed in places:
                found.append((places.pop(signed), sign))
                break
        else:
            return None
    return found
