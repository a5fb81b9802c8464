"""A guess stays within a kind; where it refutes, the one other choice that is right is taken."""

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics import Particle, Scene, parameters
from mechanics.claims.guess import REASONS, _moving_rules, _still_rules
from mechanics.claims.kinds import kinds
from mechanics.judge.check import derived
from mechanics.scene import force
from systems import acrobot, cartpole

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


def carts() -> Scene:
    """Two carts that do not know each other, masses m_t and m."""
    x, y, force_ = dynamicsymbols("x y F")
    heavy, light, k = parameters("m_t m k", units="kg kg N/m", typical="5 2 7")
    ground = ReferenceFrame("N")
    origin = Point("O")
    one, two = origin.locatenew("A", x * ground.x), origin.locatenew("B", y * ground.x)
    return Scene(
        "two carts", ground, origin, coordinates=(x, y),
        bodies=(Particle("one", one, heavy), Particle("two", two, light)),
        loads=(
            force("F", one, force_ * ground.x, on="one"),
            force("spring", two, -k * y * ground.x, on="two"),
        ),
        inputs=(force_,),
    )  # fmt: skip


def test_the_one_choice_that_is_right_is_taken_and_told() -> None:
    truth = derived(carts())
    found = mechanics.check(truth, "M*x'' = F")
    assert found.ok
    (match,) = (match for match in found.names if match.guessed)
    assert (match.name, match.meaning) == ("M", "m_t")
    assert match.why == "the only choice that makes all of it right"
    # What the person gives is no guess, and neither is what is called the same.
    assert not mechanics.check(truth, "M*x'' = F", names={"M": "m"}).ok
    assert not mechanics.check(truth, "m*x'' = F").ok


def test_where_no_choice_is_right_the_guess_is_told_beside_the_refutation() -> None:
    found = mechanics.check(derived(carts()), "M*x'' = 2*F", blame=False)
    assert found.verdict.name == "REFUTED"
    assert any("guessed: M as m: " in remark and "--name M=" in remark for remark in found.remarks)


def test_no_choice_is_taken_that_makes_only_one_of_two_right() -> None:
    found = mechanics.check(derived(carts()), "M*x'' = F; M*y'' = -k*y", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["REFUTED", "PROVED"]


def test_the_first_letters_and_the_number_of_an_angle() -> None:
    truth = derived(acrobot.scene())
    potential = "V = -m1*g*lc1*cos(th1) - m2*g*(l1*cos(th1) + lc2*cos(th1 + th2))"
    assert mechanics.check(truth, potential, blame=False).ok
    assert not mechanics.check(truth, potential.replace("th1 + th2", "th2"), blame=False).ok


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"$M_{12} = m_2(l_{c2}^2 + l_1 l_{c2}\cos\theta_2) + I_2$", "PROVED"),
        ("D22 = m2*lc2^2 + I2", "PROVED"),
        (r"$M_{12} = m_2(l_{c2}^2 + l_1 l_{c2}\sin\theta_2) + I_2$", "REFUTED"),
        ("M11 = m2*lc2^2 + I2", "REFUTED"),
        ("M33 = m2*lc2^2 + I2", "UNDECIDED"),
    ],
)
def test_an_entry_of_the_mass_matrix_by_its_place(text: str, verdict: str) -> None:
    found = mechanics.check(derived(acrobot.scene()), text, blame=False)
    assert found.verdict.name == verdict


def test_every_reason_for_a_guess_is_one_that_other_choices_are_tried_for() -> None:
    scene = cartpole.scene()
    rules = (*_moving_rules(scene), *_still_rules(scene, {"F"}))
    assert {why for _, why in rules} == set(REASONS)
