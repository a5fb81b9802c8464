r"""Variants of a letter that a text uses beside it: two names, and not one.

\mathcal F  and  F        \vec r  and  r        \ell  and  l        \vartheta  and  \theta

A text that has one of them alone means the letter. No character moves: \vec r becomes \vecr.
"""

import re
from collections.abc import Iterator, Sequence

from mechanics.claims.names import Naming

LETTER = r"(?:(?P<short>(?<=\s)[A-Za-z])|\\(?P<greek>[A-Za-z]+)|\{\s*\\?(?P<braced>[A-Za-z]+)\s*\})"
STYLED = re.compile(
    r"\\(?P<font>mathcal|mathscr|mathfrak|mathbb|vec|mathbf|boldsymbol|bm|overrightarrow)\s*"
    rf"{LETTER}(?P<index>\s*_\s*(?:\w|\{{[^{{}}]*\}}))?"
)
PREFIXES = {"mathcal": "cal", "mathscr": "cal", "mathfrak": "cal", "mathbb": "cal"}
"""Of other fonts: vec."""
OTHERS = {"ell": ("l", "lsc"), **{
    f"var{name}": (rf"\{name}", f"{name}var")
    for name in ("theta", "phi", "epsilon", "rho", "sigma", "pi")
}}  # fmt: skip
NAME = re.compile(rf"(?:cal|vec)[A-Za-z]+|lsc|{'|'.join(new for _, new in OTHERS.values())}")
"""Commands of this module."""
COLUMNS = frozenset("qQ")
"""What is as a rule the column of all q_i."""
WORDS = re.compile(r"\\(?:text\w*|mathrm|mbox|operatorname|begin|end|label|tag)\s*\{[^{}]*\}")
COMMANDS = re.compile(r"\\[A-Za-z]+")


def with_variants(text: str, formulas: Sequence[str], naming: Naming) -> str:
    """The text, where a variant that stands beside a letter of the scene is a name of its own.

    Parameters
    ----------
    text : str
        In LaTeX, without comments.
    formulas : sequence of str
        Its formulas.
    naming : Naming
    """
    plain = {
        (letter, index) for formula in formulas for letter, index in _plain(formula)
        if naming.knows(f"{letter}_{index}" if index else letter)
    }  # fmt: skip
    text = STYLED.sub(lambda m: _styled(m, plain), text)
    for command, (letter, new) in OTHERS.items():
        both = any(_has(f, rf"\{command}") and _has_letter(f, letter) for f in formulas)
        if both:
            text = re.sub(rf"\\{command}(?![A-Za-z])", rf"\\{new}", text)
    return text


def _plain(formula: str) -> Iterator[tuple[str, str]]:
    """Letters of a formula that no font changes, each with its index."""
    rest = WORDS.sub(" ", STYLED.sub(" ", formula))
    for one in re.finditer(r"\\([A-Za-z]+)(\s*_\s*(?:\w|\{[^{}]*\}))?", rest):
        yield one[1], _index(one[2])
    for one in re.finditer(r"([A-Za-z])(\s*_\s*(?:\w|\{[^{}]*\}))?", COMMANDS.sub(" ", rest)):
        yield one[1], _index(one[2])


def _index(text: str | None) -> str:
    return re.sub(r"\W|_", "", text or "")


def _styled(match: re.Match[str], plain: set[tuple[str, str]]) -> str:
    letter = match["short"] or match["greek"] or match["braced"]
    index = match["index"] or ""
    new = f"\\{PREFIXES.get(match['font'], 'vec')}{letter}"
    room = len(match[0]) - len(index) - len(new)
    beside = (letter, _index(index)) in plain and letter not in COLUMNS
    if not beside or room < 0 or (room == 0 and not index and match["greek"] is None):
        return match[0]
    return new + " " * room + index


def _has(formula: str, command: str) -> bool:
    return re.search(rf"\{command}(?![A-Za-z])", formula) is not None


def _has_letter(formula: str, letter: str) -> bool:
    if letter.startswith("\\"):
        return _has(formula, letter)
    return letter in COMMANDS.sub(" ", WORDS.sub(" ", formula))
