"""What a model of Modelica says of the begin: where a motion begins, or what a name is.

initial equation
  theta = 0.1; der(theta) = 0;       where a motion begins: no equation of it, nor is what it
                                     says of names of which equations say what they are
  r = 2*R;                           what the parameter r(fixed = false) is: a definition
"""

import re
from collections.abc import Iterator

from mechanics.program.c.tokens import blanked

INITIAL = re.compile(
    r"\binitial[ \t]+(?P<kind>equation|algorithm)\b(?P<body>.*?)"
    r"(?=^[ \t]*(?:(?:initial[ \t]+)?(?:equation|algorithm)|end|public|protected|annotation)\b|\Z)",
    re.MULTILINE | re.DOTALL,
)
STATEMENT = re.compile(r"[^;]+;?")
EQUATION = re.compile(r"^[ \t]*(?:initial[ \t]+)?(?:equation|algorithm)\b", re.MULTILINE)
RATE = re.compile(r"\bder[ \t]*\([ \t]*(\w+)[ \t]*\)")
SOLE = re.compile(
    r"(?:^|;)[ \t]*(\w+)[ \t]*=(?!=)|\bder[ \t]*\([ \t]*\w+[ \t]*\)[ \t]*=[ \t]*(\w+)[ \t]*;",
    re.MULTILINE,
)
"""A name that an equation says: a = F/m; der(v) = a."""
ASSIGNED = re.compile(r"\b([^\W\d]\w*)[ \t]*:=")
ALGORITHM = re.compile(
    r"^[ \t]*(?:initial[ \t]+)?algorithm\b.*?"
    r"(?=^[ \t]*(?:(?:initial[ \t]+)?(?:equation|algorithm)|end|public|protected|annotation)\b|\Z)",
    re.MULTILINE | re.DOTALL,
)


def definitions_of_begin(text: str) -> Iterator[tuple[str, str]]:
    """Statements of initial sections that are no begin of a motion, and of which section.

    Parameters
    ----------
    text : str
        Of a model, without comments and strings.
    """
    moving = _moving(text)
    for section in INITIAL.finditer(text):
        for one in STATEMENT.findall(section["body"]):
            if one.strip("; \t\r\n") and not _begins(one, moving):
                yield section["kind"], " ".join(one.strip("; \t\r\n").split())


def assigned_again(text: str) -> tuple[str, ...]:
    """Names that algorithms assign more than once.

    Parameters
    ----------
    text : str
        Of a model, without comments and strings.
    """
    names = ASSIGNED.findall(text)
    return tuple(name for name in dict.fromkeys(names) if names.count(name) > 1)


def without_begin(text: str) -> str:
    """The text, place by place, without where a motion begins; assignments are equations.

    A name that an algorithm assigns twice keeps its ``:=``, which is not read.
    """
    moving = _moving(text)

    def kept(section: re.Match[str]) -> str:
        head = blanked(section[0][: section.start("body") - section.start()])
        return head + STATEMENT.sub(
            lambda m: blanked(m[0]) if _begins(m[0], moving) else m[0], section["body"]
        )

    text = ALGORITHM.sub(lambda m: _equated(m[0], text), text)
    return INITIAL.sub(kept, text)


def _moving(text: str) -> set[str]:
    """Names that have rates, or that equations say."""
    start = EQUATION.search(text)
    rest = INITIAL.sub(" ", text[start.start() :]) if start else ""
    return {*RATE.findall(text)} | {name for pair in SOLE.findall(rest) for name in pair if name}


def _begins(statement: str, moving: set[str]) -> bool:
    sides = re.split(r":=|=", statement.strip("; \t\r\n"))
    return bool({RATE.sub(r"\1", side.strip()) for side in sides} & moving)


def _equated(algorithm: str, text: str) -> str:
    """An algorithm whose assignments of names that it assigns once are equations."""
    again = assigned_again(text)
    return ASSIGNED.sub(lambda m: m[0] if m[1] in again else m[0].replace(":=", " ="), algorithm)
