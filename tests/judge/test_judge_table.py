"""The table of where a statement is defined, row by row, in every input form.

Expected are the verdict and where it holds; the exit code follows from the verdict alone: 0 for
PROVED and CERTIFIED, 1 for REFUTED, 3 for UNDECIDED.
"""

from dataclasses import replace

import casadi
import numpy as np
import pytest
import sympy
from rod_statements import ROD, C, of_c, of_casadi, of_latex, of_python, of_sympy, of_text, outcome

import mechanics
from mechanics.errors import InputError, SceneError

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


@pytest.mark.sample(4)
@pytest.mark.parametrize(("found", "expected"), rows(THIN))
def test_thin_sets(found, expected):
    assert outcome(found()) == expected


@pytest.mark.parametrize(("found", "expected"), rows(OPEN))
def test_open_sets(found, expected):
    assert outcome(found()) == expected


@pytest.mark.sample(4)
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


LIMITED = {
    "text": lambda: of_text(torque="min(max(u, -2), 2)"),
    "LaTeX": lambda: of_latex(torque=r"\min(\max(u, -2), 2)"),
    "C": lambda: of_c(torque="fmin(fmax(u, -2), 2)"),
    "C, by cases": lambda: of_c(torque="(u > 2 ? 2 : (u < -2 ? -2 : u))"),
    "Python": lambda: of_python(torque=lambda u: np.clip(u, -2, 2)),
    "Python, min and max": lambda: of_python(torque=lambda u: max(-2.0, min(2.0, u))),
    "Python, by cases": lambda: of_python(
        torque=lambda u: 2.0 if u > 2.0 else (-2.0 if u < -2.0 else u)
    ),
    "CasADi": lambda: of_casadi(torque=lambda u: casadi.fmin(casadi.fmax(u, -2), 2)),
    "SymPy": lambda: of_sympy(torque=lambda u: sympy.Min(sympy.Max(u, -2), 2)),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("form", LIMITED)
def test_an_input_may_be_limited_before_it_is_used(form):
    verdict, domain = outcome(LIMITED[form]())
    assert verdict in ("PROVED", "CERTIFIED")
    assert domain == "u is limited to +-2"


@pytest.mark.parametrize(
    ("torque", "words"),
    [
        (lambda u: min(u, 3), "u is limited to u <= 3"),
        (lambda u: max(u, 0), "u is limited to u >= 0"),
        (lambda u: np.clip(u, -1, 4), "u is limited to -1 .. 4"),
    ],
)
def test_limits_are_named(torque, words):
    found = of_python(torque=torque)
    assert found.ok
    assert outcome(found)[1] == words


NOT_LIMITS = {
    "a coordinate": lambda: of_python(angle=lambda theta: np.clip(theta, -2, 2)),
    "a coordinate in C": lambda: of_c(angle="fmin(fmax(theta, -2), 2)"),
    "another value beyond": lambda: of_python(torque=lambda u: u if abs(u) < 2 else 0),
    "used before": lambda: of_python(torque=lambda u: np.clip(u, -2, 2) / 2 + u / 2),
    "rest is beyond": lambda: of_python(torque=lambda u: max(u, 1)),
    "next to nothing is left below": lambda: of_python(torque=lambda u: np.clip(u, -1e-300, 2)),
    "next to nothing is left": lambda: of_python(torque=lambda u: np.clip(u, -1e-9, 1e-9)),
    "nothing is left": lambda: of_python(torque=lambda u: np.clip(u, 0, 0)),
    "a wrong factor": lambda: of_python(torque=lambda u: 2 * np.clip(u, -2, 2)),
    "by a coordinate": lambda: of_c(torque="fmin(u, theta)"),
    "by a length": lambda: of_c(torque="fmin(u, l)"),
    "exchanged limits": lambda: of_c(torque="(u > 2 ? -2 : (u < -2 ? 2 : u))"),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", NOT_LIMITS)
def test_anything_else_is_refuted(name):
    assert NOT_LIMITS[name]().verdict.name == "REFUTED"


def test_a_wrap_of_what_has_no_value_at_rest_is_no_wrap():
    found = of_python(more=lambda x: np.arcsin(np.sin(np.sin(x) / x)))
    assert found.verdict.name in ("REFUTED", "UNDECIDED")


def sinc(x, least=1e-8, at_zero=1.0):
    return np.sin(x) / x if abs(x) > least else at_zero


GUARDED = {
    "Python": lambda: of_python(more=lambda x: x * sinc(x) - np.sin(x)),
    "Python, np.where": lambda: of_python(
        more=lambda x: x * np.where(abs(x) < 1e-8, 1, np.sin(x) / x) - np.sin(x)
    ),
    "C": lambda: of_c(more="theta*(fabs(theta) < 1e-8 ? 1 : sin(theta)/theta) - sin(theta)"),
    "Python, a wider one": lambda: of_python(more=lambda x: x * sinc(x, 1e-6) - np.sin(x)),
    "Python, of a square": lambda: of_python(
        more=lambda x: x * (np.sin(x) / x if x * x > 1e-16 else 1.0) - np.sin(x)
    ),
    "CasADi": lambda: of_casadi(
        more=lambda x: (
            casadi.if_else(casadi.fabs(x) < 1e-8, 1, casadi.sin(x) / x) * x - casadi.sin(x)
        )
    ),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("form", GUARDED)
def test_within_a_small_guard_what_is_near_the_truth_will_do(form):
    found = GUARDED[form]()
    assert outcome(found) == SILENT
    assert "within 1e-9 of the truth" in found.judged[0].finding.evidence


NO_GUARDS = {
    "another value": lambda: of_python(more=lambda x: x * sinc(x, at_zero=0.5) - np.sin(x)),
    "another value in C": lambda: of_c(
        more="theta*(fabs(theta) < 1e-8 ? 0.5 : sin(theta)/theta) - sin(theta)"
    ),
    "a wide one": lambda: of_python(more=lambda x: x * sinc(x, 1e-3) - np.sin(x)),
    "on one side": lambda: of_python(
        more=lambda x: x * (np.sin(x) / x if x > 1e-8 else 1.0) - np.sin(x)
    ),
    "wrong beside it": lambda: of_python(more=lambda x: 2 * x * sinc(x) - np.sin(x)),
    "nothing to guard": lambda: of_python(more=lambda x: x if abs(x) < 1e-8 else 0),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", NO_GUARDS)
def test_other_guards_are_refuted(name):
    assert NO_GUARDS[name]().verdict.name == "REFUTED"


HALF = "PROVED WHERE -pi/2 < theta < pi/2"
WHOLE = "PROVED WHERE -pi < theta < pi"
PRINCIPAL = [
    ("asin", ("UNDECIDED", HALF), {
        "text": lambda: of_text(more="u*(asin(sin(theta)) - theta)"),
        "LaTeX": lambda: of_latex(more=r"u (\arcsin(\sin\theta) - \theta)"),
        "C": lambda: of_c(more="u*(asin(sin(theta)) - theta)"),
        "Python": lambda: of_python(more=lambda x: np.arcsin(np.sin(x)) - x),
        "CasADi": lambda: of_casadi(more=lambda x: casadi.asin(casadi.sin(x)) - x),
        "SymPy": lambda: of_sympy(more=lambda x: sympy.asin(sympy.sin(x)) - x),
    }),
    ("atan2", ("UNDECIDED", WHOLE), {
        "text": lambda: of_text(more="u*(atan2(sin(theta), cos(theta)) - theta)"),
        "C": lambda: of_c(more="u*(atan2(sin(theta), cos(theta)) - theta)"),
        "Python": lambda: of_python(more=lambda x: np.arctan2(np.sin(x), np.cos(x)) - x),
        "CasADi": lambda: of_casadi(
            more=lambda x: casadi.atan2(casadi.sin(x), casadi.cos(x)) - x),
    }),
    ("twice atan", ("UNDECIDED", WHOLE), {
        "text": lambda: of_text(more="u*(2*atan(tan(theta/2)) - theta)"),
        "Python": lambda: of_python(more=lambda x: 2 * np.arctan(np.tan(x / 2)) - x),
    }),
    ("acos", ("UNDECIDED", "PROVED WHERE 0 < theta < pi"), {
        "text": lambda: of_text(more="u*(acos(cos(theta)) - theta)"),
        "Python": lambda: of_python(more=lambda x: np.arccos(np.cos(x)) - x),
    }),
    ("modulo", ("UNDECIDED", WHOLE), {
        "Python": lambda: of_python(more=lambda x: (x + np.pi) % (2 * np.pi) - np.pi - x),
    }),
]  # fmt: skip


@pytest.mark.sample(4)
@pytest.mark.parametrize(("found", "expected"), rows(PRINCIPAL))
def test_what_differs_beyond_the_range_of_its_own_wraps_is_right_within(found, expected):
    assert outcome(found()) == expected


@pytest.mark.parametrize(
    "more",
    [
        lambda x: np.arcsin(np.sin(x)) + x,
        lambda x: np.arctan2(np.cos(x), np.sin(x)) - x,
        lambda x: (x + np.pi) % (2 * np.pi) - x,
        lambda x: x % 3 - x,
    ],
)
def test_what_is_wrong_within_it_is_refuted(more):
    assert of_python(more=more).verdict.name == "REFUTED"


ROUND = 2 * np.pi
PERIODS = {
    "a period": lambda: of_c("fmod(theta, 2*3.141592653589793)"),
    "two periods": lambda: of_c("fmod(theta, 4*3.141592653589793)"),
    "two of half the angle": lambda: of_python(
        more=lambda x: (
            2 * np.sin(np.fmod(x, 2 * ROUND) / 2) * np.cos(np.fmod(x, 2 * ROUND) / 2) - np.sin(x)
        )
    ),
    "a period, shifted": lambda: of_python(lambda x: (x + 1) % ROUND - 1),
    "of a multiple": lambda: of_python(more=lambda x: np.sin(3 * (x % ROUND)) - np.sin(3 * x)),
}
NO_PERIODS = {
    "half a period": lambda: of_c("fmod(theta, 3.141592653589793)"),
    "of half the angle": lambda: of_python(more=lambda x: np.sin((x % ROUND) / 2) - np.sin(x / 2)),
    "rounded": lambda: of_c("fmod(theta, 6.28)"),
    "the angle itself": lambda: of_c("theta", more="u*(fmod(theta, 2*3.141592653589793) - theta)"),
}


@pytest.mark.parametrize("name", PERIODS)
def test_wrapping_by_whole_periods_is_nothing_under_a_sine(name):
    assert outcome(PERIODS[name]()) == SILENT


@pytest.mark.parametrize("name", NO_PERIODS)
def test_wrapping_otherwise_is_not_shown(name):
    assert not NO_PERIODS[name]().ok


def undefined_where(condition):
    """Zero, but for a logarithm of what is negative in a branch."""
    return lambda x: 0 * np.log(-1 - x * x) if condition(x) else 0


BRANCHES = {
    "far": (lambda x: x > 1e5, "PROVED WHERE theta <= 100000"),
    "farther": (lambda x: x**3 > 1e27, "PROVED WHERE theta**3 <= 1000000000000000000000000000"),
    "near 0": (lambda x: 0 < x**3 < 1e-30, "PROVED WHERE theta**3 <= 0 or theta**3 >="
               " 1/1000000000000000000000000000000"),
    "beside a value": (lambda x: 2 < x < 2.001, "PROVED WHERE theta <= 2 or theta >= 2001/1000"),
}  # fmt: skip
EMPTY = {
    "a sine above 1": lambda x: np.sin(x) > 1,
    "a sine beyond 2": lambda x: np.sin(x) > 2,
    "an exponential below 0": lambda x: np.exp(x) < 0,
    "a square below 0": lambda x: x * x + 1 < 0,
    "above and below": lambda x: (x * x < 0) or (abs(x) < 0),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", BRANCHES)
def test_branches_are_reached_at_all_scales(name):
    condition, words = BRANCHES[name]
    assert outcome(of_python(more=undefined_where(condition))) == ("UNDECIDED", words)
    assert of_python(more=lambda x: 1 if condition(x) else 0).verdict.name == "REFUTED"


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", EMPTY)
def test_branches_that_no_state_takes_are_shown_empty(name):
    assert outcome(of_python(more=undefined_where(EMPTY[name]))) == SILENT
    assert outcome(of_python(more=lambda x: 1 if EMPTY[name](x) else 0)) == SILENT


def test_a_branch_that_is_neither_reached_nor_shown_empty_is_undecided():
    def hardly(x):
        return np.sin(x) ** 2 * np.exp(-x * x) > 0.9999

    for more in (undefined_where(hardly), lambda x: 1 if hardly(x) else 0):
        assert outcome(of_python(more=more)) == ("UNDECIDED", "")


@pytest.mark.parametrize("setting", ["NDEBUG", "FAST_MATH", "__cplusplus"])
def test_code_under_two_settings_of_a_macro_is_refused_by_name(setting):
    with pytest.raises(InputError, match=setting):
        of_c(more=f"0;\n#ifdef {setting}\n    return 0;\n#endif\n    (void)0")


def hanging(**declared):
    """The rod that hangs at theta = pi."""
    return mechanics.derive(replace(ROD.scene, **declared), "free_body")


@pytest.mark.parametrize(
    ("more", "without", "declared"),
    [
        ("0/(sin(theta/2) - 1)", ("PROVED", "except where sin(theta/2) - 1 = 0"),
         ("UNDECIDED", "NOT SHOWN: NaN at rest (sin(theta/2) - 1 = 0)")),
        ("0*log(3 - theta)", ("UNDECIDED", "PROVED WHERE 3 - theta > 0"),
         ("REFUTED", "undefined")),
        ("0*log(4 - theta)", ("UNDECIDED", "PROVED WHERE 4 - theta > 0"),
         ("UNDECIDED", "PROVED WHERE 4 - theta > 0")),
    ],
)  # fmt: skip
def test_what_is_written_has_a_value_at_declared_equilibria(more, without, declared):
    text = C % ("theta", "u", more)
    truth = hanging(equilibria=({"theta": sympy.pi},))
    assert outcome(of_c(more=more)) == without
    found = mechanics.check(truth, text, blame=False, notation="c")
    assert outcome(found) == declared
    if declared[0] == "REFUTED":
        assert "theta = 3.1416" in found.judged[0].finding.evidence


@pytest.mark.parametrize(
    ("equilibrium", "words"),
    [({"phi": 0}, "an equilibrium gives 'phi'"), ({"theta": ROD.scene.q[0]}, "give a number")],
)
def test_an_equilibrium_gives_numbers_of_the_scene(equilibrium, words):
    with pytest.raises(SceneError, match=words):
        hanging(equilibria=(equilibrium,))
