"""The equations of the seed document's problem 2, part (a), typed by hand: the rocker's shapes."""

from sympy import Mul, Rational, pi

from mechanics.scene.published import Published, published
from mechanics.scene.quantities import Centroid, Inertia, Mass
from mechanics.scene.typed import as_printed, rounded
from systems.rocker import (
    CIRCLE,
    I_1,
    I_2,
    I_C1,
    MIDDLE,
    ROCKER,
    UPPER,
    I_o,
    M,
    R,
    h,
    m_1,
    m_2,
    rho,
    ybar,
)

CENTRE = (0, 0)
ONE_OF_TWO = "stated for one of the two half discs; both are alike"

PUBLISHED: tuple[Published, ...] = (
    published("m_1", Mass(UPPER), rho * h * pi * R**2 / 2, label="mass of a half disc"),
    published("m_2", Mass(MIDDLE), 2 * rho * h * R**2, label="mass of the rectangle"),
    published("M", Mass(ROCKER), 2 * m_1 + m_2, label="total mass from the parts"),
    published(
        "M",
        Mass(ROCKER),
        rho * h * (2 * pi * R**2 / 2 + 2 * R**2),
        label="total mass, parts written out",
    ),
    published("M", Mass(ROCKER), rho * h * R**2 * (pi + 2), label="total mass"),
    published(
        "(1)", Inertia(ROCKER), 2 * I_1 + I_2, label="total moment of inertia from the parts"
    ),
    published(
        "(2)",
        Inertia(MIDDLE, CENTRE),
        m_2 * as_printed(R**2, (2 * R) ** 2) / 12,
        label="moment of inertia of the rectangle",
    ),
    published(
        "(2)",
        Inertia(MIDDLE, CENTRE),
        Rational(5, 12) * m_2 * R**2,
        label="moment of inertia of the rectangle, by its mass",
    ),
    published(
        "(2)",
        Inertia(MIDDLE, CENTRE),
        Rational(5, 6) * rho * h * R**4,
        label="moment of inertia of the rectangle, by its density",
    ),
    published(
        "parallel axis C",
        Inertia(UPPER, CENTRE),
        I_C1 + m_1 * (R / 2 + ybar) ** 2,
        label="a half disc about C from its own centroid",
        note=ONE_OF_TWO,
    ),
    published(
        "y bar",
        Centroid(UPPER, "y", CIRCLE),
        4 * R / (3 * pi),
        label="centroid of a half disc from the centre of its circle",
    ),
    published(
        "parallel axis O",
        Inertia(UPPER, CIRCLE),
        I_C1 + m_1 * ybar**2,
        label="a half disc about the centre of its circle",
    ),
    published(
        "parallel axis O",
        Inertia(UPPER),
        I_o - m_1 * ybar**2,
        label="a half disc about its centroid, from the centre of its circle",
    ),
    published(
        "I_o",
        Inertia(UPPER, CIRCLE),
        Mul(Rational(1, 2), 2 * m_1, R**2 / 2, evaluate=False),
        label="one half of a full disc's moment of inertia",
    ),
    published(
        "I_o",
        Inertia(UPPER, CIRCLE),
        m_1 * R**2 / 2,
        label="moment of inertia of a half disc about the centre of its circle",
    ),
    published(
        "I_C1",
        Inertia(UPPER),
        m_1 * (R**2 / 2 - ybar**2),
        label="moment of inertia of a half disc about its centroid",
    ),
    published(
        "(3)",
        Inertia(UPPER, CENTRE),
        m_1 * as_printed(R**2 / 2, -(ybar**2), R**2 / 4, R * ybar, ybar**2),
        label="moment of inertia of a half disc about C, inserted",
    ),
    published(
        "(3)",
        Inertia(UPPER, CENTRE),
        m_1 * R**2 * (Rational(3, 4) + 4 / (3 * pi)),
        label="moment of inertia of a half disc about C, by its mass",
    ),
    published(
        "(3)",
        Inertia(UPPER, CENTRE),
        (3 * pi / 8 + Rational(2, 3)) * rho * h * R**4,
        label="moment of inertia of a half disc about C, by its density",
    ),
    published(
        "I_C",
        Inertia(ROCKER),
        as_printed(
            Mul(2, 3 * pi / 8 + Rational(2, 3), evaluate=False),
            Rational(5, 6),
        )
        * rho
        * h
        * R**4,
        label="moment of inertia of the rocker, parts inserted",
    ),
    published(
        "I_C",
        Inertia(ROCKER),
        (9 * pi + 26) / 12 * rho * h * R**4,
        label="moment of inertia of the rocker, by its density",
    ),
    published(
        "I_C",
        Inertia(ROCKER),
        (9 * pi + 26) / (12 * (pi + 2)) * M * R**2,
        label="moment of inertia of the rocker, by its mass",
    ),
    published(
        "I_C",
        Inertia(ROCKER),
        rounded("0.88") * M * R**2,
        label="moment of inertia of the rocker, rounded",
    ),
)
