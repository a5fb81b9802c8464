"""A tree as an expression in the scene's plain symbols.

    Rate(e) -> sum_s (de/ds) s'        Name(x, order 2) -> x_ddot

A name that the person defines ("with T = ...") stands for its definition. A name that nothing
explains stays, as a symbol that the scene does not have, so that the verdict can name it.
"""

from collections.abc import Mapping, Sequence
from functools import lru_cache, partial, reduce
from operator import mul
from types import MappingProxyType
from typing import Any

from sympy import Add, Expr, I, Integer, Matrix, Rational, S, Symbol, nan, oo, zoo
from sympy.matrices import MatrixBase
from sympy.matrices.exceptions import NonInvertibleMatrixError, ShapeError

from mechanics.claims.demands import Demand, of_function, of_power, within
from mechanics.claims.functions import FUNCTIONS
from mechanics.claims.independent import partial_derivative
from mechanics.claims.names import Naming
from mechanics.claims.place import Refused
from mechanics.claims.total_derivative import total_derivative
from mechanics.claims.tree import (
    COMPOSED,
    ENTRY,
    LARGEST,
    LARGEST_EXPONENT,
    Call,
    Name,
    Node,
    Number,
    Pointwise,
    Power,
    Product,
    Rate,
    Sum,
    Table,
    Total,
    constant,
)
from mechanics.scene.rates import rate
from mechanics.scene.symbols import TIME, by_name

LARGEST_NUMBER = 1000
"""What a function may be taken of, where that is a number."""
MOST_PARTS = 200_000
"""Of an expression that is written out: products of many matrices share what they are made of."""

Value = Any
"""An expression, or a matrix of them."""


def _small(base: Expr, exponent: Expr) -> bool:
    """Whether a power can be carried out: what is left when symbols have cancelled counts."""
    if not exponent.is_Rational:
        return not exponent.atoms(Integer) or bool(abs(exponent.n(5)) <= LARGEST_EXPONENT)
    if abs(exponent.p) > LARGEST_EXPONENT * exponent.q or exponent.q > LARGEST_EXPONENT:
        return False
    bits = max((max(abs(n.p), n.q).bit_length() for n in base.atoms(Rational)), default=1)
    return bool(bits * abs(exponent.p) <= 2 * LARGEST)


@lru_cache(maxsize=1024)
def _beyond(number: Expr) -> bool:
    """Whether a function of a number is refused; a search asks for the same numbers again."""
    return bool(number.is_finite and abs(number.n(5)) > LARGEST_NUMBER)


def _parts(entry: Expr, counted: dict[Any, int]) -> int:
    """How many nodes an expression has, each counted wherever it stands."""
    if entry not in counted:
        counted[entry] = 1 + sum(_parts(part, counted) for part in entry.args)
    return counted[entry]


def _is_number(value: Any) -> bool:
    return not isinstance(value, MatrixBase)


class Builder:
    """Builds expressions.

    `unknown` are the names that stood for nothing, `demands` what has no value everywhere, with
    that of the definitions that are used, `demanded`.
    """

    def __init__(
        self, naming: Naming, defined: Mapping[str, Value], vague: Mapping[str, Sequence[str]],
        trees: Mapping[str, Node] = MappingProxyType({}),
        demanded: Mapping[str, Sequence[Demand]] = MappingProxyType({}),
        put: Mapping[Symbol, Expr] = MappingProxyType({}),
    ) -> None:  # fmt: skip
        self.naming, self.defined, self.vague, self.trees = naming, defined, vague, trees
        self.demanded, self.put = demanded, put
        self.unknown: list[str] = []
        self.demands: list[Demand] = []
        self.held: frozenset[Symbol] = frozenset()

    def beside(self, defined: Mapping[str, Value]) -> "Builder":
        """The same with other values for the definitions."""
        return Builder(self.naming, defined, self.vague, self.trees, self.demanded, self.put)

    def __call__(self, node: Node) -> Value:
        """The expression of a tree.

        Raises
        ------
        Refused
            For what has no finite real value, or no meaning.
        """
        value = self.value(node)
        entries = list(value) if isinstance(value, MatrixBase) else [value]
        parts: dict[Any, int] = {}
        for entry in entries:
            if _parts(entry, parts) > MOST_PARTS:
                raise Refused(node.at, f"too large: {MOST_PARTS:,} symbols and numbers at most")
            # SymPy's is_real differentiates large expressions for minutes: numbers only.
            if entry.has(nan, oo, -oo, zoo, I) or (entry.is_number and entry.is_real is False):
                raise Refused(node.at, f"this has no finite real value: {str(entry)[:40]}")
        return value

    def value(self, node: Node) -> Any:
        """The expression of a part of a tree."""
        match node:
            case Number(value=value):
                return Rational(value.numerator, value.denominator)
            case Name():
                return self._name(node)
            case Sum(terms=terms):
                return self._sum(node, [self.value(term) for term in terms])
            case Product(factors=factors):
                return self._product(node, [self.value(factor) for factor in factors])
            case Power() if (plain := self._without_root(node)) is not None:
                return self.value(plain)
            case Power(base=base, exponent=exponent):
                return self._power(node, self.value(base), self.value(exponent))
            case Call(function="pi"):
                return S.Pi
            case Call(function="partial", arguments=(of, by)):
                return self._derived(self._by_a_name(node, of, by))
            case Call(function=function, arguments=(of, index)) if function == ENTRY:
                return self._entry(node, self.value(of), int(constant(index) or 0) - 1)
            case Call(function=function, arguments=arguments):
                return self._call(node, function, [self.value(x) for x in arguments])
            case Rate(of=inner, order=order):
                return self._derived(self._rate(self.value(inner), order, node.at))
            case Table(rows=rows):
                return Matrix([[self._scalar(node, self.value(c)) for c in row] for row in rows])
        raise Refused(node.at, "this is not supported")

    def _by_a_name(self, node: Call, of: Node, by: Node) -> Any:
        """A derivative by a name: partial, or along the motion."""
        if isinstance(node, Total):
            value, below = self.value(of), self.value(by)
            along = partial(self._rate, order=1, at=node.at)
            if (found := total_derivative(self.naming, node, value, below, along)) is not None:
                self.demands.append(Demand("divide", (S.One, along(below))))
                return found
        return partial_derivative(self, of, by, node.at)

    def _name(self, node: Name) -> Any:
        if node.name in self.defined:
            value: Any = self.defined[node.name]
            if node.primes and self._of_place(value):
                told = f"the derivative of {node.name} by time, or by what it depends on"
                raise Refused(node.at, f"a prime may be {told}: write \\dot, or {node.name}'(x)")
            self.unknown += self.vague.get(node.name, ())
            self.demands += self.demanded.get(node.name, ())
            return self._derived(self._rate(value, node.order, node.at)) if node.order else value
        try:
            symbol = self.naming.symbol(node.name, node.order)
        except KeyError as error:
            raise Refused(node.at, str(error.args[0])) from None
        if symbol is None:
            self.unknown.append(node.name)
            dots = "'" * node.order
            return Symbol(node.name + dots, real=True)
        return self.put.get(symbol, symbol)

    def _of_place(self, value: Any) -> bool:
        """Whether a value moves with coordinates, and not with their rates."""
        scene = self.naming.vocabulary.scene
        held = value.free_symbols
        return bool(held & {*scene.q}) and not held & {*scene.qd, *scene.u, TIME}

    def _without_root(self, node: Power) -> Power | None:
        """A power of a name that stands for a root: of w^2, where w = sqrt(k/m), that of k/m."""
        base, exponent = node.base, constant(node.exponent)
        root = self.trees.get(base.name) if isinstance(base, Name) and not base.order else None
        if not isinstance(root, Power) or root.exponent.at != COMPOSED or exponent is None:
            return None
        inner = constant(root.exponent)
        if inner is None or (inner * exponent).denominator != 1:
            return None
        return Power(node.at, root.base, Number(node.exponent.at, inner * exponent))

    def _derived(self, value: Any) -> Any:
        """A derivative: 1/(2 sqrt(x)) has no value where the root that was written has one."""
        entries = value if isinstance(value, MatrixBase) else [value]
        self.demands += [demand for entry in entries for demand in within(entry)]
        return value

    def _rate(self, value: Any, order: int, at: int) -> Any:
        for _ in range(order):
            if isinstance(value, MatrixBase):
                value = value.applyfunc(lambda entry: self._rate_once(entry, at))
            else:
                value = self._rate_once(value, at)
        return value

    def _rate_once(self, value: Expr, at: int) -> Expr:
        vocabulary = self.naming.vocabulary
        unknown = vocabulary.without_rate | self.held
        for symbol in sorted(value.free_symbols & unknown, key=by_name):
            raise Refused(at, f"the rate of {symbol} is not known")
        return rate(value, vocabulary.rate_table)

    def _sum(self, node: Node, terms: list[Any]) -> Any:
        if any(isinstance(term, MatrixBase) for term in terms):
            # A zero beside a matrix is the zero matrix.
            kept = [t for t in terms if isinstance(t, MatrixBase) or t != 0]
            if not all(isinstance(t, MatrixBase) and t.shape == kept[0].shape for t in kept):
                raise Refused(node.at, "matrices of different shapes are added")
            return reduce(lambda a, b: a + b, kept)
        return Add(*terms)

    def _product(self, node: Node, factors: list[Any]) -> Any:
        if not any(isinstance(factor, MatrixBase) for factor in factors):
            return reduce(mul, factors, S.One)
        if isinstance(node, Pointwise):
            self._of_one_matrix(node, factors)
        try:
            found = reduce(mul, factors)
        except ShapeError:
            raise Refused(node.at, "matrices of these shapes cannot be multiplied") from None
        # q'^T M q' is a number.
        return found[0, 0] if found.shape == (1, 1) else found

    def _of_one_matrix(self, node: Pointwise, factors: list[Any]) -> None:
        """Refuse ``A .* B`` and ``1 ./ A``, which are no products of matrices."""
        matrices = [n for n, f in zip(node.factors, factors, strict=True) if not _is_number(f)]
        if len(matrices) > 1 or any(isinstance(part, Power) for part in matrices):
            words = "entry by entry (.* ./ .^, or * of arrays) matrices are not multiplied here"
            raise Refused(node.at, f"{words}: write the entries out")

    def _power(self, node: Node, base: Any, exponent: Any) -> Any:
        exponent = self._scalar(node, exponent)
        if isinstance(base, MatrixBase):
            if exponent == -1 and base.rows == base.cols <= 3:
                try:
                    self.demands.append(Demand("divide", (S.One, base.det(method="berkowitz"))))
                    return base.inv(method="ADJ")
                except NonInvertibleMatrixError:
                    raise Refused(node.at, "this matrix has no inverse") from None
            raise Refused(node.at, "a power of a matrix is not supported")
        if base == 0 and exponent.is_negative:
            raise Refused(node.at, "a division by zero")
        if exponent.is_number and not _small(base, exponent):
            raise Refused(node.at, f"the exponent is too large: {LARGEST_EXPONENT} is the limit")
        self.demands += of_power(base, exponent)
        return self._real(node, base**exponent)

    def _real(self, node: Node, value: Any) -> Any:
        """A value, unless it is a number that is not real."""
        if value.is_number and value.is_real is False:
            raise Refused(node.at, f"this has no finite real value: {str(value)[:40]}")
        return value

    def _call(self, node: Node, function: str, arguments: list[Any]) -> Any:
        if function == "transpose":
            (only,) = arguments
            if not isinstance(only, MatrixBase):
                words = "a prime or .T behind what is no matrix: write diff(..., t) for a rate"
                raise Refused(node.at, words)
            return only.T
        if function == "cross":
            return self._cross(node, *arguments)
        _, _, make = FUNCTIONS[function]
        numbers = [self._scalar(node, argument) for argument in arguments]
        if any(n.is_number and _beyond(n) for n in numbers):
            raise Refused(node.at, f"{function} of a number that is too large")
        self.demands += of_function(function, numbers)
        return self._real(node, make(*numbers))

    def _entry(self, node: Node, value: Any, place: int) -> Expr:
        """An entry of a column or row."""
        if not isinstance(value, MatrixBase) or not 0 <= place < len(value):
            raise Refused(node.at, f"there is no entry {place + 1} here")
        return value[place]

    def _cross(self, node: Node, *factors: Any) -> Any:
        """A vector product; what turns out to be numbers is multiplied."""
        columns = [value for value in factors if not _is_number(value)]
        if len(columns) < 2:
            return self._product(node, list(factors))
        if len(columns) > 2:
            raise Refused(node.at, "a vector product of three columns: write brackets around two")
        left, right = columns
        if (left.shape, right.shape) != ((3, 1), (3, 1)):
            raise Refused(node.at, "a vector product takes two columns of three")
        return reduce(mul, filter(_is_number, factors), S.One) * left.cross(right)

    def _scalar(self, node: Node, value: Any) -> Expr:
        if isinstance(value, MatrixBase):
            if value.shape == (1, 1):
                return value[0, 0]
            raise Refused(node.at, "a matrix stands where a number belongs")
        return value
