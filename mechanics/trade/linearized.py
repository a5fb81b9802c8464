"""The linearized model as equations of motion, in the coordinates of the scene.

    M x'' = -C x' - K x + E_0 w,    x = q - q_0

about the equilibrium q_0 that is nearest to where the motion starts. It is proved to be one, and
the equations are made, by `mechanics.linear`.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product

import numpy as np
from sympy import Expr, Integer, Matrix, Symbol, cos, pi, sin, sympify

from mechanics.equations import Equations, Matrices
from mechanics.errors import ExpressionError, InputError, SingularError
from mechanics.linear import Linear, linearize, numeric_poles
from mechanics.scene import Scene
from mechanics.simulate.consistent import Suggestion

# Candidates are every coordinate at zero or, if it is an angle, at half a turn: 2^n of them, so
# beyond so many angles only those where all of these are alike are tried.
MOST_ANGLES = 6
# Poles whose real part is below this, of the largest magnitude, are on the imaginary axis.
AXIS = 1e-9


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A proved equilibrium and the linear equations about it.

    Attributes
    ----------
    growth : float
        Largest real part of a pole, in 1/s; zero for poles on the imaginary axis.
    distance : float
        Of the start from it, as the largest difference of a coordinate.
    """

    linear: Linear
    growth: float
    distance: float

    @property
    def stable(self) -> bool:
        """Whether no small deviation grows exponentially."""
        return self.growth <= 0.0

    @property
    def place(self) -> str:
        """``"x = 0, theta = 0"``."""
        scene = self.linear.scene
        return ", ".join(f"{q.name} = {self.linear.point[q]}" for q in scene.q)


def equilibria(
    equations: Equations, parameters: Mapping[str, float], near: Suggestion
) -> tuple[Equilibrium, ...]:
    """The nearest equilibrium, and the nearest stable one if that is another, stable ones first.

    Parameters
    ----------
    parameters : mapping of str to float
        What differs from the typical values.
    near : Suggestion
        Coordinates.

    Raises
    ------
    InputError
        If none is found among the places where every coordinate is zero or an angle half a turn,
        or the linear equations are not in the scene's own coordinates.
    """
    if equations.textbook is None:
        raise InputError(
            f"{equations.scene.name}: its equations stay a program, and so would its linear ones:"
            " `mechanics linearize` gives them in numbers"
        )
    _has_own_coordinates(equations)
    found: list[Equilibrium] = []
    why = ""
    places = (place for place in _places(equations, near) if _inside(equations.scene, place))
    for place in sorted(places, key=lambda p: _distance(p, near)):
        try:
            linear = linearize(equations, place, dict.fromkeys(_inputs(equations), Integer(0)))
            at = Equilibrium(linear, _growth(linear, parameters), _distance(place, near))
        except (InputError, ExpressionError, SingularError) as error:
            why = str(error)
            continue
        if at.stable or not found:
            found.insert(0, at)
        if at.stable:
            break
    if not found:
        raise InputError(
            f"{equations.scene.name}: no equilibrium is found where every coordinate is zero, or an"
            f" angle half a turn ({why})"
        )
    return tuple(found)


def linearized(
    equations: Equations,
    parameters: Mapping[str, float],
    suggested: tuple[Suggestion, Suggestion],
) -> Equations:
    """Linear equations about the equilibrium nearest to the start, if possible a stable one."""
    return as_equations(equilibria(equations, parameters, suggested[0])[0].linear)


def as_equations(linear: Linear) -> Equations:
    """Linear equations in the common form, for the coordinates of their scene.

    Raises
    ------
    InputError
        If rates of inputs drive the system.
    """
    scene = linear.scene
    if len(linear.input_matrices) > 1:
        raise InputError(f"{scene.name}: rates of inputs drive the linear equations")
    deviation = Matrix([q - linear.point[q] for q in scene.q])
    drive = Matrix([w - linear.point[w] for w in scene.input_symbols])
    forcing = -linear.damping * Matrix(scene.u) - linear.stiffness * deviation
    if len(drive):
        forcing += linear.input_matrices[0] * drive
    rows, n = linear.mass.shape
    matrices = Matrices(
        linear.mass, forcing, Matrix.zeros(rows, 0), Matrix.zeros(0, n), Matrix.zeros(0, 1)
    )
    route = f"{linear.route}, linearized"
    return Equations(scene, route, (), linear.conjugate, textbook=matrices)


def is_linear(equations: Equations) -> bool:
    """Whether u' is linear in q and u with constant coefficients as it stands.

    True only where M is constant and f linear, which is enough to tell the seed's chain of masses.
    """
    if equations.textbook is None:
        return False
    state = {*equations.scene.q, *equations.scene.u}
    constant = not any(sympify(entry).free_symbols & state for entry in equations.mass)
    slopes = equations.forcing.jacobian([*equations.scene.q, *equations.scene.u])
    return constant and not any(sympify(entry).free_symbols & state for entry in slopes)


def _has_own_coordinates(equations: Equations) -> None:
    scene = equations.scene
    if scene.constraints:
        raise InputError(
            f"{scene.name}: it has constraints: linear equations would be in fewer coordinates"
        )
    if scene.speeds:
        raise InputError(f"{scene.name}: its speeds are not the rates of its coordinates")


def _inputs(equations: Equations) -> list[str]:
    return [w.name for w in equations.scene.input_symbols]


def _places(equations: Equations, near: Suggestion) -> Iterator[dict[str, Expr]]:
    scene = equations.scene
    entries = (*equations.mass, *equations.forcing)
    waves = set().union(*(sympify(entry).atoms(sin, cos) for entry in entries))
    turning: set[Symbol] = set().union(*(wave.free_symbols for wave in waves))
    angles = [q.name for q in scene.q if q in turning]
    resting = {q.name: Integer(0) for q in scene.q}
    combinations: list[tuple[int, ...]] = [(0,) * len(angles), (1,) * len(angles)]
    if len(angles) <= MOST_ANGLES:
        combinations = list(product((0, 1), repeat=len(angles)))
    start = dict(zip(near.names, near.values, strict=True))
    for halves in combinations:
        yield resting | {
            name: half * pi + 2 * pi * round((start[name] / np.pi - half) / 2)
            for name, half in zip(angles, halves, strict=True)
        }


def _inside(scene: Scene, place: Mapping[str, Expr]) -> bool:
    """Whether no condition on coordinates alone says that the model is not valid there."""
    table = {q: place[q.name] for q in scene.q}
    margins = [scene.plain(c.margin, c.name).xreplace(table) for c in scene.conditions]
    return not any(m.is_negative for m in margins if not m.free_symbols)


def _growth(linear: Linear, parameters: Mapping[str, float]) -> float:
    values = {str(key): float(value) for key, value in parameters.items()}
    needed = _names(linear)
    poles = numeric_poles(linear, {k: v for k, v in values.items() if k in needed})
    largest = float(np.max(poles.real))
    return largest if largest > AXIS * float(np.max(np.abs(poles))) else min(largest, 0.0)


def _names(linear: Linear) -> set[str]:
    scene = linear.scene
    inside = {s.name for e in scene.definitions.values() for s in sympify(e).free_symbols}
    return {s.name for s in (*scene.parameters, *scene.definitions)} | inside


def _distance(place: Mapping[str, Expr], near: Suggestion) -> float:
    pairs = zip(near.names, near.values, strict=True)
    return max(abs(float(place[name]) - value) for name, value in pairs)
