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

from sympy import Expr, Symbol, degree, expand, factor, numer, sqrt, together

from mechanics.claims.prose import sentence_around
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.judge.letters import meanings_of
from mechanics.judge.meanings import ROOT, SQUARES, candidates
from mechanics.kernel import undecided
from mechanics.linear.small_oscillations import SQUARE, oscillations
from mechanics.report.answer.judged import Judged
from mechanics.symbolic import is_zero

WHICH = re.compile(
    r"\b(?:low(?:est|er)|high(?:est|er)|small(?:est|er)|larg(?:est|er)|slow(?:est|er)|fast(?:est|er)"
    r"|fundamental|only|sole|single|short(?:est|er)|long(?:est|er)|first|second)\s+"
    r"(?:\w+\s+){0,2}(?:\w*frequenc|mode|period|root)",
    re.IGNORECASE,
)
LOWER = re.compile(r"(?:low|small|slow|fundamental)(?!.*period)", re.IGNORECASE)
HIGHER = re.compile(r"(?:high|larg|fast)(?!.*period)", re.IGNORECASE)
"""Of frequencies; a period is larger where its frequency is smaller."""
KINDS = {
    "natural": re.compile(
        r"\b(?:natural|undamped|eigen\w*)\b|\b(?:without|no|neglect\w*|ignor\w*)\s+(?:\w+\s+){0,2}"
        r"(?:damp|friction|drag)|omega_[n0]\b|w_?[n0]\b", re.IGNORECASE,
    ),
    "damped": re.compile(r"\bdamped\b|omega_d\b|w_?d\b", re.IGNORECASE),
    "resonant": re.compile(r"\bresonan\w*|\bpeak\b|omega_r\b|w_?r\b", re.IGNORECASE),
}  # fmt: skip
"""Frequencies of one freedom with a damper, and what says which one is meant."""


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


def solved(truth: Equations, statement: Statement) -> Statement:
    """The statement of the one frequency of a scene with its square on a side of its own.

    What the square of it has to be stands beside what was written, so that edits can be searched.
    """
    row, letter = statement.row, statement.letter
    if row is None or letter is None:
        return statement
    for meaning in SQUARES.keys() & {*meanings_of(statement)}:
        for candidate in candidates(truth, meaning):
            if row not in candidate.rows(row, letter.sides) or candidate.vanishing is None:
                continue
            square = Symbol("square", positive=True)
            above = expand(numer(together(candidate.vanishing.subs(ROOT, sqrt(square)))))
            while above != 0 and above.coeff(square, 0) == 0:  # what moves freely has none
                above = expand(above / square)
            if above.has(square) and degree(above, square) == 1:
                root = -above.coeff(square, 0) / above.coeff(square, 1)
                sides = (*(side**2 for side in letter.sides), factor(root))
                return replace(statement, row=replace(row, sides=sides))
    return statement


def _other_kind(truth: Equations, statement: Statement) -> str:
    """What is to be said where a damper makes several frequencies, and not this one is said."""
    square = truth.scene.plain(_square(statement))
    damped = [one for one in oscillations(truth) if one.damped is not None]
    kinds = [
        k for k in KINDS if any(is_zero(getattr(o, k).xreplace({SQUARE: square})) for o in damped)
    ]
    written = statement.written
    sentence = sentence_around(written.text, written.start) if written is not None else ""
    words = f"{' '.join(sentence.split())} {_name(statement)}"
    said = [kind for kind, pattern in KINDS.items() if pattern.search(words)] or ["damped"]
    if not kinds or said == kinds:
        return ""
    return f"it is the {kinds[0]} frequency of what has a damper: say '{kinds[0]}', and no other"


def _left_open(entry: Judged, words: str) -> Judged:
    doubt = f"it is a frequency of small oscillations, but the scene has several: {words}"
    return replace(entry, finding=undecided(entry.finding.subject, doubt))


def _which(statement: Statement) -> str:
    """Which of several it is said to be."""
    written = statement.written
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
    return bool(gaps) and all(gap.is_positive for gap in gaps)


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
