"""The equations of the seed document's problem 2, parts (b), (d) and (e), typed by hand.

Small motions of the rocker about its upright equilibrium, and their control.
"""

from sympy import Gt, Lt, Rational, symbols
from sympy.physics.mechanics import dynamicsymbols

from mechanics.scene.linear_quantities import (
    EquilibriumStability,
    FeedbackLaw,
    InertiaAbout,
    Laplace,
    LinearizedEquation,
    PoleEquation,
    ProportionalFeedback,
    StabilityBoundary,
    StabilityRegion,
    TransferFunction,
    TransformedEquation,
    operating_point,
)
from mechanics.scene.published import Published, published
from mechanics.scene.typed import as_printed
from systems.rocker import I_C, M, R, f, g, theta

t = dynamicsymbols._t
# The gain is real, not positive: for small and for negative gains the rocker falls.
K, theta_d = symbols("K theta_d", real=True)
s, Theta, Theta_d, F = symbols("s Theta Theta_d F", real=True)
I_A = symbols("I_A", positive=True)

UPRIGHT = operating_point({"theta": 0}, {"f": 0})
LOOP = ProportionalFeedback("f", "theta", K, theta_d)
LAPLACE = Laplace(s, (("theta", Theta), ("f", F), ("theta_d", Theta_d)))
# A' is the point that touches the floor at B when the rocker is upright.
INERTIA = InertiaAbout(UPRIGHT, "rocker", "B", "theta")
WITH_I_A = ((I_A, INERTIA),)

PUBLISHED: tuple[Published, ...] = (
    published(
        "(b)",
        EquilibriumStability(UPRIGHT),
        "unstable",
        label="the upright equilibrium without control",
    ),
    published(
        "(8)",
        LinearizedEquation(UPRIGHT),
        (I_C + Rational(9, 4) * M * R**2) * theta.diff(t, 2) - M * g * R / 2 * theta,
        3 * R / 2 * f,
        label="linearized equation of motion",
        latex=(
            r"\left(I_{C}+\frac{9}{4} M R^{2}\right) \ddot{\theta}-M g \frac{R}{2} \theta="
            r"\frac{3 R}{2} f(t)"
        ),
    ),
    published(
        "I_A'",
        INERTIA,
        I_C + M * (3 * R / 2) ** 2,
        label="moment of inertia about the extreme bottom point",
    ),
    published(
        "(9)",
        TransformedEquation(UPRIGHT, LAPLACE, where=WITH_I_A),
        (I_A * s**2 - M * g * R / 2) * Theta,
        3 * R / 2 * F,
        label="transform of (8)",
    ),
    published(
        "Theta/F",
        TransferFunction(UPRIGHT, s, "theta", "f", where=WITH_I_A),
        (3 * R / 2) / (I_A * s**2 - M * g * R / 2),
        label="transfer function from the force to the angle",
    ),
    published(
        "f(t)",
        FeedbackLaw(UPRIGHT, LOOP),
        f,
        K * (theta_d - theta),
        label="control force",
    ),
    published(
        "(10)",
        FeedbackLaw(UPRIGHT, LOOP, LAPLACE),
        F,
        K * (Theta_d - Theta),
        label="control force in the s-domain",
    ),
    published(
        "closed loop",
        TransformedEquation(UPRIGHT, LAPLACE, LOOP, where=WITH_I_A),
        (I_A * s**2 - M * g * R / 2) * Theta,
        K * 3 * R / 2 * (Theta_d - Theta),
        label="(10) inserted into (9)",
    ),
    published(
        "closed loop",
        TransformedEquation(UPRIGHT, LAPLACE, LOOP, where=WITH_I_A),
        as_printed(I_A * s**2, K * 3 * R / 2, -M * g * R / 2) * Theta,
        K * 3 * R / 2 * Theta_d,
        label="closed-loop equation",
    ),
    published(
        "Theta/Theta_d",
        TransferFunction(UPRIGHT, s, "theta", "theta_d", LOOP, where=WITH_I_A),
        (K * 3 * R / 2) / (I_A * s**2 + K * 3 * R / 2 - M * g * R / 2),
        label="transfer function from the desired to the actual angle",
    ),
    published(
        "poles",
        PoleEquation(UPRIGHT, s, LOOP, where=WITH_I_A),
        s**2,
        -(3 * K - M * g) * (R / 2) / I_A,
        label="poles of the closed loop",
    ),
    published(
        "K",
        StabilityBoundary(UPRIGHT, LOOP),
        M * g / 3,
        label="gain on the borderline between stability and instability",
    ),
    published(
        "K smaller",
        StabilityRegion(UPRIGHT, LOOP, stable=False),
        Lt(K, M * g / 3),
        label="for smaller values of K the system is unstable",
    ),
    published(
        "K larger",
        StabilityRegion(UPRIGHT, LOOP, stable=True),
        Gt(K, M * g / 3),
        label="for larger values of K the system is stable",
    ),
)
