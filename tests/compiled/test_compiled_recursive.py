"""Forward dynamics from the bodies: proved, linear in their number, refused where it cannot be."""

from typing import Any

import casadi as ca
import pytest
from shared_scenes import WITH_FRICTION
from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.compiled import compile, prove_graph
from mechanics.compiled.forms.members import RECURSIVE, SPARSE
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.kinematics.printer import Printer
from mechanics.program.operations import COS, SIN, TAN
from mechanics.routes.derivation import by_route
from mechanics.scene import (
    RigidBody,
    Scene,
    damper,
    force,
    gravity,
    parameters,
    reaction,
    reaction_couple,
    spring,
    torque,
    torsion_spring,
)
from systems import ALL, VARIANTS, pendulum_chain

pytestmark = pytest.mark.campaign

ROUTES = ("free_body", "moving_point", "kane", "lagrange")


def arm(joints: str, loads: bool = False) -> Scene:
    """Bodies in space, one on the other: joints turn about x, y, z or slide along X, Y, Z."""
    g, k, c, w = parameters("g k c w")
    N, O = ReferenceFrame("N"), Point("O")
    q = dynamicsymbols(f"q1:{len(joints) + 1}")
    frame, end, inner = N, O, None
    bodies, reactions, applied = [], [], [gravity(-g * N.z)]
    for i, (joint, angle) in enumerate(zip(joints, q, strict=True)):
        m, l, A, B, C = parameters(f"m{i} l{i} A{i} B{i} C{i}")
        axis, slides = joint.lower(), joint.isupper()
        along, name = getattr(frame, axis), f"b{i}"
        own = frame if slides else frame.orientnew(f"F{i}", "Axis", (angle, along))
        at = end.locatenew(f"J{i}", angle * along) if slides else end
        centre = at.locatenew(f"C{i}", l / 2 * own.x + l / 3 * own.y)
        bodies.append(RigidBody(name, centre, own, m, inertia(own, A, B, C)))
        for way in "xyz":
            direction = getattr(frame, way)
            if not (slides and way == axis):
                reactions.append(reaction(f"R{i}{way}", at=at, on=name, by=inner, along=direction))
            if slides or way != axis:
                reactions.append(reaction_couple(f"M{i}{way}", name, inner, direction))
        if loads:
            applied.append(torque(f"T{i}", w * along, on=name, by=inner))
            applied.append(force(f"F{i}", centre, k * own.y, on=name))
        end, frame, inner = at.locatenew(f"P{i}", l * own.x), own, name
    if loads:
        applied += [
            spring("s", O, end, k, length=c, second_on=inner),
            damper("d", bodies[0].centre, bodies[-1].centre, c),
            torsion_spring("t", q[0], getattr(N, joints[0].lower()), k, on="b0"),
        ]
    return Scene(
        f"arm {joints}", N, O, coordinates=q, bodies=tuple(bodies),
        reactions=tuple(reactions), loads=tuple(applied),
    )  # fmt: skip


def forced(equations: Any, form: str = "recursive") -> Any:
    return compile(equations, form=form, compiler=None, outputs=("forward_dynamics",))


def certified(model: Any, graph: ca.Function | None = None) -> Verdict:
    """A certificate is enough here; small systems are proved by the laws over all of them."""
    return prove_graph("forward_dynamics", model.casadi, graph, try_normal=False).verdict


SMOOTH = [system for system in (*ALL, *VARIANTS) if system.name not in WITH_FRICTION]


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", ROUTES)
@pytest.mark.parametrize("system", SMOOTH, ids=lambda system: system.name)
def test_from_the_bodies_it_is_what_every_route_derived(system: Any, route: str) -> None:
    scene = system.scene()
    equations = by_route(route, scene)
    form, other = (SPARSE, RECURSIVE) if scene.constraints else (RECURSIVE, SPARSE)
    if scene.constraints and not equations.multipliers:
        assert "hold no multipliers" in form.unsuited(equations)
        return
    assert form.unsuited(equations) == ""
    model = forced(equations, form.name)
    assert model.form == form.name
    assert certified(model) is Verdict.CERTIFIED
    with pytest.raises(InputError, match=f"form '{other.name}': .*, or 'auto'$") as refused:
        compile(equations, form=other.name)
    among = str(refused.value).rpartition("choose among ")[2]
    assert form.name in among and other.name not in among


@pytest.mark.parametrize("system", [s for s in ALL if s not in SMOOTH], ids=lambda s: s.name)
def test_friction_depends_on_reactions_that_gauss_s_function_does_not_hold(system: Any) -> None:
    equations = by_route("kane", system.scene())
    assert RECURSIVE.unsuited(equations) == (
        "track depends on a reaction, which this form does not hold"
    )
    with pytest.raises(InputError, match="form 'recursive': track depends on a reaction"):
        compile(equations, form="recursive")
    assert certified(compile(equations)) is Verdict.CERTIFIED


@pytest.mark.sample(2)
@pytest.mark.parametrize("joints", ["z", "xy", "xYz", "Xyz"])
def test_arms_in_space(joints: str) -> None:
    assert certified(forced(by_route("kane", arm(joints)))) is Verdict.CERTIFIED


@pytest.mark.parametrize("joints", ["xy", "zX"])
def test_loads_on_arms_in_space(joints: str) -> None:
    assert certified(forced(by_route("kane", arm(joints, loads=True)))) is Verdict.CERTIFIED


def spinning() -> Scene:
    """A free rigid body; speeds are the components of its angular velocity."""
    phi, theta, psi, w1, w2, w3 = dynamicsymbols("phi theta psi w1 w2 w3")
    m, A, B, C = parameters("m A B C")
    N, O = ReferenceFrame("N"), Point("O")
    precessing = N.orientnew("P", "Axis", (phi, N.z))
    nodding = precessing.orientnew("Q", "Axis", (theta, precessing.x))
    body = nodding.orientnew("S", "Axis", (psi, nodding.z))
    return Scene(
        "free body", N, O, coordinates=(phi, theta, psi),
        speeds=(
            (w1, phi.diff() * sin(theta) * sin(psi) + theta.diff() * cos(psi)),
            (w2, phi.diff() * sin(theta) * cos(psi) - theta.diff() * sin(psi)),
            (w3, phi.diff() * cos(theta) + psi.diff()),
        ),
        bodies=(RigidBody("body", O, body, m, inertia(body, A, B, C)),),
    )  # fmt: skip


def test_declared_speeds_are_regular_where_rates_of_angles_are_not() -> None:
    """A w1' = (B - C) w2 w3 is computed: no angle is left, and no sine to divide by."""
    model = forced(by_route("kane", spinning()))
    assert certified(model) is Verdict.CERTIFIED
    q, u = [0.3, 0.0, 0.2], [1.0, 2.0, 3.0]
    found = model.forward_dynamics(q, u, p={"m": 1.0, "A": 1.0, "B": 2.0, "C": 4.0})
    assert found.tolist() == [-12.0, 4.5, -0.5]
    operations = {node.operation for node in model.program("forward_dynamics").nodes}
    assert not operations & {SIN, COS, TAN}


def test_a_changed_graph_is_refuted_by_the_rows() -> None:
    """One wrong sign is found."""
    equations = by_route("free_body", pendulum_chain.scene(8))
    model = forced(equations)
    assert certified(model) is Verdict.CERTIFIED
    own, _ = model.casadi.exact("forward_dynamics")
    inputs = [ca.SX.sym(own.name_in(i), own.size_in(i)) for i in range(own.n_in())]
    ud, multipliers = own(*inputs)
    ud[3] = -ud[3]
    names = own.name_in(), own.name_out()
    changed = ca.Function("changed", inputs, [ud, multipliers], *names)
    assert certified(model, changed) is Verdict.REFUTED


def test_rows_are_what_is_split_into_the_matrix() -> None:
    equations = by_route("free_body", pendulum_chain.scene(2))
    mechanism, rows = equations.program
    printed = Printer(equations.scene, mechanism)(rows.values)
    for row, value in zip(printed, equations.residual, strict=True):
        assert (row - value).expand().rewrite("exp").expand() == 0
