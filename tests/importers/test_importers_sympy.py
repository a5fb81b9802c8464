"""Models of SymPy's come in as scenes whose equations are SymPy's own."""

import sympy.physics.mechanics as me
from sympy import symbols

from mechanics import from_sympy
from mechanics.crosscheck.own_equations import compare_own
from mechanics.kernel import Verdict

t = me.dynamicsymbols._t
g, l, m, r = symbols("g l m r")


def verdicts(model, **given):
    return compare_own(from_sympy(model, **given), model)


def pendulum() -> me.System:
    """A bob on a pin joint."""
    ground, bob = me.RigidBody("ground"), me.RigidBody("bob", mass=m)
    system = me.System.from_newtonian(ground)
    system.add_joints(me.PinJoint("pin", ground, bob, child_point=l * bob.y))
    system.apply_uniform_gravity(-g * ground.y)
    return system


def test_joints_bring_their_reactions():
    scene = from_sympy(pendulum())
    assert [one.name for one in scene.reactions] == ["pin_x", "pin_y", "pin_z", "pin_my", "pin_mz"]
    assert [load.name for load in scene.loads] == ["gravity"]
    assert scene.body("bob").mass.is_positive


def test_equations_of_a_system_are_its_own():
    (found,) = verdicts(pendulum())
    assert found.verdict is Verdict.PROVED
