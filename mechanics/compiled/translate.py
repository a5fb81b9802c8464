"""SymPy expression in plain symbols -> CasADi SX graph.

    p/q * a * b**-2        becomes        (p * a) / (q * sq(b))

One node of the expression is translated once, so that what is shared stays shared. Every number in
a graph is a double; a number that no double holds exactly (pi, sqrt(2), an integer of 20 digits)
becomes a *named constant*: an input of the graph, so that the graph is exact and can be proved, and
bound to the nearest double only afterwards. So do divisors, whose reciprocals no double holds.
"""

from collections.abc import Callable, Mapping, Sequence

import casadi as ca
import sympy
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFalse, BooleanTrue

from mechanics.errors import ExpressionError
from mechanics.program.casadi_printer import ExactGraphs
from mechanics.program.postorder import postorder
from mechanics.symbolic.decimals import float_as_rational

EXACT_INTEGER = 2**53

_FUNCTIONS: dict[type, Callable[..., ca.SX]] = {
    sympy.sin: ca.sin, sympy.cos: ca.cos, sympy.tan: ca.tan,
    sympy.asin: ca.asin, sympy.acos: ca.acos, sympy.atan: ca.atan, sympy.atan2: ca.atan2,
    sympy.sinh: ca.sinh, sympy.cosh: ca.cosh, sympy.tanh: ca.tanh,
    sympy.asinh: ca.asinh, sympy.acosh: ca.acosh, sympy.atanh: ca.atanh,
    sympy.exp: ca.exp, sympy.log: ca.log, sympy.erf: ca.erf,
    sympy.Abs: ca.fabs, sympy.sign: ca.sign,
    sympy.floor: ca.floor, sympy.ceiling: ca.ceil,
}  # fmt: skip

_RELATIONS: dict[type, Callable[..., ca.SX]] = {
    sympy.StrictLessThan: ca.lt, sympy.LessThan: ca.le,
    sympy.StrictGreaterThan: ca.gt, sympy.GreaterThan: ca.ge,
    sympy.Equality: ca.eq, sympy.Unequality: ca.ne,
}  # fmt: skip


class Translator:
    """Translates expressions over a fixed table of symbols; remembers what it has translated.

    Parameters
    ----------
    symbols : mapping of sympy.Symbol to casadi.SX
        What each symbol stands for: a graph symbol, or any scalar graph.
    constants : dict of sympy.Expr to casadi.SX, optional
        Named constants found so far; new ones are added. Share it between translators.
    """

    def __init__(
        self,
        symbols: Mapping[sympy.Symbol, ca.SX],
        constants: dict[sympy.Expr, ca.SX] | None = None,
    ) -> None:
        self.constants = {} if constants is None else constants
        self._memo: dict[sympy.Basic, ca.SX] = dict(symbols)

    def __call__(self, expression: sympy.Expr) -> ca.SX:
        """Return the scalar graph of an expression.

        Raises
        ------
        ExpressionError
            If the expression holds an unknown symbol or operation; it is named.
        """
        root = sympy.sympify(expression)
        for node in postorder(root, _parts, self._memo):
            self._memo[node] = self._node(node)
        return self._memo[root]

    def matrix(self, entries: sympy.Matrix) -> ca.SX:
        """Return the dense graph of a matrix of expressions."""
        graph = ca.SX(entries.rows, entries.cols)
        for i in range(entries.rows):
            for j in range(entries.cols):
                graph[i, j] = self(entries[i, j])
        return ca.densify(graph)

    def column(self, entries: Sequence[sympy.Expr]) -> ca.SX:
        """Return the dense column of a sequence of expressions."""
        return self.matrix(sympy.Matrix(len(entries), 1, list(entries)))

    @property
    def exact(self) -> ExactGraphs:
        """Operations on graphs and numbers that round no number."""
        return ExactGraphs(self._constant)

    def named(self, number: sympy.Expr) -> ca.SX:
        """Return a number as a named constant."""
        return self._constant(number)

    def _node(self, node: sympy.Basic) -> ca.SX:
        if isinstance(node, sympy.Rational):
            return self._rational(node)
        if isinstance(node, sympy.Float):
            return self._float(node)
        if isinstance(node, sympy.NumberSymbol):
            return self._constant(node)
        if isinstance(node, sympy.Add):
            return _sum([self._memo[part] for part in node.args])
        if isinstance(node, sympy.Mul | sympy.Pow):
            return self._product(node)
        if isinstance(node, sympy.Piecewise):
            return self._piecewise(node)
        if isinstance(node, sympy.Symbol):
            raise ExpressionError(
                f"symbol {node} is neither a coordinate, a speed, an input nor a parameter of the"
                " scene, so nothing gives it a value: declare it in the scene"
            )
        if type(node) in _FUNCTIONS and node.is_number and node.is_real:
            return self._constant(node)  # CasADi would round it at once
        parts = [self._memo[part] for part in node.args]
        if isinstance(node, sympy.Max | sympy.Min):
            return _folded(ca.fmax if isinstance(node, sympy.Max) else ca.fmin, parts)
        if type(node) in _FUNCTIONS:
            return _FUNCTIONS[type(node)](*parts)
        return self._condition(node, parts)

    def _condition(self, node: sympy.Basic, parts: Sequence[ca.SX]) -> ca.SX:
        if isinstance(node, BooleanTrue | BooleanFalse):
            return ca.SX(1 if isinstance(node, BooleanTrue) else 0)
        if type(node) in _RELATIONS:
            return _RELATIONS[type(node)](*parts)
        if isinstance(node, sympy.Not):
            return ca.logic_not(parts[0])
        if isinstance(node, sympy.And | sympy.Or):
            both = isinstance(node, sympy.And)
            return _folded(ca.logic_and if both else ca.logic_or, parts)
        raise ExpressionError(
            f"operation {type(node).__name__} in {str(node)[:80]} cannot be compiled:"
            " write it with + - * /, powers and elementary functions of plain symbols"
        )

    def _rational(self, number: sympy.Rational) -> ca.SX:
        p, q = int(number.p), int(number.q)
        if max(abs(p), q) > EXACT_INTEGER:
            return self._constant(number)
        # CasADi folds p/q into a double: exact only where q is a power of two.
        return ca.SX(p / q) if q & (q - 1) == 0 else self._constant(number)

    def _divisor(self, number: sympy.Integer) -> ca.SX:
        """An integer to divide by. CasADi differentiates x/3 into the double 1/3: name the 3."""
        q = int(number)
        return ca.SX(q) if q & (q - 1) == 0 else self._constant(sympy.Integer(q))

    def _float(self, number: sympy.Float) -> ca.SX:
        value = float(number)
        return (
            ca.SX(value)
            if sympy.Rational(value) == float_as_rational(number)
            else self._constant(number)
        )

    def _constant(self, number: sympy.Expr) -> ca.SX:
        if number not in self.constants:
            self.constants[number] = ca.SX.sym(f"constant{len(self.constants)}")
        return self.constants[number]

    def _product(self, node: sympy.Expr) -> ca.SX:
        """A product or power as one numerator over one denominator."""
        above: list[ca.SX] = []
        below: list[ca.SX] = []
        negative = False
        for factor in sympy.Mul.make_args(node):
            if isinstance(factor, sympy.Rational) and _holds(factor):
                negative = factor.p < 0
                above += [ca.SX(abs(int(factor.p)))] if abs(factor.p) != 1 else []
                below += [self._divisor(factor.q)] if factor.q != 1 else []
            elif isinstance(factor, sympy.Pow) and factor.base is not sympy.S.Exp1:
                power, inverse = self._power(factor)
                (below if inverse else above).append(power)
            else:
                above.append(self._memo[factor])
        graph = _folded(ca.times, above) if above else ca.SX(1)
        if below:
            graph = graph / _folded(ca.times, below)
        return -graph if negative else graph

    def _power(self, node: sympy.Pow) -> tuple[ca.SX, bool]:
        """A power with positive exponent, and whether it stands in the denominator."""
        base, exponent = node.args
        if base.is_number and exponent.is_number and not exponent.is_Integer:
            return self._constant(node), False
        graph = self._memo[base]
        if isinstance(exponent, sympy.Rational) and exponent.q <= 2:
            whole, half = divmod(abs(int(exponent.p)), int(exponent.q))
            factors = [_integer_power(graph, whole)] if whole else []
            if half:
                # Kept like a node of its own, so that a root is taken once for all its powers.
                root = sympy.Pow(base, sympy.S.Half)
                factors.append(self._memo.setdefault(root, ca.sqrt(graph)))
            return _folded(ca.times, factors), exponent.is_negative
        return graph ** self._memo[exponent], False

    def _piecewise(self, node: sympy.Piecewise) -> ca.SX:
        *cases, (result, last) = node.args
        if not isinstance(last, BooleanTrue):
            raise ExpressionError(
                f"Piecewise {str(node)[:80]} is undefined outside its cases: add a case"
                " (value, True)"
            )
        graph = self._memo[result]
        for value, condition in reversed(cases):
            graph = ca.if_else(self._memo[condition], self._memo[value], graph)
        return graph


def _parts(node: sympy.Basic) -> tuple[sympy.Basic, ...]:
    """The nodes that have to be translated before `node`."""
    if isinstance(node, sympy.Mul | sympy.Pow):
        parts: list[sympy.Basic] = []
        for factor in sympy.Mul.make_args(node):
            if not isinstance(factor, sympy.Pow):
                parts += [] if isinstance(factor, sympy.Rational) and _holds(factor) else [factor]
            elif not (factor.base.is_number and factor.exp.is_number and not factor.exp.is_Integer):
                halves = isinstance(factor.exp, sympy.Rational) and factor.exp.q <= 2
                parts += factor.args[:1] if halves else factor.args
        return tuple(parts)
    if isinstance(node, sympy.Piecewise):
        return tuple(part for case in node.args for part in case.args)
    arguments = tuple(node.args)
    return arguments if isinstance(node, _WITH_PARTS) else ()


_WITH_PARTS: tuple[type, ...] = (
    *_FUNCTIONS, Relational,
    sympy.Add, sympy.Max, sympy.Min, sympy.Not, sympy.And, sympy.Or,
)  # fmt: skip


def _holds(number: sympy.Rational) -> bool:
    return max(abs(int(number.p)), int(number.q)) <= EXACT_INTEGER


def _integer_power(graph: ca.SX, exponent: int) -> ca.SX:
    """x**n by squaring: roundings grow with log n, and no pow() is called."""
    factors, square = [], graph
    while exponent:
        if exponent & 1:
            factors.append(square)
        exponent >>= 1
        square = square * square if exponent else square
    return _folded(ca.times, factors)


def _folded(operation: Callable[[ca.SX, ca.SX], ca.SX], parts: Sequence[ca.SX]) -> ca.SX:
    result = parts[0]
    for part in parts[1:]:
        result = operation(result, part)
    return result


def _sum(parts: Sequence[ca.SX]) -> ca.SX:
    return _folded(ca.plus, parts)
