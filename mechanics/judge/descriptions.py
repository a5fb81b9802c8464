r"""What a text describes otherwise than the scene has it: lengths, senses of inputs, bodies.

    where $l$ is the distance from the pivot to the mass centre    half-length of l
    where $u$ acts clockwise, is minus the applied torque          other sign of u
    where $m$ is twice the mass, a point mass on a massless rod    nothing is shown

Conventions are named as a person declares them; what no convention says is a contradiction, which
leaves what it is said beside UNDECIDED. What a text says as the scene has it changes nothing.
"""

import re
from collections.abc import Iterator, Sequence

from sympy import Expr, Rational, Symbol

from mechanics.claims.directions import counted
from mechanics.claims.names import Match
from mechanics.claims.prose import ENDS
from mechanics.claims.statement import Statement
from mechanics.judge.denotations import denoted_otherwise, other_times
from mechanics.scene import RigidBody, Scene
from mechanics.scene.loads import Force, Torque
from mechanics.symbolic import is_zero

BARE = r"\\?(?:var)?(?P<name>[A-Za-z]+(?:_\{?\w+\}?)?)"
NAME = rf"\$\s*{BARE}\s*\$"
IS = r"\s*(?:is|be|being|denotes|means|,)\s*(?:taken\s+(?:as|to be)\s+)?"
MASS_CENTRE = r"(?:cent(?:re|er) of (?:mass|gravity|inertia)|mass cent(?:re|er)|centroid|CoM)"
DISTANCE = re.compile(
    rf"{NAME}{IS}(?:the\s+)?(?:distance|length)\s+"
    r"(?:(?:from\s+(?:(?!and\b)[\w']+\s+){1,6})?to|between\s+(?:(?!and\b)[\w']+\s+){1,6}and|of)"
    rf"\s+(?:the|its)\s+(?:\w+(?:'s)?\s+)?{MASS_CENTRE}\b",
    re.IGNORECASE,
)
WHOLE = re.compile(
    rf"{NAME}{IS}(?:the|its)\s+(?:(?:full|total|whole|entire)\s+length\b|length\s+of\s+the\b)",
    re.IGNORECASE,
)
FACTOR = re.compile(
    rf"{NAME}{IS}(?P<size>half|twice|double|two times|one third|a third)\s+(?:of\s+)?(?:the|its)\s+"
    r"(?:(?:total|full|whole|applied|driving)\s+)?(?P<what>mass|torque|force|moment)\b",
    re.IGNORECASE,
)
NEGATIVE = re.compile(
    rf"{NAME}{IS}(?:minus|the\s+(?:negative|opposite)(?:\s+of)?|opposite\s+to)\s+(?:the\s+)?"
    r"(?:\w+\s+){0,2}(?:torque|moment|force|input|control)\b",
    re.IGNORECASE,
)
TURNS = re.compile(
    rf"{NAME}\s*(?:,\s*)?(?:is|acts?|acting|applied|measured|counted|taken|positive|turns?"
    r"|increases|grows|in|the|a|that|which|torque|moment|\s)+\s(?P<sense>(?:counter|anti)-?clockwise|clockwise)\b"
    r"(?!\s+from)",
    re.IGNORECASE,
)
PUSHES = re.compile(
    rf"{NAME}\s*(?:,\s*)?(?:is|acts?|acting|applied|directed|pushes|pulls|positive|points|the|a|that|which|force|\s)+"
    r"\s(?:to the\s+)?(?P<side>left|right|leftwards?|rightwards?)\b",
    re.IGNORECASE,
)
POINT_MASS = re.compile(r"\b(?:point|particle) ?mass|\bbob\b|\bparticle\b", re.IGNORECASE)
MASSLESS = re.compile(
    r"\b(?:mass-?less|weightless|light)\s+(?:rigid\s+)?(?:rod|pole|link|bar|stick|arm|string)s?\b",
    re.IGNORECASE,
)
DENIED = re.compile(r"\b(?:not|no|never|unlike|rather|instead|than|contrast)\b", re.IGNORECASE)


def described(scene: Scene, text: str, known: Sequence[Match]) -> Iterator[str]:
    """Conventions that a text describes, as they are declared.

    Parameters
    ----------
    known : sequence of Match
        What names of the person were taken for.
    """
    plain = " ".join(text.split())
    for found in WHOLE.finditer(plain):
        if "half" in _meaning(scene, _own(found, known)):
            yield f"twice the length of {_name(found)}"
    for found in DISTANCE.finditer(plain):
        if _ratio(scene, _own(found, known)) == Rational(1, 2):
            yield f"half-length of {_name(found)}"
    inputs = {symbol.name for symbol in scene.input_symbols}
    for found in NEGATIVE.finditer(plain):
        if _own(found, known) in inputs:
            yield f"other sign of {_name(found)}"
    yield from senses(scene, text, known)


def senses(scene: Scene, text: str, known: Sequence[Match]) -> Iterator[str]:
    """Those of `described` that are told by left, right and clockwise: as seen from one side."""
    plain = " ".join(text.split())
    for pattern, group in ((TURNS, "sense"), (PUSHES, "side")):
        for found in pattern.finditer(plain):
            way = -1 if found[group].lower().startswith(("clock", "left")) else 1
            if _way(scene, _own(found, known)) == -way:
                yield f"other sign of {_name(found)}"


def contradictions(
    scene: Scene, statements: Sequence[Statement], known: Sequence[Match]
) -> tuple[str, ...]:
    """What texts say that the scene has otherwise, and no convention mends; in words."""
    texts = sorted({s.written.text for s in statements if s.written is not None})
    return tuple(
        dict.fromkeys(one for text in texts for one in _contradictions(scene, text, known))
    )


def _contradictions(scene: Scene, text: str, known: Sequence[Match]) -> Iterator[str]:
    plain = " ".join(text.split())
    yield from other_times(text)
    for found in re.finditer(NAME, plain):
        behind = plain[found.end() : found.end() + FURTHEST]
        yield from denoted_otherwise(scene, _name(found), _own(found, known), behind)
    parameters = {symbol.name for symbol in scene.parameters}
    inputs = {symbol.name for symbol in scene.input_symbols}
    for found in FACTOR.finditer(plain):
        if _own(found, known) in parameters | inputs:
            yield f"the text says that {_name(found)} is {found['size']} the {found['what']}"
    for found in DISTANCE.finditer(plain):
        own = _own(found, known)
        if own in parameters and _ratio(scene, own) not in (1, Rational(1, 2)):
            words = f"the text says that {_name(found)} is the distance to a mass centre"
            yield f"{words}, but {own} of the scene is not"
    for pattern, group in ((TURNS, "sense"), (PUSHES, "side")):
        for found in pattern.finditer(plain):
            own = _own(found, known)
            if own in inputs and _way(scene, own) == 0:
                words = f"the text says that {_name(found)} acts {found[group]}"
                yield f"{words}, which the scene does not say of {own}"
    heavy = [b for b in scene.bodies if isinstance(b, RigidBody) and b.inertia != 0]
    sentences = ENDS.split(text) if len(heavy) == len(scene.bodies) else []
    for sentence in (one for one in sentences if not DENIED.search(one)):
        rod = MASSLESS.search(sentence)
        if rod and POINT_MASS.search(sentence):
            bodies = ", ".join(body.name for body in heavy)
            yield f"the text has a point mass on a {rod[0]}, the scene has rigid bodies: {bodies}"


def _name(found: re.Match[str]) -> str:
    return found["name"].replace("{", "").replace("}", "")


def _own(found: re.Match[str], known: Sequence[Match]) -> str:
    """The scene's name of what a sentence is about."""
    name = _name(found)
    meanings = {match.name: match.meaning for match in known}
    return meanings.get(name, meanings.get(name.replace("_", ""), name))


def _meaning(scene: Scene, name: str) -> str:
    return next((getattr(p, "meaning", "") for p in scene.parameters if p.name == name), "")


def _ratio(scene: Scene, name: str) -> Expr | None:
    """Of distances from points where reactions act to mass centres, to a length: 1 if one is it."""
    length = next((p for p in scene.parameters if p.name == name), None)
    if length is None or getattr(length, "unit", "") != "m":
        return None
    points = [scene.origin, *(one.at for one in scene.reactions if one.at is not None)]
    found: list[Expr] = []
    for body in scene.bodies:
        for point in points:
            span = scene.position(body.centre) - scene.position(point)
            square = span.dot(span)
            found += [k for k in RATIOS if is_zero(square - (k * length) ** 2)]
    return (found and (Rational(1) if 1 in found else found[0])) or None


RATIOS = (Rational(1), Rational(1, 2))
FURTHEST = 120
"""Characters behind a name that may say what it is."""


def _way(scene: Scene, name: str) -> int:
    """1 where an angle or a torque is counted counterclockwise, a force to the right; -1; or 0."""
    for angle in counted(scene):
        if angle.symbol.name == name:
            return angle.sense if angle.fixed and angle.planar else 0
    symbol = next((s for s in scene.input_symbols if s.name == name), Symbol(name, real=True))
    loads = [load for load in scene.loads if isinstance(load, Force | Torque)]
    vectors = [(isinstance(x, Torque), scene.vector(x.vector, x.name)) for x in loads]
    held = [(turns, vector) for turns, vector in vectors if symbol in vector.free_symbols]
    if len(held) != 1:
        return 0
    turns, vector = held[0]
    across, up, out = (one.diff(symbol) for one in vector)
    value = out if turns else across
    if not value.is_number or any(one != 0 for one in (across, up, out) if one is not value):
        return 0
    return 1 if value.is_positive else -1 if value.is_negative else 0
