"""A side that is told by cases: each case where its condition holds.

    if q > 1: ...        q = 1 + s, s > 0        and the typed formula of that case

A case of a function that is hardly ever entered would not be met by random states.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace

from sympy import Abs, Dummy, Expr, Piecewise, Rational, S, Symbol, oo, preorder_traversal
from sympy.core.relational import Ge, Gt, Le, Lt, Relational
from sympy.logic.boolalg import And, Boolean, Not, Or

from mechanics.checks.ledger_compare import settle_defined
from mechanics.checks.ledger_motion import put_motion
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.exact import (
    Arithmetic,
    Finding,
    Inadmissible,
    Verdict,
    Witness,
    collect_linear,
    decide,
)
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, Identity

Pairs = list[tuple]
Region = dict[Symbol, Expr]

MOST = 64
"""Alternatives of the conditions of one case."""


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
    for conditions, sides in _parts(row):
        if conditions is None:
            return None
        try:
            region = _region(conditions)
        except Inadmissible:
            continue
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
    if not findings:
        return None
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


def _parts(row: Published) -> Iterator[tuple[tuple[Relational, ...] | None, tuple[Expr, ...]]]:
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
    if not isinstance(condition, Gt | Ge | Lt | Le):
        return None
    moduli = [m for m in (condition.gts - condition.lts).atoms(Abs) if not m.args[0].has(Abs)]
    if not moduli:
        return [(condition,)]
    modulus = moduli[0]
    inside = modulus.args[0]
    halves = [
        (positive, condition.xreplace({modulus: value}))
        for positive, value in ((inside >= 0, inside), (inside <= 0, -inside))
    ]
    some = [_split(half) for half in halves]
    return None if None in some else [one for more in some for one in more or ()]


def _region(conditions: tuple[Relational, ...]) -> Region | None:
    """Symbols in terms of positive ones such that conditions hold; None where none are found.

    A symbol between numbers a < b is (a + b s)/(1 + s). Any other condition has to be linear in a
    symbol that the ones before leave free.

    Raises
    ------
    Inadmissible
        When no state meets the conditions, but for boundaries.
    """
    bounds: dict[Symbol, tuple[Expr, Expr]] = {}
    others: list[Relational] = []
    for condition in conditions:
        bound = _bound(condition)
        if bound is None:
            others.append(condition)
            continue
        symbol, low, high = bound
        lowest, highest = bounds.get(symbol, (-oo, oo))
        bounds[symbol] = low, high = max(low, lowest), min(high, highest)
        own = [c for c in conditions if c.free_symbols == {symbol}]
        if low == high and all(c.xreplace({symbol: low}) == S.true for c in own):
            return None  # one point only, which no random state is
        if low >= high:
            raise Inadmissible("no state meets the conditions")
    region = {symbol: _between(symbol, *bound) for symbol, bound in bounds.items()}
    for condition in others:
        rest = (condition.gts - condition.lts).xreplace(region)
        solved = _solved(rest, region)
        if solved is None:
            return None
        symbol, value = solved
        region = {s: e.xreplace({symbol: value}) for s, e in region.items()}
        region[symbol] = value
    return region


def _bound(condition: Relational) -> tuple[Symbol, Expr, Expr] | None:
    """A condition on one symbol that may have any sign: between which numbers it is."""
    positive = condition.gts - condition.lts
    symbols = positive.free_symbols
    if len(symbols) != 1 or any(s.is_positive or isinstance(s, Dummy) for s in symbols):
        return None
    (symbol,) = symbols
    try:
        (slope,), rest = collect_linear(positive, (symbol,))
    except ExpressionError:
        return None
    if not (slope.is_Rational and rest.is_Rational and slope != 0):
        return None
    bound = -rest / slope
    return (symbol, bound, oo) if slope > 0 else (symbol, -oo, bound)


def _between(symbol: Symbol, low: Expr, high: Expr) -> Expr:
    more = Dummy(f"beyond_{symbol}", positive=True)
    if high == oo:
        return low + more
    if low == -oo:
        return high - more
    return (low + high * more) / (1 + more)


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
