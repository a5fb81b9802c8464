"""The example motion of a scene, for its report."""

from mechanics.compiled import Model
from mechanics.errors import MechanicsError
from mechanics.report.result import Motion

DURATION = 10.0
SAMPLES = 401


def example_motion(model: Model) -> tuple[Motion | None, tuple[str, ...]]:
    """Ten seconds from the scene's example; a remark says why where there is none."""
    # SciPy's integrators take half a second to import, and only reports show motions.
    from mechanics.simulate import simulate

    try:
        found = simulate(model, DURATION, samples=SAMPLES)
    except MechanicsError as error:
        return None, (f"No example motion: {error}",)
    columns = {
        "t": found.times,
        **found.coordinates,
        **found.speeds,
        **found.inputs,
        "kinetic_energy": found.kinetic,
        "potential_energy": found.potential,
        "total_energy": found.total,
    }
    note = f"{found.reason}."
    if found.conservative:
        note += f" Largest relative change of the energy: {found.energy_drift:.1e}."
    if found.drift:
        note += f" Largest constraint drift before projection: {max(found.drift.values()):.1e}."
    return Motion(f"{found.title}, example motion", columns, note, found.units), ()
