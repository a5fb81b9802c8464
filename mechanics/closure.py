"""Where the constraints of a mechanism hold: a state that is closed, and points of its component.

    phi(q, p) = 0               configuration, by Newton's method from the scene's example      (1)
    q <- q - J^T (J J^T + d I)^-1 phi,    J = dphi/dq,  d = 0 where the rows are independent
    A(q, p) u + a = 0           conditions on the speeds                                        (2)

Dependent inputs are replaced as the kernel does it (`mechanics.kernel.constraints`): a chart of the
component that the closed state is on. At its points routes choose pivots and scenes are checked.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from flint import arb, arb_mat

from mechanics.kernel import Range, Statement, enclose
from mechanics.kernel.balls import precision
from mechanics.kernel.constraints import BITS, NEGLIGIBLE, on_constraints
from mechanics.kernel.statement import RATES, ZERO
from mechanics.program.builder import Builder, Node
from mechanics.program.derivatives import gradient
from mechanics.program.interpret import include
from mechanics.program.residues import Choice, Residues

STEPS = 60
CLOSED = 2.0**-200
DAMPING = 2.0**-60


@dataclass(frozen=True)
class Closure:
    """What is known of the states at which constraints hold.

    Attributes
    ----------
    configuration, rates : tuples of Node
        Constraints of the coordinates, and those of the speeds with the rates of the first.
    dependent : tuple of str
        Inputs for which they may be solved: speeds, parameters, coordinates.
    start : mapping of str to Fraction
        A state at which (1) holds to 200 binary digits; empty where none is known.
    values : mapping of Node to Node
        What takes the place of dependent inputs; empty where no exact point is known.
    choice : Choice or None
        A point of the field that has the roots of these values: found once, filters begin with it.
    """

    configuration: tuple[Node, ...] = ()
    rates: tuple[Node, ...] = ()
    dependent: tuple[str, ...] = ()
    start: Mapping[str, Fraction] = field(default_factory=dict)
    values: Mapping[Node, Node] = field(default_factory=dict)
    choice: Choice | None = None

    def __bool__(self) -> bool:
        return bool(self.configuration or self.rates)


def close(
    builder: Builder,
    configuration: Sequence[Node],
    rates: Sequence[Node],
    dependent: Sequence[str],
    coordinates: Sequence[Node],
    suggested: Mapping[str, Fraction],
    signs: Mapping[str, Range],
) -> Closure:
    """The closure of constraints.

    Parameters
    ----------
    configuration, rates : sequences of Node
    dependent : sequence of str
        Inputs in the order in which they are tried.
    coordinates : sequence of Node
        Inputs that Newton's method may move.
    suggested : mapping of str to Fraction
        The scene's example and typical values. Where one is missing both branches of each root are
        followed; if their states are singular, one is chosen that is regular and near the example.
    """
    start = closed_state(builder, configuration, coordinates, suggested)
    plain = Closure(tuple(configuration), tuple(rates), tuple(dependent), start)
    if start:
        closure = _with_values(builder, plain, signs)
        if closure.values:
            return closure
    # Where the state is one at which components meet, what is said is said of all of them.
    both = _regular(builder, replace(plain, start={}), coordinates, signs)
    if start or both:
        return both or plain
    completed = _completed(builder, configuration, coordinates, suggested, signs)
    known = _regular(builder, replace(plain, start=completed), coordinates, signs)
    return known or _with_values(builder, plain, signs)


def extended(
    builder: Builder,
    closure: Closure,
    forms: Sequence[Node],
    dependent: Iterable[str],
    signs: Mapping[str, Range],
) -> Closure:
    """The closure with forms that are zero, too, solved for inputs of their own: accelerations.

    Parameters
    ----------
    dependent : iterable of str
        Inputs that only the forms hold.
    """
    program = builder.program({"forms": forms})
    names = {builder.inputs[builder.operands[0][x.number]]: v for x, v in closure.values.items()}
    held = {name: names[name] for name in program.inputs if name in names}
    plain = replace(
        closure,
        configuration=(),
        rates=include(builder, program, held)["forms"],
        dependent=tuple(dependent),
        values={},
    )
    more = _with_values(builder, plain, signs)
    return replace(closure, values={**closure.values, **more.values} if more.values else {})


def with_both_roots(builder: Builder, closure: Closure, signs: Mapping[str, Range]) -> Closure:
    """The closure with a free sign for each root, whichever leads to the closed state."""
    return _with_values(builder, replace(closure, start={}, values={}), signs)


def _completed(
    builder: Builder,
    configuration: Sequence[Node],
    coordinates: Sequence[Node],
    suggested: Mapping[str, Fraction],
    signs: Mapping[str, Range],
) -> dict[str, Fraction]:
    """A state near the example; Newton moves parameters without typical values, too, from 1."""
    inputs = builder.program({"zero": configuration}).inputs
    moved = {builder.inputs[builder.operands[0][q.number]] for q in coordinates}
    missing = [name for name in inputs if name not in {*suggested, *moved}]
    signed = {n: Fraction(-1 if signs.get(n) is Range.NEGATIVE else 1) for n in missing}
    nodes = [*coordinates, *map(builder.input, missing)]
    state = closed_state(builder, configuration, nodes, {**suggested, **signed})
    return state if all(state.get(n, 0) * sign > 0 for n, sign in signed.items()) else {}


def _is_regular(builder: Builder, closure: Closure, coordinates: Sequence[Node]) -> bool:
    """Whether the constraints restrict as many motions at the point as elsewhere."""
    if not closure.values:
        return False
    slopes = [gradient([one], [1], coordinates) for one in closure.configuration]
    filters = Residues(builder), Residues(builder, closure.values, closure.choice)
    return filters[0].rank(slopes) == filters[1].rank(slopes)


def _regular(
    builder: Builder, plain: Closure, coordinates: Sequence[Node], signs: Mapping[str, Range]
) -> Closure | None:
    """The closure with values, where these are regular.

    Tried in a builder of its own: filters draw until all roots exist that a builder has.
    """
    own = Builder()
    groups = {"zero": plain.configuration, "rates": plain.rates, "q": coordinates}
    zero, rates, q = map(tuple, include(own, builder.program(groups)).values())
    tried = _with_values(own, replace(plain, configuration=zero, rates=rates), signs)
    if not _is_regular(own, tried, q):
        return None
    named = {own.inputs[own.operands[0][x.number]]: [value] for x, value in tried.values.items()}
    nodes = include(builder, own.program(named))
    values = {builder.input(name): node for name, (node,) in nodes.items()}
    return replace(plain, values=values, choice=Residues(builder, values).choice)


def _with_values(builder: Builder, plain: Closure, signs: Mapping[str, Range]) -> Closure:
    """The closure with what takes the place of dependent inputs, where an exact point is known."""
    configuration, start = plain.configuration, plain.start
    outputs = {"left": [builder.zero], "right": [builder.one]}
    program = builder.program({**outputs, ZERO: configuration, RATES: plain.rates})
    statement = Statement("closure", program, signs, start, plain.dependent)
    constrained = on_constraints(statement)
    if constrained is None:
        return plain
    solved = [name for name in program.inputs if name in constrained.program.outputs]
    nodes = include(builder, constrained.program)
    values = {builder.input(name): nodes[name][0] for name in solved}
    filter_ = Residues(builder, values, plain.choice)
    closed = not any(filter_.values([*configuration, *plain.rates]))
    return replace(plain, values=values, choice=filter_.choice) if closed else plain


def independent_at(
    builder: Builder, rows: Sequence[Sequence[Node]], state: Mapping[str, Fraction]
) -> list[int]:
    """Indices of the rows that are independent of those before them at a closed state.

    By numbers of `BITS` digits: what is left of a row that depends is `NEGLIGIBLE`.

    Parameters
    ----------
    rows : sequence of equally long sequences of Node
    state : mapping of str to Fraction
        An input that has no value counts as 1.
    """
    program = builder.program({"rows": [entry for row in rows for entry in row]})
    given = {name: state.get(name, Fraction(1)) for name in program.inputs}
    width, kept, left = len(rows[0]), list[int](), list[tuple[int, list[arb]]]()
    with precision(BITS):
        entries = [value.mid() for value in enclose(program, given, BITS)["rows"]]
        for place in range(len(rows)):
            row = entries[width * place : width * (place + 1)]
            for pivot, other in left:
                factor = row[pivot] / other[pivot]
                row = [(x - factor * y).mid() for x, y in zip(row, other, strict=True)]
            pivot = max(range(width), key=lambda k: float(abs(row[k])))
            if float(abs(row[pivot])) > NEGLIGIBLE:
                kept.append(place)
                left.append((pivot, row))
    return kept


def closed_state(
    builder: Builder,
    configuration: Sequence[Node],
    coordinates: Sequence[Node],
    suggested: Mapping[str, Fraction],
) -> dict[str, Fraction]:
    """Equation (1); empty where a value is missing or Newton's method does not come to a point."""
    slopes = [gradient([one], [1], coordinates) for one in configuration]
    program = builder.program({"value": configuration, "slope": [e for row in slopes for e in row]})
    names = [builder.inputs[builder.operands[0][q.number]] for q in coordinates]
    state = {**dict.fromkeys(names, Fraction(0)), **suggested}
    if not state.keys() >= set(program.inputs):
        return {}
    with precision(BITS):
        for _ in range(STEPS):
            outputs = enclose(program, state, BITS)
            if not all(ball.is_finite() for balls in outputs.values() for ball in balls):
                return {}
            value = arb_mat(len(configuration), 1, [v.mid() for v in outputs["value"]])
            if all(abs(entry) < CLOSED for entry in value.entries()):
                return state
            slope = arb_mat(len(configuration), len(names), [v.mid() for v in outputs["slope"]])
            gram = slope * slope.transpose()
            try:
                step = slope.transpose() * gram.solve(value)
            except ZeroDivisionError:
                # Rows that depend: what the diagonal changes is in the null space of J^T.
                small = arb_mat(len(configuration), len(configuration), 1) * arb(DAMPING)
                step = slope.transpose() * (gram + small).solve(value)
            for name, change in zip(names, step.entries(), strict=True):
                state[name] = _exact(arb(state[name].numerator) / state[name].denominator - change)
    return {}


def _exact(value: arb) -> Fraction:
    """The midpoint of a ball."""
    mantissa, exponent = value.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
