"""Taylor's method over lanes as C: recurrences of the program, and steps around them.

    order n = 2 - ln(e) / 2,   e the share of the state that the last terms of a step may have

What a step of order n costs grows with n^2, and what it reaches with e^(1/n): the least cost for a
duration is at n = -ln(e) / 2 (Jorba and Zou, 2005); two more, because order 0, with its sines and
its control of the step, has a cost of its own.
"""

import math
import re

from mechanics.compiled.c.sine import sine_source
from mechanics.compiled.programs.program import Program
from mechanics.simulate.ensembles.recurrences import Recurrences
from mechanics.simulate.ensembles.text import text

HIGHEST = 25
"""Order for which memory is set aside."""


def order(share: float) -> int:
    """Order of the series."""
    return min(HIGHEST, math.ceil(-math.log(share) / 2) + 2)


def taylor_source(code: Program) -> str:
    """C text with everything that a block of lanes needs.

    Raises
    ------
    ExpressionError
        If the program holds an operation that is not analytic; it is named.
    """
    rules = Recurrences(code)
    memory = [
        f"L s[{rules.rows}][TOP + 1];", f"L constants[{max(1, rules.constants)}];", "L ratio;",
    ]  # fmt: skip
    return "\n".join([
        sine_source("double"),
        text("series.h"),
        f"enum {{ TOP = {HIGHEST} }};",
        "typedef struct {",
        *(f"    {line}" for line in memory),
        "} Work;",
        text("block.h"),
        _constants(rules),
        _expand(rules),
        text("taylor.c"),
        text("march.c"),
    ])  # fmt: skip


# The first of two orders leaves to the second what it has summed for it.
_SUM = re.compile(r"(\w+)\(@(\d+),")
_FIRST, _SECOND = r"\1_first(&later\2,", r"\1_second(later\2,"


def _constants(rules: Recurrences) -> str:
    return "\n".join([
        "/* What depends on parameters only. */",
        "static void constants(const L *held, L *c)",
        "{",
        "    (void)held;",
        "    (void)c;",
        *(f"    {line}" for line in rules.once),
        "}",
        "",
    ])  # fmt: skip


def _expand(rules: Recurrences) -> str:
    """The coefficients of the state, and of what they need, up to an order."""
    size = len(rules.rates)
    first = [line for rule in rules.rules for line in (*rule.first, *rule.kept)]
    first += [f"s[{k}][1] = mul(step, {rate.name});" for k, rate in enumerate(rules.rates)]
    above = [line for rule in rules.rules[:size] for line in rule.kept]
    above += [line for rule in rules.rules[size:] for line in (*rule.above, *rule.kept)]
    for k, rate in enumerate(rules.rates):
        value = "all(0.0)" if rate.constant else f"mul(part, {rate.name})"
        above.append(f"s[{k}][j + 1] = {value};")
    share = "const L share = all(1.0 / j), part = mul(step, all(1.0 / (j + 1)));"
    above = [share, "(void)share;", *above]
    return "\n".join([
        "static void expand(int order, const L *y, const L *held, const L *c, L step,",
        "                   L (*restrict s)[TOP + 1])",
        "{",
        "    (void)held;",
        "    (void)c;",
        *(f"    L inverse{k};" for k in range(rules.inverses)),
        "    {",
        "        enum { j = 0 };",
        *(f"        {line}" for line in first),
        "    }",
        "    for (int j = 1; j < order; ++j) {",
        *(f"        L later{k};" for k in range(rules.sums)),
        "        {",
        *(f"            {_SUM.sub(_FIRST, line)}" for line in above),
        "        }",
        "        if (++j < order) {",
        *(f"            {_SUM.sub(_SECOND, line)}" for line in above),
        "        }",
        "    }",
        "}",
        "",
    ])  # fmt: skip
