"""Poles in numbers against what is said of them.

    all conditions positive  <=>  no pole has a positive real part                           (1)
    det(M s^2 + C s + K) = det(M_22 s^2) det(M_v s^2 + v C_1 s + g K_0 + v^2 K_2)            (2)

(1) at drawn parameters and where a bisection comes near the border of stability, the poles those
of y' = A y; (2) at drawn parameters and s, M_22 that of
the cyclic coordinates: the momenta of these are kept, so that Routh's reduction takes out s^2 each.
"""

from collections.abc import Sequence
from math import isqrt
from random import Random

import mpmath
import numpy as np
from flint import arb, arb_mat

from benchmarks.faults.deviations import BITS, CLOSE, Point, drawn_point
from mechanics.kernel import Finding, enclose, refuted, supported
from mechanics.kernel.balls import precision
from mechanics.linear.first_order import Array, first_order
from mechanics.linear.form import Linear
from mechanics.linear.speed_form import NAMES, SpeedForm
from mechanics.linear.stability import conditions
from mechanics.program import Builder
from mechanics.program.sympy_reader import read

DRAWS, SPREAD = 12, 3
"""Of parameters, wide enough to come to both sides of a border."""

STEPS = 12
"""By which the distance to the border is halved."""

ROUNDED = 1e-8
DIGITS, FAR = 80, 1e-18
"""Of poles: one that is 0 several times is known to a root of the last digit."""


def check_stability(linear: Linear) -> Finding:
    """Statement (1)."""
    subject = f"{linear.route}: conditions of stability = signs of the poles"
    builder = Builder()
    program = builder.program(
        {"c": read(builder, conditions(linear)), "A": read(builder, tuple(linear.A))}
    )
    names = [*program.inputs, *linear.program.inputs]
    samples: list[tuple[bool, bool]] = []
    sides: dict[bool, Point] = {}
    for draw in range(DRAWS + STEPS):
        point = drawn_point({}, names, f"{draw}", SPREAD)
        if draw >= DRAWS and len(sides) == 2:
            with precision(BITS):
                point = {name: (sides[True][name] + sides[False][name]) / 2 for name in names}
        found = enclose(program, {n: point[n] for n in program.inputs}, BITS)
        state = [(name, value.str(9, radius=False)) for name, value in point.items()]
        matrix = _first_order(linear, point)
        for entry, own in zip(found["A"], matrix.flat, strict=True):
            if abs(float(entry.mid()) - own) > ROUNDED * (1 + abs(own)):
                return refuted(subject, "an entry of A", float(entry.mid()), float(own), state)
        said = all(bool(c > 0) for c in found["c"])
        stable = _largest(found["A"]) < FAR
        if said != stable:
            words = "stable by the conditions, and by the poles"
            return refuted(subject, words, said, stable, state)
        samples.append((said, stable))
        sides[stable] = point
    words = f"the same at {DRAWS} draws, and on the way from a stable to an unstable one"
    return supported(subject, samples, words)


def _first_order(linear: Linear, point: Point) -> Array:
    """A of y' = A y in numbers."""
    found = enclose(linear.program, {n: point[n] for n in linear.program.inputs}, BITS)
    n = len(linear.coordinates)
    mass, damping, stiffness = (
        np.array([float(entry.mid()) for entry in found[name]]).reshape(n, n)
        for name in ("mass", "damping", "stiffness")
    )
    kept = n - len(linear.cyclic)
    matrix, _ = first_order(mass, damping, stiffness, np.zeros((n, 0)), kept, linear.scene.name)
    return matrix


def _largest(entries: Sequence[arb]) -> float:
    """The largest real part of an eigenvalue, by mpmath."""
    size = isqrt(len(entries))
    with mpmath.workdps(DIGITS):
        numbers = [mpmath.mpf(entry.mid().str(DIGITS, radius=False)) for entry in entries]
        matrix = mpmath.matrix([numbers[size * i : size * (i + 1)] for i in range(size)])
        poles, _ = mpmath.eig(matrix)
        return float(max(mpmath.re(pole) for pole in poles))


def check_speed_form(form: SpeedForm, speed: str, gravity: str = "g") -> Finding:
    """Statement (2)."""
    linear, subject = form.linear, "form in v and g: the poles of the linear equations"
    names = [*linear.program.inputs, *form.program.inputs, speed, gravity]
    point = drawn_point({}, names, "form")
    n, kept = len(linear.coordinates), len(linear.coordinates) - len(linear.cyclic)
    with precision(BITS):
        s = arb(Random("s").randint(16, 48)) / 32
        whole, parts = (
            enclose(program, {n: point[n] for n in program.inputs}, BITS)
            for program in (linear.program, form.program)
        )
        mass, damping, stiffness = (
            arb_mat(n, n, list(whole[name])) for name in ("mass", "damping", "stiffness")
        )
        M, C1, K0, K2 = (arb_mat(kept, kept, list(parts[name])) for name in NAMES)
        v, g = point[speed], point[gravity]
        cyclic = arb_mat([[mass[i, j] for j in range(kept, n)] for i in range(kept, n)])
        left = (mass * s**2 + damping * s + stiffness).det()
        right = (cyclic * s**2).det() if kept < n else arb(1)
        right = right * (M * s**2 + C1 * (v * s) + K0 * g + K2 * v**2).det()
        if not left.overlaps(right):
            return refuted(subject, "determinants at a drawn s", left, right)
        return supported(subject, [(arb(left.mid(), CLOSE), right)], "determinants at a drawn s")
