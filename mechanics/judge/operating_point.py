r"""Whether a text means an equation to first order, and about which angles.

Linearized about $\theta = \pi$    theta = pi        near the upper equilibrium    by the scene
For small angles                   theta = 0         in contrast to small angles   hedged
"""

import re
from dataclasses import dataclass

from sympy import Expr, Integer, Rational, S, Symbol, pi

from mechanics.claims.claim import Written
from mechanics.claims.directions import Counted, counted
from mechanics.claims.kinds import angular
from mechanics.claims.prose import ENDS
from mechanics.claims.tree import Table
from mechanics.scene import Scene

ANGLE = r"\\?(?:(?:var)?theta|(?:var)?phi|alpha|beta|psi|q)"
COORDINATES = rf"(?:\$?\w+\$?(?:,|,?\s+and)\s+)?\$?{ANGLE}"
"""An angle, or another coordinate and an angle."""
SAID = re.compile(
    rf"small[ -]+(?:angle|oscillation|amplitude|displacement|motion|pitch|roll|{COORDINATES})"
    rf"|{ANGLE}(?:_\{{?\w+\}}?)?\$?\s+(?:(?:is|are|stays?|remains?)\s+)?small\b"
    r"|(?<!non)(?<!non[- ])(?:lineari[sz]|linear (?:model|equation|approximation))|to first order"
    r"|\\sin\s*\{?\\?\w+\}?\s*\\(?:approx|simeq)",
    re.IGNORECASE,
)
"""What says that equations are meant to first order."""
DENIED = re.compile(r"\b(?:not?|nor|never|without|before|cannot)\b|n't\b", re.IGNORECASE)
"""What says that they are not, in the same sentence."""
FULL = re.compile(
    r"\b(?:non-?\s?linear|full|exact|complete|original|unapproximated)\s+"
    r"(?:(?!lineari)\w+\s+){0,3}?(?:equations?|models?|systems?|dynamics|motion|form)\b",
    re.IGNORECASE,
)
"""What says that an equation is meant as it stands."""
CALLED = re.compile(
    r"(?<!non)(?<!non[- ])\blinear(?:i[sz]ed)?\s+(?:(?!equation|model)\w+\s+){0,2}?"
    r"(?:equations?|models?|systems?|dynamics|form|approximation)(?:\s+of\s+(?:the\s+)?\w+)?\s*"
    r"(?:is|are|reads?|becomes?|follows?|here)?\s*:?[\s$\\(\[]*\Z",
    re.IGNORECASE,
)
"""What the formula behind it is called."""
HEDGED = re.compile(
    r"\b(?:unlike|contrast|contrary|fail\w*|beyond|exact\w*|exclud\w+|useless|invalid|large"
    r"|special case|nowhere|instead|rather|arbitrary|generally|in general|whereas"
    r"|(?:any|all) angles?)\b",
    re.IGNORECASE,
)
"""What says, beside it, that another equation may be meant so."""
BEHIND = re.compile(r"(?:\$|\\\]|\\end\{\w+\*?\})\s+(?=[A-Z])")
"""Where a sentence begins behind a formula without a full stop."""

PLACE = re.compile(
    r"\b(?:about|around|near|close to|(?:vicinity|neighbou?rhood) of|lineari[sz]\w+ at)\s+"
    r"(?P<place>(?:[^.;:]|\.(?=\d))+)",
    re.IGNORECASE,
)
AT = re.compile(r"\b(?:at|where|for)\s+(?P<place>(?:[^.;:]|\.(?=\d))+)", re.IGNORECASE)
VERTICAL = re.compile(
    r"\b(?:upper|upright|upwards?|top|highest|inverted|lower|lowest|downwards?|bottom|hanging)\s+"
    r"(?:(?:un)?stable\s+|vertical\s+)?"
    r"(?:equilibri\w*|positions?|point|vertical|state|configuration|pendulum|one)\b"
    r"|\b(?:about|around|near|at)\s+(?:the\s+|its\s+)?"
    r"(?:upper|upright|upward|top|highest|inverted|lower|lowest|downward|bottom|hanging)\b"
    r"(?!\s+(?:mass|rod|bob|link|end|spring|dis[ck]|body|arm)\b)",
    re.IGNORECASE,
)
"""One of two vertical places; the lower mass is none."""
UNSTABLE = re.compile(r"\bunstable (?:equilibri|position|point|vertical)\w*", re.IGNORECASE)
"""About which nothing oscillates."""
UP = re.compile(r"\b(?:up(?:per|right|wards?)|inverted|top|highest|unstable vertical)\b", re.I)
DOWN = re.compile(r"\b(?:low(?:er|est)|hanging|down(?:wards?)?|bottom|pendent)\b", re.I)
OTHER = re.compile(
    r"\b(?:this|that|these|it|other|second|unstable|stable|non-?trivial|non-?zero|tilted|any)\b"
    r"|operating point",
    re.IGNORECASE,
)
EQUALS = re.compile(
    r"\\?(?P<name>[A-Za-z]+(?:_\{?\w+\}?)?)\s*(?:=|\\approx|\\simeq|\\to)\s*"
    r"(?P<value>(?:(?!\band\b)[^$,=])+)"
)
FURTHER = re.compile(r"[\s$]*(?:,|,?\s*\band\b)[\s$]*")
"""What stands before a further coordinate of a place."""
VALUE = re.compile(
    r"(?P<sign>[-+]?)(?:\\[dt]?frac)?\{?(?P<times>\d*(?:\.\d+)?)(?P<pi>\\?pi)?\}?(?:/?\{?(?P<by>\d+)\}?)?"
)


@dataclass(frozen=True)
class OperatingPoint:
    """About which angles an equation is meant to first order.

    Attributes
    ----------
    words : str
        What the text says of it.
    place : dict of Symbol to Expr or None
        Angles as the person counts them; None where the words are not read.
    hedge : str
        What stands beside that speaks of another equation; empty otherwise.
    """

    words: str
    place: dict[Symbol, Expr] | None
    hedge: str = ""


def operating_point(scene: Scene, written: Written) -> OperatingPoint | None:
    """What the last sentence up to a statement says that speaks of it; None where none does."""
    for sentence in reversed(_sentences(written)):
        if _is_full(written, sentence):
            return None
        if SAID.search(sentence) and not DENIED.search(sentence):
            hedge = HEDGED.search(sentence)
            place, words = _place(scene, written, sentence)
            return OperatingPoint(words, place, hedge[0] if hedge else "")
    return None


def called_linear(written: Written) -> str:
    """How the words before a formula call it a linear one; empty where they do not."""
    before = " ".join(written.text[max(0, written.start - 120) : written.start].split())
    found = CALLED.search(ENDS.split(f"{before} ")[-1])
    return found[0].strip(" $\\([:") if found and not DENIED.search(found[0]) else ""


def place_said(
    scene: Scene, written: Written, sentence: str
) -> tuple[str, dict[Symbol, Expr] | None]:
    """Which vertical a sentence gives a frequency about, in words, and its angles if it is known.

    Parameters
    ----------
    sentence : str
        Of the formula.
    """
    zero: dict[Symbol, Expr] = {q: S.Zero for q in scene.q if q in angular(scene)}
    plain = " ".join(sentence.split())
    for found in (*PLACE.finditer(plain), *AT.finditer(plain)):
        equal = EQUALS.match(found["place"].lstrip("$ ("))
        name = written.naming.lookup(equal["name"]) if equal else None
        symbol = Symbol(name[0], real=True) if name is not None and not name[1] else None
        if equal and symbol in zero and (value := _value(equal["value"])) is not None:
            return equal[0].strip(" $"), {symbol: value}
    never = UNSTABLE.search(plain)
    places = " ".join(found[0] for found in VERTICAL.finditer(plain))
    up, down = UP.search(places), DOWN.search(places)
    if never is not None:
        return never[0], None
    if (up is None) is (down is None) or not zero:
        return "", None
    way, quarter = (up, 1) if up is not None else (down, 3)
    place = _vertical(scene, zero, quarter)
    return (way[0], place) if way is not None and place is not None else ("", None)


def _is_full(written: Written, sentence: str) -> bool:
    """Whether the last that a sentence says before a formula is that it is meant as it stands."""
    at = written.text.rfind(sentence, 0, written.start + 1)
    before = sentence[: written.start - at] if at + len(sentence) > written.start else sentence
    full = max((m.start() for m in FULL.finditer(before)), default=-1)
    said = max((m.start() for m in SAID.finditer(before)), default=-1)
    return full > said and not HEDGED.search(FULL.sub(" ", before))


def _sentences(written: Written) -> list[str]:
    """Up to a statement, and as far as its own goes on behind it."""
    text, start = written.text, written.start
    behind = BEHIND.search(text, start)
    ends = sorted({*(m.end() for m in ENDS.finditer(text)), *([behind.end()] if behind else [])})
    starts = [0, *ends]
    pairs = zip(starts, [*ends, len(text)], strict=True)
    return [text[a:b] for a, b in pairs if a <= start]


def _place(scene: Scene, written: Written, sentence: str) -> tuple[dict[Symbol, Expr] | None, str]:
    zero: dict[Symbol, Expr] = {q: S.Zero for q in scene.q if q in angular(scene)}
    plain, own = " ".join(sentence.split()), dict(written.definitions)
    for found in PLACE.finditer(plain):
        words = found["place"].partition("$$")[0].partition("\\[")[0].strip()
        if equal := EQUALS.match(words.lstrip("$ (")):
            if _value(equal["value"]) == 0 and isinstance(own.get(equal["name"]), Table):
                return zero, words  # of a state, s = (x, x', theta, theta')
            point = _point(scene, written, words.lstrip("$ ("))
            if not point:
                return None, found[0].strip()
            return {**zero, **point}, words
        for way, quarter in ((UP, 1), (DOWN, 3)):
            if way.search(words):
                return _vertical(scene, zero, quarter), found[0].strip()
        if OTHER.search(words):
            return None, found[0].strip()
    return zero, ""


def _point(scene: Scene, written: Written, words: str) -> dict[Symbol, Expr]:
    """The coordinates of a list, as far as it gives them values."""
    point: dict[Symbol, Expr] = {}
    at: re.Match[str] | None = None
    while equal := EQUALS.match(words, at.end() if at else 0):
        name = written.naming.lookup(equal["name"].replace("{", "").replace("}", ""))
        value = _value(equal["value"])
        symbol = None if name is None or name[1] else Symbol(name[0], real=True)
        if value is None or symbol not in scene.q:
            break
        point[symbol] = value
        at = FURTHER.match(words, equal.end())
        if at is None:
            break
    return point


def _vertical(scene: Scene, zero: dict[Symbol, Expr], quarter: int) -> dict[Symbol, Expr] | None:
    """Angles where bodies are above, or below; None where the scene does not tell."""
    fixed = [one for one in counted(scene) if one.fixed and one.quarter is not None]
    return {**zero, **{one.symbol: _turned(one, quarter) for one in fixed}} if fixed else None


def _turned(one: Counted, quarter: int) -> Expr:
    if not one.sense:
        return S.Zero if one.quarter == quarter else pi
    return pi / 2 * (((quarter - (one.quarter or 0)) * one.sense + 1) % 4 - 1)


def _value(text: str) -> Expr | None:
    """An angle that is a number, or a part of pi."""
    plain = next(iter(text.split()), "").rstrip("})\\]")
    found = VALUE.fullmatch(plain)
    if found is None or not plain or not (found["times"] or found["pi"]):
        return None
    by = int(found["by"] or 1)
    if not by:
        return None
    number = Rational(found["times"] or 1) / by
    return Integer(-1 if found["sign"] == "-" else 1) * number * (pi if found["pi"] else 1)
