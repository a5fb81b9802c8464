r"""Names of which a text says something that is not read: nobody guesses what they mean.

r := 2*R     \xrightarrow{q = \theta/2}     [d, w] = deal(2*R, u)     % l_p = l/2

A line that is not read names all that it holds; what is no part of the formulas, as a comment, what
it gives a value that is no number and no words.
"""

import re
from collections.abc import Iterator, Sequence

from mechanics.claims.lines import Entry, Unread
from mechanics.claims.names import Naming
from mechanics.claims.place import line_and_column
from mechanics.claims.spelled_rates import key
from mechanics.claims.text.letters import plain

FONT = re.compile(
    r"\\(?:mathrm|mathbf|mathit|mathsf|text(?:rm|it)?|operatorname|rm)(?![A-Za-z])\s*(?:\{([^{}]*)\})?"
)
NAME = re.compile(r"\\?[^\W\d_]+(?:\d+(?!\w))?(?:_\s*(?:\{[^{}]*\}|\\?[^\W_]+))*")
LETTER = re.compile(r"(?<!\\)(?<![^\W_])[^\W\d_]{2,}(?P<low>(?:_\s*(?:\{[^{}]*\}|\w))?)")
"""In LaTeX letters side by side are a product, of which the last one has the subscript."""
SIGNS = (
    r":=|\u2254|\u2255|=:|[-+*/]=|<-|\u2190|\u2192|\u2250|\u225c|\u225d|\u2261|\u2259|==?(?!>)"
    r"|\\(?:leftarrow|gets|coloneqq|triangleq|equiv|doteq|to|rightarrow|mapsto)(?![A-Za-z])|\u2236="
)
BEGINS = r"(?:(?<![^\W\d_])|(?=[^\w\s]))"
"""No name begins within a word."""
GIVEN = re.compile(rf"{BEGINS}(?P<name>{NAME.pattern})\s*(?:{SIGNS})\s*(?P<value>[^=;,\n]*)")
GIVES = re.compile(
    rf"{BEGINS}(?:\(?\[?)(?P<names>{NAME.pattern}(?:\s*,\s*{NAME.pattern})*)[\])]?"
    r"(?:\([^=]*\)|\[[^=]*\])?\s*(?:\\mathrel\s*\{\s*)?"
    rf"(?:{SIGNS}|\\(?:wide)?hat\s*\{{?=|\\(?:overset|stackrel|mathrel)\b)"
)
"""What a line that is not read gives a value to."""
SET = re.compile(r":=|\u2254|[-+*/]=|<-|\u2190|\u2236=|\\(?:leftarrow|gets|coloneqq)(?![A-Za-z])")
"""What gives a name another value, of whatever it has been."""
DECORATED = re.compile(r"\\(?:vec|hat|bar|tilde|mathbf|boldsymbol|bm)\s*\{([^{}]*)\}")
RATED = re.compile(rf"\\d{{1,4}}ot\s*(?:\{{\s*{NAME.pattern}\s*\}}|{NAME.pattern})")
ALONE = re.compile(rf"(?:{SIGNS})\s*(?P<name>{NAME.pattern})\s*(?:\([^=()]*\))?\s*(?=[.,;:&=]|\Z)")
"""A name that stands alone to the right of a sign."""
UNIT = r"(?:[kcm]?m|k?g|m?s|k?N|J|rad|deg|W|Pa|Hz)(?:\^?-?[1-4]|\*\*-?[1-4])?"
MEASURED = re.compile(
    rf"\bin\s+(?:{UNIT}|sec)(?:\s*[*/]\s*\(?\s*(?:{UNIT}|sec)(?:\s*\^\s*-?\d)?\s*\)?)*(?![\w(])"
)
"""In which unit something is."""
RELATES = re.compile(rf"{SIGNS}|[<>~\u2248\u2243]|\\(?:approx|simeq|sim|ll|gg|leq?|geq?|propto)\b")
IS = re.compile(
    rf"(?P<name>{NAME.pattern})\s*[$)\]}}]*\s*"
    r"(?::|(?<=\s)(?:is|are|be|being|as|equals?|means?|denotes?|stands?)\b)",
    re.IGNORECASE,
)
"""A name of which words say what it is."""
PARTS = re.compile(r"\b(?:half|halves|twice|double|thirds?|square|negative|times|sum)\b", re.I)
COUNTS = re.compile(r"[\d*/^+\\-]")
"""What makes of names something else than a word."""
NUMBER = re.compile(
    rf"\s*[-+]?[\d.]+(?:[eE][-+]?\d+)?(?:\s+{UNIT}(?:[ */.]{{1,3}}{UNIT})*)?[\s.]*"
    rf"|\s*[-+]?[\d.]+\s*\[{UNIT}(?:[ */.]{{1,3}}{UNIT})*\][\s.]*"
)
"""With a unit; 2m may be twice a mass."""
WORDS = re.compile(r"\s*(?:(?:a|an|the)\s+\w|[a-z]{3,}(?:[ \t]+[a-z]{2,}|\s*$))", re.IGNORECASE)


def unread_names(
    lines: Sequence[Entry], beside: Sequence[tuple[int, str]], text: str
) -> dict[str, str]:
    """Keys of names that are said something of which is not read, and where.

    Parameters
    ----------
    beside : sequence of (int, str)
        What is no part of the formulas: its place in the text, and its words.
    """
    found: dict[str, str] = {}
    for line in lines:
        if isinstance(line, Unread):
            where = f"line {line_and_column(text, line.at)[0]}"
            for name in mentioned(line.source):
                found.setdefault(name, where)
    for at, words in beside:
        for name in assigned_names(words):
            found.setdefault(name, f"line {line_and_column(text, at)[0]}")
    return found


def assigned_names(words: str) -> Iterator[str]:
    """Keys of the names that words give a value which is no number and no words."""
    for match in GIVEN.finditer(words):
        if not (NUMBER.fullmatch(match["value"]) or WORDS.match(match["value"])):
            yield _key(match["name"])
            yield from mentioned(match["value"])


def mentioned(source: str) -> Iterator[str]:
    """Keys of the names in a formula that is not read."""
    source = FONT.sub(r" \1", source)
    for match in NAME.finditer(source):
        yield _key(match[0])
    if "\\" in source:
        for match in LETTER.finditer(source):
            letters = match[0].removesuffix(match["low"])
            yield from letters[:-1]
            yield _key(letters[-1] + match["low"])


def reassigned_names(lines: Sequence[Entry], naming: Naming) -> set[str]:
    """Keys of names that a line which is not read gives a value to.

    A coordinate = ... may be its motion, or an equation; one that is set is another one.
    """
    found: set[str] = set()
    for line in lines:
        if isinstance(line, Unread):
            source = FONT.sub(r" \1", line.source)
            for match in GIVES.finditer(source):
                assigned = {_key(one) for one in NAME.findall(match["names"])}
                anew = SET.search(match[0]) is not None
                found |= {n for n in assigned if anew or not naming.is_function(n)}
    return found


def possibly_assigned_names(source: str) -> set[str]:
    """Keys of names that a formula which is not read may give a value to, whatever they are.

    A rate that is given is none.
    """
    source = FONT.sub(r" \1", DECORATED.sub(r" \1 ", RATED.sub(" ", source)))
    found = {_key(one) for match in GIVES.finditer(source) for one in NAME.findall(match["names"])}
    return found | {_key(match["name"]) for match in ALONE.finditer(source)}


def described_names(source: str) -> set[str] | None:
    """Keys of names of which words say what they are; None where a sign relates names.

    where l is 2*R    ->    l          where tau is torque in N * m    ->    none
    """
    words = MEASURED.sub(" ", source)
    if RELATES.search(words):
        return None
    if PARTS.search(words):
        return {*mentioned(words)}
    if not COUNTS.search(words):
        return set()
    return {_key(match["name"]) for match in IS.finditer(words)}


def _key(name: str) -> str:
    return key("".join(plain(part)[0] for part in re.findall(r"\w", name)))
