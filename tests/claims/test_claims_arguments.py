r"""Functions of a person's own are taken of what they are defined of; x(0) is no product with 0."""

import re

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import derived
from tests.notation_scenes import swinging

TRUTH = derived(swinging())
EQUATION = r"\[ m\ddot r - m r\dot\theta^2 + k r = m g USE \]"


def verdicts(definition: str, use: str) -> list[str]:
    text = rf"\[ {definition} \]" + EQUATION.replace("USE", use)
    return [e.finding.verdict.name for e in mechanics.check(TRUTH, text, blame=False).judged]


@pytest.mark.parametrize(
    ("definition", "use"),
    [
        (r"f(\theta) = \cos\theta", r"f(\theta)"),
        (r"f(\theta) = \cos\theta", "f"),
        (r"f(r, \theta) = r\cos\theta", r"\frac{1}{r} f(r, \theta)"),
        (r"f(r, \theta) = r\cos\theta", r"\frac{f(\theta)}{r}"),
        (r"f(q) = \cos\theta", r"f(\theta)"),
        (r"f(\theta) = \sqrt{2 + \cos\theta}", r"(f(\theta)^2 - 2)"),
    ],
)
def test_a_function_is_used_as_it_is_defined(definition: str, use: str) -> None:
    assert verdicts(definition, use) == ["PROVED"]


@pytest.mark.parametrize(
    ("definition", "use", "words"),
    [
        (
            r"f(r, \theta) = r\cos\theta",
            r"f(\theta, r)/r",
            r"with the arguments \(r, theta\) and used with",
        ),
        (
            r"f(\theta) = \frac{1}{r}\cos\theta",
            "f(r)",
            r"with the arguments \(theta\) and used with \(r\)",
        ),
        (r"f(q) = \cos\theta", r"f(\dot q)", r"used with \(r', theta'\)"),
        (r"f(r, \theta) = \cos\theta", r"f(\theta, \dot\theta)", "used with"),
        (r"f(\theta) = \cos\theta", r"f(2\theta)", "what is no name"),
        (r"f(\theta) = \frac{\cos\theta}{r + \theta}", r"f(r + \theta)", "what is no name"),
        ("f = 1", r"\cos\theta + f(0)", "at one time"),
    ],
)
def test_a_function_of_something_else_is_refused(definition: str, use: str, words: str) -> None:
    text = rf"\[ {definition} \]" + EQUATION.replace("USE", use)
    try:
        doubts = [e.statement.doubt for e in mechanics.check(TRUTH, text, blame=False).judged]
    except InputError as error:
        doubts = [str(error)]
    assert any(re.match(r"LaTeX, line 1, column \d+: .*" + words, doubt) for doubt in doubts)


def test_a_function_is_no_factor() -> None:
    """f(theta) = cos(theta)/theta was a product with theta, and this was proved."""
    assert verdicts(r"f(\theta) = \frac{\cos\theta}{\theta}", r"f(\theta)") == ["REFUTED"]


@pytest.mark.parametrize("use", [r"\cos\theta + \theta(0)", r"\cos\theta - \dot\theta(0)"])
def test_a_value_at_the_beginning_is_no_product(use: str) -> None:
    with pytest.raises(InputError, match="at one time"):
        mechanics.check(TRUTH, EQUATION.replace("USE", use), blame=False)


def test_a_value_at_the_beginning_is_no_product_in_text() -> None:
    text = "m*r.diff(t, 2) - m*r*theta.diff(t)**2 + k*r - m*g*cos(theta) = r(0)"
    with pytest.raises(InputError, match=r"text, line 1, column \d+: r\(0\) is a value at one"):
        mechanics.check(TRUTH, text, blame=False)
