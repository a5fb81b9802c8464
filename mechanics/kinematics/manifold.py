"""Points on the constraint manifold, in any arithmetic.

phi(q; p) = 0      solved for what it holds linearly (link lengths first), or as a square
A(q) u + a = 0     solved for dependent speeds
A(q) u' = b        solved for dependent accelerations, where a statement holds free ones
e . e = 1          e0 = (1 - x . x) / (1 + x . x),  ei = 2 xi / (1 + x . x)    a quaternion
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

from sympy import Expr, Symbol

from mechanics.errors import ExpressionError
from mechanics.kinematics.constraints import velocity_forms
from mechanics.scene import Scene
from mechanics.scene.rates import rate, rate_table
from mechanics.scene.symbols import plain_symbol
from mechanics.symbolic import Arithmetic, Number, canonical, collect_linear, independent_rows

Solvable = tuple[tuple[Symbol, ...], list[list[Expr]], list[Expr]]
"""Unknowns, coefficients and rest: coefficients times unknowns plus rest is zero."""


@dataclass(frozen=True, eq=False, repr=False)
class ConstraintManifold:
    """Constraints of a scene, solved for what depends on the rest; once, when it is first needed.

    Attributes
    ----------
    scene : Scene
    """

    scene: Scene

    def __repr__(self) -> str:
        return f"<constraint manifold of {self.scene.name}>"

    def project(self, a: Arithmetic) -> None:
        """Give dependent quantities the values that the constraints ask for.

        Must run before any other expression is evaluated in this arithmetic.

        Raises
        ------
        ExpressionError
            When no quantity is known for which a configuration constraint can be solved.
        """
        for rotation in self.scene.rotations:
            _on_sphere(a, [plain_symbol(q) for q in rotation.coordinates])
        if self._closing:
            self._project_configuration(a)
        if self.scene.constraints:
            _solve(a, *self._speeds)

    def _project_configuration(self, a: Arithmetic) -> None:
        """Together where the constraints are linear, else one by one."""
        if self._linear is not None:
            for symbol, number in zip(self._linear[0], _solve(a, *self._linear), strict=True):
                if symbol.is_positive:
                    a.require_positive(number)
            return
        for symbol, powers in self._quadratic:
            _solve_square(a, symbol, *powers)

    def project_accelerations(self, a: Arithmetic) -> None:
        """Give dependent accelerations the values that the constraints ask for; after `project`."""
        if self.scene.constraints:
            _solve(a, *self._accelerations)

    @cached_property
    def _forms(self) -> list[Expr]:
        return velocity_forms(self.scene)

    @cached_property
    def _speeds(self) -> Solvable:
        return _dependent(self._forms, self.scene.u)

    @cached_property
    def _accelerations(self) -> Solvable:
        table = rate_table(self.scene)
        return _dependent([rate(form, table) for form in self._forms], self.scene.ud)

    @cached_property
    def _closing(self) -> list[Expr]:
        """What is zero in every configuration."""
        constraints = (c for c in self.scene.constraints if c.holonomic)
        return [self.scene.plain(c.expression, c.name) for c in constraints]

    def _candidates(self, closing: Sequence[Expr]) -> list[Symbol]:
        """What they may be solved for: parameters first, for angles stay free that way."""
        free = (q for q in self.scene.q if q not in self.scene.quaternions)
        symbols = (*self.scene.parameters, *free)
        return [s for s in symbols if any(s in e.free_symbols for e in closing)]

    @cached_property
    def _linear(self) -> Solvable | None:
        """The configuration constraints, in quantities in which all of them are linear."""
        for unknown in combinations(self._candidates(self._closing), len(self._closing)):
            try:
                split = [collect_linear(expression, unknown) for expression in self._closing]
            except ExpressionError:
                continue  # not linear in this set: the next one may do
            rows = [list(coefficients) for coefficients, _ in split]
            if len(independent_rows(rows)) == len(rows):
                return unknown, rows, [rest for _, rest in split]
        return None

    @cached_property
    def _quadratic(self) -> list[tuple[Symbol, tuple[Expr, Expr, Expr]]]:
        """For each constraint a quantity that it alone holds, and coefficients of its powers."""
        solved = []
        for i, expression in enumerate(self._closing):
            others = {s for k, e in enumerate(self._closing) if k != i for s in e.free_symbols}
            own = (s for s in self._candidates([expression]) if s not in others)
            squares = ((symbol, _in_powers(expression, symbol)) for symbol in own)
            first = next(((symbol, powers) for symbol, powers in squares if powers), None)
            if first is None:
                raise ExpressionError(
                    f"{self.scene.name}: the configuration constraints are linear in no"
                    f" {len(self._closing)} quantities together, and one of them is quadratic in"
                    " nothing that it alone holds, so no exact point on them is known"
                )
            solved.append(first)
        return solved


def chart(symbol: Symbol) -> str:
    """The input that stands for a coordinate of a quaternion on the way to its sphere."""
    return f"chart of {symbol.name}"


def branch(symbol: Symbol) -> str:
    """The input whose sign tells which root a coordinate is."""
    return f"branch of {symbol.name}"


def _on_sphere(a: Arithmetic, coordinates: Sequence[Symbol]) -> None:
    """By the stereographic projection, which misses one point: rational, and of one component."""
    first, *others = coordinates
    numbers = [a.auxiliary(chart(symbol)) for symbol in others]
    square = sum((number * number for number in numbers), a.builder.zero)
    a.assign(first, (1 - square) / (1 + square))
    for symbol, number in zip(others, numbers, strict=True):
        a.assign(symbol, 2 * number / (1 + square))


def _solve_square(a: Arithmetic, symbol: Symbol, square: Expr, slope: Expr, rest: Expr) -> None:
    two, one, zero = (a.value(entry) for entry in (square, slope, rest))
    root = a.sqrt(one * one - 4 * two * zero)
    if symbol.is_positive and slope == 0:
        # Of two opposite solutions, the positive one.
        root = -root if square.is_negative else root
    else:
        root = root * _either_sign(a, symbol)
    number = (root - one) / (2 * two)
    if symbol.is_positive:
        a.require_positive(number)
    a.assign(symbol, number)


def _either_sign(a: Arithmetic, symbol: Symbol) -> Number:
    """1 or -1, sqrt(z^2) / z of a free z: what holds on one branch only is not shown."""
    free = a.auxiliary(branch(symbol))
    return a.sqrt(free * free) / free


def _solve(
    a: Arithmetic, unknown: Sequence[Symbol], rows: Sequence[Sequence[Expr]], rest: Sequence[Expr]
) -> list[Number]:
    numbers = a.solve(
        [[a.value(entry) for entry in row] for row in rows], [-a.value(entry) for entry in rest]
    )
    for symbol, number in zip(unknown, numbers, strict=True):
        a.assign(symbol, number)
    return numbers


def _in_powers(expression: Expr, symbol: Symbol) -> tuple[Expr, Expr, Expr] | None:
    """(a, b, c) of a s^2 + b s + c; None for any other function of s."""
    square = canonical(expression.diff(symbol, 2) / 2)
    slope = canonical(expression.diff(symbol) - 2 * square * symbol)
    rest = canonical(expression - square * symbol**2 - slope * symbol)
    if square == 0 or any(symbol in e.free_symbols for e in (square, slope, rest)):
        return None
    return square, slope, rest


def _dependent(forms: Sequence[Expr], symbols: Sequence[Symbol]) -> Solvable:
    """As many symbols as there are forms, the last ones that the forms determine."""
    split = [collect_linear(form, symbols) for form in forms]
    columns = [[row[i] for row, _ in split] for i in range(len(symbols))]
    backwards = list(range(len(columns)))[::-1]
    picked = sorted(backwards[k] for k in independent_rows([columns[i] for i in backwards]))
    rows = [[row[i] for i in picked] for row, _ in split]
    others = [
        rest + sum(row[i] * symbol for i, symbol in enumerate(symbols) if i not in picked)
        for row, rest in split
    ]
    return tuple(symbols[i] for i in picked), rows, others
