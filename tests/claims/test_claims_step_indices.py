"""An index of a time step is dropped where all that moves has it; else the names are open."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import elastic_pendulum, rod_pendulum

ROD = derived(rod_pendulum.scene())


def verdict(angle: str, force: str, **how) -> str:
    law = rf"$$\ddot{{{angle}}}=\frac{{3g}}{{2l}}\sin {angle}+\frac{{3{force}}}{{m l^2}}$$"
    return mechanics.check(ROD, law, blame=False, **how).verdict.name


@pytest.mark.parametrize("step", ["", "_k", "_n", "_{k-1}", "_{n+1}"])
def test_one_step_is_read(step: str) -> None:
    assert verdict(rf"\theta{step}", f"u{step}") == "PROVED"


@pytest.mark.parametrize(
    ("angle", "force"),
    [
        (r"\theta_k", "u_{k-1}"), (r"\theta_n", "u_{n+1}"), (r"\theta_{k-1}", "u_{k+1}"),
        (r"\theta_k", "u"), (r"\theta", "u_{k-1}"), (r"\theta_k", "u_n"), (r"\theta_k", "F_{k-1}"),
        (r"\theta_t", r"u_{t-\tau}"), (r"\theta", r"u_{\mathrm{prev}}"),
    ],
)  # fmt: skip
def test_several_steps_are_open(angle: str, force: str) -> None:
    assert verdict(angle, force) == "UNDECIDED"


def test_names_that_are_given_are_taken() -> None:
    names = {"theta_k": "theta", "u_kminus1": "u"}
    assert verdict(r"\theta_k", "u_{k-1}", names=names) == "PROVED"


def test_in_text_and_in_energies() -> None:
    text = "theta_k'' = 3*g/(2*l)*sin(theta_k) + 3*u_km1/(m*l^2)"
    assert mechanics.check(ROD, text, blame=False).verdict.name == "UNDECIDED"
    V = r"$$V=k x_{k+1}^2-\frac12 M g L\cos\theta_k$$"
    found = mechanics.check(elastic_pendulum.scene(), V, blame=False)
    assert found.verdict.name == "UNDECIDED"
    assert "different steps" in found.judged[0].statement.doubt


@pytest.mark.parametrize("force", [r"u_{\max}", r"u_{\mathrm{ref}}", "u_0", "F_0"])
def test_a_bound_or_a_start_is_no_input(force: str) -> None:
    assert verdict(r"\theta", force) == "UNDECIDED"
