"""What the entries of q, u, inputs and p are: name, unit, meaning, typical value, in order.

Units of coordinates are not declared; they follow from use: what turns a frame or stands under a
sine is an angle, everything else a length. An input takes the unit of the load that holds it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import sympy
from sympy import Expr, Symbol

from mechanics.equations import Equations
from mechanics.errors import ValueMissingError
from mechanics.scene import Force, RigidBody, Scene, Torque, TorsionSpring
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS, plain_symbol

# Digits for the value of an expression such as pi/4: more than a double has, so that rounding
# it once gives the nearest double.
DIGITS = 40


@dataclass(frozen=True)
class Quantity:
    """One entry of an array.

    Attributes
    ----------
    symbol : Symbol
    unit : str
        SI; empty where it is not known.
    meaning : str
    positive : bool
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
    equations : Equations
    fixed : mapping of Symbol to Expr, optional
        Values of parameters that are no longer given.
    with_reactions : bool
        Whether reactions are asked for; they are not solved for otherwise.
    """
    known = dict(fixed or {})
    reactions = equations.reactions if with_reactions else ()
    scene = equations.scene
    angles = angle_symbols(equations)

    def motion(symbols: Iterable[Symbol], turning: set[Symbol], order: int) -> tuple[Quantity, ...]:
        per = ("", "/s", "/s^2")[order]
        return tuple(Quantity(s, ("rad" if s in turning else "m") + per) for s in symbols)

    turning = {u for u in scene.u if _turns(scene, u, angles)}
    rates = {ud for u, ud in zip(scene.u, scene.ud, strict=True) if u in turning}
    declared = {
        r.symbol: Quantity(r.symbol, "N m" if r.at is None else "N") for r in scene.reactions
    }
    definitions = {
        s: sympy.sympify(e).xreplace(known) for s, e in scene.definitions.items() if s not in known
    }
    return Quantities(
        q=motion(scene.q, angles, 0),
        u=motion(scene.u, turning, 1),
        ud=motion(scene.ud, rates, 2),
        inputs=tuple(_input(scene, symbol) for symbol in input_symbols(equations, reactions)),
        p=tuple(_parameter(symbol) for symbol in scene.parameters if symbol not in known),
        multipliers=tuple(
            declared.get(s, Quantity(s, "", "multiplier")) for s in equations.multipliers
        ),
        reactions=tuple(declared.get(s, Quantity(s, "N")) for s, _ in reactions),
        definitions=definitions,
    )


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
    typical: Fraction | None = getattr(symbol, "typical", None)
    if typical is None:
        raise ValueMissingError(
            f"parameter {symbol}: a number is needed and it has no typical value: pass one, or"
            " declare it with parameters(..., typical=...)"
        )
    return sympy.Rational(typical.numerator, typical.denominator)


def angle_symbols(equations: Equations) -> set[Symbol]:
    """Coordinates that turn a body, or stand under a sine or in the angle of a torsion spring."""
    scene = equations.scene
    found: set[Symbol] = set()
    for body in scene.bodies:
        if isinstance(body, RigidBody):
            found |= scene.rotation(body.frame).free_symbols
        for entry in scene.position(body.centre):
            for function in entry.atoms(sympy.sin, sympy.cos, sympy.tan):
                found |= function.free_symbols
    for load in scene.loads:
        if isinstance(load, TorsionSpring):
            found |= scene.plain(load.angle, load.name).free_symbols
    return found & set(scene.q)


def _turns(scene: Scene, speed: Symbol, angles: set[Symbol]) -> bool:
    """Whether a speed is in rad/s: the rate of an angle, or one that only drives such rates."""
    rates = zip(scene.q, (scene.coordinate_rates[qd] for qd in scene.qd), strict=True)
    driven = [q for q, rate in rates if speed in rate.free_symbols]
    return any(q in angles for q in driven)


def input_symbols(
    equations: Equations, reactions: Iterable[tuple[Symbol, Expr]] = ()
) -> list[Symbol]:
    """Inputs in the scene's order, then their rates up to the highest that occurs, then time.

    Time is there wherever the scene writes it, though it may cancel in the equations of a route.
    Energies and momenta hold the lower rates where the equations hold a higher one.
    """
    scene = equations.scene
    orders = range(1, len(DOTS))
    given = {plain_symbol(f, k) for f in scene.inputs for k in orders}
    used = _used(equations, given)
    for _, expression in reactions:
        used |= expression.free_symbols
    found = list(scene.input_symbols)
    highest = {f: max((k for k in orders if plain_symbol(f, k) in used), default=0)
               for f in scene.inputs}  # fmt: skip
    for order in orders:
        found += [plain_symbol(f, order) for f in scene.inputs if order <= highest[f]]
    return found + ([TIME] if scene.explicit_time else [])


def _used(equations: Equations, given: set[Symbol]) -> set[Symbol]:
    """Those of the given symbols that the equations hold; M and f are not written out for none."""
    if equations.rows and not any(row.free_symbols & given for row in equations.rows):
        return set()
    left, right = equations.system
    return (left.free_symbols | right.free_symbols) & given


def _input(scene: Scene, symbol: Symbol) -> Quantity:
    if symbol == TIME:
        return Quantity(symbol, "s", "time")
    for load in scene.loads:
        if isinstance(load, Force | Torque):
            held = scene.vector(load.vector, load.name).free_symbols
            if symbol in held:
                return Quantity(
                    symbol, "N" if isinstance(load, Force) else "N m", f"load {load.name}"
                )
    return Quantity(symbol, "", "prescribed")


def _parameter(symbol: Symbol) -> Quantity:
    return Quantity(
        symbol,
        getattr(symbol, "unit", ""),
        getattr(symbol, "meaning", ""),
        positive=bool(symbol.is_positive),
    )
