"""What was written and has no value everywhere: roots, logarithms, quotients, as they were written.

    sqrt(x)^2    ->    sqrt of x        0 log(a)    ->    log of a        x/x    ->    a divisor x

SymPy and CasADi put `sqrt(x)^2` and `x/x` together while they are made, so what an operation asks
of its operands is recorded when it is read, with the conditions of the branch that it stands in.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from sympy import Basic, Expr, Function, Piecewise, Pow, S, cos, sin, sinh

CONSTANT_NAN, ERROR, RAISED = (
    "the constant nan",
    "a way that ends in an error",
    "an error it raises",
)
"""What has no value at any state of its branch, in words; its demand has no operands."""

Condition = tuple[Basic, bool]
"""What decides, as a comparison or as 0 and 1, and the answer that leads to a branch."""


@dataclass(frozen=True)
class Demand:
    """An operation that has no value for all operands.

    Attributes
    ----------
    operation : str
        By its name in the table of operations; or `CONSTANT_NAN`, `ERROR`, `RAISED`.
    operands : tuple of Expr
    conditions : tuple of Condition
    """

    operation: str
    operands: tuple[Expr, ...] = ()
    conditions: tuple[Condition, ...] = ()

    @property
    def nowhere(self) -> bool:
        """Whether it has no value wherever its branch is taken."""
        zero = self.operation == "divide" and self.operands[1] == 0
        return zero or self.operation in (CONSTANT_NAN, ERROR, RAISED)

    def under(self, conditions: Iterable[Condition]) -> "Demand":
        """The same within a branch."""
        return replace(self, conditions=tuple(dict.fromkeys((*conditions, *self.conditions))))


@dataclass(frozen=True)
class Demands:
    """All of a statement.

    Attributes
    ----------
    of : tuple of Demand
    code : bool
        Whether they are of code, which computes, and has to have a number where it begins.
    """

    of: tuple[Demand, ...] = ()
    code: bool = False

    def put(self, table: Mapping[Expr, Expr]) -> "Demands":
        """The same with what stands for a person's symbols."""
        found = (
            replace(
                demand,
                operands=tuple(operand.xreplace(table) for operand in demand.operands),
                conditions=tuple((c.xreplace(table), answer) for c, answer in demand.conditions),
            )
            for demand in self.of
        )
        return replace(self, of=tuple(found))


class Asked(NamedTuple):
    """Demands of a number: its own operation's, and those of the numbers that it is made of."""

    own: tuple[Demand, ...]
    parts: "tuple[Asked, ...]"


NOTHING = Asked((), ())


def asked(own: Iterable[Demand], *parts: Asked) -> Asked:
    """What a number asks for that an operation makes of others."""
    demands = tuple(own)
    kept = tuple(part for part in parts if part is not NOTHING)
    if not demands and len(kept) < 2:
        return kept[0] if kept else NOTHING
    return Asked(demands, kept)


def gathered(number: Asked) -> tuple[Demand, ...]:
    """All that a number asks for, each demand once."""
    seen: set[int] = set()
    found: dict[Demand, None] = {}
    todo = [number]
    while todo:
        here = todo.pop()
        if id(here) not in seen:
            seen.add(id(here))
            found.update(dict.fromkeys(here.own))
            todo += here.parts
    return tuple(found)


def of_power(base: Expr, exponent: Expr) -> Iterator[Demand]:
    """What base ** exponent asks for."""
    if exponent.is_Integer:
        if exponent < 0 and not (base.is_number and base.is_nonzero):
            yield Demand("divide", (S.One, base))
    elif not (base.is_number and base.is_positive):
        yield Demand("power", (base, exponent))


def of_function(name: str, operands: Sequence[Any]) -> Iterator[Demand]:
    """What a function asks for, by any of its names."""
    if name in DIVISORS:
        yield Demand("divide", (S.One, DIVISORS[name](operands[0])))
    elif name in MODULI:
        yield Demand("divide", (S.One, operands[1]))
    elif name in NAMES:
        yield Demand(NAMES[name], tuple(operands))


def within(expression: Any) -> Iterator[Demand]:
    """What is in an expression as SymPy has it; branches of cases under their conditions."""
    todo: list[tuple[Any, tuple[Condition, ...]]] = [(expression, ())]
    seen: set[tuple[Any, tuple[Condition, ...]]] = set()
    while todo:
        here = todo.pop()
        if here in seen:
            continue
        seen.add(here)
        part, conditions = here
        if isinstance(part, Piecewise):
            todo += _branches(part, conditions)
            if part.args[-1][1] != S.true:
                # SymPy gives no value where no case applies.
                none = ((condition, False) for _, condition in part.args)
                yield Demand("divide", (S.One, S.Zero)).under((*conditions, *none))
            continue
        if isinstance(part, Pow):
            yield from (demand.under(conditions) for demand in of_power(*part.args))
        elif isinstance(part, Function):
            name = type(part).__name__
            yield from (demand.under(conditions) for demand in of_function(name, part.args))
        todo += [(inner, conditions) for inner in getattr(part, "args", ())]


def _branches(
    cases: Piecewise, conditions: tuple[Condition, ...]
) -> Iterator[tuple[Any, tuple[Condition, ...]]]:
    """Each case where its condition holds, and those before it do not."""
    for value, condition in cases.args:
        yield condition, conditions
        here = () if condition == S.true else ((condition, True),)
        yield value, (*conditions, *here)
        conditions = (*conditions, (condition, False))


NAMES = {
    **{name: name for name in (
        "sqrt", "log", "tan", "asin", "acos", "acosh", "atanh", "atan2",
    )},
    "ln": "log", "tg": "tan", "arcsin": "asin", "arccos": "acos",
    "arcosh": "acosh", "arccosh": "acosh", "artanh": "atanh", "arctanh": "atanh",
    "arctan2": "atan2",
}  # fmt: skip
"""Functions that have no value everywhere."""

MODULI = ("mod", "Mod", "rem", "fmod")
"""Functions that have no value where the second operand is zero."""

DIVISORS = {
    "cot": sin, "ctg": sin, "csc": sin, "cosec": sin, "sec": cos, "coth": sinh, "csch": sinh,
}  # fmt: skip
"""Functions that are quotients, by what is below."""
