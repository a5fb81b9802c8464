"""One form for what sentences say of names: ⟨m⟩ is the mass of the rod.

    The length of the pole is ⟨l⟩.                    ⟨l⟩ is the length of the pole
    A rod of mass ⟨m⟩ and length ⟨l⟩                  ⟨m⟩ is the mass of the rod, ...
    The cart has the mass ⟨M⟩.                        ⟨M⟩ is the mass of the cart
    ⟨M⟩ and ⟨m⟩ are the masses of the cart and the pole, respectively

What `phrases` has rows for is asked of these, beside the sentence as it stands.
"""

import re
from collections.abc import Iterator

QUANTITY = r"(?:moment of inertia|mass|length|half-length|radius|diameter|stiffness|inertia|weight)"
NAME = "\u27e8(\\w+)\u27e9"
INVERSE = re.compile(
    rf"\b[Tt]he ((?:total |whole )?{QUANTITY} of (?:the )?(?:\w+ )?\w+) (?:is|equals|be) {NAME}"
)
OWNED = re.compile(
    rf"\b(\w+) (?:of|has|with|have) (?:the |a |an )?({QUANTITY}) {NAME}"
    rf"(?:(?:,| and) (?:of )?(?:the |a )?({QUANTITY}) {NAME})?"
)
BESIDE = re.compile(rf"\b[Tt]he ({QUANTITY}) {NAME} of the (\w+)\b")
PAIR = re.compile(
    rf"{NAME} and {NAME} (?:are|denote) the (mass|length|stiffness|radi)(?:es|s|i)? of "
    r"(?:the )?(\w+) and (?:of )?(?:the )?(\w+)"
)


def one_form(sentence: str) -> Iterator[str]:
    """A sentence, without what it says of two names at once, and what it says of single names.

    Parameters
    ----------
    sentence : str
        With names marked.
    """
    yield PAIR.sub(" ", sentence)
    for said in INVERSE.finditer(sentence):
        yield f"\u27e8{said[2]}\u27e9 is the {said[1]}"
    for said in OWNED.finditer(sentence):
        pairs = ((said[2], said[3]), (said[4], said[5]))
        yield from (f"\u27e8{n}\u27e9 is the {what} of the {said[1]}" for what, n in pairs if n)
    for said in BESIDE.finditer(sentence):
        yield f"\u27e8{said[2]}\u27e9 is the {said[1]} of the {said[3]}"
    for said in PAIR.finditer(sentence):
        what = "radius" if said[3] == "radi" else said[3]
        for name, body in ((said[1], said[4]), (said[2], said[5])):
            yield f"\u27e8{name}\u27e9 is the {what} of the {body}"
