"""A side that is told by cases: each case where its condition holds.

    if q > 1: ...        q = 1 + s, s > 0        and the typed formula of that case

A case of a function that is hardly ever entered would not be met by random states.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from sympy import (
    Abs,
    Dummy,
    Expr,
    Piecewise,
    Rational,
    S,
    Symbol,
    default_sort_key,
    preorder_traversal,
)
from sympy.core.relational import Eq, Ge, Gt, Le, Lt, Ne, Relational
from sympy.logic.boolalg import And, Boolean, Not, Or

from mechanics.checks.ledger_compare import define
from mechanics.checks.ledger_motion import put_motion
from mechanics.checks.manifold import restrict
from mechanics.claims.demands import Demand
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.judge.case_states import Region, entered
from mechanics.judge.guards import inside, is_guard
from mechanics.judge.regions import region_of, slice_of
from mechanics.kernel import Finding, Verdict, Witness, follows, refuted, undecided
from mechanics.kernel.definedness import excludes
from mechanics.kernel.field import Inadmissible
from mechanics.program import Builder
from mechanics.program.sympy_reader import read
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, Identity
from mechanics.symbolic import Arithmetic, Number, decide
from mechanics.symbolic.arithmetic import Experiment

MOST = 64
"""Alternatives of the conditions of one case."""


def has_guard(row: Published, demands: Sequence[Demand]) -> bool:
    """Whether a row has a case within a small guard."""
    conditions = {c for side in row.sides for p in side.atoms(Piecewise) for _, c in p.args}
    relations = {r for c in conditions for r in c.atoms(Relational)}
    return any(is_guard(s, demands) for r in relations for s in (r, Not(r)))


def has_parts(truth: Equations, row: Published) -> bool:
    """Whether a row is told by cases that can be looked at one by one."""
    if not truth.scene.unconstrained or not isinstance(row.quantity, EquationOfMotion | Identity):
        return False
    return any(side.has(Piecewise) for side in row.sides)


def check_cases(truth: Equations, row: Published, demands: Sequence[Demand] = ()) -> Finding | None:
    """The finding of a row with cases, from its cases one by one; None where that is no help.

    Parameters
    ----------
    row : Published
        About an equation of motion, in a scene without constraints.
    demands : sequence of Demand
        What it asks for; within a small guard of that it has to be near the truth only.
    """
    if not has_parts(truth, row):
        return None
    findings: list[Finding] = []
    open_ones: list[Finding] = []
    near: list[str] = []
    singular: list[str] = []
    for conditions, sides in parts_of(row):
        if conditions is None:
            return None
        if guard := [c for c in conditions if is_guard(c, demands)]:
            experiment = in_region(truth, replace(row, sides=sides), {})
            found = inside(truth, conditions, experiment)
            where = " and ".join(map(in_words, guard))
            if found.apart is not None:
                words = f"within its guard {where} the value is far from the truth"
                far = found.apart
                return refuted(f"{row.tag} {row.label}", words, far.near, far.value, far.state)
            if found.states or found.singular:
                (singular if found.singular else near).append(where)
                continue
        try:
            finding = in_case(truth, replace(row, sides=sides), conditions)
        except Inadmissible:
            continue
        words = " and ".join(map(in_words, conditions))
        if finding.verdict is Verdict.REFUTED:
            return replace(finding, evidence=f"{finding.evidence}, where {words}")
        if finding.shown:
            findings.append(finding)
        else:
            open_ones.append(
                replace(finding, evidence=f"{finding.evidence}: not shown where {words}")
            )
    if open_ones or not findings:
        return open_ones[0] if open_ones else None
    worst = [f for f in findings if f.verdict is Verdict.CERTIFIED] or findings
    words = f"{worst[0].evidence}, in each of {len(findings)} cases"
    if near:
        words += f"; within 1e-9 of the truth at the states that were tried where {near[0]}"
    domain = f"except where {singular[0]}" if singular else ""
    return replace(follows(worst[0].subject, findings), evidence=words, domain=domain)


def with_case(truth: Equations, row: Published, finding: Finding) -> Finding:
    """A refuted row's finding, with the conditions of the case that its witness is in."""
    if finding.verdict is not Verdict.REFUTED or not finding.witness or not has_parts(truth, row):
        return finding
    for conditions, _ in parts_of(row):
        if conditions and meets(finding.witness, conditions):
            words = " and ".join(map(in_words, conditions))
            return replace(finding, evidence=f"{finding.evidence}, where {words}")
    return finding


def meets(witness: Witness, conditions: Sequence[Relational]) -> bool:
    """Whether conditions hold at the state of a witness; False where nobody can tell."""
    values = {**dict(witness.solved), **dict(witness.state)}
    symbols: set[Symbol] = set().union(*(c.free_symbols for c in conditions))
    table = {s: Rational(values[s.name]) for s in symbols if s.name in values}
    return all(condition.xreplace(table) == S.true for condition in conditions)


def in_words(condition: Relational) -> str:
    """A condition as people write it."""
    signs = {Eq: "=", Ne: "!="}
    sign = signs.get(type(condition))
    return f"{condition.lhs} {sign} {condition.rhs}" if sign else str(condition)


def in_case(truth: Equations, row: Published, conditions: tuple[Relational, ...]) -> Finding:
    """The finding of a case where its conditions hold.

    Where no symbols are found that make them hold, the case may be right everywhere, or wrong at a
    state that happens to enter it.

    Parameters
    ----------
    truth : Equations
        Of a scene without constraints.
    row : Published
        About an equation of motion, or an identity.

    Raises
    ------
    Inadmissible
        When no state meets the conditions, but for boundaries.
    """
    subject = f"{row.tag} {row.label}"
    equal = [condition for condition in conditions if isinstance(condition, Eq)]
    others = tuple(c for c in conditions if not isinstance(c, Eq | Ne))
    region = region_of(others) if not equal else slice_of(equal, others)
    # What the motion determines cannot be chosen so that conditions hold.
    solved = {*truth.unknowns, *(symbol for symbol, _ in truth.reactions)}
    if region is not None and not solved & region.keys():
        finding = decide(subject, in_region(truth, row, region))
        if finding.verdict is Verdict.REFUTED and equal:
            # What differs at single states only may be meant to be another limit.
            return undecided(subject, "it differs at isolated states")
        witness = None if finding.witness is None else _of_scene(finding.witness, region)
        return replace(finding, witness=witness)
    if _is_empty(conditions):
        raise Inadmissible("no state meets the conditions")
    everywhere = decide(subject, in_region(truth, row, {}))
    if everywhere.shown or equal:
        return everywhere if everywhere.shown else undecided(subject, "not right everywhere")
    for point in entered(conditions):
        finding = decide(subject, in_region(truth, row, point))
        if finding.verdict is Verdict.REFUTED and finding.witness is not None:
            return replace(finding, witness=_of_scene(finding.witness, point))
    return undecided(
        subject,
        "neither proved where the conditions hold nor refuted at the states that were tried",
    )


def _is_empty(conditions: tuple[Relational, ...]) -> bool:
    """Whether no state meets the conditions, as far as signs tell: sin(theta) > 1."""
    builder = Builder()
    try:
        nodes = read(builder, conditions)
    except ExpressionError:
        return False
    positive = {s.name for c in conditions for s in c.free_symbols if s.is_positive}
    truths = [(node.number, True) for node in nodes if node.constant is None]
    falsehood = any(node.is_zero for node in nodes)
    return falsehood or excludes(builder, truths, frozenset(positive))


def _cases(
    sides: tuple[Expr, ...], known: tuple[Boolean, ...]
) -> Iterator[tuple[tuple[Boolean, ...], tuple[Expr, ...]]]:
    """Sides without cases, each with the conditions under which they hold, the outermost first."""
    nodes = (node for side in sides for node in preorder_traversal(side))
    found = next((node for node in nodes if isinstance(node, Piecewise)), None)
    if found is None:
        yield known, sides
        return
    before: tuple[Boolean, ...] = ()
    for value, condition in found.args:
        here = before if condition == S.true else (*before, condition)
        table = {found: value}
        yield from _cases(tuple(side.xreplace(table) for side in sides), (*known, *here))
        before = (*before, Not(condition))


def parts_of(row: Published) -> Iterator[tuple[tuple[Relational, ...] | None, tuple[Expr, ...]]]:
    """Cases of a row with inequalities as their conditions; None for conditions of other kinds."""
    for conditions, sides in _cases(row.sides, ()):
        some = _split(conditions)
        for one in some if some is not None else (None,):
            yield one, sides


def _split(conditions: tuple[Boolean, ...]) -> list[tuple[Relational, ...]] | None:
    """Conditions as alternatives of inequalities; None for others, or for too many."""
    found: list[tuple[Relational, ...]] = [()]
    for condition in conditions:
        some = _alternatives(condition)
        if some is None or len(found) * len(some) > MOST:
            return None
        found = [(*known, *more) for known in found for more in some]
    return found


def _alternatives(condition: Boolean) -> list[tuple[Relational, ...]] | None:
    """One condition as alternatives: |q| > 1 is q > 1 or -q > 1, |q| < 1 both q < 1 and -q < 1."""
    if isinstance(condition, And):
        return _split(condition.args)
    if isinstance(condition, Or):
        some = [_alternatives(part) for part in condition.args]
        return None if None in some else [one for more in some for one in more or ()]
    if isinstance(condition, Eq | Ne):
        return [(condition,)]
    if not isinstance(condition, Gt | Ge | Lt | Le):
        return None
    moduli = [m for m in (condition.gts - condition.lts).atoms(Abs) if not m.args[0].has(Abs)]
    if not moduli:
        return [(condition,)]
    modulus = min(moduli, key=default_sort_key)
    inside = modulus.args[0]
    halves = [
        (positive, condition.xreplace({modulus: value}))
        for positive, value in ((inside >= 0, inside), (inside <= 0, -inside))
    ]
    some = [_split(half) for half in halves]
    return None if None in some else [one for more in some for one in more or ()]


def _of_scene(witness: Witness, region: Region) -> Witness:
    """The witness in the symbols of the scene: none tells how far beyond a boundary it is."""
    drawn = {name: Rational(value) for name, value in witness.state}
    solved = dict(witness.solved)
    state = dict(witness.state)
    for symbol, value in region.items():
        known = {s: drawn[s.name] for s in value.free_symbols if s.name in drawn}
        exact = value.xreplace(known)
        rounded = solved.pop(symbol.name)
        state[symbol.name] = str(exact) if exact.is_Rational else rounded
        for more in value.atoms(Dummy):
            state.pop(more.name, None)
    return replace(witness, state=tuple(sorted(state.items())), solved=tuple(solved.items()))


def in_region(truth: Equations, row: Published, region: Region) -> Experiment:
    """A row about the motion, its symbols in terms of others."""

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        for symbol, value in region.items():
            a.assign(symbol, a.value(value))
        define(a, truth.scene)
        restrict(a, truth.kinematics)
        put_motion(a, truth)
        first, *others = row.sides
        return [(a.value(first), a.value(side)) for side in others]

    return experiment
