"""A witness: a real, admissible state where the enclosures of the two sides are disjoint.

[left] and [right] disjoint  =>  left != right there, whatever the rounding.

States are the same for the same statement: simple numbers first, so that a person can put them into
something else; then numbers that are drawn, of more digits and other magnitudes.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from flint import arb

from mechanics.kernel.balls import PRECISIONS, enclose, precision
from mechanics.kernel.conjugates import has_cases
from mechanics.kernel.draws import Draws
from mechanics.kernel.finding import Witness, exact, in_words
from mechanics.kernel.statement import LEFT, POSITIVE, RIGHT, Range, Statement
from mechanics.program import Program
from mechanics.program.operations import COS, EQUAL, INPUT, LESS, NOT_GREATER, SIGN, SIN

DIGITS = 17
SIMPLE = tuple(
    Fraction(*pair)
    for pair in ((1, 1), (2, 1), (1, 2), (3, 1), (3, 2), (5, 2), (3, 4), (5, 4), (7, 4), (4, 1))
)
ANGLES = tuple(Fraction(n, 10) for n in (3, 7, 11, 5, 8, 13, 2, 9, 4, 15))
"""In radians: none is near a multiple of a quarter turn."""

STATES = 160
SIMPLE_STATES = 24
TYPICAL_STATES = 12
ROUNDS = ((PRECISIONS, 4), ((64, 256), 80))
"""Precisions, and at how many states where both sides are defined they are tried: many digits for
differences that are tiny everywhere, many states for those that are zero where some sign is right.
"""

BOUNDARY_PRECISIONS = (64, 256)
MOST_BOUNDARIES = 8
"""Inputs that are paired with each other to find boundaries of cases."""
BOUNDARY_STATES = 3
COMPARISONS = frozenset({SIGN, LESS, NOT_GREATER, EQUAL})

State = dict[str, Fraction]


def states(statement: Statement) -> Iterator[State]:
    """States that meet the declared signs, simple ones first."""
    names = statement.program.inputs
    angles = angle_inputs(statement.program)
    typical = {name: value for name, value in statement.typical.items() if name in names}
    draws = Draws(statement.seed, "witness")

    def simple(k: int) -> State:
        return {name: _simple(statement.range_of(name), name in angles, i, k)
                for i, name in enumerate(names)}  # fmt: skip

    if statement.typical:
        yield simple(0) | typical
    for k in range(SIMPLE_STATES):
        if statement.typical and k < TYPICAL_STATES:
            known = simple(k + 1) | typical
            yield {name: known[name] * _near(i, k) for i, name in enumerate(names)}
        yield simple(k)
    for k in range(STATES - SIMPLE_STATES):
        state = {name: _drawn(statement.range_of(name), draws, k) for name in names}
        near = {name: value * (1 + Fraction(draws.below(129) - 64, 256))
                for name, value in typical.items() if k % 2}  # fmt: skip
        yield state | near


def boundaries(statement: Statement) -> Iterator[State]:
    """States on the boundaries of cases: inputs that are zero, pairs that are equal, and values of
    an input for which what is compared is equal, if it is linear in that input.

    Of several states: at a single one, sides may be equal by accident.
    """
    names = [n for n in statement.program.inputs if statement.range_of(n) is Range.FREE]
    base, draws = next(states(statement)), Draws(statement.seed, "boundaries")
    yield base | dict.fromkeys(names, Fraction(0))
    for place, name in enumerate(names[:MOST_BOUNDARIES]):
        for other in names[:place]:
            yield base | {name: base[other]}
            yield base | {name: -base[other]}
    for _ in range(BOUNDARY_STATES):
        yield from (base | {name: Fraction(0)} for name in names[:MOST_BOUNDARIES])
        yield from _meetings(statement, base)
        base = {n: _drawn(statement.range_of(n), draws, 0) for n in statement.program.inputs}


def _meetings(statement: Statement, base: State) -> Iterator[State]:
    """States in which both sides of a comparison are equal, from two values of each input."""
    program = statement.program
    sides = {str(number): program.operands_of(number)
             for number, code in enumerate(program.operations) if code in COMPARISONS}  # fmt: skip
    compared = replace(program, outputs=sides)
    for name in program.inputs if sides else ():
        ends = [enclose(compared, base | {name: Fraction(x)}) for x in (0, 1)]
        for key in sides:
            here, there = (end[key][0] - sum(end[key][1:]) for end in ends)
            slope = here - there
            if slope.is_finite() and slope.is_exact() and not slope.is_zero():
                value = exact(here) / exact(slope)
                if _admits(statement.range_of(name), value):
                    yield base | {name: value}


def _admits(known: Range, value: Fraction) -> bool:
    if not value:
        return known in (Range.FREE, Range.NONNEGATIVE)
    return _signed(known, abs(value), value < 0) == value


def far_states(statement: Statement) -> Iterator[State]:
    """States beyond the constants of a program with cases: a limit at 100 is met by 101 alone."""
    if not has_cases(statement.program):
        return
    base = next(states(statement))
    far = {abs(constant) for constant in statement.program.constants} - set(SIMPLE)
    for constant in sorted(size for size in far if size > 1)[:MOST_BOUNDARIES]:
        for name in statement.program.inputs[:MOST_BOUNDARIES]:
            for value in (constant + 1, -constant - 1):
                if _admits(statement.range_of(name), value):
                    yield base | {name: value}


def first_witness(statement: Statement, tried: Iterable[State]) -> Witness | None:
    """The first of some states that refutes the statement, or None where none does."""
    found = (_at_state(statement, state, BOUNDARY_PRECISIONS)[0] for state in tried)
    return next((witness for witness in found if witness is not None), None)


def angle_inputs(program: Program) -> frozenset[str]:
    """Inputs whose sine or cosine is taken."""
    first = program.operands[0]
    return frozenset(
        program.inputs[first[first[number]]]
        for number, code in enumerate(program.operations)
        if code in (SIN, COS) and program.operations[first[number]] == INPUT
    )


def _simple(known: Range, is_angle: bool, place: int, k: int) -> Fraction:
    """Each input another number in each state; signs by Walsh: any two inputs meet both ways."""
    table = ANGLES if is_angle else SIMPLE
    size = table[(place * (1 + k % 3) + k) % len(table)]
    return _signed(known, size, (k & (place % 31 + 1)).bit_count() % 2 == 1)


def _signed(known: Range, size: Fraction, minus: bool) -> Fraction:
    """A size with a sign that the range admits, minus where either is."""
    return -size if known is Range.NEGATIVE or (known is Range.FREE and minus) else size


def _near(place: int, k: int) -> Fraction:
    """A factor close to 1, another for each input: what a body can have stays so."""
    return 1 + Fraction((place * 7 + k * 5) % 11 - 5, 100)


def _drawn(known: Range, draws: Draws, k: int) -> Fraction:
    """Multiples of 1/64 up to 4; later ones of all magnitudes."""
    size = Fraction(1 + draws.below(255), 64)
    if k >= STATES // 2:
        size *= Fraction(2) ** (draws.below(25) - 12)
    return _signed(known, size, bool(draws.bits(1)))


def find_witness(statement: Statement) -> Witness | None:
    """A state that refutes the statement, or None where none was found."""
    for precisions, wanted in ROUNDS:
        defined = 0
        for state in states(statement):
            found, here = _at_state(statement, state, precisions)
            if found is not None:
                return found
            defined += here
            if defined == wanted:
                break
    return first_witness(statement, far_states(statement))


def _at_state(
    statement: Statement, state: Mapping[str, Fraction], precisions: Sequence[int]
) -> tuple[Witness | None, bool]:
    """A witness if there is one, and whether an entry of both sides had a value."""
    defined = False
    for bits in precisions:
        outputs = enclose(statement.program, state, bits)
        conditions = outputs.get(POSITIVE, ())
        if any(entry <= 0 for entry in conditions):
            return None, defined
        pairs = zip(outputs[LEFT], outputs[RIGHT], strict=True)
        finite = [(x, y) for x, y in pairs if x.is_finite() and y.is_finite()]
        defined = defined or bool(finite)
        if not finite and bits >= 256:
            return None, defined
        if not all(entry > 0 for entry in conditions):
            continue  # more digits may tell
        apart = [(x, y) for x, y in finite if not x.overlaps(y)]
        if apart:
            with precision(bits):
                x, y = max(apart, key=lambda pair: float(abs(pair[0] - pair[1]).mid()))
            told = {name: state[name] for name in state.keys() - statement.auxiliary}
            return _witness(told, outputs, x, y), True
    return None, defined


def _witness(
    state: Mapping[str, Fraction], outputs: Mapping[str, tuple[arb, ...]], x: arb, y: arb
) -> Witness:  # fmt: skip
    solved = [
        (name if len(values) == 1 else f"{name}[{i}]", value.str(DIGITS, radius=False))
        for name, values in outputs.items()
        if name not in (LEFT, RIGHT, POSITIVE)
        for i, value in enumerate(values)
    ]
    words = tuple((name, str(state[name])) for name in sorted(state))
    return Witness(words, *in_words(x, y), tuple(solved))
