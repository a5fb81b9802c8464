r"""What LaTeX does not print: comments, verbatim text, and what stands between conditions.

    a = b  % c        \iffalse a = b \fi        \begin{comment} a = b \end{comment}

    50 % of it: $a = b$        in a page of Markdown or a cell a percent sign is one

It is blanked: no character moves, so that messages name the right place.
"""

import re
from collections.abc import Iterator

from mechanics.claims.place import Refused
from mechanics.program.c.tokens import blanked

COMMENT = re.compile(r"(?<!\\)((?:\\\\)*)%(?P<words>[^\n]*)")
PERCENT = re.compile(r"(?<!\\)((?:\\\\)*)%")
SIGN = "\uff05"
"""What stands for a percent sign that begins no comment."""
SOURCE = re.compile(r"^[^%\n]*\\(?:documentclass|(?:begin|end)\s*\{document\})", re.MULTILINE)
"""What only a document in LaTeX has."""
HIDDEN = re.compile(
    r"\\begin\s*\{(?P<env>comment|verbatim\*?|Verbatim|lstlisting|minted|filecontents\*?)\}"
    r"(?P<inside>.*?)(?:\\end\s*\{(?P=env)\}|\Z)"
    r"|\\(?:verb|lstinline|mintinline\s*\{\w+\})\*?(?P<mark>[^\sA-Za-z*{])(?P<short>[^\n]*?)(?P=mark)"
    r"|\\(?:end\s*\{document\}|endinput(?![A-Za-z])).*",
    re.DOTALL,
)
UNPRINTED = ("comment", "filecontents", "filecontents*")
KEPT = re.compile(
    r"\\begin\s*\{(?P<env>verbatim\*?|Verbatim|lstlisting|minted|filecontents\*?)\}"
    r".*?(?:\\end\s*\{(?P=env)\}|\Z)|\\(?:verb|lstinline)\*?(?P<mark>[^\sA-Za-z*{])[^\n]*?(?P=mark)",
    re.DOTALL,
)
"""What is hidden from the reader of formulas alone, or is a file of its own."""
OPTIONS = re.compile(r"\s*(?:\[[^\]]*\])?(?:\{\w*\})?")
CONDITION = re.compile(r"(?<!\\)\\(if(?!f(?![A-Za-z@]))[A-Za-z@]*|else|fi|unless)(?![A-Za-z@])")
BODY = re.compile(r"\\begin\s*\{document\}")


def is_source(text: str) -> bool:
    """Whether a text is a document in LaTeX, not a page with formulas in it."""
    return SOURCE.search(text) is not None


def without_comments_in_prose(text: str, formulas: Iterator[tuple[int, int]]) -> str:
    """A page in which a percent sign begins a comment in formulas alone, place by place.

    Parameters
    ----------
    formulas : iterator of (int, int)
        Where they stand in order, in `as_signs` of the text.
    """
    signs, out, at = as_signs(text), "", 0
    for start, end in formulas:
        out += signs[at:start] + text[start:end]
        at = end
    return out + signs[at:]


def as_signs(text: str) -> str:
    """The text without comments: all its percent signs are signs."""
    return PERCENT.sub(lambda m: f"{m[1]}{SIGN}", text)


def comments(text: str) -> Iterator[str]:
    """What comments of a text say, and each line that conditions or its end leave unprinted."""
    for match in COMMENT.finditer(text):
        yield match["words"].strip("% \t")
    text = COMMENT.sub(lambda m: m[1] + " " * (len(m[0]) - len(m[1])), text)
    text = KEPT.sub(lambda m: blanked(m[0]), text)
    try:
        shown = without_hidden(text)
    except Refused:
        return  # nothing of it is read
    for line, printed in zip(text.split("\n"), shown.split("\n"), strict=True):
        pairs = zip(line, printed, strict=True)
        yield "".join(one if one != other else " " for one, other in pairs).strip()


def without_hidden(text: str) -> str:
    r"""The text with blanks for what is not printed.

    Raises
    ------
    Refused
        For a condition other than ``\iffalse`` and ``\iftrue``: what is printed is not known.
    """
    text = COMMENT.sub(lambda m: m[1] + " " * (len(m[0]) - len(m[1])), text)
    text = HIDDEN.sub(lambda m: blanked(m[0]), text)
    return _decided(text) if CONDITION.search(text) else text


def verbatim(text: str) -> Iterator[tuple[int, str]]:
    """What is printed as it stands, which is no formula: its place, and its words."""
    text = COMMENT.sub(lambda m: m[1] + " " * (len(m[0]) - len(m[1])), text)
    for match in HIDDEN.finditer(text):
        if match["short"] is not None:
            yield match.start("short"), match["short"]
        elif match["env"] and match["env"] not in UNPRINTED:
            options = OPTIONS.match(match["inside"])
            at = match.start("inside") + (options.end() if options else 0)
            yield at, match.string[at : match.end("inside")]


def blank(out: list[str], start: int, end: int) -> None:
    """Put blanks in place of characters; lines stay."""
    out[start:end] = [c if c == "\n" else " " for c in out[start:end]]


def _decided(text: str) -> str:
    """The text with blanks for the branches of conditions that are not printed."""
    body = BODY.search(text)
    begins = body.end() if body else 0
    out = list(text)
    opened: list[tuple[bool, int]] = []  # whether the present branch is printed, where it begins
    for match in CONDITION.finditer(text):
        word = match[1]
        if word in ("else", "fi"):
            if not opened:
                continue
            printed, start = opened.pop()
            blank(out, match.start() if printed else start, match.end())
            if word == "else":
                opened.append((not printed, match.start()))
            continue
        known = word in ("iffalse", "iftrue")
        if not known and match.start() >= begins and all(printed for printed, _ in opened):
            words = f"the condition {match[0]} is not supported: leave what is printed"
            raise Refused(match.start(), words)
        opened.append((word != "iffalse", match.start()))
        blank(out, match.start(), match.end() if known else match.start())
    hidden = [start for printed, start in opened if not printed]
    blank(out, hidden[0] if hidden else len(out), len(out))
    return "".join(out)
