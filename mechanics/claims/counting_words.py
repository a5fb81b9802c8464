"""Words that tell things of a kind apart: the upper rod, the second mass, theta_left."""

COUNTED = (
    ("first", "upper", "inner", "shoulder", "one"),
    ("second", "lower", "outer", "elbow", "two"),
    ("third", "wrist", "three"),
)
"""Words that count, those of each place; what is nearer to the ground comes first."""
ONE_OF_SEVERAL = frozenset(
    ("left", "right", "front", "rear", *(word for words in COUNTED for word in words))
)
"""Words for one of several."""
