"""Where conditions hold: symbols in terms of positive ones.

theta > 1        theta = 1 + s, s > 0        u = 0        u = 0
"""

from sympy import Dummy, Expr, S, Symbol, oo
from sympy.core.relational import Eq, Relational

from mechanics.errors import ExpressionError
from mechanics.judge.case_states import Region
from mechanics.kernel.field import Inadmissible
from mechanics.symbolic import collect_linear


def region_of(conditions: tuple[Relational, ...]) -> Region | None:
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


def slice_of(equal: list[Eq], others: tuple[Relational, ...]) -> Region | None:
    """Symbols where equations hold, as `region_of`; None where none are found.

    Raises
    ------
    Inadmissible
        When no state meets the conditions.
    """
    fixed: Region = {}
    for condition in equal:
        rest = (condition.lhs - condition.rhs).xreplace(fixed)
        found = _root(rest)
        if found is None:
            return None
        symbol, value = found
        fixed = {s: e.xreplace({symbol: value}) for s, e in fixed.items()} | {symbol: value}
    left = [condition.xreplace(fixed) for condition in others]
    if any(condition == S.false for condition in left):
        raise Inadmissible("no state meets the conditions")
    region = region_of(tuple(condition for condition in left if condition != S.true))
    if region is None:
        return None
    return region | {symbol: value.xreplace(region) for symbol, value in fixed.items()}


def _root(rest: Expr) -> tuple[Symbol, Expr] | None:
    """A symbol that makes an expression zero, and its value."""
    for symbol in sorted(rest.free_symbols, key=str):
        if isinstance(symbol, Dummy) or symbol.is_positive:
            continue
        try:
            (slope,), other = collect_linear(rest, (symbol,))
        except ExpressionError:
            continue
        if slope.is_number and slope != 0:
            return symbol, -other / slope
    return None


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
        if slope != 0 and (slope.is_number or slope.is_positive or slope.is_negative):
            more = Dummy(f"beyond_{symbol}", positive=True)
            return symbol, (more - rest) / slope
    return None
