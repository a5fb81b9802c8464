"""Objects of CasADi and SymPy: names count, and so does what was put in place of their parts."""

import casadi as ca
import pytest
import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from mechanics import check
from mechanics.errors import InputError, WrongKindError
from mechanics.kernel import Verdict
from mechanics.testing import assert_equivalent
from systems import cartpole, rod_pendulum

CART, ROD = cartpole.scene(), rod_pendulum.scene()
NAMES = ["x", "x_dot", "theta", "theta_dot", "F", "mc", "mp", "l", "g"]
theta, u, w = dynamicsymbols("theta u w")
m, l, g = sp.symbols("m l g")
MOTION = theta.diff().diff() - 3 * g / (2 * l) * sp.sin(theta) - 3 * u / (m * l**2)


def function(*outputs: str) -> ca.Function:
    given = [ca.SX.sym(name) for name in NAMES]
    _, _, angle, rate, push, cart, pole, length, gravity = given
    sine, cosine, mass = ca.sin(angle), ca.cos(angle), cart + pole
    temp = (push + pole * length * rate**2 * sine) / mass
    turn = (gravity * sine - cosine * temp) / (length * (ca.SX(4) / 3 - pole * cosine**2 / mass))
    slide = temp - pole * length * turn * cosine / mass
    return ca.Function("f", given, [slide, turn], NAMES, [*outputs])


def test_outputs_of_casadi_are_what_their_names_say() -> None:
    for names in (("x_ddot", "theta_ddot"), ("o0", "o1")):
        assert check(CART, function(*names)).verdict is Verdict.PROVED
    assert check(CART, function("theta_ddot", "x_ddot"), blame=False).verdict is Verdict.REFUTED
    assert check(CART, function("theta_ddot", "o1"), blame=False).verdict is Verdict.REFUTED
    with pytest.raises(InputError, match="calls an output energy"):
        check(CART, function("o0", "energy"))


def model(kind: type = KanesMethod, mass: sp.Expr = m) -> KanesMethod:
    ground, pivot = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    centre = pivot.locatenew("C", l / 2 * rod.y)
    pivot.set_vel(ground, 0)
    rod.set_ang_vel(ground, w * ground.z)
    centre.v2pt_theory(pivot, ground, rod)
    body = RigidBody("B", centre, rod, m, (inertia(rod, 0, 0, mass * l**2 / 12), centre))
    made = kind(ground, q_ind=[theta], u_ind=[w], kd_eqs=[w - theta.diff()])
    made.kanes_equations([body], [(centre, -m * g * ground.y), (rod, u * ground.z)])
    return made


class Massive(KanesMethod):
    @property
    def mass_matrix(self) -> sp.Matrix:
        return sp.Matrix([[m * l**2 / 3]])


def test_a_model_whose_parts_are_replaced_is_refused() -> None:
    assert check(ROD, model()).verdict is Verdict.PROVED
    assert check(ROD, model(mass=2 * m), blame=False).verdict is Verdict.REFUTED
    replaced = model()
    replaced.rhs = lambda: sp.zeros(2, 1)
    for one in (model(Massive, 2 * m), replaced):
        with pytest.raises(WrongKindError, match="is not SymPy's"):
            check(ROD, one)
    turned = model()
    turned._f_k = turned._f_k + sp.Matrix([theta])
    assert check(ROD, turned, blame=False).verdict is Verdict.REFUTED


@pytest.mark.parametrize("factor", [theta, theta.diff(), u, sp.sin(theta)])
def test_an_equation_times_what_vanishes_is_not_the_motion(factor: sp.Expr) -> None:
    assert check(ROD, factor * MOTION).verdict is Verdict.PROVED
    with pytest.raises(AssertionError, match="only 0 of 1"):
        assert_equivalent(factor * MOTION, ROD)
    assert_equivalent((2 + factor**2) * MOTION, ROD)


def test_matrices_without_entries_are_named_and_columns_are_equations() -> None:
    symbol = sp.MatrixSymbol("l", 1, 1)
    for thing in (symbol, sp.Matrix([symbol[0, 0]]), symbol[0, 0] * MOTION):
        with pytest.raises(WrongKindError, match="l is a matrix without entries"):
            check(ROD, thing)
    second = theta.diff().diff()
    assert (
        check(ROD, sp.Eq(sp.Matrix([second]), sp.Matrix([second - MOTION]))).verdict.name
        == "PROVED"
    )
