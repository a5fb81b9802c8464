"""Words that tell things of a kind apart: the upper rod, the second mass, theta_left."""

import re

NUMBERED = (
    frozenset(("first", "upper", "inner")),
    frozenset(("second", "lower", "outer")),
    frozenset(("third",)),
)
"""Of each place; what is nearer to the ground comes first."""
_JOINTS = ("shoulder", "elbow", "wrist")
_NUMBERS = ("one", "two", "three")
COUNTED = tuple(
    words | {joint, number}
    for words, joint, number in zip(NUMBERED, _JOINTS, _NUMBERS, strict=True)
)
"""Words that count, those of each place."""
ONE_OF_SEVERAL = frozenset(("left", "right", "front", "rear")).union(*COUNTED)
"""Words for one of several."""
_COUNT = re.compile(r"\b(?:two|three)[ _](?=[a-z])")


def without_counts(words: str) -> str:
    """Words in small letters without how many: "two ropes" tells none apart, "rope two" does."""
    return _COUNT.sub("", words)
