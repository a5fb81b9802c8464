"""LaTeX as people write it, read and judged."""

import re
from pathlib import Path

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import cartpole, elastic_pendulum, rocker, two_mass_chain

PENDULUM = derived(elastic_pendulum.scene())
ROCKER = derived(rocker.scene())
CHAIN = derived(two_mass_chain.scene())

# As they stand in the source, character by character.
SIX = r"""
$$
\begin{equation*}
(M+m) \ddot{x}+2 k x+M \frac{L}{2} \ddot{\theta} \cos \theta-M \frac{L}{2} \dot{\theta}^{2} \sin \theta=0 \tag{6}
\end{equation*}
$$
"""  # noqa: E501
SEVEN = r"""
$$
\begin{equation*}
M \frac{L}{2} \ddot{x} \cos \theta+M \frac{L^{2}}{3} \ddot{\theta}+M g \frac{L}{2} \sin \theta=0 \tag{7}
\end{equation*}
$$
"""  # noqa: E501
ROCKER_SEVEN = r"""
$$
\begin{equation*}
\left[I_{C}+M R^{2}\left(\frac{5}{4}+\cos \theta\right)\right] \ddot{\theta}-M \frac{R^{2}}{2} \dot{\theta}^{2} \sin \theta-M g \frac{R}{2} \sin \theta=f(t)\left(R+\frac{R}{2} \cos \theta\right) \tag{7}
\end{equation*}
$$
"""  # noqa: E501
MATRICES = r"""
-\left[\begin{array}{rr}
2 k & -k  \tag{1}\\
-k & k
\end{array}\right]\left\{\begin{array}{l}
x_{1} \\
x_{2}
\end{array}\right\}=\left[\begin{array}{rr}
3 m & 0 \\
0 & 2 m
\end{array}\right]\left\{\begin{array}{l}
\ddot{x}_{1} \\
\ddot{x}_{2}
\end{array}\right\}
"""


def verdicts(scene, text: str, **options) -> list[tuple[str, str]]:
    found = mechanics.check(scene, text, notation="latex", **options)
    return [(entry.statement.tag, entry.finding.verdict.name) for entry in found.judged]


def test_the_source_verbatim_is_proved() -> None:
    assert verdicts(PENDULUM, SIX + SEVEN) == [("(6)", "PROVED"), ("(7)", "PROVED")]
    found = mechanics.check(ROCKER, ROCKER_SEVEN)
    (entry,) = found.judged
    assert entry.finding.verdict is Verdict.PROVED
    assert entry.statement.notes == ("f(t) is read as a function of time, not as a product",)
    assert verdicts(CHAIN, MATRICES) == [("1 row 1", "PROVED"), ("1 row 2", "PROVED")]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "text",
    [
        r"(M+m)\ddot x + 2kx + \frac{ML}{2}(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = 0",
        r"(M+m)x'' + 2kx + \frac{ML}{2}\left[\theta''\cos(\theta)-(\theta')^2\sin(\theta)\right]",
        r"\frac{d}{dt}\left[(m+M)\dot{x}+M\frac L2\dot\theta\cos\theta\right] = -2kx",
        r"(M+m)\frac{d^2x}{dt^2} + 2 k x = -\tfrac12 M L \frac{d^{2}}{dt^{2}} \sin\theta",
        r"(M+m)\frac{\mathrm{d}^2 x}{\mathrm{d}t^2}+2kx"
        r"+\frac12 ML\frac{d\,}{dt}(\dot\theta\cos\theta)",
        r"2\,k\,x(t) + (\mathrm{M}+\mathrm{m})\,\ddot{x}(t) + \frac{1}{2} M L"
        r" \bigl( \ddot{\theta}(t) \cos\theta(t) - \dot{\theta}(t)^{2} \sin \theta(t) \bigr) = 0.",
        "\\begin{align}\n(M+m)\\ddot{x} &= -2kx \\\\\n&\\quad - \\frac{ML}{2}\\ddot\\theta\\cos"
        "\\theta + \\frac{ML}{2}\\dot\\theta^2\\sin\\theta \\nonumber\n\\end{align}",
        r"\ddot{x} = -\frac{2kx + M L/2\,(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)}{M+m}",
        r"0 = \left( M + m \right) \cdot \ddot x + 2 \times k x + \left. \frac{ML}{4} \left("
        r" 2\ddot\theta\cos\theta - (1 - \cos^2\theta)^{1/2}\sqrt{4\dot\theta^4} \right)\right.",
    ],
)
def test_ways_to_write_equation_six(text: str) -> None:
    *_, (_, verdict) = verdicts(PENDULUM, text)
    # The last one holds for 0 < theta < pi only.
    assert verdict == ("REFUTED" if "sqrt" in text else "PROVED")


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "text",
    [
        SIX.replace("2 k x", "k x"),
        SIX.replace(r"\dot{\theta}^{2} \sin", r"\dot{\theta}^{2} \cos"),
        SIX.replace(r"\cos \theta-M", r"\cos \theta+M"),
        SEVEN.replace("{3}", "{12}"),
        SEVEN.replace(r"\sin \theta=0", r"\sin \theta=x"),
    ],
)
def test_a_wrong_term_is_refuted_with_a_state(text: str) -> None:
    found = mechanics.check(PENDULUM, text)
    (entry,) = found.judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.finding.witness is not None
    assert dict(entry.finding.witness.state).keys() >= {"M", "L", "theta"}


def test_several_sides_definitions_reactions_and_rates() -> None:
    text = r"""
    \begin{gather}
    x_{C}=x+\frac{L}{2} \sin \theta \\
    p_{x}=M \dot{x}_{C}=M\left(\dot{x}+\frac{L}{2} \dot{\theta} \cos \theta\right) \tag{p} \\
    -T=\frac{d p_{x}}{d t}=M\left[\ddot{x}+\frac{L}{2}\left(\ddot{\theta} \cos \theta
       -\dot{\theta}^{2} \sin \theta\right)\right] \tag{3} \\
    N_{1}=m g+N \\
    N - N_1 + m g = 0
    \end{gather}"""
    found = mechanics.check(PENDULUM, text)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"] * 4
    assert [entry.statement.tag for entry in found.judged][:2] == ["(p)", "(3)"]
    assert any(remark.startswith("x_C is taken as defined by") for remark in found.remarks)


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"V = k x^2 - M g \frac{L}{2}\cos\theta + M g L", "PROVED"),
        (r"V = k x^2 - M g \frac{L}{2}\cos\theta + 3", "REFUTED"),
        (r"V = k x^2 + M g \frac{L}{2}\cos\theta", "REFUTED"),
        (
            r"K = \frac{1}{2}(m+M)\dot x^2 + \frac16 ML^2\dot\theta^2"
            r"+\frac12 ML\dot x\dot\theta\cos\theta",
            "PROVED",
        ),
        (
            r"L=\frac12 (m+M)\dot x^2 + \frac16 ML^2\dot\theta^2+\frac12 ML\dot x\dot\theta"
            r"\cos\theta - kx^2+Mg\frac L2\cos\theta",
            "PROVED",
        ),
        (r"I_C = \frac{M L^2}{12}", "PROVED"),
        (r"I_C = \frac{M L^2}{3}", "REFUTED"),
        (
            r"\begin{pmatrix} M+m & \frac{ML}{2}\cos\theta \\ \frac{ML}{2}\cos\theta & ML^2/3"
            r"\end{pmatrix}",
            "PROVED",
        ),
    ],
)
def test_partial_input(text: str, verdict: str) -> None:
    found = mechanics.check(PENDULUM, text, names={"K": "kinetic energy"} if "K" in text else None)
    assert [entry.finding.verdict.name for entry in found.judged] == [verdict]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (r"\frac{L}{2 = 3", "line 1, column"),
        (r"a = \foo", r"line 1, column 5: the command \foo is not supported"),
        ("x =\n  \\int x", r"line 2, column 3: the command \int is not supported"),
        (r"\sin", "column 1: the argument of sin is missing"),
        (r"x^{100000}", "the exponent is too large"),
        (r"(x + 1]", "column 7: ']' cannot be read"),
        (r"\ddot{x} + = 3", "a term is missing here"),
        (r"x = 1/0", "a division by zero"),
        (r"x = \sqrt{-1}", "no finite real value"),
        ("{" * 3000 + "}" * 3000, "nested too deeply"),
        (r"\frac" * 5000, "line 1, column"),
        ("x" * 200_000, "100000 are the limit"),
        ("", "there is no equation in it"),
        (r"((x^{64})^{64})^{64}", "too large"),
    ],
)
def test_what_cannot_be_read_is_one_line_with_its_place(text: str, words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        mechanics.check(PENDULUM, text, notation="latex")
    assert "\n" not in str(caught.value)


def test_one_unreadable_line_does_not_hide_the_others(tmp_path: Path) -> None:
    file = tmp_path / "mine.tex"
    file.write_text(SIX + "\n$$ \\sum_i m_i x_i = 0 $$\n" + SEVEN)
    found = mechanics.check(PENDULUM, file)
    assert [e.finding.verdict.name for e in found.judged] == ["PROVED", "UNDECIDED", "PROVED"]
    assert f"{file}, line 8, column" in found.judged[1].finding.evidence
    assert not found.ok


@pytest.mark.parametrize(
    "more",
    [
        r"\text{ + friction}", r"\text{+ small terms}", r"\quad\text{+ friction of the bearing}",
        r"\text{ plus friction}", r"\mbox{- the drag}", r"\text{ + } x",
    ],
)  # fmt: skip
def test_a_term_in_words_is_no_prose(more: str) -> None:
    row = r"(m_c + m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) - F"
    try:
        found = mechanics.check(
            cartpole.scene(), rf"\[ {row} {more} = 0 \]", notation="latex", blame=False
        )
    except mechanics.MechanicsError as error:
        assert "line 1, column" in str(error)
    else:
        assert not found.ok


def test_a_paragraph_ends_an_equation() -> None:
    row = r"(m_c + m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) - F = 0"
    found = mechanics.check(
        cartpole.scene(), rf"\[ {row} \par \ddot\theta = 0 \]", notation="latex", blame=False
    )
    assert [e.finding.verdict.name for e in found.judged] == ["PROVED", "REFUTED"]


@pytest.mark.parametrize("written", ["[+ 2 k x]", r"\; [\;+\; 2 k x \;]", r"\left(+ 2 k x\right)"])
def test_a_term_in_brackets_with_a_plus_may_be_left_out_and_is_read_as_there(written: str) -> None:
    text = SIX.replace("+2 k x", written)
    assert text != SIX
    found = mechanics.check(PENDULUM, text, blame=False)
    assert found.verdict is Verdict.PROVED
    assert any("read as a term" in note for note in found.judged[0].statement.notes)
    wrong = mechanics.check(PENDULUM, text.replace("2 k x", "3 k x"), blame=False)
    assert wrong.verdict is Verdict.REFUTED
    with pytest.raises(InputError, match="or a factor"):
        mechanics.check(PENDULUM, text.replace(written, written + " m"), blame=False)
