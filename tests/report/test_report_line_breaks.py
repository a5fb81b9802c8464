r"""Where LaTeX may break on a page: nothing is lost, nothing wide stays whole, nothing hangs."""

import re
from time import process_time

import pytest
from markupsafe import Markup

from mechanics.report.answer.safe_mathml import safe_mathml
from mechanics.report.latex_items import width
from mechanics.report.line_breaks import WIDEST, broken
from mechanics.report.notation import mathml

LONG = " + ".join(rf"m_{{{n}}} l \ddot{{\theta}}_{{{n}}}" for n in range(1, 8))


def letters(page: str) -> str:
    """What a reader sees, without spaces."""
    return "".join(re.sub(r"<[^>]*>", "", page).split())


def texts(latex: str) -> list[str]:
    """The pieces that are typeset one by one."""
    found: list[str] = []

    def keep(piece: str) -> Markup:
        found.append(piece)
        return Markup(mathml(piece))

    assert broken(latex, keep) is not None
    return found


@pytest.mark.parametrize(
    "latex",
    [
        rf"x = \frac{{{LONG}}}{{m}}",
        rf"x = -\frac{{a}}{{{LONG}}} \cos \theta",
        rf"A \left(-{LONG}\right)^{{2}} \sin \theta",
        rf"A \left(\frac{{{LONG}}}{{2}} + b\right) \sin \left({LONG}\right)",
        rf"{{\class{{wrong}}{{{LONG}}}\class{{right}}{{{LONG} + c}}}} x = 0",
    ],
)
def test_wide_formulas_are_cut_and_nothing_is_lost(latex: str) -> None:
    assert all(width(piece) <= WIDEST for piece in texts(latex))
    shown = broken(latex, safe_mathml)
    assert shown is not None
    assert letters(shown).count("m") == latex.count("m_") + (r"{m}" in latex)


def test_fractions_stay_fractions_and_narrow_ones_stay_mathml() -> None:
    assert 'class="fraction"' in str(broken(rf"\frac{{{LONG}}}{{m}}", safe_mathml))
    assert texts(rf"\frac{{a + b}}{{c}} + {LONG}")[0] == r"\frac{a + b}{c}"


def test_what_fits_on_one_line_is_one_element() -> None:
    assert texts(r"\frac{a + b}{c} + d = 0") == [r"\frac{a + b}{c} + d = 0"]


def test_what_belongs_together_is_not_cut() -> None:
    for latex in (
        rf"\sqrt{{ ({LONG}) }}",
        rf"e^{{ ({LONG}) }}",
        rf"\begin{{bmatrix}} {LONG} \end{{bmatrix}}",
    ):
        assert len(texts(latex)) == 1
    assert texts(rf"\sin \left({LONG}\right)")[0].startswith(r"\sin \bigl( m_{1}")


def test_a_line_may_end_before_a_wrong_sign() -> None:
    latex = rf"x = a \class{{wrong}}{{+}}\class{{right}}{{-}} b + {LONG}"
    assert texts(latex)[:3] == ["x", "= a", r"\class{wrong}{+}\class{right}{-} b"]


@pytest.mark.parametrize(
    "hostile", ["(" * 4000, "{" * 4000 + "}" * 4000, r"\frac" * 3000, r"\left" * 3000, "x" * 30000]
)
def test_what_cannot_be_read_takes_no_time(hostile: str) -> None:
    start = process_time()
    broken(hostile, lambda piece: Markup("{}").format(piece))
    assert process_time() - start < 2
