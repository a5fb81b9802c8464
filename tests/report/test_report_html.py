"""What the page holds; how it looks in a browser is tested beside."""

import dataclasses
import os
import re
from html import unescape
from itertools import chain
from pathlib import Path
from types import ModuleType

import pytest
from html_nesting import Nesting
from markupsafe import escape
from sympy import Add, ImmutableMatrix, Symbol, sqrt

from mechanics.equations import Line
from mechanics.kernel import Finding, Verdict
from mechanics.report import typeset, words
from mechanics.report.html import to_html
from mechanics.report.line_breaks import fits
from mechanics.report.result import LedgerResult, ResidualResult, RouteResult, SystemResult
from mechanics.report.sections import residual_rows
from mechanics.routes.derivation import by_route, goal_of, steps_of
from systems import elastic_pendulum, pendulum_chain, rocker, rocker_ledger

GOLDEN = Path(__file__).parent / "golden" / "page.html"


def test_golden(small: SystemResult, monkeypatch: pytest.MonkeyPatch) -> None:
    """The page with LaTeX in place of MathML; MECHANICS_UPDATE_GOLDEN=1 writes it anew."""
    monkeypatch.setattr(typeset, "mathml", lambda source: f"<math>{escape(source)}</math>")
    page = to_html([small])
    if os.environ.get("MECHANICS_UPDATE_GOLDEN") == "1":
        GOLDEN.parent.mkdir(exist_ok=True)
        GOLDEN.write_text(page, encoding="utf-8")
    assert page == GOLDEN.read_text(encoding="utf-8")


def test_elements_are_nested_and_headings_skip_no_level(small: SystemResult) -> None:
    page = Nesting(to_html([small, small]))
    assert page.wrong == []
    assert page.stack == []
    steps = zip(page.headings, page.headings[1:], strict=False)
    assert page.headings[0] == 1
    assert all(below <= above + 1 for above, below in steps)


def test_nothing_is_fetched_and_nothing_runs(small: SystemResult) -> None:
    page = to_html([small])
    assert not re.search(r'(?:src|href|srcset|action)\s*=\s*(?!"#|"data:)', page)
    assert not re.search(r"url\(|@import|<script|https?:", page)


def test_every_verdict_is_a_word(small: SystemResult) -> None:
    page = to_html([small])
    for finding in [*small.findings, *(row.finding for row in small.published)]:
        assert re.search(rf"</span> {finding.verdict.name.lower()}</span>", page)
        assert finding.evidence in page


def test_names_are_escaped(small: SystemResult) -> None:
    page = to_html([small])
    assert "block &lt;on a spring&gt;" in page
    assert "<on a spring>" not in page


def test_the_overall_verdict(small: SystemResult) -> None:
    proved = Finding("a = b", Verdict.PROVED, "")
    good = dataclasses.replace(small, findings=(proved,), pairs={})
    assert "All 2 checks passed." in to_html([good])
    assert "Not all 7 checks passed." in to_html([good, small])
    assert "Nothing was checked" in to_html([])


def test_parts_that_a_result_lacks_are_left_out(small: SystemResult) -> None:
    bare = dataclasses.replace(
        small, routes={}, published=(), compiled=(), modes=(), motion=None, remarks=(), pairs={}
    )
    page = to_html([bare])
    for title in ("Derivations", "Published", "Reactions", "Compiled", "Modes", "A motion"):
        assert f"<h3>{title}" not in page
    assert "Other checks" in page


def test_residuals_stand_beside_each_other(small: SystemResult) -> None:
    measured = (
        ResidualResult("kane: equation (6), double", 1.5, 10),
        ResidualResult("free_body: equation (6), double", 2.5, 10),
        ResidualResult("all routes", 3.5, 10),
    )
    rows = residual_rows(dataclasses.replace(small, compiled=measured))
    assert [(row.statement, row.values) for row in rows] == [
        ("equation (6), double", [2.5, None, 1.5]),
        ("all routes", [3.5, 3.5, 3.5]),
    ]


def test_many_statements_that_are_shown_are_folded(small: SystemResult) -> None:
    many = tuple(Finding(f"a{i} = b", Verdict.PROVED, "") for i in range(13))
    doubt = Finding("c = d", Verdict.UNDECIDED, "an unknown function")
    page = to_html([dataclasses.replace(small, findings=(*many, doubt), pairs={})])
    assert page.index("an unknown function") < page.index("13 statements, all proved or certified")


def test_long_lines_are_folded_and_longer_ones_left_out() -> None:
    def line(terms: int) -> Line:
        return Line("a", Add(*(Symbol(f"b{i}") for i in range(terms))))

    assert "<details" not in typeset.equation(line(20))
    folded = typeset.equation(line(typeset.FOLDED))
    assert "<details" in folded
    assert f"{typeset.FOLDED} terms" in folded
    assert "too long to be read" in typeset.equation(line(typeset.TOO_LONG))


def test_sides_that_a_tag_names_are_no_equality() -> None:
    two = typeset.ledger_row("K, M", (Symbol("a"), Symbol("b")))
    assert [part.count("<mo") for part in two.split('<div class="eq">')[1:]] == [1, 1]
    assert typeset.ledger_row("(1)", (Symbol("a"), Symbol("b"))).count('<div class="eq">') == 1


def test_tags_that_are_letters_are_typeset() -> None:
    for text in ("lambda", "P", "x_C"):
        assert "<math" in typeset.tag(text)
    assert typeset.tag("(ii) final") == "(ii) final"


def test_names_in_prose_are_typeset() -> None:
    text = typeset.prose("rate of x_C with $\\omega$ <b>, free_body")
    assert text.count("<math") == 2
    assert "&lt;b&gt;, free_body" in text


def test_a_power_in_prose_is_raised() -> None:
    assert typeset.prose("chance of error below 2^-98") == (
        "chance of error below 2<sup>\N{MINUS SIGN}98</sup>"
    )


def test_ratios_and_durations() -> None:
    assert [words.ratio(value) for value in (None, 1.256, 4e15)] == ["", "1.26", "4.0e+15"]
    assert [words.duration(value) for value in (0.0042, 0.25, 0.9999, 12.34)] == [
        "4.2 ms",
        "250 ms",
        "1.0 s",
        "12.3 s",
    ]


@pytest.mark.parametrize(("bound", "power"), [(2.0**-100, "−100"), (1.1 * 2.0**-100, "−99")])
def test_a_printed_bound_is_a_bound(bound: float, power: str) -> None:
    finding = Finding("a = b", Verdict.CERTIFIED, "", bound)
    assert f"<sup>{power}</sup>" in words.bound(finding)


def test_what_does_not_stand_is_listed_first_and_linked(small: SystemResult) -> None:
    page = to_html([small, small])
    head = page.partition("</header>")[0]
    anchors = re.findall(r'<li><a href="#((?:row|others|pairs)-[\d-]+)"', head)
    wrong = [row for row in small.published if not row.finding.shown]
    wrong += [finding for finding in small.findings if not finding.shown]
    assert len(anchors) == 2 * len(wrong) > 0
    assert all(f'id="{anchor}"' in page for anchor in anchors)


def words_in_maths(page: str) -> set[str]:
    """Contents of letters and signs of MathML that are longer than one character."""
    parts = re.findall(r"<m(?:i|o|text)\b[^>]*>([^<]*)</m(?:i|o|text)>", page)
    return {text for part in parts if len(text := unescape(part)) > 1}


@pytest.mark.parametrize(
    "make",
    [
        rocker.scene,
        pytest.param(elastic_pendulum.scene, marks=pytest.mark.campaign),
        pytest.param(pendulum_chain.scene, marks=pytest.mark.campaign),
    ],
)
def test_no_maths_holds_a_backslash_or_a_word_that_is_no_symbol(make) -> None:
    scene = make()
    goal = goal_of([by_route("kane", scene)])
    routes = {}
    for name in ("free_body", "moving_point", "kane", "lagrange"):
        equations = by_route(name, scene)
        routes[name] = RouteResult(equations, 0.1, 1, steps=steps_of(equations, goal))
    published = tuple(
        LedgerResult(row, Finding(row.tag, Verdict.PROVED, "")) for row in rocker_ledger.PUBLISHED
    )
    result = SystemResult(scene.name, scene, routes, (), published, form=goal)
    page = to_html([result])
    assert words_in_maths(page) <= {"sin", "cos"}
    assert "\\" not in "".join(re.findall(r"<math.*?</math>", page))
    ids = re.findall(r' id="([^"]*)"', page)
    assert len(ids) == len(set(ids))
    assert set(re.findall(r'href="#([^"]*)"', page)) <= set(ids)


def test_a_term_lights_the_arrow_of_its_load() -> None:
    scene = rocker.scene()
    equations = by_route("free_body", scene)
    route = RouteResult(equations, 0.1, 1, steps=steps_of(equations))
    page = to_html([SystemResult(scene.name, scene, {"free_body": route}, ())])
    for name in ("T", "N", "f", "gravity"):
        assert f'<g class="of-{name} arrow' in page
        assert re.search(rf'<(span|mrow) class="of-{name}" tabindex="0">', page)
        assert f".terms .of-{name}:is(:hover, :focus)) .arrow.of-{name} {{" in page


@pytest.mark.parametrize("system", [rocker, elastic_pendulum])
def test_an_equation_that_fits_on_a_line_is_one_element(system: ModuleType) -> None:
    """A wider one is pieces, in a box that is called mathematics and says its LaTeX."""
    scene = system.scene()
    routes = [by_route(name, scene) for name in ("free_body", "moving_point", "kane", "lagrange")]
    goal = goal_of(routes)
    seen = []
    steps = chain.from_iterable(steps_of(equations, goal) for equations in routes)
    for line in chain.from_iterable(step.lines for step in steps):
        page = typeset.equation(line)
        latex = unescape(re.findall(r"<code>(.*?)</code>", page)[0])
        ((called, shown),) = re.findall(r'<div class="terms"(.*?)>(.*?)</div>', page)
        seen.append(fits(latex))
        assert (shown.count("<math") == 1) == seen[-1]
        assert called.startswith(f' role="math" aria-label="{escape(latex)}"') != seen[-1]
    assert seen.count(True) > seen.count(False) > 0


def test_a_wide_matrix_is_written_entry_by_entry() -> None:
    """A row of it would go beyond the page: the bicycle's."""
    x = Symbol("x")
    entry = sum(x**k for k in range(2, 22))
    wide = typeset.chain((ImmutableMatrix([[entry, 0], [0, x]]),))
    assert [f"row {i}, column {i}" in wide for i in (1, 2)] == [True, True]
    assert "row 1, column 2" not in wide
    assert "all others are 0" in wide
    assert "mtable" not in wide
    assert "mtable" in typeset.chain((ImmutableMatrix([[x, 0], [0, x]]),))


def test_what_may_scroll_is_reached_by_the_keyboard() -> None:
    x = Symbol("x")
    short = typeset.chain((x + 1,))
    root = sqrt(Add(*(Symbol(f"a_{k}") for k in range(30))))
    assert "tabindex" not in short
    wide = typeset.chain((x + 1 / root,))
    assert re.search(r'<div class="terms"[^>]* tabindex="0">', wide)
    # Paper does not scroll: the root alone is set smaller there.
    assert re.findall(r'class="wide" style="--letters: (\d+)"', wide) == [
        str(10 * 2 + 20 * 3 + 29 + 1)
    ]


def test_a_sum_of_no_terms_is_zero() -> None:
    """The momentum of a pulley without mass, in Atwood's machine."""
    line = typeset.equation(Line("p", ()))
    assert re.findall(r"<m[on][^>]*>([^<]*)<", line) == ["&#x0003D;", "0"]
