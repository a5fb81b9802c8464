"""An energy by its letter in what another one is said to be."""

import particles
import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, of_one_particle
from mechanics import check
from mechanics.scene import Scene, force
from systems import rod_pendulum

T = r"\frac12 m (\dot r^2 + r^2 w^2)"
H = r"\frac12 m (\dot r^2 - r^2 w^2)"


def whirled(stiffness: bool = False) -> Scene:
    """A bead on a rod that turns in its horizontal plane by w, held by a spring or free."""
    r, (m, w, k) = dynamicsymbols("r"), P("m:kg w:1/s k:N/m")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (w * dynamicsymbols._t, N.z))
    C = O.locatenew("C", r * A.x)
    pull = (force("pull", C, -k * r * A.x, on="bead"),) if stiffness else ()
    return of_one_particle("rod", N, O, (r,), ("bead", C, m), pull, side=A.y, up=N.z)


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (rf"H = {H} = E - m w^2 r^2", "PROVED"),
        (rf"H = \dot r p - L = {H} = E - m w^2 r^2", "PROVED"),
        (rf"H = {H} = E - \frac12 m w^2 r^2", "REFUTED"),
        (rf"H = {T} = E - m w^2 r^2", "REFUTED"),
        (rf"H = {H} = E", "UNDECIDED"),  # E may be the value that is kept
        (rf"H = {H} = 2 E - m w^2 r^2", "UNDECIDED"),
    ],
)
def test_a_letter_of_an_energy_is_the_scenes_own(text: str, verdict: str) -> None:
    found = check(whirled(), rf"\[ {text} \]", blame=False)
    assert found.verdict.name == verdict
    assert verdict != "PROVED" or "E is read as the energy" in found.judged[0].statement.notes


def test_beside_a_force_with_a_potential_it_is_left_open() -> None:
    text = rf"\[ H = {H} + \frac12 k r^2 = E - m w^2 r^2 \]"
    assert check(whirled(stiffness=True), text, blame=False).verdict.name == "UNDECIDED"


@pytest.mark.parametrize("potential", ["U", "E_p"])
def test_a_potential_that_nothing_else_can_be_is_the_scenes_own(potential: str) -> None:
    """Without a prescribed motion there is no effective potential, so that U is V."""
    for part, verdict in ((2, "PROVED"), (3, "REFUTED")):
        text = rf"\[ L = \frac{{1}}{{{part}}} m l^2 \dot\theta^2 - {potential} \]"
        found = check(particles.pendulum(names="m l g"), text, blame=False)
        assert found.verdict.name == verdict, str(found)


@pytest.mark.parametrize("potential", ["U", r"U(\theta)"])
@pytest.mark.parametrize(
    "text", [r"L = \frac16 m l^2 \dot\theta^2 - {}", "L = T - {}", "E = T + {}"]
)
def test_an_energy_is_no_input_in_capitals(text: str, potential: str) -> None:
    """A torque u beside the potential energy U, which may count it: open, and not refuted."""
    found = check(rod_pendulum.scene(), rf"\[ {text.format(potential)} \]", blame=False)
    assert found.verdict.name == "UNDECIDED"


@pytest.mark.parametrize(
    ("text", "right"),
    [
        (r"L = T + m g l\cos\theta", True), (r"E = T - m g l\cos\theta", True),
        (r"E = U(\theta) + \frac12 m l^2\dot\theta^2", True),
        (r"L = T - m g l\cos\theta", False), (r"E = T + m g l\sin\theta", False),
        (r"E = U(\theta) + m l^2\dot\theta^2", False),
        ("L = T - U", False), ("H = T + U", False),  # which say nothing of the scene
    ],
)  # fmt: skip
def test_a_letter_beside_an_energy_is_the_other_one(text: str, right: bool) -> None:
    found = check(particles.pendulum(names="m l g"), rf"\[ {text} \]", blame=False)
    assert (found.verdict.name == "PROVED") is right, str(found)


def test_a_capital_letter_beside_no_energy_is_the_input() -> None:
    text = r"\[ \ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3U}{ml^2} \]"
    assert check(rod_pendulum.scene(), text, blame=False).verdict.name == "PROVED"
