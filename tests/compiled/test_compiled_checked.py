"""No infinity passes for an acceleration: errors that name the state and say why."""

import numpy as np
import pytest

from mechanics.compiled import compile as compile_model
from mechanics.compiled.c.status import watched, with_watched
from mechanics.errors import InputError, RangeError, SingularError

NAN, INF = float("nan"), float("inf")


@pytest.fixture(params=["auto", None], ids=["C", "virtual machine"])
def pendulum(request, derived):
    return compile_model(derived("elastic_pendulum", "kane"), compiler=request.param)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("q", "u", "p", "error", "words"),
    [
        ([0.1, NAN], [0, 0], {}, InputError, "theta = nan: give finite numbers"),
        ([0.1, 0.3], [0, INF], {}, InputError, "theta_dot = inf"),
        ([0.1, 0.3], [0, 0], {"m": INF}, InputError, "m = inf"),
        ([0.1, 0.3], [0, 1e200], {}, RangeError, "beyond the largest number at x = 0.1"),
        ([0.1, 0.3], [0, 0], {"M": 0, "m": 0}, SingularError, "without mass"),
        ([[1, 2], [1, 2], [1, NAN]], [0, 0], {}, InputError, "state 2 of the batch: theta = nan"),
    ],
)
def test_what_is_no_number_is_an_error(pendulum, q, u, p, error, words: str) -> None:
    with pytest.raises(error, match=words):
        pendulum.forward_dynamics(q, u, p=p)
    raw = pendulum.forward_dynamics(q, u, p=p, check=False)
    assert raw.shape == np.shape(q)


def test_an_infinity_that_a_quotient_hides_is_an_error(derived) -> None:
    """2 (M + m) is infinite, so x'' is zero: a number, and wrong."""
    model = compile_model(derived("elastic_pendulum", "kane"), form="primitive")
    q, u, p = [0.1, 0.3], [0, 0], {"m": 1.5e308}
    assert model.forward_dynamics(q, u, p=p, check=False)[0] == 0
    with pytest.raises(RangeError, match="pass check=False"):
        model.forward_dynamics(q, u, p=p)


def test_checked_and_raw_values_are_the_same(pendulum) -> None:
    random = np.random.default_rng(0)
    q, u = random.normal(size=(2, 50, 2))
    assert np.array_equal(
        pendulum.forward_dynamics(q, u), pendulum.forward_dynamics(q, u, check=False)
    )
    assert pendulum.forward_dynamics(np.zeros((0, 2)), np.zeros((0, 2))).shape == (0, 2)


def test_multipliers_are_checked_too(modelled) -> None:
    disc = modelled("rolling_disc", "free_body")
    q, u = [0, 0, 0.3, 0.4, 0], [1, 2, 3, 4, 5]
    assert disc.multipliers(q, u).shape == (2,)
    with pytest.raises(SingularError, match="rolling disc: the equations are singular"):
        disc.multipliers(q, u, p={"m": 0, "R": 0})


def test_divisors_are_watched_and_constants_are_not(modelled) -> None:
    code = modelled("elastic_pendulum", "kane").program("forward_dynamics")
    found = watched(code)
    assert found.divisors and all(code.nodes[k].constant is None for k in found.divisors)
    assert with_watched(code).shapes[-1] == ("watched", (len(found.divisors), 1))
    assert not watched(modelled("elastic_pendulum", "kane").program("mass_matrix")).divisors
