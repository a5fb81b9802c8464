"""The report in a real browser: nothing overflows, nothing is fetched, the console is silent.

The page is shown in a frame of the width of a phone or of a desktop; a script of the test, outside
of the frame, measures it and writes what it found into the document that Chromium prints.
"""

import json
import os
import re
import shutil
import subprocess
from dataclasses import dataclass, replace
from html import escape, unescape
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest

from mechanics.equations import Line
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.page import check_html
from mechanics.report.html import to_html
from mechanics.report.result import RouteResult, SystemResult
from mechanics.routes.derivation import by_route, steps_of
from systems import elastic_pendulum, pendulum_chain

pytestmark = [pytest.mark.browser, pytest.mark.campaign]

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
MEASURE = (Path(__file__).parent / "measure.js").read_text(encoding="utf-8")
OPTIONS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-sync",
    "--disable-component-update",
    "--no-first-run",
    "--enable-logging=stderr",
    "--v=0",
    "--dump-dom",
    "--window-size=1400,1000",
    "--virtual-time-budget=20000",
    # Names of hosts lead nowhere; what the page asks for is seen all the same.
    "--host-resolver-rules=MAP * ~NOTFOUND",
)


@dataclass(frozen=True)
class Sight:
    """What Chromium found: measurements, and the lines of its console."""

    found: dict[str, Any]
    console: list[str]


def chromium() -> str:
    """Path of a browser; without one the test is skipped, except in CI, where it fails."""
    for name in NAMES:
        path = shutil.which(name)
        if path:
            return path
    if os.environ.get("MECHANICS_CI"):
        pytest.fail("Chromium is missing: install Debian's package chromium")
    pytest.skip("Chromium is not installed")


def look(page: str, folder: Path, width: int, dark: bool) -> Sight:
    """Show a page in a frame of that width and measure it."""
    wrapper = folder / "wrapper.html"
    wrapper.write_text(
        '<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,">'
        f'<pre id="found"></pre><script>{MEASURE}</script>'
        f'<iframe style="width:{width}px;height:900px;border:0" srcdoc="{escape(page)}"></iframe>',
        encoding="utf-8",
    )
    command = [
        chromium(),
        *OPTIONS,
        f"--user-data-dir={folder / 'profile'}",
        f"--blink-settings=preferredColorScheme={0 if dark else 1}",
        wrapper.as_uri(),
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)
    text = re.search(r'<pre id="found">(.*?)</pre>', done.stdout, re.DOTALL)
    assert text is not None, done.stderr[-2000:]
    console = [line for line in done.stderr.splitlines() if ":CONSOLE" in line]
    return Sight(json.loads(unescape(text[1])), console)


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
    sight = look(to_html([small, *derived]), tmp_path, width, dark)
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
    sight = look(to_html([result]), tmp_path, width, False)
    assert sight.found["wide"] == []
    assert sight.found["scroll"] <= sight.found["width"], sight.found["outside"]


@pytest.mark.sample(1)
@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
@pytest.mark.parametrize("width", [390, 1200])
def test_answer_in_a_browser(width: int, dark: bool, answered: Check, tmp_path: Path) -> None:
    sight = look(check_html(answered), tmp_path, width, dark)
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
    sight = look(page, tmp_path, 390, False)
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
