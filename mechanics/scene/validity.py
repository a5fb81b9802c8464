"""The domain of validity of a scene: its conditions in plain symbols, and what they may hold."""

from sympy import Expr, Symbol

from mechanics.errors import SceneError
from mechanics.scene.conditions import Condition
from mechanics.scene.declaration import Declaration
from mechanics.scene.parameters import Parameter
from mechanics.scene.symbols import by_name


def condition_parameters(scene: Declaration) -> tuple[Symbol, ...]:
    """Parameters that only conditions use, in order of their names.

    They are no arguments of the equations.
    """
    found = {s for c in scene.conditions for s in plain_margin(scene, c).free_symbols}
    taken = {symbol.name for symbol in known_symbols(scene)}
    return tuple(sorted((s for s in found if s.name not in taken), key=by_name))


def known_symbols(scene: Declaration) -> tuple[Symbol, ...]:
    """What a condition may hold besides parameters of its own, in plain symbols."""
    moving = (*scene.q, *scene.u, *scene.ud, *scene.input_symbols)
    declared = (*scene.parameters, *scene.definitions)
    return (*moving, *(reaction.symbol for reaction in scene.reactions), *declared)


def plain_margin(scene: Declaration, condition: Condition) -> Expr:
    """The margin in plain symbols; reactions are found by their names."""
    margin = scene.plain(condition.margin, f"condition {condition.name}")
    table = {symbol.name: symbol for symbol in known_symbols(scene)}
    return margin.xreplace({s: table.get(s.name, s) for s in margin.free_symbols})


def check_conditions(scene: Declaration) -> None:
    """Every condition depends on the motion, and every symbol of it is known.

    Raises
    ------
    SceneError
        Names the condition and the symbol.
    """
    moving = {s.name for s in (*scene.q, *scene.u, *scene.ud, *scene.input_symbols)}
    moving |= {reaction.name for reaction in scene.reactions}
    known = {symbol.name for symbol in known_symbols(scene)}
    for one in scene.conditions:
        what = f"condition {one.name}"
        symbols = plain_margin(scene, one).free_symbols
        for symbol in symbols:
            if symbol.name not in known and not isinstance(symbol, Parameter):
                reactions = ", ".join(r.name for r in scene.reactions) or "none"
                raise SceneError(
                    f"{what}: {symbol} is neither a coordinate, an input, a reaction nor a"
                    f" parameter: the reactions are {reactions}; declare parameters by"
                    " parameters(...)"
                )
        if not any(symbol.name in moving for symbol in symbols):
            raise SceneError(
                f"{what}: {one.relation} does not depend on the motion: it is about parameters"
                " only, and belongs to their declaration"
            )
