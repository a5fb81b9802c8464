"""A scene as numbers on paper: p = P r, with the values of one state and typical parameters.

A scene that keeps the plane z = 0 is seen along z, any other along (-1, -1, -1), z upwards.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import Any

import numpy as np
from sympy import Expr, Matrix, Symbol, sympify
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.program import Builder, Program, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.sympy_reader import read
from mechanics.scene import Gravity, Scene, Spring
from mechanics.scene.rates import TIME

ISOMETRIC = np.array([[-0.7071, 0.7071, 0.0], [-0.4082, -0.4082, 0.8165]])
FRONT = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
# Arrows of inputs and of parameters without a typical value need some length.
UNKNOWN = 1.0
ARRAYS = Arrays()


def _program(entries: tuple[Any, ...], by: Symbol | None = None) -> Program:
    """Expressions in plain symbols as a program, or their derivatives by a symbol."""
    builder = Builder()
    shown = entries if by is None else [sympify(entry).diff(by) for entry in entries]
    return builder.program({"entries": read(builder, shown)})


@dataclass(frozen=True)
class View:
    """A scene at one state, seen on paper.

    Parameters
    ----------
    scene : Scene
    state : mapping of str to float
        Values by plain name; what is missing is 0 for coordinates and speeds.
    known : mapping of Symbol to float, optional
        Parameters, where another view of the scene has them already, see `at`.
    apart : mapping of Point to ndarray, optional
        The shifts of `slack` that another view has: they are the same at all states of a motion.
    program : callable, optional
        `_program`, with what it made: the same are asked for at all states of a motion.
    """

    scene: Scene
    state: Mapping[str, float]
    known: Mapping[Symbol, float] | None = None
    apart: Mapping[Point, np.ndarray] | None = None
    program: Callable[..., Program] = field(default_factory=lambda: cache(_program))

    def at(self, state: Mapping[str, float]) -> "View":
        """The scene at another state."""
        return View(self.scene, state, self.constants, self.slack, self.program)

    @cached_property
    def constants(self) -> Mapping[Symbol, float]:
        """A number for every parameter."""
        return self.known or {symbol: self._constant(symbol) for symbol in self.scene.parameters}

    @cached_property
    def values(self) -> dict[Symbol, float]:
        """A number for every symbol of the scene."""
        scene = self.scene
        table = dict(self.constants)
        table |= {symbol: UNKNOWN for symbol in scene.input_symbols}
        for symbol in (*scene.q, *scene.qd, *scene.u, *scene.ud):
            table[symbol] = float(self.state.get(symbol.name, 0.0))
        # Where the scene holds the time, it is seen at the start.
        return {TIME: 0.0, **table}

    @cached_property
    def inputs(self) -> dict[str, float]:
        """The same by name."""
        return {symbol.name: value for symbol, value in self.values.items()}

    def _constant(self, symbol: Symbol) -> float:
        """A parameter by its definition, else its typical value."""
        definition = self.scene.definitions.get(symbol)
        if definition is not None:
            plain = self.scene.plain(definition)
            return float(plain.evalf(subs={s: self._constant(s) for s in plain.free_symbols}))
        typical = getattr(symbol, "typical", None)
        return UNKNOWN if typical is None else float(typical)

    @cached_property
    def planar(self) -> bool:
        """Whether every mass centre keeps the plane z = 0 and every body turns about z only."""
        positions = [self.scene.position(body.centre)[2] for body in self.scene.bodies]
        frames = [body.frame for body in self.scene.bodies if hasattr(body, "frame")]
        normals = [self.scene.rotation(frame)[2, 2] - 1 for frame in frames]
        return all(entry == 0 for entry in (*positions, *normals))

    @cached_property
    def down(self) -> np.ndarray | None:
        """Direction of gravity on paper, or None."""
        for load in self.scene.loads:
            if isinstance(load, Gravity):
                return unit(self.direction(load.field))
        return None

    @cached_property
    def slack(self) -> Mapping[Point, np.ndarray]:
        """Shifts that give springs between free masses a length where the scene has left it out.

        Sources count such displacements from where the springs are slack, and so let all masses
        start at one point.
        """
        if self.apart is not None:
            return self.apart
        found: dict[Point, np.ndarray] = {}
        if self.scene.reactions:
            return found
        largest = max(abs(self.values[q]) for q in self.scene.q)
        for load in self.scene.loads:
            if isinstance(load, Spring) and load.along is not None and load.length == 0:
                along = unit(self.direction(load.along))
                found[load.second] = found.get(load.first, 0.0) + 4 * (largest or 1.0) * along
        return found

    def number(self, expression: Any) -> float:
        """Value of an expression in plain or dynamic symbols."""
        return float(self.numbers(Matrix([self.scene.plain(sympify(expression))]))[0, 0])

    def numbers(self, matrix: Matrix, by: Symbol | None = None) -> np.ndarray:
        """Values of a matrix in plain symbols, or of its derivative by one of them."""
        program = self.program(tuple(matrix), by)
        entries = interpret(program, ARRAYS, self.inputs, release=False)["entries"]
        return np.array(entries, dtype=float).reshape(matrix.shape)

    def project(self, position: np.ndarray) -> np.ndarray:
        """Inertial components to paper, both in m; x to the right, y upwards."""
        return (FRONT if self.planar else ISOMETRIC) @ position.ravel()

    def place(self, point: Point) -> np.ndarray:
        """Inertial components of a point, in m."""
        return self.numbers(self.scene.position(point)).ravel()

    def frame(self, frame: ReferenceFrame) -> np.ndarray:
        """R with v = R v_frame."""
        return self.numbers(self.scene.rotation(frame))

    def point(self, point: Point) -> np.ndarray:
        """A point of the scene on paper."""
        return self.project(self.place(point)) + self.slack.get(point, 0.0)

    def direction(self, vector: Vector) -> np.ndarray:
        """A vector of the scene on paper."""
        return self.project(self.numbers(self.scene.vector(vector)))

    def shift(self, point: Point, coordinate: Symbol) -> np.ndarray:
        """How a point moves on paper with a coordinate: dr/dq."""
        return self.project(self.numbers(self.scene.position(point), coordinate))

    def turns(self, vector: Vector) -> bool:
        """Whether the direction of a vector depends on a coordinate."""
        return bool(self.scene.vector(vector).free_symbols & set(self.scene.q))

    def moves(self, point: Point) -> bool:
        """Whether the point depends on a coordinate or an input."""
        free: set[Expr] = self.scene.position(point).free_symbols
        return bool(free & {*self.scene.q, *self.scene.input_symbols})


def unit(vector: np.ndarray) -> np.ndarray:
    """The vector with length 1; the zero vector stays."""
    length = float(np.hypot(*vector))
    return vector / length if length > 1e-12 else vector


def normal(vector: np.ndarray) -> np.ndarray:
    """The vector turned by a quarter turn counterclockwise."""
    return np.array([-vector[1], vector[0]])
