"""Names in plain letters: Greek ones by name, dots above them counted.

np.x -> x, 0        \u03b8\u0307 -> theta, 1
"""

import unicodedata

DOTS = {"\u0307": 1, "\u0308": 2}
"""Orders of the derivative, by the mark above a letter."""


def plain(text: str) -> tuple[str, int]:
    """A name without its module and its dots, Greek letters by name."""
    _, _, name = text.rpartition(".")
    decomposed = unicodedata.normalize("NFD", name)
    order = sum(DOTS.get(character, 0) for character in decomposed)
    letters = "".join(_latin(c) for c in decomposed if c not in DOTS)
    return letters, order


def _latin(character: str) -> str:
    if ord(character) < 128:
        return unicodedata.normalize("NFKD", character)  # a script l is an l
    character = unicodedata.normalize("NFKD", character)  # a symbol for phi is a phi
    words = unicodedata.name(character, "").split() if len(character) == 1 else []
    # GREEK SMALL LETTER THETA, GREEK CAPITAL LETTER DELTA
    if words[:1] == ["GREEK"] and "LETTER" in words:
        spelled = words[words.index("LETTER") + 1].lower().replace("lamda", "lambda")
        return spelled.capitalize() if "CAPITAL" in words else spelled
    return character
