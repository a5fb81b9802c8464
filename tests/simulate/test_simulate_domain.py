"""Where a simulation leaves the domain of its model: located, named, not passed in silence."""

import math

import numpy as np
import pytest
from sympy import Abs, Symbol, pi, symbols
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import compile, derive, simulate
from mechanics.compiled import Model
from mechanics.errors import InputError, SceneError
from mechanics.scene import Particle, Scene, condition, force, gravity, parameters, reaction
from mechanics.scene.conditions import Condition
from mechanics.scene.validity import condition_parameters
from mechanics.simulate import Ending
from systems import rocker

theta, f = dynamicsymbols("theta f")
m, L, g = parameters("m L g", units="kg m m/s^2", typical="1 1 9.81")
S = Symbol("S", real=True)


def pendulum(*conditions: Condition, example: float = 0.0) -> Scene:
    """A bob on a string, theta from the downward vertical; f drives it sideways."""
    ground, origin = ReferenceFrame("G"), Point("O")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    tip = origin.locatenew("P", -L * rod.y)
    return Scene(
        "bob on a string",
        ground,
        origin,
        coordinates=(theta,),
        bodies=(Particle("bob", tip, m),),
        loads=(gravity(-g * ground.y), force("f", tip, f * rod.x, on="bob")),
        reactions=(reaction("S", at=tip, on="bob", by=None, along=rod.y),),
        inputs=(f,),
        example={"theta": example},
        conditions=conditions,
    )


TAUT = condition("string", S >= 0, "goes slack")


def model(*conditions: Condition) -> Model:
    return compile(derive(pendulum(*conditions), "kane"))


@pytest.fixture(scope="module")
def rolling() -> Model:
    return compile(derive(rocker.scene(), "kane"))


def test_a_string_goes_slack_where_the_textbook_says() -> None:
    # From the bottom with v^2 = 4 g L: slack where cos theta = (2 - v^2/(g L)) / 3 = -2/3.
    start = {"theta_dot": 2 * math.sqrt(9.81)}
    found = simulate(model(TAUT), 3.0, initial=start, samples=3001, rtol=1e-12)
    assert found.ending is Ending.LEFT_DOMAIN
    (crossing,) = found.crossings
    assert crossing.leaving and crossing.condition == "string"
    assert "goes slack" in found.reason and "S >= 0" in found.reason
    assert found.times[-1] <= crossing.time < found.times[-1] + 0.0011
    # theta at the crossing, by Taylor's formula from the last sample.
    last = found.coordinates["theta"][-1]
    rest = crossing.time - found.times[-1]
    there = last + rest * found.speeds["theta_dot"][-1] - rest**2 / 2 * 9.81 * math.sin(last)
    assert math.cos(there) == pytest.approx(-2 / 3, abs=1e-8)


def test_going_on_beyond_is_marked_until_it_comes_back() -> None:
    start = {"theta_dot": 2.1 * math.sqrt(9.81)}
    found = simulate(model(TAUT), 3.0, initial=start, beyond_domain=True)
    assert found.ending is Ending.COMPLETE
    leaving = [crossing.leaving for crossing in found.crossings]
    assert leaving == [True, False] * (len(leaving) // 2) and leaving
    times = [crossing.time for crossing in found.crossings]
    assert times == sorted(times)
    assert found.outside[0] == (times[0], times[1])
    assert "goes slack" in found.note


def test_an_excursion_within_one_step_is_found() -> None:
    low = condition("low", theta <= 0.99999, "rises too high")
    # It turns at theta = 1, outside for three thousandths of a second, a small part of a step.
    found = simulate(model(low), 2.0, initial={"theta": -1.0}, beyond_domain=True, rtol=1e-6)
    assert [crossing.leaving for crossing in found.crossings] == [True, False]
    begin, end = (crossing.time for crossing in found.crossings)
    # theta(t) = 1 - g sin(1)/2 (t - T)^2 at the top, so it is outside for 2 sqrt(2e-5/(g sin 1)).
    assert end - begin == pytest.approx(2 * math.sqrt(2e-5 / (9.81 * math.sin(1.0))), rel=0.05)


def test_touching_the_edge_from_inside_is_no_exit() -> None:
    touch = condition("top", Abs(theta) <= pi / 2, "turns over")
    found = simulate(model(touch), 5.0, initial={"theta": math.nextafter(math.pi / 2, 0) - 1e-6})
    assert found.ending is Ending.COMPLETE and not found.crossings


def test_a_start_outside_is_refused_or_marked() -> None:
    with pytest.raises(InputError, match=r"starts outside .* goes slack \(S >= 0 does not hold\)"):
        simulate(model(TAUT), 1.0, initial={"theta": 3.0})
    found = simulate(model(TAUT), 0.1, initial={"theta": 3.0}, beyond_domain=True)
    assert found.crossings[0].time == 0.0 and found.outside == ((0.0, 0.1),)


def test_conditions_hold_inputs_and_several_are_told_in_order() -> None:
    weak = condition("drive", Abs(f) <= 1, "saturates")
    found = simulate(
        model(TAUT, weak), 2.0, inputs={"f": lambda t: 0.5 * t + 0.7}, beyond_domain=True
    )
    assert found.crossings[0].condition == "drive"
    assert found.crossings[0].time == pytest.approx(0.6, abs=1e-12)


@pytest.mark.campaign
def test_the_accuracy_does_not_pass_the_edge(rolling: Model) -> None:
    plain = simulate(rolling, 3.0)
    found = simulate(rolling, 3.0, accuracy=1e-7)
    assert found.ending is plain.ending is Ending.LEFT_DOMAIN
    assert found.crossings[-1].time == pytest.approx(plain.crossings[-1].time, rel=1e-6)
    assert found.error_estimate is not None and found.error_estimate < 1e-7


def test_the_rocker_comes_to_the_end_of_its_half_disc(rolling: Model) -> None:
    found = simulate(rolling, 3.0)
    assert [crossing.condition for crossing in found.crossings] == ["half disc"]
    assert abs(found.coordinates["theta"][-1]) < math.pi / 2


def test_the_rocker_slips_and_lifts_off(rolling: Model) -> None:
    slippery = simulate(rolling, 3.0, parameters={"mu": 0.1})
    assert [crossing.condition for crossing in slippery.crossings] == ["rolling"]
    reactions = rolling_reactions(slippery.crossings[0].time)
    assert abs(reactions["T"]) == pytest.approx(0.1 * reactions["N"], rel=1e-6)
    # At theta = 0 the floor carries N = M (g - R/2 theta'^2).
    edge = math.sqrt(2 * 9.81 / 0.1)
    with pytest.raises(InputError, match="lifts off"):
        simulate(rolling, 1.0, initial={"theta": 0.0, "theta_dot": edge * (1 + 1e-9)})


def rolling_reactions(time: float) -> dict[str, float]:
    """Reactions of the example motion at a time."""
    full = compile(derive(rocker.scene(), "free_body"))
    found = simulate(full, time, samples=2, rtol=1e-12)
    q = [float(found.coordinates["theta"][-1])]
    u = [float(found.speeds["theta_dot"][-1])]
    values = full.evaluate("reactions", q=q, u=u, inputs=[0.0], p=None)["reactions"]
    names = (entry.name for entry in full.quantities.reactions)
    return dict(zip(names, np.ravel(values).tolist(), strict=True))


def test_parameters_of_conditions_are_no_arguments_of_the_equations(rolling: Model) -> None:
    assert [symbol.name for symbol in condition_parameters(rocker.scene())] == ["mu"]
    assert "mu" not in [entry.name for entry in rolling.quantities.p]
    with pytest.raises(InputError, match="parameter mu: -1 is negative"):
        simulate(rolling, 1.0, parameters={"mu": -1.0})


N = Symbol("N", positive=True)
(mu,) = parameters("mu")


@pytest.mark.parametrize(
    ("relation", "words"),
    [
        (N > 0, "condition c: the relation is True whatever happens"),
        (S, "condition c: the relation is S, a Symbol"),
        ("S > 0", "condition c: the relation is 'S > 0', a str"),
    ],
)
def test_what_is_no_inequality_is_refused(relation: object, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        condition("c", relation, "breaks")


@pytest.mark.parametrize(
    ("relation", "words"),
    [
        (symbols("Z", real=True) > 0, "condition c: Z is neither .* the reactions are S"),
        (mu < 1, "condition c: mu < 1 does not depend on the motion"),
        (dynamicsymbols("phi") > 0, "condition c: phi.* is neither a coordinate"),
    ],
)
def test_a_condition_about_nothing_in_the_scene_is_refused(relation: object, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        pendulum(condition("c", relation, "breaks"))


def test_names_of_conditions_differ() -> None:
    with pytest.raises(SceneError, match="2 times a condition named 'string'"):
        pendulum(TAUT, TAUT)
