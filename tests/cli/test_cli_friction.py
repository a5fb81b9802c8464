"""The cart-pole with friction from the command line: exit codes, and one line where it refuses."""

from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.campaign

FLORIAN = r"""
\begin{align}
\ddot{x} &= \frac{F + m_p l (\dot\theta^2 \sin\theta - \ddot\theta\cos\theta)
    - \mu_c N_c \mathrm{sgn}(N_c \dot{x})}{m_c + m_p} \\
\ddot\theta &= \frac{g \sin\theta + \cos\theta \left\{ \frac{-F - m_p l \dot\theta^2 [\sin\theta
    + \mu_c \mathrm{sgn}(N_c\dot{x})\cos\theta]}{m_c+m_p} + \mu_c g\, \mathrm{sgn}(N_c \dot{x})
    \right\} - \frac{\mu_p\dot\theta}{m_p l}}{l \left\{ \frac{4}{3}
    - \frac{m_p\cos\theta}{m_c+m_p}[\cos\theta - \mu_c\,\mathrm{sgn}(N_c\dot{x})REACH]\right\}}
\end{align}
"""


def test_florian_in_latex_with_and_without_the_sine(run: Any, tmp_path: Path) -> None:
    file = tmp_path / "florian.tex"
    file.write_text(FLORIAN.replace("REACH", r"\sin\theta"), encoding="utf-8")
    right = run("check", "cartpole_friction", file)
    assert right.code == 0 and "2 PROVED" in right.out
    file.write_text(FLORIAN.replace("REACH", ""), encoding="utf-8")
    wrong = run("check", "cartpole_friction", file)
    assert wrong.code == 1 and "1 PROVED, 1 REFUTED" in wrong.out
    assert "comes from  load track on cart" in wrong.out


def test_friction_with_the_wrong_sign_is_blamed_on_its_load(run: Any, tmp_path: Path) -> None:
    file = tmp_path / "sign.txt"
    file.write_text(
        "xddot = (F + m_p*l*(thetadot**2*sin(theta) - thetaddot*cos(theta))"
        " + mu_c*N_c*sign(xdot))/(m_c + m_p)\n",
        encoding="utf-8",
    )
    found = run("check", "cartpole_friction", file)
    assert found.code == 1
    assert "write - for +" in found.out and "load track on cart" in found.out


CART = "xddot = (F + m_p*l*(thetadot**2*sin(theta) - thetaddot*cos(theta)) - {})/(m_c + m_p)\n"
POLE = (
    "thetaddot = (g*sin(theta) + cos(theta)*(-F - m_p*l*thetadot**2*sin(theta)"
    " + mu_c*sign(xdot))/(m_c + m_p) - mu_p*thetadot/(m_p*l))"
    "/(l*(4/3 - m_p*cos(theta)**2/(m_c + m_p)))\n"
)
MISTAKES = {
    "weight": (
        CART.format("mu_c*(m_c + m_p)*g*sign(xdot)"),
        "because: friction track uses the value of N_c at rest, not in motion",
    ),
    "1983, cart": (
        CART.format("mu_c*sign(xdot)"),
        "because: friction track is the coefficient alone, without N_c",
    ),
    "1983, pole": (POLE, "because: friction track is the coefficient alone, without N_c"),
}


@pytest.mark.sample(1)
@pytest.mark.parametrize("name", MISTAKES)
def test_friction_that_presses_wrongly_is_named(run: Any, tmp_path: Path, name: str) -> None:
    """Barto, Sutton and Anderson left the normal force out; others take the weight for it."""
    text, words = MISTAKES[name]
    file = tmp_path / "wrong.txt"
    file.write_text(text, encoding="utf-8")
    found = run("check", "cartpole_friction", file)
    assert found.code == 1
    assert words in " ".join(found.out.split())


def test_a_crosscheck_shows_everything(run: Any, tmp_path: Path) -> None:
    page = tmp_path / "friction.html"
    found = run("crosscheck", "cartpole_friction", "--states", 100, "--report", page)
    assert found.code == 0
    assert "pairs of routes: 15 PROVED" in found.out
    assert "published rows: 5 PROVED" in found.out
    assert "has no slope at the operating point" in " ".join(found.out.split())
    assert "sticking is not modelled" in page.read_text(encoding="utf-8")


def test_a_motion_ends_where_sliding_does(run: Any, tmp_path: Path) -> None:
    found = run("simulate", "cartpole_friction", "--duration", 5, "--out", tmp_path / "out.csv")
    assert found.code == 3
    assert "sticking is not modelled" in " ".join((found.out + found.err).split())


@pytest.mark.parametrize("command", ["linearize", "modes", "fmu"])
def test_what_is_not_defined_with_friction_is_refused_in_one_line(
    run: Any, tmp_path: Path, command: str
) -> None:
    extra = ("--out", tmp_path / "unit.fmu") if command == "fmu" else ()
    found = run(command, "cartpole_friction", *extra)
    assert found.code == 2
    assert found.err.startswith("error: ") and found.err.count("\n") == 1
    assert "sign" in found.err.lower() or "friction" in found.err
