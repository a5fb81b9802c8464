"""Energies count in what a scene declares as a force: at the point that the body carries there."""

from collections.abc import Callable

import particles
import pytest
from sympy import cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import check
from mechanics.kernel import Verdict
from mechanics.scene import Particle, RigidBody, Scene, force, parameters, reaction


def roller() -> Scene:
    """A wheel that rolls by x, a spring written as a force at its top, a push at its centre."""
    (x, F), (M, R, J, k, c) = (
        dynamicsymbols("x F"), parameters("M R J k c", units="kg m kg*m^2 N/m N*s/m")
    )  # fmt: skip
    N, O = ReferenceFrame("N"), Point("O")
    A, G = N.orientnew("A", "Axis", (-x / R, N.z)), O.locatenew("G", x * N.x)
    ground, top = G.locatenew("K", -R * N.y), G.locatenew("T", R * N.y)
    return Scene(
        "wheel", N, O, coordinates=(x,), inputs=(F,), plane=N.z,
        bodies=(RigidBody("wheel", G, A, M, J),),
        loads=(
            force("spring", top, -2 * k * x * N.x, on="wheel"),
            force("push", G, (F - k * x - c * x.diff()) * N.x, on="wheel"),
        ),
        reactions=(
            reaction("f", at=ground, on="wheel", by=None, along=N.x),
            reaction("n", at=ground, on="wheel", by=None, along=N.y),
        ),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"V = \frac12 k (2x)^2 + \frac12 k x^2", Verdict.PROVED),
        (r"V = \frac12 k x^2 + \frac12 k x^2", Verdict.REFUTED),
        (r"V = \frac12 k (2x)^2 - F x", Verdict.REFUTED),
    ],
)
def test_springs_that_are_forces_have_a_potential_beside_inputs(
    text: str, verdict: Verdict
) -> None:
    assert check(roller(), text, blame=False).verdict is verdict


def test_an_input_by_the_letter_of_an_energy_is_no_energy() -> None:
    assert check(roller(), "U = F", blame=False).verdict is Verdict.UNDECIDED


def wagon() -> Scene:
    """A wagon on a spring to a place z that is moved."""
    (x, z), (m, k) = dynamicsymbols("x z"), parameters("m k", units="kg N/m")
    return particles.on_line(
        "wagon", x, m, lambda N, O, P: [force("spring", P, -k * (x - z) * N.x, on="wagon")],
        body="wagon", inputs=(z,),
    )  # fmt: skip


def plate() -> Scene:
    """A point on a plate that turns, springs that are forces along its axes."""
    (x, y), (m, a, b, W) = (
        dynamicsymbols("x y"), parameters("m a b W", units="kg N/m N/m 1/s")
    )  # fmt: skip
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (W * dynamicsymbols._t, N.z))
    C = O.locatenew("C", x * A.x + y * A.y)
    springs = force("springs", C, -a * x * A.x - b * y * A.y, on="point")
    up = reaction("up", at=C, on="point", by=None, along=N.z)
    return Scene("plate", N, O, coordinates=(x, y), loads=(springs,), reactions=(up,),
                 bodies=(Particle("point", C, m),), example={"x": 0.4, "y": 0.3})  # fmt: skip


@pytest.mark.parametrize(
    ("scene", "text", "verdict"),
    [
        (wagon, r"V = \frac12 k (x - z)^2", Verdict.PROVED),
        (wagon, r"V = \frac12 k (x + z)^2", Verdict.REFUTED),
        (wagon, r"V = \frac12 k x^2 - k x z + k z^2", Verdict.REFUTED),
        (wagon, r"L = \frac12 m \dot x^2 - \frac12 k (x - z)^2", Verdict.PROVED),
        (plate, r"V = \frac12 (a x^2 + b y^2)", Verdict.PROVED),
        (plate, r"V = \frac12 (a x^2 - b y^2)", Verdict.REFUTED),
    ],
)
def test_a_spring_to_what_moves_has_its_potential(
    scene: Callable[[], Scene], text: str, verdict: Verdict
) -> None:
    assert check(scene(), text, blame=False).verdict is verdict


def driven() -> Scene:
    """A mass on a spring and a damper, driven by F_0 cos(omega t), all in one force."""
    y, (m, k, l, b, F0, w) = (
        dynamicsymbols("y"), parameters("m k l b F_0 omega", units="kg N/m m N*s/m N 1/s")
    )  # fmt: skip
    strength = F0 * cos(w * dynamicsymbols._t) - k * (y - l) - b * y.diff()
    return particles.on_line(
        "driven", y, m, lambda N, O, P: [force("all", P, strength * N.x, on="mass")]
    )


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"V = \frac12 k (y - l)^2", Verdict.PROVED),
        (r"V = \frac12 k (y + l)^2", Verdict.REFUTED),
        (r"V = \frac12 k (y - l)^2 - F_0 y \cos\omega t", Verdict.REFUTED),
        (r"L = \frac12 m \dot y^2 - \frac12 k (y - l)^2", Verdict.PROVED),
        (r"L = \frac12 m \dot y^2 + \frac12 k (y - l)^2", Verdict.REFUTED),
    ],
)
def test_a_drive_beside_a_spring_is_no_part_of_its_potential(text: str, verdict: Verdict) -> None:
    assert check(driven(), text).verdict is verdict


@pytest.mark.parametrize(
    ("scene", "text", "edit"),
    [
        (roller, r"V = \frac12 k (2x)^2 - \frac12 k x^2", ("-", "+")),
        (driven, r"L = \frac12 m \dot y^2 - \frac12 k (y + l)^2", ("+", "-")),
    ],
)
def test_a_mistake_in_the_potential_of_a_force_is_named(
    scene: Callable[[], Scene], text: str, edit: tuple[str, str]
) -> None:
    (entry,) = check(scene(), text).judged
    assert entry.blame is not None
    edits = [edit for repair in entry.blame.repairs for edit in repair.edits]
    assert edit in [(one.written, one.right) for one in edits]
    assert len(edits) == len(entry.blame.repairs)
