"""Derivatives of forward dynamics are those of what was derived, whatever turns a joint."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import Particle, Scene, compile, derive, gravity, parameters, reaction
from mechanics.compiled import prove_compiled


def incline() -> Scene:
    """A double pendulum on a cart that slides down an incline of angle beta."""
    x, theta, phi = dynamicsymbols("x theta phi")
    M, m, l, g, beta = parameters("M m l g beta")
    N, O = ReferenceFrame("N"), Point("O")
    cart = O.locatenew("P", x * (cos(beta) * N.x + sin(beta) * N.y))
    A = N.orientnew("A", "Axis", (theta, N.z))
    upper = cart.locatenew("Q", -l * A.y)
    B = A.orientnew("B", "Axis", (phi, A.z))
    lower = upper.locatenew("R", -l * B.y)
    normal = -sin(beta) * N.x + cos(beta) * N.y
    return Scene(
        "incline",
        N,
        O,
        coordinates=(x, theta, phi),
        bodies=(
            Particle("cart", cart, M),
            Particle("upper", upper, m),
            Particle("lower", lower, m),
        ),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("S", at=cart, on="cart", by=None, along=normal),
            reaction("T", at=upper, on="upper", by="cart", along=A.y),
            reaction("U", at=lower, on="lower", by="upper", along=B.y),
        ),
    )


def test_by_a_parameter_that_turns_the_axis_of_a_joint() -> None:
    findings = prove_compiled(compile(derive(incline()), compiler=None))
    assert any("jacobians" in finding.subject for finding in findings)
    assert not [finding for finding in findings if not finding.shown]
