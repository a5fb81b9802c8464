"""What the name on the left of a statement means: one meaning for all that it is said to be.

T = m g cos(theta) + m l theta_dot^2    [T] = N    ->    no energy: T is read as the tension

Meanings without the dimension of what was written are dead. Of the others those of the first rank
count: what one of them proves is read so, and said. Those of later ranks are other readings
(`mechanics.judge.other_reading`): "right if T is the torque". What the scene itself calls so, in
the same dimension, or what the person says that it means, is nothing else.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice

from sympy import Add, Expr, Symbol, preorder_traversal

from mechanics.claims.about import ENERGY_NAMES, LETTERS, QUANTITIES
from mechanics.claims.convention import Table
from mechanics.claims.demands import Demands
from mechanics.claims.statement import NO_DEMANDS, Letter, Statement
from mechanics.compiled.dimensions import known_dimensions
from mechanics.equations import Equations
from mechanics.judge.meanings import NO_TABLE, UNITS, Candidate, candidates
from mechanics.judge.single import by_dimension, subject_of
from mechanics.kernel import Finding
from mechanics.scene.dimensions import MixedDimensions, dimension_of
from mechanics.scene.published import Published
from mechanics.scene.quantities import ReactionValue
from mechanics.scene.unit_names import Dimension, dimension_of_unit, words

OWN = "what the scene calls so"
FORCES = tuple(dimension_of_unit(unit, "") for unit in ("N", "N*m"))
"""Of reactions."""
MOMENTA = tuple(dimension_of_unit(unit, "") for unit in ("kg*m/s", "kg*m^2/s"))
"""Of momenta, those of angles among them."""

Shown = Callable[[Statement], bool]
Known = Mapping[Symbol, Dimension | None]


@dataclass(frozen=True)
class Settled:
    """A statement with one meaning.

    Attributes
    ----------
    finding : Finding or None
        Where its dimension alone refutes it.
    """

    statement: Statement
    finding: Finding | None = None


def settle(
    truth: Equations, statements: Sequence[Statement], shown: Shown, table: Table = NO_TABLE,
    dimensions: bool = True,
) -> list[Settled]:  # fmt: skip
    """Statements under one meaning of each name on the left.

    Parameters
    ----------
    shown : callable
        Whether a statement is right as it is judged.
    table : mapping of Symbol to Expr
        The person's coordinates in the scene's, where they count otherwise.
    dimensions : bool
        Whether dimensions tell: a number may stand for a parameter that has a value.
    """
    settled = [Settled(statement) for statement in statements]
    known = _known(truth, statements, dimensions)
    for places in _groups(statements):
        group = [statements[k] for k in places]
        for k, one in zip(places, _settled(truth, group, known, shown, table), strict=True):
            settled[k] = one
    return settled


def other_meanings(
    truth: Equations, statements: Sequence[Statement], dimensions: bool
) -> Iterator[tuple[str, dict[int, Statement]]]:
    """Meanings of later ranks of names on the left, in words, and their statements by places."""
    known = _known(truth, statements, dimensions)
    for places in _groups(statements):
        group = [statements[k] for k in places]
        letter = _letter(group[0])
        try:
            ranks = _living(truth, letter, _written(truth, group, known), known)
        except MixedDimensions:
            continue
        for meaning in (word for rank in ranks[1:] for word in rank):
            if any(True for _ in candidates(truth, meaning)):
                meant = [replace(s, letter=replace(_letter(s), said=meaning)) for s in group]
                words = f"{letter.name} is {_article(meaning)}: --name {letter.name}={meaning!r}"
                yield words, dict(zip(places, meant, strict=True))


def _groups(statements: Sequence[Statement]) -> list[list[int]]:
    """Places of the statements of each name on the left."""
    groups: dict[str, list[int]] = {}
    for k, statement in enumerate(statements):
        if statement.letter is not None and statement.row is not None:
            groups.setdefault(statement.letter.name, []).append(k)
    return list(groups.values())


def _known(truth: Equations, statements: Sequence[Statement], dimensions: bool) -> Known:
    """Dimensions of symbols, where names on the left ask for them."""
    return known_dimensions(truth) if dimensions and any(s.letter for s in statements) else {}


def _written(truth: Equations, group: Sequence[Statement], known: Known) -> Dimension | None:
    """The dimension of what a name is said to be; None where it is not known, or is several."""
    written = {_dimension(truth, _letter(s), known) for s in group} - {None}
    return written.pop() if len(written) == 1 else None


def _settled(
    truth: Equations, group: Sequence[Statement],
    known: Known, shown: Shown, table: Table,
) -> list[Settled]:  # fmt: skip
    letter = _letter(group[0])
    try:
        one = _written(truth, group, known)
    except MixedDimensions:
        meaning = _of_some_term(truth, letter, known)
        return [Settled(_first(truth, s, meaning, table)) for s in group]
    ranks = _living(truth, letter, one, known)
    if not ranks:
        return [_dead(truth, s, one) for s in group]
    for meaning in ranks[0]:
        for found, words_of in _trials(truth, group, meaning, table):
            if all(map(shown, found)):
                return [_noted(s, letter, words_of) for s in found]
    return [_unproved(truth, s, ranks[0][0], table) for s in group]


def meanings_of(statement: Statement) -> tuple[str, ...]:
    """All that the name on the left of a statement may mean."""
    letter = statement.letter
    if letter is None:
        return ()
    return (letter.said,) if letter.said else tuple(w for r in LETTERS[letter.name] for w in r)


def _letter(statement: Statement) -> Letter:
    assert statement.letter is not None  # of a group
    return statement.letter


def _dimension(truth: Equations, letter: Letter, known: Known) -> Dimension | None:
    """Of all sides that a letter is said to be."""
    scene = truth.scene
    sides = [scene.plain(side) for side in letter.sides]
    found = {dimension_of(scene, side, known) for side in sides} - {None}
    return found.pop() if len(found) == 1 else None


def has_meaning(truth: Equations, letter: Letter, known: Known) -> bool:
    """Whether a name on the left can mean something of the dimension of what was written.

    Parameters
    ----------
    known : mapping
        Dimensions of symbols.
    """
    try:
        written = _dimension(truth, letter, known)
    except MixedDimensions:
        return False
    return bool(_living(truth, letter, written, known))


def _of_some_term(truth: Equations, letter: Letter, known: Known) -> str:
    """The first meaning that has the dimension of one of the terms, which all others miss."""
    scene, found = truth.scene, set[Dimension]()
    for term in (t for side in letter.sides for t in _terms(scene.plain(side))):
        try:
            one = dimension_of(scene, term, known)
        except MixedDimensions:
            continue  # the mistake is in it
        found |= {one} if one is not None else set()
    every = [letter.said] if letter.said else [w for r in LETTERS[letter.name] for w in r]
    fitting = (word for word in every if any(_fits(word, one) for one in found))
    return next(fitting, every[0])


def _terms(side: Expr) -> Iterator[Expr]:
    """The terms of a side; of sqrt(m + I/r) what it is with one of the terms below the root."""
    terms = Add.make_args(side)
    sums = [part for part in preorder_traversal(side) if isinstance(part, Add)]
    yield from terms
    if len(terms) == 1 and sums:
        yield from (side.xreplace({sums[0]: term}) for term in sums[0].args)


def _living(
    truth: Equations, letter: Letter, written: Dimension | None,
    known: Known,
) -> list[tuple[str, ...]]:  # fmt: skip
    """Meanings by rank that have the dimension of what was written."""
    if letter.said:
        return [(letter.said,)] if _fits(letter.said, written) else []
    ranks = LETTERS.get(letter.name, ())
    if letter.own:
        own = known.get(Symbol(letter.name, real=True))
        if own is None or written is None:
            return [(OWN,), *ranks]
        if own == written:
            return [(OWN,)]
    found = (tuple(word for word in rank if _fits(word, written)) for rank in ranks)
    return [rank for rank in found if rank]


def _fits(word: str, written: Dimension | None) -> bool:
    if written is None:
        return True
    if word == "reaction":
        return written in FORCES
    if word == "momentum":
        return written in MOMENTA
    return word not in UNITS or dimension_of_unit(UNITS[word], word) == written


def _trials(
    truth: Equations, group: Sequence[Statement], meaning: str, table: Table
) -> Iterator[tuple[list[Statement], str]]:
    """The statements under everything in the scene that has a meaning."""
    if meaning == OWN:
        yield list(group), OWN
        return
    letter = _letter(group[0])
    every = list(candidates(truth, meaning, table))
    # The scene's own reaction of that name is it, and no other.
    named = [c for c in every if c.quantity == ReactionValue(letter.name)]
    for candidate in named or every:
        derived = bool(candidate.before) or candidate.vanishing is not None
        for rows in zip(*(_rows(s, candidate) for s in group), strict=True):
            found = [
                replace(s, row=row, doubt=_doubt(s), demands=_demands(s, candidate),
                        derived=derived)
                for s, row in zip(group, rows, strict=True)
            ]  # fmt: skip
            yield found, candidate.words


def _rows(statement: Statement, candidate: Candidate) -> Iterator[Published]:
    assert statement.row is not None  # of a group
    return candidate.rows(statement.row, _letter(statement).sides)


def _demands(statement: Statement, candidate: Candidate) -> Demands:
    """What has to have a value; a frequency is that of an equilibrium that is stable."""
    return statement.demands if candidate.vanishing is None else NO_DEMANDS


def _doubt(statement: Statement) -> str:
    """What is left in doubt: that nobody knows what it means no longer is."""
    return "" if statement.doubt.endswith(UNEXPLAINED) else statement.doubt


UNEXPLAINED = "is defined and never used, so it is NOT checked: say what it means"


def _unproved(truth: Equations, statement: Statement, meaning: str, table: Table) -> Settled:
    """A statement that nothing of that meaning makes right.

    In doubt where the scene has no such thing, or several and only prose names it so.
    """
    name = _letter(statement).name
    some = list(islice(candidates(truth, meaning, table), 2)) if meaning != OWN else []
    if meaning == OWN or len(some) == 1 or (some and name in LETTERS):
        return Settled(_first(truth, statement, meaning, table))
    have = "none of the scene's is that" if some else "the scene has none"
    doubt = f"{name} is read as {_article(meaning)}, and {have}: say what it means"
    return Settled(replace(statement, doubt=statement.doubt or doubt))


def _first(
    truth: Equations, statement: Statement, meaning: str, table: Table = NO_TABLE
) -> Statement:
    """The statement under the first thing that has a meaning; as it is, where nothing has."""
    return next(_trials(truth, [statement], meaning, table), ([statement], ""))[0][0]


def _noted(statement: Statement, letter: Letter, meaning: str) -> Settled:
    if meaning == OWN:
        return Settled(statement)
    name = f"what {letter.name} returns" if letter.returned else f"{letter.name} on the left"
    note = f"{name} is read as {_article(meaning)}"
    return Settled(replace(statement, notes=(*statement.notes, note)))


def _article(meaning: str) -> str:
    own = meaning.startswith("the ") or meaning.startswith(("Rayleigh", "reaction", "tension "))
    return meaning if own else f"the {meaning}"


def _dead(truth: Equations, statement: Statement, written: Dimension | None) -> Settled:
    """No meaning has the dimension of what was written."""
    letter, scene = _letter(statement), truth.scene
    moving = {*scene.q, *scene.qd, *scene.u, *scene.ud}
    moves = any(scene.plain(side).free_symbols & moving for side in letter.sides)
    first = letter.said or (*LETTERS.get(letter.name, ((OWN,),)),)[0][0]
    constant = first == "frequency"  # of what a text calls omega
    nothing = (
        f"{letter.name} has the unit {words(written or ())}, as which it means nothing: say what"
    )
    if written is not None and not moves and {*letter.sides} & {*scene.input_symbols}:
        return Settled(replace(statement, doubt=nothing))  # U = F: an input by another name
    if written is None or first not in UNITS or not (moves or constant):
        return Settled(statement)
    if first in QUANTITIES and len({UNITS[word] for word in meanings_of(statement)}) == 1:
        # What is meant has one dimension, and a value: what differs from it can be mended.
        return Settled(_first(truth, statement, first))
    if first in QUANTITIES and not letter.said and letter.name not in ENERGY_NAMES:
        # h is an energy in some books, r^2 phi' in others, of which the rate is judged.
        return Settled(replace(statement, doubt=nothing))
    needed = words(dimension_of_unit(UNITS[first], first) or ())
    message = f"{letter.name} as {_article(first)} has the unit {needed}, this has {words(written)}"
    return _of_no_dimension(statement, MixedDimensions(message, words(written), needed))


def _of_no_dimension(statement: Statement, mixed: MixedDimensions) -> Settled:
    return Settled(replace(statement, doubt=""), by_dimension(subject_of(statement), mixed))
