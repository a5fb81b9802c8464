"""Pictures of the documentation are what `python -m benchmarks.pictures` makes of today's code."""

import re

import numpy as np
import pytest

from benchmarks import pictures
from mechanics.crosscheck import derive
from mechanics.report.trade_plot import style
from mechanics.simulate.integrators import INTEGRATORS, Setting
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice, Variant
from mechanics.trade.measure import prepared
from mechanics.trade.yardstick import yardstick
from systems import elastic_pendulum

NUMBER = re.compile(r"-?\d+\.\d")
POINT = re.compile(
    r'cx="([\d.]+)"[^>]*><title>((?:C|SciPy) \w+), (step|tolerance) ([\d.e-]+)(?: s)?:'
    r" ([\d.e+]+) (\S+) for a second, error ([\d.e+-]+)<"
)


def kept(name: str) -> str:
    return (pictures.IMAGES / pictures.DRAWN[name][0]).read_text(encoding="utf-8")


def test_every_picture_of_the_documentation_is_checked_here() -> None:
    assert {file for file, _ in pictures.DRAWN.values()} == {
        path.name for path in pictures.IMAGES.iterdir()
    }


@pytest.mark.campaign
def test_the_moving_picture_is_the_motion_of_the_tutorial() -> None:
    """Numbers may differ in their last digit."""
    drawn, picture = pictures.pendulum(), kept("pendulum")
    assert NUMBER.sub("#", drawn) == NUMBER.sub("#", picture)
    pairs = zip(NUMBER.findall(drawn), NUMBER.findall(picture), strict=True)
    assert max(abs(float(a) - float(b)) for a, b in pairs) < 0.15


@pytest.mark.campaign
def test_the_answer_is_the_page_that_is_written_now() -> None:
    """If not: ``python -m benchmarks.pictures answer``, and look at it."""
    picture = (pictures.IMAGES / "answer.png").read_bytes()
    assert pictures.digest_of(picture) == pictures.digest(pictures.answer())


def test_a_digest_stands_in_a_picture_beside_its_data() -> None:
    png = b"\x89PNG\r\n\x1a\n" + b"\0\0\0\0IHDR" + b"\0\0\0\0IDATdata"
    marked = pictures.with_digest(png, "page")
    assert pictures.digest_of(marked) == pictures.digest("page") != pictures.digest("other")
    assert pictures.digest_of(png) == ""
    assert marked.endswith(b"IDATdata")


@pytest.mark.campaign
def test_the_map_of_errors_is_what_is_measured_now() -> None:
    """Another compiler may round a cell or two in a hundred into the next shade."""
    drawn, picture = pictures.errors(), kept("extremes")
    words = re.compile(r"<text class=\"(?:title|form|tick|axis-title)\".*?</text>")
    assert words.findall(drawn) == words.findall(picture)
    assert np.mean(shades(drawn) == shades(picture)) > 0.97


def shades(svg: str) -> np.ndarray:
    """The class of each cell; neighbours of one class are one rectangle."""
    cells = re.findall(r'<rect class="(\w+)" x="[\d.]+" y="[\d.]+" width="([\d.]+)"', svg)
    return np.array([kind for kind, width in cells for _ in range(round(float(width) / 14))])


def test_the_work_precision_plot_has_the_style_and_the_integrators_of_today() -> None:
    picture = kept("work_precision")
    assert f"<style>{style()}</style>" in picture
    shown = {name for _, name, *_ in POINT.findall(picture)}
    assert shown <= {member.name for member in INTEGRATORS}
    assert len(shown) > 7


def test_points_of_the_work_precision_plot_stand_at_their_errors() -> None:
    """x = a - b log10(error), with one a and one b: the axis is in its ticks."""
    points = POINT.findall(kept("work_precision"))
    x, logs = np.array([(float(p[0]), np.log10(float(p[-1]))) for p in points]).T
    slope, start = np.polyfit(logs, x, 1)
    assert np.abs(start + slope * logs - x).max() < 0.03 * abs(slope)
    assert start == pytest.approx(58, abs=1)


@pytest.mark.campaign
def test_errors_of_the_work_precision_plot_are_what_is_measured_now() -> None:
    """Times are of the machine that drew it; errors are not. Steps go through the samples."""
    equations = derive(elastic_pendulum.scene(), "kane")
    case, stick, _ = yardstick(Case(equations, pictures.HORIZON, through=True))
    off = []
    points = [p for p in POINT.findall(kept("work_precision")) if 1e-9 < float(p[-1]) < 1e-2]
    for _, name, knob, amount, _, _, error in points[::7]:
        choice = Choice(Variant(), Setting(name, **{knob: float(amount)}))
        now = np.max(stick.truth.errors(prepared(case, choice)().states))
        off.append(abs(np.log10(now / float(error))))
    assert len(off) > 8
    assert max(off) < 0.05
