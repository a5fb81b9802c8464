"""Words for typing equations as they are printed."""

from sympy import Derivative, Matrix, S, Symbol, cos
from sympy.physics.mechanics import dynamicsymbols

from mechanics.scene.typed import along_z, as_printed, cross, d_dt, plane, rounded

a, b = Symbol("a"), Symbol("b")
theta = dynamicsymbols("theta")
t = dynamicsymbols._t


def test_vectors() -> None:
    assert cross(plane(a, 0), plane(0, b)) == along_z(a * b) == Matrix([0, 0, a * b])


def test_derivatives_are_not_carried_out() -> None:
    assert d_dt(cos(theta)) == Derivative(cos(theta), t)
    assert d_dt(along_z(cos(theta))) == Matrix([0, 0, Derivative(cos(theta), t)])
    assert d_dt(S.Zero) == 0


def test_printed_terms_are_kept() -> None:
    assert len(as_printed(a, -a, b).args) == 3


def test_rounded_numbers_keep_their_digits() -> None:
    for text in ("0.88", "0.7071", "1.0000", "-0.0123", "12.50"):
        assert str(rounded(text)) == text
