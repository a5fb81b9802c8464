"""A parameter of C without a name takes nothing: of a function that is called, it is refused."""

import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import rod_pendulum

HELPER = "double squared({}) {{ return l*l; }}\n"
ACC = (
    "double acc(double theta, {} double u, double m, double l, double g)\n"
    "{{ return 3*g*sin(theta)/{} + 3*u/(m*l*l); }}\n"
)


@pytest.mark.parametrize(
    "parameters", ["double l, double", "double, double l", "double *, double l"]
)
def test_of_a_function_that_is_called(parameters: str) -> None:
    code = HELPER.format(parameters) + ACC.format("", "(2*squared(l, l)/l)")
    with pytest.raises(InputError, match=r"line 1, column 8: a parameter of squared has no name"):
        check(rod_pendulum.scene(), code, notation="c", blame=False)


@pytest.mark.parametrize(("divisor", "verdict"), [("(2*l)", "PROVED"), ("l", "REFUTED")])
def test_of_the_function_that_is_judged(divisor: str, verdict: str) -> None:
    code = ACC.format("double,", divisor)
    found = check(rod_pendulum.scene(), code, notation="c", blame=False)
    assert found.verdict is Verdict[verdict]
