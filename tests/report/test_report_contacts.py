"""A page says which bodies roll, from the geometry and the constraints."""

import pytest

from mechanics.report.contacts import rolling_words
from systems import bicycle, cartpole, cylinder_in_cylinder, four_bar, rocker, rolling_disc


@pytest.mark.parametrize(
    ("system", "rolling"),
    [
        (rocker, ["The rocker"]),
        (rolling_disc, ["The disc"]),
        (cylinder_in_cylinder, ["The cylinder"]),
        pytest.param(bicycle, ["The rear", "The front"], marks=pytest.mark.campaign),
        (cartpole, []),
        (four_bar, []),
    ],
)
def test_bodies_roll_whose_point_at_the_contact_is_at_rest(system, rolling: list[str]) -> None:
    sentences = [s for s in rolling_words(system.scene()).split(". ") if s]
    assert [sentence.split(" rolls")[0] for sentence in sentences] == rolling
    assert all("without slip" in sentence for sentence in sentences)


def test_a_wheel_that_may_slip_does_not_roll() -> None:
    """The disc without the constraints that keep its lowest point at rest."""
    scene = rolling_disc.scene()
    slips = type(scene)(
        scene.name, scene.frame, scene.origin, coordinates=scene.coordinates,
        speeds=scene.speeds, bodies=scene.bodies, loads=scene.loads, reactions=scene.reactions,
        constraints=scene.constraints[:1], example=scene.example,
    )  # fmt: skip
    assert rolling_words(slips) == ""
