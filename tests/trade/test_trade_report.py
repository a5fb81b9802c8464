"""The report and the plot of a trade."""

import re
from itertools import pairwise
from xml.etree import ElementTree

import pytest

from mechanics.report.trade import powers, trade_html
from mechanics.report.trade_plot import (
    NARROW,
    WIDE,
    Size,
    curves,
    spaced,
    standalone,
    uncrossed,
    work_precision,
)
from mechanics.trade import Trade


@pytest.mark.campaign
def test_page_needs_no_network_and_runs_no_script(pendulum: Trade) -> None:
    page = trade_html(pendulum)
    assert "<script" not in page
    assert not re.search(r"(src|href)=\"(?!#|data:)", page)
    assert page.count("<svg") >= 3


@pytest.mark.campaign
@pytest.mark.parametrize("size", [WIDE, NARROW])
def test_plot_shows_every_choice_of_the_front_and_every_pick(pendulum: Trade, size: Size) -> None:
    drawn = ElementTree.fromstring(work_precision(pendulum, size))
    kinds = [node.get("class", "").split(" ")[0] for node in drawn.iter()]
    assert kinds.count("front") == 2 * len(pendulum.front)
    assert kinds.count("pick") == len(pendulum.recommendations)
    assert kinds.count("target") == len(pendulum.recommendations)
    assert kinds.count("line") == len(curves(pendulum))


@pytest.mark.campaign
@pytest.mark.parametrize("size", [WIDE, NARROW])
def test_everything_that_is_drawn_lies_inside(pendulum: Trade, size: Size) -> None:
    drawn = ElementTree.fromstring(work_precision(pendulum, size))
    for node in drawn.iter():
        for key, limit in (("cx", size.width), ("x", size.width), ("cy", size.height),
                           ("y", size.height)):  # fmt: skip
            if node.get(key) is not None:
                assert 0 <= float(node.get(key, "")) <= limit


@pytest.mark.campaign
def test_plot_stands_alone(pendulum: Trade) -> None:
    text = standalone(pendulum)
    drawn = ElementTree.fromstring(text)
    assert drawn.tag == "{http://www.w3.org/2000/svg}svg"
    assert "prefers-color-scheme: dark" in text


def test_names_beside_the_plot_keep_their_distance_and_order() -> None:
    wanted = [10.0, 11.0, 12.0, 80.0, 99.0, 99.5]
    heights = spaced(wanted, 15.0, 100.0)
    gaps = [b - a for a, b in pairwise(heights)]
    assert min(gaps) >= 15.0
    assert max(heights) <= 100.0
    assert spaced([10.0, 50.0], 15.0, 100.0) == [10.0, 50.0]


def test_lines_to_names_do_not_cross() -> None:
    """Ends of curves at one height, from left to right, as integrators that give up early have."""
    starts = [(10.0 * k, 50.0 + 3.0 * (k % 3)) for k in range(9)]
    heights, edge = [40.0 + 15.0 * k for k in range(9)], 100.0
    order = uncrossed(starts, heights, edge)
    assert sorted(order) == list(range(9))
    lines = [(*starts[start], height) for start, height in zip(order, heights, strict=True)]
    for (x, y, end), (other_x, other_y, other_end) in pairwise(lines):
        at = max(x, other_x)
        above = y + (at - x) / (edge - x) * (end - y)
        below = other_y + (at - other_x) / (edge - other_x) * (other_end - other_y)
        assert above <= below


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("tolerance 1e-07", "tolerance 10<sup>−7</sup>"),
        ("error 7.2e-06, 5 us", "error 7.2·10<sup>−6</sup>, 5 µs"),
        ("<b> -O3 RK8 case", "&lt;b&gt; -O3 RK8 case"),
    ],
)
def test_numbers_in_sentences_become_powers(text: str, expected: str) -> None:
    assert powers(text) == expected


@pytest.mark.campaign
def test_every_recommendation_is_on_the_page(pendulum: Trade) -> None:
    page = trade_html(pendulum)
    for pick in pendulum.recommendations:
        assert powers(pick.reason) in page
    assert pendulum.least is not None
    for row in pendulum.least.amplitudes:
        assert powers(row.words) in page
