"""A side that is told by cases: each case where its condition holds.

    if q > 1: ...        q = 1 + s, s > 0        and the typed formula of that case

A case of a function that is hardly ever entered would not be met by random states.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace

from sympy import Dummy, Expr, Piecewise, Rational, S, Symbol, preorder_traversal
from sympy.core.relational import Ge, Gt, Le, Lt, Relational
from sympy.logic.boolalg import And, Boolean, Not

from mechanics.checks.ledger_compare import settle_defined
from mechanics.checks.ledger_motion import put_motion
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic, Finding, Verdict, Witness, collect_linear, decide
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, Identity

Pairs = list[tuple]
Region = dict[Symbol, Expr]


def check_cases(truth: Equations, row: Published) -> Finding | None:
    """The finding of a row with cases, from its cases one by one; None where that is no help.

    Parameters
    ----------
    truth : Equations
    row : Published
        About an equation of motion, in a scene without constraints.
    """
    kinds = (EquationOfMotion, Identity)
    if truth.scene.constraints or not isinstance(row.quantity, kinds):
        return None
    if not any(side.has(Piecewise) for side in row.sides):
        return None
    findings = []
    for conditions, sides in _cases(row.sides, ()):
        region = _region(conditions)
        if region is None:
            return None
        case = replace(row, sides=sides)
        finding = decide(f"{row.tag} {row.label}", _in_region(truth, case, region))
        if not finding.shown:
            words = " and ".join(str(condition) for condition in conditions)
            witness = None if finding.witness is None else _of_scene(finding.witness, region)
            evidence = f"{finding.evidence}, where {words}"
            return replace(finding, evidence=evidence, witness=witness)
        findings.append(finding)
    worst = [f for f in findings if f.verdict is Verdict.CERTIFIED] or findings
    bound = max((f.error_bound or 0.0 for f in worst), default=0.0)
    words = f"{worst[0].evidence}, in each of {len(findings)} cases"
    return replace(worst[0], evidence=words, error_bound=bound or None)


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


def _region(conditions: tuple[Boolean, ...]) -> Region | None:
    """Symbols in terms of positive ones such that conditions hold; None where none are found.

    Each condition has to be linear in a symbol that the ones before leave free.
    """
    region: Region = {}
    for condition in conditions:
        parts = condition.args if isinstance(condition, And) else (condition,)
        for part in parts:
            if not isinstance(part, Relational) or not isinstance(part, Gt | Ge | Lt | Le):
                return None
            rest = (part.gts - part.lts).xreplace(region)
            solved = _solved(rest, region)
            if solved is None:
                return None
            symbol, value = solved
            region = {s: e.xreplace({symbol: value}) for s, e in region.items()}
            region[symbol] = value
    return region


def _solved(positive: Expr, region: Region) -> tuple[Symbol, Expr] | None:
    """A symbol that makes an expression equal to a positive one."""
    for symbol in sorted(positive.free_symbols - region.keys(), key=str):
        if isinstance(symbol, Dummy) or symbol.is_positive:
            continue
        try:
            (slope,), rest = collect_linear(positive, (symbol,))
        except ExpressionError:
            continue
        if slope.is_number and slope != 0:
            more = Dummy(f"beyond_{symbol}", positive=True)
            return symbol, (more - rest) / slope
    return None


def _of_scene(witness: Witness, region: Region) -> Witness:
    """The witness in the symbols of the scene: none tells how far beyond a boundary it is."""
    drawn = {name: Rational(value) for name, value in witness.state}
    solved = dict(witness.solved)
    state = dict(witness.state)
    for symbol, value in region.items():
        known = {s: drawn[str(s)] for s in value.free_symbols if str(s) in drawn}
        exact = value.xreplace(known)
        rounded = solved.pop(symbol.name)
        state[symbol.name] = str(exact) if exact.is_Rational else rounded
        for more in value.atoms(Dummy):
            state.pop(str(more), None)
    return replace(witness, state=tuple(sorted(state.items())), solved=tuple(solved.items()))


def _in_region(truth: Equations, row: Published, region: Region) -> Callable[[Arithmetic], Pairs]:
    def experiment(a: Arithmetic) -> Pairs:
        for symbol, value in region.items():
            a.assign(symbol, a.value(value))
        settle_defined(truth.scene, a)
        put_motion(a, truth)
        first, *others = row.sides
        return [(a.value(first), a.value(side)) for side in others]

    return experiment
