"""What the entries of q, u, inputs and p are: name, unit, meaning, typical value, in order.

Units of coordinates are not declared; they follow from use: what turns a frame or stands under a
sine is an angle, everything else a length. An input takes the unit of the load that holds it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import sympy
from sympy import Expr, Symbol

from mechanics.equations import Equations
from mechanics.errors import ValueMissingError
from mechanics.kinematics import chain
from mechanics.kinematics.outputs import output_functions, output_matrix
from mechanics.mechanism import GROUND, Mechanism, inputs_of, lower
from mechanics.program.builder import Builder, Node
from mechanics.program.operations import COS, SIN, TAN
from mechanics.program.program import reachable
from mechanics.routes.rows import acceleration_forms
from mechanics.scene import Scene
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS, plain_symbol
from mechanics.scene.units import ratios, rolled

# Digits for the value of an expression such as pi/4: more than a double has, so that rounding
# it once gives the nearest double.
DIGITS = 40

CIRCULAR = (SIN, COS, TAN)

STATE = ("q", "u", "inputs", "p")
"""The arrays that every function takes."""


@dataclass(frozen=True)
class Quantity:
    """One entry of an array.

    Attributes
    ----------
    unit : str
        SI; empty where it is not known.
    """

    symbol: Symbol
    unit: str
    meaning: str = ""
    positive: bool = False

    @property
    def name(self) -> str:
        """Plain name, as the scene gives it."""
        return str(self.symbol.name)


@dataclass(frozen=True)
class Quantities:
    """Entries of every array of a model, in order.

    Attributes
    ----------
    q, u, ud, inputs, p, multipliers, reactions : tuple of Quantity
        Coordinates, speeds, their rates, inputs (with the rates of them that occur, and time if it
        is in the scene), parameters, multipliers that stay, and all reactions that are known.
    definitions : mapping of Symbol to Expr
        Of the scene.
    """

    q: tuple[Quantity, ...]
    u: tuple[Quantity, ...]
    ud: tuple[Quantity, ...]
    inputs: tuple[Quantity, ...]
    p: tuple[Quantity, ...]
    multipliers: tuple[Quantity, ...]
    reactions: tuple[Quantity, ...]
    definitions: Mapping[Symbol, Expr]

    @property
    def h(self) -> tuple[Quantity, ...]:
        """The length of a step of integration."""
        return (Quantity(Symbol("h"), "s", "length of the step"),)

    @cached_property
    def typical(self) -> tuple[float, ...]:
        """Typical value of each parameter, the nearest double.

        Raises
        ------
        ValueMissingError
            For a parameter without a typical value or definition; it is named.
        """
        return tuple(typical_value(entry.symbol, self.definitions) for entry in self.p)


def quantities(
    equations: Equations,
    fixed: Mapping[Symbol, Expr] | None = None,
    with_reactions: bool = True,
) -> Quantities:
    """Names, units and orders for the functions of a set of equations.

    Parameters
    ----------
    fixed : mapping of Symbol to Expr, optional
        Values of parameters that are no longer given.
    with_reactions : bool
        Whether reactions are asked for; they are not solved for otherwise.
    """
    known = dict(fixed or {})
    scene, mechanism = equations.scene, mechanism_of(equations)
    turning_q = {s for s in scene.q if s.name in angles(mechanism)} - rolled(scene)

    of_places = ratios(scene) - turning_q

    def motion(symbols: Iterable[Symbol], turning: set[Symbol], order: int) -> tuple[Quantity, ...]:
        per = ("", "/s", "/s^2")[order]
        plain = of_places if order == 0 else shrinking
        return tuple(
            Quantity(s, ("rad" if s in turning else "1" if s in plain else "m") + per)
            for s in symbols
        )

    turning = {u for u in scene.u if _turns(scene, u, turning_q)}
    rates = {ud for u, ud in zip(scene.u, scene.ud, strict=True) if u in turning}
    shrinking = {u for u in scene.u if _turns(scene, u, of_places)} - turning
    shrinking |= {ud for u, ud in zip(scene.u, scene.ud, strict=True) if u in shrinking}
    declared = {
        r.symbol: Quantity(r.symbol, "N m" if r.at is None else "N") for r in scene.reactions
    }
    definitions = {
        s: sympy.sympify(e).xreplace(known) for s, e in scene.definitions.items() if s not in known
    }
    told: list[Symbol] = []
    if with_reactions:
        written = equations.textbook is not None
        told = (
            [s for s, _ in equations.reactions] if written else [r.symbol for r in scene.reactions]
        )
    return Quantities(
        q=tuple(
            replace(e, unit="1") if e.symbol in scene.quaternions else e
            for e in motion(scene.q, turning_q, 0)
        ),
        u=motion(scene.u, turning, 1),
        ud=motion(scene.ud, rates, 2),
        inputs=tuple(
            _input(mechanism, symbol) for symbol in input_symbols(equations, with_reactions)
        ),
        p=tuple(_parameter(symbol) for symbol in scene.parameters if symbol not in known),
        multipliers=tuple(
            declared.get(s, Quantity(s, "", "multiplier")) for s in equations.multipliers
        ),
        reactions=tuple(declared.get(s, Quantity(s, "N")) for s in told),
        definitions=definitions,
    )


def mechanism_of(equations: Equations) -> Mechanism:
    """The scene of some equations as nodes."""
    return equations.mechanism or lower(equations.scene, Builder())


def typical_value(symbol: Symbol, definitions: Mapping[Symbol, Expr]) -> float:
    """The nearest double to the typical value of a parameter; definitions are evaluated.

    Raises
    ------
    ValueMissingError
        Naming the parameter.
    """
    return float(_exact_value(symbol, definitions).evalf(DIGITS))


def _exact_value(symbol: Symbol, definitions: Mapping[Symbol, Expr]) -> Expr:
    if symbol in definitions:
        expression = sympy.sympify(definitions[symbol])
        free = expression.free_symbols
        return expression.xreplace({s: _exact_value(s, definitions) for s in free})
    exact: Expr | None = getattr(symbol, "exact", None)
    if exact is None:
        raise ValueMissingError(
            f"parameter {symbol}: a number is needed and it has no typical value: pass one, or"
            " declare it with parameters(..., typical=...)"
        )
    return exact


def angles(mechanism: Mechanism) -> set[str]:
    """Inputs that turn a body, or stand under a sine or in the angle of a torsion spring."""
    turns: list[Node] = []
    moves: list[Node] = []
    for body in mechanism.bodies:
        if body.frame is not None:
            turns += _rotations(mechanism, body.frame)
        place = body.centre
        while place != GROUND:
            for frame, step in mechanism.points[place].step:
                moves += [*step, *_rotations(mechanism, frame)]
            place = mechanism.points[place].parent
    turns += [torsion.angle for torsion in mechanism.torsions]
    build = mechanism.builder
    numbers = reachable(build, [node.number for node in moves])
    turns += [Node(build, build.operands[0][n]) for n in numbers if build.operations[n] in CIRCULAR]
    return names_of(turns)


def _rotations(mechanism: Mechanism, frame: int) -> list[Node]:
    """Entries of all rotations from the ground to a frame."""
    found: list[Node] = []
    while frame != GROUND:
        found += [entry for row in mechanism.frames[frame].rotation for entry in row]
        frame = mechanism.frames[frame].parent
    return found


def names_of(nodes: Iterable[Node]) -> set[str]:
    """Names of the inputs that nodes are computed from."""
    return {node.builder.inputs[node.builder.operands[0][node.number]] for node in inputs_of(nodes)}


def _turns(scene: Scene, speed: Symbol, angles: set[Symbol]) -> bool:
    """Whether a speed is in rad/s: the rate of an angle, or one that only drives such rates."""
    rates = zip(scene.q, (scene.coordinate_rates[qd] for qd in scene.qd), strict=True)
    driven = [q for q, rate in rates if speed in rate.free_symbols]
    return any(q in angles for q in driven)


def input_symbols(equations: Equations, with_reactions: bool = False) -> list[Symbol]:
    """Inputs in the scene's order, then their rates up to the highest that occurs, then time.

    Time is there wherever the scene writes it, though it may cancel in the equations of a route.
    Energies and momenta hold the lower rates where the equations hold a higher one.
    """
    scene = equations.scene
    orders = range(1, len(DOTS))
    given = {plain_symbol(f, k) for f in scene.inputs for k in orders}
    used = _used(equations, given) | _moving(equations, given) if given else set()
    if with_reactions:
        for _, expression in equations.reactions:
            used |= expression.free_symbols
    found = list(scene.input_symbols)
    highest = {f: max((k for k in orders if plain_symbol(f, k) in used), default=0)
               for f in scene.inputs}  # fmt: skip
    for order in orders:
        found += [plain_symbol(f, order) for f in scene.inputs if order <= highest[f]]
    return found + ([TIME] if scene.explicit_time else [])


def _used(equations: Equations, given: set[Symbol]) -> set[Symbol]:
    """Those of the given symbols that the equations hold."""
    if equations.textbook is None and equations.rows is not None:
        closing = acceleration_forms(mechanism_of(equations))
        rows = equations.rows
        held = names_of((*rows.values, *closing, *rows.reactions.values()))
        return {symbol for symbol in given if symbol.name in held}
    left, right = equations.system
    return (left.free_symbols | right.free_symbols) & given


def _moving(equations: Equations, given: set[Symbol]) -> set[Symbol]:
    """Those that the outputs of the scene hold."""
    mechanism = mechanism_of(equations)
    motions = chain.motions(mechanism)
    held = names_of(
        entry
        for of in output_functions(mechanism).values()
        for row in output_matrix(mechanism, motions, *of)[1]
        for entry in row
    )
    return {symbol for symbol in given if symbol.name in held}


def _input(mechanism: Mechanism, symbol: Symbol) -> Quantity:
    if symbol == TIME:
        return Quantity(symbol, "s", "time")
    for push in mechanism.pushes:
        if symbol.name in names_of(entry for _, step in push.vector for entry in step):
            return Quantity(symbol, "N m" if push.at is None else "N", f"load {push.name}")
    return Quantity(symbol, "", "prescribed")


def _parameter(symbol: Symbol) -> Quantity:
    return Quantity(
        symbol,
        getattr(symbol, "unit", ""),
        getattr(symbol, "meaning", ""),
        positive=bool(symbol.is_positive),
    )
