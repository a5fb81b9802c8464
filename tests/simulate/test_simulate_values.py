"""What people set: names, numbers, inputs; every mistake is named."""

import re
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from particles import on_line
from sympy import Expr, Symbol, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.compiled.model import Model, compile
from mechanics.errors import InputError, SingularError, ValueMissingError
from mechanics.routes.derivation import by_route
from mechanics.scene import (
    Particle,
    Scene,
    damper,
    force,
    gravity,
    holonomic,
    parameters,
    reaction,
    spring,
)
from mechanics.simulate import Ending, march, simulate

ModelOf = Callable[[str], Model]


@pytest.fixture(scope="module")
def pendulum(model_of: ModelOf) -> Model:
    return model_of("elastic_pendulum")


def test_initial_values_come_from_the_person_the_example_or_are_zero(pendulum: Model) -> None:
    motion = simulate(pendulum, 0.1, initial={"theta": 1.0})
    assert motion.coordinates["theta"][0] == 1.0
    assert motion.coordinates["x"][0] == 0.1  # the scene's example
    assert motion.speeds["x_dot"][0] == 0.0
    assert motion.times[0] == 0.0
    assert motion.times[-1] == 0.1
    assert len(motion.times) == 501


def test_parameters_are_typical_unless_given(pendulum: Model) -> None:
    motion = simulate(pendulum, 0.1, parameters={"k": 20, "M": Fraction(1, 3)}, samples=3)
    assert motion.parameters == {"L": 1.0, "M": 1 / 3, "g": 9.81, "k": 20.0, "m": 1.0}


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"initial": {"phi": 1}}, "'phi'.* coordinates and speeds are x, theta, x_dot, theta_dot"),
        ({"initial": {"x": "far"}}, "initial value x: 'far' is no number"),
        ({"initial": {"x": float("inf")}}, "initial value x: inf is not finite"),
        ({"parameters": {"K": 1}}, "parameter 'K'.*parameters are I_C, L, M, g, k, m"),
        ({"parameters": {"M": -1}}, "parameter M: -1 is negative"),
        ({"parameters": {"M": None}}, "parameter M: None is no number"),
        ({"inputs": {"F": 1}}, "input 'F'.*there are no inputs"),
        ({"samples": 1}, "samples: 1 found"),
        ({"method": "Euler"}, "methods are DOP853, RK45, Radau, BDF, LSODA"),
        ({"rtol": 1e-18}, "rtol: 1e-18 found"),
        ({"atol": 0.0}, "atol: 0.0 found"),
    ],
)
def test_mistakes_are_named(pendulum: Model, settings: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        simulate(pendulum, 1.0, **settings)


@pytest.mark.parametrize("duration", [0, -1.0, float("nan"), float("inf"), "long"])
def test_duration_is_a_positive_number(pendulum: Model, duration: Any) -> None:
    with pytest.raises(InputError, match="positive number of seconds"):
        simulate(pendulum, duration)


def oscillator(typical: str, damping: Any = None) -> Model:
    """A mass on a spring whose stiffness is defined by a frequency: k = m w^2."""
    x, (m, w), k = (
        dynamicsymbols("x"),
        parameters("m w", typical=typical),
        Symbol("k", positive=True),
    )

    def loads(N: ReferenceFrame, O: Point, P: Point) -> list[Any]:
        held = [spring("k", O, P, k, along=N.x)]
        return held if damping is None else [*held, damper("c", O, P, damping, along=N.x)]

    scene = on_line("oscillator", x, m, loads, definitions={k: m * w**2})
    return compile(by_route("lagrange", scene), compiler=None)


def test_definitions_follow_what_they_are_defined_by() -> None:
    motion = simulate(oscillator("2 -"), 1.0, initial={"x": 1}, parameters={"w": 3})
    assert motion.parameters["k"] == 18.0
    assert np.allclose(motion.coordinates["x"], np.cos(3 * motion.times), atol=1e-8)


def test_a_definition_can_be_overruled() -> None:
    motion = simulate(oscillator("2 -"), 1.0, initial={"x": 1}, parameters={"k": 8})
    assert np.allclose(motion.coordinates["x"], np.cos(2 * motion.times), atol=1e-8)


def test_parameter_without_a_value_is_named() -> None:
    with pytest.raises(ValueMissingError, match="parameter w: a number is needed"):
        simulate(oscillator("2 -"), 1.0)


def test_damping_is_seen_as_loss() -> None:
    motion = simulate(oscillator("1 1", damping=0.5), 5.0, initial={"x": 1})
    assert not motion.conservative
    assert motion.total[-1] < 0.2 * motion.total[0]
    assert "loads or inputs do work" in motion.note


def prescribed() -> Model:
    """A bead whose height is prescribed: x free on a rail at y = f(t), by a constraint."""
    x, y, f = dynamicsymbols("x y f")
    (m,) = parameters("m", typical="1")
    ground, origin = ReferenceFrame("N"), Point("O")
    bead = origin.locatenew("P", x * ground.x + y * ground.y)
    scene = Scene(
        "bead on a lift",
        ground,
        origin,
        coordinates=(x, y),
        bodies=(Particle("bead", bead, m),),
        loads=(gravity(-ground.y),),
        reactions=(reaction("N", at=bead, on="bead", by=None, along=ground.y),),
        constraints=(holonomic("lift", y - f, "N"),),
        inputs=(f,),
    )
    return compile(by_route("lagrange", scene), compiler=None)


def test_prescribed_motion_is_followed() -> None:
    given = {"f": np.sin, "f_dot": np.cos, "f_ddot": lambda t: -np.sin(t)}
    motion = simulate(prescribed(), 2.0, initial={"x_dot": 1.0}, inputs=given)
    assert motion.ending is Ending.COMPLETE
    assert not motion.conservative
    assert np.allclose(motion.coordinates["y"], np.sin(motion.times), rtol=0, atol=1e-13)
    assert np.allclose(motion.speeds["y_dot"], np.cos(motion.times), rtol=0, atol=1e-13)


def test_rate_of_a_prescribed_motion_is_asked_for() -> None:
    with pytest.raises(InputError, match=r"its rate f_d?dot is needed: give that function too"):
        simulate(prescribed(), 2.0, inputs={"f": np.sin})


def pushed(by: Callable[[Expr], Expr]) -> Model:
    """A point mass on a line, pushed with by(x)."""
    x, (m,) = dynamicsymbols("x"), parameters("m", typical="1")
    scene = on_line("pushed mass", x, m, lambda N, O, P: [force("F", P, by(x) * N.x)])
    return compile(by_route("lagrange", scene), compiler=None)


def test_force_that_ends_ends_the_motion() -> None:
    motion = simulate(pushed(lambda x: sqrt(1 - x)), 5.0, initial={"x_dot": 1.0}, samples=5001)
    assert motion.ending is Ending.NOT_FINITE
    assert motion.coordinates["x"][-1] == pytest.approx(1.0, abs=2e-3)
    assert re.match(r"ended at t = 0\.\d+ s of 5 s: the acc.* not finite", motion.reason)


def test_escape_to_infinity_ends_the_motion() -> None:
    # x'' = 2 x^3 from x = 1, x' = 1 is x = 1 / (1 - t).
    motion = simulate(pushed(lambda x: 2 * x**3), 2.0, initial={"x": 1.0, "x_dot": 1.0})
    assert motion.ending in (Ending.STALLED, Ending.NOT_FINITE)
    assert np.allclose(motion.coordinates["x"][:200] * (1 - motion.times[:200]), 1, atol=1e-7)
    assert "ended at t = 1 s" in motion.reason


def test_acceleration_that_is_not_finite_at_the_start_is_refused() -> None:
    with pytest.raises(SingularError, match=r"no motion starts.*accelerations are not finite"):
        simulate(pushed(lambda x: 1 / x), 1.0)


def test_too_many_steps_end_the_motion(pendulum: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(march, "MAX_STEPS", 5)
    motion = simulate(pendulum, 10.0)
    assert motion.ending is Ending.TOO_LONG
    assert 1 < len(motion.times) < 501


def test_a_motion_is_one_line_and_what_it_calls_is_named(pendulum: Model) -> None:
    motion = simulate(pendulum, 1.0)
    assert repr(motion).count("\n") == 0
    assert "501 samples" in repr(motion)
    part = compile(pendulum.equations, outputs=("forward_dynamics",))
    with pytest.raises(InputError, match="compiled without coordinate_rates, energy: name them"):
        simulate(part, 1.0)
