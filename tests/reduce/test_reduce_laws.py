"""Laws of reductions over systems: what is proved is not exceeded, more error costs less."""

from collections.abc import Callable, Mapping
from fractions import Fraction

import numpy as np
import pytest

from benchmarks.largest_deviation import largest_deviations
from mechanics import derive
from mechanics.kernel import Verdict
from mechanics.program import Program
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.reduce import Reduction, reduce
from mechanics.reduce.edits import Edit, Kind
from mechanics.scene import Scene
from systems import bead_on_hoop, cartpole, double_pendulum, elastic_pendulum, four_bar, rocker

Case = tuple[Callable[[], Scene], str, dict[str, tuple[float, float]]]

PENDULUM = {"theta": (-0.2, 0.2), "theta_dot": (-1, 1), "x": (-0.1, 0.1)}
ROCKER = {"theta": (-0.1, 0.1), "theta_dot": (-1, 1), "f": (-5, 5)}
CART = {"theta": (-0.3, 0.3), "theta_dot": (-1, 1), "F": (-5, 5), "theta_ddot": (-3, 3),
        "x_ddot": (-3, 3)}  # fmt: skip
DOUBLE = {"phi1": (-0.2, 0.2), "phi2": (-0.2, 0.2), "phi1_dot": (-1, 1), "phi2_dot": (-1, 1),
          "phi1_ddot": (-3, 3), "phi2_ddot": (-3, 3)}  # fmt: skip
HOOP = {"theta": (-0.2, 0.2), "theta_dot": (-1, 1)}
BAR = {"q1": (0.9, 1.1), "q2": (0.1, 0.4), "q3": (1.0, 1.5), "q1_dot": (-1, 1), "q2_dot": (-1, 1),
       "q3_dot": (-1, 1), "tau": (-1, 1), "q1_ddot": (-2, 2), "q2_ddot": (-2, 2),
       "q3_ddot": (-2, 2)}  # fmt: skip

CASES: dict[str, Case] = {
    "small angles": (elastic_pendulum.scene, "forward_dynamics", PENDULUM),
    "upright": (rocker.scene, "forward_dynamics", ROCKER),
    "forces on a cart": (cartpole.scene, "inverse_dynamics", CART),
    "two links": (double_pendulum.scene, "inverse_dynamics", DOUBLE),
    "masses of two links": (double_pendulum.scene, "mass_matrix", DOUBLE),
    "hoop": (bead_on_hoop.scene, "forward_dynamics", HOOP),
    "masses of a loop": (four_bar.scene, "mass_matrix", BAR),
}
ERRORS = ("0", "0.01", "0.1", "0.7")
QUICK = ("forces on a cart", "hoop")
EVERY = [
    name if name in QUICK else pytest.param(name, marks=pytest.mark.campaign) for name in CASES
]


@pytest.fixture(scope="module")
def reductions() -> Callable[[str], list[Reduction]]:
    """Of a case, one for each error, made once."""
    made: dict[str, list[Reduction]] = {}

    def of_case(name: str) -> list[Reduction]:
        if name not in made:
            make, of, over = CASES[name]
            equations = derive(make(), "kane")
            made[name] = [reduce(equations, error, of=of, over=over) for error in ERRORS]
        return made[name]

    return of_case


def values(program: Program, inputs: Mapping[str, np.ndarray], count: int) -> np.ndarray:
    found = interpret(program, Arrays(), {name: inputs[name] for name in program.inputs})
    flat = [np.broadcast_to(v, count) for entries in found.values() for v in entries]
    return np.stack(flat)


@pytest.mark.parametrize("name", EVERY)
def test_no_state_of_the_box_deviates_by_more_than_is_proved(
    name: str, reductions: Callable[[str], list[Reduction]]
) -> None:
    draws, count = np.random.default_rng(7), 20_000
    for found in reductions(name):
        assert found.finding.verdict is Verdict.PROVED, found.finding
        inputs = {
            n: draws.uniform(float(low), float(high), count)
            for n, (low, high) in found.start.box.items()
        }
        whole = values(found.start.reduced({}), inputs, count)
        moved = np.abs(values(found.program, inputs, count) - whole).max(axis=1)
        bounds = np.array([float(bound) for bound in found.bounds])
        assert (moved <= bounds + 1e-12 * np.abs(whole).max(axis=1)).all()


@pytest.mark.parametrize("name", EVERY)
def test_states_that_are_searched_for_do_not_either(
    name: str, reductions: Callable[[str], list[Reduction]]
) -> None:
    for found in reductions(name):
        for worst, bound in zip(largest_deviations(found), found.bounds, strict=True):
            assert worst <= bound


@pytest.mark.parametrize("name", EVERY)
def test_a_larger_error_never_takes_more_operations(
    name: str, reductions: Callable[[str], list[Reduction]]
) -> None:
    counts = [found.after for found in reductions(name)]
    assert counts == sorted(counts, reverse=True)
    assert counts[0] <= reductions(name)[0].before


@pytest.mark.parametrize("name", EVERY)
def test_without_an_error_nothing_changes(
    name: str, reductions: Callable[[str], list[Reduction]]
) -> None:
    exact = reductions(name)[0]
    assert set(exact.bounds) == {Fraction(0)}
    assert set(largest_deviations(exact)) <= {Fraction(0)}


@pytest.mark.campaign
def test_an_error_beyond_everything_leaves_nothing() -> None:
    found = reduce(derive(elastic_pendulum.scene(), "kane"), 20, over=PENDULUM)
    assert found.after == 0 and found.finding.verdict is Verdict.PROVED
    assert found.parameters == ((), ("L", "M", "g", "k", "m"))


def test_an_absolute_error_is_in_the_unit_of_the_output() -> None:
    equations = derive(elastic_pendulum.scene(), "kane")
    found = reduce(equations, "0.05", over=PENDULUM, absolute=True)
    assert found.bounds == (Fraction(1, 20),) * 2
    assert found.after < found.before
    assert max(largest_deviations(found)) <= Fraction(1, 20)


@pytest.mark.campaign
def test_a_parameter_with_a_range_stays_an_input_or_goes() -> None:
    equations = derive(elastic_pendulum.scene(), "kane")
    found = reduce(equations, "0.05", over={**PENDULUM, "k": (9, 11)})
    assert "k" in found.program.inputs and found.finding.verdict is Verdict.PROVED
    weak = reduce(equations, "0.05", over={**PENDULUM, "k": ("1e-4", "1e-3")})
    assert "k" in weak.parameters[1]


def test_entries_of_the_mass_matrix_that_are_small_become_numbers() -> None:
    """m2 is tiny: what it couples is less than what is allowed, in kg m^2."""
    equations = derive(double_pendulum.scene(), "kane")
    box = {name: ends for name, ends in DOUBLE.items() if name.startswith("phi")}
    found = reduce(
        equations, "0.01", of="mass_matrix", over=box, values={"m2": "1e-4"}, absolute=True
    )
    assert found.after == 0 and found.finding.verdict is Verdict.PROVED
    assert len(found.program.outputs["mass_matrix"]) == 4


def test_couplings_are_among_what_may_be_left_out() -> None:
    found = reduce(
        derive(cartpole.scene(), "kane"), "0.1",
        over={"theta": (-1.5, 1.5), "theta_dot": (-1, 1), "F": (-5, 5)},
    )  # fmt: skip
    (node, name), *_ = found.base.couplings
    assert name == "M[x_dot, theta_dot]"
    assert Edit(node, Kind.ZERO) in found.start.edits
