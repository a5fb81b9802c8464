"""Many initial states at once, and progress as it goes on."""

from typing import Any

import numpy as np
import pytest

from mechanics.cli.load import load
from mechanics.compiled import Model, compile
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.simulate import simulate

ANGLES = (0.3, 1.0, 2.5)


@pytest.fixture(scope="module")
def model() -> Model:
    return compile(derive(load("elastic_pendulum").scene(), "kane"))


@pytest.mark.parametrize(
    "initial",
    [
        tuple({"theta": a, "x": 0.2} for a in ANGLES),
        [{"theta": a, "x": 0.2} for a in ANGLES],
        {"theta": np.array(ANGLES), "x": 0.2},
        {"theta": list(ANGLES), "x": np.full(3, 0.2)},
    ],
)
def test_batch_is_the_same_as_one_after_the_other(model: Model, initial: Any) -> None:
    found = simulate(model, 1.0, initial=initial, samples=11)
    assert isinstance(found, tuple)
    for one, angle in zip(found, ANGLES, strict=True):
        alone = simulate(model, 1.0, initial={"theta": angle, "x": 0.2}, samples=11)
        for name, column in alone.columns.items():
            assert np.array_equal(one.columns[name], column), name


@pytest.mark.parametrize(
    ("initial", "words"),
    [
        ([], "the batch is empty"),
        ({"theta": []}, "the batch is empty"),
        ([{"theta": 1.0}, 3.0], "entry 1 of the batch"),
        ({"theta": [1.0, 2.0], "x": [0.0]}, "arrays of one length"),
        ({"theta": np.ones((2, 2))}, "arrays of one length"),
        ("theta", "give a mapping, or many of them"),
        (3.0, "give a mapping, or many of them"),
    ],
)
def test_what_is_no_batch_is_refused(model: Model, initial: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        simulate(model, 1.0, initial=initial)


@pytest.mark.parametrize("initial", [{"theta": 1.0}, [{"theta": 1.0}, {"theta": 2.0}]])
def test_progress_rises_to_the_end(model: Model, initial: Any) -> None:
    shares: list[float] = []
    simulate(model, 1.0, initial=initial, samples=11, progress=shares.append)
    assert len(shares) > 4
    assert shares == sorted(shares)
    assert 0 < shares[0] < shares[-1] == 1.0
