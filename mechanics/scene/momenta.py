"""Names of generalized momenta.

The momentum of a coordinate phi1 goes by the name p_phi1 and its rate by p_phi1_dot, in every
scene: nothing declares them, and a typed side that holds them is compared with them put in. So
Hamilton's equations are written as they are: q' in q and p is a kinematic relation, and p' in q and
p an equation of motion.
"""

from sympy import Symbol

from mechanics.scene.scene import Scene


def momentum_symbols(scene: Scene) -> dict[Symbol, Symbol]:
    """The momentum of each coordinate, and the coordinate.

    Names that the scene uses for something else are left out.
    """
    taken = {s.name for s in (*scene.parameters, *scene.q, *scene.u, *scene.input_symbols)}
    taken |= {symbol.name for symbol in scene.definitions}
    taken |= {reaction.name for reaction in scene.reactions}
    names = {Symbol(f"p_{q.name}", real=True): q for q in scene.q}
    return {symbol: q for symbol, q in names.items() if symbol.name not in taken}


def rate_symbol(momentum: Symbol) -> Symbol:
    """p_i' of p_i."""
    return Symbol(f"{momentum.name}_dot", real=True)
