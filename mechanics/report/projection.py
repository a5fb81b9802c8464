"""A scene as numbers on paper: p = P r, with the values of one state and typical parameters.

A scene that keeps the plane z = 0 is seen along z, any other along (-1, -1, -1), z upwards. Where
gravity would point up, the scene is turned about x by half a turn first.
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
from mechanics.scene import Body, Damper, Gravity, Scene, Spring
from mechanics.scene.actions import carrier_of
from mechanics.scene.joints import Rope
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import plain_symbol

ISOMETRIC = np.array([[-0.7071, 0.7071, 0.0], [-0.4082, -0.4082, 0.8165]])
FRONT = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
TURNED = np.diag([1.0, -1.0, -1.0])
# Inputs that move points are at rest.
# Arrows of other inputs and of parameters without a typical value need some length.
UNKNOWN = 1.0
ITERATIONS = 40
PLACES = 480
"""Along a motion, at most."""
STACKED = 0.22
"""Parts of the width of a scene between bodies that springs hold above each other."""
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
        Values by plain name; coordinates and speeds that are missing are 0, quaternions no turn,
        inputs of a length that can be drawn.
    known : mapping of Symbol to float, optional
        Parameters, where another view of the scene has them already, see `at`.
    apart : mapping of Point to ndarray, optional
        The shifts of `slack` that another view has: they are the same at all states of a motion.
    program : callable, optional
        `_program`, with what it made: the same are asked for at all states of a motion.
    motion : mapping of str to array, optional
        Coordinates along a motion, by plain name: where points go, see `way`.
    """

    scene: Scene
    state: Mapping[str, float]
    known: Mapping[Symbol, float] | None = None
    apart: Mapping[Point, np.ndarray] | None = None
    program: Callable[..., Program] = field(default_factory=lambda: cache(_program))
    motion: Mapping[str, Any] | None = None

    def at(self, state: Mapping[str, float]) -> "View":
        """The scene at another state."""
        return View(self.scene, state, self.constants, self.slack, self.program, self.motion)

    @cached_property
    def constants(self) -> Mapping[Symbol, float]:
        """A number for every parameter."""
        return self.known or {symbol: self._constant(symbol) for symbol in self.scene.parameters}

    @cached_property
    def values(self) -> dict[Symbol, float]:
        """A number for every symbol of the scene."""
        scene = self.scene
        table = dict(self.constants)
        places = [scene.position(point).free_symbols for point in self.loaded]
        shaking = set[Symbol]().union(*places)
        rest = {s: 0.0 if s in shaking else UNKNOWN for s in scene.input_symbols}
        table |= {s: float(self.state.get(s.name, value)) for s, value in rest.items()}
        for symbol in (*scene.q, *scene.qd, *scene.u, *scene.ud):
            table[symbol] = float(self.state.get(symbol.name, 0.0))
        for rotation in scene.rotations:
            parts = [plain_symbol(part) for part in rotation.coordinates]
            if not any(table[part] for part in parts):
                table[parts[0]] = 1.0
        # Where the scene holds the time, it is seen at the start.
        return {TIME: 0.0, **table}

    @cached_property
    def inputs(self) -> dict[str, float]:
        """The same by name."""
        return {symbol.name: value for symbol, value in self.values.items()}

    @property
    def loaded(self) -> list[Point]:
        """The points at which loads act, on bodies and on the ground."""
        names = ("at", "first", "second")
        ends = (vars(load).get(name) for load in self.scene.loads for name in names)
        return [end for end in ends if isinstance(end, Point)]

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
    def field(self) -> np.ndarray | None:
        """Gravity in inertial components, or None."""
        field = next((g.field for g in self.scene.loads if isinstance(g, Gravity)), None)
        return None if field is None else self.numbers(self.scene.vector(field)).ravel()

    @cached_property
    def projection(self) -> np.ndarray:
        """P, 2 x 3: paper from inertial components."""
        upright = FRONT if self.planar else ISOMETRIC
        turned = self.field is not None and (upright @ self.field)[1] > 1e-9
        return upright @ TURNED if turned else upright

    @property
    def down(self) -> np.ndarray | None:
        """Direction of gravity on paper, or None."""
        return None if self.field is None else unit(self.project(self.field))

    @cached_property
    def slack(self) -> Mapping[Point, np.ndarray]:
        """Shifts that give springs between free masses a length where the scene has left it out.

        Sources count such displacements from where the springs are slack, and so let all masses
        start at one point.
        """
        if self.apart is not None:
            return self.apart
        found: dict[Point, np.ndarray] = {}
        for rope in self.scene.joints:
            if isinstance(rope, Rope):
                self._hang(rope, found)
        if self.scene.reactions:
            self._stack(found)
            return found
        largest = max(abs(self.values[q]) for q in self.scene.q)
        for load in self.scene.loads:
            if isinstance(load, Spring) and load.along is not None and load.length == 0:
                along = unit(self.direction(load.along))
                found[load.second] = found.get(load.first, 0.0) + 4 * (largest or 1.0) * along
        return found

    def _stack(self, found: dict[Point, np.ndarray]) -> None:
        """Bodies on springs above each other, where the scene counts them from one place."""
        scene, rest = self.scene, View(self.scene, {}, self.constants, {}, self.program)
        springs = [s for s in scene.loads if isinstance(s, Spring) and _is_between_places(s, rest)]
        if not any(rest.swings(spring.first) for spring in springs):
            return
        wide = [rest.point(point)[0] for body in scene.bodies for point in attached(scene, body)]
        step = STACKED * float(np.ptp(wide)) or UNKNOWN
        for _ in springs:
            for spring in springs:
                if spring.first in found or not rest.swings(spring.first):
                    carrier = carrier_of(scene, spring, spring.second, spring.second_on)
                    shift = found.get(spring.first, 0.0) + step * unit(rest.direction(spring.along))
                    for point in attached(scene, scene.body(str(carrier))):
                        found.setdefault(point, shift)

    def _hang(self, rope: Rope, found: dict[Point, np.ndarray]) -> None:
        """The ends of a rope beside each other, where the scene has all of it on one line."""
        ends = [point for _, point in rope.ends]
        places = np.array([self.point_itself(point) for point in ends])
        if len(ends) != 3 or np.ptp(places[:, 0]) > 1e-9:
            return
        wide = np.ptp(places[:, 1]) / 3 or UNKNOWN
        middle = found.setdefault(ends[1], np.zeros(2))
        for end, sign in ((ends[0], -1), (ends[2], 1)):
            found[end] = middle + sign * np.array([wide, 0.0])

    def number(self, expression: Any) -> float:
        """Value of an expression in plain or dynamic symbols."""
        return float(self.numbers(Matrix([self.scene.plain(sympify(expression))]))[0, 0])

    def numbers(self, matrix: Matrix, by: Symbol | None = None) -> np.ndarray:
        """Values of a matrix in plain symbols, or of its derivative by one of them."""
        program = self.program(tuple(matrix), by)
        with np.errstate(all="ignore"):  # a quotient may have no value at this state
            entries = interpret(program, ARRAYS, self.inputs, release=False)["entries"]
        return np.array(entries, dtype=float).reshape(matrix.shape)

    def project(self, position: np.ndarray) -> np.ndarray:
        """Inertial components to paper, both in m; x to the right, y upwards."""
        projected: np.ndarray = self.projection @ position.ravel()
        return projected

    def place(self, point: Point) -> np.ndarray:
        """Inertial components of a point, in m."""
        return self.numbers(self.scene.position(point)).ravel()

    def frame(self, frame: ReferenceFrame) -> np.ndarray:
        """R with v = R v_frame."""
        return self.numbers(self.scene.rotation(frame))

    def point(self, point: Point) -> np.ndarray:
        """A point of the scene on paper."""
        return self.point_itself(point) + self.slack.get(point, 0.0)

    def way(self, point: Point) -> np.ndarray:
        """The point along the motion on paper, shape (N, 2); where it is, without a motion."""
        count = max(map(len, (self.motion or {}).values()), default=1)
        samples = np.unique(np.linspace(0, count - 1, PLACES).astype(int))
        inputs: dict[str, Any] = dict(self.inputs)
        inputs |= {name: np.asarray(x)[samples] for name, x in (self.motion or {}).items()}
        program = self.program(tuple(self.scene.position(point)))
        entries = interpret(program, ARRAYS, inputs, release=False)["entries"]
        at = np.array([np.broadcast_to(entry, samples.shape) for entry in entries], dtype=float)
        path: np.ndarray = (self.projection @ at).T + self.slack.get(point, 0.0)
        return path

    def point_itself(self, point: Point) -> np.ndarray:
        """The same without a shift."""
        return self.project(self.place(point))

    def direction(self, vector: Vector) -> np.ndarray:
        """A vector of the scene on paper."""
        return self.project(self.numbers(self.scene.vector(vector)))

    def shift(self, point: Point, coordinate: Symbol) -> np.ndarray:
        """How a point moves on paper with a coordinate: dr/dq."""
        return self.project(self.numbers(self.scene.position(point), coordinate))

    def outlines(self, body: Body) -> list[np.ndarray]:
        """What is declared to be drawn of a body, as points on paper: 2 of a line, 49 of others."""
        found = []
        for outline in getattr(body, "outlines", ()):
            at = self.point(body.centre) + self.direction(outline.at)
            first, second = self.direction(outline.first), self.direction(outline.second)
            angles = np.linspace(0, 2 * np.pi, 49) if outline.second.args else np.array([0, np.pi])
            found.append(at + np.outer(np.cos(angles), first) + np.outer(np.sin(angles), second))
        return found

    def turns(self, vector: Vector) -> bool:
        """Whether the direction of a vector depends on a coordinate or the time."""
        return bool(self.scene.vector(vector).free_symbols & {*self.scene.q, TIME})

    def swings(self, point: Point) -> bool:
        """Whether the point depends on a coordinate."""
        return bool(self.scene.position(point).free_symbols & {*self.scene.q})

    def moves(self, point: Point) -> bool:
        """Whether the point depends on a coordinate or an input."""
        free: set[Expr] = self.scene.position(point).free_symbols
        return bool(free & {*self.scene.q, *self.scene.input_symbols})


@dataclass(frozen=True)
class Paper:
    """From metres on paper (y upwards) to pixels (y downwards).

    Attributes
    ----------
    scale : float
        In pixels per m.
    shift, middle : ndarray
        Pixel of the origin, and of the middle of the drawing.
    """

    scale: float
    shift: np.ndarray
    middle: np.ndarray

    def place(self, point: np.ndarray) -> np.ndarray:
        """Pixel of a point."""
        return self.shift + self.scale * point * np.array([1, -1])

    def turn(self, direction: np.ndarray) -> np.ndarray:
        """A direction in pixels, with its length in m."""
        return direction * np.array([1, -1])


def attached(scene: Scene, body: Body) -> list[Point]:
    """The centre of a body and the points where reactions and springs act on it."""
    points = [body.centre]
    for reaction in scene.reactions:
        # A rope acts on its body at the end that is there; the other end is elsewhere.
        bodies = (reaction.on,) if reaction.parts else (reaction.on, reaction.by)
        if body.name in bodies and reaction.at is not None:
            points.append(reaction.at)
    for load in scene.loads:
        if isinstance(load, Spring | Damper):
            for point, stated in ((load.first, load.first_on), (load.second, load.second_on)):
                if carrier_of(scene, load, point, stated) == body.name:
                    points.append(point)
    return points


def _is_between_places(spring: Spring, rest: View) -> bool:
    """Whether a spring along a line has no length at rest."""
    apart = rest.point(spring.first) - rest.point(spring.second)
    return spring.along is not None and spring.length == 0 and float(np.hypot(*apart)) < 1e-9


def closed(
    scene: Scene, state: Mapping[str, float], start: Mapping[str, float] | None = None
) -> Mapping[str, float]:
    """A state whose loops are closed: c(q) = 0 by Newton's method, from where the state is.

    Coordinates that the state names keep their values where the others can close the loops; these
    begin at `start`, or at 0.
    """
    closing = [scene.plain(c.expression) for c in scene.constraints if c.holonomic]
    named = [q for q in scene.q if q.name not in state and q not in scene.quaternions]
    for free in (named, [q for q in scene.q if q not in scene.quaternions]):
        view = View(scene, {**(start or {}), **state})
        slopes = Matrix(closing).jacobian(free) if closing and free else Matrix()
        for _ in range(ITERATIONS if slopes else 0):
            off = view.numbers(Matrix(closing)).ravel()
            if np.max(np.abs(off)) < 1e-10:
                return view.state
            step = np.linalg.lstsq(view.numbers(slopes), off, rcond=None)[0]
            moved = {q.name: view.values[q] - d for q, d in zip(free, step, strict=True)}
            view = view.at({**view.state, **moved})
    return state


def unit(vector: np.ndarray) -> np.ndarray:
    """The vector with length 1; the zero vector stays."""
    length = float(np.hypot(*vector))
    return vector / length if length > 1e-12 else vector


def normal(vector: np.ndarray) -> np.ndarray:
    """The vector turned by a quarter turn counterclockwise."""
    return np.array([-vector[1], vector[0]])
