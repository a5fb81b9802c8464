"""A moving picture goes through the motion that was simulated."""

import re
import sys
import xml.etree.ElementTree as ElementTree
from itertools import accumulate
from pathlib import Path

import numpy as np
import pytest

from mechanics.errors import InputError
from mechanics.report.animation import COARSE, LARGEST_TURN, SLOW, animation, watchable
from mechanics.report.coordinates import RADIUS, SPIRAL, TURNS
from mechanics.report.drawing import drawing
from mechanics.report.motion import FAR, moving_figure, supported, write_motion
from systems import cartpole, double_pendulum, rolling_disc, slider_crank

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


def test_a_page_has_the_rules_of_its_curves(tmp_path: Path) -> None:
    """Without them curves are filled areas."""
    times = np.linspace(0, 2, 21)
    columns = {"t": times, "x": times, "theta": times, "total_energy": times}
    write_motion(cartpole.scene(), columns, {}, "a note", tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text(encoding="utf-8")
    for name in re.findall(r'<polyline class="(curve) (s\d)"', text)[0]:
        assert f".{name} {{" in text


def test_many_turns_are_a_spiral_of_the_last_ones() -> None:
    """Thirty turns of a crank, drawn all, hide the scene."""
    scene = slider_crank.scene()
    text = drawing(scene, scene.example | {"theta": 180.5})
    spiral = max(re.findall(r'<polyline class="motion" points="([^"]*)"', text), key=len)
    ways = np.array([list(map(float, pair.split(","))) for pair in spiral.split()])
    steps = np.hypot(*np.diff(ways, axis=0).T)
    assert steps.max() < 2 * np.median(steps)
    assert np.ptp(ways, axis=0).max() < 2 * (RADIUS[1] + SPIRAL * (TURNS + 1))


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


def columns_of_a_cart() -> dict[str, np.ndarray]:
    """A cart that goes to the right at 1 m/s under an upright pole, for 1.23 s."""
    times = np.linspace(0, 1.23, 51)
    still = 0 * times
    return {"t": times, "x": times, "theta": still, "F": still, "kinetic_energy": still + 0.5}


def test_a_page_is_one_file_with_the_motion_and_its_curves(tmp_path: Path) -> None:
    path = tmp_path / "motion.html"
    assert write_motion(cartpole.scene(), columns_of_a_cart(), {"x": "m"}, "a note", path) == ""
    text = path.read_text(encoding="utf-8")
    assert len(re.findall(r'<animate attributeName="points"[^>]* dur="1.23s"', text)) > 3
    assert re.findall(r'class="chart"[^>]*aria-label="([^"]*)', text) == [
        "Coordinates over time: x", "Angles over time: theta", "Energy over time: kinetic energy",
    ]  # fmt: skip
    assert "A note." in text
    assert "(prefers-reduced-motion: reduce), print" in text
    assert not re.search(r"<script|(?:href|src)=(?!\"data:,)|url\(", text)


def test_a_gif_shows_the_same_motion_in_its_own_time(tmp_path: Path) -> None:
    pytest.importorskip("resvg_py")
    image = pytest.importorskip("PIL.Image")
    path = tmp_path / "motion.gif"
    write_motion(cartpole.scene(), columns_of_a_cart(), {}, "", path)
    ends, places = [], []
    with image.open(path) as film:
        assert film.info["loop"] == 0
        for k in range(film.n_frames):
            film.seek(k)
            ends.append(film.info["duration"])
            pixels = np.asarray(film.convert("RGB")).astype(int)
            # The light blue of bodies, below the pole.
            blue = np.abs(pixels[320:] - (0xCF, 0xDE, 0xF1)).max(axis=2) < 4
            places.append(np.nonzero(blue)[1].mean())
    assert list(accumulate(ends))[-1] == 1230
    steps = np.diff(places)
    assert len(places) == 25
    assert np.ptp(places) > 40
    assert np.allclose(steps, steps.mean(), atol=1)


def test_what_leads_far_away_is_followed_while_bodies_are_more_than_dots() -> None:
    columns = columns_of_a_cart()
    far = columns | {"x": 100 * columns["t"]}
    words, picture = moving_figure(cartpole.scene(), far)
    seconds = float(re.fullmatch(r"The first (\S+) s in real time", words)[1])
    pole = 1.0
    assert FAR * pole / 200 < seconds < FAR * pole * 2 / 100
    assert f"{cartpole.scene().name} in motion, {seconds:.2g}" in picture
    assert moving_figure(cartpole.scene(), columns)[0] == "The scene in real time"


def test_moving_pictures_that_cannot_be_written_are_refused(tmp_path, monkeypatch) -> None:
    with pytest.raises(InputError, match=r"suffix \.mp4 .*: use \.svg or \.html or \.gif"):
        supported("motion.mp4")
    with pytest.raises(InputError, match="there is no folder"):
        supported(tmp_path / "none" / "motion.gif")
    monkeypatch.setitem(sys.modules, "resvg_py", None)
    with pytest.raises(InputError, match=r"motion\.gif: GIF needs resvg-py.*mechanics\[gif\]"):
        supported(tmp_path / "motion.gif")
    assert supported(tmp_path / "motion.html").name == "motion.html"
