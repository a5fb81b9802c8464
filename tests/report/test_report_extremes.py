"""The map of the extremes: what is in it, and that it stands alone."""

import re
from functools import cache
from itertools import pairwise
from xml.etree import ElementTree

import pytest

from mechanics.crosscheck import derive
from mechanics.extremes import CAUSES, Cause, Extremes, extremes
from mechanics.extremes.result import Figures
from mechanics.report.extremes import extremes_html, telling
from mechanics.report.extremes_map import LETTERS, heat_map, shade, strip, value_label
from mechanics.report.extremes_plot import heat_plot
from systems import rocker, two_mass_chain

pytestmark = pytest.mark.campaign


@cache
def walked(controlled: bool = False) -> Extremes:
    if controlled:
        equations = derive(rocker.controlled(), "kane")
        return extremes(
            equations, paths=(rocker.AT_CRITICAL_GAIN,), forms=("elimination",), paired=300
        )
    return extremes(derive(two_mass_chain.scene(), "kane"), name="two_mass_chain", paired=300)


def test_the_page_stands_alone_and_names_everything() -> None:
    found = (walked(), walked(controlled=True))
    page = extremes_html(found)
    assert not re.search(r"<script|https?://|@import", page)
    for one in found:
        assert one.system in page and all(form in page for form in one.forms)
    assert page.count('class="strip"') == 2 * sum(len(one.axes) for one in found)
    assert all(cause.value in page for cause in CAUSES if cause is not Cause.ACCURATE)
    assert "beside the critical one" in page and "Places worth a visit" in page
    ids = re.findall(r'id="([^"]+)"', page)
    assert len(ids) == len(set(ids))
    assert {ref for ref in re.findall(r'href="#([^"]+)"', page)} <= set(ids)


def pictures(found: Extremes) -> list[tuple[str, Figures, int]]:
    made = []
    for visited in found.visited:
        figures = visited.figure(found.default, "double")
        walk = visited.walk
        if walk.kind == "pair":
            text = heat_map("pair", walk.names, ("kg", "rad"), walk.values, figures)
            made.append((text, figures, len(walk)))
    return made


def test_a_cell_for_every_point_in_the_colour_of_its_cause() -> None:
    for text, figures, count in pictures(walked()):
        tree = ElementTree.fromstring(text)
        rects = [e for e in tree.iter("rect") if e.get("class") != "frame"]
        assert sum(round(float(e.get("width", 0)) / 14) for e in rects) == count
        assert {e.get("class") for e in rects} == {shade(figures, i) for i in range(count)}
        letters = "".join(e.text or "" for e in tree.iter("text") if "letter" in e.get("class", ""))
        told = [LETTERS.get(figures.cause(i), "") for i in range(count)]
        assert sorted(letters) == sorted("".join(told))


def test_a_strip_covers_every_decade_once() -> None:
    found = walked()
    for visited in found.visited:
        if visited.walk.kind == "line":
            text = strip("line", visited.walk.values[0], visited.figure(found.default, "double"))
            rects = [e for e in ElementTree.fromstring(text).iter("rect")][1:]
            ends = [(float(e.get("x")), float(e.get("width"))) for e in rects]
            for (x, width), (next_x, _) in pairwise(ends):
                assert x + width >= next_x - 0.11
            assert ends[0][0] <= 1


def test_the_maps_shown_are_different_and_tell_of_every_quantity_at_most_twice() -> None:
    found = walked(controlled=True)
    chosen = telling(found, 4)
    names = [name for visited in chosen for name in visited.walk.names]
    assert len({v.walk.names for v in chosen}) == len(chosen) == 4
    assert max(names.count(name) for name in names) <= 2


@pytest.mark.parametrize(
    ("value", "unit", "label"),
    [
        (0.0, "kg", "0"),
        (1e-12, "kg", '10<tspan class="power" dy="-.4em">−12</tspan>'),
        (1.5707963267948966, "rad", "π/2"),
        (1.5707963705062866, "rad", "π/2′"),
        (1.5707963267948966, "m", "1.57"),
    ],
)
def test_values_on_an_axis(value: float, unit: str, label: str) -> None:
    assert value_label(value, unit) == label


def test_the_plot_is_a_file_of_its_own() -> None:
    found = walked()
    text = heat_plot(found)
    root = ElementTree.fromstring(text)
    maps = [child for child in root if child.get("class") == "heat"]
    (pair,) = telling(found, 1)
    assert 1 <= len(maps) <= 2
    assert found.default in text and all(name in text for name in pair.walk.names)
    # Every colour that a map uses is explained.
    used = {rect.get("class") for one in maps for rect in one.iter() if rect.tag.endswith("rect")}
    key = {child.get("class") for child in root if child.tag.endswith("rect")}
    assert used - {"frame"} == key
    # Maps and key are below each other.
    bottom = max(float(one.get("y", 0)) + float(one.get("height", 0)) for one in maps)
    assert all(float(c.get("y", 0)) > bottom for c in root if c.tag.endswith("rect"))
