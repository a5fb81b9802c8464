"""The least model that is enough: what each step of fidelity costs, and what it is good for.

linearized <-- without a damper, without an inertia, ... <-- as declared
"""

from collections.abc import Callable
from dataclasses import dataclass

from mechanics.errors import MechanicsError
from mechanics.linear import verdict
from mechanics.simulate.integrators import Outcome
from mechanics.trade.amplitude import Amplitude, amplitudes
from mechanics.trade.case import Case
from mechanics.trade.choice import LINEARIZED, Choice, Variant
from mechanics.trade.dropping import ENOUGH, Derive, Dropped, dropped, operations
from mechanics.trade.linearized import Equilibrium, equilibria
from mechanics.trade.measure import Measurement, prepared, times_side_by_side
from mechanics.trade.train import error_of
from mechanics.trade.truth import Truth

DECLARED = "as declared"
# Errors of integration have to be far below those of models.
ACCURATE = 1e-3 * ENOUGH
# Seconds for the times of the models.
TIMING = 3.0


@dataclass(frozen=True, eq=False)
class Fidelity:
    """One model of the same system.

    Attributes
    ----------
    operations : int
        Of the right-hand side; 0 where there is no such model.
    seconds : tuple of float
        Time for a second of motion, one for each repetition, all models integrated alike.
    error : float
        Against the model as declared, along the motion from the example.
    words : str
        What it is good for.
    """

    name: str
    operations: int
    seconds: tuple[float, ...]
    error: float
    words: str


@dataclass(frozen=True, eq=False)
class LeastModel:
    """Models of rising fidelity, and how far the linear one is enough.

    Attributes
    ----------
    choice : Choice
        How all of them are integrated.
    notes : tuple of str
        About equilibria.
    """

    choice: Choice
    fidelities: tuple[Fidelity, ...]
    amplitudes: tuple[Amplitude, ...]
    notes: tuple[str, ...]


def least_model(
    case: Case, truth: Truth, measurements: tuple[Measurement, ...], derive: Derive
) -> LeastModel:
    """Compare models of a scene.

    Parameters
    ----------
    truth : Truth
        Of the motion from the example.
    measurements : tuple of Measurement
        To take a way to integrate from.
    derive : callable
        Equations of a scene.
    """
    choice = accurate(measurements)
    found, notes = _equilibria(case)
    rows = [row for at in found for row in amplitudes(case, at, choice)]
    left_out = dropped(case, derive, choice)
    linear = _linearized(case, truth, choice, rows)
    runs = [prepared(case, choice)]
    models = [*linear, *((d, d.run) for d in left_out)]
    runs += [run for _, run in models if run is not None]
    seconds = iter(times_side_by_side(runs, case.horizon, TIMING, (5, 31)))
    whole = Fidelity(DECLARED, operations(case.model()), next(seconds), 0.0, "")
    rest = tuple(
        Fidelity(d.name, d.operations, next(seconds) if run is not None else (), d.error, d.words)
        for d, run in models
    )
    return LeastModel(choice, (*rest, whole), tuple(rows), notes)


def accurate(measurements: tuple[Measurement, ...]) -> Choice:
    """The fastest fixed step in double precision whose error does not count beside a model's."""
    plain = [m for m in measurements if m.choice.variant.plain and not m.failure]
    plain = [m for m in plain if m.choice.setting.arithmetic == "double"]
    fixed = [m for m in plain if m.choice.setting.step is not None]
    good = [m for m in fixed if m.error_largest <= ACCURATE]
    if good:
        return min(good, key=lambda m: m.time).choice
    return min(plain, key=lambda m: m.error_largest).choice


def _equilibria(case: Case) -> tuple[tuple[Equilibrium, ...], tuple[str, ...]]:
    try:
        found = equilibria(case.equations, case.parameters, case.suggested[0])
    except MechanicsError as error:
        return (), (f"No linearized model: {error}.",)
    return found, tuple(_described(at) for at in found)


def _described(at: Equilibrium) -> str:
    grows = f"unstable, growing e-fold in {1 / at.growth:.2g} s" if not at.stable else ""
    kind = grows or verdict(at.linear)
    return (
        f"Linearized about {at.place}, proved to be an equilibrium ({kind}); the example starts"
        f" {at.distance:.2g} away from it."
    )


def _linearized(
    case: Case, truth: Truth, choice: Choice, rows: list[Amplitude]
) -> list[tuple[Dropped, Callable[[], Outcome]]]:
    if not rows:
        return []
    variant = choice.with_variant(Variant(model=LINEARIZED))
    error = error_of(case, variant, case.start, truth)
    words = "; ".join(row.words for row in rows)
    run = prepared(case, variant)
    size = operations(case.model(variant.variant))
    found = Dropped(LINEARIZED, error, size, run, 1.0, words)
    return [(found, run)]
