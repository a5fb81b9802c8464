"""The rod pendulum's equation of motion as people write it, in every input form.

theta'' = 3 g / (2 l) sin theta + 3 u / (m l^2)        of a rod that a torque u swings up

Each function takes what stands for the angle, what stands for the torque, and what is added.
"""

from collections.abc import Callable
from typing import Any

import casadi
import numpy as np
import sympy as sp

import mechanics
from mechanics.report.answer.check import Check
from systems import rod_pendulum

ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
TEXT = "theta'' = 3*g/(2*l)*sin({angle}) + 3*{torque}/(m*l^2) + {more}"
LATEX = r"\ddot\theta = \frac{3 g}{2 l} \sin(ANGLE) + \frac{3 TORQUE}{m l^2} + MORE"
C = """
#include <math.h>
double theta_ddot(double theta, double theta_dot, double u, double m, double l, double g)
{
    return 3*g/(2*l)*sin(%s) + 3*%s/(m*l*l) + %s;
}
"""
Part = Callable[[Any], Any]


def same(x: Any) -> Any:
    return x


def nothing(theta: Any) -> Any:
    return 0


def of_text(angle: str = "theta", torque: str = "u", more: str = "0", **options: Any) -> Check:
    text = TEXT.format(angle=angle, torque=torque, more=more)
    return mechanics.check(ROD, text, blame=False, notation="text", **options)


def of_latex(angle: str = r"\theta", torque: str = "u", more: str = "0", **options: Any) -> Check:
    text = LATEX.replace("ANGLE", angle).replace("TORQUE", torque).replace("MORE", more)
    return mechanics.check(ROD, text, blame=False, **options)


def of_c(angle: str = "theta", torque: str = "u", more: str = "0", **options: Any) -> Check:
    return mechanics.check(ROD, C % (angle, torque, more), blame=False, notation="c", **options)


def of_python(
    angle: Part = same, torque: Part = same, more: Part = nothing, **options: Any
) -> Check:
    def theta_ddot(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        first = 3 * g / (2 * l) * np.sin(angle(theta))
        return first + 3 * torque(u) / (m * l * l) + more(theta)

    return mechanics.check(ROD, theta_ddot, blame=False, **options)


def of_casadi(
    angle: Part = same, torque: Part = same, more: Part = nothing, **options: Any
) -> Check:
    names = ("theta", "theta_dot", "u", "m", "l", "g")
    theta, _, u, m, l, g = symbols = [casadi.SX.sym(name) for name in names]
    first = 3 * g / (2 * l) * casadi.sin(angle(theta))
    value = first + 3 * torque(u) / (m * l * l) + more(theta)
    function = casadi.Function("theta_ddot", symbols, [value], list(names), ["theta_ddot"])
    return mechanics.check(ROD, function, blame=False, **options)


def of_sympy(
    angle: Part = same, torque: Part = same, more: Part = nothing, **options: Any
) -> Check:
    theta, u, m, l, g, second = sp.symbols("theta u m l g theta_ddot")
    first = 3 * g / (2 * l) * sp.sin(angle(theta))
    right = first + 3 * torque(u) / (m * l**2) + more(theta)
    return mechanics.check(ROD, sp.Eq(second, right, evaluate=False), blame=False, **options)


def outcome(found: Check) -> tuple[str, str]:
    (entry,) = found.judged
    return entry.finding.verdict.name, entry.finding.domain
