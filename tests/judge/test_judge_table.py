"""The table of where a statement is defined, row by row, in every input form.

Expected are the verdict and where it holds; the exit code follows from the verdict alone: 0 for
PROVED and CERTIFIED, 1 for REFUTED, 3 for UNDECIDED.
"""

import casadi
import numpy as np
import pytest
import sympy
from rod_statements import of_c, of_casadi, of_latex, of_python, of_sympy, of_text, outcome

SILENT = ("PROVED", "")


def rows(table):
    """Parameters of a test from rows of forms."""
    return [
        pytest.param(found, expected, id=f"{name}: {form}")
        for name, expected, forms in table
        for form, found in forms.items()
    ]


THIN = [
    ("a norm less a part", ("PROVED", "except where -theta + sqrt(theta**2 + u**2) - 1 = 0"), {
        "text": lambda: of_text(more="0/(sqrt(theta^2 + u^2) - theta - 1)"),
        "LaTeX": lambda: of_latex(more=r"\frac{0}{\sqrt{\theta^2 + u^2} - \theta - 1}"),
        "C": lambda: of_c(more="0/(sqrt(theta*theta + u*u) - theta - 1)"),
    }),
    ("a modulus less a part of it", ("PROVED", "except where -theta + Abs(theta) - 1 = 0"), {
        "text": lambda: of_text(more="0/(abs(theta) - theta - 1)"),
        "LaTeX": lambda: of_latex(more=r"\frac{0}{\left|\theta\right| - \theta - 1}"),
        "C": lambda: of_c(more="0/(fabs(theta) - theta - 1)"),
        "Python": lambda: of_python(more=lambda x: 0 / (abs(x) - x - 1)),
    }),
    ("at rest, of code", ("UNDECIDED", "NOT SHOWN: NaN at rest (Abs(theta) = 0)"), {
        "C": lambda: of_c(more="0/fabs(theta)"),
        "Python": lambda: of_python(more=lambda x: 0 / abs(x)),
    }),
    ("at rest, of formulas", ("PROVED", "except where Abs(theta) = 0"), {
        "text": lambda: of_text(more="0/abs(theta)"),
        "LaTeX": lambda: of_latex(more=r"\frac{0}{\left|\theta\right|}"),
    }),
    ("a case of its own that ends in an error", ("PROVED", "except where theta = 1"), {
        "Python": lambda: of_python(more=lambda x: 0 if x != 1 else 1 / 0),
    }),
]  # fmt: skip
OPEN = [
    ("half a line, rest at its end", ("UNDECIDED", "PROVED WHERE -theta + Abs(theta) != 0"), {
        "text": lambda: of_text(more="0/(abs(theta) - theta)"),
        "LaTeX": lambda: of_latex(more=r"\frac{0}{\left|\theta\right| - \theta}"),
        "C": lambda: of_c(more="0/(fabs(theta) - theta)"),
        "Python": lambda: of_python(more=lambda x: 0 / (abs(x) - x)),
    }),
    ("beyond a value, an error that it raises", ("PROVED", "except where theta > 2"), {
        "Python": lambda: of_python(more=fails_beyond(2)),
    }),
    ("beyond a value, a division by 0", ("UNDECIDED", "PROVED WHERE theta <= 2"), {
        "Python": lambda: of_python(more=lambda x: 1 / 0 if x > 2 else 0),
    }),
]  # fmt: skip


def fails_beyond(bound):
    def more(x):
        if x > bound:
            raise ValueError("beyond")
        return 0

    return more


OPEN_AT_REST = [
    ("an error", "has no real value at theta = 0", {
        "Python": lambda: of_python(more=fails_beyond(-1)),
        "Python, a division by zero": lambda: of_python(more=lambda x: 0 / (max(x, 1.0) - 1)),
    }),
    ("a divisor that is zero around it", "at theta = 0", {
        "C": lambda: of_c(more="0/(fmax(theta, 1) - 1)"),
        "text": lambda: of_text(more="0/(max(theta, 1) - 1)"),
    }),
]  # fmt: skip
NOWHERE = [
    ("a root of what is negative", "at any state", {
        "text": lambda: of_text(more="0*sqrt(-1 - theta^2)"),
        "LaTeX": lambda: of_latex(more=r"0 \sqrt{-1 - \theta^2}"),
        "C": lambda: of_c(more="0*sqrt(-1 - theta*theta)"),
        "Python": lambda: of_python(more=lambda x: 0 * np.sqrt(-1 - x * x)),
        "CasADi": lambda: of_casadi(more=lambda x: casadi.sqrt(-1 - x * x) - casadi.sqrt(-1 - x * x)
                                    * 1.0000000001 + casadi.sqrt(-1 - x * x) * 1e-10),
        "SymPy": lambda: of_sympy(
            more=lambda x: sympy.Mul(
                sympy.sqrt(-1 - x**2), sympy.sqrt(-1 - x**2), evaluate=False) + 1 + x**2
        ),
    }),
    ("a constant that is none", "at any state", {
        "Python, nan": lambda: of_python(more=lambda x: np.nan),
        "Python, a root": lambda: of_python(more=lambda x: 0 * np.sqrt(np.float64(-1))),
        "Python, a logarithm": lambda: of_python(more=lambda x: 0 * np.log(-x * x)),
        "Python, 0/0": lambda: of_python(more=lambda x: (x - x) / (x - x)),
    }),
]  # fmt: skip


@pytest.mark.parametrize(("found", "expected"), rows(THIN))
def test_thin_sets(found, expected):
    assert outcome(found()) == expected


@pytest.mark.parametrize(("found", "expected"), rows(OPEN))
def test_open_sets(found, expected):
    assert outcome(found()) == expected


@pytest.mark.filterwarnings("ignore:invalid value")
@pytest.mark.parametrize(("found", "words"), rows(OPEN_AT_REST + NOWHERE))
def test_what_has_no_value_where_it_must(found, words):
    (entry,) = found().judged
    assert entry.finding.undefined
    assert words in entry.finding.evidence


FUNCTIONS = {
    "np.hypot": lambda x: 0 * np.hypot(x, 2),
    "np.hypot of a number and it": lambda x: np.hypot(3, x) - np.sqrt(9 + x * x),
    "np.cbrt": lambda x: np.cbrt(x) ** 3 - x,
    "np.cbrt of what is negative": lambda x: np.cbrt(-8 - x * x) + np.cbrt(8 + x * x),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_of_numpy(name):
    assert outcome(of_python(more=FUNCTIONS[name])) == SILENT


def test_a_wrong_root_is_refuted():
    assert of_python(more=lambda x: np.cbrt(x) - x).verdict.name == "REFUTED"
    assert of_python(more=lambda x: np.hypot(x, 1) - x).verdict.name == "REFUTED"
