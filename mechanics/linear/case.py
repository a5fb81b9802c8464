"""What the checks of linear rows share: the typed sides, the derived equations, the comparisons.

a form        typed side = derived value
an equation   left = right wherever the derived equation holds, and it is no identity
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, ImmutableMatrix, Matrix, Symbol, sympify
from sympy.matrices import MatrixBase

from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError
from mechanics.kernel import Finding, undecided
from mechanics.linear.algebra import coefficients
from mechanics.linear.form import Linear
from mechanics.linear.linearize import linearize
from mechanics.linear.transfer import close_loop
from mechanics.linear.values import expand_definitions
from mechanics.scene import Scene
from mechanics.scene.linear_quantities import OperatingPoint, ProportionalFeedback
from mechanics.scene.published import Published
from mechanics.scene.symbols import entries
from mechanics.symbolic import Arithmetic, Number, decide

Pairs = list[tuple[Number, Number]]
Experiment = Callable[[Arithmetic], Pairs]


@dataclass(frozen=True, eq=False)
class Case:
    """One row to be checked: its sides in plain symbols, and the equations linearized.

    Attributes
    ----------
    linear : Linear
        About the operating point of the row's quantity.
    names : mapping of Symbol to Expr
        Symbols of the source that stand for derived quantities.
    """

    subject: str
    row: Published
    linear: Linear
    names: Mapping[Symbol, Expr]

    @property
    def scene(self) -> Scene:
        """The scene of the equations."""
        return self.linear.scene

    @property
    def quantity(self) -> Any:
        """What the row is about; each check knows the class of its own quantity."""
        return self.row.quantity

    def forms(self) -> list[Expr | ImmutableMatrix]:
        """The typed sides in plain symbols."""
        return [self.plain(side) for side in self.row.sides]

    def equation(self) -> tuple[list[Expr], list[Expr]]:
        """Entries of the left and of the right side.

        Raises
        ------
        InputError
            If there are not two sides, or their shapes differ.
        """
        if len(self.row.sides) != 2:
            raise InputError(
                f"{self.subject}: {len(self.row.sides)} sides typed: an equation has two"
            )
        left, right = (entries(side) for side in self.forms())
        if len(left) != len(right):
            raise InputError(
                f"{self.subject}: {len(left)} entries on the left, {len(right)} on the right"
            )
        return left, right

    def plain(self, side: object) -> Expr | ImmutableMatrix:
        """A typed side in plain symbols, named quantities put in."""
        if isinstance(side, MatrixBase):
            return ImmutableMatrix(side.applyfunc(self.plain))
        return self.scene.plain(sympify(side), self.subject).xreplace(dict(self.names))

    def closed(self, feedback: ProportionalFeedback | None) -> Linear:
        """The linear equations, their loop closed if there is feedback."""
        return self.linear if feedback is None else closed_loop(self.linear, feedback)

    def equal(self, *derived: Expr | Matrix) -> Finding:
        """Whether every typed side has the derived value (all of them), entry by entry."""
        pairs: list[tuple[Expr, Expr]] = []
        for side in self.forms():
            for value in derived:
                typed, target = entries(side), entries(value)
                if len(typed) != len(target):
                    raise InputError(
                        f"{self.subject}: {len(typed)} entries typed, {len(target)} derived"
                    )
                pairs += zip(typed, target, strict=True)
        return self.decide(lambda a: [(a.value(x), a.value(y)) for x, y in self.expanded(pairs)])

    def expanded(self, pairs: Sequence[tuple[Expr, Expr]]) -> list[tuple[Expr, Expr]]:
        """Pairs with the definitions expanded where a side holds a symbol from inside of them."""
        inside = {s for value in self.scene.definitions.values() for s in value.free_symbols}
        inside |= set(self.scene.definitions)
        inside -= set(self.scene.parameters)
        used = set().union(*(side.free_symbols for pair in pairs for side in pair))
        if not used & inside:
            return list(pairs)
        return [
            (expand_definitions(self.scene, x), expand_definitions(self.scene, y)) for x, y in pairs
        ]

    def decide(self, experiment: Experiment) -> Finding:
        """Decide an experiment about this row."""
        return decide(self.subject, experiment)

    def holds(
        self, experiment: Experiment, unknowns: Sequence[Symbol], rank: int | None = None
    ) -> Finding:
        """Decide an equation; if it holds, make sure that it says something about the unknowns.

        Parameters
        ----------
        experiment : callable
        unknowns : sequence of Symbol
            d(left - right)/d(unknowns) must have full row rank, or the rank given.
        """
        finding = self.decide(experiment)
        if not finding.shown:
            return finding
        left, right = self.equation()
        gradient = Matrix(
            [
                [(x - y).diff(symbol) for symbol in unknowns]
                for x, y in zip(left, right, strict=True)
            ]
        )
        wanted = len(left) if rank is None else rank

        def full(a: Arithmetic) -> Pairs:
            found = a.rank(
                [[a.value(entry) for entry in gradient.row(i)] for i in range(len(left))]
            )
            return [(a.rational(found), a.rational(wanted))]

        says = decide(self.subject, full)
        if says.shown:
            return finding
        return undecided(
            finding.subject,
            "the two sides are equal, but as an identity: the row does not determine "
            + ", ".join(symbol.name for symbol in unknowns),
        )

    def same_roots(self, derived: Expr, symbol: Symbol) -> Finding:
        """Whether left - right has the roots of a derived polynomial: equal up to a factor.

        t(s) / t_n = p(s) / p_n, multiplied out.
        """
        ((left,), (right,)) = self.equation()
        typed = left - right
        if not typed.is_polynomial(symbol) or not typed.has(symbol):
            return undecided(self.subject, f"it is no polynomial equation in {symbol}")
        top, derived_top = coefficients(typed, symbol)[-1], coefficients(derived, symbol)[-1]
        return self.decide(lambda a: [(a.value(typed / top), a.value(derived / derived_top))])


def require_conjugate(linear: Linear) -> None:
    """Refuse rows that are scaled or combined, where their coefficients themselves are compared.

    Raises
    ------
    ExpressionError
        If the rows are not power-conjugate.
    """
    if not linear.conjugate:
        raise ExpressionError(
            f"{linear.scene.name}: the rows by {linear.route} are not power-conjugate, so their"
            " coefficients are no inertias or stiffnesses: use equations by lagrange or kane"
        )


def linear_at(equations: Equations, point: OperatingPoint) -> Linear:
    """The equations linearized about an operating point."""
    return linearize(
        equations, dict(point.coordinates), dict(point.inputs), speeds=dict(point.speeds)
    )


def closed_loop(linear: Linear, feedback: ProportionalFeedback) -> Linear:
    """The control loop closed: the error times the gain drives the input."""
    output = linear.coordinates[linear.coordinate_index(feedback.output)]
    law = feedback.gain * (feedback.reference - output)
    return close_loop(linear, {feedback.input: law}, (feedback.reference,))


def numbers(a: Arithmetic, matrix: Matrix) -> list[list[Number]]:
    """Rows of a matrix as numbers."""
    return [[a.value(entry) for entry in matrix.row(i)] for i in range(matrix.rows)]


def compare(a: Arithmetic, left: Sequence[Expr], right: Sequence[Expr]) -> Pairs:
    """Entries of two sides as pairs of numbers."""
    return [(a.value(x), a.value(y)) for x, y in zip(left, right, strict=True)]
