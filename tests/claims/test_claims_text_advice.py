"""What a text cannot say is refused in one line that says what to write instead."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
RAIL = "(mc + mp)*xdd = F - mp*l*(theta''*cos(theta) - theta'^2*sin(theta))\n"


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("xdd = 2 l 3 4", "write * between factors"),
        ("xdd = l x'(3)", "write * between factors"),
        ("function dz = cart(t, z)", "a MATLAB function: keep its equations only"),
        ("end", "the end of a MATLAB function"),
        ("x = z[m]", "z[...] is no entry that is known here: write its number"),
        ("mp*(l*sin(theta))'' = F", "write diff(..., t)"),
    ],
)
def test_what_to_write_instead(line: str, words: str) -> None:
    with pytest.raises(mechanics.MechanicsError) as failed:
        mechanics.check(CART, line, notation="text", blame=False)
    assert words in str(failed.value)
    assert "line 1, column" in str(failed.value)
    # It does not spoil what stands beside it.
    found = mechanics.check(CART, RAIL + line, notation="text", blame=False)
    assert [e.finding.verdict.name for e in found.judged] == ["PROVED", "UNDECIDED"]
