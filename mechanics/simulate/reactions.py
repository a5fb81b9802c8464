"""Reactions along a simulated motion: functions of the state, as `free_body` solves for them.

T = T(q, u, inputs, p)      and the multipliers that stand for reactions where a loop is cut
"""

from dataclasses import replace
from typing import Any

import numpy as np

from mechanics.compiled.model import Model
from mechanics.errors import InputError
from mechanics.simulate.trajectory import Trajectory


def with_reactions(found: Trajectory, model: Model) -> Trajectory:
    """A motion with one more column for each reaction of its scene.

    Parameters
    ----------
    found : Trajectory
        As `simulate` gives it.
    model : Model
        That it was integrated with.

    Raises
    ------
    InputError
        If the equations of the model give no reactions, or one is named as another column.
    """
    scene, known = model.equations.scene, model.quantities
    declared = {reaction.name for reaction in scene.reactions}
    if not declared:
        raise InputError(f"{scene.name}: it declares no reactions: leave them out")
    n, groups = len(found.times), (found.coordinates, found.speeds, found.inputs)
    q, u, inputs = (np.array(list(group.values())).reshape(len(group), n).T for group in groups)
    given: dict[str, Any] = {"q": q, "u": u, "inputs": inputs, "p": list(found.parameters.values())}
    tables = []
    if "reactions" in tuple(model.casadi):
        tables.append((known.reactions, model.evaluate("reactions", **given)["reactions"]))
    if declared & {entry.name for entry in known.multipliers}:
        values = model.evaluate("forward_dynamics", **given)["multipliers"]
        tables.append((known.multipliers, values))
    entries = {e: values[:, i] for table, values in tables for i, e in enumerate(table)}
    columns = {
        e.name: values.astype(np.float64) for e, values in entries.items() if e.name in declared
    }
    if missing := sorted(declared - columns.keys()):
        raise InputError(
            f"{scene.name}: the route {model.equations.route} does not solve for {missing[0]}:"
            " take free_body, and a model with all outputs"
        )
    if taken := sorted(columns.keys() & found.columns.keys()):
        raise InputError(f"{scene.name}: reaction {taken[0]} is named as another column: rename it")
    units = {entry.name: entry.unit for entry in entries}
    return replace(found, reactions=columns, units={**found.units, **units})
