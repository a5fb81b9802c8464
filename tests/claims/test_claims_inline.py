"""Equations in prose are read beside those that are displayed; values in prose are no claims."""

import time

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
RAIL = r"(m_c + m_p) \ddot x = F - m_p l (\ddot\theta \cos\theta - \dot\theta^2 \sin\theta)"
SHOWN = rf"\[ {RAIL} \]"


def verdicts(text: str, **options) -> list[str]:
    found = mechanics.check(CART, text, notation="latex", blame=False, **options)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.parametrize(
    "prose",
    [
        rf"Newton gives {SHOWN} and ${RAIL.replace('F', '2 F')}$.",
        rf"Newton gives {SHOWN} and \({RAIL.replace('F', '2 F')}\).",
        rf"Newton gives {SHOWN}" "\nand % as $x$ says\n" rf"${RAIL.replace('F', '2 F')}\,.$",
    ],
)
def test_an_equation_in_prose_is_judged(prose: str) -> None:
    assert verdicts(prose) == ["PROVED", "REFUTED"]
    assert verdicts(prose.replace("2 F", "F")) == ["PROVED", "PROVED"]


@pytest.mark.parametrize(
    "prose",
    [
        r"With $M = m_c + m_p$ one has {} .",
        r"One has {} , where \(M = m_c + m_p\) is the mass.",
        r"We write $\mu = m_c$. {} Here $M = \mu + m_p$.",
    ],
)
def test_a_definition_in_prose_holds(prose: str) -> None:
    shown = SHOWN.replace("(m_c + m_p)", "M")
    assert verdicts(prose.format(shown)) == ["PROVED"]
    assert verdicts(prose.format(shown).replace("+ m_p$", "- m_p$")
                    .replace(r"+ m_p\)", r"- m_p\)")) == ["REFUTED"]  # fmt: skip


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    "formula",
    [
        "x", r"\theta > 0", r"\theta", r"\sin\theta \approx \theta", r"l \ll 1",
        r"m_p = 2\,\mathrm{kg}", r"l = 0.5~\text{m}", r"g = 9.81\,\mathrm{m}\,\mathrm{s}^{-2}",
        r"F = 3 \cdot 10^{-2}\,\mathrm{N}", r"\theta_0 = 30^\circ", "g = 9.81", r"\theta = 0",
        r"\theta = \pi", r"\dot\theta = 0", "x(0) = 0.1", r"\theta(0) = \theta_0", "i = 1, 2",
        r"q = (x, \theta)", r"\mathbf{q} = [x, \theta]^\top", r"q=\left[x,\theta\right]^T",
        "m_c = m_p",
    ],
)  # fmt: skip
def test_what_prose_mentions_is_no_claim(formula: str) -> None:
    assert verdicts(f"Take ${formula}$ in {SHOWN} as usual.") == ["PROVED"]
    # Beside another formula in prose, where nothing is displayed, too.
    assert verdicts(f"Take ${formula}$ in the equation ${RAIL}$ as usual.") == ["PROVED"]


def test_values_that_are_not_used_are_told() -> None:
    found = mechanics.check(CART, r"Take $m_p = 2\,\mathrm{kg}$." "\n" + SHOWN, blame=False)
    assert any("line 1: m_p = 2" in remark and "not used" in remark for remark in found.remarks)


def test_an_equation_in_prose_that_cannot_be_read_leaves_a_doubt() -> None:
    found = mechanics.check(CART, rf"{SHOWN} and $\sum F = \oint x$", blame=False)
    assert not found.ok
    assert "line 1, column" in found.judged[1].finding.evidence


def test_a_display_without_an_end_leaves_a_doubt() -> None:
    assert verdicts(rf"{SHOWN} \begin{{align}} {RAIL}") == ["PROVED", "UNDECIDED"]
    # Alone, it is what there is.
    assert verdicts(rf"\begin{{align}} {RAIL}") == ["PROVED"]


@pytest.mark.parametrize("environment", ["alignat", "alignat*", "math", "IEEEeqnarray"])
def test_other_displays_are_read(environment: str) -> None:
    columns = "" if environment == "math" else "{2}"
    begin, end = rf"\begin{{{environment}}}{columns}", rf"\end{{{environment}}}"
    text = f"{SHOWN} {begin} {RAIL.replace('F', '2 F')} {end}"
    assert verdicts(text) == ["PROVED", "REFUTED"]


def test_a_price_in_dollars_hides_no_equation() -> None:
    text = rf"It costs $5." "\n\n" rf"We have ${RAIL.replace('F', '2 F')}$ and {SHOWN}"
    assert verdicts(text) == ["REFUTED", "PROVED"]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "piece", ["$", "$a", r"\(", r"\(a\)", "$ ", "{", r"\boxed{", "%", "$\n", r"\["]
)
def test_long_documents_are_read_in_linear_time(piece: str) -> None:
    start = time.process_time()
    try:
        mechanics.check(CART, piece * (90_000 // len(piece)), notation="latex", blame=False)
    except mechanics.MechanicsError as error:
        assert len(str(error).splitlines()) == 1
    assert time.process_time() - start < 4


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "stray",
    [
        r"\ddot x = 0",
        r"\begin{bmatrix} \ddot x \\ 0 \end{bmatrix} = \begin{bmatrix} 1 \\ 0 \end{bmatrix}",
        r"\begin{strange} m \frac{d v}{dt} = F \end{strange}",
        r"and so I x'' = 0",
        r"\ensuremath{x'' = F}",
    ],
)
def test_an_equation_outside_of_every_formula_is_told(stray: str) -> None:
    r"""TeX would stop there; a person has forgotten \[, or has an environment of their own."""
    text = r"We have $\ddot x = F$ and with it" + "\n\n" + stray + "\n\nas before."
    found = mechanics.check(cartpole.scene(), text, notation="latex", blame=False)
    (entry,) = [entry for entry in found.judged if "outside" in entry.statement.doubt]
    assert entry.finding.verdict.name == "UNDECIDED"
    assert "line 3, column" in entry.statement.doubt


def test_prose_with_commands_and_without_an_equation_is_passed_over() -> None:
    text = r"Of \textbf{all} parts, \sin. We have $\ddot x = \dot\theta^2$."
    found = mechanics.check(cartpole.scene(), text, notation="latex", blame=False)
    assert len(found.judged) == 1


@pytest.mark.parametrize("beside", [r"\be m_c x^2 = 0 \ee", r"\beq M \alpha = 0 \eeq"])
def test_what_only_a_formula_can_hold_is_no_prose(beside: str) -> None:
    # Who defines such a command may hide with it what stands beside.
    assert verdicts(SHOWN + "\n" + beside) == ["UNDECIDED", "UNDECIDED"]


@pytest.mark.parametrize("words", [r"\mbox{and $\ddot x = 0$}", r"\text{ and \(\ddot x = 0\)}"])
def test_an_equation_in_the_words_of_a_display_is_told(words: str) -> None:
    assert verdicts(rf"\[ {RAIL} {words} \]") == ["PROVED", "UNDECIDED"]
    assert verdicts(rf"\[ {RAIL} \text{{ for all $\theta$}} \]") == ["PROVED"]


@pytest.mark.parametrize(
    "text", [r"Then $\ddot x$ = $F/m_c$.", r"\[ \ddot x \approx F \]", r"\[ x'' \ge F \]"]
)
def test_what_is_no_equation_of_one_formula_is_told(text: str) -> None:
    right = r"\[ (m_c+m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = F \]"
    found = mechanics.check(cartpole.scene(), f"{right} {text}", notation="latex", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "UNDECIDED"]


def test_unless_is_refused() -> None:
    text = r"\[ \ddot x = \dot x \] \unless\iffalse \[ x = 1 \] \fi"
    with pytest.raises(mechanics.MechanicsError, match="unless"):
        mechanics.check(cartpole.scene(), text, notation="latex", blame=False)


@pytest.mark.parametrize(("factor", "verdict"), [("1{,}0", "PROVED"), ("1{,}5", "REFUTED")])
def test_a_comma_in_braces_is_that_of_a_decimal(factor: str, verdict: str) -> None:
    assert verdicts(SHOWN.replace("= F", f"= {factor} F")) == [verdict]


def test_a_comma_before_three_digits_may_be_that_of_thousands() -> None:
    with pytest.raises(mechanics.MechanicsError, match="column"):
        verdicts(SHOWN.replace("= F", "= 1{,}000 F"))
