"""Every kind of page on paper: nothing is cut, nothing moves, no sheet is empty, ink is dark."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from chromium import look, printed

import mechanics
from mechanics.extremes import extremes
from mechanics.grading.group import grade_files
from mechanics.grading.page import group_html
from mechanics.report.answer.page import check_html
from mechanics.report.extremes import extremes_html
from mechanics.report.html import to_html
from mechanics.report.motion import motion_html
from mechanics.report.trade import trade_html
from mechanics.simulate.integrators import INTEGRATORS
from mechanics.trade import trade
from systems import elastic_pendulum, rod_pendulum, two_mass_chain

pytestmark = [pytest.mark.browser, pytest.mark.campaign]

PAPER = (Path(__file__).parent / "paper.js").read_text(encoding="utf-8")
WIDTH = 740
"""Of US Letter between the margins of a browser, in pixels."""
WRONG = (
    r"M\frac{L}{2}\ddot{x}\cos\theta + M\frac{L^2}{12}\ddot\theta"
    r" - M g\frac{L}{2}\sin\theta = 0"
)

derive = partial(mechanics.derive, route="kane")


def report(folder: Path) -> str:
    scenes = (rod_pendulum.scene(), elastic_pendulum.scene())
    return to_html([mechanics.crosscheck(s, mechanics.CrossCheck(motion=True)) for s in scenes])


def answer(folder: Path) -> str:
    return check_html(mechanics.check(elastic_pendulum.scene(), WRONG, notation="latex"))


def grades(folder: Path) -> str:
    for name, text in (("wrong", WRONG), ("right", WRONG.replace("12", "3").replace("- M", "+ M"))):
        (folder / f"{name}.tex").write_text(text, encoding="utf-8")
    return group_html(grade_files(elastic_pendulum.scene(), sorted(folder.glob("*.tex"))))


def traded(folder: Path) -> str:
    few = tuple(m for m in INTEGRATORS if m.name in ("SciPy DOP853", "C RK8"))
    equations = derive(rod_pendulum.scene())
    return trade_html(trade(equations, 1.0, target=(1e-3, 1e-6), members=few, derive=derive))


def walked(folder: Path) -> str:
    equations = derive(two_mass_chain.scene())
    return extremes_html([extremes(equations, name="two_mass_chain", paired=300)])


def moving(folder: Path) -> str:
    scene = rod_pendulum.scene()
    motion = mechanics.simulate(mechanics.compile(derive(scene)), 1.0, samples=41)
    return motion_html(scene, motion.columns, motion.units, motion.note)


@pytest.mark.sample(1)
@pytest.mark.parametrize("kind", [report, answer, grades, traded, walked, moving])
def test_a_page_on_paper(kind: Callable[[Path], str], tmp_path: Path) -> None:
    page = kind(tmp_path)
    found = look(page, tmp_path, WIDTH, False, PAPER).found
    assert found["heading"] > 0
    assert found["stuck"] == found["cut"] == found["outside"] == []
    assert found["moving"] == found["animated"] == 0
    assert found["still"] == found["strips"]
    # A reader whose screen is dark prints on white paper, too.
    sheets = printed(page, tmp_path, dark=True)
    assert all(sheet.texts for sheet in sheets)
    assert sum(sheet.light for sheet in sheets) < 0.1 * sum(sheet.texts for sheet in sheets)


def test_a_page_that_is_bad_on_paper_is_seen(tmp_path: Path) -> None:
    page = (
        "<!DOCTYPE html><h1>A page</h1><div class='moving' style='position: sticky'>x</div>"
        "<div style='overflow: auto; width: 90px'><p style='width: 200px'>cut</p></div>"
        "<p style='color: #eee'>faint</p><div style='break-before: page; height: 9px'></div>"
    )
    found = look(page, tmp_path, WIDTH, False, PAPER).found
    assert found["stuck"] and found["cut"] and found["moving"]
    first, last = printed(page, tmp_path, dark=True)
    assert first.texts > first.light > 0
    assert not last.texts
