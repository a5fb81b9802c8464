"""Mode shapes swing: along the shape, through rest, far enough to be seen."""

import xml.etree.ElementTree as ElementTree
from dataclasses import replace

import numpy as np
import pytest
from sympy import pi

from mechanics import derive
from mechanics.crosscheck.small_motions import small_motions
from mechanics.report.projection import View
from mechanics.report.swing import swings
from systems import (
    acrobot,
    cylinder_in_cylinder,
    elastic_pendulum,
    half_car,
    rocker,
    rod_pendulum,
    two_mass_chain,
)


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


@pytest.mark.campaign
def test_a_damped_mode_decays_as_its_pole_says() -> None:
    scene = half_car.scene()
    found, _ = small_motions({"kane": derive(scene, "kane")})
    swinging = found[0].swings
    assert len(swinging) == 4
    for mode, (words, text) in zip(swinging, swings(scene, swinging), strict=True):
        assert mode.growth < 0
        assert "damping ratio 0." in words
        assert "nan" not in text
        assert {e.get("dur") for e in ElementTree.fromstring(text).iter("animate")} == {"6s"}
    # x'' + 2 zeta omega x' + omega^2 x = 0 of each pole, by its ratio after a period.
    mode = swinging[0]
    _, text = swings(scene, (mode,))[0]
    body = next(e for e in ElementTree.fromstring(text).iter("polyline") if e.get("class") == "rim")
    heights = np.array(
        [float(p.split()[0].split(",")[1]) for p in str(body[0].get("values")).split(";")]
    )
    swing = heights - heights[-1]
    first, second = np.abs(swing[:24]).max(), np.abs(swing[24:48]).max()
    assert second / first == pytest.approx(np.exp(2 * np.pi * mode.growth / mode.omega), rel=0.15)


@pytest.mark.campaign
def test_what_rolls_swings_with_its_constraint() -> None:
    scene = cylinder_in_cylinder.scene()
    found, remarks = small_motions({"lagrange": derive(scene, "lagrange")})
    assert not remarks
    (mode,) = found[0].swings
    ((words, text),) = swings(scene, (mode,))
    assert words.startswith("Mode ")
    R, a, g = (
        float(p.typical)
        for p in (cylinder_in_cylinder.R, cylinder_in_cylinder.a, cylinder_in_cylinder.g)
    )
    # A cylinder that rolls inside another one: omega^2 = 2 g / (3 (R - r)).
    assert mode.omega**2 == pytest.approx(2 * g / (3 * (R - a)))
    assert "<animate" in text


def test_a_mode_about_a_declared_equilibrium_swings_about_that() -> None:
    """A pendulum counted from the upright hangs at pi, and is drawn below its pin."""
    scene = replace(rod_pendulum.scene(), equilibria=({"theta": pi},))
    found, remarks = small_motions({"kane": derive(scene, "kane")})
    upright, hanging = found
    assert (upright.title, hanging.title) == (
        "Natural modes about q = 0", "Natural modes about theta = pi",
    )  # fmt: skip
    assert remarks == upright.swings == ()
    (mode,) = hanging.swings
    assert mode.about == {"theta": pytest.approx(np.pi)}
    assert mode.omega == pytest.approx(np.sqrt(1.5 * 10))
    _, text = swings(scene, (mode,))[0]
    moving = next(e for e in ElementTree.fromstring(text) if e.get("class") == "moving")
    rod = next(e for e in moving if e.get("class") == "rod")
    pin = next(e for e in moving if e.get("class") == "plate")
    below = [float(pair.split(",")[1]) for pair in str(rod.get("points")).split()]
    top = [float(pair.split(",")[1]) for pair in str(pin.get("points")).split()]
    assert max(below) > max(top) + 20
