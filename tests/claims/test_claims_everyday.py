"""Notation as people write it every day: Leibniz, frames, labels, conditions, old fractions."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
LEFT = r"(m_c + m_p) \ddot x + m_p l (\ddot\theta \cos\theta - \dot\theta^2 \sin\theta)"


def verdicts(text: str, notation: str = "latex") -> list[str]:
    found = mechanics.check(CART, text, notation=notation, blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


def twice(text: str) -> tuple[list[str], list[str]]:
    """Verdicts of a right text, and of it with another force."""
    return verdicts(text), verdicts(text.replace("F", "2 F"))


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "rate",
    [
        r"\frac{d^2 x}{dt^2}", r"\frac{d^2x}{dt^2}", r"\frac{d^{2}x}{dt^{2}}",
        r"\dfrac{\mathrm d^2 x}{\mathrm d t^2}", r"\frac{\mathrm d^2}{\mathrm dt^2} x",
        r"\frac{{\rm d}^2 x}{{\rm d} t^2}", r"\frac{\mathrm{d}}{\mathrm{d}t}(\dot x)",
        r"\frac{d}{dt}\frac{dx}{dt}", r"\frac{\mathrm{d}\dot x}{\mathrm{d}t}", "x^{(2)}",
        r"(\dot x)'", r"\left(\dot x\right)^{\prime}",
    ],
)  # fmt: skip
def test_second_derivatives(rate: str) -> None:
    assert twice(rf"{LEFT} = F".replace(r"\ddot x", rate)) == (["PROVED"], ["REFUTED"])


@pytest.mark.parametrize("rate", [r"\frac{dx}{dt}", r"\frac{\mathrm dx}{\mathrm dt}", "x^{(1)}"])
def test_first_derivatives(rate: str) -> None:
    text = rf"T = \frac12 m_c ({rate})^2 + \frac12 m_p (\dot x^2 + 2 l \dot x \dot\theta"
    assert verdicts(rf"{text} \cos\theta) + \frac23 m_p l^2 \dot\theta^2") == ["PROVED"]


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    "text",
    [
        rf"\boxed{{{LEFT} = F}}",
        rf"{LEFT} = \underbrace{{F}}_{{\text{{drive}}}}",
        rf"\overbrace{{{LEFT}}}^{{\text{{inertia, }} x}} = F",
        rf"{LEFT} = F \qquad\text{{(trolley)}}",
        rf"{LEFT} = F \quad\text{{trolley}}",
        rf"{LEFT} = F\text{{, with }} l > 0",
        rf"{LEFT} = F, \quad 0 < l < 5, \quad \theta \in [0, 1]",
        rf"{LEFT} \text{{ (inertia)}} - F = 0",
        LEFT.replace("m_c", r"m_\mathrm{c}").replace("m_p", r"m_\text{p}") + "= F",
        LEFT.replace("m_c", r"m_\mathrm c").replace("m_p", r"m_{\rm p}") + "= F",
        rf"{{{{{LEFT}}} \over 2}} = {{F \over 2}}",
    ],
)
def test_frames_labels_and_conditions(text: str) -> None:
    assert twice(text) == (["PROVED"], ["REFUTED"])


@pytest.mark.parametrize("arrow", [r"\Rightarrow", r"\quad\Longrightarrow\quad", r"\iff"])
def test_equations_on_both_sides_of_an_arrow(arrow: str) -> None:
    text = rf"{LEFT} - F = 0 {arrow} {LEFT} = F"
    assert verdicts(text) == ["PROVED", "PROVED"]
    assert verdicts(text.replace("= F", "= 2 F")) == ["PROVED", "REFUTED"]


@pytest.mark.parametrize("name", [r"\mathbf{M}(\mathbf{q})", r"\mathbf M(q)", r"M(\theta)"])
def test_a_name_that_depends_on_coordinates_is_defined(name: str) -> None:
    rows = r"m_c + m_p & m_p l \cos\theta \\ m_p l \cos\theta & \frac43 m_p l^2"
    assert verdicts(rf"{name} = \begin{{bmatrix}} {rows} \end{{bmatrix}}") == ["PROVED"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            r"F = \begin{cases} x & \text{if } x > 0 \\ 0 & x < 0 \end{cases}",
            "cases cannot be read",
        ),
        (r"m_c \ddot x \approx F", "approximation cannot be judged"),
        (r"l \ddot\theta > g \theta", "inequality or approximation"),
        (r"m_c^{(2)} x = 0", "has no rate"),
        (r"x + F \over 2 = 3", "over' is out of place"),
    ],
)
def test_what_cannot_be_judged_is_never_dropped(text: str, words: str) -> None:
    with pytest.raises(mechanics.MechanicsError, match=words):
        verdicts(text)
    # Nor beside something right; and it does not spoil that.
    assert "UNDECIDED" in verdicts(rf"\[ {LEFT} = F \] \[ {text} \]")


def test_a_line_that_cannot_be_read_does_not_spoil_the_others() -> None:
    text = rf"{LEFT} &= F \\ \frac{{\partial L}}{{\partial x}} &= 0"
    assert verdicts(rf"\begin{{align}} {text} \end{{align}}") == ["PROVED", "UNDECIDED"]


def test_how_letters_were_parted_is_told_once() -> None:
    text = r"m_c g = ml + a \\ 2 ml = 3 x"
    found = mechanics.check(CART, text, notation="latex", blame=False)
    assert sum("ml is read as the product m l" in remark for remark in found.remarks) == 1
    assert not any("ml" in note for e in found.judged for note in e.statement.notes)
