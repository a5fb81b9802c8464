"""`simulate(accuracy=...)`: the error that is asked for is met, and the estimate is honest."""

from typing import Any

import numpy as np
import pytest

from mechanics import simulate
from mechanics.cli.load import load
from mechanics.compiled import compile
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.simulate.integrators import INTEGRATORS
from mechanics.simulate.reference import reference
from mechanics.trade.accurate import states_of
from mechanics.trade.case import Case
from mechanics.trade.truth import from_reference

pytestmark = pytest.mark.campaign

FEW = tuple(m for m in INTEGRATORS if m.name in ("SciPy DOP853", "C RK5", "C RK8"))


def model_of(name: str, compiler: str | None = "auto") -> Any:
    return compile(derive(load(name).scene(), "kane"), compiler=compiler)


@pytest.mark.sample(1)
@pytest.mark.parametrize("accuracy", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("name", ["elastic_pendulum", "rolling_disc"])
def test_accuracy_is_met_at_every_sample(name: str, accuracy: float) -> None:
    model = model_of(name)
    found = simulate(model, 2.0, accuracy=accuracy, samples=41, members=FEW)
    case = Case(model.equations, 2.0, grid=tuple(found.times.tolist())).with_model(model)
    truth = from_reference(reference(case.problem(), 18))
    error = float(np.max(truth.errors(states_of(found))))
    assert error <= accuracy
    assert found.error_estimate <= accuracy
    # The estimate tells the size of the error: a finer setting is much more accurate.
    assert error / 5 <= found.error_estimate <= 5 * error or error < 1e-13
    assert found.solved_by.split(",")[0] in {m.name for m in FEW}


def test_batch_meets_the_accuracy_for_each_state() -> None:
    model = model_of("elastic_pendulum")
    found = simulate(
        model, 2.0, accuracy=1e-7, initial={"theta": [0.1, 1.0, 3.0]}, samples=21, members=FEW
    )
    assert [one.coordinates["theta"][0] for one in found] == [0.1, 1.0, 3.0]
    assert all(one.error_estimate <= 1e-7 for one in found)


def test_constraints_are_kept_while_the_accuracy_is_met() -> None:
    found = simulate(model_of("rolling_disc"), 1.0, accuracy=1e-6, samples=21)
    assert found.solved_by.startswith("SciPy")
    assert found.drift and max(found.drift.values()) < 1e-5


def test_inputs_that_are_functions_are_accepted() -> None:
    model = model_of("rocker")
    found = simulate(model, 1.0, accuracy=1e-6, inputs={"f": np.sin}, samples=21, members=FEW)
    assert found.error_estimate <= 1e-6


def test_machine_without_a_compiler_meets_it_too() -> None:
    model = model_of("elastic_pendulum", None)
    found = simulate(model, 1.0, accuracy=1e-6, samples=21, members=FEW)
    assert found.error_estimate <= 1e-6


def test_without_accuracy_nothing_is_chosen() -> None:
    found = simulate(model_of("two_mass_chain"), 1.0, samples=11)
    assert found.error_estimate < 1e-9
    assert found.solved_by == ""


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"accuracy": 0.0}, "accuracy: 0.0 found"),
        ({"accuracy": 2.0}, "accuracy: 2.0 found"),
        ({"accuracy": float("nan")}, "accuracy: nan found"),
        ({"accuracy": 1e-17}, "doubles round to 2.2e-16"),
        ({"accuracy": 3e-16}, "no choice meets it; the best is"),
        ({"accuracy": 1e-6, "rtol": 1e-6}, "it chooses rtol: give one or the other"),
    ],
)
def test_accuracy_that_cannot_be_is_refused(options: dict[str, float], words: str) -> None:
    with pytest.raises(InputError, match=words):
        simulate(model_of("elastic_pendulum"), 1.0, members=FEW, samples=11, **options)
