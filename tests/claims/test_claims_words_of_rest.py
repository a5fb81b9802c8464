"""A sentence on a start from rest speaks of no equilibrium."""

import pytest

from mechanics.claims.prose import of_equilibrium


@pytest.mark.parametrize(
    "words", ["The rod is at\nrest where", "It rests where", "In equilibrium", "at rest, initially"]
)
def test_rest_is_an_equilibrium(words: str) -> None:
    assert of_equilibrium(words, len(words) - 1)


@pytest.mark.parametrize(
    "words",
    ["It starts from rest", "It is initially at rest", "released at\nrest", "Starting from rest",
     "started at rest", "seen from a frame at rest", "The ladder rests\non the wall"],
)  # fmt: skip
def test_a_start_from_rest_is_none(words: str) -> None:
    assert not of_equilibrium(words, len(words) - 1)
