r"""What a text says that a name of the scene denotes, where the scene has another thing by it.

    where $m$ is the mass of the carriage    the scene's m is the mass of the pendulum
    where $R$ is the diameter                the scene's R is a radius
    where $m$ is the mass per unit length    the scene's m is a mass
    where dots are derivatives by \tau       the scene's are by time

What a text says in words that the scene does not use says nothing against it.
"""

import re
from collections.abc import Iterator

from sympy import Symbol

from mechanics.claims.directions import counted
from mechanics.scene import Scene

PHRASE = r"\s*(?:is|are|be|being|denotes|means|,)?\s*(?:the|a|its)\s+(?P<phrase>[^$.;:,()\\]{3,80})"
"""Behind a name."""
BREAK = re.compile(r"\b(?:and|which|that|where|with|while|but|when|if)\b", re.IGNORECASE)
"""Behind it something else is spoken of."""
SMALL = re.compile(
    r"of|the|an?|its|from|to|in|at|on|for|about|by|this|that|each|our|is|are|total|whole"
)
OTHERS = (
    (r"\bradius\b", r"\bdiameter\b"),
    (r"\beach\b", r"\b(?:total|combined|together|both|equivalent)\b"),
    (r"\bdiameter\b", r"\bradius\b"),
)
"""What the scene says, and what is something else."""
SCALED = re.compile(
    r"\b(?:per unit (?:length|area|volume|mass|inertia)|divided by|multiplied by"
    r"|(?:square|inverse|reciprocal|logarithm) of)\b",
    re.IGNORECASE,
)
TURNS = re.compile(
    r"^[^$.;]{0,60}?\b(?:(?:revolutions?|turns|cycles|rotations|degrees)\s+(?:per|a)\s+"
    r"(?:second|minute)|in\s+(?:rpm|hertz|Hz|rev/s))\b",
    re.IGNORECASE,
)
RELATIVE = re.compile(
    r"^[^$.;]{0,60}?\brelative\s+to\s+(?:the\s+)?(?!(?:the|vertical|horizontal|upright|downward|upward"
    r"|equilibrium|static|rest|wall|ground|inertial|fixed|its|origin|earth|undeformed|position)\b)"
    r"(?P<to>\w+)",
    re.IGNORECASE,
)
ABSOLUTE = re.compile(
    r"^[^$.;]{0,40}?\b(?:from|with)\s+(?:the\s+)?(?:(?:down|up)wards?\s+)?"
    r"(?P<to>vertical|horizontal)\b",
    re.IGNORECASE,
)
AGAINST = re.compile(
    r"^[^$.;]{0,40}?\b(?:(?:of|towards)\s+decreasing|opposite\s+(?:to|in)|opposing|opposes"
    r"|against\s+(?:the\s+)?(?:motion|rotation|direction))\b",
    re.IGNORECASE,
)
DOTS = re.compile(
    r"\b(?:over)?(?:dots?|primes?)\b[^.;$]{0,50}\b(?:with respect to|by)\s+(?:the\s+)?"
    r"(?P<by>(?:dimensionless|non-?dimensional|scaled|normali[sz]ed|rescaled|proper)\s+time"
    r"|\$(?!\s*t\s*\$)[^$]*\$)",
    re.IGNORECASE,
)


def other_times(text: str) -> Iterator[str]:
    """What a text says that dots are, where that is no rate in time; in words."""
    for dots in DOTS.finditer(" ".join(text.split())):
        yield f"the text says that dots are derivatives by {dots['by']}"


def denoted_otherwise(scene: Scene, name: str, own: str, behind: str) -> Iterator[str]:
    """What the words behind a name say that the scene's symbol is not; in words.

    Parameters
    ----------
    name, own : str
        As the text has it, and as the scene has.
    behind : str
        The text behind it.
    """
    parameters = {p.name: p for p in scene.parameters}
    inputs = {symbol.name for symbol in scene.input_symbols}
    phrase = re.match(PHRASE, behind, re.IGNORECASE)
    words = BREAK.split(phrase["phrase"])[0].strip() if phrase else ""
    said = f"the text says that {name} is the {words}"
    if own in parameters | dict.fromkeys(inputs):
        scaled = SCALED.search(words)
        if scaled and "/" not in getattr(parameters.get(own), "unit", ""):
            yield said
        elif turns := TURNS.search(behind):
            yield f"the text says of {name} {turns[0].strip()!r}"
    if own in inputs and (against := AGAINST.search(behind)):
        yield f"the text says of {name} {against[0].strip()!r}"
    if own in parameters and words:
        meaning = getattr(parameters[own], "meaning", "")
        if any(re.search(a, meaning) and re.search(b, words) for a, b in OTHERS):
            yield f"{said}, the scene's {own} is the {meaning}"
        elif other := _means_another(parameters, own, words):
            yield f"{said}, the scene's {own} is the {meaning}, and {other} is that"
    for pattern, way, one in ((RELATIVE, "relative to", True), (ABSOLUTE, "from", False)):
        found = pattern.search(behind)
        if found and _is_absolute(scene, own) is one:
            yield f"the text says that {name} counts {way} the {found['to']}, {own} does not"


def _means_another(parameters: dict[str, Symbol], own: str, words: str) -> str:
    """The other parameter of the same unit whose meaning words have that set it apart; or empty."""
    said, mine = _nouns(words), _nouns(getattr(parameters[own], "meaning", ""))
    for name, parameter in parameters.items():
        theirs = _nouns(getattr(parameter, "meaning", ""))
        same = getattr(parameter, "unit", "") == getattr(parameters[own], "unit", "")
        apart = theirs - mine and theirs <= said and not mine <= said
        if name != own and same and apart and not (mine - theirs) & said:
            return name
    return ""


def _nouns(words: str) -> frozenset[str]:
    plain = re.sub(r"'s\b", "", words.lower())
    return frozenset(w for w in re.findall(r"[a-z]+", plain) if not SMALL.fullmatch(w))


def _is_absolute(scene: Scene, name: str) -> bool | None:
    """Whether a coordinate is counted from what is fixed: a body's place holds no other.

    None for what is no coordinate.
    """
    symbol = next((q for q in scene.q if q.name == name), None)
    if symbol is None:
        return None
    angles = {one.symbol: one.fixed for one in counted(scene)}
    if symbol in angles:
        return angles[symbol]
    others = {*scene.q} - {symbol}
    places = [list(scene.position(body.centre)) for body in scene.bodies]
    held = [set().union(*(e.free_symbols for e in place)) for place in places]
    return any(symbol in symbols and not symbols & others for symbols in held)
