"""Units pass FMPy's validation, and move in FMPy as the models do in mechanics.simulate."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from mechanics.compiled import Model
from mechanics.crosscheck.fmu import write_fmu
from mechanics.simulate import Ending, Trajectory, simulate
from systems import ALL, four_bar

pytestmark = pytest.mark.campaign

SYSTEMS = [system.name for system in ALL]
DURATION, SAMPLES = 1.0, 51
Models, Units = Callable[[str], Model], Callable[[str], Path]


def reference(model: Model, rtol: float = 1e-12, **options: Any) -> Trajectory:
    return simulate(model, DURATION, samples=SAMPLES, rtol=rtol, atol=rtol / 100, **options)


def ran(unit: Path, kind: str, **options: Any) -> np.ndarray:
    interval = DURATION / (SAMPLES - 1)
    return simulate_fmu(
        str(unit), stop_time=DURATION, output_interval=interval, fmi_type=kind, **options
    )


def difference(one: Any, other: Any, names: list[str]) -> float:
    """Largest difference of the samples that both have."""
    count = min(len(one[names[0]]), len(other[names[0]]))
    return max(float(np.max(np.abs(one[n][:count] - other[n][:count]))) for n in names)


@pytest.mark.sample(1)
@pytest.mark.parametrize("name", SYSTEMS)
def test_fmpy_finds_no_problem(unit_of: Units, name: str) -> None:
    assert validate_fmu(str(unit_of(name))) == []


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SYSTEMS)
def test_co_simulation_is_the_motion_of_simulate(
    unit_of: Units, model_of: Models, name: str
) -> None:
    """Both errors are measured: that of the unit by half of its step, that of the reference by ten
    times its tolerance. What is left is the rounding of a thousand steps.
    """
    exact, coarse = (reference(model_of(name), rtol) for rtol in (1e-12, 1e-11))
    names = [*exact.coordinates, *exact.speeds]
    unit = unit_of(name)
    (step,) = (
        float(v.start)
        for v in read_model_description(str(unit)).modelVariables
        if v.name == "step_size"
    )
    found = ran(unit, "CoSimulation")
    halved = ran(unit, "CoSimulation", start_values={"step_size": step / 2})
    scale = max(float(np.max(np.abs(exact.columns[n]))) for n in names)
    allowed = 2 * difference(found, halved, names)
    allowed += 2 * difference(exact.columns, coarse.columns, names)
    allowed += 1000 * np.finfo(float).eps * scale
    assert difference(found, exact.columns, names) <= allowed
    assert allowed < 1e-7 * scale


@pytest.mark.parametrize("name", SYSTEMS)
def test_model_exchange_is_the_motion_of_simulate(
    unit_of: Units, model_of: Models, name: str
) -> None:
    """CVODE's error at a tenth of a tolerance is less than what the tolerance changes."""
    exact = reference(model_of(name))
    names = [*exact.coordinates, *exact.speeds]
    coarse, fine = (
        ran(unit_of(name), "ModelExchange", relative_tolerance=rtol) for rtol in (1e-8, 1e-9)
    )
    allowed = difference(coarse, fine, names)
    assert difference(fine, exact.columns, names) <= allowed
    assert allowed < 1e-2


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", SYSTEMS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_outputs_are_those_of_the_model(
    unit_of: Units, model_of: Models, name: str, kind: str
) -> None:
    """At the unit's own states, to rounding: the graphs are the same, put together otherwise."""
    model = model_of(name)
    found = ran(unit_of(name), kind)
    known = model.quantities
    q, u = (np.column_stack([found[e.name] for e in group]) for group in (known.q, known.u))
    given = {"q": q, "u": u, "inputs": np.zeros(len(known.inputs))}
    expected = dict(zip(model.entries["ud"], model.forward_dynamics(**given).T, strict=True))
    for part, values in model.energy(**given).items():
        expected[f"{part} energy"] = values
    if known.reactions:
        reactions = model.evaluate("reactions", **given)["reactions"]
        expected |= dict(zip((e.name for e in known.reactions), reactions.T, strict=True))
    for column, values in expected.items():
        scale = np.max(np.abs(values)) + 1e-12
        np.testing.assert_allclose(found[column], values, rtol=0, atol=1e-10 * scale)


def test_inputs_and_parameters_reach_the_unit(unit_of: Units, model_of: Models) -> None:
    force = np.array([(0.0, 3.0), (DURATION, 3.0)], dtype=[("time", float), ("F", float)])
    exact = reference(
        model_of("pendulum_chain"), inputs={"F": 3.0}, parameters={"m1": 2.5, "g": 3.7},
        initial={"q1": 0.4},
    )  # fmt: skip
    names = [*exact.coordinates, *exact.speeds]
    for kind in ("CoSimulation", "ModelExchange"):
        found = ran(
            unit_of("pendulum_chain"), kind, input=force, relative_tolerance=1e-9,
            start_values={"m1": 2.5, "g": 3.7, "q1": 0.4},
        )  # fmt: skip
        assert difference(found, exact.columns, names) < 1e-5


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_the_unit_ends_where_the_model_does(unit_of: Units, model_of: Models, kind: str) -> None:
    exact = reference(model_of("rocker"))
    assert exact.ending is Ending.LEFT_DOMAIN
    (crossing,) = exact.crossings
    said: list[str] = []

    def logged(environment: object, status: int, category: bytes, words: bytes) -> None:
        said.append(f"{category.decode()}: {words.decode()}")

    found = ran(unit_of("rocker"), kind, logger=logged, relative_tolerance=1e-9)
    (words,) = said
    assert words.startswith("logStatusWarning: t = ") and crossing.sentence in words
    # Co-simulation notices at the end of the communication step, an integrator at the crossing.
    interval = DURATION / (SAMPLES - 1)
    late = float(words.split("t = ")[1].split(" s")[0]) - crossing.time
    assert 0 <= late <= interval if kind == "CoSimulation" else abs(late) < 1e-6
    assert found["time"][-1] <= crossing.time + interval


def test_beyond_its_domain_the_unit_goes_on(model_of: Models, tmp_path: Path) -> None:
    unit = write_fmu(model_of("rocker"), tmp_path / "rocker.fmu", beyond_domain=True)
    found = ran(unit, "CoSimulation", output=["theta", "margin of half disc"])
    assert len(found) == SAMPLES
    exact = reference(model_of("rocker"), beyond_domain=True)
    np.testing.assert_allclose(found["theta"], exact.coordinates["theta"], rtol=0, atol=1e-8)
    assert found["margin of half disc"][-1] < 0 < found["margin of half disc"][0]
    np.testing.assert_allclose(
        found["margin of half disc"], np.pi / 2 - np.abs(found["theta"]), rtol=0, atol=1e-15
    )


def test_constraints_drift_no_more_than_the_integration_errs(
    unit_of: Units, model_of: Models
) -> None:
    names = [f"residual of {constraint.name}" for constraint in four_bar.scene().constraints]
    exact = reference(model_of("four_bar"))
    found = ran(unit_of("four_bar"), "CoSimulation")
    error = difference(found, exact.columns, [*exact.coordinates])
    drift = max(float(np.max(np.abs(found[name]))) for name in names)
    # A residual is a sum of lengths, below 1 m, times cosines of the angles.
    assert drift <= 3 * error + 1e-12
    start = ran(unit_of("four_bar"), "ModelExchange", output=names)[0]
    assert max(abs(start[name]) for name in names) < 1e-14
