"""What a definition calls a momentum or an entry of the mass matrix is a claim, too."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import cartpole, rod_pendulum

ROD = derived(rod_pendulum.scene())
CART = derived(cartpole.scene())
ARM = r"$p_\theta={0}ml^2\dot\theta$, ${1}\dot p_\theta=\frac{{mgl}}{{2}}\sin\theta+u$"
RAIL = "({0} + {1})*x'' + {2}*theta'' - mp*l*theta'^2*sin(theta) = F"


def verdicts(truth, text: str) -> list[str]:
    return [e.verdict.name for e in mechanics.check(truth, text, blame=False).judged]


def test_a_momentum_that_an_equation_uses_is_judged() -> None:
    assert verdicts(ROD, ARM.format(r"\frac13", "")) == ["PROVED", "PROVED"]
    assert verdicts(ROD, ARM.format(r"\frac14", r"\frac43")) == ["REFUTED", "UNDECIDED"]
    more = ARM.format(r"\frac13", "").replace(r"\dot\theta$,", r"\dot\theta + ml\sqrt{gl}$,")
    assert verdicts(ROD, more)[0] == "REFUTED"


@pytest.mark.parametrize("name", ["p_x", "P"])
def test_a_momentum_that_may_be_of_a_body_is_open(name: str) -> None:
    text = f"{name} = (mc + mp)*x' + mp*l*theta'*cos(theta){{}}\n{name}' = F"
    assert verdicts(CART, text.format("")) == ["PROVED", "PROVED"]
    assert verdicts(CART, text.format(" + mp*sqrt(g*l)")) == ["UNDECIDED", "UNDECIDED"]


def test_an_entry_with_a_factor_or_beside_another_term_is_judged() -> None:
    right = "M_12 = mp*l*cos(theta)\n" + RAIL.format("mc", "mp", "1*M_12")
    assert "UNDECIDED" not in verdicts(CART, right)
    twice = "M_12 = 2*mp*l*cos(theta)\n" + RAIL.format("mc", "mp", "1/2*M_12")
    assert verdicts(CART, twice) == ["UNDECIDED", "UNDECIDED"]
    beside = "M_11 = mc\n" + RAIL.format("M_11", "mp", "mp*l*cos(theta)")
    assert verdicts(CART, beside) == ["UNDECIDED", "UNDECIDED"]


def test_an_entry_before_its_acceleration_is_what_the_equation_says() -> None:
    text = "M_22 = 4/3*l\nM_22*theta'' + x''*cos(theta) = g*sin(theta)"
    assert verdicts(CART, text) == ["PROVED"]
