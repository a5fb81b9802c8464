r"""What a text says of several frequencies: different names, different roots; the lowest.

omega_1 = sqrt(k/m), omega_2 = sqrt(k/m)    each is a root; both are it only where it is double
the lowest frequency is sqrt(k/m)           of two roots it has to be the smaller one; of more it
                                            is not checked
omega = sqrt(k/m), with a damper            is the natural frequency, and not that of the motion: it
                                            has to be said, or the name be omega_n
"""

import re
from collections.abc import Sequence
from dataclasses import replace

from sympy import (
    Dummy,
    Expr,
    Pow,
    S,
    Symbol,
    degree,
    expand,
    factor,
    factor_list,
    numer,
    sqrt,
    together,
)

from mechanics.claims.code.function_names import spoken
from mechanics.claims.counting_words import ONE_OF_SEVERAL
from mechanics.claims.prose import sentence_around
from mechanics.claims.statement import Statement
from mechanics.claims.tree import names
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.judge.letters import meanings_of
from mechanics.judge.meanings import ROOT, SQUARES, candidates
from mechanics.judge.operating_point import place_said
from mechanics.kernel import undecided
from mechanics.linear.small_oscillations import SQUARE, oscillations
from mechanics.report.answer.judged import Judged
from mechanics.symbolic import is_zero

WHICH = re.compile(
    r"\b(?:low(?:est|er)|high(?:est|er)|small(?:est|er)|larg(?:est|er)|slow(?:est|er)|fast(?:est|er)"
    r"|fundamental|ground|only|sole|single|short(?:est|er)|long(?:est|er)|first|second"
    r"|min(?:imum|imal)|max(?:imum|imal)|upper(?=\s+(?:\w*frequenc|mode|root|eigen)))\s+"
    r"(?:of\s+(?:the\s+|both\s+)?(?:two\s+)?)?(?:\w+\s+){0,2}(?:\w*frequenc|mode|period|root|eigen\w+)"
    r"|\b(?:opposite directions?|out of phase|in phase|in unison|(?:anti-?)?symmetric mode"
    r"|held|clamped|fixed|locked)\b",
    re.IGNORECASE,
)
WHICH_OF_NAME = re.compile(
    r"(?:low|high|slow|fast)(?:er|est)?|(?:small|larg)(?:er|est)|fundamental|m(?:in|ax)(?:imum)?"
)
"""The same in the name of a function."""
LOWER = re.compile(r"(?:low|small|slow|fundamental|ground|min)(?!.*period)", re.IGNORECASE)
HIGHER = re.compile(r"(?:high|upper|larg|fast|max)(?!.*period)", re.IGNORECASE)
"""Of frequencies; a period is larger where its frequency is smaller."""
WITHOUT = (
    r"(?<!not )(?<!without )(?<!never )(?:without|no|neglect\w*|ignor\w*|disregard\w*)"
    r"\s+(?:the\s+|any\s+)?(?:damp|friction|drag)\w*"
)
KINDS = {
    "natural": (
        rf"(?<!\bdamped )\b(?:natural|undamped|eigen\w*)\b|\b{WITHOUT}",
        r"\w*?_?(?:n|0|nat)",
    ),
    "damped": (r"\bdamped(?:\s+natural)?\b", r"\w+?_?d"),
    "resonant": (r"\bresonan\w*|\bpeak\b", r"\w+?_?(?:r|res)"),
}
"""Frequencies of one freedom with a damper: what says in a text which one is meant, and what in its
name.
"""
AMPLITUDE = re.compile(
    r"(?<!small )(?<!infinitesimal )(?<!vanishing )(?<!independent of )(?<!independent of the )"
    r"(?<!depend on )(?<!depend on the )(?<!any )(?<!small-)\bamplitudes?\b"
    r"|\b(?:large|finite|big|wide)\s+(?:oscillation|vibration|swing|motion|angle|displacement)s?\b",
    re.IGNORECASE,
)
"""What speaks of a motion that is not small."""
OF_FREQUENCY = r"\W+(?:angular\W+|circular\W+)?(?:\w*frequenc\w*|period\w*)"


def one_root_each(
    truth: Equations, judged: Sequence[Judged], statements: Sequence[Statement]
) -> tuple[Judged, ...]:
    """The entries; frequencies of which more is said than that they are some are UNDECIDED.

    Parameters
    ----------
    statements : sequence of Statement
        As they were read.
    """
    found = list(judged)
    roots = [
        k for k, (entry, statement) in enumerate(zip(judged, statements, strict=True))
        if entry.finding.shown and entry.statement.derived
        and SQUARES.keys() & {*meanings_of(statement)}
    ]  # fmt: skip
    for k in roots:
        if words := _is_rate(truth, statements[k]):
            found[k] = replace(found[k], finding=undecided(found[k].finding.subject, words))
    for k in roots:
        if words := _said_elsewhere(truth, statements[k]) or _said_wide(truth, statements[k]):
            found[k] = replace(found[k], finding=undecided(found[k].finding.subject, words))
    for k in roots if len(truth.scene.q) == 1 else ():
        if words := _other_kind(truth, statements[k]):
            found[k] = replace(found[k], finding=undecided(found[k].finding.subject, words))
    for k in roots if len(truth.scene.q) > 1 else ():
        others = [j for j in roots if j != k and _alike(statements[j], statements[k])]
        if others and not _double(truth, statements[k]):
            words = ", ".join(dict.fromkeys(_name(statements[j]) for j in others))
            found[k] = _left_open(found[k], f"{words} and {_name(statements[k])} are the same one")
        elif (words := _which(statements[k])) and not _is_so(truth, statements[k], words):
            found[k] = _left_open(found[k], f"it is not checked whether it is {words!r}")
    return tuple(found)


def solved(truth: Equations, statement: Statement) -> list[Statement]:
    """The statement of a frequency with its square on a side of its own, for each root.

    What the square of it has to be stands beside what was written, so that edits can be searched.
    """
    row, letter = statement.row, statement.letter
    if row is None or letter is None:
        return [statement]
    for meaning in SQUARES.keys() & {*meanings_of(statement)}:
        for candidate in candidates(truth, meaning):
            if row not in candidate.rows(row, letter.sides) or candidate.vanishing is None:
                continue
            square = Symbol("square", positive=True)
            above = numer(together(candidate.vanishing.subs(ROOT, sqrt(square))))
            squares = [side**2 for side in letter.sides]
            _, parts = factor_list(above, square)
            linear = [part for part, _ in parts if degree(part, square) == 1 and part != square]
            roots = [-part.coeff(square, 0) / part.coeff(square, 1) for part in map(expand, linear)]
            if roots:
                rows = [replace(row, sides=(*squares, factor(root))) for root in roots]
                return [replace(statement, row=each) for each in rows]
    return [statement]


def _is_rate(truth: Equations, statement: Statement) -> str:
    """What is to be said of a name that its text defines as something that moves, too."""
    written, name = statement.written, _name(statement)
    value = dict(written.definitions).get(name) if written is not None else None
    if written is None or value is None or value in written.sides:  # defined by itself only
        return ""
    moving = {q.name for q in truth.scene.q}
    meanings = ((one, written.naming.lookup(one.name)) for one in names(value))
    if not any(one.order or (own is not None and own[0] in moving) for one, own in meanings):
        return ""
    return f"the text defines {name} as something that moves, too: give one of them another name"


def _said_elsewhere(truth: Equations, statement: Statement) -> str:
    """What is to be said where its sentence gives the frequency of another equilibrium."""
    written = statement.written
    if written is None or written.notation not in ("latex", "text"):
        return ""
    sentence = WHICH.sub(" ", sentence_around(written.text, written.start))
    words, place = place_said(truth.scene, written, sentence)
    if not words:
        return ""
    square = truth.scene.plain(_square(statement))
    found = [
        one.place for one in oscillations(truth)
        if any(is_zero(zero.xreplace({SQUARE: square}))
               for zero in (one.natural, one.damped, one.resonant) if zero is not None)
    ]  # fmt: skip
    named = [dict(pair.split(" = ") for pair in each.split(", ")) for each in found]
    if not found or (place is not None and any(
        all(each.get(q.name) == str(value) for q, value in place.items()) for each in named
    )):  # fmt: skip
        return ""
    return f"it is the frequency about {' or '.join(found)}, and the text says {words!r}"


def _said_wide(truth: Equations, statement: Statement) -> str:
    """What is to be said where its sentence speaks of a motion that is not small."""
    written = statement.written
    sentence = sentence_around(written.text, written.start) if written is not None else ""
    wide = AMPLITUDE.search(" ".join(sentence.split()))
    if wide is None or _is_linear(truth):
        return ""
    return f"it is the frequency of small oscillations, and the text says {wide[0]!r}"


def _is_linear(truth: Equations) -> bool:
    """Whether its equations of motion are linear in all that moves."""
    moving = [*truth.scene.q, *truth.scene.qd, *truth.scene.u, *truth.scene.ud]
    slopes = [row.diff(symbol) for row in truth.residual for symbol in moving]
    return all(is_zero(slope.diff(symbol)) for slope in slopes for symbol in moving)


def _other_kind(truth: Equations, statement: Statement) -> str:
    """What is to be said where a damper makes several frequencies, and not this one is said."""
    square = truth.scene.plain(_square(statement))
    damped = [one for one in oscillations(truth) if one.damped is not None]
    zeros = {k: [getattr(o, k) for o in damped if getattr(o, k) is not None] for k in KINDS}
    kinds = [k for k in KINDS if any(is_zero(z.xreplace({SQUARE: square})) for z in zeros[k])]
    said = _said(statement) or ["damped"]
    if not kinds or said == kinds:
        return ""
    return f"it is the {kinds[0]} frequency of what has a damper: write '{kinds[0]} frequency'"


def _said(statement: Statement) -> list[str]:
    """Which kinds are said: by the word before "frequency", else by any, else by the name."""
    written = statement.written
    sentence = sentence_around(written.text, written.start) if written is not None else ""
    for behind in (OF_FREQUENCY, ""):
        found = [
            kind for kind, (words, _) in KINDS.items()
            if re.search(rf"(?:{words}){behind}", sentence, re.IGNORECASE)
        ]  # fmt: skip
        if found:
            return found
    name = _name(statement)
    return [kind for kind, (_, name_of) in KINDS.items() if re.fullmatch(name_of, name)]


def _left_open(entry: Judged, words: str) -> Judged:
    doubt = f"it is a frequency of small oscillations, but the scene has several: {words}"
    return replace(entry, finding=undecided(entry.finding.subject, doubt))


def _which(statement: Statement) -> str:
    """Which of several it is said to be, of code by the name of the function."""
    written, letter = statement.written, statement.letter
    if letter is not None and letter.returned:
        said = spoken(letter.name).split()
        word = next((w for w in said if WHICH_OF_NAME.fullmatch(w) or w in ONE_OF_SEVERAL), "")
        kind = "period" if "period" in said else "frequency"
        return f"{word} {kind}" if word else ""
    if written is None:
        return ""
    found = WHICH.search(" ".join(sentence_around(written.text, written.start).split()))
    return found[0] if found else ""


def _is_so(truth: Equations, statement: Statement, words: str) -> bool:
    """Whether of two frequencies it is the one that it is said to be, wherever it is one."""
    sign = 1 if LOWER.match(words) else -1 if HIGHER.match(words) else 0
    if not sign or SQUARES.keys() & {*meanings_of(statement)} != {"frequency"}:
        return False
    square, gaps = truth.scene.plain(_square(statement)), []
    for one in oscillations(truth):
        if not is_zero(one.natural.xreplace({SQUARE: square})):
            continue
        whole = expand(one.natural)
        if degree(whole, SQUARE) != 2:
            return False
        other = -whole.coeff(SQUARE, 1) / whole.coeff(SQUARE, 2) - square
        gaps.append(factor(together(sign * (other - square))))
    return bool(gaps) and all(_with_roots_positive(gap).is_positive for gap in gaps)


def _with_roots_positive(gap: Expr) -> Expr:
    """A gap with letters for its square roots, which are positive where two frequencies differ."""
    return gap.replace(
        lambda e: isinstance(e, Pow) and e.exp == S.Half, lambda _: Dummy(positive=True)
    )


def _name(statement: Statement) -> str:
    return statement.letter.name if statement.letter is not None else ""


def _square(statement: Statement) -> Expr:
    """That of the frequency that a statement gives, as which it was shown."""
    assert statement.letter is not None  # of a root
    (word, *_) = (m for m in meanings_of(statement) if m in SQUARES)
    return SQUARES[word].subs(ROOT, statement.letter.sides[-1])


def _alike(one: Statement, other: Statement) -> bool:
    """Whether two names are said to be one root."""
    if _name(one) == _name(other):
        return False
    try:
        return bool(is_zero(_square(one) - _square(other)))
    except ExpressionError:
        return False


def _double(truth: Equations, statement: Statement) -> bool:
    """Whether what is written is a root of which there are two."""
    square = truth.scene.plain(_square(statement))
    for one in oscillations(truth):
        both = (one.natural, one.natural.diff(SQUARE))
        if all(is_zero(two.xreplace({SQUARE: square})) for two in both):
            return True
    return False
