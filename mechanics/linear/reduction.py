"""Equations of motion in independent speeds v: dependent speeds and multipliers are eliminated.

    A(q) u + a = 0,   u = (v, u_d):     u_d = -A_d^-1 (A_i v + a),   u_d' = d/dt u_d         (1)
    F(q, v, v', w) = T^T row,  T = du/dv      of rows power-conjugate to u                   (2)
    F = row - B_r B_k^-1 row_k                of others, k rows giving the k multipliers     (3)

In (2) the reactions drop out: they have no power on u = T v. Pivots of A_d and B_k are chosen where
they are not zero at the operating point.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.linear.operating_point import Place, pivots
from mechanics.mechanism import Mechanism, lower, name_of
from mechanics.program import Builder, Node
from mechanics.program.elimination import solve_with_pivots
from mechanics.program.forward import tangent
from mechanics.program.sympy_reader import read
from mechanics.routes.rows import coefficients, remainder, substitute, velocity_forms

Rows = Sequence[Sequence[Node]]


@dataclass(frozen=True)
class Reduction:
    """Equations in independent speeds.

    Attributes
    ----------
    mechanism : Mechanism
    free : tuple of int
        The independent speeds v, by their places among u.
    rows : tuple of Node
        F, one for each of them.
    rates : tuple of Node
        q' in q and v.
    speeds : tuple of Node
        u in q and v.
    configuration : tuple of Node
        Holonomic constraints, then norms of quaternions.
    redundant : tuple of Node
        Constraints of the speeds that the others imply, in q and v.
    conjugate : bool
        Whether F is power-conjugate to v.
    ranks : (int, int)
        How many constraints are independent at the operating point, and near it.
    """

    mechanism: Mechanism
    free: tuple[int, ...]
    rows: tuple[Node, ...]
    rates: tuple[Node, ...]
    speeds: tuple[Node, ...]
    configuration: tuple[Node, ...]
    redundant: tuple[Node, ...]
    conjugate: bool
    ranks: tuple[int, int]

    @property
    def v(self) -> tuple[Node, ...]:
        """The independent speeds."""
        return tuple(self.mechanism.u[i] for i in self.free)

    @property
    def vd(self) -> tuple[Node, ...]:
        """Their rates."""
        return tuple(self.mechanism.ud[i] for i in self.free)


Derived = tuple[Mechanism, tuple[Node, ...], tuple[Node, ...]]
"""The mechanism, rows that vanish along every motion, and the multipliers in them."""


def as_rows(equations: Equations) -> Derived:
    """What a route derived, or matrices that somebody gave, as rows."""
    if equations.mechanism is not None and equations.rows is not None:
        return equations.mechanism, equations.rows.values, equations.rows.multipliers
    mechanism = equations.mechanism or lower(equations.scene, Builder())
    rows = read(mechanism.builder, tuple(equations.residual))
    return mechanism, rows, tuple(read(mechanism.builder, equations.multipliers))


def reduction(equations: Equations, derived: Derived, place: Place, given: set[str]) -> Reduction:
    """Eliminate dependent speeds and multipliers.

    Parameters
    ----------
    derived : Derived
        Their rows.
    place : Place
        The operating point, as far as it is known.
    given : set of str
        Speeds of which a value was given: they stay independent if they can.

    Raises
    ------
    InputError
        If the rows do not determine their multipliers.
    """
    mechanism, rows, multipliers = derived
    forms = velocity_forms(mechanism)
    matrix = coefficients(forms, mechanism.u) if forms else ()
    known = [name_of(u) in given for u in mechanism.u]
    # The last ones that are not given become dependent, as in Kane's equations.
    order = sorted(range(len(mechanism.u) - 1, -1, -1), key=known.__getitem__)
    there = place.matrix([[row[i] for i in order] for row in matrix])
    found = [(row, order[column]) for row, column in pivots(place.builder, there)]
    implied = [form for row, form in enumerate(forms) if row not in {r for r, _ in found}]
    dependent = dict(sorted((column, row) for row, column in found))
    free = tuple(i for i in range(len(mechanism.u)) if i not in dependent)
    speeds, accelerations = _dependent(mechanism, forms, matrix, found, free)
    table = {mechanism.u[i]: node for i, node in speeds.items()}
    rates = substitute(mechanism.builder, mechanism.q_rates, table)
    moved = {mechanism.ud[i]: node for i, node in accelerations.items()}
    plain = substitute(mechanism.builder, rows, {**table, **moved})
    holonomic = [c.expression for c in mechanism.constraints if c.holonomic]
    conjugate = equations.conjugate and len(rows) == len(mechanism.u)
    ranks = len(found), _generic_rank(mechanism, matrix)
    if ranks[0] < ranks[1]:
        reduced = list(plain)  # a singular place, which is refused
    elif conjugate:
        reduced = _projected(mechanism, plain, multipliers, speeds, free)
    else:
        reduced = _without_multipliers(equations, mechanism, plain, multipliers, place)
    return Reduction(
        mechanism,
        free,
        tuple(reduced),
        rates,
        tuple(speeds.get(i, u) for i, u in enumerate(mechanism.u)),
        (*holonomic, *read(mechanism.builder, equations.scene.norms)),
        substitute(mechanism.builder, implied, table) if implied else (),
        conjugate,
        ranks,
    )


def _generic_rank(mechanism: Mechanism, matrix: Rows) -> int:
    """Independent constraints near the operating point."""
    _, closed = mechanism.filters
    return closed.rank(matrix)


def _dependent(
    mechanism: Mechanism, forms: Sequence[Node], matrix: Rows,
    found: Sequence[tuple[int, int]], free: Sequence[int],
) -> tuple[dict[int, Node], dict[int, Node]]:  # fmt: skip
    """Equation (1): the dependent speeds, and their rates."""
    if not found:
        return {}, {}
    builder, u = mechanism.builder, mechanism.u
    rest = remainder(builder, forms, u)
    sides = []
    for row, _ in found:
        side = rest[row]
        for i in free:
            side = side + matrix[row][i] * u[i]
        sides.append(-side)
    square = [[matrix[row][column] for _, column in found] for row, _ in found]
    values = solve_with_pivots(square, sides, [(k, k) for k in range(len(found))])
    speeds = {column: value for (_, column), value in zip(found, values, strict=True)}
    table = {u[i]: value for i, value in speeds.items()}
    rates = substitute(builder, mechanism.q_rates, table)
    directions = {**mechanism.given_rates, **dict(zip(mechanism.q, rates, strict=True))}
    directions |= {u[i]: mechanism.ud[i] for i in free}
    accelerations = tangent(list(speeds.values()), directions)
    return speeds, dict(zip(speeds, accelerations, strict=True))


def _projected(
    mechanism: Mechanism, rows: Sequence[Node], multipliers: Sequence[Node],
    speeds: dict[int, Node], free: Sequence[int],
) -> list[Node]:  # fmt: skip
    """Equation (2)."""
    plain = remainder(mechanism.builder, rows, multipliers) if multipliers else rows
    totals = [plain[i] for i in free]
    if not speeds:
        return totals
    slopes = coefficients(list(speeds.values()), [mechanism.u[i] for i in free])
    for i, slope in zip(speeds, slopes, strict=True):
        totals = [total + factor * plain[i] for total, factor in zip(totals, slope, strict=True)]
    return totals


def _without_multipliers(
    equations: Equations, mechanism: Mechanism, rows: Sequence[Node],
    multipliers: Sequence[Node], place: Place,
) -> list[Node]:  # fmt: skip
    """Equation (3)."""
    if not multipliers:
        return list(rows)
    matrix = coefficients(rows, multipliers)
    plain = remainder(mechanism.builder, rows, multipliers)
    found = pivots(place.builder, place.matrix(matrix))
    if len(found) < len(multipliers):
        raise InputError(
            f"{equations.scene.name}: the rows by {equations.route} do not determine the reactions"
            " of redundant constraints: linearize equations by lagrange or kane"
        )
    square = [[matrix[row][column] for _, column in found] for row, _ in found]
    order = [(k, k) for k in range(len(found))]
    values = solve_with_pivots(square, [-plain[row] for row, _ in found], order)
    taken = {row for row, _ in found}
    totals = []
    for i, total in enumerate(plain):
        if i not in taken:
            for (_, column), value in zip(found, values, strict=True):
                total = total + matrix[i][column] * value
            totals.append(total)
    return totals
