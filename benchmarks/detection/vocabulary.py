"""Symbols that people take for each other: those of one kind in a scene."""

from sympy import Symbol

from mechanics.scene import Scene


def vocabulary(scene: Scene) -> tuple[tuple[Symbol, ...], ...]:
    """Parameters of one unit, all parameters, coordinates, speeds, ...; q beside q' beside q''."""
    reactions = tuple(reaction.symbol for reaction in scene.reactions)
    defined = set().union(*(value.free_symbols for value in scene.definitions.values()))
    constants = tuple(sorted({*scene.parameters} - (defined - {*scene.parameters}), key=str))
    moving = (scene.q, scene.u, scene.ud)
    orders = tuple(zip(*moving, strict=True)) if not scene.speeds else ()
    return (constants, *moving, *orders, scene.input_symbols, reactions)
