"""Numbers in C that have the name of a parameter of the scene: what is judged holds for all values.

    #define g 9.81            double f(double x) { return -g*x; }
    ->                        double f(double x, double g) { return -g*x; }

As everywhere, a value that a person gives to a parameter is not used. A name that is a parameter's
but for capitals is that parameter, where the scene has no other. Of integers (``#define l 4``,
``const int l = 4;``) it is said that they are some: C divides them otherwise.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.lines import NOT_USED
from mechanics.claims.names import Vocabulary
from mechanics.program.c.tokens import blanked
from mechanics.program.c.types import REALS

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[fF]?"
DEFINED = re.compile(
    rf"^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t]+\(?({NUMBER})\)?[ \t]*\r?$", re.MULTILINE
)
ONE = rf"(\w+)\s*=\s*({NUMBER})"
DECLARED = re.compile(
    rf"\b(?:(?:static|const)\s+)*(?P<kind>double|float|int)\s+(?:const\s+)?"
    rf"(?P<ones>{ONE}(?:\s*,\s*{ONE})*)\s*;"
)
WHOLE = re.compile(r"[-+]?\d+")
HEAD = re.compile(r"\b(double|float|void|int)\s+(\w+)\s*\(([^(){};]*)\)\s*\{")


@dataclass(frozen=True)
class Passed:
    """A file whose numbers for parameters are arguments.

    Attributes
    ----------
    text : str
        Without comments.
    notes : tuple of str
        What is to be said of the names.
    integers : dict of str to int
        Those that are integers in C, with their values.
    """

    text: str
    notes: tuple[str, ...] = ()
    integers: dict[str, int] = field(default_factory=dict)


def with_parameters(text: str, vocabulary: Vocabulary) -> Passed:
    """The text, without comments, with such names as arguments, and what is to be said of them.

    Parameters
    ----------
    text : str
    vocabulary : Vocabulary
    """
    if not HEAD.search(text):
        return Passed(text)
    notes: dict[str, str] = {}
    integers: dict[str, int] = {}

    def passed(match: re.Match[str], pairs: list[tuple[str, str]], kind: str) -> str:
        meanings = [_parameter(name, vocabulary) for name, _ in pairs]
        if not all(meanings) or any(_assigned_again(text, name) for name, _ in pairs):
            return match[0]
        whole = {n: int(v) for n, v in pairs if kind not in REALS and WHOLE.fullmatch(v)}
        if kind == "int" and (len(whole) < len(pairs) or any(_counts(text, n) for n in whole)):
            return match[0]
        integers.update(whole)
        for (name, number), meaning in zip(pairs, meanings, strict=True):
            notes[name] = f"{name} = {number} is read as {meaning}: {NOT_USED}"
        return blanked(match[0])

    found = DEFINED.sub(lambda m: passed(m, [(m[1], m[2])], "macro"), text)
    found = DECLARED.sub(lambda m: passed(m, re.findall(ONE, m["ones"]), m["kind"]), found)
    if not notes:
        return Passed(text)
    return Passed(_passed(found, list(notes)), tuple(notes.values()), integers)


def _counts(text: str, name: str) -> bool:
    """Whether an integer is a size, a place or a bound of a loop."""
    return (
        re.search(rf"\[[^][]*\b{name}\b|\bfor\s*\([^{{}}]*?\b{name}\b[^{{}}]*?\)", text) is not None
    )


def _passed(text: str, names: Sequence[str]) -> str:
    """Functions that read variables without a value, with these as arguments."""
    own = ", ".join(f"double {name}" for name in names)
    calls = [
        re.compile(rf"\b{m[2]}\s*\(([^()]*(?:\([^()]*\)[^()]*)*)\)") for m in HEAD.finditer(text)
    ]
    pieces, at = [], 0
    for match in HEAD.finditer(text):
        arguments = ", ".join(filter(None, (match[3].strip(), own)))
        pieces += [_called(text[at : match.start()], calls, names)]
        pieces += [f"{match[1]} {match[2]}({arguments}) {{"]
        at = match.end()
    return "".join((*pieces, _called(text[at:], calls, names)))


def _called(text: str, functions: list[re.Pattern[str]], names: Sequence[str]) -> str:
    """Calls of functions of the file with these names passed on."""
    passed = ", ".join(names)
    for function in functions:
        text = function.sub(lambda m: f"{m[0][:-1]}{', ' if m[1].strip() else ''}{passed})", text)
    return text


def _parameter(name: str, vocabulary: Vocabulary) -> str:
    """The parameter of the scene that a name is, or a step of time; empty for none."""
    meaning = vocabulary.parameter(name)
    unknown = not meaning and vocabulary.lookup(name) is None
    return "a step of time" if unknown and name in STEPS and name != "h" else meaning


def _assigned_again(text: str, name: str) -> bool:
    """Whether it is assigned more than once, or is an argument somewhere."""
    changes = re.findall(rf"\b{name}\s*(?:[-+*/]?=(?!=)|\+\+|--)|(?:\+\+|--|&)\s*{name}\b", text)
    argument = re.search(rf"\b(?:double|float)\s+{name}\s*[,)]", text)
    return len(changes) > 1 or argument is not None
