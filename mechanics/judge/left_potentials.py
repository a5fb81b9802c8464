"""Loads of position alone that an energy leaves out, since the scene declares them as forces.

L = m r'^2/2 of a mass that F = -m mu/r^2 pulls: it is T - V with the V of conservative loads, which
is 0, and the generalized force of F remains.
"""

from collections.abc import Iterator, Sequence

from sympy import S, Symbol

from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene
from mechanics.scene.loads import Force, Torque
from mechanics.scene.quantities import Hamiltonian, Lagrangian, PotentialEnergy, TotalEnergy
from mechanics.scene.symbols import TIME

HOLDING: dict[type, str] = {
    PotentialEnergy: "potential energy", TotalEnergy: "energy", Lagrangian: "Lagrangian",
    Hamiltonian: "Hamiltonian",
}  # fmt: skip
"""What has a potential in it."""


def left_potentials(scene: Scene, judged: Sequence[Judged]) -> Iterator[str]:
    """Remarks on loads whose potential is in no energy that is shown.

    Parameters
    ----------
    judged : sequence of Judged
    """
    for entry in judged:
        row = entry.statement.row
        word = HOLDING.get(type(row.quantity)) if row is not None else None
        if row is None or word is None or not entry.finding.shown:
            continue
        held = set().union(*(scene.plain(side).free_symbols for side in row.sides))
        for name, symbols in _of_position(scene):
            if not symbols <= held:
                yield (
                    f"load {name} is a force in the scene: no potential of it is in the {word}, and"
                    " its generalized forces remain"
                )


def _of_position(scene: Scene) -> Iterator[tuple[str, set[Symbol]]]:
    """Forces and torques that act without inputs and at rest, with the parameters in them."""
    still = dict.fromkeys((*scene.u, *scene.qd, *scene.input_symbols), S.Zero)
    for load in scene.loads:
        if isinstance(load, Force | Torque):
            resting = scene.vector(load.vector, load.name).xreplace(still)
            symbols = resting.free_symbols
            if symbols and TIME not in symbols and not resting.has(S.NaN, S.ComplexInfinity):
                yield load.name, symbols & {*scene.parameters}
