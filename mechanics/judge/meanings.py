"""What a word such as "tension" can be in a scene: each reaction, each moment, each momentum.

    tension             a reaction, up to direction, or a component of one in the axes of a body
    torque              moment of the loads about a point that rests, up to direction
    angular momentum    of all bodies or of one, about a point that rests or its mass centre
    frequency, period   of small oscillations about an equilibrium
effective potential V - T0 of a prescribed motion, T0 the kinetic energy where nothing else moves
    speed               |v| of a mass centre        power    d(T + V)/dt along the motion

A candidate is compared with what was written by the kernel; nothing here is believed.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

from sympy import Add, Expr, S, Symbol, pi
from sympy.physics.vector import ReferenceFrame, Vector

from mechanics.checks.ledger_energy import energy_of
from mechanics.claims.about import ENTRIES, QUANTITIES, named_quantity
from mechanics.claims.convention import Table
from mechanics.equations import Equations
from mechanics.judge.converted_rows import slopes_of
from mechanics.kinematics.symbolic import Kinematics
from mechanics.linear.small_oscillations import SQUARE, oscillations
from mechanics.scene import RigidBody, Scene
from mechanics.scene import quantities as q
from mechanics.scene.loads import Damper
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.published import Published, Quantity
from mechanics.scene.rates import rate, rate_table
from mechanics.scene.reactions import Reaction
from mechanics.symbolic import is_zero

UNITS: dict[str, str] = {
    **dict.fromkeys(("kinetic energy", "potential energy", "energy"), "J"),
    **dict.fromkeys(("Lagrangian", "Hamiltonian", "effective potential"), "J"),
    "tension": "N", "torque": "N*m", "period": "s",
    **{f"momentum along {axis}": "kg*m/s" for axis in "xyz"},
    **dict.fromkeys(("frequency", "turns per second"), "1/s"), "speed": "m/s",
    "angular momentum": "kg*m^2/s", "momentum": "kg*m/s",
    **dict.fromkeys(("power", "Rayleigh's function", "dissipated power"), "W"),
}  # fmt: skip
"""Of what a word means; a reaction is a force or a couple."""


ROOT = Symbol("root", real=True)
SQUARES: dict[str, Expr] = {
    "frequency": ROOT**2, "turns per second": (2 * pi * ROOT) ** 2, "period": (2 * pi / ROOT) ** 2,
}  # fmt: skip
"""The square of a frequency, of what a word says of it."""
OF_DRIVE = ", of a drive under which it swings widest"
NO_TABLE: Table = {}
OF_COORDINATES = ("momentum", "angular momentum")


@dataclass(frozen=True)
class Candidate:
    """One thing of a scene that a name may mean.

    Attributes
    ----------
    before : tuple of Expr
        Sides that come before those that are written.
    directed : bool
        Whether its direction is a convention of the author's.
    power : int
        To which power what is written is raised: 2 where the sign is not told.
    vanishing : Expr or None
        What is 0 with what is written in place of `ROOT`.
    rest : Expr
        What is written is the quantity without.
    """

    words: str
    quantity: Quantity
    before: tuple[Expr, ...] = ()
    directed: bool = False
    power: int = 1
    vanishing: Expr | None = None
    rest: Expr = S.Zero

    def rows(self, row: Published, sides: tuple[Expr, ...]) -> Iterator[Published]:
        """The row with this meaning; in both directions where the author may choose one."""
        if self.vanishing is not None:
            # A frequency is no negative number: w = -sqrt(k/m) is said to be its magnitude.
            held = (-2 * s if s.is_negative else self.vanishing.subs(ROOT, s) for s in sides)
            yield replace(row, quantity=self.quantity, sides=(*held, S.Zero))
            return
        for sign in (1, -1) if self.directed else (1,):
            meant = tuple(sign * side**self.power + self.rest for side in sides)
            yield replace(row, quantity=self.quantity, sides=(*self.before, *meant))


def candidates(truth: Equations, words: str, table: Table = NO_TABLE) -> Iterator[Candidate]:
    """All that a word can be in a scene, the likeliest first.

    Parameters
    ----------
    words : str
        One of `mechanics.claims.about.WORDS`.
    table : mapping of Symbol to Expr
        The person's coordinates in the scene's, where they count otherwise.
    """
    slopes = slopes_of(truth.scene, table)
    if words in OF_COORDINATES and not slopes.is_diagonal():
        return  # momenta of coordinates that are mixed: nothing here tells
    if words in QUANTITIES:
        yield Candidate(words, named_quantity(words))
    elif words in ENTRIES:
        mass, (i, j) = truth.kinematics.mass_matrix, ENTRIES[words]
        if max(i, j) < mass.rows:
            own = mass if truth.scene.speeds else slopes.inv().T * mass * slopes.inv()
            yield Candidate(words, q.Identity(), (own[i, j],))
    elif words in SEARCHED:
        yield from SEARCHED[words](truth)


def _reactions(truth: Equations) -> Iterator[Candidate]:
    """Forces and couples."""
    for one in truth.scene.reactions:
        yield Candidate(f"reaction {one.name}", q.ReactionValue(one.name), directed=True)
    yield from _components(truth.scene)


def _tension(truth: Equations) -> Iterator[Candidate]:
    forces = {one.name for one in truth.scene.reactions if one.at is not None}
    for one in _reactions(truth):
        if not isinstance(one.quantity, q.ReactionValue) or one.quantity.name in forces:
            yield replace(one, words=one.words.replace("reaction", "tension"))


def _components(scene: Scene) -> Iterator[Candidate]:
    """Components, in the axes of each body, of forces that a scene gives in other axes."""
    places: dict[tuple[object, str], list[Reaction]] = {}
    for one in scene.reactions:
        if one.at is not None and not one.parts:
            places.setdefault((one.at, one.on), []).append(one)
    frames = [body.frame for body in scene.bodies if isinstance(body, RigidBody)]
    for (point, body), group in places.items():
        for axis, words in _axes(frames) if len(group) > 1 else ():
            unit = scene.vector(axis, words)
            force = Add(*(g.symbol * scene.vector(g.along, g.name).dot(unit) for g in group))
            if len(force.free_symbols & {g.symbol for g in group}) > 1:
                what = f"the force on {body} at {getattr(point, 'name', point)} along {words}"
                yield Candidate(f"reaction: {what}", q.EquationOfMotion(), (force,), directed=True)


def _axes(frames: list[ReferenceFrame]) -> Iterator[tuple[Vector, str]]:
    for frame in dict.fromkeys(frames):
        for axis, name in zip((frame.x, frame.y, frame.z), "xyz", strict=True):
            yield axis, f"{frame.name}.{name}"


def _moments(truth: Equations) -> Iterator[Candidate]:
    bodies, points = _all(truth.scene), _resting(truth.scene)
    for point in points:
        for axis in _turning(truth.scene):
            words = f"the torque about {point} along {axis}"
            yield Candidate(words, q.Moment(bodies, point, axis), directed=True)


def _angular_momenta(truth: Equations) -> Iterator[Candidate]:
    scene = truth.scene
    for point in _resting(scene):
        for axis in _turning(scene):
            words = f"the angular momentum about {point} along {axis}"
            yield Candidate(words, q.AngularMomentum(_all(scene), point, axis), directed=True)
    for body in scene.bodies:
        for axis in _turning(scene) if isinstance(body, RigidBody) else ():
            words = f"the angular momentum of {body.name} along {axis}"
            yield Candidate(words, q.AngularMomentum(body.name, None, axis), directed=True)
    yield from _generalized(truth)


def _momenta(truth: Equations) -> Iterator[Candidate]:
    for axis in "xyz":
        words = f"the momentum along {axis}"
        yield Candidate(words, q.Momentum(_all(truth.scene), axis), directed=True)
    yield from _generalized(truth)


def _generalized(truth: Equations) -> Iterator[Candidate]:
    for symbol in momentum_symbols(truth.scene).values():
        words = f"the generalized momentum of {symbol.name}"
        yield Candidate(words, q.GeneralizedMomentum(symbol.name), directed=True)


def _speeds(truth: Equations) -> Iterator[Candidate]:
    for name, body in truth.kinematics.bodies.items():
        velocity = body.centre.velocity
        yield Candidate(f"the speed of {name}", q.Identity(), (velocity.dot(velocity),), power=2)


def _power(truth: Equations) -> Iterator[Candidate]:
    """Of what has no potential: what the energy gains along the motion."""
    scene = truth.scene
    energy = energy_of(truth.kinematics, q.TotalEnergy())
    gained = rate(energy, rate_table(scene))
    yield Candidate("the power of the loads", q.EquationOfMotion(), (gained,), directed=True)


def _effective(truth: Equations) -> Iterator[Candidate]:
    """Of a prescribed motion, Jacobi's integral T2 + V - T0 without T2."""
    scene, energy = truth.scene, truth.kinematics.energy_in_rates
    still = energy.xreplace(dict.fromkeys(scene.qd, S.Zero))
    if not is_zero(still) and not scene.speeds:
        pairs = ((a, b) for a in scene.qd for b in scene.qd)
        square = Add(*(a * b * energy.diff(a, b) for a, b in pairs)) / 2
        yield Candidate("the effective potential V - T0", q.Hamiltonian(), rest=square)


def _dissipation(truth: Equations) -> Iterator[Candidate]:
    for candidate in _dissipated(truth):
        half = tuple(side / 2 for side in candidate.before)
        yield replace(candidate, words="Rayleigh's function", before=half)


def _dissipated(truth: Equations) -> Iterator[Candidate]:
    scene = truth.scene
    dampers = [load for load in scene.loads if isinstance(load, Damper)]
    if dampers:
        power = Add(*(_damped(truth.kinematics, load) for load in dampers))
        yield Candidate("the power that dampers dissipate", q.Identity(), (power,))


def _damped(kinematics: Kinematics, load: Damper) -> Expr:
    """c times the square of the speed at which the ends part."""
    scene = kinematics.scene
    span = scene.position(load.second) - scene.position(load.first)
    velocity = span.applyfunc(lambda entry: rate(entry, rate_table(scene)))
    coefficient = scene.plain(load.coefficient, load.name)
    if load.along is not None:
        return coefficient * velocity.dot(scene.vector(load.along, load.name)) ** 2
    return coefficient * span.dot(velocity) ** 2 / span.dot(span)


def _oscillations(word: str, truth: Equations) -> Iterator[Candidate]:
    what, square = word.replace("turns", "number"), SQUARES[word]
    for one in oscillations(truth):
        words = f"the {what} of small oscillations about {one.place}"
        without = "" if one.damped is None else ", without damping"
        kinds = (without, one.natural), (", with damping", one.damped), (OF_DRIVE, one.resonant)
        for kind, vanishing in kinds:
            if vanishing is not None:
                zero = vanishing.subs(SQUARE, square)
                yield Candidate(words + kind, q.Identity(), vanishing=zero)


def _along(axis: str, truth: Equations) -> Iterator[Candidate]:
    yield Candidate(f"the momentum along {axis}", q.Momentum(_all(truth.scene), axis))


SEARCHED: dict[str, Callable[[Equations], Iterator[Candidate]]] = {
    "reaction": _reactions, "tension": _tension, "torque": _moments,
    "angular momentum": _angular_momenta, "momentum": _momenta, "speed": _speeds,
    **{word: partial(_oscillations, word) for word in SQUARES},
    **{f"momentum along {axis}": partial(_along, axis) for axis in "xyz"},
    "effective potential": _effective, "power": _power, "Rayleigh's function": _dissipation,
    "dissipated power": _dissipated,
}  # fmt: skip
"""What a word can be, by the word."""


def _all(scene: Scene) -> tuple[str, ...]:
    return tuple(body.name for body in scene.bodies)


def _resting(scene: Scene) -> list[str]:
    """Points that no coordinate moves: the origin, and where reactions act."""
    points = [scene.origin, *(one.at for one in scene.reactions if one.at is not None)]
    still = (p for p in dict.fromkeys(points) if not scene.position(p).free_symbols & {*scene.q})
    return [point.name for point in still]


def _turning(scene: Scene) -> str:
    """Axes about which bodies can turn: z where the scene is planar."""
    planar = all(scene.position(body.centre)[2] == S.Zero for body in scene.bodies)
    return "z" if planar else "xyz"
