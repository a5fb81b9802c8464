"""Verdicts under conventions that a person declares.

What is shown holds under every choice that the declaration leaves open, the same one for all
statements; what is right under some of them only is UNDECIDED, and what is right under none, or
wrong under the choice that serves all statements best, is REFUTED.

An angle "from the horizontal" may grow upwards or downwards: these are different equations, and the
sign of gravity tells them apart. Declared above or below the horizontal, it is right or wrong.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

from sympy import Symbol

from mechanics.claims.about import ENTRIES
from mechanics.claims.convention import POINT_MASS, Change, Table
from mechanics.claims.conventions import combined_table, joints, other_signs
from mechanics.claims.declared_conventions import Declared, readings
from mechanics.claims.directions import counted
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.judge.at_rest import at_rest
from mechanics.judge.converted_rows import in_plain_symbols, moved, moves_more
from mechanics.judge.letters import meanings_of, settle
from mechanics.judge.other_conventions import targets_of
from mechanics.judge.single import FAILURES, judge, subject_of
from mechanics.judge.small_angles import as_said
from mechanics.kernel import Finding, Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import Identity
from mechanics.scene.symbols import DOTS

Answer = tuple[tuple[Judged, ...], tuple[str, ...]]

NOT_RIGHT = "not all statements are right under it; states are given in the scene's convention"


def judge_under(
    truth: Equations, statements: Sequence[Statement], declared: Sequence[Declared]
) -> Answer:
    """Verdicts and remarks.

    Raises
    ------
    InputError
        For conventions that contradict each other, or of what the scene does not have.
    """
    held = _held(truth, statements)
    changes = _choices(truth, declared, held)
    if not changes:
        told = ", ".join(d.told for d in declared)
        doubt = f"the convention {told} has no meaning for {truth.scene.name}: leave it out"
        findings = [undecided(subject_of(s), s.doubt or doubt) for s in statements]
        return tuple(map(Judged, statements, findings)), (doubt,)
    both = [_under(target, statements, change) for change, target in changes]
    meant = [[statement for statement, _ in pairs] for pairs in both]
    table = [[finding for _, finding in pairs] for pairs in both]
    if len(changes) > 1:
        return _open(meant, [change for change, _ in changes], table, declared)
    ((change, _),), (findings,) = changes, table
    helping_for, statements = statements, meant[0]
    words = _words(change)
    claimed = [f for s, f in zip(statements, findings, strict=True) if not s.doubt]
    right = all(f.shown for f in claimed)
    remarks = (f"convention: {words}" if right else f"convention: {words}: {NOT_RIGHT}",)
    helping = () if right else _more(changes[0][1], helping_for, change)
    entries = [
        Judged(s, _where(f, words), helping if f.verdict is Verdict.REFUTED else ())
        for s, f in zip(statements, findings, strict=True)
    ]
    return tuple(entries), (*remarks, *_unused(change, held), *_speeds(truth.scene, change))


def only_change(
    truth: Equations, statements: Sequence[Statement], declared: Sequence[Declared]
) -> tuple[Table, Equations] | None:
    """What stands for the person's symbols, and what statements are compared with then.

    None where a declaration leaves several choices open.
    """
    choices = _choices(truth, declared, _held(truth, statements))
    if len(choices) != 1:
        return None
    ((change, target),) = choices
    return combined_table(change), target


def _choices(
    truth: Equations, declared: Sequence[Declared], held: frozenset[Symbol]
) -> list[tuple[Change, Equations]]:
    """What a declaration can mean, and what statements are compared with then."""
    every = readings(truth.scene, declared, held)
    pairs = zip(every, targets_of(truth, every), strict=True)
    return [(change, target) for change, target in pairs if target is not None]


def _speeds(scene: Scene, change: Change) -> tuple[str, ...]:
    turned = any(set(scene.q) & convention.table.keys() for convention in change)
    names = ", ".join(speed.name for speed in scene.u)
    return (f"speeds are the scene's own: {names}",) if scene.speeds and turned else ()


def _more(target: Equations, statements: Sequence[Statement], change: Change) -> tuple[str, ...]:
    """What else has to be counted otherwise, the signs of inputs for example."""
    claimed = [s for s in statements if s.row is not None and not s.doubt]
    touched = {symbol for convention in change for symbol in convention.table}
    every = (*other_signs(target.scene), *joints(target.scene, counted(target.scene)))
    free = [c for c in every if not touched & c.table.keys()]
    for count in range(1, len(free) + 1):
        for extra in combinations(free, count):
            shown = _under(target, claimed, (*change, *extra))
            if claimed and all(finding.shown for _, finding in shown):
                names = ", ".join(c.name for c in extra)
                return (f"{_words(extra)} as well (--convention {names!r} besides)",)
    return ()


def _open(
    meant: list[list[Statement]], changes: Sequence[Change], table: list[list[Finding]],
    declared: Sequence[Declared],
) -> Answer:  # fmt: skip
    """Verdicts where a declaration leaves several choices open."""
    shown = [[f.shown for f in row] for row in table]
    best = max(range(len(changes)), key=lambda k: sum(shown[k]))
    statements = meant[best]
    helping = [k for k, row in enumerate(shown) if sum(row) == sum(shown[best])]
    all_right = all(f or s.doubt for s, f in zip(statements, shown[best], strict=True))
    words = [_words(change) for change in changes]
    told = ", ".join(d.told for d in declared)
    say = ", ".join(c.name for c in changes[best])
    entries = []
    for i, statement in enumerate(statements):
        finding = table[best][i]
        if statement.doubt or not any(row[i] for row in shown):
            entries.append(Judged(statement, _where(finding, words[best])))
        elif all(row[i] for row in shown):
            entries.append(Judged(statement, _where(finding, f"{told} in every sense")))
        elif not finding.shown:
            entries.append(Judged(statement, _where(finding, words[best])))
        else:
            where = " or ".join(words[k] for k in helping if shown[k][i])
            doubt = f"right where {where}: {told!r} leaves that open: say --convention {say!r}"
            entries.append(Judged(statement, undecided(finding.subject, doubt)))
    among = f"convention {told}: it can mean {len(changes)} things"
    if not all_right:
        return tuple(entries), (f"{among}: {NOT_RIGHT.replace('it;', 'any of them;')}",)
    if all(entry.finding.shown for entry in entries):
        return tuple(entries), (f"{among}: the statements are right under all of them",)
    return tuple(entries), (f"{among}: say which, for example --convention {say!r}",)


def _under(
    target: Equations, statements: Sequence[Statement], change: Change
) -> list[tuple[Statement, Finding]]:
    """Statements as they were meant, their rows as the person counts, and the findings."""
    table = combined_table(change)
    there = [_moved(target, statement, table) for statement in statements]
    settled = settle(target, there, lambda s: judge(target, s, {}).shown, table)
    meant = [one.statement for one in settled]
    findings = [one.finding or judge(target, one.statement, {}) for one in settled]
    meant, findings = as_said(target, meant, findings, table)
    return [
        (replace(one, row=_as_counted(statement, one), written=statement.written), finding)
        for statement, one, finding in zip(statements, meant, findings, strict=True)
    ]


def _as_counted(statement: Statement, meant: Statement) -> Published | None:
    """The row in the person's symbols; that of what is the scene's own as it was judged."""
    if statement.row is None or meant.row is None or meant.derived:
        return meant.row
    return replace(statement.row, quantity=meant.row.quantity)


def _moved(target: Equations, statement: Statement, table: Table) -> Statement:
    """A statement as the scene counts."""
    row, letter = statement.row, statement.letter
    if row is None:
        return statement
    resting = at_rest(target, statement, table)
    if resting is not statement:
        return replace(resting, written=statement.written)
    try:
        there = moved(target.scene, row, table)
        if letter is not None:
            sides = moved(
                target.scene, replace(row, quantity=Identity(), sides=letter.sides), table
            )
            letter = replace(letter, sides=sides.sides)
    except FAILURES as error:
        return replace(statement, doubt=statement.doubt or str(error))
    return replace(statement, row=there, demands=statement.demands.put(table), letter=letter)


def _held(truth: Equations, statements: Sequence[Statement]) -> frozenset[Symbol]:
    """Symbols that matter to statements."""
    scene = truth.scene
    some = [s for s in statements if s.row is not None and (not s.doubt or s.letter is not None)]
    rows = [s.row for s in some if s.row is not None]
    entries = any(meaning in ENTRIES for s in some for meaning in meanings_of(s))
    if entries or any(moves_more(scene, row) for row in rows):
        rates = {Symbol(q.name + dots, real=True) for q in scene.q for dots in DOTS}
        return frozenset({*scene.q, *rates, *scene.input_symbols, *scene.parameters})
    sides = (side for row in rows for side in in_plain_symbols(truth.kinematics, row).sides)
    resting = any(at_rest(truth, s) is not s for s in statements)
    own = {*scene.q} if resting else set[Symbol]()
    return frozenset(own.union(*(side.free_symbols for side in sides)))


def _unused(change: Change, held: frozenset[Symbol]) -> tuple[str, ...]:
    """Conventions that do not touch the statements, which are right or wrong without them."""
    idle = [c for c in change if c is not POINT_MASS and c.table and not held & c.table.keys()]
    return tuple(
        f"convention {c.name}: the statements hold nothing that it changes: it makes no difference"
        for c in idle
    )


def _where(finding: Finding, words: str) -> Finding:
    return replace(finding, evidence=f"{finding.evidence}, where {words}")


def _words(change: Change) -> str:
    return " and ".join(convention.words for convention in change)
