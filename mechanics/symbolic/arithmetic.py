"""An experiment: a function that builds both sides of a statement from SymPy's expressions.

    experiment(a: Arithmetic) -> pairs (left, right) of nodes that should be equal

Numbers are nodes of one builder, so that a statement is a program from the beginning. What an
experiment asks on its way (a rank, whether something is zero) is answered at a random point of a
field, where a wrong answer has a chance below 2^-90.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from mechanics.errors import ExpressionError
from mechanics.kernel import Range, Statement
from mechanics.kernel.field import DivisionHere, Inadmissible
from mechanics.kernel.statement import LEFT, POSITIVE, RATES, RIGHT, ZERO
from mechanics.program import Builder, Node, casadi_reader
from mechanics.program.branches import Parts
from mechanics.program.sympy_reader import Reader
from mechanics.symbolic.pivots import pivot_columns
from mechanics.symbolic.point import Point, drawn_inputs, random_field

MOST_POINTS = 1024
HOPELESS = 16
"""Points at which a division may fail before it counts as failing everywhere."""

Number = Node
"""What an expression is worth: a node, which mixes with integers, fractions and rationals."""


class Arithmetic:
    """Builds a program from expressions, functions of CasADi and arithmetic.

    Attributes
    ----------
    builder : Builder
    signs : dict of str to Range
        What is known of the inputs.
    positive : list of Node
        What the statement takes to be positive.
    inputs : dict of Symbol to str
        Names of the inputs.
    constraints : mapping of str to sequence of Node
        What is zero where the statement is made, in the order in which it is solved.
    start : mapping of str to Fraction
        A state at which it is.
    dependent : sequence of str
        Inputs for which it may be solved.
    assigned : dict of Symbol to Node
        What symbols stand for.
    """

    def __init__(self) -> None:
        self.builder = Builder()
        self.signs: dict[str, Range] = {}
        self.positive: list[Node] = []
        self.assigned: dict[sympy.Symbol, Node] = {}
        self.inputs: dict[sympy.Symbol, str] = {}
        self.constraints: Mapping[str, Sequence[Node]] = {}
        self.start: Mapping[str, Fraction] = {}
        self.dependent: Sequence[str] = ()
        self._names: dict[str, sympy.Symbol] = {}
        rules = {
            sympy.Symbol: lambda symbol: Parts((), lambda: self._input(symbol).number),
            sympy.Dummy: lambda symbol: Parts((), lambda: self._input(symbol).number),
            AppliedUndef: self._unknown,
        }
        self._reader = Reader(self.builder, {}, rules)
        self._point: Point | None = None
        self._points = 0

    # ------------------------------------------------------------------ expressions

    def value(self, expression: Any) -> Node:
        """The node of an expression; shared parts are read once.

        Raises
        ------
        ExpressionError
            If it holds an operation without an exact meaning; it is named.
        """
        return self._reader.read(sympy.sympify(expression))

    def assign(self, symbol: sympy.Symbol, number: Node | int | Fraction) -> None:
        """Let a symbol stand for a number that the experiment has computed.

        Raises
        ------
        ValueError
            If the symbol has been used already: values that contain it would be wrong.
        """
        node = self.builder.node(number)
        if symbol in self.inputs or not self._reader.define(symbol, node):
            raise ValueError(
                f"symbol {symbol} has been used or assigned already: assign it before its first use"
            )
        self.assigned[symbol] = node

    def constrain(
        self,
        configuration: Sequence[Node],
        rates: Sequence[Node],
        start: Mapping[str, Fraction],
        dependent: Sequence[str],
    ) -> None:
        """State that constraints hold.

        Parameters
        ----------
        configuration, rates : sequences of Node
            What is zero; the rates are solved after the configuration.
        start : mapping of str to Fraction
            A state of the component that is meant; empty where none is known.
        dependent : sequence of str
            Inputs for which they may be solved, in order.
        """
        self.constraints = {ZERO: configuration, RATES: rates}
        self.start, self.dependent = start, dependent

    def _input(self, symbol: sympy.Symbol) -> Node:
        """The input of its name, or of a longer one where another symbol has that."""
        name = symbol.name
        while self._names.setdefault(name, symbol) != symbol:
            name += "'"
        self.inputs[symbol] = name
        self.signs[name] = range_of(symbol)
        return self.builder.input(name)

    def _unknown(self, expression: Any) -> Parts:
        """A function f(x, y) that is known by congruence only: erf(a + b x + c y).

        With a, b, c of its own it is equal for equal arguments, different for others, and a real
        function for a witness.
        """
        name = f"function {expression.func.__name__}"

        def build(*numbers: int) -> int:
            total = self.builder.input(f"{name}: 0")
            for place, number in enumerate(numbers, 1):
                total = total + self.builder.input(f"{name}: {place}") * Node(self.builder, number)
            return self.builder.call("erf", total).number

        return Parts(expression.args, build)

    def graph(
        self, function: Any, symbols: Sequence[Sequence[sympy.Expr]]
    ) -> list[list[Node]]:  # fmt: skip
        """The outputs of a CasADi function; its double constants are the rationals that they are.

        Parameters
        ----------
        function : casadi.Function
            A graph of scalars.
        symbols : sequence of sequence of sympy.Expr
            What the entries of each input stand for, dense and column by column.

        Returns
        -------
        list of list of Node
            For every output its entries, dense and column by column.

        Raises
        ------
        ExpressionError
            If the graph holds an unknown operation (named), or the symbols have wrong shapes.
        """
        if len(symbols) != function.n_in():
            raise ExpressionError(
                f"casadi function {function.name()} has {function.n_in()} inputs, "
                f"{len(symbols)} groups of symbols found: pass one group for each input"
            )
        arguments = {}
        for i, group in enumerate(symbols):
            nodes = [self.value(entry) for entry in group]
            rows, columns = function.size_in(i)
            if len(nodes) == rows * columns:
                nodes = _transposed(nodes, columns, rows)
            arguments[function.name_in(i)] = nodes
        outputs = casadi_reader.read(self.builder, function, arguments)
        shapes = (function.size_out(i) for i in range(function.n_out()))
        return [
            _transposed(outputs[function.name_out(i)], rows, columns)
            for i, (rows, columns) in enumerate(shapes)
        ]

    # ------------------------------------------------------------------ arithmetic

    def rational(self, number: int | Fraction) -> Node:
        """A constant."""
        return self.builder.constant(number)

    def sqrt(self, number: Node | int | Fraction) -> Node:
        """The root that is not negative."""
        return self.builder.node(number).sqrt()

    def solve(
        self, rows: Sequence[Sequence[Node | int | Fraction]], rhs: Sequence[Node | int | Fraction]
    ) -> list[Node]:
        """The solution of a square linear system."""
        return list(self.builder.solve(rows, rhs)) if rows else []

    # ------------------------------------------------------------------ questions

    def residues(self, numbers: Sequence[Node | int | Fraction]) -> tuple[list[int], Point]:
        """Values at a random point of a field at which they, and the conditions, have some.

        Raises
        ------
        Inadmissible
            If some points have been tried in vain.
        """
        nodes = [self.builder.node(number) for number in numbers]
        reason, divisions = "", 0
        for _ in range(MOST_POINTS):
            point = self._current_point()
            try:
                for node in self.positive:
                    point.domain.positive(point.value(node))
                return [point.value(node) for node in nodes], point
            except Inadmissible as inadmissible:
                reason, self._point = str(inadmissible), None
                divisions += isinstance(inadmissible, DivisionHere)
                if divisions == HOPELESS:
                    break
        raise Inadmissible(f"no admissible point was found: {reason}")

    def _current_point(self) -> Point:
        if self._point is None:
            domain = random_field("arithmetic", str(self._points))
            self._points += 1
            known = drawn_inputs(domain, lambda name: self.signs.get(name, Range.FREE))
            self._point = Point(self.builder, domain, known)
        return self._point

    def rank(self, rows: Sequence[Sequence[Node | int | Fraction]]) -> int:
        """The rank of a matrix."""
        return len(self.independent_rows(rows))

    def independent_rows(self, rows: Sequence[Sequence[Node | int | Fraction]]) -> list[int]:
        """Indices of the first rows that are independent."""
        if not rows or not len(rows[0]):
            return []
        entries, point = self.residues([entry for row in rows for entry in row])
        width = len(rows[0])
        columns = [entries[j::width] for j in range(width)]
        return pivot_columns(columns, point.prime)

    def is_zero(self, number: Node | int | Fraction) -> bool:
        """Whether a number is zero."""
        node = self.builder.node(number)
        if node.constant is not None:
            return node.is_zero
        return self.residues([node])[0] == [0]

    def require_positive(self, number: Node | int | Fraction) -> None:
        """State that a number is positive."""
        self.positive.append(self.builder.node(number))


def range_of(symbol: sympy.Symbol) -> Range:
    """What is known of a symbol."""
    if symbol.is_positive:
        return Range.POSITIVE
    if symbol.is_nonnegative:
        return Range.NONNEGATIVE
    return Range.NEGATIVE if symbol.is_negative else Range.FREE


def _transposed(entries: Sequence[Node], rows: int, columns: int) -> list[Node]:
    return [entries[i * columns + j] for j in range(columns) for i in range(rows)]


Experiment = Callable[[Arithmetic], Sequence[tuple[Any, Any]]]
"""Returns pairs of numbers that should be equal."""


def statement(subject: str, experiment: Experiment, target: float) -> Statement:
    """The statement that all pairs of an experiment are equal.

    Raises
    ------
    ValueError
        If it compares nothing.
    Inadmissible
        If the experiment says that no state is admissible.
    """
    a = Arithmetic()
    pairs = list(experiment(a))
    outputs: Mapping[str, Sequence[Node | int | Fraction]] = {
        LEFT: [left for left, _ in pairs],
        RIGHT: [right for _, right in pairs],
        POSITIVE: a.positive,
        **a.constraints,
        **{
            symbol.name: [node]
            for symbol, node in a.assigned.items()
            if not isinstance(symbol, sympy.Dummy) and symbol.name not in a.signs
        },
    }  # fmt: skip
    program, dependent = a.builder.program(outputs), tuple(a.dependent)
    return Statement(subject, program, a.signs, a.start, dependent, target=target)
