"""Energies count in what a scene declares as a force: at the point that the body carries there."""

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import check
from mechanics.kernel import Verdict
from mechanics.scene import RigidBody, Scene, force, parameters, reaction


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
