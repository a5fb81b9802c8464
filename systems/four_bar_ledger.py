"""Dynamic force analysis of the four-bar linkage, as textbooks of mechanisms set it up.

The nine equations of three free bodies, and the power equation ("virtual work"). Common knowledge
in this field rather than one author's text: typed by hand from the free-body diagrams.
"""

from sympy import cos, sin, symbols

from mechanics.scene.published import Published, published
from mechanics.scene.quantities import AngularMomentumPrinciple, EquationOfMotion, MomentumPrinciple
from systems.four_bar import g, l1, l2, l3, m1, m2, m3, q1, q2, q3, tau

Ax, Ay, Bx, By, Cx, Cy, Dx, Dy = symbols("Ax Ay Bx By Cx Cy Dx Dy", real=True)
w1, w2, w3 = (q.diff() for q in (q1, q2, q3))
a1, a2, a3 = (q.diff().diff() for q in (q1, q2, q3))

PUBLISHED: tuple[Published, ...] = (
    published(
        "crank, x",
        MomentumPrinciple("crank", "x"),
        Ax - Bx,
        -m1 * l1 / 2 * (a1 * sin(q1) + w1**2 * cos(q1)),
        label="forces on the crank along x",
    ),
    published(
        "crank, y",
        MomentumPrinciple("crank", "y"),
        Ay - By - m1 * g,
        m1 * l1 / 2 * (a1 * cos(q1) - w1**2 * sin(q1)),
        label="forces on the crank along y",
    ),
    published(
        "crank, z",
        AngularMomentumPrinciple("crank", "z"),
        tau + l1 / 2 * ((Ax + Bx) * sin(q1) - (Ay + By) * cos(q1)),
        m1 * l1**2 / 12 * a1,
        label="moments on the crank about its mass centre",
    ),
    published(
        "coupler, x",
        MomentumPrinciple("coupler", "x"),
        Bx - Cx,
        -m2 * l1 * (a1 * sin(q1) + w1**2 * cos(q1))
        - m2 * l2 / 2 * (a2 * sin(q2) + w2**2 * cos(q2)),
        label="forces on the coupler along x",
    ),
    published(
        "coupler, y",
        MomentumPrinciple("coupler", "y"),
        By - Cy - m2 * g,
        m2 * l1 * (a1 * cos(q1) - w1**2 * sin(q1)) + m2 * l2 / 2 * (a2 * cos(q2) - w2**2 * sin(q2)),
        label="forces on the coupler along y",
    ),
    published(
        "coupler, z",
        AngularMomentumPrinciple("coupler", "z"),
        l2 / 2 * ((Bx + Cx) * sin(q2) - (By + Cy) * cos(q2)),
        m2 * l2**2 / 12 * a2,
        label="moments on the coupler about its mass centre",
    ),
    published(
        "rocker, x",
        MomentumPrinciple("rocker", "x"),
        Cx + Dx,
        m3 * l3 / 2 * (a3 * sin(q3) + w3**2 * cos(q3)),
        label="forces on the rocker along x",
        note="the mass centre turns about the ground pivot D",
    ),
    published(
        "rocker, y",
        MomentumPrinciple("rocker", "y"),
        Cy + Dy - m3 * g,
        m3 * l3 / 2 * (w3**2 * sin(q3) - a3 * cos(q3)),
        label="forces on the rocker along y",
        note="the mass centre turns about the ground pivot D",
    ),
    published(
        "rocker, z",
        AngularMomentumPrinciple("rocker", "z"),
        l3 / 2 * ((Cx - Dx) * sin(q3) - (Cy - Dy) * cos(q3)),
        m3 * l3**2 / 12 * a3,
        label="moments on the rocker about its mass centre",
    ),
    published(
        "power",
        EquationOfMotion(),
        tau * w1
        - g * (m1 * l1 / 2 * cos(q1) * w1 + m2 * (l1 * cos(q1) * w1 + l2 / 2 * cos(q2) * w2))
        + g * m3 * l3 / 2 * cos(q3) * w3,
        m1 * l1**2 / 3 * a1 * w1
        + m2 * (l1**2 * a1 * w1 + l2**2 / 3 * a2 * w2)
        + m2 * l1 * l2 / 2 * cos(q1 - q2) * (w1 * a2 + w2 * a1)
        + m2 * l1 * l2 / 2 * sin(q1 - q2) * w1 * w2 * (w2 - w1)
        + m3 * l3**2 / 3 * a3 * w3,
        label="power of torque and weights is the rate of kinetic energy",
    ),
)
