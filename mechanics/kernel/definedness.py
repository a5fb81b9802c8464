"""Where a statement is defined: obligations of what was written, discharged or shown to fail.

    D_t    real states where loads and geometry have values and the mass matrix is regular
    D_w    where what was written has values
    gaps   what is left of D_t without D_w: thin sets, open sets, everything

An obligation is a sign that an expression must have, under the conditions of its branch. In order:
declared signs and the sign of its polynomial, with what its branch and the stated region say; the
same obligation in the truth; for divisors, factors that divide one of the truth's. What is left is
decided by states: a ball strictly outside, where the truth has its value, shows an open gap.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from functools import cache

from flint import arb, fmpq_mpoly

from mechanics.kernel.balls import ball, enclose
from mechanics.kernel.conjugates import has_cases, is_thin
from mechanics.kernel.draws import Draws
from mechanics.kernel.finding import Finding, Verdict, undecided
from mechanics.kernel.signs import (
    ANY,
    NEGATIVE,
    NOT_NEGATIVE,
    NOT_POSITIVE,
    POSITIVE,
    ZERO,
    Fact,
    Forms,
    Quotient,
    negated,
)
from mechanics.kernel.states import State, candidates
from mechanics.program import operations as op
from mechanics.program.builder import Builder, Condition, Node, Obligation
from mechanics.program.program import reachable

BITS = 192

MOST_ZEROS = 12
"""States at which an argument is 0 that are looked at further."""
NEAR = 6
"""States near one that are tried, to tell an open set from a thin one."""
PRODUCTS = 4
"""States at which the product over all cases is tried."""


class Kind(Enum):
    """How much of the truth's states a gap is; the value is for people."""

    THIN = "a set without interior"
    OPEN = "an open set"
    NOWHERE = "all states"
    UNKNOWN = "it is not known where"


@dataclass(frozen=True)
class Gap:
    """Where an obligation of what was written is not met, and the truth has its value.

    Attributes
    ----------
    at_rest : bool
        Whether a reference state is in it; strictly inside for open sets.
    state : tuple of (str, Fraction or arb)
        One of its states; empty where none is known.
    region : bool
        Whether that state lies in a region that was stated.
    branch : bool
        Whether it is not met wherever its branch is taken.
    """

    obligation: Obligation
    kind: Kind
    at_rest: bool = False
    state: tuple[tuple[str, Fraction | arb], ...] = ()
    region: bool = False
    branch: bool = False


@dataclass(frozen=True)
class Space:
    """What is known of the states.

    Attributes
    ----------
    positive : frozenset of str
        Inputs that are declared positive.
    base : state
        What inputs are that are not tried; a value for every input.
    references : tuple of states
        Rest, and declared equilibria, where what was written has to have a value.
    region : tuple of int
        Nodes that are positive where the statement is judged.
    truth : tuple of Obligation
        Of the loads, the geometry, the mass matrix.
    zero : tuple of int
        Nodes that are zero at all states: configuration constraints.
    admissible : callable
        From a state to one on the constraints, or None where there is none.
    """

    positive: frozenset[str]
    base: State
    references: tuple[State, ...]
    region: tuple[int, ...] = ()
    truth: tuple[Obligation, ...] = ()
    zero: tuple[int, ...] = ()
    admissible: Callable[[State], State | None] = dict


def unmet(builder: Builder, written: Sequence[Obligation], space: Space) -> tuple[Obligation, ...]:
    """Obligations that neither signs nor the truth, as far as `space` says it, discharge.

    Parameters
    ----------
    builder : Builder
        With the nodes of all obligations.
    """
    forms = _forms(builder, written, space)
    return tuple(o for o, _ in _left(forms, written, space))


def excludes(builder: Builder, conditions: Sequence[Condition], positive: frozenset[str]) -> bool:
    """Whether no state meets all conditions, by the signs of their differences.

    Parameters
    ----------
    conditions : sequence of (int, bool)
        Nodes, and the truth values that are asked for.
    positive : frozenset of str
        Inputs that are declared positive.
    """
    forms = Forms(builder, [node for node, _ in conditions], positive.__contains__)
    return _contradict(forms, _facts(forms, (), conditions))


def _contradict(forms: Forms, facts: Sequence[Fact]) -> bool:
    return any(not forms.sign(p) & possible for p, possible in facts)


def gaps(builder: Builder, written: Sequence[Obligation], space: Space) -> tuple[Gap, ...]:
    """What obligations leave out of the states of the truth.

    Parameters
    ----------
    builder : Builder
        With the nodes of all obligations.
    """
    forms = _forms(builder, written, space)
    left = _left(forms, written, space)
    if not left:
        return ()
    trial = _Trial(builder, forms, space, [o for o, _ in left])
    found = (trial.gap(obligation, signs) for obligation, signs in left)
    return tuple(gap for gap in found if gap is not None)


def undefined(subject: str, words: str, gap: Gap) -> Finding:
    """What is said of a gap that refutes: REFUTED where it leaves states out that have to be met.

    Those are all states, open sets that hold a reference state, and states of the stated region.
    """
    if gap.kind is Kind.NOWHERE or (gap.kind is Kind.OPEN and (gap.at_rest or gap.region)):
        return Finding(subject, Verdict.REFUTED, words, domain="undefined")
    return undecided(subject, f"{words}: not known of any state that has to be met")


def _forms(builder: Builder, written: Sequence[Obligation], space: Space) -> Forms:
    rows = (*written, *space.truth)
    nodes = [node for o in rows for node in (o.node, *(c for c, _ in o.conditions))]
    roots = [*nodes, *space.region, *space.zero]
    return Forms(builder, roots, space.positive.__contains__)


def _closing(forms: Forms, space: Space) -> list[fmpq_mpoly]:
    """Polynomials that are zero at all states."""
    return [form.above for node in space.zero if (form := forms.forms[node]) is not None]


def _left(
    forms: Forms, written: Sequence[Obligation], space: Space
) -> list[tuple[Obligation, int]]:
    """Obligations that are not discharged, with the signs that are possible."""
    left: list[tuple[Obligation, int]] = []
    closing = _closing(forms, space)
    of_truth = cache(lambda other: tuple(_of_truth(forms, other)))
    for obligation in written:
        facts = _facts(forms, space.region, obligation.conditions)
        for more in dict.fromkeys(((), space.truth)):
            of_branch = (o for o in more if set(o.conditions) <= set(obligation.conditions))
            facts += [fact for other in of_branch for fact in of_truth(other)]
            signs = forms.sign_on(forms.forms[obligation.node], closing, facts)
            known = met(signs, obligation.sign) or _contradict(forms, facts)
            if known:
                break
        if not (known or any(_follows(forms, obligation, other) for other, _ in left)):
            left.append((obligation, signs))
    return left


def _follows(forms: Forms, obligation: Obligation, other: Obligation) -> bool:
    """Whether one is met where the other is: its argument is a positive number of times theirs."""
    one, two = forms.forms[obligation.node], forms.forms[other.node]
    if one is None or two is None or obligation.sign is not other.sign:
        return False
    if not set(other.conditions) <= set(obligation.conditions):
        return False
    ratio = forms.quotient(one, two)
    signs = ANY if ratio is None else forms.sign_of(ratio)
    return signs == POSITIVE or (obligation.sign is op.Sign.NONZERO and not signs & ZERO)


def met(signs: int, demanded: op.Sign) -> bool:
    """Whether an expression of these signs has the one that is demanded."""
    if demanded is op.Sign.NONZERO:
        return not signs & ZERO
    return signs == POSITIVE if demanded is op.Sign.POSITIVE else not signs & NEGATIVE


def _facts(forms: Forms, region: Sequence[int], conditions: Sequence[Condition]) -> list[Fact]:
    """What a region and the conditions of a branch say of polynomials."""
    found: list[Fact] = []
    for node in region:
        found += _fact(forms, forms.forms[node], POSITIVE)
    for node, truth in conditions:
        found += _of_condition(forms, node, truth)
    return found


def _of_truth(forms: Forms, obligation: Obligation) -> Iterator[Fact]:
    """What an obligation of the truth says of polynomials: it is met, and no factor is zero."""
    form = forms.forms[obligation.node]
    if form is None:
        return
    if obligation.sign is not op.Sign.NONZERO:
        signs = POSITIVE if obligation.sign is op.Sign.POSITIVE else NOT_NEGATIVE
        yield from _fact(forms, form, signs)
    if obligation.sign is not op.Sign.NONNEGATIVE and len(form.above):
        for factor in forms.factors(form.above):
            yield Fact(factor, ANY & ~ZERO)


def _fact(forms: Forms, form: Quotient | None, signs: int) -> Iterator[Fact]:
    if form is None:
        return
    below = forms.sign(form.below) & ~ZERO
    if below not in (POSITIVE, NEGATIVE):
        return
    known = signs if below == POSITIVE else negated(signs)
    # Facts are told of what is not negative, where that can be.
    turned = known & NEGATIVE and not known & POSITIVE
    yield Fact(-form.above, negated(known)) if turned else Fact(form.above, known)


def _of_condition(forms: Forms, node: int, truth: bool) -> Iterator[Fact]:
    builder, (first, second, _) = forms.builder, forms.builder.operands
    code = builder.operations[node]
    if code == op.NOT:
        yield from _of_condition(forms, first[node], not truth)
    elif (code, truth) in ((op.AND, True), (op.OR, False)):
        yield from _of_condition(forms, first[node], truth)
        yield from _of_condition(forms, second[node], truth)
    elif code in (op.LESS, op.NOT_GREATER, op.EQUAL):
        difference = forms.difference(second[node], first[node])
        signs = {op.LESS: POSITIVE, op.NOT_GREATER: NOT_NEGATIVE, op.EQUAL: ZERO}[code]
        yield from _fact(forms, difference, signs if truth else ANY & ~signs)


class _Trial:
    """States at which obligations are tried."""

    def __init__(
        self, builder: Builder, forms: Forms, space: Space, left: Sequence[Obligation]
    ) -> None:
        self.builder, self.forms, self.space = builder, forms, space
        self.left = left
        self.text = builder.program({"left": self._nodes(o.node for o in left)}).digest
        outputs: dict[str, Sequence[int]] = {
            "left": [o.node for o in left],
            "region": space.region,
            "truth": [o.node for o in space.truth],
            "conditions of truth": [c for o in space.truth for c, _ in o.conditions],
        }
        for place, obligation in enumerate(left):
            outputs[f"conditions {place}"] = [c for c, _ in obligation.conditions]
        self.program = builder.program({n: self._nodes(of) for n, of in outputs.items()})

    def _nodes(self, numbers: Iterable[int]) -> list[Node]:
        return [Node(self.builder, number) for number in numbers]

    def gap(self, obligation: Obligation, signs: int) -> Gap | None:
        """What an obligation leaves out."""
        sign, form = obligation.sign, self.forms.forms[obligation.node]
        never = NEGATIVE if sign is op.Sign.NONNEGATIVE else NOT_POSITIVE
        if sign is op.Sign.NONZERO:
            never = ZERO
        vanishes = form is not None and not len(form.above)
        if vanishes and sign is op.Sign.NONNEGATIVE:
            return None
        region, always = bool(self.space.region), vanishes or not signs & ~never
        if not obligation.conditions and always:
            return Gap(obligation, Kind.NOWHERE, True, (), region)
        places = [self._at(obligation, r, bound=True) for r in self.space.references]
        outside, zeros, inside = self._tried(obligation)
        at_rest = zip(self.space.references, places, strict=True)
        outside = next((state for state, place in at_rest if place == -1), outside)
        if sign is not op.Sign.NONZERO and outside is not None:
            # States may be left where it is met, unless its sign is known.
            interior = inside is not None or signs & POSITIVE or obligation.conditions
            kind = Kind.OPEN if interior else Kind.NOWHERE
            return Gap(obligation, kind, -1 in places, tuple(outside.items()), region, always)
        if sign is op.Sign.NONNEGATIVE or (sign is op.Sign.POSITIVE and signs & NEGATIVE):
            return Gap(obligation, Kind.UNKNOWN)
        # What is left fails where its argument is 0.
        rests = [r for r, place in zip(self.space.references, places, strict=True) if place == 0]
        if self._is_thin(obligation, vanishes, inside):
            return Gap(obligation, Kind.THIN, bool(rests))
        wide = next(
            (state for state in (*rests, *zeros) if self._zero_around(obligation, state)), None
        )
        if wide is None:
            return Gap(obligation, Kind.UNKNOWN)
        return Gap(
            obligation, Kind.OPEN, any(wide is r for r in rests), tuple(wide.items()), region
        )

    def _is_thin(self, obligation: Obligation, vanishes: bool, inside: State | None) -> bool:
        """Whether what must not be 0 is so on a thin set, or stands in a branch of one."""
        builder, (first, second, _) = self.builder, self.builder.operands
        nodes = [] if vanishes else [Node(builder, obligation.node)]
        for node, truth in obligation.conditions:
            while builder.operations[node] == op.NOT:
                node, truth = first[node], not truth
            if truth and builder.operations[node] == op.EQUAL:
                nodes.append(Node(builder, first[node]) - Node(builder, second[node]))
        return any(self._vanishes_on_a_thin_set(node, inside) for node in nodes)

    def _vanishes_on_a_thin_set(self, node: Node, inside: State | None) -> bool:
        program = self.builder.program({"x": [node]})
        if not has_cases(program) and inside is not None:
            return True
        drawn = list(
            candidates(
                program.digest, self._names(program.inputs), self.space.positive.__contains__,
                self._base(), (),
            )
        )  # fmt: skip
        states = [*([] if inside is None else [inside]), *drawn[-PRODUCTS:]]
        there = (self.space.admissible(state) for state in states)
        return is_thin(program, "x", [balls for balls in there if balls is not None])

    def _names(self, inputs: Sequence[str]) -> list[str]:
        """Inputs that are tried for some of them: on constraints, one cannot be changed alone."""
        return sorted(self.space.base if self.space.zero else inputs)

    def _zero_around(self, obligation: Obligation, state: State) -> bool:
        """Whether the argument is 0 at a state and at all drawn ones near it."""
        draws = Draws(self.text, "near")
        for _ in range(NEAR):
            steps = (Fraction(draws.below(2 << 12) - (1 << 12), 1 << 40) for _ in state)
            moved = {
                name: value + (1 + abs(value)) * (ball(step) if isinstance(value, arb) else step)
                for (name, value), step in zip(state.items(), steps, strict=True)
            }
            if self._at(obligation, moved) != 0:
                return False
        return True

    def _tried(self, obligation: Obligation) -> tuple[State | None, list[State], State | None]:
        """A state where it fails, states where its argument is zero, and one where it holds."""
        builder = self.builder
        nodes = [obligation.node, *(node for node, _ in obligation.conditions)]
        names = self._names(self._inputs(nodes))
        values = [builder.constant_at(node) for node in reachable(builder, nodes)]
        constants = [value for value in values if value is not None]
        positive = self.space.positive.__contains__
        analytic = not has_cases(builder.program({"x": [Node(builder, obligation.node)]}))
        zeros: list[State] = []
        outside = inside = None
        for state in candidates(self.text, names, positive, self._base(), constants):
            place = self._at(obligation, state)
            if place == -1 and outside is None:
                outside = state
            elif place == 0 and len(zeros) < MOST_ZEROS:
                zeros.append(state)
            elif place == 1 and inside is None:
                inside = state
            # What is analytic and not zero at one state is zero on a thin set at most.
            known = outside is not None or (obligation.sign is op.Sign.NONZERO and analytic)
            if known and inside is not None:
                break
        return outside, zeros, inside

    def _has_truth(self, values: Mapping[str, Sequence[arb]], bound: bool = False) -> bool:
        """Whether a state is in the region, and the truth has its value there and around.

        At the bound of where it has one, as 0 for a root, there is a value but none on one side.
        """
        if not all(value > 0 for value in values["region"]):
            return False
        arguments, conditions = iter(values["truth"]), iter(values["conditions of truth"])
        for row in self.space.truth:
            taken = [next(conditions) == int(truth) for _, truth in row.conditions]
            value = next(arguments)
            there = (0, 1) if bound and row.sign is op.Sign.NONNEGATIVE else (1,)
            if all(taken) and _place(value, row.sign) not in there:
                return False
        return True

    def _base(self) -> State:
        """What inputs are that are not tried: rest, but for what has to be 0 nowhere."""
        base, balls = self.space.base, self.space.admissible(self.space.base)
        if balls is None or self._has_truth(enclose(self.program, balls, BITS)):
            return base
        nodes = [*self.space.region, *(o.node for o in self.space.truth)]
        return {**base, **{n: base[n] or Fraction(1) for n in self._inputs(nodes)}}

    def _inputs(self, nodes: Sequence[int]) -> list[str]:
        builder = self.builder
        needed = [n for n in reachable(builder, nodes) if builder.operations[n] == op.INPUT]
        return sorted(builder.inputs[builder.operands[0][n]] for n in needed)

    def _at(self, obligation: Obligation, state: State, bound: bool = False) -> int | None:
        """-1 where it strictly fails, 0 where its argument is 0, 1 where it strictly holds.

        None where the state is none of the truth's, or not of the branch, or it cannot be told.
        """
        balls = self.space.admissible(state)
        if balls is None:
            return None
        values = enclose(self.program, balls, BITS)
        if not self._has_truth(values, bound):
            return None
        place = self.left.index(obligation)
        of_branch = zip(values[f"conditions {place}"], obligation.conditions, strict=True)
        if not all(value == int(truth) for value, (_, truth) in of_branch):
            return None
        return _place(values["left"][place], obligation.sign)


def _place(value: arb, sign: op.Sign) -> int | None:
    """Where an argument is of the bound of what is demanded: see `_Trial._at`."""
    if not value.is_finite():
        return None
    if value.is_zero() or (value.contains(0) and value.rad() < arb(2) ** -100):
        return 0
    if value.contains(0):
        return None
    if sign is op.Sign.NONZERO:
        return 1
    return 1 if value > 0 else -1
