"""Commands of the person's own: put in where they are harmless, else refused by name."""

import pytest

import mechanics
from mechanics.claims.latex.macros import expanded
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
POLE = r"\tfrac43 l\ddot\theta + \ddot x\cos\theta = g\sin\theta"


def verdicts(text: str) -> list[str]:
    found = mechanics.check(CART, text, notation="latex", blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("definition", "old", "new"),
    [
        (r"\newcommand{\th}{\theta}", r"\theta", r"\th "),
        (r"\newcommand\th{\theta}", r"\theta", r"\th "),
        (r"\providecommand{\th}{\theta}", r"\theta", r"\th "),
        (r"\def\th{\theta}", r"\theta", r"\th "),
        (r"\let\th\theta", r"\theta", r"\th "),
        (r"\let\th=\theta", r"\theta", r"\th "),
        (r"\newcommand{\dd}[1]{\ddot{#1}}", r"\ddot", r"\dd"),
        (r"\def\dd#1{\ddot{#1}}", r"\ddot", r"\dd"),
        (r"\newcommand{\dd}[2][2]{\frac{d^{#1} #2}{dt^{#1}}}", r"\ddot", r"\dd"),
        (r"\newcommand{\dd}[2][1]{\frac{d^{#1} #2}{dt^{#1}}}", r"\ddot", r"\dd[2]"),
        (r"\def\of #1/#2;{\frac{#1}{#2}}", r"\tfrac43", r"\of 4/3;"),
        (r"\newcommand{\s}{\sin}", r"\sin", r"\s"),
        (r"\DeclareMathOperator{\s}{sin}", r"\sin", r"\s"),
        (r"\DeclareMathOperator*{\s}{sin}", r"\sin", r"\s"),
        (r"\newcommand{\four}{4}\newcommand{\three}{3}", r"\tfrac43", r"\frac\four\three"),
        (r"\newcommand{\beq}{\begin{equation}}\newcommand{\eeq}{\end{equation}}", "$", "$"),
    ],
)
def test_harmless_commands_are_put_in(definition: str, old: str, new: str) -> None:
    shown = rf"\beq {POLE} \eeq" if "beq" in definition else f"$${POLE}$$"
    text = shown.replace(old, new)
    assert verdicts(f"{definition}\n{text}") == ["PROVED"]
    assert verdicts(f"{definition}\n{text.replace('= g', '= -g')}") == ["REFUTED"]


@pytest.mark.parametrize(
    "definition",
    [r"\renewcommand{\sin}{\cos}", r"\let\sin\cos", r"\def\sin{\cos}", r"\renewcommand{\theta}{x}"],
)
def test_what_is_given_another_meaning_has_it(definition: str) -> None:
    assert verdicts(f"{definition} $${POLE}$$") == ["REFUTED"]


def test_the_blank_behind_a_command_stays_beside_macros() -> None:
    text = r"\newcommand{\acc}{\ddot\theta} \acc = -\frac gL + \frac{g}{L} + \sqrt 2"
    right = r"\ddot\theta = -\frac gL + \frac{g}{L} + \sqrt 2"
    assert " ".join(expanded(text, "a text").split()) == right


def test_a_saved_command_keeps_its_meaning() -> None:
    text = r"\let\old\sin \renewcommand{\sin}{\cos} \[ " + POLE.replace(r"\sin", r"\old") + r"\]"
    assert verdicts(text.replace(r"\cos\theta", r"\sin\theta")) == ["PROVED"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (r"\def\a{\a} \[ \a \]", r"column 15: \a expands too far"),
        (r"\def\a#1{#1#1}" + r"\a{" * 40 + "x" + "}" * 40, r"\a expands too far"),
        ("".join(rf"\def\z{chr(97 + i)}{{\z{chr(98 + i)}\z{chr(98 + i)}}}" for i in range(25))
            + r"\[ \za \]", "expands too far"),
        (r"\def\a#1{" + "#1" * 20000 + r"}\a{" + "x" * 50000 + "}", r"\a expands too far"),
        (r"\def\a{" * 5000, "is missing behind this"),
        (r"\edef\a{x}\[ \a = 1 \]", r"column 14: \a is defined by \edef"),
        (r"{\def\a{x}} \[ \a = 1 \]", r"\def in braces or an environment"),
        (r"\begingroup\let\sin\cos\endgroup \[ x = \sin x \]", r"\let in braces"),
        (r"\let\a{} \[ x = \a \]", r"column 1: \let: '' is no command"),
        (r"\newcommand{\f}[1]{#1} \[ x = \f", r"column 31: an argument of \f is missing"),
        (r"\newcommand{\f}[1]{#2} \[ x = \f x \]", r"column 31: \f has no argument #2"),
        (r"\catcode`\!=13 \def\a{b} \[ x = 1 \]", r"column 1: \catcode is not supported"),
        (r"\ifx\a\b \[ x = 1 \] \fi", r"column 1: the condition \ifx is not supported"),
        (rf"\iffalse \[ {POLE} \] \fi", "there is no equation in it"),
        (rf"\begin{{comment}} \[ {POLE} \] \end{{comment}}", "there is no equation in it"),
    ],
)  # fmt: skip
def test_what_is_not_harmless_is_refused_by_name(text: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        mechanics.check(CART, text, notation="latex")
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_lines_do_not_move() -> None:
    text = "\\newcommand{\\f}[1]{\n#1\n}\n\\f{\n1\n}\n\\[ x = \\foo \\]"
    with pytest.raises(InputError, match="line 7, column 8"):
        mechanics.check(CART, text, notation="latex")


@pytest.mark.parametrize(
    "hidden",
    [
        r"\iffalse \[ x = 1 \] \fi",
        r"\iftrue\else \[ x = 1 \] \fi",
        r"\begin{verbatim} \[ x = 1 \] \end{verbatim}",
        r"\verb|\[| ",
        r"% \[ x = 1 \]",
    ],
)
def test_what_is_not_printed_is_not_read(hidden: str) -> None:
    assert verdicts(f"{hidden}\n\\[ {POLE} \\] \\end{{document}} \\[ x = 1 \\]") == ["PROVED"]
    assert verdicts(rf"\[ \ensuremath{{{POLE}}} \iffalse + 1 \fi \]") == ["PROVED"]


@pytest.mark.parametrize(
    "pole",
    [
        r"\qty(m_c + m_p) \dv[2]{x}{t}"
        r" + m_p l\qty[\ddot\theta\cos\theta - \dot\theta^2\sin\theta] = F",
        r"\dv{t}\qty((m_c + m_p)\dot x + m_p l\cos\theta\,\dot\theta) = F",
    ],
)
def test_commands_of_a_package_for_brackets_and_derivatives(pole: str) -> None:
    assert verdicts(rf"\[ {pole} \]") == ["PROVED"]
    assert verdicts(rf"\[ {pole.replace('m_c +', 'm_c -')} \]") == ["REFUTED"]
