"""What code returns by name, nests, or ends without: no traceback, and no exit of its own."""

from collections.abc import Callable
from importlib import import_module
from math import sin
from pathlib import Path
from typing import Any

import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import double_pendulum
from systems.rod_pendulum import scene

SCENE = scene()


def acceleration(theta: Any, u: Any, m: Any, l: Any, g: Any) -> Any:
    return 3 * g / (2 * l) * sin(theta) + 3 * u / (m * l**2)


def verdict(function: Callable) -> Verdict:
    return check(SCENE, function, blame=False).verdict


def test_keys_of_the_state_are_what_their_values_are_the_rates_of() -> None:
    def right(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        return {"theta_dot": acceleration(theta, u, m, l, g), "theta": theta_dot}

    def exchanged(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        return {"theta_dot": theta_dot, "theta": acceleration(theta, u, m, l, g)}

    assert verdict(right) is Verdict.PROVED
    assert verdict(exchanged) is Verdict.REFUTED


@pytest.mark.parametrize("end", [SystemExit(0), GeneratorExit()], ids=repr)
def test_code_that_ends_the_program_does_not_end_ours(end: BaseException) -> None:
    def leaves(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        raise end

    with pytest.raises(InputError, match=type(end).__name__):
        check(SCENE, leaves)


def test_a_tuple_within_a_tuple_is_refused_in_one_line() -> None:
    def nested(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        return ((theta_dot, (acceleration(theta, u, m, l, g), 3 * g)),)

    with pytest.raises(InputError, match="returns tuple"):
        check(SCENE, nested)


def test_a_residual_that_is_zero_on_one_side_is_not_shown() -> None:
    def one_sided(theta, theta_dot, theta_ddot, u, m, l, g):  # type: ignore[no-untyped-def]
        return max(0, theta_ddot - acceleration(theta, u, m, l, g))

    assert verdict(one_sided) is Verdict.UNDECIDED


PARTS = """from math import sin, cos
def model(phi1, phi2, phi1_dot, phi2_dot, m1, m2, l1, l2, g):
    d = phi1 - phi2
    a, b, c = (m1 + m2)*l1**2, m2*l1*l2*cos(d), m2*l2**2
    M = [[a, b], [b, c]]
    C = [m2*l1*l2*sin(d)*phi2_dot**2, -m2*l1*l2*sin(d)*phi1_dot**2]
    G = [(m1 + m2)*g*l1*sin(phi1), m2*g*l2*sin(phi2)]
    {}
    return {}, C, G
"""


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("line", "mass", "verdict"),
    [
        ("pass", "M", "PROVED"),
        ("M = [[2*a, b], [b, c]]", "M", "REFUTED"),
        ("M = [[a, -b], [-b, c]]; G = [-G[0], -G[1]]", "M", "REFUTED"),
        ("G = [-G[0], -G[1]]", "M", "UNDECIDED"),
        ("M = [[a/l1, b/l1], [b/l2, c/l2]]; C = [C[0]/l1, C[1]/l2]; G = [-G[0]/l1, -G[1]/l2]", "M",
         "UNDECIDED"),
        ("M = [M[1], M[0]]; C = [C[1], C[0]]; G = [-G[1], -G[0]]", "M", "UNDECIDED"),
        ("D = a*c - b*b; Minv = [[c/D, -b/D], [-b/D, a/D]]", "Minv", ""),
    ],
)  # fmt: skip
def test_rows_of_a_manipulator_may_be_divided_or_exchanged(
    line: str, mass: str, verdict: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """M u' + C - G = 0 by rows is right whatever they are multiplied by; a wrong M is not."""
    name = f"parts_{tmp_path.name}"
    (tmp_path / f"{name}.py").write_text(PARTS.format(line, mass))
    monkeypatch.syspath_prepend(tmp_path)
    model = import_module(name).model
    if not verdict:  # an inverse is no mass matrix
        with pytest.raises(InputError, match="say what it is"):
            check(double_pendulum.scene(), model, blame=False)
        return
    assert check(double_pendulum.scene(), model, blame=False).verdict.name == verdict


CUT = "function out = rod(theta, u, m, l, g)\nk = 3/(m*l^2);\nacc = k*(m*g*l/2*sin(theta) + u)%s\n"


@pytest.mark.parametrize(
    ("behind", "expected"),
    [
        (";", "UNDECIDED"),  # as it stands, it returns nothing
        ("/2;", "REFUTED"),
        (";\nout = acc;", "PROVED"),
        (";\nplot(acc);", None),  # it is used
        (";\nk = acc + k;", None),
    ],
)
def test_a_function_that_is_cut_returns_what_it_computes_last(
    behind: str, expected: str | None, tmp_path: Path
) -> None:
    path = tmp_path / "rod.m"
    path.write_text(CUT % behind + "end\n")
    if expected is None:
        with pytest.raises(InputError):
            check(SCENE, path, blame=False)
        return
    found = check(SCENE, path, blame=False)
    assert found.verdict.name == expected
    assert ("computes last" in str(found)) == (expected == "UNDECIDED")
