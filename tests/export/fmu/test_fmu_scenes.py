"""Units of scenes that the systems do not cover: time, rates of inputs, names of all kinds."""

from pathlib import Path

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from particles import pushed
from sympy import Symbol
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.compiled import compile as compile_model
from mechanics.crosscheck.fmu import write_fmu
from mechanics.routes.derivation import by_route
from mechanics.scene import (
    Particle,
    Scene,
    condition,
    gravity,
    orientation,
    parameters,
    position,
    reaction,
    velocity,
)
from mechanics.simulate import simulate

pytestmark = pytest.mark.campaign

KINDS = ["CoSimulation", "ModelExchange"]


def carried() -> Scene:
    """A pendulum whose pivot moves by the input y, in a lift with the condition that it pulls."""
    theta, y = dynamicsymbols("theta y")
    m, L, g = parameters("m L g", units="kg m m/s^2", typical="1 0.5 9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    bob = origin.locatenew("B", y * ground.x).locatenew("C", -L * rod.y)
    return Scene(
        "carried pendulum", ground, origin, coordinates=(theta,), inputs=(y,),
        bodies=(Particle("bob", bob, m),), loads=(gravity(-g * ground.y),),
        reactions=(reaction("S", at=bob, on="bob", by=None, along=rod.y),),
        conditions=(condition("string", Symbol("S", real=True) > 0, "goes slack"),),
        outputs={"bob": position(bob), "rod": orientation(rod), "slip": velocity(bob)},
    )  # fmt: skip


def oddly_named() -> Scene:
    """Names that mean something else in C, in XML or in the unit."""
    sin, clock = dynamicsymbols("sin time")
    register, step = parameters("register step_size", units="kg m/s^2", typical="3 7")
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", sin * ground.x + clock * ground.y)
    return Scene(
        'péndulo "1" \\ <&> ??/', ground, origin, coordinates=(sin, clock),
        bodies=(Particle('m "<&>"', place, register),), loads=(gravity(-step * ground.y),),
        conditions=(condition('a "<&>" ??/', clock > -100, 'has "<&>" ??/ \\ left'),),
    )  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_time_reaches_the_equations(tmp_path: Path, kind: str) -> None:
    unit = write_fmu(compile_model(by_route("kane", pushed())), tmp_path / "pushed.fmu")
    assert validate_fmu(str(unit)) == []
    found = simulate_fmu(
        str(unit), stop_time=2.0, output_interval=0.1, fmi_type=kind, relative_tolerance=1e-10
    )
    t = np.linspace(0, 2, 21)
    # Co-simulation errs by 1e-10 in a step; CVODE by more than its tolerance, step by step.
    tolerance = 1e-9 if kind == "CoSimulation" else 1e-7
    np.testing.assert_allclose(found["x"], 5 * (1 - np.cos(3 * t)) / 18, rtol=0, atol=tolerance)
    np.testing.assert_allclose(found["x_dot"], 5 * np.sin(3 * t) / 6, rtol=0, atol=tolerance)
    np.testing.assert_allclose(found["x_ddot"], 5 * np.cos(3 * t) / 2, rtol=0, atol=1e-14)


@pytest.mark.parametrize("kind", KINDS)
def test_rates_of_inputs_are_inputs(tmp_path: Path, kind: str) -> None:
    model = compile_model(by_route("free_body", carried()))
    unit = write_fmu(model, tmp_path / "carried.fmu", inputs={"y_ddot": 2.0})
    known = {v.name: v for v in read_model_description(str(unit)).modelVariables}
    assert {n for n, v in known.items() if v.causality == "input"} == {"y", "y_dot", "y_ddot"}
    assert float(known["y_ddot"].start) == 2.0
    exact = simulate(model, 1.0, inputs={"y_ddot": 2.0}, samples=21)
    found = simulate_fmu(
        str(unit), stop_time=1.0, output_interval=0.05, fmi_type=kind, relative_tolerance=1e-9
    )
    np.testing.assert_allclose(found["theta"], exact.coordinates["theta"], rtol=0, atol=1e-6)
    assert abs(found["theta"][-1]) > 0.1
    for name in ("bob_x", "bob_y", "rod_xy", "slip_x"):
        np.testing.assert_allclose(found[name], exact.columns[name], rtol=0, atol=1e-6)
    assert known["slip_x"].unit == "m/s"


def test_a_condition_on_a_reaction_ends_the_simulation(tmp_path: Path) -> None:
    """Thrown up with less than sqrt(5 g L), the string goes slack above the middle."""
    model = compile_model(by_route("free_body", carried()))
    start = {"theta_dot": 0.9 * np.sqrt(5 * 9.81 / 0.5)}
    exact = simulate(model, 2.0, initial=start)
    (crossing,) = exact.crossings
    unit = write_fmu(model, tmp_path / "carried.fmu", initial=start)
    said: list[str] = []
    found = simulate_fmu(
        str(unit), stop_time=2.0, output_interval=0.01, fmi_type="ModelExchange",
        relative_tolerance=1e-9, logger=lambda env, status, category, words: said.append(words),
    )  # fmt: skip
    assert found["time"][-1] == pytest.approx(crossing.time, abs=1e-5)
    assert abs(found["S"][-1]) < 1e-3 and found["margin of string"][-1] == found["S"][-1]
    assert b"it goes slack (S > 0 no longer holds)" in said[0]


def test_names_of_all_kinds(tmp_path: Path) -> None:
    model = compile_model(by_route("kane", oddly_named()))
    unit = write_fmu(model, tmp_path / "odd.fmu", initial={"time": 2.0, "sin_dot": 1.0})
    assert validate_fmu(str(unit)) == []
    description = read_model_description(str(unit))
    known = {v.name: v for v in description.modelVariables}
    assert known["time"].causality == "independent"
    assert float(known["time 2"].start) == 2.0 and float(known["step_size"].start) == 7.0
    assert known["step_size 2"].description == "co-simulation: longest internal step"
    assert known['margin of a "<&>" ??/'].description.endswith('or it has "<&>" ??/ \\ left')
    said: list[bytes] = []
    found = simulate_fmu(
        str(unit), stop_time=10.0, output_interval=0.1, fmi_type="CoSimulation",
        logger=lambda env, status, category, words: said.append(words),
    )  # fmt: skip
    # 2 - 7 t^2 / 2 = -100
    fall = np.sqrt(2 * 102 / 7)
    assert fall <= found["time"][-1] <= fall + 0.2
    assert b'it has "<&>" ??/ \\ left (time > -100 no longer holds)' in said[0]
