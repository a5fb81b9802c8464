"""Every displayed equation of the seed document's problem 3, typed by hand."""

from sympy import Derivative, ImmutableMatrix, Rational, Symbol, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from mechanics.scene.linear_quantities import (
    BackSubstitution,
    CharacteristicPolynomial,
    DimensionlessMatrices,
    DimensionlessParameter,
    DimensionlessProblem,
    Eigenvalue,
    EigenvalueProblem,
    LinearizedEquation,
    ModalMatrix,
    ModeShape,
    PrintedEigenvalues,
    PrintedShapes,
    TrialSolution,
    operating_point,
)
from mechanics.scene.published import Published, published
from mechanics.scene.quantities import MomentumPrinciple
from mechanics.scene.typed import as_printed, rounded
from systems.two_mass_chain import k, m, x1, x2

t = dynamicsymbols._t
a1, a2, phi = symbols("a1 a2 phi", real=True)
omega = Symbol("omega", positive=True)
lambda_ = Symbol("lambda", real=True)

AT_REST = operating_point({"x1": 0, "x2": 0})
AMPLITUDES = (a1, a2)


def matrix(*rows: tuple) -> ImmutableMatrix:
    return ImmutableMatrix(rows)


def column(*entries: object) -> ImmutableMatrix:
    return ImmutableMatrix(entries)


x = column(x1, x2)
a = column(a1, a2)
K = matrix((2 * k, -k), (-k, k))
M = matrix((3 * m, 0), (0, 2 * m))
NUMBERS_K = matrix((2, -1), (-1, 1))
NUMBERS_M = matrix((3, 0), (0, 2))

MOMENTUM: tuple[Published, ...] = (
    published(
        "first mass",
        MomentumPrinciple("first", "x"),
        -k * x1 + k * (x2 - x1),
        Derivative(3 * m * x1.diff(t), t),
        3 * m * x1.diff(t, 2),
        label="momentum principle for the mass 3 m",
        latex=(
            r"-k x_{1}+k\left(x_{2}-x_{1}\right)=\frac{d}{d t}\left(3 m \dot{x}_{1}\right)="
            r"3 m \ddot{x}_{1}"
        ),
    ),
    published(
        "second mass",
        MomentumPrinciple("second", "x"),
        -k * (x2 - x1),
        Derivative(2 * m * x2.diff(t), t),
        2 * m * x2.diff(t, 2),
        label="momentum principle for the mass 2 m",
        latex=(
            r"-k\left(x_{2}-x_{1}\right)=\frac{d}{d t}\left(2 m \dot{x}_{2}\right)=2 m "
            r"\ddot{x}_{2}"
        ),
    ),
)

MODES: tuple[Published, ...] = (
    published(
        "(1)",
        LinearizedEquation(AT_REST),
        -K * x,
        M * x.diff(t, 2),
        label="equations of motion in matrix form",
        latex=(
            r"-\left[\begin{array}{rr} 2 k & -k\\ -k & k "
            r"\end{array}\right]\left\{\begin{array}{l} x_{1} \\ x_{2} \end{array}\right\}="
            r"\left[\begin{array}{rr} 3 m & 0 \\ 0 & 2 m "
            r"\end{array}\right]\left\{\begin{array}{l} \ddot{x}_{1} \\ \ddot{x}_{2} "
            r"\end{array}\right\}"
        ),
    ),
    published(
        "trial",
        TrialSolution(AT_REST, AMPLITUDES, omega, phi, t),
        a * sin(omega * t + phi),
        label="form of the free vibrations",
    ),
    published(
        "(2)",
        EigenvalueProblem(AT_REST, AMPLITUDES, omega),
        K * a,
        omega**2 * M * a,
        label="eigenvalue problem",
    ),
    published(
        "(3)",
        EigenvalueProblem(AT_REST, AMPLITUDES, omega),
        matrix((2 * k - 3 * m * omega**2, -k), (-k, k - 2 * m * omega**2)) * a,
        column(0, 0),
        label="eigenvalue problem, all terms on the left",
    ),
    published(
        "characteristic",
        CharacteristicPolynomial(AT_REST, omega),
        as_printed(2 * k**2, -7 * k * m * omega**2, 6 * m**2 * omega**4, -(k**2)),
        label="determinant that has to vanish, written out",
    ),
    published(
        "characteristic",
        CharacteristicPolynomial(AT_REST, omega),
        k**2 - 7 * k * m * omega**2 + 6 * m**2 * omega**4,
        label="determinant that has to vanish",
    ),
    published(
        "characteristic",
        CharacteristicPolynomial(AT_REST, omega),
        (k - m * omega**2) * (k - 6 * m * omega**2),
        label="determinant that has to vanish, in factors",
    ),
    published(
        "omega_1^2",
        Eigenvalue(AT_REST, 1),
        Rational(1, 6) * k / m,
        label="eigenvalue of the first mode",
    ),
    published("omega_2^2", Eigenvalue(AT_REST, 2), k / m, label="eigenvalue of the second mode"),
    published(
        "(3) at omega_1",
        BackSubstitution(AT_REST, AMPLITUDES, 1),
        matrix((Rational(3, 2) * k, -k), (-k, Rational(2, 3) * k)) * a,
        column(0, 0),
        label="first eigenvalue inserted",
    ),
    published(
        "mode 1",
        ModeShape(AT_REST, 1),
        column(Rational(2, 3), 1),
        label="shape of the first mode",
    ),
    published(
        "(3) at omega_2",
        BackSubstitution(AT_REST, AMPLITUDES, 2),
        matrix((-k, -k), (-k, -k)) * a,
        column(0, 0),
        label="second eigenvalue inserted",
    ),
    published("mode 2", ModeShape(AT_REST, 2), column(-1, 1), label="shape of the second mode"),
    published(
        "Phi",
        ModalMatrix(AT_REST),
        matrix((Rational(2, 3), -1), (1, 1)),
        label="modal matrix, lowest frequency first, largest element one",
    ),
    published(
        "dimensionless",
        DimensionlessProblem(AT_REST, AMPLITUDES, lambda_),
        NUMBERS_K * a,
        lambda_ * NUMBERS_M * a,
        label="eigenvalue problem without dimensions",
    ),
    published(
        "lambda",
        DimensionlessParameter(AT_REST, omega),
        m * omega**2 / k,
        label="dimensionless parameter",
    ),
    published(
        "K, M",
        DimensionlessMatrices(AT_REST),
        NUMBERS_K,
        NUMBERS_M,
        label="matrices as given to MATLAB",
        note="the source prints both without the semicolons between their rows",
    ),
    published(
        "V",
        PrintedShapes(AT_REST, largest_first=True),
        matrix((rounded("0.7071"), rounded("0.5547")), (rounded("-0.7071"), rounded("0.8321"))),
        label="MATLAB's modal vectors: largest eigenvalue first, columns of unit length",
        note="the sign of a column is free",
    ),
    published(
        "D",
        PrintedEigenvalues(AT_REST, largest_first=True),
        matrix((rounded("1.0000"), 0), (0, rounded("0.1667"))),
        label="MATLAB's eigenvalues, largest first",
    ),
    published(
        "D, engineering",
        PrintedEigenvalues(AT_REST, largest_first=False),
        matrix((rounded("0.1667"), 0), (0, rounded("1.0000"))),
        label="the same in the engineering order, lowest frequency first",
        note="stated in words after the MATLAB session; Phi above has the engineering scaling",
    ),
)

PUBLISHED: tuple[Published, ...] = MOMENTUM + MODES
