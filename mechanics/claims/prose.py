"""What the prose around formulas says that a letter is.

"the torque $T$ about O"    "where $S$ denotes the tension"    ->    torque, tension
"""

import re

SYMBOL = r"\\?(?:var)?(?P<name>[A-Za-z]+(?:_\{?\w+\}?)?)"
"""A name with its subscript in a pattern, in LaTeX or plain."""
NOUNS: tuple[tuple[str, str], ...] = (
    ("kinetic energy", "kinetic energy"),
    ("effective potential energy|effective potential", "effective potential"),
    ("potential energy|potential", "potential energy"),
    ("total energy|mechanical energy|energy", "energy"),
    ("Lagrangian|Lagrange function", "Lagrangian"),
    ("Hamiltonian|Jacobi integral|Jacobi's integral|energy integral", "Hamiltonian"),
    ("angular momentum|moment of momentum", "angular momentum"),
    ("linear momentum|momentum", "momentum"),
    ("tension", "tension"),
    ("normal force|normal reaction|constraint force|contact force|reaction", "reaction"),
    ("torque|moment of force|moment", "torque"),
    ("period", "period"),
    ("speed", "speed"),
    ("dissipation function|Rayleigh function", "Rayleigh's function"),
    ("power", "power"),
)
"""Nouns, and the word for what they mean."""

_ANY = "|".join(nouns for nouns, _ in NOUNS)
_BEFORE = (
    rf"(?P<noun>{_ANY})(?: (?:in|of|on|about) (?:the )?[\w$-]+){{0,2}}(?: is| as)?[ ,:]*"
    r"(?:\$|\\\()?\s*"
)
_AFTER = (
    r"\s*(?:\$|\\\))?\s*(?:is|be|denotes|for|,|:|being|means)\s+(?:the|its|a)?\s*"
    rf"(?:[a-z]+ ){{0,2}}?(?P<noun>{_ANY})\b"
)
PAIR = re.compile(r"\b(?:kinetic|potential)(?: energy)?,? (?:and|or|minus|plus) (?:the )?$", re.I)
"""Before a noun of two things, which says nothing of one letter."""

ENERGY = re.compile(
    r"\b(?:(?P<kinetic>kinetic)|(?P<potential>potential)|(?:total|mechanical)) energy"
    r"(?: (?:of|in) (?:the |this |our )?[\w ]{1,24}?)?"
    r"(?: is| reads| becomes| equals|:| =)\s*(?:\$\$?|\\[(\[])?\s*$",
    re.IGNORECASE,
)
"""What an expression without a letter is called before it."""


def energy_before(text: str, at: int) -> str:
    """The letter of the energy that words before a place in a text say stands there; else empty."""
    match = ENERGY.search(" ".join(text[max(0, at - 80) : at].split()) + " ")
    if match is None:
        return ""
    return "T" if match["kinetic"] else "V" if match["potential"] else "E"


FROM_REST = re.compile(
    r"\b(?:start|releas|beg[iau]n)\w* (?:from |at )?rest\b|\bfrom rest\b|\binitially at rest\b",
    re.IGNORECASE,
)
"""How a motion begins."""
EQUILIBRIUM = re.compile(
    r"equilibri|stationary (?:point|solution)|fixed point"
    r"|\b(?:balances|is balanced|held horizontally)\s+(?:when|where|if|with)\b"
    r"|(?<!frame )\bat rest\b|\brests\b(?! (?:on|against|upon)\b)"
    r"|(?:oscillat|vibrat)\w+\s+(?:about|around)\b",
    re.IGNORECASE,
)
AWAY = re.compile(
    r"\b(?:no|not(?: an?| the| in| at)?|never|nor|neither|without|away from|far from|out of|non)"
    r"[\s-]+(?:[a-z]+\s+){0,2}equilibri"
    r"|equilibri\w*\s+(?:(?:is|are|does|do|has|have|can)\s+)?(?:not|never|nowhere|cannot|fails?)\b",
    re.IGNORECASE,
)
"""What denies that there is an equilibrium."""
ENDS = re.compile(
    r"[.;!?](?=\s)|(?<![:\s])(?<!\bwhere)(?<!\bif)(?<!\bwhen)(?<!\bat)(?<!\bby)(?<!\bis)\s*\n\s*\n"
)
"""Of sentences; what a colon or a function word announces is part of its own."""


def sentence_around(text: str, at: int) -> str:
    """The sentence around a place in a text.

    Parameters
    ----------
    text : str
    at : int
    """
    ends = [match.end() for match in ENDS.finditer(text)]
    start = max((end for end in ends if end <= at), default=0)
    end = min((end for end in ends if end > at), default=len(text))
    return text[start:end]


def of_equilibrium(text: str, at: int) -> bool:
    """Whether the sentence around a place in a text speaks of an equilibrium."""
    sentence = " ".join(sentence_around(text, at).split())
    return EQUILIBRIUM.search(FROM_REST.sub("", sentence)) is not None


def denies_equilibrium(text: str, at: int) -> str:
    """How the sentence around a place denies that there is an equilibrium; empty otherwise."""
    found = AWAY.search(" ".join(sentence_around(text, at).split()))
    return found[0] if found else ""


def said_of(text: str, letter: str) -> str:
    """The word for what a text says that a letter is; empty where it says nothing, or two things.

    Parameters
    ----------
    text : str
    letter : str
    """
    plain = " ".join(text.split())
    name = rf"(?<![\w\\]){re.escape(letter)}(?![\w_'^(])"
    patterns = (rf"\b{_BEFORE}{name}", rf"{name}{_AFTER}")
    every = (m for p in patterns for m in re.finditer(p, plain, re.IGNORECASE))
    nouns = {m["noun"].lower() for m in every if not PAIR.search(plain[: m.start("noun")])}
    said = {word for noun in nouns for names, word in NOUNS if noun in names.lower().split("|")}
    return said.pop() if len(said) == 1 else ""
