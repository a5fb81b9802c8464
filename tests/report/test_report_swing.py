"""Mode shapes swing: along the shape, through rest, far enough to be seen."""

import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from mechanics import derive
from mechanics.crosscheck.small_motions import small_motions
from mechanics.report.projection import View
from mechanics.report.swing import swings
from systems import acrobot, elastic_pendulum, rocker, two_mass_chain


def modes(scene):
    found, _ = small_motions({"kane": derive(scene, "kane")})
    return found[0].swings


@pytest.mark.parametrize(
    "system", [elastic_pendulum, pytest.param(acrobot, marks=pytest.mark.campaign)]
)
def test_every_mode_with_a_frequency_is_a_picture_that_moves(system) -> None:
    scene = system.scene()
    shapes = modes(scene)
    assert len(shapes) == len(scene.q)
    pictures = swings(scene, shapes)
    for mode, (words, text) in zip(shapes, pictures, strict=True):
        assert words.startswith(f"Mode {mode.number}: ")
        root = ElementTree.fromstring(text)
        assert {e.get("dur") for e in root.iter("animate")} == {"2s"}
        assert "nan" not in text


def test_an_equilibrium_that_does_not_swing_has_no_picture() -> None:
    assert modes(rocker.scene()) == ()


def test_two_masses_swing_in_the_ratio_of_the_shape_about_places_that_rest() -> None:
    # Equal springs, masses 3 m and 2 m: (2/3, 1) and (-1, 1), as the source prints them.
    scene = two_mass_chain.scene()
    for mode, ratio in zip(modes(scene), (2 / 3, -1), strict=True):
        _, text = swings(scene, (mode,))[0]
        moving = next(e for e in ElementTree.fromstring(text) if e.get("class") == "moving")
        assert all(e.find("animate") is None for e in moving if e.get("class") == "zero")
        blocks = [e for e in moving if e.get("class") == "body"]
        paths = [
            np.array([float(corners.split(",")[0]) for corners in values.split(";")])
            for values in (str(block.find("animate").get("values")) for block in blocks)
        ]
        assert len(paths) == 2
        first, second = (path - path[0] for path in paths)
        assert np.abs(second).max() > 10
        np.testing.assert_allclose(first, ratio * second, atol=0.2)


def test_what_stands_between_free_masses_is_as_long_at_every_state() -> None:
    scene = two_mass_chain.scene()
    view = View(scene, {"x1": 0.1, "x2": 0.3})
    moved = view.at({"x1": 0.0, "x2": 0.1})
    for body, way in zip(scene.bodies, (0.1, 0.2), strict=True):
        path = view.point(body.centre) - moved.point(body.centre)
        np.testing.assert_allclose(path, [way, 0], atol=1e-12)
