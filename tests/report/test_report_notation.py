"""Expressions as a textbook sets them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Derivative, Expr, Float, Matrix, Rational, Symbol, cos, pi, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from mechanics.report.notation import latex, latex_name, mathml, operations, pieces, svg_name
from mechanics.scene import parameters

M, m, L, k, g = parameters("M m L k g", units="kg kg m N/m m/s^2")
t = dynamicsymbols._t
X, THETA = dynamicsymbols("x theta")
x, theta, theta_dot, theta_ddot, x_ddot = symbols("x theta theta_dot theta_ddot x_ddot", real=True)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("x", "x"),
        ("x_dot", r"\dot{x}"),
        ("theta_ddot", r"\ddot{\theta}"),
        ("theta1_dot", r"\dot{\theta}_{1}"),
        ("I_C", "I_{C}"),
        ("I_C1", "I_{C1}"),
        ("Ty1", "T_{y1}"),
        ("omega_0", r"\omega_{0}"),
        ("yaw", r"\mathrm{yaw}"),
        ("yaw_dot", r"\dot{\mathrm{yaw}}"),
    ],
)
def test_names(name: str, expected: str) -> None:
    assert latex_name(name) == expected


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (L * M * g * sin(theta) / 2, r"\tfrac{1}{2} M g L \sin \theta"),
        (L**2 * M * theta_ddot / 12, r"\tfrac{1}{12} M L^{2} \ddot{\theta}"),
        (x_ddot * (M + m), r"\left(M + m\right) \ddot{x}"),
        (sin(theta) ** 2 * cos(2 * theta), r"\cos 2 \theta \sin^{2} \theta"),
        (cos(theta - x), r"\cos \left(\theta - x\right)"),
        (sqrt(k / m), r"\sqrt{\frac{k}{m}}"),
        (k / m / 6, r"\frac{k}{6 m}"),
        (M / (pi + 2), r"\frac{M}{2 + \pi}"),
        (Symbol("T") - k * x, "T - k x"),
        (-Rational(3, 2) * L, r"-\tfrac{3}{2} L"),
        (Float("1.0000", 5), "1.0000"),
        (2.5 * k, "2.5 k"),
        (X.diff(t, 2), r"\ddot{x}"),
        (M * THETA.diff(t) ** 2, r"M \dot{\theta}^{2}"),
        (Derivative(M * X * cos(THETA), t), r"\frac{d}{dt}\left[M x \cos \theta\right]"),
    ],
)
def test_expressions(expression: Expr, expected: str) -> None:
    assert latex(expression) == expected


def test_terms_with_accelerations_stand_first() -> None:
    row = (M + m) * x_ddot + 2 * k * x - M * L / 2 * theta_dot**2 * sin(theta)
    assert pieces(row) == [
        r"\left(M + m\right) \ddot{x}",
        r"- \tfrac{1}{2} M L \dot{\theta}^{2} \sin \theta",
        "+ 2 k x",
    ]


def test_a_vector_has_unit_vectors() -> None:
    assert pieces(Matrix([0, 0, k * x])) == [r"k x \vec{u}_{z}"]
    assert pieces(Matrix([x, -L, 0])) == [r"x \vec{u}_{x}", r"- L \vec{u}_{y}"]
    assert pieces(Matrix([0, 0, L + x])) == [r"\bigl[ L", r"+ x \bigr] \vec{u}_{z}"]
    assert pieces(Matrix([0, 0, 0])) == [r"\vec{0}"]


@given(
    st.lists(st.sampled_from([M, m, L, x, theta_dot, sin(theta), cos(x)]), max_size=5),
    st.fractions(min_value=-9, max_value=9, max_denominator=9),
)
def test_pieces_are_the_sum(factors: list[Expr], number: object) -> None:
    product: Expr = Rational(str(number))
    for factor in factors:
        product *= factor
    total = product + k * theta_ddot
    # Every term is there once, and braces are balanced, so that each piece stands by itself.
    found = pieces(total)
    assert len(found) == len(total.args) if total.is_Add else len(found) == 1
    assert all(piece.count("{") == piece.count("}") for piece in found)


def test_mathml_is_inline_in_display_style() -> None:
    text = mathml("+ k x")
    assert text.startswith('<math displaystyle="true">')
    assert '<mo form="infix">&#x0002B;</mo>' in text
    assert 'form="infix"' not in mathml("-k x")
    assert "<mi>yaw</mi>" in mathml(r"\mathrm{yaw}")


def test_svg_names_are_escaped() -> None:
    assert "θ" in svg_name("theta1_dot")
    assert "<b" not in svg_name("<b>")


def test_operations_stop_at_the_limit() -> None:
    assert operations(x + L, 100) == 3
    assert operations((x + L) ** 7 * sin(x), 4) == 4


def test_names_are_set_as_the_field_sets_them() -> None:
    """A letter and what it is of, words upright; words side by side do not run together."""
    assert [latex_name(n) for n in ("mB", "IHxz", "Ixx", "EI")] == [
        "m_{B}", "I_{Hxz}", "I_{xx}", r"\mathrm{EI}",
    ]  # fmt: skip
    assert latex_name("q_left_hip") == r"q_{\mathrm{left},\mathrm{hip}}"
    kt, yaw = symbols("kt yaw")
    assert latex(kt * yaw) == r"\mathrm{kt} \, \mathrm{yaw}"
