r"""Statements about a special case that the text gives: "for $u = 0$ ...", "without torque, ...".

    For $u=0$ we have \ddot\theta = 3g/(2l) \sin\theta    REFUTED as it stands, right if u = 0

What a text gives a value to is not used, since a person's numbers are as a rule an example. Where a
refuted statement is right with them it is open, and the answer says with which.
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from sympy import Expr, Rational, S, Symbol
from sympy.matrices import MatrixBase

from mechanics.claims.claim import Written
from mechanics.claims.latex.case_beside import case_of
from mechanics.claims.names import Naming
from mechanics.claims.prose import SYMBOL, sentence_around
from mechanics.equations import Equations
from mechanics.judge.at_values import as_identity, fewest, put, right_with, words
from mechanics.judge.converted_rows import in_plain_symbols
from mechanics.kernel import Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene
from mechanics.scene.published import Published

UNIT = r"(?:\\[,;:! ]|~|\s|\\?(?:mathrm|text|textrm|si|unit)\s*\{[^{}$]*\})*"
GIVEN = re.compile(
    rf"\$\s*{SYMBOL}(?P<more>(?:\s*=\s*\\?[A-Za-z]\w*(?:_\{{\w+\}})?)*)"
    rf"\s*=\s*(?P<value>-?\d+(?:\.\d+)?)\s*{UNIT}\$"
)
STATED = re.compile(
    rf"(?:^|(?<=[\s,;($&~])|(?<=quad)){SYMBOL}(?:\s*\[[^\]\n]*\])?\s*=\s*"
    r"(?P<value>-?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?)"
    r"(?:[ ~]*(?:\[[^\]\n]*\]|(?:\\[,:])?\s*\\(?:mathrm|text|si|unit)\s*\{[^{}]*\}"
    r"|(?:[kcm]?m|k?g|N|s)\b[\w/^*]*))?"
    r"(?=[ \t~]*(?:$|[,;.)&\"#%]|\\[,;:\] q\\]|\$|and\b))",
    re.MULTILINE,
)
"""A value that stands beside formulas."""
PLAIN = r"[A-Za-z]\w*(?:_\{\w+\})?"
EQUAL = re.compile(rf"\$\s*(?P<names>{PLAIN}(?:\s*=\s*{PLAIN})+)\s*\$")
IDLE = re.compile(
    r"\b(?:no|without|zero|vanishing)\s+(?:(?:an?|any|external|applied|driving|motor|control)\s+)*"
    r"(?:torque|force|forcing|input|control|drive)s?\b"
    r"|\bun(?:forced|driven|actuated)\b|\bfree\s+(?:motion|oscillation|vibration|swing)",
    re.IGNORECASE,
)
"""What says that nothing drives."""


def in_special_case(truth: Equations, entries: Sequence[Judged]) -> tuple[Judged, ...]:
    """The entries; a refuted one is open where it is right in the case that its text gives."""
    return tuple(_open(truth, entry) for entry in entries)


def _open(truth: Equations, entry: Judged) -> Judged:
    row, written = entry.statement.row, entry.statement.written
    if entry.verdict is not Verdict.REFUTED or row is None:
        return entry
    held = set().union(*(side.free_symbols for side in row.sides))
    given = dict(entry.statement.file_values)
    if held & {*truth.scene.parameters}:  # no code in which all parameters are numbers
        given = {s: v for s, v in given.items() if s in truth.scene.input_symbols}
    if (needed := _needed(truth, row, given)) is not None:
        arguments = " and ".join(symbol.name for symbol in needed)
        told = f"{words(needed)}, as the code says; as an argument {arguments} is judged for all"
        return replace(entry, right_if=(f"{told} values",), open=True)
    if written is None:
        return entry
    if written.notation == "latex" and (
        case := case_of(written.text, written.start, written.naming)
    ):
        doubt = f"the text gives it for {case} only, which is not judged apart: leave that out"
        return replace(entry, finding=undecided(entry.finding.subject, doubt), right_if=())
    table = dict(_given(truth, written)) if written.notation == "latex" else {}
    # Of what stands in the statement itself, a value is an example, but where it says no more.
    alone = all(isinstance(s, Expr) and (s in held or s.is_number) for s in row.sides)
    beside = {s: v for s, v in _stated(truth, written).items() if alone or s not in held}
    for some in (table, table | beside):
        if (needed := _needed(truth, row, some)) is not None:
            return replace(entry, right_if=(f"{words(needed)}, as the text says",), open=True)
    return entry


def _needed(
    truth: Equations, row: Published, some: Mapping[Symbol, Expr]
) -> Mapping[Symbol, Expr] | None:
    """The values with which a row is right; None where it is not, or there are none."""
    if not some or not _right_with(truth, row, some):
        return None
    return fewest(some, lambda values: _right_with(truth, row, values))


def _right_with(truth: Equations, row: Published, table: Mapping[Symbol, Expr]) -> bool:
    """Whether a row is right where its text's values stand in both sides."""
    plain = in_plain_symbols(truth.kinematics, as_identity(truth, row))
    if any(isinstance(side, MatrixBase) for side in plain.sides):
        return False
    # A value of the scene's, a reaction, has one side: what it equals is not written.
    values = [side.xreplace(dict(table)) for side in plain.sides]
    gives_it = len(values) > 1 and len({*values}) == 1
    return gives_it or right_with(truth, [put(plain, table)], table)


def _stated(truth: Equations, written: Written) -> dict[Symbol, Expr]:
    """Values of parameters and inputs in the text, the same in all places.

    In LaTeX what stands behind the sentence is of something else.
    """
    text = written.text if written.notation == "text" else written.text[: _end(written)]
    return values_in(text, truth.scene, written.naming)


def values_in(text: str, scene: Scene, naming: Naming) -> dict[Symbol, Expr]:
    """Values of parameters and inputs in a text, the same in all places.

    Parameters
    ----------
    text : str
    scene : Scene
    naming : Naming
    """
    free = _free(scene, naming)
    found: dict[Symbol, set[Rational]] = {}
    for one in STATED.finditer(text):
        if (own := free(one["name"])) is not None:
            found.setdefault(own, set()).add(Rational(one["value"]))
    return {
        own: value for own, values in found.items() for value in values
        if len(values) == 1 and (value > 0 or not own.is_positive)
    }  # fmt: skip


def _free(scene: Scene, naming: Naming) -> Callable[[str], Symbol | None]:
    """The parameter or input that a name stands for."""
    free = {s.name: s for s in (*scene.parameters, *scene.input_symbols)}

    def symbol(name: str) -> Symbol | None:
        meaning = naming.lookup(name.replace("{", "").replace("}", ""))
        return None if meaning is None or meaning[1] else free.get(meaning[0])

    return symbol


def _end(written: Written) -> int:
    """Where the sentence of a statement ends."""
    sentence = sentence_around(written.text, written.start)
    return written.text.find(sentence, max(0, written.start - len(sentence))) + len(sentence)


def _given(truth: Equations, written: Written) -> Iterator[tuple[Symbol, Expr]]:
    """Symbols of the scene with what the text up to the end of its sentence puts for them."""
    scene, naming = truth.scene, written.naming
    symbol = _free(scene, naming)
    sentence = sentence_around(written.text, written.start)
    text = " ".join(written.text[: _end(written)].split())

    if IDLE.search(sentence):
        yield from ((one, S.Zero) for one in scene.input_symbols)
    for chain in EQUAL.finditer(text):
        same = [one for name in chain["names"].split("=") if (one := symbol(name.strip()))]
        yield from ((one, same[0]) for one in same[1:])
    for one in GIVEN.finditer(text):
        for name in (one["name"], *one["more"].replace("\\", "").split("=")):
            if (own := symbol(name.strip())) is not None:
                yield own, Rational(one["value"])
