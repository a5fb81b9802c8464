"""A guess stays within a kind; where it refutes, the one other choice that is right is taken."""

import pytest

import mechanics
from mechanics.crosscheck.check import derived
from mechanics.reading.kinds import kinds
from systems import cartpole

CART = derived(cartpole.scene())
RAIL = "(mc + mp)*xdd = F - mp*l*(theta''*cos(theta) - theta'^2*sin(theta))\n"


def guesses(truth, text: str) -> dict[str, str]:
    found = mechanics.check(truth, text, blame=False)
    return {match.name: match.meaning for match in found.names if match.guessed}


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("theta_p", {"angle"}), ("phi1", {"angle"}), ("th", {"angle"}), ("x_c", {"length"}),
        ("cart_pos", {"length"}), ("q", {"angle", "length"}), ("xi", {"angle", "length"}),
        ("E", set()), ("v", set()), ("omega_3", set()), ("L", set()),
    ],
)  # fmt: skip
def test_what_a_name_may_be(name: str, found: set[str]) -> None:
    assert kinds(name) == found


@pytest.mark.parametrize("name", ["E", "v", r"\omega", "x_1"])
def test_no_guess_goes_across_kinds(name: str) -> None:
    # The angle is the only coordinate that is left.
    text = rf"(m_c + m_p) \ddot x = F - m_p l \dot {name}"
    assert guesses(CART, text) == {}
    assert guesses(CART, text.replace(name, r"\alpha")) == {"alpha": "theta"}
