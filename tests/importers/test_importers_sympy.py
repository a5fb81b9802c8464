"""Models of SymPy's come in as scenes whose equations are SymPy's own; where they are not, why."""

import pytest
import sympy.physics.mechanics as me
from sympy import cos, sin, symbols
from sympy.physics.mechanics import models

from mechanics import check, crosscheck, derive, from_sympy
from mechanics.cli.load import load
from mechanics.compiled import compile, prove_compiled
from mechanics.crosscheck.own_equations import compare_own
from mechanics.errors import SceneError
from mechanics.kernel import Verdict

g, l, m, r = symbols("g l m r")
q, u = me.dynamicsymbols("q u")
x, y = me.dynamicsymbols("x y")
t = me.dynamicsymbols._t


def verdicts(model, **given):
    return compare_own(from_sympy(model, **given), model)


def cause(model, **given) -> str:
    """The subject of what is named beside a refutation."""
    first, second = verdicts(model, **given)
    assert first.verdict is Verdict.REFUTED
    return second.subject


def pendulum() -> me.System:
    """A bob on a pin joint."""
    ground, bob = me.RigidBody("ground"), me.RigidBody("bob", mass=m)
    system = me.System.from_newtonian(ground)
    system.add_joints(me.PinJoint("pin", ground, bob, q, u, child_point=l * bob.y))
    system.apply_uniform_gravity(-g * ground.y)
    return system


def ground() -> tuple[me.ReferenceFrame, me.Point]:
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    return N, O


def slider(velocity) -> tuple[me.ReferenceFrame, me.Particle]:
    """A particle on a line, whose velocity is set."""
    N, O = ground()
    P = O.locatenew("P", q * N.x)
    P.set_vel(N, velocity * N.x)
    return N, me.Particle("mass", P, m)


def disc() -> tuple:
    """Frames, points and body of a thin disc that rolls on a plane, from its contact point up."""
    yaw, lean, spin = angles = me.dynamicsymbols("yaw lean spin")
    N, C = me.ReferenceFrame("N"), me.Point("C")
    Y = N.orientnew("Y", "Axis", [yaw, N.z])
    L = Y.orientnew("L", "Axis", [lean, Y.x])
    R = L.orientnew("R", "Axis", [spin, L.y])
    C.set_vel(N, 0)
    centre = C.locatenew("D", r * L.z)
    inertia = me.inertia(L, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4)
    return N, L, R, C, centre, me.RigidBody("disc", centre, R, m, (inertia, centre)), angles


def rolling_by_kane(**also) -> me.KanesMethod:
    N, L, R, C, centre, body, angles = disc()
    speeds = me.dynamicsymbols("u1:4")
    turned = R.ang_vel_in(N)
    R.set_ang_vel(N, speeds[0] * L.x + speeds[1] * L.y + speeds[2] * L.z)
    centre.v2pt_theory(C, N, R)
    rates = [(R.ang_vel_in(N) - turned).dot(axis) for axis in L]
    method = me.KanesMethod(N, angles, speeds, rates, **also)
    method.kanes_equations([body], [(centre, -m * g * N.z)])
    return method


def test_joints_bring_their_reactions():
    scene = from_sympy(pendulum())
    assert [one.name for one in scene.reactions] == ["pin_x", "pin_y", "pin_z", "pin_my", "pin_mz"]
    assert [load.name for load in scene.loads] == ["gravity"]
    assert scene.body("bob").mass.is_positive


def test_a_system_is_taken_wherever_a_scene_is():
    assert derive(pendulum(), "kane").scene.q[0].name == "q"
    inertia = symbols("bob_izz")
    text = f"(m*l^2 + {inertia})*u' + m*g*l*sin(q) = 0"
    model = pendulum()
    model.bodies[1].central_inertia = me.inertia(model.bodies[1].frame, inertia, inertia, inertia)
    assert [entry.finding.shown for entry in check(model, text).judged] == [True]


@pytest.mark.campaign
def test_a_cross_check_begins_with_the_equations_of_the_model():
    first = crosscheck(pendulum()).findings[0]
    assert first.subject.startswith("SymPy's System") and first.verdict is Verdict.PROVED


@pytest.mark.campaign
def test_equations_that_sympy_would_not_finish_are_not_formed():
    links = models.n_link_pendulum_on_cart(12)
    model = me.KanesMethod(links._inertial, links.q,
                           links.u, list(links.q.diff(t) - links.u), bodies=links.bodies,
                           forcelist=links.forcelist)  # fmt: skip
    found = crosscheck(model)
    assert found.remarks[0].startswith("SymPy's own equations are not compared: 13 speeds")
    assert not model._fr


@pytest.mark.parametrize(
    "model",
    [
        pytest.param(lambda: models.multi_mass_spring_damper(2, True, True), id="masses"),
        pytest.param(lambda: models.n_link_pendulum_on_cart(2, True, True), id="links"),
        pytest.param(rolling_by_kane, id="rolling disc", marks=pytest.mark.campaign),
    ],
)
def test_models_of_the_library_come_in_and_agree(model):
    (found,) = verdicts(model())
    assert found.verdict in (Verdict.PROVED, Verdict.CERTIFIED)


@pytest.mark.campaign
@pytest.mark.parametrize("links", [1, 2])
def test_a_step_of_a_library_model_is_shown(links):
    """The angles of a stage are sums whose terms multiply as they are written in base angles."""
    model = compile(derive(models.n_link_pendulum_on_cart(links), "free_body"))
    (found,) = prove_compiled(model, ["step"])
    assert found.verdict is Verdict.CERTIFIED


@pytest.mark.campaign
def test_a_contact_point_at_rest_moves_on():
    scene = from_sympy(rolling_by_kane())
    assert [s.name for s in scene.q] == ["yaw", "lean", "spin", "C_x", "C_y"]
    assert [c.holonomic for c in scene.constraints] == [False, False]
    assert {one.at.name for one in scene.reactions} == {"C"}


def test_a_point_of_which_only_the_velocity_is_said_has_its_integral():
    N = me.ReferenceFrame("N")
    P = me.Point("P")
    P.set_vel(N, l * u * (cos(q) * N.x + sin(q) * N.y))
    method = me.KanesMethod(N, [q], [u], [q.diff() - u])
    method.kanes_equations([me.Particle("bob", P, m)], [(P, -m * g * N.y)])
    scene = from_sympy(method)
    assert len(scene.coordinates) == 1
    assert scene.position(scene.body("bob").centre)[0] == scene.parameters[1] * sin(scene.q[0])
    assert verdicts(method)[0].verdict is Verdict.PROVED


@pytest.mark.campaign
def test_reactions_are_found_that_no_axis_has():
    """A bead on a parabola, and two masses on a rope."""
    N, O = ground()
    P, A, B = (O.locatenew("P", q * N.x + q**2 * N.y), O.locatenew("A", q * N.y),
               O.locatenew("B", -2 * q * N.y))  # fmt: skip
    for points in ((P,), (A, B)):
        bodies = [me.Particle(point.name, point, m) for point in points]
        for point in points:
            point.set_vel(N, point.pos_from(O).dt(N))
        energy = me.Lagrangian(N, *bodies)
        method = me.LagrangesMethod(energy, [q], bodies=bodies, frame=N,
                                    forcelist=[(points[0], -m * g * N.y)])  # fmt: skip
        assert verdicts(method)[0].verdict is Verdict.PROVED


@pytest.mark.campaign
def test_unknown_forces_of_auxiliary_speeds_are_reactions():
    N, L, R, C, centre, body, angles = disc()
    speeds, auxiliary = me.dynamicsymbols("u1:4"), me.dynamicsymbols("a1:3")
    f1, f2 = me.dynamicsymbols("f1 f2")
    turned = R.ang_vel_in(N)
    R.set_ang_vel(N, speeds[0] * L.x + speeds[1] * L.y + speeds[2] * L.z)
    C.set_vel(N, auxiliary[0] * N.x + auxiliary[1] * N.y)
    centre.v2pt_theory(C, N, R)
    rates = [(R.ang_vel_in(N) - turned).dot(axis) for axis in L]
    method = me.KanesMethod(N, angles, speeds, rates, u_auxiliary=auxiliary)
    method.kanes_equations([body], [(centre, -m * g * N.z), (C, f1 * N.x + f2 * N.y)])
    scene = from_sympy(method)
    assert {"f1", "f2"} <= {one.name for one in scene.reactions} and not scene.inputs
    assert verdicts(method)[0].verdict is Verdict.CERTIFIED


# --------------------------------------------------------------- what SymPy does with them


def test_a_load_that_lagrange_drops_is_named():
    """Its point has a velocity in u, of which LagrangesMethod knows nothing."""
    N, mass = slider(u)
    at = mass.point.locatenew("H", 0)
    at.set_vel(N, u * N.x)
    mass.point.set_vel(N, q.diff() * N.x)
    loads = [(mass.point, -g * q * N.x), (at, m * g * N.x)]
    method = me.LagrangesMethod(me.Lagrangian(N, mass), [q], loads, [mass], N)
    assert "drops the load load2_mass" in cause(method)


def test_a_constraint_that_kane_ignores_is_named():
    N, O = ground()
    P = O.locatenew("P", x * N.x + y * N.y)
    v, w = me.dynamicsymbols("v w")
    P.set_vel(N, v * N.x + w * N.y)
    method = me.KanesMethod(N, [x], [v, w], [x.diff() - v, y.diff() - w], q_dependent=[y],
                            configuration_constraints=[x**2 + y**2 - l**2])  # fmt: skip
    method.kanes_equations([me.Particle("bob", P, m)], [(P, -m * g * N.y)])
    assert "does not keep constraint1" in cause(method)


def test_a_potential_that_kane_ignores_is_named():
    N, mass = slider(u)
    mass.potential_energy = m * g * q
    method = me.KanesMethod(N, [q], [u], [q.diff() - u])
    method.kanes_equations([mass], [])
    assert "does not count the potential energy" in cause(method)


def test_a_load_that_lagrange_counts_twice_is_named():
    N, mass = slider(q.diff())
    mass.potential_energy = m * g * q
    method = me.LagrangesMethod(me.Lagrangian(N, mass), [q], bodies=[mass], frame=N,
                                forcelist=[(mass.point, -m * g * N.x)])  # fmt: skip
    assert "counts gravity twice" in cause(method)


@pytest.mark.campaign
def test_a_constraint_that_is_put_into_a_lagrangian_is_named():
    N, _, R, C, centre, body, angles = disc()
    centre.v2pt_theory(C, N, R)
    body.potential_energy = m * g * r * cos(angles[1])
    method = me.LagrangesMethod(me.Lagrangian(N, body), angles, bodies=[body], frame=N)
    assert "where the motion constraints hold" in cause(method)


def test_an_acceleration_that_contradicts_its_velocity_is_named():
    N, mass = slider(u)
    mass.point.set_acc(N, (u.diff() + u**2) * N.x)
    method = me.KanesMethod(N, [q], [u], [q.diff() - u])
    method.kanes_equations([mass], [(mass.point, -g * q * N.x)])
    assert "the acceleration of P that is set" in cause(method)


# --------------------------------------------------------------- what a model does not say


def test_velocities_that_contradict_positions_are_named():
    N, O = ground()
    A, B = O.locatenew("A", q * N.x), O.locatenew("B", q * N.y)
    A.set_vel(N, u * N.x)
    B.set_vel(N, 2 * u * N.y)
    method = me.KanesMethod(N, [q], [u], [q.diff() - u])
    method.kanes_equations([me.Particle(p.name, p, m) for p in (A, B)], [(A, m * g * N.x)])
    with pytest.raises(SceneError, match=r"^body B: the velocity of B that is set contradicts"):
        from_sympy(method)


def test_turns_that_contradict_orientations_are_named():
    N, O = ground()
    A = N.orientnew("A", "Axis", [q, N.z])
    A.set_ang_vel(N, 2 * u * N.z)
    body = me.RigidBody("rod", O, A, m, (me.inertia(A, 0, 0, m), O))
    method = me.KanesMethod(N, [q], [u], [q.diff() - u])
    method.kanes_equations([body], [(A, g * N.z)])
    with pytest.raises(SceneError, match=r"^body rod: the angular velocity of frame A"):
        from_sympy(method)


def test_loads_that_no_body_carries_are_named():
    N, mass = slider(u)
    P = mass.point.locatenew("H", q**2 * N.y)
    method = me.KanesMethod(N, [q], [u], [q.diff() - u])
    P.set_vel(N, u * N.x + 2 * q * u * N.y)
    method.kanes_equations([mass], [(P, m * g * N.x)])
    with pytest.raises(SceneError, match=r"^load1 on point H: no body carries that point"):
        from_sympy(method)


def test_a_lagrangian_alone_asks_for_its_bodies():
    N, mass = slider(q.diff())
    method = me.LagrangesMethod(me.Lagrangian(N, mass), [q])
    with pytest.raises(SceneError, match="it names no bodies: pass from_sympy"):
        from_sympy(method)
    assert verdicts(method, bodies=[mass])[0].verdict is Verdict.PROVED


@pytest.mark.campaign
def test_a_file_of_a_model_is_loaded(tmp_path):
    path = tmp_path / "bob.py"
    path.write_text(
        "import sympy.physics.mechanics as me\n"
        "def make_model():\n"
        "    ground, bob = me.RigidBody('ground'), me.RigidBody('bob')\n"
        "    system = me.System.from_newtonian(ground)\n"
        "    system.add_joints(me.PinJoint('pin', ground, bob, child_point=bob.y))\n"
        "    return system\n"
    )
    system = load(f"{path}:make_model")
    assert system.scene().name == "bob"
    assert crosscheck(system).findings[0].subject.startswith("SymPy's System")
