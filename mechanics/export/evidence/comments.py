"""Comments and headers: who embeds reads the order, unit and meaning of entries there.

    scene derived again, graphs  --printed once more-->  comments  =  comments of the folder

Layout is free, words are not. A row of a table, ``p[0]  L  m  length``, says what the physics says
or is refuted: another value is false. Other sentences are this version's words, and where one
differs or is missing nothing shows what is said. A comment that somebody added is his note, and the
changed hash names the file; one that speaks of entries of arrays is shown by nothing.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from difflib import SequenceMatcher
from typing import NamedTuple

from mechanics.errors import ExpressionError
from mechanics.kernel import Finding, refuted, same, undecided
from mechanics.program.c.tokens import comments, lines, tokens

ROW = re.compile(r"\w+\[[^\]]*\]:?\s|\d\s|\w+ = ")
"""``p[0] L``, ``ud_q[i + 2 * j]:``, a status, the value of a fixed parameter."""
ENTRY = re.compile(r"\w\[")
LONGEST = 100
"""Characters of a line that are repeated."""


END = 0, "the end of the file"


class Comment(NamedTuple):
    """One comment: its words, and for each the number and text of its line."""

    words: tuple[str, ...]
    lines: tuple[tuple[int, str], ...]


def prove_comments(
    texts: Mapping[str, str], wanted: Mapping[str, str], physics: bool
) -> Iterator[Finding]:
    """Decide about the comments of files.

    Parameters
    ----------
    texts : mapping of str to str
        Files as they stand in the folder, by name.
    wanted : mapping of str to str
        The same as they are printed once more; files that are not in the folder are passed over.
    physics : bool
        Whether that is from a scene that was derived again; else it is from the manifest.
    """
    for file, again in wanted.items():
        if file not in texts:
            continue
        try:
            here, there = _comments(texts[file], file), _comments(again, file)
        except ExpressionError as error:
            yield undecided(f"{file}: comments", f"refused: {error}")
            continue
        found = list(_differences(file, here, there, physics))
        if not found:
            words = f"{len(there)} comments are those printed"
            printed = [comment.words for comment in there]
            found = [same(f"{file}: comments", _matching(here, there), printed, words)]
        yield from found


def prove_code(wanted: Mapping[str, str], texts: Mapping[str, str]) -> Iterator[Finding]:
    """Decide whether files hold the printed tokens beside their comments.

    Parameters
    ----------
    wanted, texts : mapping of str to str
        Files as they are printed once more, and as they stand in the folder, by name.
    """
    for file, again in wanted.items():
        try:
            here, there = _code(texts.get(file, ""), file), _code(again, file)
        except ExpressionError as error:
            yield undecided(f"{file}: code", f"refused: {error}")
            continue
        ends = zip((*here, END), (*there, END), strict=False)
        own, other = next((pair for pair in ends if pair[0][1] != pair[1][1]), (END, END))
        if own is other:
            words = f"{len(there)} tokens are those printed"
            yield same(f"{file}: code", [t for _, t in here], [t for _, t in there], words)
        else:
            words = f"refused: '{own[1][:LONGEST]}' stands there, printed is '{other[1][:LONGEST]}'"
            yield undecided(f"{file}: line {own[0]}" if own[0] else f"{file}: end", words)


def _code(text: str, file: str) -> list[tuple[int, str]]:
    """Number of the line and text of each token; a directive, which ends with its line, is one."""
    found: list[tuple[int, str]] = []
    for number, line in enumerate(lines(tokens(text, file)), 1):
        plain = [token for kind, token in line if kind != "space"]
        directive = plain[:1] == ["#"]
        found += [(number, " ".join(plain))] if directive else [(number, token) for token in plain]
    return found


def _comments(text: str, file: str) -> list[Comment]:
    found: list[Comment] = []
    for first, body in comments(text, file):
        words: list[str] = []
        lines: list[tuple[int, str]] = []
        for number, line in enumerate(body.split("\n"), first):
            plain = line.strip().removeprefix("/*").removesuffix("*/").strip()
            plain = plain.removeprefix("//").removeprefix("*").strip()
            words += plain.split()
            lines += [(number, plain)] * len(plain.split())
        if words:
            found.append(Comment(tuple(words), tuple(lines)))
    return found


def _matching(here: Sequence[Comment], there: Sequence[Comment]) -> list[tuple[str, ...]]:
    """Words of the comments of a file that are printed, too; others say nothing of entries."""
    matcher = SequenceMatcher(None, [c.words for c in here], [c.words for c in there], False)
    blocks = matcher.get_matching_blocks()
    return [here[k].words for first, _, size in blocks for k in range(first, first + size)]


def _differences(
    file: str, here: Sequence[Comment], there: Sequence[Comment], physics: bool
) -> Iterator[Finding]:
    matcher = SequenceMatcher(None, [c.words for c in here], [c.words for c in there], False)
    for kind, first, last, begin, end in matcher.get_opcodes():
        if kind == "equal":
            continue
        pairs = min(last - first, end - begin)
        for own, other in zip(here[first:last], there[begin:end], strict=False):
            yield _difference(file, own, other, physics)
        for own in here[first + pairs : last]:
            if told := [row for row in own.lines if ENTRY.search(row[1])]:
                number, line = told[0]
                words = f"refused: nothing shows what this comment says: {line[:LONGEST]}"
                yield undecided(f"{file}: line {number}", words)
        for other in there[begin + pairs : end]:
            words = f"refused: the comment is missing that says: {other.lines[0][1][:LONGEST]}"
            yield undecided(f"{file}: comments", words)


def _difference(file: str, own: Comment, other: Comment, physics: bool) -> Finding:
    """The first place at which a comment differs from the printed one."""
    pairs = zip((*own.words, ""), (*other.words, ""), strict=False)
    at = next(i for i, (one, two) in enumerate(pairs) if one != two)
    number, line = own.lines[min(at, len(own.lines) - 1)]
    _, right = other.lines[min(at, len(other.lines) - 1)]
    subject, said = f"{file}: line {number}", f"'{line[:LONGEST]}'"
    if physics and ROW.match(right) and ROW.match(line):
        words = f"{said} stands there, the scene gives '{right[:LONGEST]}'"
        return refuted(subject, words, line, right)
    source = "this version writes" if physics else "the manifest gives"
    return undecided(subject, f"refused: {said} stands there, {source} '{right[:LONGEST]}'")
