"""A small guard around a point where what is written has no value: sin(x)/x, and 1 for |x| < 1e-8.

    | guarded value - truth |  <=  1e-9 max(1, |truth|)        at states inside, by enclosure

A guard is a condition with a number of at most 1e-6 whose other branch has an obligation in the
same symbols. Where the truth has no value either, that is said.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from flint import arb
from sympy import Not, Rational, S, Symbol
from sympy.core.relational import Ge, Gt, Le, Lt, Relational

from mechanics.claims.demands import Demand
from mechanics.equations import Equations
from mechanics.kernel.balls import ball, enclose, precision
from mechanics.kernel.statement import LEFT, POSITIVE, RIGHT
from mechanics.program import Program
from mechanics.symbolic import Arithmetic
from mechanics.symbolic.arithmetic import Experiment

LARGEST = Fraction(1, 10**6)
NEAR = Fraction(1, 10**9)
BITS = 256

SHARES = (
    Fraction(0),
    1 - Fraction(1, 2**20),
    Fraction(1, 2),
    Fraction(1, 2**10),
    Fraction(1, 2**40),
)
"""Of the number that the guard compares with: values of what it holds."""
SIZES = tuple(Fraction(2) ** scale for scale in (-48, -34, -20, 0, 4, 20))
"""Other values, of which those beyond a guard that is none on one side are far from the truth."""
SIMPLE = (Fraction(1), Fraction(-1, 2), Fraction(2))


@dataclass(frozen=True)
class Apart:
    """A state, all values that are near the truth there, and the guarded one."""

    state: tuple[tuple[str, str], ...]
    near: arb
    value: arb


@dataclass(frozen=True)
class Inside:
    """What was found inside of a guard.

    Attributes
    ----------
    apart : Apart or None
        Where the guarded value is not near the truth.
    singular : bool
        Whether the truth has no value at a state inside.
    states : int
        At how many the values are near.
    """

    apart: Apart | None
    singular: bool
    states: int


def is_guard(condition: Relational, demands: Sequence[Demand]) -> bool:
    """Whether a condition is a small guard of something that is demanded beside it."""
    if not _is_small(condition):
        return False
    held = condition.free_symbols
    return any(
        held & set().union(*(e.free_symbols for e in demand.operands))
        for demand in demands
        for other, answer in demand.conditions
        if isinstance(other, Relational) and _is_small(Not(other) if answer else other)
    )


def _is_small(condition: Relational) -> bool:
    """Whether it says of something that it is less than a small number."""
    return 0 < _number(condition) <= LARGEST


def _number(condition: Relational) -> Fraction:
    """The number that something is less than; 0 where there is none."""
    if not isinstance(condition, Lt | Le | Gt | Ge):
        return Fraction(0)
    number = (condition.gts - condition.lts).as_coeff_Add()[0]
    return Fraction(int(number.p), int(number.q)) if number.is_Rational else Fraction(0)


def inside(truth: Equations, conditions: Sequence[Relational], experiment: Experiment) -> Inside:
    """Guarded values beside those of the truth, at states where conditions hold.

    Parameters
    ----------
    conditions : sequence of Relational
        Of the case.
    experiment : callable
        Pairs of a value of the truth and a guarded one.
    """
    singular, near = False, 0
    a = Arithmetic()
    pairs = experiment(a)
    left, right = [x for x, _ in pairs], [y for _, y in pairs]
    program = a.builder.program({LEFT: left, RIGHT: right, POSITIVE: a.positive})
    for state in _states(truth, conditions):
        values = _at(program, {a.inputs[s]: v for s, v in state.items() if s in a.inputs})
        with precision(BITS):
            if values is None:
                singular = True
                continue
            far = [(x, y) for x, y in values if not _is_near(x, y)]
            if far:
                return Inside(_apart(state, *far[0]), singular, near)
            near += 1
    return Inside(None, singular, near)


def _states(
    truth: Equations, conditions: Sequence[Relational]
) -> Iterator[Mapping[Symbol, Fraction]]:
    """States near 0 of what the guard holds, and far from it, where conditions hold."""
    scene = truth.scene
    symbols = (*scene.parameters, *scene.q, *scene.u, *scene.input_symbols)
    held = set().union(*(c.free_symbols for c in conditions))
    numbers = [number for c in conditions if (number := _number(c)) > 0]
    sizes = [share * number for share in SHARES for number in numbers]
    for k, size in enumerate((*sizes, *SIZES)):
        for sign, moving in product((1, -1), (0, 1)):
            state = {}
            for place, symbol in enumerate(symbols):
                value = SIMPLE[(place + k) % len(SIMPLE)]
                if symbol.is_positive:
                    typical = Fraction(getattr(symbol, "typical", None) or 1)
                    state[symbol] = abs(value) if k % 2 else typical
                else:
                    state[symbol] = sign * size if symbol in held else moving * value
            table = {s: Rational(v.numerator, v.denominator) for s, v in state.items()}
            if all(condition.xreplace(table) == S.true for condition in conditions):
                yield state


def _at(program: Program, state: Mapping[str, Fraction]) -> list[tuple[arb, arb]] | None:
    """Pairs at a state; None where the truth has no value, or the state is none of the scene."""
    if not state.keys() >= set(program.inputs):
        return None
    values = enclose(program, state, BITS)
    known = all(x.is_finite() for x in values[LEFT]) and all(x > 0 for x in values[POSITIVE])
    return list(zip(values[LEFT], values[RIGHT], strict=True)) if known else None


def _is_near(x: arb, y: arb) -> bool:
    if not y.is_finite():
        return True  # where it has a value is another question
    return bool(abs(x - y) <= ball(NEAR) * abs(x).max(arb(1)))


def _apart(state: Mapping[Symbol, Fraction], x: arb, y: arb) -> Apart:
    words = tuple(sorted((symbol.name, str(value)) for symbol, value in state.items()))
    return Apart(words, x + arb(0, (ball(NEAR) * abs(x).max(arb(1))).upper()), y)
