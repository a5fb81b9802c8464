"""A moving picture goes through the motion that was simulated."""

import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from mechanics.report.animation import COARSE, LARGEST_TURN, SLOW, animation, watchable
from systems import cartpole, double_pendulum, rolling_disc

SVG = "{http://www.w3.org/2000/svg}"


def swing(scene, name: str) -> str:
    times = np.linspace(0, 2, 101)
    still = {q.name: np.full(101, scene.example.get(q.name, 0.2)) for q in scene.q}
    return animation(scene, times, still | {name: 0.2 + np.sin(times)})


@pytest.mark.parametrize(
    ("scene", "name"),
    [
        (cartpole.scene, "x"),
        (double_pendulum.scene, "phi1"),
        pytest.param(rolling_disc.scene, "x", marks=pytest.mark.campaign),
    ],
)
def test_it_is_one_file_that_moves_and_rests_for_who_prefers_that(scene, name) -> None:
    text = swing(scene(), name)
    root = ElementTree.fromstring(text)
    moving = [e for e in root.iter(f"{SVG}animate")]
    assert moving
    assert {e.get("dur") for e in moving} == {"2s"}
    assert "<script" not in text
    assert not re.search(r"(?:href|src|url)\s*[=(]", text)
    assert "prefers-reduced-motion: reduce), print" in text
    assert "nan" not in text


def test_a_cart_goes_where_its_coordinate_says() -> None:
    root = ElementTree.fromstring(swing(cartpole.scene(), "x"))
    (cart,) = (e for e in root.iter(f"{SVG}polygon") if e.get("class") == "body" and len(e))
    samples = [
        np.array([list(map(float, pair.split(","))) for pair in points.split()]).mean(axis=0)
        for points in str(cart[0].get("values")).split(";")
    ]
    x, y = np.array(samples).T
    wanted = 0.2 + np.sin(np.linspace(0, 2, len(x)))
    assert np.ptp(y) < 0.2
    scale = np.ptp(x) / np.ptp(wanted)
    assert np.allclose((x - x[0]) / scale, wanted - wanted[0], atol=0.01)


def test_the_floor_rests() -> None:
    root = ElementTree.fromstring(swing(cartpole.scene(), "x"))
    moving = root.find(f"{SVG}g[@class='moving']")
    assert moving is not None
    floor = [e for e in moving if e.get("class") in ("line", "thin")]
    assert floor
    assert not any(len(e) for e in floor)


def test_what_turns_too_fast_is_shown_slower() -> None:
    """A wheel at 400 rad/s would seem to stand, or to turn back, at ten pictures a second."""
    times = np.linspace(0, 10, 2001)
    assert watchable(times, [np.sin(times)]) == (2001, 1.0)
    assert watchable(times, []) == (2001, 1.0)
    shown, slower = watchable(times, [np.sin(times), -400 * times])
    assert 400 * times[shown - 1] == pytest.approx(LARGEST_TURN * SLOW * COARSE, rel=0.02)
    assert slower * times[shown - 1] == pytest.approx(SLOW, rel=0.02)
    assert np.ptp(400 * times[:shown]) / (COARSE * slower * times[shown - 1]) < 1.1 * LARGEST_TURN
