"""Commands of LaTeX packages say what LaTeX itself says; what is no use of them is not read."""

import pytest

import mechanics
from mechanics.claims.latex.macros import expanded
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())


@pytest.mark.parametrize(
    ("short", "long"),
    [
        (r"\dv{x}{t}", r"\frac{d x}{d t}"),
        (r"\dv*[2]{x}{t}", r"\frac{d^2 x}{d t^2}"),
        (r"\dv{t}(x)", r"\frac{d }{d t}(x)"),
        (r"\odv{}{t} x", r"\frac{d }{d t} x"),
        (r"\pdv{L}{\dot{q}}", r"\frac{\partial L}{\partial \dot{q}}"),
        (r"\pdv{L}{x}{y}", r"\frac{\partial^2 L}{\partial x \partial y}"),
        (r"\diffp{L}{x,y}", r"\frac{\partial^2 L}{\partial x \partial y}"),
        (r"\dv{\qty(x+y)}{t}", r"\frac{d {\left(x+y\right)}}{d t}"),
        (r"\qty(a(b+c)\qty[d])", r"\left(a(b+c)\left[d\right]\right)"),
        (r"\qty\big{a}", r"\left\{a\right\}"),
        (r"\sin[2](x)", r"\sin^{2}(x)"),
        (r"a \qc b", r"a ,\quad  b"),
        (r"a \qq*{so that} b", r"a \quad\text{so that}\quad b"),
        (r"\vb*{F} \cross \vu{n}", r"\mathbf{F} \times \hat{n}"),
        (r"\frac{\dd{x}}{\dd t}", r"\frac{ d x }{ d  t}"),
        (r"\mqty(a & b \\ c & d)", r"\begin{pmatrix}a & b \\ c & d\end{pmatrix}"),
        (r"\pmqty{a \\ b}", r"\begin{pmatrix}a \\ b\end{pmatrix}"),
        (r"\abs{\dot x}", r"\left|\dot x\right|"),
    ],
)
def test_a_command_is_what_it_prints(short: str, long: str) -> None:
    assert expanded(short, "").split() == long.split()


@pytest.mark.parametrize(
    "text",
    [
        r"m = \qty{9.81}{m/s^2}", r"\dv[n]{x}{t}", r"\diff{x} = y",
        r"\pdv[2,1]{L}{x,y}", r"\qty\frac{a}{b}", r"\sin[\theta](x)", r"\norm{v}",
    ],
)  # fmt: skip
def test_what_has_no_such_meaning_stays(text: str) -> None:
    assert expanded(text, "").replace(" ", "") == text.replace(" ", "")


def test_a_bracket_that_is_not_closed_is_named_with_its_place() -> None:
    with pytest.raises(InputError, match="line 2, column 5: '\\)' is missing"):
        expanded("x\n  m \\qty(a + b", "text")


def test_a_command_of_the_person_comes_first() -> None:
    assert r"\ddot{x}" in expanded(r"\newcommand{\dv}[1]{\ddot{#1}} \dv{x}", "")


@pytest.mark.parametrize(
    "text",
    [
        r"\frac{4}{3}l\dv[2]{\theta}{t} + \dv[2]{x}{t}\cos(\theta) = SIGN g\sin(\theta)",
        r"\qty(\frac{4}{3}l)\ddot\theta + \qty[\ddot x\cos\theta] = SIGN g\sin\theta",
        r"0 = 0 \qc \tfrac43 l\ddot\theta + \ddot x\cos\theta = SIGN \tan(\theta) g \cos(\theta)",
    ],
)  # fmt: skip
def test_a_right_statement_is_proved_and_a_wrong_one_is_not(text: str) -> None:
    def verdict(sign: str) -> str:
        found = mechanics.check(CART, text.replace("SIGN", sign), notation="latex", blame=False)
        return found.judged[-1].finding.verdict.name

    assert verdict("+") == "PROVED"
    assert verdict("-") == "REFUTED"


@pytest.mark.parametrize(
    "text",
    [
        r"\frac{dx}{d\theta} = 0", r"\frac{d^2 x}{d\theta^2} = 0", r"\frac{d^2x}{d\theta dt} = 0",
        r"\dv[2]{V}{\theta} = -m_p g l\cos\theta", r"\dv{\theta} V = 0",
    ],
)  # fmt: skip
def test_the_d_of_a_differential_is_no_length(text: str) -> None:
    with pytest.raises(InputError, match="a derivative by something other than time"):
        mechanics.check(CART, text, notation="latex", blame=False)


MOTION = r"\[ (m_c + m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = F \]"


@pytest.mark.parametrize("head", [r"\documentclass{%s}", r"\usepackage{amsmath, %s}"])
def test_a_package_of_ones_own_may_redefine_any_command(head: str) -> None:
    known = "article" if "class" in head else "physics"
    plain = mechanics.check(CART, f"{head % known}\n{MOTION}")
    other = mechanics.check(CART, f"{head % 'macros'}\n{MOTION}")
    assert plain.ok
    assert not other.ok
    assert "the package 'macros' is not read" in str(other)
