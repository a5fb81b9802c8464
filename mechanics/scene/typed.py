"""Words for typing a source's equations as it prints them."""

from sympy import Add, Derivative, Expr, Float, ImmutableMatrix, S, sympify
from sympy.matrices import MatrixBase
from sympy.physics.vector import dynamicsymbols


def plane(x: Expr, y: Expr) -> ImmutableMatrix:
    """The vector x u_x + y u_y."""
    return ImmutableMatrix([x, y, 0])


def along_z(value: Expr) -> ImmutableMatrix:
    """The vector `value` u_z."""
    return ImmutableMatrix([0, 0, value])


def cross(a: ImmutableMatrix, b: ImmutableMatrix) -> ImmutableMatrix:
    """The vector product a x b, not multiplied out."""
    return ImmutableMatrix(a.cross(b))


def d_dt(value: Expr | MatrixBase) -> Expr | ImmutableMatrix:
    """The time derivative of an expression or a vector, not carried out."""
    if isinstance(value, MatrixBase):
        return ImmutableMatrix(value.applyfunc(d_dt))
    return Derivative(value, dynamicsymbols._t) if value != 0 else S.Zero


def as_printed(*terms: Expr) -> Expr:
    """A sum that SymPy leaves as it is typed: like terms are not put together."""
    return Add(*(sympify(term) for term in terms), evaluate=False)


def rounded(text: str) -> Float:
    """A decimal number with the digits that the source prints, ``"0.88"``: it stands for all
    numbers that round to it.
    """
    return Float(text, max(1, sum(c.isdigit() for c in text.lstrip("-0.") if c != ".")))
