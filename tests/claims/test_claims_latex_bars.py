r"""Bars without ``\left`` and ``\right``: which opens and which closes."""

import pytest
from rod_statements import ROD

import mechanics
from mechanics.claims.latex.bars import CLOSING, OPENING, barred
from mechanics.errors import InputError
from mechanics.kernel import Verdict

SHOWN = (Verdict.PROVED, Verdict.CERTIFIED)
REST = r"\frac{3 u}{m l^2}"


def marked(text: str) -> str:
    return barred(text).replace(OPENING, "<").replace(CLOSING, ">")


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("x |y| + 1", "x <y> + 1"),
        ("|a|b|c|", "<a>b<c>"),
        ("|a + |b||", "<a + <b>>"),
        (r"\frac{|x|}{|y|}", r"\frac{<x>}{<y>}"),
        (r"-|\dot x|\dot x", r"-<\dot x>\dot x"),
        (r"\sin|x|^2", r"\sin<x>^2"),
        (r"\bigl|x\bigr|", r"\bigl<x\bigr>"),
        (r"\left|x\right|", r"\left|x\right|"),
        (r"x|_{t=0}", r"x|_{t=0}"),
        (r"|x = y|", r"|x = y|"),
        (r"{|x} y|", r"{|x} y|"),
        (r"\|x\|", r"\|x\|"),
    ],
)
def test_bars_pair(text: str, wanted: str) -> None:
    assert marked(text) == wanted


@pytest.mark.parametrize(
    "term",
    [
        r"\frac{3 g \sin\theta\,|\dot\theta|}{2 l |\dot\theta|}",
        r"\frac{3 g}{2 |l|}\sin\theta \cdot |-1|",
        r"\frac{3 g}{2 l}\sin\theta + |\theta||u| - |\theta u|",
        r"\frac{3 g}{2 l}\sin\theta + \lvert u\rvert - \bigl|{-u}\bigr|",
    ],
)
def test_bars_are_read_as_magnitudes(term: str) -> None:
    text = rf"\ddot\theta = {term} + {REST}"
    assert mechanics.check(ROD, text, blame=False).verdict in SHOWN


def test_a_magnitude_is_not_the_number_itself() -> None:
    text = rf"\ddot\theta = \frac{{3 g |\sin\theta|}}{{2 l}} + {REST}"
    assert mechanics.check(ROD, text, blame=False).verdict is Verdict.REFUTED


def test_a_single_bar_is_refused_where_it_stands() -> None:
    with pytest.raises(InputError, match=r"column 26: '\|_\{"):
        mechanics.check(ROD, r"\ddot\theta = g\sin\theta|_{\theta=0}", notation="latex")
