"""What the name of a function says that it returns.

normalForce                a normal force
lower_rope_tension         a tension, that of the lower rope
powerOfMotor, torque2      a power, that of the motor; a torque, the second
accel_from_force, f        nothing
"""

import re
from dataclasses import dataclass

from mechanics.claims.counting_words import without_counts
from mechanics.claims.prose import NOUNS

TITLE = re.compile(
    r"^(?:get|compute|calc|calculate|eval|evaluate)_|_(?:fun|func|fn|function)$", re.IGNORECASE
)
"""What people put before and behind the name of what a function returns."""
AXES = frozenset("xyz")
UNIT = re.compile(
    r"(?:(?<=energy )(?:[km]?j|n ?m)|(?<=frequency )(?:hz|rad ?s)|(?<=period )(?:m?s|sec|seconds)"
    r"|(?:(?<=force )|(?<=tension ))[km]?n|(?<=torque )[km]?n ?m)$"
)
"""Of a noun, behind it: energy_J, period_ms."""
OWNED = re.compile(r" (?:of|on|at|in|about) ")
BESIDE = re.compile(r" (?:with|without|no|not|under|by|for|from|per|and|to|vs) .*")
"""What is only there: pendulum_with_torque, accel_from_force."""

_NOUNS: tuple[tuple[str, str], ...] = (
    *((noun.lower(), word) for nouns, word in NOUNS for noun in nouns.split("|")),
    ("frequency", "frequency"), ("force", "force"), ("forces", "force"),
    *((part, "part") for part in ("friction", "drag", "damping", "weight", "coriolis")),
)  # fmt: skip
"""The ends of names, and the words for what they mean; the longer ones first."""

_PLAIN = frozenset(("natural", "angular", "circular", "small", "total", "generalized"))
"""Words that tell nothing apart."""


@dataclass(frozen=True)
class FunctionName:
    """What the name of a function says.

    Attributes
    ----------
    word : str
        A word of `mechanics.claims.about.WORDS`, ``"force"``, ``"part"`` of what drives; or empty.
    owner : frozenset of str
        Its other words, in small letters: whose it is.
    """

    word: str = ""
    owner: frozenset[str] = frozenset()


def function_name(title: str) -> FunctionName:
    """What a name says, by the last noun before a preposition.

    Parameters
    ----------
    title : str
        In small letters and underscores, or with capitals between its words.
    """
    words = re.sub(r"(\d+)", r" \1", BESIDE.sub("", f" {without_counts(spoken(title))} "))
    head, *rest = OWNED.split(f" {words.strip()} ", maxsplit=1)
    parts = head.split()
    ends: list[str] = []
    if unit := UNIT.search(" ".join(parts)):
        parts = parts[: -len(unit[0].split())]
    while parts and (parts[-1] in AXES or parts[-1].isdigit()):
        ends.append(parts.pop())
    said = " ".join(parts)
    for noun, word in sorted(_NOUNS, key=lambda pair: -len(pair[0])):
        if f" {said}".endswith(f" {noun}"):
            own = [*said.removesuffix(noun).split(), *ends, *" ".join(rest).split()]
            own += ["normal"] if "normal" in noun else []
            return FunctionName(word, frozenset(own) - _PLAIN)
    return FunctionName()


def spoken(title: str) -> str:
    """The name of a function in words, without what people put before and behind it."""
    plain = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", title).lower()
    return TITLE.sub("", plain).strip("_").replace("_", " ")
