"""SymPy's rolling disc: right by Kane; by Lagrange its constraint stands in the Lagrangian.

The tutorial "A rolling disc using Lagrange's Method" (SymPy, issue 27631) gives the contact point
no velocity, and counts the potential energy of gravity with the wrong sign.
"""

import pytest
from sympy import cos, linsolve, sin, symbols
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Point,
    ReferenceFrame,
    RigidBody,
    dot,
    dynamicsymbols,
    inertia,
)

import mechanics
from mechanics.judge.check import Check

q1, q2, q3, u1, u2, u3 = dynamicsymbols("q1 q2 q3 u1 u2 u3")
r, m, g = symbols("r m g")
NAMES = {"q1": "yaw", "q2": "lean", "q3": "spin", "r": "R"}
RIGHT = ("0.6280509609228515", "4.243586837784844", "-0.02637900157817294")
PRINTED = ("2.0078873826124033", "-2.382820539009993", "-0.49783764534975306")
Q, RATES = (0.4, 0.3, 1.1), (0.5, -0.2, 1.5)


def frames() -> tuple[ReferenceFrame, ReferenceFrame, ReferenceFrame, ReferenceFrame]:
    ground = ReferenceFrame("N")
    heading = ground.orientnew("Y", "Axis", [q1, ground.z])
    leaning = heading.orientnew("L", "Axis", [q2, heading.x])
    return ground, heading, leaning, leaning.orientnew("R", "Axis", [q3, leaning.y])


def disc(ground: ReferenceFrame, leaning: ReferenceFrame, turning: ReferenceFrame) -> RigidBody:
    contact = Point("C")
    contact.set_vel(ground, 0)
    centre = contact.locatenew("Dmc", r * leaning.z)
    centre.v2pt_theory(contact, ground, turning)
    about = inertia(leaning, m / 4 * r**2, m / 2 * r**2, m / 4 * r**2)
    return RigidBody("BodyD", centre, turning, m, (about, centre))


def by_kane() -> KanesMethod:
    ground, heading, leaning, turning = frames()
    omega = turning.ang_vel_in(ground)
    turning.set_ang_vel(ground, u1 * leaning.x + u2 * leaning.y + u3 * leaning.z)
    rows = [dot(omega - turning.ang_vel_in(ground), axis) for axis in leaning]
    body = disc(ground, leaning, turning)
    method = KanesMethod(ground, q_ind=[q1, q2, q3], u_ind=[u1, u2, u3], kd_eqs=rows)
    method.kanes_equations([body], [(body.masscenter, -m * g * heading.z)])
    return method


def by_lagrange(up: int) -> LagrangesMethod:
    ground, _, leaning, turning = frames()
    body = disc(ground, leaning, turning)
    body.potential_energy = up * m * g * r * cos(q2)
    method = LagrangesMethod(Lagrangian(ground, body), [q1, q2, q3])
    method.form_lagranges_equations()
    return method


def solved(method: KanesMethod | LagrangesMethod) -> list[float]:
    """q'' at the published state."""
    values = {m: 1.3, r: 0.7, g: 9.81}
    q, rates = (q1, q2, q3), [c.diff() for c in (q1, q2, q3)]
    motion = dict(zip(rates, RATES, strict=True))
    place = dict(zip(q, Q, strict=True))
    accelerations = [c.diff().diff() for c in q]
    if isinstance(method, KanesMethod):
        known = method.kindiffdict()
        rows = [rate - known[rate] for rate in rates]
        ((*speeds,),) = linsolve(rows, u1, u2, u3)
        table = dict(zip((u1, u2, u3), speeds, strict=True))
        slow = {u.diff(): value.diff() for u, value in table.items()}
        left = method.mass_matrix * method.u.diff() - method.forcing
        left = left.xreplace(slow).xreplace(table)
    else:
        left = method.eom
    residual = left.subs(values).doit()
    matrix = residual.jacobian(accelerations)
    rest = residual.subs(dict.fromkeys(accelerations, 0))
    matrix, rest = (part.subs(motion).subs(place).evalf() for part in (matrix, rest))
    return [float(entry) for entry in matrix.LUsolve(-rest)]


def judged(truth, method) -> Check:
    return mechanics.check(truth("rolling_disc"), method, names=NAMES)


def test_kane_is_right(truth, assert_agree) -> None:
    method = by_kane()
    assert_agree(solved(method), RIGHT)
    found = judged(truth, method)
    assert {entry.finding.verdict.name for entry in found.judged} <= {"PROVED", "CERTIFIED"}
    assert len(found.judged) == 3


def test_the_engine_gives_the_right_values(truth, assert_agree) -> None:
    equations = truth("rolling_disc")
    scene = equations.scene
    (yaw, lean, _), (yaw_rate, lean_rate, spin_rate) = Q, RATES
    q = [0, 0, *Q]
    u = [lean_rate, spin_rate + yaw_rate * sin(lean), yaw_rate * cos(lean),
         0.7 * spin_rate * cos(yaw), 0.7 * spin_rate * sin(yaw)]  # fmt: skip
    u = [float(speed) for speed in u]
    given = {"m": 1.3, "R": 0.7, "g": 9.81}
    ud = mechanics.compile(equations, compiler=None).forward_dynamics(q, u, given)
    values = dict(zip((*scene.q, *scene.u, *scene.ud), (*q, *u, *ud), strict=True))
    second = [scene.plain(c.diff().diff()) for c in scene.coordinates[2:]]
    assert_agree([value.subs(values).evalf() for value in second], RIGHT)


@pytest.mark.campaign
@pytest.mark.parametrize("up", [1, -1])
def test_lagrange_with_the_constraint_substituted_is_refuted(truth, assert_agree, up: int) -> None:
    method = by_lagrange(up)
    # As printed, gravity is reversed too, which moves only the lean.
    wanted = PRINTED if up < 0 else (PRINTED[0], RIGHT[1], PRINTED[2])
    assert_agree(solved(method), wanted)
    yaw, lean, spin = judged(truth, method).judged
    assert [yaw.finding.verdict.name, spin.finding.verdict.name] == ["REFUTED", "REFUTED"]
    assert lean.finding.shown is (up > 0)
    for entry in (yaw, spin):
        (words,) = entry.blame.explanations
        assert "substituted into the Lagrangian" in words
        assert ("gravity reversed" in words) is (up < 0)
