"""Equations side by side, broken over lines, numbered, framed: as displays are written."""

import contextlib
import time

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
POLE = r"\tfrac43 l\ddot\theta + \ddot x\cos\theta &= g\sin\theta"
RAIL = r"(m_c+m_p)\ddot x + m_p l\ddot\theta\cos\theta &= F + m_p l\dot\theta^2\sin\theta"
LEFT = r"(m_c+m_p)\ddot x + m_p l\ddot\theta\cos\theta"
REST = r"m_p l\dot\theta^2\sin\theta"


def verdicts(text: str) -> list[str]:
    try:
        found = mechanics.check(CART, text, notation="latex", blame=False)
    except InputError:
        return ["UNDECIDED"]
    return [entry.finding.verdict.name for entry in found.judged]


def display(text: str, name: str = "align") -> str:
    return f"\\begin{{{name}}}\n{text}\n\\end{{{name}}}"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "between",
    [" & ", " && ", r" &\quad ", r" &\qquad ", r", & ", r" & \text{and} & ", r" & \hspace{1cm} "],
)
@pytest.mark.parametrize("name", ["align", "aligned", "flalign*"])
def test_equations_side_by_side_are_two(between: str, name: str) -> None:
    text = display(f"{POLE}{between}{RAIL} \\nonumber\\\\[2pt]", name)
    assert verdicts(text) == ["PROVED", "PROVED"]
    assert verdicts(text.replace("= F +", "= F -")) == ["PROVED", "REFUTED"]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "space", [r"\quad", r"\qquad", r"\quad\quad", r"\;\;\;", r"\ \ ", r"\hspace{3em}", "~~~"]
)
def test_equations_with_a_wide_space_between_are_two(space: str) -> None:
    text = rf"\[ {POLE} {space} {RAIL} \]".replace("&", "")
    assert verdicts(text) == ["PROVED", "PROVED"]
    assert verdicts(text.replace("= g", "= -g")) == ["REFUTED", "PROVED"]


def test_an_equation_beside_another_may_begin_with_a_minus() -> None:
    text = rf"\[ {POLE} \qquad -F + {LEFT} - {REST} = 0 \]".replace("&", "")
    assert verdicts(text) == ["PROVED", "PROVED"]
    assert verdicts(text.replace("-F", "F")) == ["PROVED", "REFUTED"]


def test_zero_on_the_left_twice_is_no_chain() -> None:
    text = rf"0 &= {POLE.replace('&=', '- (')}) & 0 &= {RAIL.replace('&=', '- (')})"
    assert verdicts(display(text)) == ["PROVED", "PROVED"]


@pytest.mark.parametrize(
    "text",
    [
        rf"{LEFT} \quad = \quad F \quad + \quad {REST}",
        rf"{LEFT} &=& F + {REST}",
        rf"{LEFT} &= F + {REST} &= F \quad + {REST}",
        rf"(m_c+m_p)\ddot x &+{{}}& m_p l\ddot\theta\cos\theta &= F + {REST}",
    ],
)
def test_marks_beside_a_sign_set_nothing_apart(text: str) -> None:
    assert verdicts(display(text)) == ["PROVED"]


@pytest.mark.parametrize(
    "text",
    [
        rf"{LEFT} = F \quad {REST}",
        rf"a = {LEFT} \quad +b = F",
        rf"{LEFT} = F \quad l \quad x = 0",
        rf"{LEFT} \\ ({REST}) = F",
        rf"{LEFT} = F + m_p l \\ \dot\theta^2\sin\theta",
    ],
)
def test_what_can_be_read_in_two_ways_is_in_doubt(text: str) -> None:
    assert set(verdicts(display(text))) == {"UNDECIDED"}


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["multline", "multline*", "split", "align", "gather", "dmath"])
@pytest.mark.parametrize(
    "text",
    [
        rf"{LEFT} \\ - {REST} = F",
        rf"{LEFT} \nonumber \\[2pt] &\quad - {REST} = F",
        rf"{LEFT} \notag \\* & {{}} - {REST} = F",
        rf"{LEFT} - {{}} & \\ {REST} & = F",
        rf"{LEFT} - {REST} \\ = F",
        r"(m_c+m_p)\ddot x + m_p l \\ \times(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = F",
        r"(m_c+m_p)\ddot x + m_p l \Bigl[ & \ddot\theta\cos\theta \\ & - \dot\theta^2"
        r"\sin\theta \Bigr] = F",
        r"(m_c+m_p)\ddot x + m_p l \left[ \ddot\theta\cos\theta \right. \\ & \quad \left. -"
        r"\dot\theta^2\sin\theta \right] = F",
        r"(m_c+m_p)\ddot x + m_p l \left[ \ddot\theta\cos\theta \right. \\ & \quad - \left. "
        r"\dot\theta^2\sin\theta \right] = F",
    ],
)
def test_an_equation_broken_before_its_relation_is_one(name: str, text: str) -> None:
    shown = display(text, name)
    assert verdicts(shown) == ["PROVED"]
    assert verdicts(shown.replace("= F", "= 2 F")) == ["REFUTED"]
    both = display(rf"{POLE} \\ {text} \\ {POLE}", name)
    if not name.startswith(("multline", "dmath")):
        assert verdicts(both) == ["PROVED"] * 3


def test_a_product_goes_on_in_one_equation_of_many_lines() -> None:
    text = r"(m_c+m_p)\ddot x + m_p l \\ (\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = F"
    assert verdicts(display(text, "multline")) == ["PROVED"]


def test_a_line_that_begins_with_a_minus_may_be_another_equation() -> None:
    text = display(rf"{POLE} \\[4pt] -F + {LEFT} - {REST} &= 0")
    assert verdicts(text) == ["PROVED", "PROVED"]


def test_a_bracket_behind_the_end_of_a_line_is_no_length() -> None:
    text = display(rf"{POLE} \\ [m_c+m_p] \ddot x + m_p l\ddot\theta\cos\theta - {REST} &= F")
    assert verdicts(text) == ["PROVED", "PROVED"]


@pytest.mark.parametrize(
    "number", [r"\qquad (6)", r"\quad (3.12)", "& (6a)", "   (A.6)", r", (6')"]
)
def test_a_number_at_the_end_is_no_factor(number: str) -> None:
    found = mechanics.check(CART, rf"{LEFT} - {REST} = F {number}", notation="latex", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"]
    assert found.judged[0].statement.tag.strip("()") in number


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("begin", "end"),
    [
        (r"\left\{\begin{aligned}", r"\end{aligned}\right."),
        (r"\left\{\begin{array}{rcl}", r"\end{array}\right."),
        (r"\left.\begin{array}{l}", r"\end{array}\right\}"),
        (r"\begin{array}{rl}", r"\end{array}"),
        (r"\begin{aligned}[t]", r"\end{aligned}"),
        (r"\begin{cases}", r"\end{cases}"),
    ],
)
def test_a_system_with_a_brace_is_its_equations(begin: str, end: str) -> None:
    text = rf"\[ {begin} {POLE} \\ {RAIL} {end} \]"
    assert verdicts(text) == ["PROVED", "PROVED"]
    assert verdicts(text.replace("= F +", "= F -")) == ["PROVED", "REFUTED"]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "piece",
    [r"(a & ", r"\left( a \right. ", r"\right." + " " * 50, r"\left\{ ", r"\\ & ", "( & ) "],
)
def test_long_documents_are_unframed_in_linear_time(piece: str) -> None:
    for length in (14_000, 90_000):
        start = time.process_time()
        with contextlib.suppress(InputError):
            mechanics.check(CART, r"\[ " + piece * (length // len(piece)), notation="latex")
        assert time.process_time() - start < 4


def bare(text: str) -> str:
    return text.replace("&", "")


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "end", ["\n", "\n\n", "\\tag{1}\n\n", " \\eqno(3)\n", "\\cdots(1)\n", ",\n"]
)
def test_lines_of_a_bare_text_are_equations(end: str) -> None:
    text = bare(f"{POLE}{end}{RAIL}{end}- F + {LEFT} - {REST} = 0")
    assert verdicts(text) == ["PROVED"] * 3
    assert verdicts(text.replace("= g", "= -g")) == ["REFUTED", "PROVED", "PROVED"]


@pytest.mark.parametrize(
    "text",
    [
        LEFT + "\n = F\n + " + REST,
        LEFT + " = F +\n" + REST,
        LEFT + "\n - " + REST + " = F",
        "(m_c+m_p)\\ddot x + m_p l\n\\ddot\\theta\\cos\\theta = F + " + REST,
    ],
)
def test_an_equation_of_a_bare_text_goes_on_over_lines(text: str) -> None:
    assert verdicts(text) == ["PROVED"]
    assert verdicts(f"{bare(POLE)}\n\n{text}\n{bare(POLE)}") == ["PROVED"] * 3


def test_a_line_of_a_bare_text_that_begins_with_a_factor_is_in_doubt() -> None:
    assert verdicts(f"{bare(POLE)}\n{LEFT}\n = F + {REST}") == ["UNDECIDED"]
    assert verdicts(f"{LEFT} = F + m_p l\n\\dot\\theta^2\\sin\\theta") == ["UNDECIDED"]


@pytest.mark.parametrize(
    "label",
    [r"(1)\quad ", r"(1):\quad ", "x: ", r"\text{cart: }", r"\rightarrow ", r"\therefore\quad "],
)
def test_what_stands_before_an_equation_is_its_label(label: str) -> None:
    assert verdicts(rf"\[ {label} {bare(RAIL)} \]") == ["PROVED"]
    assert verdicts(rf"\[ {label} {bare(RAIL).replace('F', '2 F')} \]") == ["REFUTED"]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "text",
    [
        r"(m_c+m_p)&\ddot x + m_p l\cos\theta&\ddot\theta &= F + m_p l\dot\theta^2\sin\theta",
        r"(m_c+m_p)&\ddot x &{}+{}& m_p l\cos\theta&\ddot\theta &= F + m_p l\dot\theta^2\sin\theta",
        r"(m_c+m_p)\ddot x &= F - m_p l\bigl( \ddot\theta\cos\theta \nonumber\\ &\qquad\qquad {} -"
        r" \dot\theta^2\sin\theta \bigr)",
        r"x:&& (m_c+m_p)\ddot x &= F - m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)",
        r"\begin{multlined} (m_c+m_p)\ddot x + m_p l\ddot\theta\cos\theta \\ - m_p l\dot\theta^2"
        r"\sin\theta = F \end{multlined}",
    ],
)
def test_columns_of_terms(text: str) -> None:
    assert verdicts(display(text)) == ["PROVED"]
    assert verdicts(display(text.replace("F", "2 F"))) == ["REFUTED"]


@pytest.mark.parametrize("typed", [r"\text{ + 5x}", r"\quad\text{- x}", r"\mbox{+ 2 \ }"])
def test_a_term_that_is_written_as_text_is_not_passed_over(typed: str) -> None:
    assert verdicts(rf"\[ {bare(RAIL)} {typed} \]") == ["UNDECIDED"]
    assert verdicts(rf"\[ {bare(RAIL)} \quad\text{{-- the cart}} \]") == ["PROVED"]
