"""The report in a real browser: nothing overflows, nothing is fetched, the console is silent.

The frame has the width of a phone or of a desktop.
"""

import shutil
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import pytest
from chromium import Sight, chromium, look

from mechanics.equations import Line
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.page import check_html
from mechanics.report.html import to_html
from mechanics.report.result import RouteResult, SystemResult
from mechanics.routes.derivation import by_route, steps_of
from systems import elastic_pendulum, pendulum_chain

pytestmark = [pytest.mark.browser, pytest.mark.campaign]

MEASURE = (Path(__file__).parent / "measure.js").read_text(encoding="utf-8")


def seen(page: str, folder: Path, width: int, dark: bool) -> Sight:
    """A page in a frame of that width."""
    return look(page, folder, width, dark, MEASURE)


@pytest.fixture(scope="module")
def derived() -> list[SystemResult]:
    """Real derivations: a short one, and one whose lines are far wider than a phone."""
    results = []
    for scene in (elastic_pendulum.scene(), pendulum_chain.scene(4)):
        equations = by_route("free_body", scene)
        long = replace(
            equations.result,
            title="Without a place to break a line",
            lines=(
                Line(r"\left(" + " + ".join(["x_{long}"] * 60) + r"\right)", equations.forcing[0]),
                *(Line(symbol, value) for symbol, value in equations.reactions),
            ),
        )
        route = RouteResult(equations, 0.1, 999, steps=(*steps_of(equations), long))
        results.append(SystemResult(scene.name, scene, {"free_body": route}, ()))
    return results


@pytest.mark.sample(1)
@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
@pytest.mark.parametrize("width", [390, 1100, 1280])
def test_report_in_a_browser(
    width: int, dark: bool, small: SystemResult, derived: list[SystemResult], tmp_path: Path
) -> None:
    sight = seen(to_html([small, *derived]), tmp_path, width, dark)
    found = sight.found
    assert sight.console == []
    assert found["fetched"] == []
    assert found["dark"] is dark
    assert found["scroll"] <= found["width"], found["outside"]
    assert found["outside"] == []
    assert found["faint"] == []
    assert found["maths"] > 100
    assert found["height"] > 3000


@pytest.mark.parametrize("width", [390, 1100])
def test_six_columns_of_routes_are_seen_whole(
    width: int, small: SystemResult, tmp_path: Path
) -> None:
    one = next(iter(small.routes.values()))
    names = ("free_body", "moving_point", "kane", "kane_sympy", "lagrange", "lagrange_sympy")
    finding = next(f for f in small.pairs.values() if f.verdict is Verdict.CERTIFIED)
    result = replace(
        small, routes=dict.fromkeys(names, one), sympy={},
        pairs=dict.fromkeys(combinations(names, 2), finding),
    )  # fmt: skip
    sight = seen(to_html([result]), tmp_path, width, False)
    assert sight.found["wide"] == []
    assert sight.found["scroll"] <= sight.found["width"], sight.found["outside"]


@pytest.mark.sample(1)
@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
@pytest.mark.parametrize("width", [390, 1200])
def test_answer_in_a_browser(width: int, dark: bool, answered: Check, tmp_path: Path) -> None:
    sight = seen(check_html(answered), tmp_path, width, dark)
    found = sight.found
    assert sight.console == []
    assert found["fetched"] == []
    assert found["dark"] is dark
    assert found["scroll"] <= found["width"], found["outside"]
    assert found["outside"] == []
    assert found["faint"] == []
    assert found["maths"] > 80
    assert found["wide"] == []
    assert found["marked"] >= 6


def test_a_bad_page_is_seen(tmp_path: Path) -> None:
    page = (
        '<!DOCTYPE html><p style="width:900px;color:#aaa;background:#fff">wide and faint</p>'
        '<div style="width:90px"><table style="width:200px"><tr><td>x</td></tr></table></div>'
        '<img src="https://example.org/a.png"><script>console.log("noise")</script>'
    )
    sight = seen(page, tmp_path, 390, False)
    assert sight.found["scroll"] > sight.found["width"]
    assert sight.found["outside"] != []
    assert sight.found["wide"] != []
    assert sight.found["faint"] != []
    assert sight.found["fetched"] == ["https://example.org/a.png"]
    assert any("noise" in line for line in sight.console)


def test_without_chromium_ci_fails_and_others_skip(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: None)
    monkeypatch.setenv("MECHANICS_CI", "1")
    with pytest.raises(pytest.fail.Exception, match="Chromium is missing"):
        chromium()
    monkeypatch.delenv("MECHANICS_CI")
    with pytest.raises(pytest.skip.Exception, match="not installed"):
        chromium()
