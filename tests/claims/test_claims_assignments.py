"""What a program assigns again holds from there on; what is not read spoils what uses it."""

from functools import cache
from pathlib import Path

import pytest

from mechanics import check
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import rod_pendulum

HEAD = "function dydt = f(t, y, u, m, l, g)\n"
RATE = "dydt = [y(2); k*3*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)];"


@cache
def truth() -> Equations:
    return derived(rod_pendulum.scene())


def worst(body: str, tmp_path: Path) -> Verdict:
    path = tmp_path / "f.m"
    path.write_text(f"{HEAD}{body}\nend\n")
    return check(truth(), path, blame=False).verdict


@pytest.mark.parametrize(
    "body",
    [
        f"k = -1; k = 1; {RATE}",
        f"k = -1; k = -k; {RATE}",
        f"k = -1;\nk = k + 2;\n{RATE}",
        "dydt = zeros(2, 1); dydt(1) = y(2);"
        " dydt(2) = 3*g/(2*l)*sin(y(1)); dydt(2) = dydt(2) + 3*u/(m*l^2);",
        "l = l/2; dydt = [y(2); 3*g/(4*l)*sin(y(1)) + 3*u/(4*m*l^2)];",
        "a = 3*g/(2*l)*sin(y(1)); a = a + 3*u/(m*l^2); dydt = [y(2); a];",
    ],
)
def test_a_name_is_worth_what_was_assigned_last(body: str, tmp_path: Path) -> None:
    assert worst(body, tmp_path) is Verdict.PROVED


@pytest.mark.parametrize(
    "body",
    [
        f"k = 1; k = -1; {RATE}",
        f"k = 1; k = 2*k; {RATE}",
        "l = l/2; dydt = [y(2); 3*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)];",
        "a = 3*g/(2*l)*sin(y(1)); a = a + u/(m*l^2); dydt = [y(2); a];",
        "dydt = zeros(2, 1); dydt(1) = y(2);"
        " dydt(2) = 3*g/(2*l)*sin(y(1)); dydt(2) = dydt(2) + u/(m*l^2);",
    ],
)
def test_the_first_value_proves_nothing(body: str, tmp_path: Path) -> None:
    assert worst(body, tmp_path) is not Verdict.PROVED


def test_an_acceleration_is_what_it_is_at_the_end() -> None:
    text = "thetadd = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);\nthetadd = {}*thetadd;"
    assert check(truth(), text.format("1"), blame=False).verdict is Verdict.PROVED
    assert check(truth(), text.format("2"), blame=False).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "body",
    [
        "y = flipud(y); dydt = [y(1); 3*g/(2*l)*sin(y(2)) + 3*u/(m*l^2)];",
    ],
)
def test_what_uses_a_value_that_is_not_read_has_no_verdict(body: str, tmp_path: Path) -> None:
    try:
        verdict = worst(body, tmp_path)
    except InputError:
        return  # nothing of it is read
    assert verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "body",
    [
        f"if y(1) > 0\nk = 1;\nelse\nk = 1 + u;\nend\n{RATE}",
        f"k = 1 + u;\nif y(1) > 0\nk = 1;\nend\n{RATE}",
    ],
)
def test_a_branch_that_is_wrong_is_refuted(body: str, tmp_path: Path) -> None:
    assert worst(body, tmp_path) is Verdict.REFUTED
