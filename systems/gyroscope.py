"""Symmetric rotor in two gimbals: Cardan suspension, all axes through one point.

    alpha   of the outer gimbal, about an axis at rest
    beta    of the inner gimbal; the rotor's axis is across the outer gimbal's at beta = 0
    gamma   of the rotor in the inner gimbal

Gimbals count: without them the rotor could be spun about any axis. The equations are those of
textbooks on gyroscopes, as K. Magnus, "Kreisel: Theorie und Anwendungen" (1971), with the first
integrals of alpha and gamma; nothing is weighed, since all mass centres are at rest.
"""

from sympy import Rational, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import Outline, RigidBody, Scene, parameters, pin
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, GeneralizedMomentum, KineticEnergy
from mechanics.scene.typed import d_dt

alpha, beta, gamma = dynamicsymbols("alpha beta gamma")
A, C, A1, B1, C1, D = parameters(
    "A C A1 B1 C1 D",
    units="kg*m^2 kg*m^2 kg*m^2 kg*m^2 kg*m^2 kg*m^2",
    typical="0.0005 0.0009 0.0003 0.0002 0.0004 0.0006",
    meanings=(
        "inertia of the rotor across its axis",
        "inertia of the rotor about its axis",
        "inertia of the inner gimbal across its axis and the rotor's",
        "inertia of the inner gimbal about its axis",
        "inertia of the inner gimbal about the rotor's axis",
        "inertia of the outer gimbal about its axis",
    ),
)


def scene() -> Scene:
    """Three bodies, each on a pin in the one before."""
    ground, centre = ReferenceFrame("N"), Point("O")
    outer = pin("outer", None, "outer gimbal", at=centre, axis=ground.z, angle=alpha)
    inner = pin("inner", "outer gimbal", "inner gimbal", at=centre, axis=outer.frame.x, angle=beta)
    bearing = pin("bearing", "inner gimbal", "rotor", at=centre, axis=inner.frame.y, angle=gamma)
    moments = (
        ("outer gimbal", outer.frame, (0, 0, D)),
        ("inner gimbal", inner.frame, (B1, C1, A1)),
        ("rotor", bearing.frame, (A, C, A)),
    )
    rings = {
        "outer gimbal": (Outline(_cm(12) * outer.frame.x, _cm(12) * outer.frame.z),),
        "inner gimbal": (Outline(_cm(10) * inner.frame.x, _cm(10) * inner.frame.y),),
        "rotor": (
            Outline(_cm(10) * bearing.frame.y),
            Outline(_cm(7) * bearing.frame.x, _cm(7) * bearing.frame.z, filled=True),
        ),
    }
    return Scene(
        "gyroscope",
        ground,
        centre,
        bodies=tuple(
            RigidBody(name, centre, frame, 0, inertia(frame, *values), rings[name])
            for name, frame, values in moments
        ),
        joints=(outer, inner, bearing),
        example={"beta": 0.3, "gamma_dot": 400.0},
    )


def _cm(count: int) -> Rational:
    """A length that drawings have; no equation has any."""
    return Rational(count, 100)


spin = gamma.diff() + alpha.diff() * sin(beta)
across = D + (A + A1) * cos(beta) ** 2 + C1 * sin(beta) ** 2
p_alpha = across * alpha.diff() + C * spin * sin(beta)
p_gamma = C * spin

PUBLISHED = (
    published(
        "T",
        KineticEnergy(),
        (across * alpha.diff() ** 2 + (A + B1) * beta.diff() ** 2 + C * spin**2) / 2,
        label="kinetic energy",
    ),
    published("p_gamma", GeneralizedMomentum("gamma"), p_gamma, label="momentum of the spin"),
    published("p_alpha", GeneralizedMomentum("alpha"), p_alpha, label="of the outer gimbal"),
    published("spin", EquationOfMotion(), d_dt(p_gamma), 0, label="the first stays constant"),
    published("outer", EquationOfMotion(), d_dt(p_alpha), 0, label="so does the second"),
    published(
        "inner",
        EquationOfMotion(),
        (A + B1) * beta.diff().diff(),
        p_gamma * alpha.diff() * cos(beta)
        - (A + A1 - C1) * alpha.diff() ** 2 * sin(beta) * cos(beta),
        label="equation of the inner gimbal",
    ),
)
