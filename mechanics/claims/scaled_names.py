"""Names that say another quantity than the letter they begin with: nobody guesses what they are.

theta_deg    omega_rpm    R_mm    u_kNm    l_half    half_l    l_1over2    diameter    u_max
"""

import re

from mechanics.claims.foreign_units import LAST_WORDS

OF_PARTS = "half halves halved semi quarter third double doubled twice full whole diameter diam dia"
PARTS = frozenset(OF_PARTS.split())
"""Words for a part or a multiple."""
OTHERS = frozenset(("max", "min", "ref", "des", "eq"))
"""Words for a bound, an aim or a state at rest."""
_PER_SECOND = re.compile(r"(?<=[a-z])(?:_?[Pp]er_?|_)(?:[sS]|[sS]ec|[sS]econd)\d?$")
GLUED = re.compile(rf"[A-Za-z]({'|'.join(sorted(OTHERS))})")
"""Behind one letter: umax."""
FRACTION = re.compile(r"(?<=_)(\d+over\d+)$")
WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|k?N(?:mm?|cm)?(?![a-z])")


def another_quantity(name: str) -> str:
    """The word of a name that says that it is another quantity; empty for any other name."""
    if fraction := FRACTION.search(name):
        return fraction[1].replace("over", "/")
    parts = [part for part in name.replace("{", "_").replace("}", "_").split("_") if part]
    words = [word for part in parts for word in (part, *WORD.findall(part))]
    words += GLUED.findall(name) if GLUED.fullmatch(name) else []
    said = [word for word in words if word.lower() in PARTS | OTHERS]
    if not said and parts and (len(parts) > 1 or len(parts[-1]) > 2):
        said = [word for word in _last_words(parts) if _is_unit(word)]
    return said[0] if said else ""


def unit_in(words: str) -> str:
    """The first of words, or of the parts of a name, that is no coherent unit of the SI."""
    parts = (part for word in re.findall(r"[^\W_]+", words) for part in (word, *WORD.findall(word)))
    return next((part for part in parts if _is_unit(part)), "")


def unit_at_end(name: str) -> str:
    """The unit at the end of a name, per second or not, that is no coherent one of the SI.

    theta_deg, accDegPerS2, cycles_per_second
    """
    parts = [part for part in _PER_SECOND.sub("", name).split("_") if part]
    if not parts or (len(parts) == 1 and len(parts[0]) < 3):
        return ""
    return next((word for word in _last_words(parts) if _is_unit(word)), "")


def _last_words(parts: list[str]) -> list[str]:
    return [parts[-1], *WORD.findall(parts[-1])[1:]]


def _is_unit(word: str) -> bool:
    return word in LAST_WORDS or (len(word) > 2 and word.lower() in LAST_WORDS)
