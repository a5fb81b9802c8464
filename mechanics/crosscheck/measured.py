"""Published equations of motion with compiled accelerations put in: which, and where.

Without constraints random states are anywhere; with them they are put onto the constraints, off
which published equations need not hold.
"""

from collections.abc import Mapping, Sequence

from mechanics.checks.ledger_compare import definitions_in_full
from mechanics.compiled import Model, residuals
from mechanics.compiled.residuals import SEED, random_states
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.kinematics.symbolic import Kinematics
from mechanics.report.result import ResidualResult
from mechanics.scene import Scene
from mechanics.scene.declared import decimals
from mechanics.scene.published import Published

MOST_CLOSED = 10_000
"""Random states that are put onto constraints."""
ON_MANIFOLD = (
    "Residuals are measured at random states that are put onto the constraints, with angles within"
    " a radian of the example."
)
NOT_CLOSED = "Residuals are not measured: no random state was found that satisfies the constraints."


def holds_others(scene: Scene, row: Published) -> bool:
    """Whether a row holds reactions or momenta: compiled functions of the motion give neither."""
    held = {reaction.symbol for reaction in scene.reactions}
    kinematics = Kinematics(scene)
    written = [momenta_written_out(kinematics, side) for side in row.sides]
    if any(one != other for one, other in zip(written, row.sides, strict=True)):
        return True
    return any(scene.plain(side, row.tag).free_symbols & held for side in row.sides)


def measured(
    scene: Scene, models: Mapping[str, Model], rows: Sequence[Published], states: int
) -> tuple[ResidualResult, ...]:
    """The largest residual of each row for each model; none where no state is found.

    Parameters
    ----------
    models : mapping of str to Model
        By route.
    rows : sequence of Published
        Equations of motion that are right.
    states : int
        How many; at most `MOST_CLOSED` of a scene with constraints.
    """
    draw = random_states
    if scene.constraints:
        # SciPy's integrators and optimizers take half a second to import.
        from mechanics.simulate.many_on_manifold import states_on_manifold

        draw, states = states_on_manifold, min(states, MOST_CLOSED)
    if not rows or states == 0 or not all(len(draw(m, 1, SEED)) for m in models.values()):
        return ()
    # Compiled functions take what is defined as a parameter where the equations hold it.
    defined = definitions_in_full(scene, but=scene.parameters)
    typed = [
        (row.tag, *(decimals(scene.plain(side, row.tag).xreplace(defined)) for side in sides))
        for row, sides in ((row, row.sides[:2]) for row in rows)
    ]
    found = residuals(tuple(models.values()), typed, states=states, draw=draw)
    return tuple(ResidualResult(entry.subject, entry.max_eps, entry.states) for entry in found)
