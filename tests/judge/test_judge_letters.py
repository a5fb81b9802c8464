"""What a letter on the left means: by dimension first, by rank, one meaning for a document."""

import particles
import pytest
from sympy.physics.mechanics import dynamicsymbols

from mechanics import check
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from mechanics.scene import Scene, damper, parameters
from systems import bead_on_hoop, elastic_pendulum, rod_pendulum

RIGHT = (Verdict.PROVED, Verdict.CERTIFIED)
WRONG = (Verdict.REFUTED,)


def pendulum(units: str = "kg m m/s^2") -> Scene:
    """Theta from the bottom, S_0 pulls the bob inwards."""
    return particles.pendulum(units, "", "m l g", "S_0")


def damped() -> Scene:
    """A mass on a damper."""
    x, (m, c) = dynamicsymbols("x"), parameters("m c", units="kg N*s/m")
    return particles.on_line(
        "damped mass", x, m, lambda N, O, P: [damper("c", O, P, c, along=N.x)], body="body"
    )


SCENES = {
    "pendulum": pendulum,
    "pendulum without units": lambda: pendulum(""),
    "hoop": bead_on_hoop.scene,
    "rod": rod_pendulum.scene,
    "damped": damped,
}


def answer(scene: str, text: str) -> Check:
    return check(SCENES[scene](), text)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("scene", "text", "said"),
    [
        ("pendulum", r"T = m g \cos\theta + m l \dot\theta^2", "tension"),
        ("pendulum", "N = m*g*cos(theta) + m*l*theta'^2", "reaction"),
        ("pendulum", "N = -m*g*cos(theta) - m*l*theta'^2", "reaction"),
        ("pendulum", r"L = m l^2 \dot\theta", "angular momentum"),
        ("pendulum", r"V = l\dot\theta", "speed"),
        ("pendulum", r"E = \frac12 m l^2\dot\theta^2 + m g l(1 - \cos\theta)", "energy"),
        (
            "pendulum",
            r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta + m l^2\dot\theta\sqrt{g/l}",
            "",
        ),
        ("hoop", r"H = p_\theta^2/(2 m R^2) - m R^2 \omega^2\sin^2\theta/2 - m g R\cos\theta", ""),
        ("hoop", r"H = m R^2\dot\theta^2/2 - m R^2\omega^2\sin^2\theta/2 - m g R\cos\theta", ""),
        ("hoop", r"E = m R^2(\dot\theta^2 + \omega^2\sin^2\theta)/2 - m g R\cos\theta", "energy"),
        ("rod", "P = u*theta'", "power"),
        ("damped", "D = c*x'^2/2", "Rayleigh"),
        ("damped", "P = m*x'", "momentum"),
    ],
)
def test_a_letter_is_read_as_what_has_its_dimension(scene: str, text: str, said: str) -> None:
    found = answer(scene, text)
    assert found.verdict in RIGHT, str(found)
    assert said in str(found)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("scene", "text"),
    [
        ("pendulum", r"T = m g \cos\theta - m l \dot\theta^2"),
        ("pendulum", r"L = m l \dot\theta"),
        ("pendulum", r"L = 2 m l^2 \dot\theta"),
        ("pendulum", r"V = 2 l\dot\theta"),
        ("pendulum", r"E = \frac12 m l^2\dot\theta^2 + m g l(1 - \cos\theta) + m l"),
        ("pendulum", r"E = \frac12 m l^2\dot\theta^2 + m g l(1 - \cos\theta) + 7"),
        ("pendulum", r"U = l^4 - m g l \cos\theta"),
        ("pendulum", r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta + g"),
        ("pendulum without units", r"U = l^4 - m g l \cos\theta"),
        ("pendulum without units", r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta + g"),
        ("hoop", r"H = p_\theta^2/(2 m R^2) + m R^2 \omega^2\sin^2\theta/2 - m g R\cos\theta"),
        ("hoop", r"H = m R^2(\dot\theta^2 + \omega^2\sin^2\theta)/2 - m g R\cos\theta"),
        ("hoop", r"E = m R^2(\dot\theta^2 - \omega^2\sin^2\theta)/2 - m g R\cos\theta"),
        ("hoop", r"U = -m g R\cos\theta + m R^2\omega^2\sin^2\theta/2"),
        ("rod", "P = -2*u*theta'"),
        ("damped", "P = 2*m*x'"),
    ],
)
def test_a_wrong_one_is_refuted(scene: str, text: str) -> None:
    assert answer(scene, text).verdict is Verdict.REFUTED, str(answer(scene, text))


@pytest.mark.sample(2)
@pytest.mark.parametrize("letter", ["U", "E_p", "V_{tot}"])
@pytest.mark.parametrize("scene", ["pendulum", "hoop"])
def test_an_energy_of_another_dimension_is_mended_where_all_its_meanings_have_one(
    scene: str, letter: str
) -> None:
    radius = {"pendulum": "l", "hoop": "R"}[scene]
    (entry,) = answer(scene, rf"{letter} = -m {radius} {radius}\cos\theta").judged
    assert entry.blame is not None
    assert [e.right for repair in entry.blame.repairs[:1] for e in repair.edits] == ["g"]


@pytest.mark.parametrize(
    ("scene", "text", "said"),
    [
        ("pendulum", r"T = -m g l \sin\theta", "torque"),
        ("damped", "D = c*x'^2", "dissipate"),
        ("hoop", r"U = -m g R\cos\theta - m R^2\omega^2\sin^2\theta/2", "effective potential"),
    ],
)
def test_what_another_meaning_makes_right_is_neither(scene: str, text: str, said: str) -> None:
    found = answer(scene, text)
    assert found.verdict is Verdict.UNDECIDED
    assert said in found.judged[0].right_if[0]


@pytest.mark.parametrize(
    ("text", "said", "verdict"),
    [
        (r"T = -m g l \sin\theta", "torque", RIGHT),
        (r"T = -m g l \cos\theta", "torque", WRONG),
        (r"T = m l^2\dot\theta^2/2", "torque", WRONG),
    ],
)
def test_what_is_said_is_meant(text: str, said: str, verdict: tuple[Verdict, ...]) -> None:
    assert check(pendulum(), text, names={"T": said}).verdict in verdict


@pytest.mark.campaign
def test_one_meaning_for_a_document() -> None:
    both = "T = m*g*cos(theta) + m*l*theta'^2\nT = m*l^2*theta'^2/2"
    assert answer("pendulum", both).verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"The torque $T$ about the pivot is \[ T = -m g l\sin\theta. \]", RIGHT),
        (r"\[ T = -m g l\sin\theta, \] where $T$ is the torque of gravity.", RIGHT),
        (r"The torque $T$ about the pivot is \[ T = -m g l\cos\theta. \]", WRONG),
        (r"The kinetic energy $T$ is \[ T = -m g l\sin\theta. \]", WRONG),
        (
            r"The difference of kinetic and potential energy, $L=T-V$, is $L = \frac12 m l^2"
            r"\dot\theta^2 + m g l\cos\theta$",
            RIGHT,
        ),
    ],
)
def test_prose_says_what_a_letter_is(text: str, verdict: tuple[Verdict, ...]) -> None:
    assert answer("pendulum", text).verdict in verdict, str(answer("pendulum", text))


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("theta'' = g/l*sin(theta)", Verdict.UNDECIDED),
        ("theta'' = g/l*sin(theta)\nV = -m*g*l*cos(theta)", Verdict.REFUTED),
        ("theta'' = -g/(2*l)*sin(theta)", Verdict.REFUTED),
        ("theta'' = -g/l*theta", Verdict.REFUTED),
        (r"For small angles $\ddot\theta = -\frac gl\theta$.", Verdict.PROVED),
        (r"For small angles $\ddot\theta = -\frac{2g}{l}\theta$.", Verdict.REFUTED),
        (r"For small oscillations $\ddot\theta = -\frac gl\theta^2$.", Verdict.REFUTED),
        ("theta'' = g/l*theta", Verdict.REFUTED),
    ],
)
def test_a_convention_may_be_meant_where_it_mends_all(text: str, verdict: Verdict) -> None:
    found = answer("pendulum", text)
    assert found.verdict is verdict, str(found)


def test_one_equation_of_two_is_mended_by_any_convention() -> None:
    wrong = "(M + m)*x'' + 2*k*x - M*L/2*(theta''*cos(theta) - theta'^2*sin(theta)) = 0"
    found = check(elastic_pendulum.scene(), wrong)
    assert found.verdict is Verdict.REFUTED
    assert found.judged[0].right_if
    assert not found.judged[0].open


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("scene", "text", "verdict"),
    [
        ("hoop", r"There is an equilibrium at $\cos\theta_0 = g/(\omega^2 R)$.", RIGHT),
        (
            "hoop",
            r"There is an equilibrium at $\cos\theta_0 = R/(\omega^2 g)$.",
            (Verdict.REFUTED,),
        ),
        (
            "hoop",
            r"There is an equilibrium at $\sin\theta_0 = g/(\omega^2 R)$.",
            (Verdict.REFUTED,),
        ),
        ("hoop", r"\[ \cos\theta = g/(\omega^2 R) \]", WRONG),
        ("damped", r"It is at rest where $c x_0 = m$.", (Verdict.UNDECIDED,)),
    ],
)
def test_an_equilibrium_is_a_condition_of_rest(
    scene: str, text: str, verdict: tuple[Verdict, ...]
) -> None:
    assert answer(scene, text).verdict in verdict, str(answer(scene, text))
