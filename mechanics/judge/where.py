"""Statements where something is positive: one branch of a loop, one sign of a root.

    s = r cos(theta) + sqrt(l^2 - r^2 sin(theta)^2)    right where cos(phi) > 0, wrong elsewhere

The states that are drawn meet the conditions, and there has to be such a state. A condition holds
coordinates and parameters; a boundary is looked at from inside.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, combinations

from sympy import Abs, Expr, Pow, cos, sign, sin
from sympy.core.relational import Gt, Relational
from sympy.matrices import MatrixBase

from mechanics.checks.ledger import check_row
from mechanics.checks.ledger_compare import define
from mechanics.checks.manifold import restrict
from mechanics.claims.kinds import angular
from mechanics.claims.names import Match, unexplained
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.errors import InputError, MechanicsError
from mechanics.judge.case_states import entered
from mechanics.judge.cases import in_case
from mechanics.judge.converted_rows import in_plain_symbols
from mechanics.judge.definedness import where_defined
from mechanics.judge.readers import read
from mechanics.judge.single import FAILURES, identity
from mechanics.judge.vacuous import WORDS
from mechanics.kernel import Finding, Verdict, undecided
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, Identity, ReactionValue
from mechanics.symbolic import Arithmetic, Number, decide

KINDS = (EquationOfMotion, ReactionValue, Identity)
"""What can be right on a branch alone."""

MOST = 40
"""Branches that are tried."""

MOST_CONDITIONS = 8
OPTION = "--where (where=)"
LONGEST = 300


@dataclass(frozen=True)
class Where:
    """A condition: words as ``cos(phi) > 0``, and what is positive."""

    words: str
    positive: Expr


def read_where(
    truth: Equations, texts: Sequence[str], names: Sequence[Match], given: Mapping[str, str]
) -> tuple[Where, ...]:
    """Conditions of a person, in the scene's symbols.

    Parameters
    ----------
    texts : sequence of str
        ``"cos(phi) > 0"``; several in one are parted by ``and``.
    names : sequence of Match
        What names of the person were taken for in the statements.
    given : mapping of str to str
        What the person says of names.

    Raises
    ------
    InputError
        For what is no inequality in coordinates and parameters, or holds at no state that is found.
    """
    table = {match.name: match.meaning for match in names} | dict(given)
    # What code calls a vector is no name in a condition.
    known = {name: meaning for name, meaning in table.items() if len(_words(meaning)) == 1}
    parts = [part for text in texts for part in _parts(text)]
    if len(parts) > MOST_CONDITIONS or any(len(part) > LONGEST for part in parts):
        raise InputError(f"{OPTION}: at most {MOST_CONDITIONS} conditions of {LONGEST} characters")
    found = tuple(_condition(truth.scene, part, known) for part in parts)
    if found and not _there(truth, found):
        told = " and ".join(one.words for one in found)
        raise InputError(
            f"{OPTION} {told!r}: no state of {truth.scene.name} was found where that holds: write"
            " smaller numbers, or a wider range: sin(theta) < 0 for theta > pi"
        )
    return found


def judge_where(truth: Equations, statement: Statement, where: Sequence[Where]) -> Finding:
    """The finding of a statement where conditions hold; what is right everywhere is right there.

    Parameters
    ----------
    where : sequence of Where
        At least one, which hold together at some state.
    """
    positive = [one.positive for one in where]
    everywhere = identity(truth, statement, {})
    row = statement.row
    if everywhere.shown or row is None or statement.doubt:
        return where_defined(truth, statement, everywhere, positive)
    if everywhere.verdict is Verdict.UNDECIDED and not _branched(statement):
        return everywhere
    words = " and ".join(one.words for one in where)
    try:
        found = check_row(truth.scene, row, truth, positive)
        stated = isinstance(row.quantity, Identity) and not statement.derived
        if found.shown and stated and _empty(truth.kinematics, row, where):
            return undecided(everywhere.subject, f"where {words}, {WORDS}")
        if found.verdict is Verdict.UNDECIDED and _free(truth.scene, where):
            found = _inside(truth, row, where, found)
    except FAILURES as error:
        return undecided(everywhere.subject, str(error))
    found = replace(found, evidence=f"{found.evidence}, where {words}")
    return where_defined(truth, statement, found, positive)


def right_where(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding]
) -> tuple[str, ...]:
    """A branch on which all statements are right; nothing where there is none, or no root.

    Parameters
    ----------
    findings : sequence of Finding
        Their verdicts as written.
    """
    wrong = [s for s, f in zip(statements, findings, strict=True) if not f.shown]
    if not wrong or not all(_branched(s) for s in wrong):
        return ()
    for number, one in enumerate(_candidates(truth.scene, wrong)):
        if number == MOST:
            break
        try:
            if all(
                s.row is not None and check_row(truth.scene, s.row, truth, [one.positive]).shown
                for s in wrong
            ) and _there(truth, [one]):
                return (f"{one.words}, on that branch only (--where {one.words!r})",)
        except MechanicsError:
            return ()  # the ledger compares it with something else than the motion
    return ()


def _words(meaning: str) -> list[str]:
    return meaning.replace(",", " ").split()


def _parts(text: str) -> Iterator[str]:
    """Conditions of a text: a comma inside of brackets parts none."""
    depth, start = 0, 0
    for found in re.finditer(r"[(\[]|[)\]]|,|&&?|\band\b", text):
        if found[0] in "([":
            depth += 1
        elif found[0] in ")]":
            depth -= 1
        elif depth <= 0:
            yield text[start : found.start()].strip()
            start = found.end()
    yield text[start:].strip()


def _closed(text: str) -> bool:
    """Whether every bracket is closed in a text, and none before it is opened."""
    depths = list(accumulate((c in "([") - (c in ")]") for c in text))
    return min(depths) >= 0 and depths[-1] == 0


def _condition(scene: Scene, text: str, names: Mapping[str, str]) -> Where:
    wrong = (
        f"{OPTION} {text!r}: write one inequality in coordinates and parameters, as cos(phi) > 0;"
        " the value of a parameter is --value g=9.81"
    )
    match = re.fullmatch(r"([^<>=]+)([<>])=?([^<>=]+)", text)
    if match is None or "\n" in text or not (_closed(match[1]) and _closed(match[3])):
        raise InputError(wrong)
    left, relation, right = match.groups()
    try:
        # A name that equals something would be taken for a definition.
        reading = read(scene, f"0 = ({left}) - ({right})", names, "text", None)
    except InputError as error:
        words = re.sub(r"^text, line 1, column \d+: ", "", str(error))
        raise InputError(f"{OPTION} {text!r}: {words}") from None
    guessed = [m.name for m in reading.names if m.name not in names and m.name != m.meaning]
    if guessed:
        raise InputError(f"{OPTION} {text!r}: {guessed[0]} is no name of {scene.name}: use its own")
    if len(reading.statements) != 1:
        raise InputError(wrong)
    (statement,) = reading.statements
    unknown = [words.partition(" ")[0] for words in statement.unsure]  # a guess is no condition
    if doubt := statement.doubt or (unexplained(scene, unknown) if unknown else ""):
        raise InputError(f"{OPTION} {text!r}: {doubt}")
    row = statement.row
    if row is None or len(row.sides) != 2 or not isinstance(row.quantity, Identity):
        raise InputError(wrong)
    none, difference = row.sides
    if none != 0 or isinstance(difference, MatrixBase):
        raise InputError(wrong)
    free = difference.free_symbols
    if not free or not free <= {*scene.q, *scene.parameters}:
        raise InputError(wrong)
    positive = difference if relation == ">" else -difference
    return Where(f"{left.strip()} {relation} {right.strip()}", positive)


def _empty(kinematics: Kinematics, row: Published, where: Sequence[Where]) -> bool:
    """Whether sides are the same on the branch without anything of the scene."""
    first, *others = in_plain_symbols(kinematics, row).sides

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        for one in where:
            a.require_positive(a.value(one.positive))
        return [(a.value(first), a.value(side)) for side in others]

    return not isinstance(first, MatrixBase) and decide("an identity", experiment).shown


def _inside(
    truth: Equations, row: Published, where: Sequence[Where], found: Finding
) -> Finding:  # fmt: skip
    """The finding where hardly any state that is drawn is: theta > pi. It is looked for there."""
    if not isinstance(row.quantity, EquationOfMotion | Identity):
        return found
    inside = in_case(truth, row, _conditions(where))
    if inside.verdict is Verdict.REFUTED:
        return inside
    if _met(truth, where):
        return found
    return replace(found, evidence="it is not shown, and right at the states that were tried")


def _there(truth: Equations, where: Sequence[Where]) -> bool:
    """Whether a real state is found where conditions hold: nothing is proved of none."""
    if _met(truth, where):
        return True
    return _free(truth.scene, where) and any(True for _ in entered(_conditions(where)))


def _free(scene: Scene, where: Sequence[Where]) -> bool:
    """Whether a scene lets what conditions hold have any values."""
    held = set().union(*(one.positive.free_symbols for one in where))
    return scene.unconstrained and not held & scene.definitions.keys()


def _met(truth: Equations, where: Sequence[Where]) -> bool:
    """Whether a state that is drawn is where conditions hold."""

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        define(a, truth.scene)
        restrict(a, truth.kinematics)
        for one in where:
            a.require_positive(a.value(one.positive))
        return [(a.rational(0), a.rational(1))]

    try:
        found = decide("a state", experiment, target=2.0**-20, try_normal=False)
    except MechanicsError:
        return False
    return found.verdict is Verdict.REFUTED


def _conditions(where: Sequence[Where]) -> tuple[Relational, ...]:
    return tuple(Gt(one.positive, 0, evaluate=False) for one in where)


def _branched(statement: Statement) -> bool:
    """Whether roots or moduli are in a statement, which have branches."""
    row = statement.row
    if row is None or not isinstance(row.quantity, KINDS):
        return False
    roots = [p for side in row.sides for p in side.atoms(Pow) if not p.exp.is_integer]
    return bool(roots) or any(side.has(Abs, sign) for side in row.sides)


def _candidates(scene: Scene, wrong: Sequence[Statement]) -> Iterator[Where]:
    """Signs of sines and cosines, of displacements, and of how two rods cross."""
    rows = [statement.row for statement in wrong if statement.row is not None]
    held = set().union(*(side.free_symbols for row in rows for side in row.sides))
    angles = [q for q in scene.q if q in angular(scene)]
    # Where a root stands for a coordinate, that is the one that the statement leaves out.
    order = sorted(angles, key=lambda q: q in held)
    signed = [f(q) for q in order for f in (cos, sin)]
    signed += [sin(two - one) for one, two in combinations(angles, 2)]
    signed += [q for q in scene.q if q not in angles]
    for crossing in signed:
        expression = -crossing if crossing.could_extract_minus_sign() else crossing
        yield Where(f"{expression} > 0", expression)
        yield Where(f"{expression} < 0", -expression)
