"""Taylor coefficients of y' = f(y) as C text over lanes, order by order.

    c_j = y^(j)(t) s^j / j!        state:   y_(j+1) = s f_j / (j + 1)

The rules are those of `mechanics.simulate.reference_series`; here each is a line of C for order 0
and one for the orders above. What depends on parameters only is computed when a motion enters. The
coefficients of a value are kept only where a product or a chain looks back at them.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import reduce

import casadi as ca

from mechanics.compiled.c.source import literal
from mechanics.compiled.programs.program import Program
from mechanics.errors import ExpressionError
from mechanics.simulate.reference_operations import OPERATIONS, Function, operation_name

# Exponents of powers that are products.
WHOLE = tuple(map(float, range(1, 9)))


@dataclass
class Rule:
    """Lines of C for one value; those that keep coefficients are added when somebody looks back."""

    first: list[str] = field(default_factory=list)
    above: list[str] = field(default_factory=list)
    kept: list[str] = field(default_factory=list)


@dataclass(eq=False)
class Series:
    """One value.

    Attributes
    ----------
    name : str
        C expression of its coefficient at order j.
    constant : bool
        Whether it depends on parameters only.
    rule : Rule
        What computes it, unless it is constant.
    number : float or None
        Of a number of the graph.
    row, slope, inverse : str
        Where its coefficients x_i are kept, the numbers i x_i, and 1 / x_0; empty where they are
        not.
    waves : mapping of bool to (Series, Series)
        Sine and cosine, or by False their hyperbolic sisters.
    multiple : (Series, Series) or None
        Of a constant and a value, whose product it is.
    """

    name: str
    constant: bool = True
    rule: Rule = field(default_factory=Rule)
    number: float | None = None
    row: str = ""
    slope: str = ""
    inverse: str = ""
    waves: dict[bool, tuple["Series", "Series"]] = field(default_factory=dict)
    multiple: tuple["Series", "Series"] | None = None


class Recurrences:
    """The rules for a program.

    Parameters
    ----------
    code : Program
        y' from the state, its first input, and from what is held, its second.

    Attributes
    ----------
    rules : list of Rule
        Those of the state first.
    rates : list of Series
        y'.
    once : list of str
        Lines that compute constants.
    rows, constants, inverses, sums : int
        How many of these there are; the rows of the state come first. Sums of products are numbered
        by ``@``: see `mechanics.simulate.ensembles.taylor`.
    convolutions : float
        The same, that of a square counted as half of one.

    Raises
    ------
    ExpressionError
        If the program holds an operation that is not analytic; it is named.
    """

    def __init__(self, code: Program) -> None:
        size, held = (count for _, count in code.inputs)
        self.rules = [Rule([f"s[{k}][0] = y[{k}];"]) for k in range(size)]
        self.once: list[str] = []
        self.rows, self.constants, self.inverses = size, 0, 0
        self.sums, self.convolutions = 0, 0.0
        self._count = 0
        state = [Series(f"s[{k}][j]", False, self.rules[k], row=f"s[{k}]") for k in range(size)]
        given = state, [Series(f"held[{k}]") for k in range(held)]
        values: list[Series] = []
        for operation, operands, constant in code.nodes:
            if constant is not None:
                values.append(self.number(constant))
            elif operation == ca.OP_INPUT:
                values.append(given[operands[0]][operands[1]])
            elif operation in OPERATIONS:
                values.append(OPERATIONS[operation](self, *(values[k] for k in operands)))
            else:
                raise ExpressionError(
                    f"CasADi operation {operation_name(operation)} has no Taylor series: take"
                    " another method"
                )
        self.rates = [values[k] for k in code.outputs[0]]

    def number(self, value: float) -> Series:
        """A number."""
        return Series(f"all({literal(float(value), 'double')})", number=float(value))

    def sum(self, a: Series, b: Series, sign: int = 1) -> Series:
        """A + b or a - b."""
        whole = f"{'add' if sign > 0 else 'sub'}({a.name}, {b.name})"
        if a.constant and b.constant:
            return self._constant(whole)
        if b.constant:
            return self._moving(whole, a.name)
        if a.constant:
            return self._moving(whole, b.name if sign > 0 else f"minus({b.name})")
        return self._moving(whole, whole)

    def scaled(self, a: Series, factor: int) -> Series:
        """A times a small integer."""
        return self.product(a, self.number(factor))

    def product(self, a: Series, b: Series) -> Series:
        """A b."""
        both = f"mul({a.name}, {b.name})"
        for x, factor in ((a, b), (b, a)):
            if factor.number == -1.0:
                both = f"minus({x.name})"
        if a.constant and b.constant:
            return self._constant(both)
        if a.constant or b.constant:
            out = self._moving(both, both)
            out.multiple = (a, b) if a.constant else (b, a)
            return out
        if a is b:
            return self._moving(both, f"square({self._later(0.5)}, {self._row(a)}, j)")
        # A square in disguise costs half of a product.
        for x, other in ((a, b), (b, a)):
            if x.multiple and x.multiple[1] is other:
                return self.product(x.multiple[0], self.product(other, other))
        return self._moving(both, f"product({self._later()}, {self._row(a)}, {self._row(b)}, j)")

    def quotient(self, a: Series, b: Series) -> Series:
        """A / b."""
        if a.constant and b.constant:
            return self._constant(f"over({a.name}, {b.name})")
        inverse = self._inverse(b)
        if b.constant:
            whole = f"mul({a.name}, {inverse})"
            return self._moving(whole, whole)
        below = self._row(b)
        out = self._moving(f"mul({a.name}, {inverse})", "")
        lower = f"divided({self._later()}, {self._row(out)}, {below}, j)"
        left = f"minus({lower})" if a.constant else f"sub({a.name}, {lower})"
        self._above(out, f"mul({inverse}, {left})")
        return out

    def chain(
        self, x: Series, first: Function, factor: Callable[[Series], Series], sign: int = 1
    ) -> Series:
        """y with y_0 = first(x_0) and y' = sign x' g, where g = factor(y)."""
        if first.name == "pow" and first.by.number in WHOLE:
            return reduce(self.product, [x] * int(first.by.number))
        more = f", {first.by.name}" if first.by else ""
        whole = f"each_{first.name}({x.name}{more})"
        if x.constant:
            return self._constant(whole)
        slope = self._slope(x)
        out = self._moving(whole, "")
        # The rule for y needs lower orders of g only, and those for g may need this one of y: it
        # stands before them.
        g = factor(out)
        lower = f"mul({slope}[j], {g.name})"
        if not g.constant:
            lower = f"chained({self._later()}, {slope}, {self._row(g)}, j)"
        self._above(out, f"mul(share, {lower})" if sign > 0 else f"minus(mul(share, {lower}))")
        return out

    def wave(self, x: Series, circular: bool) -> tuple[Series, Series]:
        """(sin x, cos x), or (sinh x, cosh x)."""
        if circular not in x.waves:
            x.waves[circular] = self._waves(x, circular)
        return x.waves[circular]

    def _waves(self, x: Series, circular: bool) -> tuple[Series, Series]:
        names = self._name(), self._name()
        lines = [f"L {names[0]}, {names[1]};", f"waves({x.name}, &{names[0]}, &{names[1]});"]
        if not circular:
            lines = [f"const L {n} = each_{f}({x.name});"
                     for n, f in zip(names, ("sinh", "cosh"), strict=True)]  # fmt: skip
        if x.constant:
            return self._constant("", lines, names[0]), self._constant("", lines, names[1])
        slope = self._slope(x)
        rule = Rule(lines)
        self.rules.append(rule)
        odd, even = (Series(name, False, rule) for name in names)
        signs = "", "-" if circular else ""
        for out, other, sign in zip((odd, even), (even, odd), signs, strict=True):
            lower = f"mul(share, chained({self._later()}, {slope}, {self._row(other)}, j))"
            line = f"minus({lower})" if sign else lower
            rule.above.append(f"const L {out.name} = {line};")
        return odd, even

    def _name(self) -> str:
        self._count += 1
        return f"v{self._count}"

    def _constant(self, text: str, lines: Sequence[str] = (), name: str = "") -> Series:
        """A value that is computed when a motion enters."""
        at = f"c[{self.constants}]"
        self.constants += 1
        self.once += [f"{{ {' '.join(lines)} {at} = {name}; }}"] if lines else [f"{at} = {text};"]
        return Series(at)

    def _moving(self, first: str, above: str) -> Series:
        """A value with a line for order 0 and one for the others, which may follow later."""
        name = self._name()
        out = Series(name, False, Rule([f"const L {name} = {first};"]))
        if above:
            self._above(out, above)
        self.rules.append(out.rule)
        return out

    def _above(self, out: Series, text: str) -> None:
        out.rule.above.append(f"const L {out.name} = {text};")

    def _row(self, x: Series) -> str:
        """Where the coefficients of a moving value are kept."""
        if not x.row:
            x.row = self._kept(x, x.name)
        return x.row

    def _slope(self, x: Series) -> str:
        """Where the numbers i x_i are kept."""
        if not x.slope:
            x.slope = self._kept(x, f"mul(all(j), {x.name})")
        return x.slope

    def _later(self, terms: float = 1.0) -> str:
        """Stands for what the first of two orders sums for the second."""
        self.convolutions += terms
        self.sums += 1
        return f"@{self.sums - 1}"

    def _kept(self, x: Series, text: str) -> str:
        row = f"s[{self.rows}]"
        self.rows += 1
        x.rule.kept.append(f"{row}[j] = {text};")
        return row

    def _inverse(self, x: Series) -> str:
        """1 / x_0, computed once."""
        if not x.inverse and x.constant:
            x.inverse = self._constant(f"over(all(1.0), {x.name})").name
        elif not x.inverse:
            x.inverse = f"inverse{self.inverses}"
            self.inverses += 1
            x.rule.first.append(f"{x.inverse} = over(all(1.0), {x.name});")
        return x.inverse
