"""Functions of math.h as people call them: exact ones have their meaning, others are refused."""

import pytest
from rod_statements import ROD

import mechanics
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check

SHOWN = (Verdict.PROVED, Verdict.CERTIFIED)
RIGHT = "3*g/(2*l)*sin(theta) + 3*u/(m*l*l)"
CODE = """
#include <math.h>
double theta_ddot(double theta, double theta_dot, double u, double m, double l, double g)
{
    BODY
}
"""


def check(body: str) -> Check:
    text = CODE.replace("BODY", body.replace("RIGHT", RIGHT))
    return mechanics.check(ROD, text, notation="c", blame=False)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "more",
    [
        "fdim(theta, u) - fmax(theta - u, 0)",
        "cbrt(u*u*u) - u",
        "trunc(1.5) - 1 + trunc(-1.5) + 1",
        "round(2.5) - 3 + round(-2.5) + 3",
        "exp2(2.0) - 4 + log2(u*u + 2)*log(2.0) - log(u*u + 2) + log10(10.0) - 1",
        "fmax(theta, u) + fmin(theta, u) - theta - u",
        "copysign(theta, u) - (u < 0 ? -fabs(theta) : fabs(theta)) + 0*copysign(u, 1)",
        "copysign(1.0, u)*copysign(1.0, u) - 1",
        "copysign(u*u, u) - fabs(u)*u",
        "fabs(theta) - copysign(theta, 1.0)",
        "sin(M_PI_2) - 1 + M_SQRT2*M_SQRT1_2 - 1",
        "log2(8) - 3 + exp2(0.5) - M_SQRT2",
        "(isgreater(u, 2) ? 1 : 0) + (islessequal(u, 2) ? 1 : 0) - 1",
    ],
)
def test_a_function_has_its_exact_meaning(more: str) -> None:
    assert check(f"return RIGHT + {more};").verdict in SHOWN


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "more", ["fdim(theta, u)", "cbrt(u)", "trunc(u)", "round(u)", "signbit(u)", "log2(u*u + 2)"]
)
def test_a_function_is_not_zero(more: str) -> None:
    assert check(f"return RIGHT + {more};").verdict is Verdict.REFUTED


def test_copysign_is_one_and_not_zero_at_zero() -> None:
    found = check("return RIGHT + copysign(1.0, u) - ((u > 0) - (u < 0));")
    assert found.verdict is Verdict.REFUTED


@pytest.mark.parametrize("name", ["y1", "jn", "nan", "logb"])
def test_a_variable_may_have_the_name_of_a_function(name: str) -> None:
    assert check(f"double {name} = RIGHT; return {name};").verdict in SHOWN


@pytest.mark.parametrize("asked", ["isnan(a)", "!isfinite(a)", "isinf(a)"])
def test_a_guard_of_what_has_values_is_never_taken(asked: str) -> None:
    assert check(f"double a = RIGHT; if ({asked}) return 0; return a;").verdict in SHOWN


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("if (isinf(exp(800.0))) return 0; return RIGHT;", "output 1 is 0, its formula in real"),
        ("if (!isfinite(1e200*1e200)) return 0; return RIGHT;", "output 1 is 0, its formula"),
        ("return RIGHT + 0*(1e200*1e200);", "output 1 is nan"),
        ("if (0.1 + 0.2 == 0.3) return RIGHT; return 0;", "output 1 is 0"),
        ("return RIGHT + 1e15*(1.0471975511965981 - M_PI/3);", "1.047197551196598 is read as pi/3"),
        ("return RIGHT + 1e7*(1.0471975511965981 - M_PI/3);", "1.047197551196598 is read as pi/3"),
        ("return RIGHT*(1.0471975511965981 > M_PI/3 ? 2 : 1);", "1.047197551196598 is read as"),
    ],
)
def test_what_a_machine_computes_otherwise_is_not_shown(body: str, words: str) -> None:
    found = check(body)
    assert found.verdict is Verdict.UNDECIDED
    assert words in " ".join(str(found).split())


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "body",
    [
        "return RIGHT*(1.0471975511965976*3/M_PI);",
        "return 1.0471975511965981/M_PI*3*(RIGHT);",
        "if (isinf(exp(8.0))) return 0; return RIGHT;",
        "if (theta < -5 ? 0 : 1e100 < 1e90) return 0; return RIGHT;",
        "return floor(fabs(theta/900)) > 0 ? RIGHT*1 : RIGHT + 0/(1 + fabs(u));",
    ],
)
def test_what_a_machine_computes_alike_is_shown(body: str) -> None:
    assert check(body).verdict in SHOWN


def test_a_limit_that_only_large_numbers_meet_is_refuted() -> None:
    assert check("return RIGHT + fmin(fmax(theta, -100), 100) - theta;").verdict is Verdict.REFUTED


def test_a_guard_of_what_has_no_value_somewhere_says_where() -> None:
    found = check("if (isnan(sqrt(theta))) return 0; return RIGHT;")
    assert "theta >= 0" in str(found)
    assert not found.ok


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("return rint(theta);", "rint() depends on the rounding mode: write floor(x + 0.5)"),
        ("return nearbyint(theta);", "write floor(x + 0.5)"),
        ("return remainder(theta, u);", "write fmod"),
        ("return abs(theta);", "abs() is for integers in C: write fabs"),
        ("return tgamma(theta);", "tgamma() has no exact meaning"),
        ("if (u > INFINITY) return 0; return RIGHT;", "INFINITY is no real number"),
        ("return NAN;", "NAN is no real number"),
        ("return copysign(theta, -0.0);", "-0.0 differs from 0.0 in copysign"),
        ("return RIGHT + signbit(-.0e1);", "-0.0 differs from 0.0 in copysign"),
        ("return ldexp(theta, 2);", "asks for the bits of a double"),
    ],
)
def test_what_has_no_exact_meaning_is_one_line(body: str, words: str) -> None:
    with pytest.raises(InputError, match=r"code\.c, line 5, column \d+: ") as caught:
        check(body)
    (line,) = str(caught.value).splitlines()
    assert words in line


def test_a_function_of_the_file_is_its_own() -> None:
    own = "static double fdim(double x, double y) { return 0*x*y; }" + CODE
    text = own.replace("BODY", f"return {RIGHT} + fdim(theta, u);")
    assert mechanics.check(ROD, text, notation="c", blame=False).verdict in SHOWN


UNREAD = "static double even(double x)\n{\n    return rint(x);\n}\n" + CODE.lstrip()


def test_what_is_not_called_is_named_and_need_not_be_exact() -> None:
    text = UNREAD.replace("BODY", f"return {RIGHT};")
    found = mechanics.check(ROD, text, notation="c", blame=False)
    assert found.verdict in SHOWN
    assert "even is not read" in str(found)


@pytest.mark.parametrize("body", ["return even(u);", "double even = 1.0; return even;"])
def test_a_name_that_occurs_is_read(body: str) -> None:
    """Whatever stands around it, and by way of a macro, too."""
    text = UNREAD.replace("BODY", body)
    for code in (text, text.replace("return even", "return CALL").replace(
        "double theta_ddot", "#define CALL even\ndouble theta_ddot"
    )):  # fmt: skip
        with pytest.raises(InputError, match=r"rint\(\) depends|macro"):
            mechanics.check(ROD, code, notation="c", blame=False)
