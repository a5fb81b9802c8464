"""One form for what sentences say of names: ⟨m⟩ is the mass of the rod.

The length of the pole is ⟨l⟩.                    ⟨l⟩ is the length of the pole
A rod of mass ⟨m⟩ and length ⟨l⟩                  ⟨m⟩ is the mass of the rod, ...
The cart has the mass ⟨M⟩.                        ⟨M⟩ is the mass of the cart
⟨R⟩ | radius of the bowl                          ⟨R⟩ is the radius of the bowl
⟨M⟩ and ⟨m⟩ are the masses of the cart and the pole, respectively
The masses of the cart and the pole are ⟨M⟩ and ⟨m⟩.
The second bob ⟨m2⟩ hangs from it.                ⟨m2⟩ is the second bob
The beam weighs ⟨m⟩.                              ⟨m⟩ is the mass of the beam
"""

import re

QUANTITY = r"(?:moment of inertia|mass|length|half-length|radius|diameter|stiffness|inertia|weight)"
ORDINAL = (
    "(?:first|second|third|upper|lower|inner|outer|fixed|moving|rolling|hollow|small(?:er)?"
    "|larger?)"
)
"""Words that tell one of two from the other."""
NAME = "\u27e8(\\w+)\u27e9"
EMPHASIS = re.compile(rf"(?:\*\*|`)({NAME})(?:\*\*|`)")
INVERSE = re.compile(
    rf"(?:\b[Tt]he |^)((?:total |whole )?(?i:{QUANTITY}) of (?:the )?(?:\w+ )?\w+)"
    rf"(?: is| equals| be|:) {NAME}"
)
APPOSED = re.compile(
    rf"(^|\b[Tt]he |\b[Aa] |\band )({ORDINAL} mass|(?:{ORDINAL} )?(?i:bob|bead|particle"
    r"|ball|rod|pole|bar|link|cart|trolley|carriage|block|body|wheel|disk|disc|cylinder|sphere|wedge"
    r"|load|beam|pulley|hoop|plate)) "
    rf"{NAME}(?! (?:is|denotes|be)\b)"
)
THAT_OF = re.compile(
    rf"(({QUANTITY}) of (?:the )?\w+),? and {NAME} (?:is |be )?that of (?:the )?(\w+)"
)
BY_WE_MEAN = re.compile(rf"\b[Bb]y {NAME} we (?:mean|denote|understand)")
AXIS_OF = re.compile(rf"\baxis of {NAME}")
BRACKETED = re.compile(rf"\b(\w+) \((?:of )?({QUANTITY} {NAME}) ?\)")
SUBJECT = re.compile(
    r"(?:^|(?<=; ))([Tt]he \w+)( is (?:[a-z-]+(?: and|,)? ){1,4}),? ?"
    rf"(?=(?:of|with) (?:the )?{QUANTITY} {NAME})"
)
WEIGHS = re.compile(rf"(?:^|(?<=[,;] )|(?<=and ))[Tt]he ((?:{ORDINAL} )?\w+) weighs {NAME}")
ROUND = re.compile(
    r"\b([Tt]he )(\w+)( is an? (?:\w+ ){0,2}(?:hoop|ring|dis[ck]|cylinder|sphere|ball)) of mass "
    rf"{NAME}"
)
OWNED = re.compile(
    rf"\b((?:{ORDINAL} )?(?:(?:torsion(?:al)?|rotational) )?\w+) (?:of|has|with|have) "
    rf"(?:the |a |an )?({QUANTITY}) {NAME}"
    rf"(?:(?:,| and) (?:of )?(?:the |a )?({QUANTITY}) {NAME})?"
)
BESIDE = re.compile(rf"\b[Tt]he ({QUANTITY}) {NAME} of the (\w+)\b")
LISTED = re.compile(
    rf"{NAME} ?(?:is |:|\(|=|[-\u2013\u2014]+|\||(?={QUANTITY} of (?:the )?\w)) ?"
    r"(?!(?:the|an?|its|half|twice|double|minus|not|in|per)\b)"
    rf"(?=(?i:(?:[a-z]+ ){{0,2}}?{QUANTITY}\b"
    r"|(?:viscous )?(?:damping|friction) (?:in|of|at)\b"
    r"|(?:angle|position|displacement) of\b"
    r"|(?:cart|trolley|carriage|pole|bob|load|rod|ball|beam)\b))"
)
"""A row of a table or a list: R | radius of the bowl."""
PAIR = re.compile(
    rf"{NAME} and {NAME} (?:are|denote) the (mass|length|stiffness|radi)(?:es|s|i)? of "
    r"(?:the )?(\w+) and (?:of )?(?:the )?(\w+)"
)
PAIR_OF = re.compile(
    r"\b[Tt]he (mass|length|stiffness|radi)(?:es|s|i)? of (?:the )?(\w+) and (?:of )?(?:the )?(\w+)"
    rf" (?:are|be) {NAME} and {NAME}"
)


def one_form(sentence: str) -> str:
    """A sentence, with what it says of names in that form.

    Parameters
    ----------
    sentence : str
        With names marked.
    """
    sentence = BY_WE_MEAN.sub("\u27e8\\1\u27e9 is", AXIS_OF.sub("\u27e8\\1\u27e9 axis", sentence))
    sentence = SUBJECT.sub(r"\1\2; \1 ", BRACKETED.sub(r"\1 of \2", sentence))
    sentence = THAT_OF.sub("\\1, \u27e8\\3\u27e9 is the \\2 of the \\4", sentence)
    sentence = PAIR_OF.sub(_pair_of, EMPHASIS.sub(r"\1", sentence))
    sentence = LISTED.sub("\u27e8\\1\u27e9 is the ", PAIR.sub(_pair, sentence))
    sentence = ROUND.sub("\\1\\2\\3, \u27e8\\4\u27e9 is the mass of the \\2", sentence)
    sentence = WEIGHS.sub("\u27e8\\2\u27e9 is the mass of the \\1,", sentence)
    sentence = APPOSED.sub("\\1\\2, \u27e8\\3\u27e9 is the \\2,", sentence)
    sentence = INVERSE.sub("\u27e8\\2\u27e9 is the \\1", sentence)
    sentence = BESIDE.sub("\u27e8\\2\u27e9 is the \\1 of the \\3", sentence)
    return OWNED.sub(_owned, sentence)


def _pair(said: re.Match[str]) -> str:
    what = "radius" if said[3] == "radi" else said[3]
    pairs = ((said[1], said[4]), (said[2], said[5]))
    return ", ".join(f"\u27e8{name}\u27e9 is the {what} of the {body}" for name, body in pairs)


def _pair_of(said: re.Match[str]) -> str:
    return PAIR.sub(
        _pair, f"\u27e8{said[4]}\u27e9 and \u27e8{said[5]}\u27e9 are the {said[1]}"
        f"{'i' if said[1] == 'radi' else 'es'} of the {said[2]} and the {said[3]}",
    )  # fmt: skip


def _owned(said: re.Match[str]) -> str:
    pairs = ((said[2], said[3]), (said[4], said[5]))
    each = (f", \u27e8{n}\u27e9 is the {what} of the {said[1]}" for what, n in pairs if n)
    return f"{said[1]} {''.join(each)}, "
