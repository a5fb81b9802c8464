"""What nobody said: where a refutation rests on a guess, all other ways to guess are tried.

    the guess                                    the other ways
    p is the only momentum                       p is an input
    p_theta is counted in kg m^2/s               in what m l^2 theta' is one of
    y[1], y[2] are theta1, theta2, in order      coordinates of one kind in another order
    u is the vector of inputs, in order          in another order
    M is m, the same first letter                what else is left of that unit
    f returns accelerations, f takes no speeds   there is no list of them

Where the ways cannot be listed a wrong statement is open, too. A statement is REFUTED only where
somebody said how it is to be read, where the names leave no choice, or where every other way
refutes it as well. What has no other way is no guess: it makes no entry here.

Readers say what they guessed in `Match.why`, or, where no name of the scene stands for it, in
`Statement.unsure`.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice, permutations, product

from sympy import Expr, Symbol

from mechanics.claims.assemble import used_names
from mechanics.claims.code.arguments import GUESSED_ORDER, USUAL
from mechanics.claims.guess import ONLY_MOMENTUM, TWIN
from mechanics.claims.kinds import angular
from mechanics.claims.names import Match
from mechanics.claims.spelled_rates import key
from mechanics.claims.statement import Reading, Statement
from mechanics.claims.text.elements import BY_KIND, WHY
from mechanics.compiled.fixed import fix
from mechanics.equations import Equations
from mechanics.judge.at_values import Values, put
from mechanics.judge.convention_filter import Table, may_hold
from mechanics.judge.converted_rows import each_side, in_plain_symbols
from mechanics.judge.other_names import other_choices
from mechanics.judge.other_reading import OtherReading, is_wrong
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene
from mechanics.scene.momenta import momentum_symbols, rate_symbol
from mechanics.scene.published import Published
from mechanics.scene.symbols import DOTS

MOST = 60
"""Ways that are tried for one guess; with more of them it is open."""


@dataclass(frozen=True)
class Guess:
    """What nobody said, and the other ways.

    Attributes
    ----------
    words : str
        What would be otherwise.
    ways : tuple of (str, Table), or None
        Each in words, and what the scene's symbols then stand for; None where there is no list.
    opens : bool
        Whether it leaves a refutation open where its ways are not tried.
    of : str
        The name that it is about; statements without it do not rest on it. Empty for all of them.
    """

    words: str
    ways: tuple[tuple[str, Table], ...] | None = None
    opens: bool = False
    of: str = ""


def other_guesses(
    truth: Equations, judged: Sequence[Judged], readings: Sequence[Reading],
    statements: Sequence[Statement], values: Values, tries: bool,
) -> Iterator[OtherReading]:  # fmt: skip
    """Other ways to guess that may make a refuted statement right, and leave all right ones so.

    Parameters
    ----------
    readings : sequence of Reading
        That the entries are of, in order.
    statements : sequence of Statement
        Those of the entries as they were read.
    values : mapping of Symbol to Expr
        Of parameters, where these are given.
    tries : bool
        Whether other ways can be tried: statements are judged as the scene counts, everywhere.
    """
    start = 0
    trial = _Trial(fix(truth, values) if values and tries else truth, values)
    for reading in readings:
        group = range(start, start + len(reading.statements))
        start = group.stop
        claimed = [k for k in group if (s := judged[k].statement).row is not None and not s.doubt]
        wrong = [k for k in claimed if is_wrong(judged[k]) and not judged[k].open]
        if not wrong:
            continue
        now = replace(reading, statements=tuple(judged[k].statement for k in claimed))
        shared = [g for g in _guesses(truth, now) if tries or g.opens or g.ways is None]
        right = [_row(judged[k]) for k in claimed if judged[k].finding.shown]
        for k in wrong:
            words = list(judged[k].statement.unsure)
            held = used_names(judged[k].statement.written)
            rests = [g for g in shared if not g.of or key(g.of) in held]
            words += [g.words for g in rests if g.ways is None or not tries]
            statement = judged[k].statement
            left, row = None, statement.under_any_guess
            if row is not None:
                left = replace(statement, row=row, taken=(), ways={}, written=None)
            yield from (
                OtherReading(one, {k: left if one in statement.unsure else None}) for one in words
            )
            for guess in shared if tries and not words else ():
                for one, table in trial.living(_row(judged[k]), guess.ways or (), right):
                    yield OtherReading(one, {k: _meant(truth.scene, statements[k], table)})


@dataclass(frozen=True)
class _Trial:
    """Rows under other ways, in one point of a field."""

    target: Equations
    values: Values

    def living(
        self, row: Published, ways: Sequence[tuple[str, Table]], right: Sequence[Published]
    ) -> list[tuple[str, Table]]:
        """Ways under which a row may be right, and none of the right ones gets wrong."""
        some = zip(ways, self.possible(row, [table for _, table in ways]), strict=True)
        living = [way for way, may_be in some if may_be]
        return [
            (words, table) for words, table in living
            if all(self.possible(other, [table]) == [True] for other in right)
        ]  # fmt: skip

    def possible(self, row: Published, tables: Sequence[Table]) -> list[bool]:
        """Whether a row may be right under each table."""
        momenta = momentum_symbols(self.target.scene)
        names = {s.name for p in momenta for s in (p, rate_symbol(p))}
        if any(s.name in names for table in tables for s in table):
            # A momentum is written out before a look.
            return [may_hold(self.target, [self._there(row, t)], [{}]) == [True] for t in tables]
        return may_hold(self.target, [self._there(row, {})], tables) if tables else []

    def _there(self, row: Published, table: Table) -> Published:
        meant = _put(self.target.scene, row, table)
        return put(in_plain_symbols(self.target.kinematics, meant), self.values)


def _put(scene: Scene, row: Published, table: Table) -> Published:
    return each_side(row, lambda side: scene.plain(side).xreplace(dict(table)))


def _meant(scene: Scene, statement: Statement, table: Table) -> Statement:
    """A statement whose symbols stand for others."""
    row, letter = statement.row, statement.letter
    assert row is not None  # of what is claimed
    if letter is not None:
        sides = (scene.plain(side).xreplace(dict(table)) for side in letter.sides)
        letter = replace(letter, sides=tuple(sides))
    demands = statement.demands.put(table)
    return replace(statement, row=_put(scene, row, table), letter=letter, demands=demands)


def _row(entry: Judged) -> Published:
    assert entry.statement.row is not None  # of what is claimed
    return entry.statement.row


def _guesses(truth: Equations, reading: Reading) -> Iterator[Guess]:
    """All that a reading rests on and nobody said."""
    scene = truth.scene
    for match in reading.names:
        if match.why == ONLY_MOMENTUM:
            yield _input_for(scene, match)
        if match.why == TWIN:
            words = f"{match.name} is not {match.meaning}: --name {match.name}=..."
            yield Guess(words, of=match.name)
        if GUESSED_ORDER in match.why:
            yield _ordered(scene, match)
    yield from _scaled(scene, reading.names)
    coordinates = {q.name for q in scene.q}
    if any(
        match.why in (WHY, BY_KIND)
        or (match.why == USUAL and len(coordinates & {*match.meaning.split()}) > 1)
        for match in reading.names
    ):
        yield from _exchanged(scene)
    if others := _named(truth, reading):
        yield others


def _input_for(scene: Scene, match: Match) -> Guess:
    """``p(t)`` of the only momentum: an input that is left."""
    (momentum,) = (p for p in momentum_symbols(scene) if match.meaning.startswith(p.name))
    ways = tuple(
        (f"{match.name} is {u}: --name {match.name}={u}", {momentum: u})
        for u in scene.input_symbols
    )
    return Guess(f"{match.name} is no momentum", ways)


def _scaled(scene: Scene, matches: Sequence[Match]) -> Iterator[Guess]:
    """Momenta by their names: counted in those of a mass and lengths of the scene."""
    momenta = momentum_symbols(scene)
    held = {p for p in momenta if any(m.meaning.startswith(p.name) for m in matches)}
    if not held:
        return
    units = {p: getattr(p, "unit", "") for p in scene.parameters}
    masses = [p for p, unit in units.items() if unit == "kg"]
    arms = [p for p, unit in units.items() if unit == "m"]
    scales = [m * a**2 for m in masses for a in arms] + masses
    ways = tuple(
        (f"momenta are counted in {scale}",
         {s: s / scale for p in held for s in (p, rate_symbol(p))})
        for scale in scales[:MOST]
    )  # fmt: skip
    yield Guess("momenta have another unit", ways)


def _ordered(scene: Scene, match: Match) -> Guess:
    """A vector in an order that only the scene has."""
    words = f"{match.name} is in another order than {match.meaning}"
    symbols = _symbols(scene)
    entries = [symbols[name] for name in match.meaning.split() if name in symbols]
    orders = list(islice(permutations(entries), 1, MOST + 2))
    if len(entries) < len(match.meaning.split()) or len(orders) > MOST:
        return Guess(words)
    ways = tuple((_in_order(match.name, order), _pairs(entries, order)) for order in orders)
    return Guess(words, ways, opens=True)


def _in_order(name: str, order: Sequence[Expr]) -> str:
    meaning = " ".join(map(str, order))
    return f"{name} is {meaning}: --name '{name}={meaning}'"


def _exchanged(scene: Scene) -> Iterator[Guess]:
    """Coordinates of a state in an order that only the scene has: those of one kind exchanged."""
    turning = angular(scene)
    kinds = [[q for q in scene.q if (q in turning) is one] for one in (True, False)]
    if scene.speeds:
        return
    entries = [q for kind in kinds for q in kind]
    every = ([q for part in order for q in part] for order in product(*map(permutations, kinds)))
    orders = list(islice(every, 1, MOST + 2))
    words = "the state has its coordinates in another order"
    if len(orders) > MOST:
        yield Guess(words)
        return
    ways = tuple(
        (f"the state is in the order {' '.join(map(str, order))}", _pairs(entries, order))
        for order in orders
    )
    if ways:
        yield Guess(words, ways)


def _named(truth: Equations, reading: Reading) -> Guess | None:
    """Names that are matched by a guess: what else is left for them."""
    ways = tuple(islice(other_choices(truth, reading), MOST + 1))
    if not ways:
        return None
    return Guess("names are guessed", ways if len(ways) <= MOST else None)


def _symbols(scene: Scene) -> dict[str, Symbol]:
    return {s.name: s for s in (*scene.q, *scene.input_symbols, *scene.parameters)}


def _pairs(entries: Sequence[Symbol], order: Sequence[Symbol]) -> Table:
    """What entries stand for in another order, and their rates."""
    found: dict[Symbol, Expr] = dict(zip(entries, order, strict=True))
    for dots in DOTS[1:]:
        for one, other in zip(entries, order, strict=True):
            found[Symbol(one.name + dots, real=True)] = Symbol(other.name + dots, real=True)
    return found
