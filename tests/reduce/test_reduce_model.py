"""A reduced model compiles, simulates, exports and verifies as any other, within its domain."""

import json

import numpy as np
import pytest

from mechanics import derive, simulate
from mechanics.errors import InputError, ValueMissingError
from mechanics.kernel import Verdict
from mechanics.reduce import Reduction, reduce, reduced_model
from mechanics.reduce.record import record_text, repeat
from mechanics.simulate import Ending
from systems import elastic_pendulum, rocker

BOX = {"theta": ("-0.2", "0.2"), "theta_dot": (-1, 1), "x": ("-0.1", "0.1")}


@pytest.fixture(scope="module")
def reduction() -> Reduction:
    return reduce(derive(elastic_pendulum.scene(), "kane"), "0.05", over=BOX)


def test_small_angles_make_the_pendulum_linear(reduction: Reduction) -> None:
    """Of the rod and the mass, two springs: by hand at the typical values."""
    found = reduced_model(reduction, compiler=None).forward_dynamics([0.1, 0.05], [0.0, 1.0])
    mass = np.array([[2.0, 0.5], [0.5, 1 / 3]])
    # The term of theta_dot^2 is left out.
    want = np.linalg.solve(mass, [-2 * 10 * 0.1, -9.81 / 2 * 0.05])
    assert found == pytest.approx(want, rel=1e-12)
    assert reduction.after < reduction.before


def test_the_domain_is_a_function_and_a_condition(reduction: Reduction) -> None:
    model = reduced_model(reduction, compiler=None)
    (margins,) = model.evaluate("domain", q=[0.05, 0.1], u=[0.0, 0.5]).values()
    order = [*reduction.box]
    pairs = dict(zip(order, np.reshape(margins, (-1, 2)).tolist(), strict=True))
    assert pairs["theta"] == pytest.approx([0.3, 0.1])
    assert pairs["theta_dot"] == pytest.approx([1.5, 0.5])
    assert simulate(model, 0.01, samples=2).ending is Ending.COMPLETE
    inside = simulate(model, 0.05, initial={"theta": 0.05, "x": 0.0}, samples=3)
    assert inside.ending is Ending.COMPLETE
    out = simulate(model, 2.0, initial={"theta": 0.15, "theta_dot": 1.0}, samples=3)
    assert out.ending is Ending.LEFT_DOMAIN
    assert "leaves the domain of the reduced model" in out.reason


def test_what_has_one_value_is_in_the_domain() -> None:
    box = {name: ends for name, ends in BOX.items() if name != "x"}
    equations = derive(elastic_pendulum.scene(), "kane")
    found = reduce(equations, "0.05", over=box, values={"x": 0})
    (margins,) = (
        reduced_model(found, compiler=None).evaluate("domain", q=[0.01, 0.1], u=[0.0, 0.0]).values()
    )
    pairs = dict(zip(found.box, np.reshape(margins, (-1, 2)).tolist(), strict=True))
    assert pairs["x"] == pytest.approx([0.01, -0.01])
    assert repeat(record_text(found), equations).finding.verdict is Verdict.PROVED


def test_a_record_is_repeated_and_another_is_not_it(reduction: Reduction) -> None:
    text, equations = record_text(reduction), reduction.equations
    again = repeat(text, equations)
    assert record_text(again) == text and again.finding.verdict is Verdict.PROVED
    told = json.loads(text)
    told["error"] = "1/1000"
    assert repeat(json.dumps(told), equations).finding.verdict is Verdict.UNDECIDED
    for damage in ({"edits": [[10**6, "ZERO"]]}, {"edits": [["x", "y"]]}, {"base": 99}):
        with pytest.raises(InputError, match=r"reduction\.json"):
            repeat(json.dumps({**told, **damage}), equations)


def test_what_is_not_proved_makes_no_model() -> None:
    """The rocker's acceleration where its inertia may vanish has no bound."""
    box = {"theta": (-9, 9), "theta_dot": (-1, 1), "f": (-5, 5), "I_C": (-1, 1), "M": (-1, 1)}
    found = reduce(derive(rocker.scene(), "kane"), "0.01", over=box, boxes=64)
    if found.edits or not found.finding.shown:
        with pytest.raises(InputError, match="UNDECIDED"):
            reduced_model(found)
    else:
        assert found.after == found.before


REFUSED = (
    ({"error": -1}, "a number that is not negative"),
    ({"error": "nan"}, "a number that is not negative"),
    ({"error": 0.1, "of": "forward"}, "did you mean 'forward_dynamics'"),
    ({"error": 0.1, "of": "step"}, "made of others"),
    ({"error": 0.1, "over": {"thta": (0, 1)}}, "did you mean 'theta'"),
    ({"error": 0.1, "over": {"theta": (1, 0)}}, "is empty"),
    ({"error": 0.1, "over": {"theta": (0, 1)}}, "depends on theta_dot, x"),
    ({"error": 0.1, "over": {"theta": (0, 1, 2)}}, "give \\(lowest, highest\\)"),
    ({"error": 0.1, "over": ["theta [0, 1]"]}, "it is no range"),
    ({"error": 0.1, "over": ["theta in [0, a]"]}, "is no number"),
    ({"error": 0.1, "over": ["theta in [0, 1]", "theta in [0, 2]"]}, "given twice"),
    ({"error": 0.1, "over": BOX, "values": {"x": 0}}, "a range and a value"),
    ({"error": 0.1, "over": BOX, "values": {"m": -1}}, "is negative"),
    ({"error": 0.1, "over": BOX, "boxes": 0}, "1 or more"),
)


@pytest.mark.sample(4)
@pytest.mark.parametrize(("options", "words"), REFUSED)
def test_bad_input_is_refused_by_name(options: dict, words: str) -> None:
    with pytest.raises((InputError, ValueMissingError), match=words):
        reduce(derive(elastic_pendulum.scene(), "kane"), options.pop("error"), **options)
