r"""What frames several lines: brackets that go on over their ends, braces before a system.

    [ a \\ & + b ]    ->    [ a + b ]    <-    \left[ a \right. \\ \left. + b \right]
    \left\{ \begin{aligned} a = b \\ c = d \end{aligned} \right.    ->    a = b \\ c = d

The marks are blanked: no character moves.
"""

import re

from mechanics.claims.latex.comments import blank

END = r"\\\\\*?(?:\s*\[[-+\d.]{1,9}\s?[a-z]{2}\])?"
SPACE = rf"(?:\s|&|{END}|\\q?quad(?![A-Za-z])|\\n(?:onumber|otag)(?![A-Za-z])|\{{\}}|\\[,;:!>])*"
DELIMITER = re.compile(r"\\(left|right)\s*(\\[A-Za-z]+|\\?.)")
SPLIT = re.compile(rf"\\right\s*\.{SPACE}(?:(?P<sign>[-+]){SPACE})?\\left\s*\.")
MARK = re.compile(
    rf"(?P<mark>{END}|&)|\\(?P<side>begin|end)\s*\{{(?P<env>[A-Za-z]{{1,20}}\*?)\}}"
    r"|(?P<display>\\[\[\]]|\$\$?)|(?P<open>\\\{|[({\[])|(?P<close>\\\}|[)}\]])|\\."
)
NEAR = 60
"""Characters within which an operator is looked for."""
PAIRS = {")": "(", "]": "[", "}": "{", r"\}": r"\{"}
OPERATOR = r"(?:[-+=*/]|\\cdot(?![A-Za-z])|\\times(?![A-Za-z]))"
BEFORE = re.compile(rf"(?:{OPERATOR}|[(\[]|\\\{{){SPACE}$")
BEHIND = re.compile(rf"{SPACE}{OPERATOR}")
PLACED = re.compile(r"\\begin\s*\{(?:aligned|alignedat|gathered|split|multlined)\}\s*(\[[tbc]\])")
SYSTEM = re.compile(
    r"(?:(?P<left>\\left\s*(?:\.|\\\{|\\lbrace(?![A-Za-z])))\s*)?"
    r"(?P<begin>\\begin\s*\{(?P<env>array|matrix|aligned|gathered|split|alignedat|(?<=\\left\\\{\\begin\{)align)\})"
    r"(?P<columns>\s*(?:\[[a-z]\])?\s*\{[^{}]{0,60}\})?"
    r"(?P<inside>(?:(?!\\begin\s*\{|\\end\s*\{).)*)"
    r"(?P<end>\\end\s*\{(?P=env)\})(?:\s*(?P<right>\\right\s*(?:\.|\\\}|\\rbrace(?![A-Za-z]))))?",
    re.DOTALL,
)


def on_one_line(text: str) -> str:
    """The text with blanks for frames around lines, and for ends of lines within brackets."""
    return _brackets(_halves(_systems(text)))


def _systems(text: str) -> str:
    """An array of equations is lines of equations, with or without a brace at its side."""
    out = list(text)
    for match in PLACED.finditer(text):
        blank(out, *match.span(1))
    for match in SYSTEM.finditer(text):
        if "=" not in match["inside"]:
            continue
        if match["env"] in ("array", "matrix"):
            blank(out, *match.span("begin"))
            blank(out, *match.span("end"))
            if match["columns"] and match["env"] == "array":
                blank(out, *match.span("columns"))
        if match["left"] and match["right"]:
            blank(out, *match.span("left"))
            blank(out, *match.span("right"))
    return "".join(out)


def _halves(text: str) -> str:
    r"""A bracket that is closed by nothing, and opened again by nothing, goes on."""
    out = list(text)
    opened: list[str] = []
    passed = 0
    for match in DELIMITER.finditer(text):
        if match.start() < passed:
            continue
        if match[1] == "left":
            opened.append(match[2])
            continue
        again = SPLIT.match(text, match.start()) if match[2] == "." else None
        if again and opened and opened[-1] != ".":
            blank(out, *again.span())
            if again["sign"]:
                out[again.start("sign")] = again["sign"]
            passed = again.end()
        elif opened:
            opened.pop()
    return "".join(out)


def _brackets(text: str) -> str:
    """Ends of lines and marks of columns within brackets, beside an operator, mean nothing."""
    out = list(text)
    opened: list[tuple[str, list[tuple[int, int]]]] = []
    for match in MARK.finditer(text):
        if match["mark"]:
            if opened and opened[-1][0] in ("(", "[", r"\{"):
                opened[-1][1].append(match.span())
        elif match["display"]:
            opened.clear()
        elif match["side"] == "begin":
            opened.append((match["env"], []))
        elif match["side"]:
            while opened and opened.pop()[0] != match["env"]:
                pass
        elif match["open"]:
            opened.append((match["open"], []))
        elif match["close"]:
            if not opened or opened[-1][0] != PAIRS[match["close"]]:
                # A prose bracket or an interval, that no line ends in.
                while opened and opened[-1][0] in "([{":
                    opened.pop()
                continue
            for start, end in opened.pop()[1]:
                before, behind = text[max(0, start - NEAR) : start], text[end : end + NEAR]
                if BEFORE.search(before) or BEHIND.match(behind):
                    blank(out, start, end)
    return "".join(out)
