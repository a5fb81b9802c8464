"""Where a statement that is shown has a value: its verdict, and the words of it.

nowhere, or strictly not at rest        REFUTED
an open set is left out                 PROVED WHERE r > 0; undefined at r = -1
a thin set, at rest, of code            NOT SHOWN: NaN at rest
a thin set                              PROVED except where cos(theta) = 0
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

from flint import arb
from sympy import Add, And, Basic, Expr, Mul, Not, Or, Pow, Symbol, sympify
from sympy.core.relational import Relational

from mechanics.checks.equilibria import exact
from mechanics.claims.code.trace.numerical_check import UNCALLED
from mechanics.claims.demands import RAISED, Demand, Demands, within
from mechanics.claims.statement import Statement
from mechanics.closure import with_both_roots
from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.judge.common_factor import demands_of_factors
from mechanics.kernel import Finding, Range, Verdict, enclose, undecided
from mechanics.kernel.definedness import (
    BITS,
    Gap,
    Kind,
    Space,
    gaps,
    undefined,
    unmet,
)
from mechanics.kernel.statement import POSITIVE
from mechanics.kernel.states import State
from mechanics.kinematics.symbolic import Kinematics
from mechanics.mechanism import name_of, ranges
from mechanics.program import Builder, Node, Obligation, Program
from mechanics.program.operations import Sign
from mechanics.program.sympy_reader import read
from mechanics.scene import Scene
from mechanics.scene.symbols import plain_symbol

LARGEST_DETERMINANT = 6
MOST_TOLD = 3
"""Conditions that stand beside a verdict."""


@dataclass(frozen=True)
class Written:
    """Obligations of what was written, and what each comes from."""

    builder: Builder
    origin: Mapping[Obligation, Demand]


def where_defined(
    truth: Equations, statement: Statement, finding: Finding, region: Sequence[Expr] = (),
    values: Mapping[Symbol, Expr] | None = None,
) -> Finding:  # fmt: skip
    """The finding of a statement, with where it is defined.

    Parameters
    ----------
    finding : Finding
        Of its formulas, as far as these have values.
    region : sequence of Expr
        What is positive where it is judged.
    values : mapping of Symbol to Expr, optional
        Parameters that have values.
    """
    demands = statement.demands
    if finding.shown:
        factors = demands_of_factors(truth, statement)
        demands = replace(demands, of=(*demands.of, *factors)) if factors else demands
    if finding.verdict is Verdict.REFUTED or not demands.of:
        return finding
    if never := [d for d in demands.of if d.nowhere and not d.conditions]:
        return _never(finding, never[0])
    uncalled = statement.doubt.startswith(UNCALLED) and statement.row is not None
    if not (finding.shown or uncalled) or all(map(_plain_divisor, demands.of)):
        return finding
    try:
        if uncalled:  # what it computes is not known; that it has no value is
            found = _decided(truth, demands, finding, region, {})
            return found if found.undefined else finding
        return _decided(truth, demands, finding, region, dict(values or {}))
    except MechanicsError as error:
        return undecided(finding.subject, str(error))


def _decided(
    truth: Equations, demands: Demands, finding: Finding, region: Sequence[Expr],
    fixed: Mapping[Symbol, Expr],
) -> Finding:  # fmt: skip
    written = _written(truth.scene, demands, fixed)
    if not written.origin:
        return finding
    builder, scene = written.builder, truth.scene
    before = dict(builder.obligations)
    inside = tuple(
        n.number for n in read(builder, [scene.plain(e).xreplace(fixed) for e in region])
    )
    space = _space(truth, builder, inside)
    left = unmet(builder, tuple(written.origin), space)
    if not left:
        return finding
    builder.obligations = {}
    space = replace(space, truth=_of_truth(truth, builder, fixed))
    builder.obligations = before
    space = _space(truth, builder, inside, space.truth)
    return _told(finding, gaps(builder, left, space), written, demands.code)


def at_the_bound(truth: Equations, statement: Statement, finding: Finding) -> tuple[str, ...]:
    """Remarks on code that is shown, and whose rounding may step over where a root is defined."""
    demands = statement.demands
    near = [d for d in demands.of if d.operation in ("asin", "acos") or _subtracts(d)]
    if not (finding.shown and demands.code and near):
        return ()
    written = _written(truth.scene, replace(demands, of=tuple(near)), {})
    builder = written.builder
    space = _space(truth, builder, ())
    roots = tuple(o for o in written.origin if o.sign is Sign.NONNEGATIVE)
    strictly = unmet(builder, tuple(replace(o, sign=Sign.POSITIVE) for o in roots), space)
    zero = {o.node for o in strictly} - {o.node for o in unmet(builder, roots, space)}
    names = dict.fromkeys(_operation(written.origin[o]) for o in roots if o.node in zero)
    return tuple(
        f"{name} is defined up to its bound, which it reaches: rounding may step over it"
        for name in names
    )


def _subtracts(demand: Demand) -> bool:
    """Whether it is a root of a difference; sums of squares are not negative in floats either."""
    if demand.operation != "sqrt":
        return False
    return any(t.could_extract_minus_sign() for t in Add.make_args(demand.operands[0]))


def _plain_divisor(demand: Demand) -> bool:
    """Whether it is a division by what is put together of positive parameters."""
    return demand.operation == "divide" and _positive(demand.operands[1])


def _positive(expression: Expr) -> bool:
    if isinstance(expression, Add | Mul):
        return all(map(_positive, expression.args))
    if isinstance(expression, Pow):
        return _positive(expression.base) and bool(expression.exp.is_Rational)
    return bool((expression.is_Symbol or expression.is_number) and expression.is_positive)


def _written(scene: Scene, demands: Demands, fixed: Mapping[Symbol, Expr]) -> Written:
    builder = Builder()
    plain = [
        (demand, [_plain(scene, e, fixed) for e in demand.operands],
         [_plain(scene, c, fixed) for c, _ in demand.conditions])
        for demand in demands.of
    ]  # fmt: skip
    read_in = [(d, read(builder, ops), read(builder, conditions)) for d, ops, conditions in plain]
    origin: dict[Obligation, Demand] = {}
    for demand, operands, conditions in read_in:
        builder.obligations = {}
        known = [answer for _, answer in demand.conditions]
        _ask(builder, demand, operands, list(zip(conditions, known, strict=True)))
        for obligation in builder.obligations:
            origin.setdefault(obligation, demand)
    builder.obligations = {}
    return Written(builder, origin)


def _plain(scene: Scene, expression: Expr, fixed: Mapping[Symbol, Expr]) -> Expr:
    return scene.plain(sympify(expression)).xreplace(dict(fixed))


def _ask(
    builder: Builder, demand: Demand, operands: Sequence[Node],
    conditions: list[tuple[Node, bool]],
) -> None:  # fmt: skip
    """Ask for an operation within a branch, so that its obligations are recorded."""
    if conditions:
        (condition, answer), *others = conditions
        if condition.constant is not None:
            if bool(condition.constant) == answer:
                _ask(builder, demand, operands, others)
            return
        with builder.under(condition, answer):
            _ask(builder, demand, operands, others)
    elif demand.nowhere or (demand.operation == "divide" and operands[1].constant == 0):
        builder.demand(Sign.NONZERO, 0, demand.operation)
    else:
        builder.call(demand.operation, *operands)


def _space(
    truth: Equations, builder: Builder, region: tuple[int, ...],
    obligations: tuple[Obligation, ...] = (),
) -> Space:  # fmt: skip
    scene = truth.scene
    symbols = {s.name: s for s in (*scene.parameters, *scene.definitions)}
    positive = frozenset(n for n in builder.inputs if n in symbols and symbols[n].is_positive)
    names = {*builder.inputs, *symbols, *(s.name for s in (*scene.q, *scene.u))}
    rest = {name: _typical(symbols.get(name), positive=name in positive) for name in sorted(names)}
    still = tuple(_still(rest, values) for values in scene.equilibria)
    if scene.unconstrained:
        return Space(positive, rest, (rest, *still), region, obligations)
    closing = [scene.plain(c.expression, c.name) for c in scene.constraints if c.holonomic]
    kept = dict(builder.obligations)
    zero = tuple(node.number for node in read(builder, [*closing, *scene.norms]))
    builder.obligations = kept
    on_constraints = partial(_projected, scene, _dependent(truth.kinematics))
    references = (rest, _start(scene, rest), *still)
    return Space(positive, rest, references, region, obligations, zero, on_constraints)


def _still(rest: Mapping[str, Fraction], values: Mapping[str, Expr]) -> State:
    """A declared equilibrium: what is no rational, as pi, by its enclosure."""
    builder = Builder()
    nodes = read(builder, [exact(value) for value in values.values()])
    balls = enclose(builder.program({"values": nodes}), {}, BITS)["values"]
    numbers = (
        n.constant if n.constant is not None else b for n, b in zip(nodes, balls, strict=True)
    )
    return {**rest, **dict(zip(values, numbers, strict=True))}


def _start(scene: Scene, rest: Mapping[str, Fraction]) -> Mapping[str, Fraction]:
    """The state in which a motion of the scene starts; constraints give what depends."""
    return {**rest, **{name: Fraction(str(value)) for name, value in scene.example.items()}}


def _dependent(kinematics: Kinematics) -> Program:
    """What the constraints determine, and under `POSITIVE` what has to be positive."""
    mechanism = kinematics.mechanism
    signs = ranges(mechanism)
    values = with_both_roots(mechanism.builder, mechanism.closure, signs).values
    outputs = {name_of(old): [new] for old, new in values.items()}
    positive = [new[0] for name, new in outputs.items() if signs.get(name) is Range.POSITIVE]
    return mechanism.builder.program({**outputs, POSITIVE: positive})


def _projected(scene: Scene, dependent: Program, state: State) -> State | None:
    """A state on the constraints, whose dependent quantities follow from the others."""
    given = {s.name: state[s.name] for s in (*scene.parameters, *scene.q, *scene.u)}
    # Both signs of a root are tried, by what is drawn anyway.
    sense = 1 if sum(v.numerator for v in state.values() if isinstance(v, Fraction)) % 2 else -1
    given |= {name: Fraction(sense) for name in dependent.inputs if name not in given}
    for rotation in scene.rotations:
        # What is outside the sphere comes inside; a state on it stays where it is.
        names = {plain_symbol(q).name for q in rotation.coordinates} - dependent.outputs.keys()
        square = sum(given[name] ** 2 for name in names)
        if not square <= 1:
            given |= {name: given[name] / (1 + square) for name in names}
    values = dict(enclose(dependent, given, BITS))
    # No such state, or none that is told at these digits.
    if not all(value > 0 for value in values.pop(POSITIVE)):
        return None
    solved = {name: value for name, (value,) in values.items()}
    if not all(value.is_finite() for value in solved.values()):
        return None
    return {**state, **solved}


def _typical(symbol: Symbol | None, *, positive: bool) -> Fraction:
    typical = getattr(symbol, "typical", None)
    if typical is not None:
        return Fraction(typical)
    return Fraction(int(positive))


def _of_truth(
    truth: Equations, builder: Builder, fixed: Mapping[Symbol, Expr]
) -> tuple[Obligation, ...]:
    """Obligations of loads and geometry, and that the mass matrix is regular."""
    scene = truth.scene
    typed = [_plain(scene, expression, fixed) for _, expression in scene.typed]
    demands = [demand for expression in typed for demand in within(expression)]
    for demand in dict.fromkeys(demands):
        operands = read(builder, demand.operands)
        conditions = read(builder, [c for c, _ in demand.conditions])
        answers = [answer for _, answer in demand.conditions]
        _ask(builder, demand, operands, list(zip(conditions, answers, strict=True)))
    found = tuple(builder.obligations)
    if scene.constraints or len(scene.u) > LARGEST_DETERMINANT:
        return found
    mass = truth.kinematics.mass_matrix
    entries = read(builder, [_plain(scene, entry, fixed) for entry in mass])
    n = mass.rows
    rows = [entries[n * i : n * (i + 1)] for i in range(n)]
    determinant = _determinant(rows)
    if determinant.constant is not None:
        return found
    return (*found, Obligation(Sign.NONZERO, determinant.number, "solve"))


def _determinant(rows: Sequence[Sequence[Node]]) -> Node:
    """By minors of the last rows, each of which is made once."""
    n = len(rows)
    builder = rows[0][0].builder
    minors: dict[tuple[int, ...], Node] = {(): builder.one}
    for row in reversed(rows):
        size = len(next(iter(minors))) + 1
        larger: dict[tuple[int, ...], Node] = {}
        for columns, minor in minors.items():
            for column in range(n):
                if column in columns:
                    continue
                chosen = tuple(sorted((*columns, column)))
                sign = -1 if chosen.index(column) % 2 else 1
                term = row[column] * minor * sign
                larger[chosen] = larger[chosen] + term if chosen in larger else term
        minors = {columns: minor for columns, minor in larger.items() if len(columns) == size}
    return minors[tuple(range(n))]


# ---------------------------------------------------------------------- in words


def _told(finding: Finding, left: Sequence[Gap], written: Written, code: bool) -> Finding:
    """The verdict of what is left, the worst first.

    An error that code raises itself says where the author means it: it is named, and refutes only
    where a motion has to begin.
    """
    raised = [gap for gap in left if gap.obligation.operation == RAISED and not _refutes(gap)]
    left = [gap for gap in left if gap not in raised]
    for test, tell in (
        (_refutes, _refuted), (_unknown, _undecided), (_open, _restricted),
    ):  # fmt: skip
        if worst := [gap for gap in left if test(gap)]:
            return tell(finding, worst, written)
    at_rest = [gap for gap in left if gap.at_rest]
    if code and at_rest:
        words = _listed([_excluded(written.origin[gap.obligation]) for gap in at_rest], " or ")
        advice = "its formulas are right elsewhere: give the value there a branch of its own"
        return undecided(finding.subject, advice, f"NOT SHOWN: NaN at rest ({words})")
    left = [*left, *raised]
    if not left:
        return finding
    words = _listed([_excluded(written.origin[gap.obligation]) for gap in left], " or ")
    before = f"{finding.domain}, " if finding.domain else ""
    return replace(finding, domain=f"{before}except where {words}")


def _refutes(gap: Gap) -> bool:
    if gap.kind is Kind.NOWHERE:
        return True
    return gap.kind is Kind.OPEN and (gap.at_rest or gap.region)


def _unknown(gap: Gap) -> bool:
    return gap.kind is Kind.UNKNOWN


def _open(gap: Gap) -> bool:
    return gap.kind is Kind.OPEN


def _refuted(finding: Finding, left: Sequence[Gap], written: Written) -> Finding:
    gap = left[0]
    demand = written.origin[gap.obligation]
    where = "at any state" if gap.kind is Kind.NOWHERE else f"at {_state(gap, written)}"
    words = f"{_operation(demand)} has no real value {where}, where the motion has one"
    return undefined(finding.subject, words, gap)


def _never(finding: Finding, demand: Demand) -> Finding:
    """What has a value nowhere, as it stands, divides by zero."""
    builder = Builder()
    builder.demand(Sign.NONZERO, 0, demand.operation)
    (gap,) = gaps(builder, tuple(builder.obligations), Space(frozenset(), {}, ()))
    return _refuted(finding, [gap], Written(builder, {gap.obligation: demand}))


def _undecided(finding: Finding, left: Sequence[Gap], written: Written) -> Finding:
    words = _listed([_needed(written.origin[gap.obligation]) for gap in left], " and ")
    doubt = f"right where it has a value, but it is not known whether {words}"
    return undecided(finding.subject, doubt)


def _restricted(finding: Finding, left: Sequence[Gap], written: Written) -> Finding:
    needed = [_needed(written.origin[gap.obligation], gap.branch) for gap in left]
    words = _listed(needed, " and ")
    advice = f"undefined at {_state(left[0], written)}; declare it, or --where '{needed[0]}'"
    return undecided(finding.subject, advice, f"{finding.verdict.name} WHERE {words}")


def _listed(words: Sequence[str], between: str) -> str:
    different = list(dict.fromkeys(words))
    more = f"{between}{len(different) - MOST_TOLD} more" if len(different) > MOST_TOLD else ""
    return between.join(different[:MOST_TOLD]) + more


def _state(gap: Gap, written: Written) -> str:
    """The symbols of a state that the operation holds."""
    demand = written.origin[gap.obligation]
    held = {s.name for e in demand.operands for s in e.free_symbols}
    held |= {s.name for c, _ in demand.conditions for s in c.free_symbols}
    names = [
        (name, value.str(5, radius=False) if isinstance(value, arb) else value)
        for name, value in gap.state if name in held
    ]  # fmt: skip
    return ", ".join(f"{name} = {value}" for name, value in names) or "every state"


def _operation(demand: Demand) -> str:
    """The operation as a person writes it."""
    if not demand.operands:
        return demand.operation
    x = demand.operands[0]
    match demand.operation:
        case "divide":
            return f"a division by {demand.operands[1]}"
        case "power":
            return f"({x})**({demand.operands[1]})"
    return f"{demand.operation}({', '.join(map(str, demand.operands))})"


def _bare(expression: Expr) -> Expr:
    """Without a positive number in front."""
    number, rest = expression.as_coeff_Mul()
    return rest if number.is_positive else expression


WORDS = {
    "divide": ("{y} != 0", "{y} = 0"), "tan": ("cos({whole}) != 0", "cos({whole}) = 0"),
    "sqrt": ("{x} >= 0", "{x} = 0"), "log": ("{x} > 0", "{x} = 0"),
    **dict.fromkeys(("asin", "acos"), ("-1 <= {whole} <= 1", "{x} = 0")),
    "acosh": ("{whole} >= 1", "{x} = 0"),
    "atanh": ("-1 < {whole} < 1", "{whole} = 1 or {whole} = -1"),
    "atan2": ("{all} has a value", "{x} = {second} = 0"),
}  # fmt: skip
"""Where an operation has a value, and the thin set where it has none."""


def _said(demand: Demand, thin: bool) -> str:
    whole, *others = demand.operands
    second = others[0] if others else whole
    least = demand.operation == "power" and second.is_Rational and second > 0
    kind = "sqrt" if least else "log" if demand.operation == "power" else demand.operation
    words = WORDS.get(kind, ("{all} has a value", "{x} = 0"))[thin]
    return words.format(
        x=_bare(whole), y=_bare(second), whole=whole, second=second, all=_operation(demand)
    )


def _needed(demand: Demand, branch: bool = False) -> str:
    """Where an operation has a value; outside of its branch, if it has none in it."""
    if demand.nowhere or (branch and demand.conditions):
        return " or ".join(_condition(c, not answer) for c, answer in demand.conditions)
    return _said(demand, thin=False)


def _condition(condition: Basic, answer: bool) -> str:
    """A comparison or what denies it, as a person writes it: the rest on the right."""
    there = (condition if answer else Not(condition)).to_nnf()
    if isinstance(there, And | Or):
        between = " and " if isinstance(there, And) else " or "
        return between.join(_condition(part, True) for part in there.args)
    if not isinstance(there, Relational):
        return str(there)
    number, rest = (there.lhs - there.rhs).as_coeff_Add()
    if number > 0 and rest.could_extract_minus_sign():
        there, rest, number = there.reversedsign, -rest, -number
    sign = {"==": "=", "!=": "!="}.get(there.rel_op, there.rel_op)
    return f"{rest} {sign} {-number}"


def _excluded(demand: Demand) -> str:
    """The thin set where an operation has none."""
    if demand.nowhere:
        return " and ".join(_condition(*pair) for pair in demand.conditions)
    return _said(demand, thin=True)
