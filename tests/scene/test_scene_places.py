"""Points and directions by name."""

import pytest
from sympy import Matrix

from mechanics.errors import InputError
from mechanics.scene.places import direction, point_named, points
from systems import elastic_pendulum, rocker


def test_points_on_the_way_from_the_origin_are_found() -> None:
    assert set(points(elastic_pendulum.scene())) == {"O", "B", "C"}
    assert set(points(rocker.scene())) == {"O", "B", "G", "C"}


def test_point_by_name() -> None:
    scene = rocker.scene()
    assert point_named(scene, "C") == scene.body("rocker").centre


def test_an_unknown_point_is_named_with_the_known_ones() -> None:
    with pytest.raises(InputError, match="no point 'D': the points are B, C, O"):
        point_named(elastic_pendulum.scene(), "D")


@pytest.mark.parametrize(("along", "vector"), [("x", [1, 0, 0]), ("-z", [0, 0, -1])])
def test_directions(along: str, vector: list[int]) -> None:
    assert direction(along) == Matrix(vector)


@pytest.mark.parametrize("along", ["w", "--x", ""])
def test_a_direction_is_an_axis(along: str) -> None:
    with pytest.raises(InputError, match="is no axis"):
        direction(along)
