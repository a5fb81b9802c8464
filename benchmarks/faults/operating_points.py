"""Linear equations about states of rest and steady motions: their numbers, and who checks them.

The matrices by every route are compared with the deviations of the exact equations; what is no
steady motion has to be refused.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Rational, Symbol, pi, sin, tan

from benchmarks.faults.deviations import BITS, check_linear, drawn_point
from benchmarks.faults.poles import DRAWS, SPREAD, check_speed_form, check_stability
from mechanics.crosscheck.programs import Programs
from mechanics.errors import InputError
from mechanics.kernel import Finding, enclose
from mechanics.linear import Linear, conditions, linearize, speed_form, stability
from mechanics.program import Builder
from mechanics.program.sympy_reader import read
from mechanics.routes.derivation import ROUTES, as_program
from mechanics.scene import Scene
from systems import cartpole_friction as cart
from systems import rolling_disc

SPEED, TURN = Symbol("v", positive=True), Symbol("Omega", positive=True)
PULL = cart.mu_c * (cart.m_c + cart.m_p) * cart.g


@dataclass(frozen=True)
class Operation:
    """A state of rest or a steady motion of a scene.

    Attributes
    ----------
    at, speeds, inputs : mapping of str to Expr
        For `linearize`; a text stands for a parameter of the scene.
    wrong : mapping of str to Expr
        Coordinates that make it none.
    speed : str
        For `speed_form`; empty where there is none.
    poles : bool
        Whether stability is asked for.
    """

    at: Mapping[str, Any]
    wrong: Mapping[str, Any]
    speeds: Mapping[str, Any] = field(default_factory=dict)
    inputs: Mapping[str, Any] = field(default_factory=dict)
    speed: str = ""
    poles: bool = True


R, LEAN, HEADING = rolling_disc.R, Rational(1, 4), Symbol("w", positive=True)
ROLL = (R * HEADING**2 * tan(LEAN) - 4 * rolling_disc.g * sin(LEAN)) / (6 * R * HEADING)
"""Of a disc that rolls in a circle."""

HANGING = {"x": 0, "y": "-2*L", "a": 0, "b": 0}
OPERATIONS = {
    "rolling_disc": (
        Operation({"lean": 0}, {"lean": LEAN}, {"u2": SPEED / R}, speed="v"),
        Operation({"lean": LEAN}, {"lean": 2 * LEAN}, {"u2": ROLL, "u3": HEADING}, poles=False),
    ),
    "hung plate": (Operation(HANGING, {**HANGING, "b": 1}),),
    "quaternion top": (
        Operation(
            {"e0": 0, "e1": 1, "e2": 0, "e3": 0}, {"e0": 0, "e1": 2, "e2": 0, "e3": 0}, poles=False
        ),
    ),
    "top by Euler angles": (Operation({"a": 0, "b": 0}, {"a": 0, "b": 1}, {"c_dot": TURN}),),
    "cartpole_friction": (
        Operation({"x": 0, "theta": pi}, {"x": 0, "theta": 1}, {"x_dot": SPEED}, {"F": PULL}),
    ),
}


def linear_outcome(name: str, scene: Scene, programs: Programs) -> tuple[dict, list[Finding]]:
    """Numbers of the linear equations by every route, and findings about them."""
    numbers: dict[str, str] = {}
    findings: list[Finding] = []
    known = {f"-2*{p.name}": -2 * p for p in scene.parameters}
    for k, operation in enumerate(OPERATIONS.get(name, ())):
        at, wrong = (
            {q: known.get(value, value) for q, value in place.items()}
            for place in (operation.at, operation.wrong)
        )
        for route in ROUTES:
            equations = as_program(scene, programs.mechanism, programs.route(route.name).rows)
            linear = linearize(equations, at, operation.inputs, speeds=operation.speeds)
            found = dict(_numbers(linear))
            findings.append(check_linear(linear, programs.route("kane")))
            if operation.poles:
                found["stability"] = f"{stability(linear).name} {_stable(linear)}"
                findings.append(check_stability(linear))
            if operation.speed and linear.conjugate:
                form = speed_form(linear, operation.speed)
                found["form"] = f"{form.M} {form.C1} {form.K0} {form.K2}"
                findings.append(check_speed_form(form, operation.speed))
            try:
                wrongly = linearize(equations, wrong, operation.inputs, speeds=operation.speeds)
            except InputError:
                found["refused"] = "yes"
            else:
                found["refused"] = "no"
                findings.append(check_linear(wrongly, programs.route("kane")))
            numbers |= {f"linear {k} {route.name} {key}": value for key, value in found.items()}
    return numbers, findings


def _stable(linear: Linear) -> list[bool]:
    """Whether all conditions are positive, at drawn parameters: other ones may say the same."""
    builder = Builder()
    program = builder.program({"c": read(builder, conditions(linear))})
    points = [drawn_point({}, program.inputs, f"{k}", SPREAD) for k in range(DRAWS)]
    return [all(bool(c > 0) for c in enclose(program, point, BITS)["c"]) for point in points]


def _numbers(linear: Linear) -> Iterator[tuple[str, str]]:
    """Entries of M, C, K, G and E at drawn parameters."""
    point = drawn_point({}, linear.program.inputs)
    found = enclose(linear.program, {n: point[n] for n in linear.program.inputs}, BITS)
    for key, entries in found.items():
        yield key, " ".join(entry.str(20, radius=False) for entry in entries)
    yield "coordinates", f"{linear.coordinates} {linear.cyclic} {linear.speeds}"
