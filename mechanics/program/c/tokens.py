"""The tokens of a C source, line by line, comments taken out."""

import re
from collections.abc import Iterator
from itertools import accumulate, pairwise

from mechanics.errors import ExpressionError

TOKEN = re.compile(
    r"""(?P<space>[ \t\f\v\r]+) | (?P<newline>\n)
      | (?P<comment>/\*.*?\*/|//[^\n]*)
      | (?P<string>"(?:\\.|[^"\\\n])*") | (?P<char>'(?:\\.|[^'\\\n])*')
      | (?P<number>\.?\d(?:[eEpP][+-]|[\w.])*)
      | (?P<name>[A-Za-z_]\w*)
      | (?P<punctuation><<=|>>=|\.\.\.|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|\#\#
        |[][(){}.&*+\-~!/%<>^|?:;=,\#])""",
    re.VERBOSE | re.DOTALL,
)


ODD = re.compile(r"[\x00-\x08\x0d-\x1f\x7f]")
"""A carriage return alone, an end of file."""
WORD = re.compile(r"\w\w|[^\w\s]{2}|\d\.|\.\d|[eEpP][-+]")
"""What may be one token of C, or the end of a comment, where a line is joined."""

JOINED = re.compile(r"\\\r?\n")

Line = list[tuple[str, str]]
"""Tokens as (kind, text)."""


def tokens(text: str, file: str) -> Line:
    """(kind, text) of every token, comments as the blanks and ends of lines that they cover.

    Raises
    ------
    ExpressionError
        For a character that C does not have.
    """
    if "??" in text:
        raise ExpressionError(f"{file}: '??' may begin a trigraph: write it apart")
    pieces = text.replace("\r\n", "\n").split("\\\n")
    if any(re.search(r"\\[ \t\f\v\r]+\n", piece) for piece in pieces):
        raise ExpressionError(f"{file}: blanks stand behind a \\ that ends a line: remove them")
    if odd := ODD.search(text.replace("\r\n", "\n")):
        raise ExpressionError(
            f"{file}: the character {odd[0]!r} ends a line, or the file, for some compilers only:"
            " remove it"
        )
    if any(WORD.search(f"{a[-1:]}{b[:1]}") for a, b in pairwise(pieces)):
        raise ExpressionError(f"{file}: a \\ joins two lines within a word: put a blank before it")
    # Where lines are joined: what follows the next end of line keeps its number.
    joints = list(accumulate(len(piece) + 1 for piece in pieces[:-1]))
    text = " ".join(pieces)
    found: Line = []
    at = 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if match is None:
            line = sum(k == "newline" for k, _ in found) + 1
            raise ExpressionError(f"{file}:{line}: {text[at]!r} is no token of C")
        kind, token = str(match.lastgroup), match.group()
        if kind == "comment":
            found += [("newline", "\n")] * token.count("\n") or [("space", " ")]
        else:
            found.append((kind, token))
        at = match.end()
        if kind == "newline" or "\n" in token:
            passed = sum(joint <= at for joint in joints)
            found += [("newline", "\n")] * passed
            del joints[:passed]
    return found


def comments(text: str, file: str) -> Iterator[tuple[int, str]]:
    """Number of the first line, and text, of every comment.

    Raises
    ------
    ExpressionError
        For a character that C does not have.
    """
    at, line = 0, 1
    while at < len(text):
        match = TOKEN.match(text, at) or JOINED.match(text, at)
        if match is None:
            raise ExpressionError(f"{file}:{line}: {text[at]!r} is no token of C")
        if match.lastgroup == "comment":
            yield line, match.group()
        line += match.group().count("\n")
        at = match.end()


def touching(line: Line) -> bool:
    """Whether a bracket touches the name that is defined, which makes it a macro with arguments."""
    names = [i for i, (kind, _) in enumerate(line) if kind == "name"]
    after = line[names[1] + 1][1:] if len(names) > 1 and names[1] + 1 < len(line) else ("",)
    return after[0] == "("


def lines(found: Line) -> list[Line]:
    """Tokens of each line."""
    result: list[Line] = [[]]
    for token in found:
        if token[0] == "newline":
            result.append([])
        else:
            result[-1].append(token)
    return result


def blanked(text: str) -> str:
    """Blanks in place of a text, on as many lines: what stands behind it keeps its place."""
    return re.sub(r"[^\n]", " ", text)
