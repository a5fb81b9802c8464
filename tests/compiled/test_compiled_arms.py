"""Arms in space: what is compiled is what recursive Newton-Euler computes, whoever read what."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from serial_arms import Arm, serial_arm
from sympy import Rational

from benchmarks.space.textbook import inverse_dynamics
from mechanics.compiled import Model, compile, outputs, prove_graph
from mechanics.compiled.sampling import ordinary
from mechanics.crosscheck import derive
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, SingularError
from mechanics.program import Builder
from mechanics.recursions import least_constraint
from mechanics.recursions.least_constraint.affine import Affine
from mechanics.recursions.least_constraint.elimination import Solved, values
from mechanics.recursions.least_constraint.gauss import Gauss
from mechanics.routes.derivation import by_route, steps_of
from mechanics.scene import Scene
from systems import double_pendulum, pendulum_chain

pytestmark = pytest.mark.campaign

EPS = np.finfo(float).eps
ROUNDINGS = 256
"""Of the residual of each row, against the sum of the magnitudes of what is added up in it."""

OFF_AXIS: dict[str, Any] = {"axes": "zyy", "fixed": "x", "zero": "yzDEF"}
"""With three joints, a way that passes accelerations on in inertial components goes in a circle."""


def modelled(equations: Equations, form: str = "auto") -> Model:
    return compile(equations, form=form, compiler=None, outputs=("forward_dynamics",))


def assert_follows(arm: Arm, model: Model) -> None:
    """The compiled accelerations solve M a = f with M and f by recursive Newton-Euler."""
    names, n = [entry.name for entry in model.quantities.p], len(arm.axes)
    for q, u, p, torques in _states(model):
        numbers = dict(zip(names, p, strict=True))
        joints, field = arm.joints(numbers), numbers["g"]
        rest = inverse_dynamics(joints, q, u, np.zeros(n), field)
        columns = [inverse_dynamics(joints, q, u, unit, field) - rest for unit in np.eye(n)]
        M, a = np.array(columns).T, model.forward_dynamics(q, u, p, inputs=torques)
        size = np.abs(M) @ np.abs(a) + np.abs(rest) + np.abs(torques)
        assert np.all(np.abs(M @ a + rest - torques) <= ROUNDINGS * EPS * size)


def _states(model: Model) -> Any:
    drawn = ordinary(model.quantities, 5, 3)
    return zip(drawn.q, drawn.u, drawn.p, drawn.inputs, strict=True)


def test_the_referee_swings_as_a_pendulum() -> None:
    """(I + m c^2) theta'' = -m g c sin(theta) about a horizontal axis."""
    numbers = {"g": 9.81, "m1": 2.0, "c1": -0.5, "B1": 0.3}
    joints = serial_arm(1, axes="y").joints(numbers)
    for theta in (0.3, -1.2):
        want = -2.0 * 9.81 * 0.5 * np.sin(theta) / (0.3 + 2.0 * 0.25)
        torque = inverse_dynamics(
            joints, np.array([theta]), np.array([0.7]), np.array([want]), 9.81
        )
        assert torque == pytest.approx([0], abs=1e-14)


@pytest.mark.parametrize("route", ["free_body", "moving_point", "kane", "lagrange"])
def test_two_joints_follow_by_every_route(route: str) -> None:
    arm = serial_arm(2)
    assert_follows(arm, modelled(derive(arm.scene, route)))


def test_four_joints_with_fixed_quarter_turns() -> None:
    arm = serial_arm(4, axes="zyx", fixed="zxy")
    model = modelled(by_route("kane", arm.scene))
    assert_follows(arm, model)
    finding = prove_graph("forward_dynamics", model.casadi, try_normal=False)
    assert finding.shown, finding


@pytest.mark.parametrize(
    "scene", [serial_arm(2).scene, double_pendulum.scene(), pendulum_chain.scene(7)]
)
def test_the_graph_does_not_depend_on_what_was_read(scene: Scene) -> None:
    first, second = by_route("free_body", scene), by_route("free_body", scene)
    _ = second.system, second.reactions, steps_of(second)
    codes = [modelled(equations).program("forward_dynamics") for equations in (first, second)]
    _ = first.system
    codes.append(modelled(first).program("forward_dynamics"))
    assert codes[0] == codes[1] == codes[2]


def test_a_value_that_is_found_from_itself_is_refused() -> None:
    builder = Builder()
    one, two = (Affine({name: builder.one}, builder.zero) for name in ("one", "two"))
    value = values(Gauss(builder), [Solved("one", two), Solved("two", one)])
    with pytest.raises(ExpressionError, match="acceleration one is found from itself"):
        value("one")


def test_three_joints_with_mass_centres_off_their_axes() -> None:
    """The way that goes in a circle is not offered; the others are."""
    arm = serial_arm(3, **OFF_AXIS)
    model = modelled(by_route("kane", arm.scene), "recursive")
    assert len(model.casadi.source.programs.ways("recursive")) == len(least_constraint.WAYS) - 1
    assert_follows(arm, model)
    assert_follows(arm, modelled(by_route("free_body", arm.scene)))


def test_a_form_that_is_no_solution_is_not_chosen(monkeypatch: pytest.MonkeyPatch) -> None:
    arm, solved = serial_arm(2), least_constraint.forward_dynamics
    monkeypatch.setattr(
        outputs.least_constraint,
        "forward_dynamics",
        lambda *given: tuple(entry * Fraction(1000001, 1000000) for entry in solved(*given)),
    )
    model = modelled(by_route("kane", arm.scene))
    assert model.form != "recursive"
    assert_follows(arm, model)
    with pytest.raises(SingularError, match="form 'recursive' gives no accelerations"):
        _ = modelled(by_route("kane", arm.scene), "recursive").form


def test_rows_serve_where_the_normal_form_of_f_is_too_large() -> None:
    """Turns of 1/3 rad between the joints keep their sines and cosines in every product."""
    arm = serial_arm(4, axes="z", fixed="x", turn=Rational(1, 3))
    equations = by_route("free_body", arm.scene)
    assert equations.textbook is None
    model = modelled(equations)
    assert_follows(arm, model)
    finding = prove_graph("forward_dynamics", model.casadi, try_normal=False)
    assert finding.shown, finding


def test_six_joints() -> None:
    arm = serial_arm(6)
    assert_follows(arm, modelled(by_route("kane", arm.scene)))
