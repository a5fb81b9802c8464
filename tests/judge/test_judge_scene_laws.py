"""The laws of a scene are verified before anybody is judged by it."""

from dataclasses import replace

import pytest

from mechanics.errors import SceneError
from mechanics.judge import check as judge
from mechanics.judge.scene_laws import verify
from systems import elastic_pendulum, four_bar, pendulum_chain, rolling_disc


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "scene", [elastic_pendulum.scene, rolling_disc.scene, four_bar.scene, pendulum_chain.scene]
)
def test_the_laws_of_a_scene_hold(scene) -> None:
    assert verify(judge.derived(scene())) == ()


def test_equations_that_stay_a_program_are_verified_too() -> None:
    truth = judge.derived(pendulum_chain.scene(15))
    assert truth.textbook is None
    assert verify(truth) == ()


def test_nobody_is_judged_by_equations_that_are_not_of_the_scene(monkeypatch) -> None:
    """A spring that pushes: forces with the wrong sign, as a misread load would have them."""
    truth = judge.derived(elastic_pendulum.scene())
    wrong = truth.with_matrices(forcing=-truth.forcing)
    monkeypatch.setattr(judge, "derived", lambda scene: wrong)
    with pytest.raises(SceneError, match=r"^scene pendulum .* virtual power: .*no statement is"):
        judge.check(elastic_pendulum.scene.__wrapped__(), "x = x")


def test_a_reaction_that_does_work_stops_the_check() -> None:
    scene = elastic_pendulum.scene()
    sideways, *others, upright = scene.reactions
    astray = replace(upright, along=sideways.along)
    with pytest.raises(SceneError, match=f"reaction {upright.name}: it does work"):
        judge.check(replace(scene, reactions=(sideways, *others, astray)), "x = x")
