"""Factors side by side: a product sign of no width where two operands meet.

    1/2 (m + M) x'^2 g    ->    1/2 . (m + M) . x'^2 . g        mgcos(a)    ->    m . g . cos(a)

What stands behind a function without brackets is its argument, and stays: cos w t.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache

from lark import Token

from mechanics.claims.functions import FUNCTIONS
from mechanics.claims.names import Naming
from mechanics.claims.place import Refused
from mechanics.claims.text.declarations import HEADER
from mechanics.claims.text.letters import plain

BESIDE = "BESIDE"
ENDS = frozenset(("NUMBER", "NAME", "RPAR", "PRIME", "SUPERSCRIPT", "CLOSING", "LEIBNIZ"))
STARTS = frozenset(("NUMBER", "NAME", "LPAR", "FUNCTION", "RAISED", "OPENING", "LEIBNIZ"))
ALONE = frozenset((("NAME", "LPAR"), ("PRIME", "LPAR"), ("NUMBER", "NUMBER")))
"""f(x) is a call or a product; x'(t) is neither, and 2 3 is a misprint."""
FREE = ("FUNCTION", "RAISED")
PERIODIC = ("sin", "cos", "tan", "sqrt")
"""What may stand in a word without a bracket: mglcos(theta)."""
OPEN, CLOSED = ("LPAR", "LSQB"), ("RPAR", "RSQB")
WORDS = frozenset((
    "function", "model", "end", "if", "else", "elseif", "for", "while", "return", "in", "is", "the",
    "and", "or", "of", "let", "so", "then", "by", "at", "we", "where", "with", "begin", "import",
    "from", "Real", "Integer", "Boolean", "parameter", "constant",
))  # fmt: skip
"""Of a language: what stands beside them is no factor."""
BEGINS = re.compile(r"[^\W\d_]")
"""Of a factor: no factor begins with a number, or with a dot above a letter."""
LONGEST = 40
TOGETHER = "sincos"
"""Of Julia: the sine and the cosine."""
DEFINED = re.compile(r"(?:^|[;,:])[ \t]*(\w+)[ \t]*(?:\(t\)[ \t]*)?=", re.MULTILINE)
"""What stands alone before an equals sign: of m g + mga = 0 nothing does."""


def with_products(
    tokens: Sequence[Token], letters: Callable[[str], list[str]], constant: Callable[[str], bool]
) -> list[Token]:
    """The tokens, a `BESIDE` between operands, and runs of letters apart.

    Parameters
    ----------
    tokens : sequence of Token
        Of the text grammar.
    letters : callable
        The names that a word is made of: one, or those of a product.
    constant : callable
        Whether a name is that of a constant, which is no function of what stands behind it.

    Raises
    ------
    Refused
        Where a number may be a factor or count a line: 2. x.
    """
    apart = list(_apart(tokens, letters))
    found: list[Token] = []
    depth, free = 0, -1  # at which depth a function without brackets takes what stands beside it
    for i, token in enumerate(apart):
        before = apart[i - 1] if i else None
        meet = before is not None and (_meet(apart, i) or _below(apart, i, constant))
        if meet and not (free == depth and token.type != "LPAR"):
            at = token.start_pos
            if before is not None and before.type == "NUMBER" and before.endswith("."):
                words = f"{before} may be a factor or count the line: write {before}0*{token}"
                raise Refused(int(before.start_pos or 0), words)
            found.append(
                Token(BESIDE, "", at, token.line, token.column, token.line, token.column, at)
            )
        if token.type in CLOSED:
            depth -= 1
        if depth < free or (depth == free and token.type in ("PLUS", "TIMES", "COMMA", "_EQUALS")):
            free = -1
        if token.type == "_END":
            depth, free = 0, -1
        behind = apart[i + 1].type if i + 1 < len(apart) else ""
        if token.type in FREE and behind != "LPAR":
            free = depth
        depth += token.type in OPEN
        found.append(token)
    return found


def _apart(tokens: Sequence[Token], letters: Callable[[str], list[str]]) -> Iterator[Token]:
    for i, token in enumerate(tokens):
        parts = letters(str(token)) if token.type == "NAME" else [str(token)]
        if len(parts) < 2:
            yield token
            continue
        called = i + 1 < len(tokens) and tokens[i + 1].type == "LPAR"
        at, column = int(token.start_pos or 0), int(token.column or 1)
        for part in parts:
            kind = "FUNCTION" if part in FUNCTIONS and not called else "NAME"
            end, last = at + len(part), column + len(part)
            yield Token(kind, part, at, token.line, column, token.end_line, last, end)
            at, column = end, last


def _meet(tokens: Sequence[Token], i: int) -> bool:
    """Whether a factor ends before a token, and another one begins with it."""
    before, token = tokens[i - 1], tokens[i]
    if before.type not in ENDS or token.type not in STARTS:
        return False
    if {str(before), str(token)} & WORDS:
        return False
    if (before.type, token.type) == ("NUMBER", "NAME"):
        # 2x is one factor, 2 x two of them, and in x^2y no factor begins with the 2.
        above = [t.type for t in tokens[max(i - 3, 0) : i - 1]]
        raised = above[-1:] == ["POWER"] or above == ["POWER", "PLUS"]
        return raised or before.end_pos != token.start_pos
    return (before.type, token.type) not in ALONE


def _below(tokens: Sequence[Token], i: int, constant: Callable[[str], bool]) -> bool:
    """Whether a bracket stands behind a constant that a slash divides by: k/m (r - l)."""
    if i < 2 or tokens[i].type != "LPAR" or tokens[i - 1].type != "NAME":
        return False
    return tokens[i - 2] == "/" and constant(plain(str(tokens[i - 1]))[0])


@lru_cache(maxsize=64)
def _defined(text: str) -> frozenset[str] | None:
    """Names before an equals sign; None of a program. Each line of a text asks for those of all."""
    return None if HEADER.search(text) else frozenset(DEFINED.findall(text))


def letters_of(naming: Naming, text: str) -> Callable[[str], list[str]]:
    """What splits words: mgl is m g l where these are names, and the text says nothing of mgl.

    In a program no word is a product: f(t, xx) has an argument xx, whatever x is in the scene.

    Parameters
    ----------
    naming : Naming
    text : str
        What stands before an equals sign in it is a name.
    """
    defined = _defined(text)
    if defined is None:
        return lambda word: [word]

    def letters(word: str) -> list[str]:
        if (
            word in FUNCTIONS
            or word == TOGETHER
            or word in defined
            or word in naming.own
            or naming.knows(word)
        ):
            return [word]
        return _fewest(word, means) or [word]

    def means(part: str) -> bool:
        name, _ = plain(part)
        return name in PERIODIC or naming.knows(name) or name in naming.own

    return letters


def _fewest(word: str, means: Callable[[str], bool]) -> list[str]:
    """The fewest names that a word is made of, the last of which is no function of nothing."""
    if len(word) > LONGEST:
        return []
    starts = [i for i in range(len(word)) if BEGINS.match(word, i)]
    best: dict[int, list[str]] = {len(word): []}
    for start in reversed(starts):
        ends = [end for end in (*starts, len(word)) if end > start and end in best]
        found = [[word[start:end], *best[end]] for end in ends if means(word[start:end])]
        if found:
            best[start] = min(found, key=len)
    return best.get(0, [])
