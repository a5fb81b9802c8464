r"""Derivatives of an author's own names: ``V'(x)``, and with an upright d along the motion."""

import pytest

from benchmarks.corpus.load import HERE, scene_of
from mechanics.claims.tree import Call, Name, Total, with_parts
from mechanics.judge.check import derived
from systems import bead_on_hoop, rocker, rod_pendulum
from tests.verdict_of import NOT_READ, verdict_of

ROD = derived(rod_pendulum.scene())
HOOP = derived(bead_on_hoop.scene())
ROCKER = derived(rocker.scene())
WIRE = derived(scene_of(HERE / "scenes" / "planar_wire.py", "wire"))

POTENTIAL = r"V(\theta)=\tfrac12mgl\cos\theta"
SPEED = r"\quad\omega=\dot\theta"
EFFECTIVE = r"U_{eff}(\theta)=-mgR\cos\theta-\tfrac12mR^2\omega^2\sin^2\theta"
INERTIA = r"J(\theta)=I_C+MR^2(\tfrac54+\cos\theta)"
MOMENT = r"f(R+\tfrac R2\cos\theta)+\tfrac12MgR\sin\theta"
POWER = r"\tfrac13ml^2\ddot\theta\dot\theta"


@pytest.mark.parametrize(
    ("truth", "text", "verdict"),
    [
        (ROD, rf"\tfrac13ml^2\ddot\theta=-V'(\theta)+u,\quad {POTENTIAL}", "PROVED"),
        (ROD, rf"\tfrac13ml^2\ddot\theta=-V^{{\prime}}(\theta)+u,\quad {POTENTIAL}", "PROVED"),
        (ROD, rf"{POTENTIAL},\quad \dot V=V'(\theta)\dot\theta", "PROVED"),
        (ROD, rf"{POWER}=-V'(\theta)\dot\theta+u\dot\theta,\quad {POTENTIAL}", "PROVED"),
        (ROD, rf"{POWER}=-V'(\theta)+u\dot\theta,\quad {POTENTIAL}", "REFUTED"),
        (ROD, rf"\tfrac13ml^2\ddot\theta=V'(\theta)+u,\quad {POTENTIAL}", "REFUTED"),
        (HOOP, rf"mR^2\ddot\theta=-U_{{eff}}'(\theta),\quad {EFFECTIVE}", "PROVED"),
        (HOOP, rf"mR^2\dot\theta\ddot\theta=-U_{{eff}}'(\theta),\quad {EFFECTIVE}", "REFUTED"),
        (ROCKER, rf"J(\theta)\ddot\theta+\tfrac12J'(\theta)\dot\theta^2={MOMENT},\quad {INERTIA}",
         "PROVED"),
        (ROCKER, rf"J(\theta)\ddot\theta+\tfrac12J'(\theta)\dot\theta={MOMENT},\quad {INERTIA}",
         "REFUTED"),
    ],
)  # fmt: skip
def test_a_prime_before_an_argument_is_by_it(truth: object, text: str, verdict: str) -> None:
    assert verdict_of(truth, rf"\[ {text} \]") == verdict


@pytest.mark.parametrize("text", [rf"{POTENTIAL},\ \tfrac13ml^2\ddot\theta=-V'+u"])
def test_a_prime_beside_dots_is_not_guessed(text: str) -> None:
    assert verdict_of(ROD, rf"\[ {text} \]") in ("UNDECIDED", NOT_READ)


@pytest.mark.parametrize("definition", ["$y=ax^2$, $y'=2ax$", "$y'=2ax$"])
def test_a_prime_beside_the_dots_of_another_formula_is_not_guessed(definition: str) -> None:
    motion = r"\[ (1+y'^2)\ddot x + y'y''\dot x^2 + gy' = 0 \]"
    text = f"With {definition} and $y''=2a$ we have {motion}"
    assert verdict_of(WIRE, text) in ("UNDECIDED", NOT_READ)


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"\tfrac13ml^2\omega\frac{d\omega}{d\theta}=\tfrac12mgl\sin\theta+u", "PROVED"),
        (r"\frac{d\omega}{d\theta}=\frac{\frac{3g}{2l}\sin\theta+\frac{3u}{ml^2}}{\omega}",
         "PROVED"),
        (r"\tfrac13ml^2\left(\ddot\theta+\omega\frac{d\omega}{d\theta}\right)"
         r"=\tfrac12mgl\sin\theta+u", "REFUTED"),
        (r"\tfrac13ml^2\ddot\theta+\omega\frac{d\omega}{d\theta}=\tfrac12mgl\sin\theta+u",
         "REFUTED"),
    ],
)  # fmt: skip
def test_a_speed_is_derived_along_the_motion(text: str, verdict: str) -> None:
    assert verdict_of(ROD, rf"\[ {text},{SPEED} \]") == verdict


@pytest.mark.parametrize("right", ["0", r"\tfrac12mgl\sin\theta+u", r"\tfrac16ml^2\ddot\theta"])
def test_an_energy_by_an_angle_is_not_guessed(right: str) -> None:
    r"""dT/dtheta is nothing at a given speed, and the moment along the motion."""
    text = rf"\[ \frac{{dT}}{{d\theta}}={right},\quad T=\tfrac16ml^2\dot\theta^2 \]"
    assert verdict_of(ROD, text) in ("UNDECIDED", NOT_READ)


def test_a_lagrangian_is_one_of_independent_names() -> None:
    text = (
        r"\[ L=\tfrac16ml^2\dot\theta^2-\tfrac12mgl\cos\theta \]"
        r"\[ \frac{d}{dt}\frac{dL}{d\dot\theta}-\frac{dL}{d\theta}=u \]"
    )
    assert verdict_of(ROD, text) == "PROVED"
    assert verdict_of(ROD, text.replace("-\\frac{dL}{d", "+\\frac{dL}{d")) == "REFUTED"


@pytest.mark.parametrize(
    "words",
    [r"A prime denotes the derivative with respect to $s=\omega_0t$.",
     r"Primes denote derivatives with respect to $s$."],
)  # fmt: skip
@pytest.mark.parametrize("sign", ["+", "-"])
def test_primes_by_something_else_decide_nothing(words: str, sign: str) -> None:
    text = rf"{words} \[ \theta''=\frac{{3g}}{{2l}}\sin\theta{sign}\frac{{3u}}{{ml^2}} \]"
    assert verdict_of(ROD, text) == "UNDECIDED"


@pytest.mark.parametrize("value", ["g=-9.81", "m=-1", "l=0", r"g&=-9.81\,\mathrm{m/s^2}"])
@pytest.mark.parametrize("beside", [r"{},\qquad {}", r"{} \] \[ {}", r"{} \\ {}"])
def test_what_the_scene_cannot_have_is_no_value_beside_it(value: str, beside: str) -> None:
    equation = r"\tfrac13ml^2\ddot\theta&=\tfrac12mgl\sin\theta+u"
    body = beside.format(equation, value).replace(r"\[", r"\end{align}\begin{align}")
    text = rf"\begin{{align}} {body.replace(chr(92) + ']', '')} \end{{align}}"
    assert verdict_of(ROD, text) == "UNDECIDED"
    assert verdict_of(ROD, text.replace("-9.81", "9.81").replace("=-1", "=1")
                      .replace("l=0", "l=2")) == "PROVED"  # fmt: skip


def test_a_rebuilt_tree_keeps_what_its_derivatives_are() -> None:
    names = (Name(0, "w"), Name(0, "theta"))
    for kind in (Call, Total):
        rebuilt = with_parts(kind(0, "partial", names), names[::-1])
        assert type(rebuilt) is kind and rebuilt.arguments == names[::-1]
