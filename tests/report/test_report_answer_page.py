"""The page of an answer: what it holds, and what hostile input does not become."""

import re
from dataclasses import replace
from xml.etree import ElementTree

import pytest
from html_nesting import Nesting

from mechanics.blame.result import Blame, Edit, Mistake, Repair
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.kernel import Finding, Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.formulas import Hand, equation, formula
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.page import check_html
from mechanics.report.answer.safe_mathml import safe_mathml
from mechanics.report.latex_items import terms
from mechanics.routes.derivation import steps_of
from systems import elastic_pendulum

LATEX = Hand("latex", None)
TEXT = Hand("text", Naming(Vocabulary(elastic_pendulum.scene())))


def marks(source: str, hand: Hand, *edits: Edit) -> list[tuple[str, str]]:
    """Class and text of everything that is marked in a statement."""
    page = str(equation(source, hand, edits)).replace("<wbr>", "")
    return [
        (str(e.get("class")), "".join(e.itertext()))
        for e in ElementTree.fromstring(page).iter()
        if e.get("class") in ("wrong", "right")
    ]


def wrong(source: str, written: str, right: str) -> Edit:
    at = source.index(written)
    return Edit(Mistake.TERM, written, right, (at, at + len(written)))


@pytest.mark.campaign
def test_elements_are_nested_and_headings_skip_no_level(answered: Check) -> None:
    page = Nesting(check_html(answered))
    assert page.wrong == []
    assert page.stack == []
    assert page.headings[0] == 1
    steps = zip(page.headings, page.headings[1:], strict=False)
    assert all(below <= above + 1 for above, below in steps)


def test_nothing_is_fetched_and_nothing_runs(answered: Check) -> None:
    page = check_html(answered)
    assert not re.search(r'(?:src|href|srcset|action)\s*=\s*(?!"#|"data:)', page)
    assert not re.search(r"url\(|@import|<script|https?:|javascript:", page)


@pytest.mark.campaign
def test_the_page_says_what_the_terminal_says(answered: Check) -> None:
    words = " ".join("".join(Nesting(check_html(answered)).words).split())
    for sentence in (
        "Not everything is right", "the factor is wrong", "the sign is reversed",
        "a term is missing", "or, a change as small", "the parallel axis is left out: pendulum",
        "Right if", "208 edits were tried", "pendulum: rate of angular momentum", "load gravity",
        "the only coordinate left", "is taken as defined by", "At this state", "they differ",
        "what: the scene has no such name", "numbers agree",
    ):  # fmt: skip
        assert sentence in words, sentence
    verdicts = [entry.finding.verdict.name.lower() for entry in answered.judged]
    cards = re.findall(r'<article class="statement (\w+)"', check_html(answered))
    assert cards == verdicts


def test_an_equation_of_matrices_stands_once_with_the_verdicts_of_its_rows(
    answered: Check,
) -> None:
    first, *_ = answered.judged
    rows = tuple(
        replace(first, statement=replace(first.statement, tag=f"(9) row {n}")) for n in (1, 2, 3)
    )
    page = check_html(replace(answered, judged=rows))
    assert Nesting(page).wrong == []
    assert page.count('<article class="statement') == 1
    assert page.count('<div class="eq">') < 3 + check_html(
        replace(answered, judged=(first,))
    ).count('<div class="eq">')
    assert [f"row {n}" in page for n in (1, 2, 3)] == [True] * 3


def test_long_statements_are_shown_once_and_other_changes_are_folded(answered: Check) -> None:
    source = " + ".join(f"a_{n} x" for n in range(30)) + " = 0"
    finding = answered.judged[0].finding
    repairs = tuple(Repair((wrong(source, f"a_{n}", "b"),), source, finding) for n in (3, 7))
    statement = replace(answered.judged[0].statement, source=source)
    entry = Judged(statement, finding, (), Blame((), repairs))
    page = check_html(replace(answered, judged=(entry,)))
    assert page.count("where that is") == 1


def test_the_derivation_stands_beside(answered: Check) -> None:
    page = check_html(answered)
    assert '<svg class="drawing"' in page
    assert "What follows from the scene" in page
    assert answered.derived is not None
    for step in steps_of(answered.derived)[:-1]:
        assert f"<h3>{step.title}</h3>" in page
    alone = check_html(replace(answered, derived=None))
    assert "step by step" not in alone


def test_it_says_how_many_equations_of_motion_there_are_to_give(answered: Check) -> None:
    one = check_html(replace(answered, judged=answered.judged[:1]))
    assert "1 of 2 equations of motion given." in one
    assert "equations of motion given" not in check_html(
        replace(answered, judged=answered.judged[:2])
    )


@pytest.mark.campaign
def test_the_summary_follows_the_verdict(answered: Check) -> None:
    (right, *_, numbers) = answered.judged
    assert "Everything is right" in check_html(replace(answered, judged=(right,)))
    assert "Nothing is refuted" in check_html(replace(answered, judged=(right, numbers)))
    assert "Nothing was checked" in check_html(replace(answered, judged=()))


def test_wrong_and_right_stand_inside_the_formula() -> None:
    source = r"M \frac{L^{2}}{12} \ddot{\theta} - \sin \theta = 0"
    found = marks(source, LATEX, wrong(source, "12", "3"), wrong(source, "-", "+"))
    assert found == [("wrong", "12"), ("right", "3"), ("wrong", "−"), ("right", "+")]
    found = marks(source, LATEX, wrong(source, r"\sin", r"\cos"))
    assert found == [("wrong", "sin"), ("right", "cos")]
    missing = Edit(Mistake.MISSING, "", "+ x", (len(source) - 4,) * 2)
    assert marks(source, LATEX, missing) == [("right", "+x")]


@pytest.mark.parametrize(
    ("written", "right", "found"),
    [
        ("12", "3", [("wrong", "12"), ("right", "3")]),
        ("-", "+", [("wrong", "−"), ("right", "+")]),
        ("cos", "sin", [("wrong", "cos"), ("right", "sin")]),
        ("cos(theta)", "sin(theta)", [("wrong", "cosθ"), ("right", "sinθ")]),
        ("L**2", "L", [("wrong", "L2"), ("right", "L")]),
        ("- k*x", "", [("wrong", "−kx")]),
        ("k*x", "", [("wrong", "kx")]),
        ("k*", "", [("wrong", "k")]),
        ("*theta''", "", [("wrong", "θ¨")]),
        ("- k*x", "+ k*x", [("wrong", "−kx"), ("right", "+kx")]),
    ],
)
def test_text_is_typeset_and_marked(written: str, right: str, found: list[tuple[str, str]]) -> None:
    source = "M*L**2/12*theta'' - k*x + M*x''*cos(theta) = 0"
    assert "<math" in equation(source, TEXT, [wrong(source, written, right)])
    assert marks(source, TEXT, wrong(source, written, right)) == found


@pytest.mark.parametrize("at", ["M*x'' - k*x", "M*x''", "M*x'' - k*x = L*(x + theta"])
def test_a_missing_term_stands_where_it_belongs(at: str) -> None:
    source = f"{at}{')' if '(' in at else ' = 0'}"
    missing = Edit(Mistake.MISSING, "", "+ 2*k/L", (len(at),) * 2)
    assert "<math" in equation(source, TEXT, [missing])
    assert marks(source, TEXT, missing) == [("right", "+2kL")]


def test_what_finds_no_place_in_the_formula_is_marked_in_the_source() -> None:
    source = "M*L/2*x'' = 0"
    edit = wrong(source, "*L/2", "*L/3")
    assert marks(source, TEXT, edit) == [("wrong", "*L/2"), ("right", "*L/3")]
    assert "<code>M" in equation(source, TEXT, [edit])
    assert "<code>" in equation("rate: x_ddot", Hand("code", None), ())


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("-2*k*x/(M+m)*x'", r"-\frac{2 k x}{M + m} \dot{x}"),
        ("-M*g*L/2*(1-cos(theta))", r"-\frac{M g L}{2} \left(1 - \cos \theta\right)"),
        ("1/2*M*theta'^2 + 0.5*k*x*2", r"\frac{1}{2} M \dot{\theta}^{2} + 0.5 k x \cdot 2"),
        ("cos(x+1)^2*-3", r"\cos^{2} \left(x + 1\right) \left(-3\right)"),
        ("sqrt(k/M) + x**(1/2)", r"\sqrt{\frac{k}{M}} + \sqrt{x}"),
        ("(x+1)**3 - (M - m)", r"\left(x + 1\right)^{3} - \left(M - m\right)"),
        ("1/x", r"\frac{1}{x}"),
        ("M*len*x", r"M \, \mathrm{len} \, x"),
        ("x/3/k", r"\frac{x}{3 k}"),
        ("atan2(x, L)", r"\operatorname{atan2} \left(x, L\right)"),
        ("diff(x*theta, t)", r"\frac{d}{dt} \left(x \theta\right)"),
        ("[M, 1; 2, 3]", r"\begin{bmatrix}M & 1 \\ 2 & 3\end{bmatrix}"),
    ],
)
def test_text_in_latex(text: str, latex: str) -> None:
    assert TEXT.latex(text) == latex
    assert "<math" in formula(text, TEXT)


@pytest.mark.parametrize(
    ("latex", "parts"),
    [
        ("a+b=c", ["a", "+ b", "= c"]),
        ("-a-b", ["-a", "- b"]),
        (r"a=-b", ["a", "= {-b}"]),
        (r"x^{-2}+\left(y-z\right]", ["x^{-2}", r"+ \left(y-z\right]"]),
        (r"\begin{pmatrix}a-b & c\end{pmatrix}=d", [r"\begin{pmatrix}a-b & c\end{pmatrix}", "= d"]),
        (r"\frac{a-b}{2}-c", [r"\frac{a-b}{2}", "- c"]),
    ],
)
def test_latex_breaks_between_terms_only(latex: str, parts: list[str]) -> None:
    assert terms(latex) == parts


@pytest.mark.parametrize(
    "hostile",
    [
        r"\href{javascript:alert(1)}{x}",
        r"\text{<script>alert(1)</script>}",
        r"\text{<img src=x onerror=alert(1)>}",
        r"\class{x}{y} \style{position:fixed}{z}",
        r"\text{</math><script>alert(1)</script>}",
        r"\text{&lt;script&gt;}",
        r"\includegraphics{http://example.org/a.png}",
        "\x1b[31m x^{2}",
        r"\frac{", r"\left(", "^{^{^{", "}" * 50, r"\begin{matrix}",
    ],
)  # fmt: skip
def test_hostile_latex_becomes_neither_link_nor_element(hostile: str) -> None:
    shown = str(equation(hostile, LATEX, ())) + str(formula(hostile, LATEX))
    page = Nesting(shown)
    assert page.wrong == []
    assert all(re.fullmatch("math|m[a-z]+|div|p|code", tag) for tag in page.tags)
    assert page.classes <= {"eq", "terms", "typed"}
    assert page.attributes <= {"class", "displaystyle", "width", "form", "stretchy", "fence"}
    assert "\x1b" not in shown


@pytest.mark.parametrize("name", ["pmatrix", "bmatrix", "matrix"])
def test_matrices_are_typeset_and_marked(name: str) -> None:
    source = rf"\begin{{{name}}} M+m & L \\ L & 12 \end{{{name}}} = x \tag{{6}}"
    assert "<mtable" in equation(source, LATEX, [])
    assert marks(source, LATEX, wrong(source, "12", "3")) == [("wrong", "12"), ("right", "3")]
    early = equation(source, LATEX, [wrong(source, "M", "m")])
    assert early.count("<mtd>") == 4


def test_mathml_keeps_what_it_needs() -> None:
    assert safe_mathml(r"\left[ \ddot{x} \right]") is not None
    assert safe_mathml(r"\nosuchcommand{x}") is None
    assert 'class="wrong"' in str(safe_mathml(r"\class{wrong}{x}"))
    assert "class" not in str(safe_mathml(r"\class{chip}{x}"))


def test_hostile_words_are_escaped_everywhere(answered: Check) -> None:
    evil = "<b onclick=x>&"
    entry = answered.judged[1]
    edit = Edit(Mistake.TERM, evil, evil, None)
    done = Finding("", Verdict.PROVED, evil)
    blame = Blame((), (Repair((edit,), evil, done),), (evil,), evil)
    statement = replace(entry.statement, source=evil, tag=evil, notes=(evil,), place=evil)
    hostile = replace(entry, statement=statement, blame=blame, right_if=(evil,))
    page = check_html(
        replace(answered, judged=(hostile,), names=(Match(evil, "x", evil),), remarks=(evil,))
    )
    assert "<b " not in page
    assert "&lt;b onclick=x&gt;&amp;" in page
