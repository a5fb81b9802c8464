"""Taylor's method over lanes as C: the steps of a program's series, and control of the step.

    c_j = y^(j)(t) s^j / j!
    order n = 2 - ln(e) / 2,   e the share of the state that the last terms of a step may have

What a step of order n costs grows with n^2, and what it reaches with e^(1/n): the least cost for a
duration is at n = -ln(e) / 2 (Jorba and Zou, 2005); two more, because order 0, with its sines and
its control of the step, has a cost of its own.

The rules are those of `mechanics.program.taylor`; here each is a line of C. What depends on
parameters only is computed when a motion enters, and the coefficients of a value are kept only
where a sum of products looks back at them. Straight code of all coefficients has no such loops, but
17,000 operations for `four_bar` at order 13, which take the compiler 11 s, for each order anew.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Literal

from mechanics.compiled.c.sine import sine_source
from mechanics.compiled.right_hand_side import Held
from mechanics.program import Program
from mechanics.program.taylor import Kind, Recurrences, Step, recurrences
from mechanics.simulate.ensembles.lanes import Lanes
from mechanics.simulate.ensembles.text import text

HIGHEST = 25
"""Order for which memory is set aside."""


def order(share: float) -> int:
    """Order of the series."""
    return min(HIGHEST, math.ceil(-math.log(share) / 2) + 2)


def taylor_source(of: Held) -> str:
    """C text with everything that a block of lanes needs.

    Raises
    ------
    ExpressionError
        If the program holds an operation that is not analytic; it is named.
    """
    return _written(of.program, of.state)


@lru_cache(maxsize=16)
def _written(program: Program, state: tuple[str, ...]) -> str:
    writer = _Writer(recurrences(program, state), len(state))
    constants, expand = writer.constants(), writer.expand()
    return "\n".join([
        sine_source("double"),
        text("series.h"),
        f"enum {{ TOP = {HIGHEST} }};",
        "typedef struct {",
        f"    L s[{writer.rows}][TOP + 1];",
        f"    L constants[{max(1, writer.stored)}];",
        "    L ratio;",
        "} Work;",
        text("block.h"),
        constants,
        expand,
        text("taylor.c"),
        text("march.c"),
    ])  # fmt: skip


def kept(steps: Sequence[Step], size: int) -> tuple[dict[int, int], dict[int, int]]:
    """Rows of the coefficients x_i that are kept, by series, and of the numbers i x_i."""
    back = {Kind.PRODUCT: ("a", "b"), Kind.QUOTIENT: ("out", "b"), Kind.CHAIN: ("b",)}
    series = [getattr(step, name) for step in steps for name in back.get(step.kind, ())]
    slopes = [step.a for step in steps if step.kind is Kind.CHAIN]
    rows = {k: row for row, k in enumerate(dict.fromkeys([*range(size), *series]))}
    return rows, {k: len(rows) + row for row, k in enumerate(dict.fromkeys(slopes))}


class _Writer:
    """The functions of one program."""

    def __init__(self, rules: Recurrences, size: int) -> None:
        self.rules, self.size = rules, size
        self._kept, self._slopes = kept(rules.steps, size)
        self.rows = len(self._kept) + len(self._slopes)
        first = Lanes(rules.constants, {name: name for name in rules.constants.inputs}, "k")
        # Literals stand where they are used; all else that stays is kept, and what is divided by
        # as its reciprocal, too.
        self._constant = list(first.values("constants"))
        self._once = first.lines
        self.stored = 0
        for k, value in enumerate(self._constant):
            if not value.startswith("all("):
                self._constant[k] = self._store(value)
        over = {step.b: None for step in rules.steps if step.kind is Kind.OVER}
        self._over = {
            f"c{-1 - b}": self._store(f"over(all(1.0), {self._constant[-1 - b]})") for b in over
        }

    def _store(self, value: str) -> str:
        name = f"c[{self.stored}]"
        self._once.append(f"{name} = {value};")
        self.stored += 1
        return name

    def constants(self) -> str:
        """What depends on parameters only."""
        return "\n".join([
            "/* What depends on parameters only. */",
            "static void constants(const L *held, L *c)",
            "{",
            "    (void)held;",
            "    (void)c;",
            *(f"    {line}" for line in self._once),
            "}",
            "",
        ])  # fmt: skip

    def expand(self) -> str:
        """The coefficients of the state, and of what they need, up to an order."""
        first, inverses = self._first()
        later = [step for step in self.rules.steps if step.kind in _SUMS]
        odd, even = (self._above(part, later) for part in ("first", "second"))
        return "\n".join([
            "static void expand(int order, const L *y, const L *held, const L *c, L step,",
            "                   L (*restrict s)[TOP + 1])",
            "{",
            "    (void)held;",
            "    (void)c;",
            *(f"    L {name};" for name in inverses),
            "    {",
            "        enum { j = 0 };",
            *(f"        {line}" for line in first),
            "    }",
            "    for (int j = 1; j < order; ++j) {",
            *(f"        L later{k};" for k in range(len(later))),
            "        {",
            *(f"            {line}" for line in odd),
            "        }",
            "        if (++j < order) {",
            *(f"            {line}" for line in even),
            "        }",
            "    }",
            "}",
            "",
        ])  # fmt: skip

    def _first(self) -> tuple[list[str], list[str]]:
        """Lines for order 0, and the names of reciprocals of what moves."""
        program, rules = self.rules.first, self.rules
        inputs = {name: name for name in program.inputs[: self.size]}
        inputs |= {f"c{k}": value for k, value in enumerate(self._constant)}
        lanes = Lanes(program, inputs, "v", self._over)
        values = lanes.values("first")
        divisors = [s.b for s in rules.steps if s.kind is Kind.QUOTIENT]
        self._inverse = {b: lanes.inverse(program.outputs["first"][b]) for b in divisors}
        lines = lanes.lines + [f"s[{row}][j] = {values[k]};" for k, row in self._kept.items()]
        for k, rate in enumerate(rules.rates):
            value = values[rate] if rate >= 0 else self._constant[-1 - rate]
            lines.append(f"s[{k}][1] = mul(step, {value});")
        return lines, lanes.inverses

    def _above(self, part: Literal["first", "second"], later: Sequence[Step]) -> list[str]:
        """Lines for an order above 0; the first of two leaves to the second what it has summed."""
        lines = ["const L share = all(1.0 / j), part = mul(step, all(1.0 / (j + 1)));"]
        lines.append("(void)share;")
        names = {k: f"s[{k}][j]" for k in range(self.size)}
        lines += [self._slope(k, names[k]) for k in range(self.size) if k in self._slopes]
        summed = {step: k for k, step in enumerate(later)}

        def sum_of_products(step: Step, *rows: int) -> str:
            place = f"later{summed[step]}"
            name = "square" if step.kind is Kind.PRODUCT and step.a == step.b else _SUMS[step.kind]
            given = [f"&{place}" if part == "first" else place, *(f"s[{row}]" for row in rows)]
            return f"{name}_{part}({', '.join(given)}, j)"

        for step in self.rules.steps:
            value = self._value(step, names, sum_of_products)
            if value.isidentifier() or value.startswith("s["):
                names[step.out] = value
            else:
                names[step.out] = f"v{step.out}"
                lines.append(f"const L v{step.out} = {value};")
            if step.out in self._kept:
                lines.append(f"s[{self._kept[step.out]}][j] = {names[step.out]};")
            if step.out in self._slopes:
                lines.append(self._slope(step.out, names[step.out]))
        for k, rate in enumerate(self.rules.rates):
            value = f"mul(part, {names[rate]})" if rate >= 0 else "all(0.0)"
            lines.append(f"s[{k}][j + 1] = {value};")
        return lines

    def _slope(self, k: int, name: str) -> str:
        return f"s[{self._slopes[k]}][j] = mul(all(j), {name});"

    def _value(
        self, step: Step, names: Mapping[int, str], sum_of_products: Callable[..., str]
    ) -> str:
        """The expression of one step."""
        kind, out, a, b, sign = step
        rows = self._kept
        if kind is Kind.COPY:
            return names[a] if sign > 0 else f"minus({names[a]})"
        if kind is Kind.SUM:
            return f"{'add' if sign > 0 else 'sub'}({names[a]}, {names[b]})"
        if kind is Kind.TIMES:
            return f"mul({names[a]}, {self._constant[-1 - b]})"
        if kind is Kind.OVER:
            return f"mul({names[a]}, {self._over[f'c{-1 - b}']})"
        if kind is Kind.PRODUCT:
            return sum_of_products(step, rows[a], *([rows[b]] if a != b else []))
        if kind is Kind.QUOTIENT:
            lower = sum_of_products(step, rows[out], rows[b])
            left = f"sub({names[a]}, {lower})" if a >= 0 else f"minus({lower})"
            return f"mul({self._inverse[b]}, {left})"
        chained = f"mul(share, {sum_of_products(step, self._slopes[a], rows[b])})"
        return chained if sign > 0 else f"minus({chained})"


_SUMS = {Kind.PRODUCT: "product", Kind.QUOTIENT: "divided", Kind.CHAIN: "chained"}
"""Sums of products in ``series.h``."""
