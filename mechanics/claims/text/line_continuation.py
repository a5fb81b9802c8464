"""Sentences and lines of a plain text as statements: what goes on, and what is told beside.

    a + b             x'' = mu*F, where mu = 1/M and g = 9.81.
      - c = 0         x'' = mu*F ;        mu = 1/M ;   g = 9.81

No character moves: an end of a line becomes a blank, a word the semicolon that it stands for.
"""

import re
from itertools import islice

from mechanics.claims.brackets import pieces

WORDS = re.compile(
    r"(?:[,.:][ \t]*|(?<![ \t])[ \t]+|^)(?:(?:where|with|and)\b[:\s]*)+"
    r"(?=[^\W\d]\w*[ \t]*(?:\(t\)|'{1,3})?[ \t]*=)",
    re.MULTILINE,
)
NUMBER = r"[ \t]*=[ \t]*[-+]?(?:\d+(?:\.\d+)?|pi(?:/\d)?)(?![\w.])"
AT = rf"[^\W\d]\w*'{{0,3}}{NUMBER}"
CONDITION = re.compile(
    rf"(?:[,;][ \t]*+|(?<![ \t])[ \t]++|^)(?P<bracket>\()?(?:(?:for|at|when|if|whenever)[ \t]+{AT}"
    rf"|(?:lineari[sz]\w+[ \t]+)?(?:about|around|near)[ \t]+{AT}(?:,[ \t]*{AT})*"
    rf"|(?:with|where)[ \t]+[^\W\d]\w*'{{1,3}}{NUMBER})(?:,?[ \t]+and[ \t]+{AT})*"
    r"(?(bracket)[ \t]*\))(?=[ \t]*[.,;:]?[ \t\r]*$)",
    re.MULTILINE | re.IGNORECASE,
)
"""Where an equation holds: for theta = 0 is no equation of its own, and about r = 0, theta = 0."""
STOP = re.compile(r"(?<=[^\W\d_])\.(?=[ \t\r]*$)|(?<=[)\]'])\.(?=[ \t\r]*$)", re.MULTILINE)
NUMBERED = re.compile(
    r"(?:(?<! ) {2,}|\t[ \t]*)\((?:[A-Z]\.)?\d{1,3}(?:\.\d{1,3}){0,2}[a-z]?\)[ \t\r]*$",
    re.MULTILINE,
)
LABELLED = re.compile(
    r"^[ \t]*(?:(?:\(?\d{1,2}[a-z]?\)|[*\u2022])[ \t]+(?=[^-+*/^=\s][^\n]*=)"
    r"|[^\W\d]\w{0,20}(?:[ \t]+[^\W\d]\w{0,20}){0,3}[ \t]*:(?=[ \t]+\S[^\n]*=)"
    r"|(?=[^\n=]*\b(?:the|has|have|is|are|we|of|for|then|so|get|find)\b)"
    r"(?:[^\W\d_]{2,20}[ \t]+){3,12}(?=[^\W\d]\w*[ \t]*=)"
    r"|(?:[^\W\d_]+(?:['\u2019]s)?,?[ \t]+){1,12}(?:is|are|reads?|gives?|gets?|obtains?|becomes?"
    r"|yields?|have|find|write|that)[ \t]*[:,]?[ \t]+(?=[^\s=][^\n]*=))",
    re.MULTILINE,
)
"""A number, a name, words or a mark before an equation."""
ITEM = re.compile(r"^[ \t]*(?P<number>\d{1,2})\.?[ \t]+(?=[^-+*/^=\s][^\n]*=)", re.MULTILINE)
"""The number of an item in a list, which would be a factor without the others: 2. k*x = 0."""
DECIMAL = re.compile(r"\d,\d")
BEGINS = re.compile(r"[ \t]*(?:(?P<sign>[-+*/\u2212])|=)")
ENDS = re.compile(r"(?:[-+*/=^\u2212]|\*\*)[ \t\r]*$")


def sentences(text: str) -> str:
    """The text with semicolons for words and commas between equations, and without full stops."""
    text = CONDITION.sub(lambda m: " " * len(m[0]), text)
    text = LABELLED.sub(lambda m: " " * len(m[0]), _without_items(text))
    text = NUMBERED.sub(lambda m: " " * len(m[0]), text)
    text = WORDS.sub(lambda m: ";".ljust(len(m[0])), text)
    text = STOP.sub(" ", text)
    out = list(text)
    together = [span for line in re.finditer(r"[^\n;]+", text) for span in _together(line)]
    for i in _commas(text):
        if not DECIMAL.match(text, max(i - 1, 0)):
            out[i] = ";"
    for i in together:
        out[i] = ","
    return "".join(out)


def _without_items(text: str) -> str:
    """The text with blanks for the numbers of a list that counts from one."""
    items = [*ITEM.finditer(text)]
    numbers = [int(item["number"]) for item in items]
    if {*numbers} != {1} and numbers != [*range(1, max(len(items), 2) + 1)]:
        return text
    return ITEM.sub(lambda m: " " * len(m[0]), text)


def _commas(text: str) -> list[int]:
    """Places of commas outside of brackets."""
    return [start - 1 for start, _ in islice(pieces(text, ","), 1, None)]


def _together(line: re.Match[str]) -> list[int]:
    """Commas of ``a, b = c, d``, which are no ends: b is not c."""
    commas = _commas(line[0])
    first = line[0].find("=")
    if first < 0 or not commas or commas[0] > first:
        return []
    return [line.start() + i for i in commas]


def on_one_line(text: str, code: bool = False) -> str:
    """The text with blanks for the ends of lines within an equation.

    Parameters
    ----------
    text : str
    code : bool
        Where a line that begins with a sign is one of its own, as in MATLAB and Julia.
    """
    out = list(text)
    related = False
    held: list[int] = []  # ends of lines that lie within an equation if a relation follows
    depth = at = 0
    before = ""
    for line in text.split("\n"):
        open_ended = before.strip() and depth == 0 and not before.rstrip().endswith(";")
        begins = BEGINS.match(line) if open_ended else None
        if code and begins and begins["sign"] and not ENDS.search(before):
            begins = None
        has = "=" in line
        if begins is None and not ENDS.search(before):
            held, related = [], has
        elif begins is None or not begins["sign"] or ENDS.search(before) or related != has:
            for place in [*held, at - 1]:
                out[place] = " "
            held, related = [], related or has
        elif not has:
            held.append(at - 1)
        depth += sum((c in "([") - (c in ")]") for c in line)
        before, at = line, at + len(line) + 1
    return "".join(out)
