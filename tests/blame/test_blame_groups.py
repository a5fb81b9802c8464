"""Terms belong to the group of the load whose strength stands in them."""

from dataclasses import replace

import pytest
from sympy import Expr, Symbol, sign, sympify

from mechanics.blame.groups import meanings
from mechanics.blame.terms import terms_of
from mechanics.scene import Scene, damper, force, parameters, torsion_spring
from systems import cartpole_friction, elastic_pendulum

c, kappa, drag = parameters("c kappa drag", units="N*s/m N*m N*s/m")


def scene() -> Scene:
    """The elastic pendulum with a damper, a torsion spring and a drag that is declared by hand."""
    plain = elastic_pendulum.scene()
    x, theta = plain.coordinates
    carriage = plain.bodies[0].centre
    along = plain.frame.x
    more = (
        damper("c", plain.origin, carriage, c, along=along),
        torsion_spring("kappa", theta, plain.frame.z, kappa, on="pendulum"),
        force("drag", carriage, -drag * x.diff() * along, on="carriage"),
    )
    return replace(plain, loads=(*plain.loads, *more))


def parsed(text: str, known: dict[str, Symbol]) -> Expr:
    return sympify(text, locals=known)


@pytest.mark.parametrize(
    ("group", "text"),
    [
        ("coefficient of theta_ddot", "M*L**2*theta_ddot/3"),
        ("products of speeds", "M*L*theta_dot**2*sin(theta)"),
        ("gravity", "M*g*L*sin(theta)"),
        ("stiffness", "2*k*x"),
        ("stiffness", "kappa*theta"),
        ("damping", "c*x_dot"),
        ("damping", "drag*x_dot"),
        ("reactions", "T*L"),
        ("other terms", "M*L"),
    ],
)
def test_groups(group: str, text: str) -> None:
    own = scene()
    known = {symbol.name: symbol for symbol in (*own.q, *own.u, *own.ud, *own.parameters)}
    known |= {reaction.name: reaction.symbol for reaction in own.reactions}
    (terms,) = terms_of([parsed(text, known)])
    assert list(meanings(own).grouped(terms)) == [group]


def test_friction_is_a_group_of_its_own() -> None:
    own = cartpole_friction.scene()
    x_dot, normal = own.u[0], Symbol("N_c", real=True)
    (terms,) = terms_of([cartpole_friction.mu_c * 3 * own.q[0] * sign(x_dot)])
    assert list(meanings(own).grouped(terms)) == ["friction"]
    (pressing,) = terms_of([cartpole_friction.mu_c * normal])
    assert list(meanings(own).grouped(pressing)) == ["reactions"]
