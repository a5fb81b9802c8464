"""Dimensions of all that a statement may hold, and whether an energy is one, its constant too.

[q] = 1 or m    [q'] = [q] / s    parameters as declared, else as masses, places and loads need them
"""

from collections.abc import Mapping

from sympy import Symbol

from mechanics.compiled.quantities import quantities
from mechanics.equations import Equations
from mechanics.scene import Scene
from mechanics.scene.dimensions import NONE, MixedDimensions, dimension_of
from mechanics.scene.loads import Force, Torque
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.published import Published
from mechanics.scene.quantities import (
    Hamiltonian,
    KineticEnergy,
    Lagrangian,
    PotentialEnergy,
    TotalEnergy,
)
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS, plain_symbol
from mechanics.scene.unit_names import Dimension, dimension_of_unit, words
from mechanics.scene.units import declared, inferred, lengths

ENERGIES = (KineticEnergy, PotentialEnergy, TotalEnergy, Lagrangian, Hamiltonian)
JOULE = dimension_of_unit("J", "")
METRE = dimension_of_unit("m", "")
SECOND = dimension_of_unit("s", "") or ()


def known_dimensions(truth: Equations) -> Mapping[Symbol, Dimension | None]:
    """Dimension of each symbol, as far as it is known; none of a scene with numbers in place of
    parameters, which carry units that nothing tells.
    """
    scene = truth.scene
    if any(e.is_number and e != 0 and u != "1" for _, e, u in declared(scene)):
        return {}
    known: dict[Symbol, Dimension | None] = {}
    every = quantities(truth)
    for group in (every.q, every.u, every.ud, every.inputs, every.multipliers, every.reactions):
        for entry in group:
            known[entry.symbol] = dimension_of_unit(entry.unit.replace(" ", "*"), entry.name)
    # What no place shows to be a length is none for sure: it may be a share of one.
    sure = lengths(scene)
    unsure = {q.name for q in scene.q if known.get(q) == METRE and q not in sure}
    for symbol in list(known):
        if symbol.name in {name + dots for name in unsure for dots in DOTS}:
            del known[symbol]
    for one in scene.reactions:
        known[one.symbol] = dimension_of_unit("N" if one.at is not None else "N*m", one.name)
    for function in (*scene.coordinates, *scene.inputs):
        base = known.get(plain_symbol(function))
        if base is not None:
            for order in range(1, len(DOTS)):
                known.setdefault(plain_symbol(function, order), _per_second(base, order))
    for momentum, q in momentum_symbols(scene).items():
        length = known.get(q)
        if length is not None:
            action = dimension_of_unit("J*s", "") or ()
            known[momentum] = tuple(a - b for a, b in zip(action, length, strict=True))
    known[TIME] = SECOND
    known |= inferred(scene)
    for symbol in _scaled_inputs(scene, known):
        del known[symbol]
    return known


def _scaled_inputs(scene: Scene, known: Mapping[Symbol, Dimension | None]) -> set[Symbol]:
    """Inputs and rates of them that loads hold times a parameter with a unit: no forces."""
    pure = {p for p in scene.parameters if known.get(p) == NONE}
    scaled = {
        one.name
        for load in scene.loads
        if isinstance(load, Force | Torque)
        for one in scene.input_symbols
        for entry in scene.vector(load.vector, load.name)
        if entry.diff(one).free_symbols & {*scene.parameters} - pure
    }
    names = {name + dots for name in scaled for dots in DOTS}
    return {symbol for symbol in known if symbol.name in names}


def _per_second(base: Dimension, order: int) -> Dimension:
    return tuple(b - order * s for b, s in zip(base, SECOND, strict=True))


def check_energy(truth: Equations, row: Published) -> MixedDimensions | None:
    """What in a row about an energy has not its dimension: U = ... + l^4; None where all has.

    Energies are known up to a constant, and no proof sees what a constant is.
    """
    if not isinstance(row.quantity, ENERGIES):
        return None
    known = known_dimensions(truth)
    for side in row.sides if known else ():
        try:
            found = dimension_of(truth.scene, truth.scene.plain(side), known)
        except MixedDimensions as mixed:
            return mixed
        if found is not None and found != JOULE:
            unit, joule = words(found), words(JOULE or ())
            return MixedDimensions(f"an energy has the unit {joule}, this has {unit}", unit, joule)
    return None
