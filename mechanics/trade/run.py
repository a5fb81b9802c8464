"""Measure the trade: survey, variants, training, times, recommendations.

choices --> errors on the example --> near the front --> errors on other states --> picks
"""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from mechanics.cluster import Team
from mechanics.equations import Equations
from mechanics.errors import InputError, wanted
from mechanics.simulate.integrators import INTEGRATORS, Integrator
from mechanics.simulate.run import simulate_one
from mechanics.simulate.trajectory import Ending
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.cost import costs, embeddable, operations
from mechanics.trade.dropping import Derive
from mechanics.trade.family import SPREAD, TRAINING, Family, family, solutions
from mechanics.trade.least import least_model
from mechanics.trade.recommend import Recommendation, recommend
from mechanics.trade.result import Trade
from mechanics.trade.solve import Price, cheapest_that_meets
from mechanics.trade.survey import (
    Progress,
    Survey,
    best_for,
    finest,
    near_front,
    survey,
    timed,
    vary,
)
from mechanics.trade.train import train
from mechanics.trade.workers import Workers, to_text
from mechanics.trade.yardstick import Yardstick, with_informative_start, yardstick

TARGETS = (1e-3, 1e-6, 1e-9)
"""Targets that every trade answers, beside the one that is asked for."""
STATES = 24
"""States on which every choice near the front is tried."""
CONFIRMING = 300
"""States on which picks are confirmed, the former among them."""


def trade(
    equations: Equations,
    horizon: float,
    *,
    initial: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, Any] | None = None,
    target: float | Sequence[float] | None = None,
    spread: float = SPREAD,
    members: Sequence[Integrator] = INTEGRATORS,
    compiler: str | None = "auto",
    derive: Derive | None = None,
    progress: Progress | None = None,
    team: Team | None = None,
) -> Trade:
    """Measure what each choice of method, arithmetic, form, compiler setting and model costs.

    Parameters
    ----------
    equations : Equations
        By any route.
    horizon : float
        Length of the motion in s. Shortened where doubles cannot tell the motion that long.
    initial, parameters, inputs : mapping, optional
        As for `mechanics.simulate`; inputs have to be numbers.
    target : float or sequence of float, optional
        Largest error along the way that may be made, in the norm of `mechanics.trade.truth`;
        otherwise `TARGETS`.
    spread : float
        Share of the motion by which the states differ on which picks are tuned: see
        `mechanics.trade.family`.
    members : sequence of Integrator
    compiler : str or None
        As for `mechanics.compile`.
    derive : callable, optional
        Equations of a scene, to see what parts of it may be left out; without it this is not seen.
    progress : callable, optional
        Of (what is being done, share that is done).
    team : Team, optional
        Workers for errors on other states, as of `mechanics.cluster.workers`; times are measured
        here, while they wait.

    Returns
    -------
    Trade

    Raises
    ------
    InputError
        For a horizon, target or name that is none, or an input that is a function of time.
    OverBudget
        If the motion is too fast for a reference over the horizon.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, z, (m, g) = ReferenceFrame("N"), Point("O"), dynamicsymbols("z"), (
    ...     parameters("m g", "kg m/s^2", "2 9.81"))
    >>> P = O.locatenew("P", z * N.z)
    >>> stone = Scene("stone", N, O, (z,), (Particle("stone", P, m),),
    ...     loads=(gravity(-g * N.z),))
    >>> from mechanics.simulate.integrators import INTEGRATORS
    >>> measured = trade(derive(stone), 0.1, members=INTEGRATORS[:1], compiler=None)
    >>> [pick.target for pick in measured.recommendations]
    [0.001, 1e-06, 1e-09]
    """
    wanted(equations, Equations, "trade", "pass derive(scene, route)")
    tell = progress or (lambda words, share: None)
    targets = targets_of(target)
    numbers = initial or {}, parameters or {}, inputs or {}
    asked = Case(equations, horizon, *numbers, compiler, through=True)
    tell("reference", 0.0)
    moving, beside = with_informative_start(asked)
    left = _left(moving)
    case, stick, notes = yardstick(moving)
    notes = (*beside, *notes, *left)
    found = survey(case, stick.truth, tuple(members), lambda w, s: tell(w, 0.05 + 0.3 * s))
    tell("one axis at a time", 0.35)
    better = vary(
        case, stick.truth, found, best_for(found.measurements, targets[len(targets) // 2])
    )
    near = near_front(found.measurements)
    for choice in [c.with_variant(better) for c in near if c.variant.plain]:
        if better.careful and found.add(case, choice, stick.truth) is not None:
            near.append(choice)

    def counted(choice: Choice) -> float:
        return operations(case, choice) if embeddable(choice) else np.inf

    near += near_front(found.measurements, lambda m: counted(m.choice))
    tell("states around the start", 0.45)
    around = _family(case, found, stick, spread, team)
    trained = train(case, list(dict.fromkeys(near)), around, STATES)
    tell("times", 0.7)
    timed(case, found, near)
    tell("picks", 0.85)
    tried = {t.choice: t for t in trained}

    def picked(target: float, price: Price | None = None) -> Recommendation:
        pick = cheapest_that_meets(case, stick.truth, found, trained, around, target, STATES, price)
        if pick is not None:
            tried[pick.trained.choice] = pick.trained
        return recommend(target, case.horizon, pick, trained, around.doubt)

    picks = tuple(map(picked, targets))
    embedded = tuple(picked(each, counted) for each in targets)
    measurements = tuple(found.measurements)
    chosen = [pick.choice for pick in (*picks, *embedded) if pick.choice is not None]
    tell("models", 0.9)
    least = None
    if derive is not None:
        least = least_model(case, stick.truth, measurements, derive)
    model = case.model()
    return Trade(
        title=equations.scene.name,
        horizon=case.horizon,
        asked=horizon,
        start=dict(zip(case.names, case.start.tolist(), strict=True)),
        parameters=dict(zip(model.entries["p"], case.p(model).tolist(), strict=True)),
        backend=model.backend,
        yardstick=stick,
        measurements=measurements,
        family=around,
        trained=tuple(tried.values()),
        recommendations=picks,
        embedded=embedded,
        costs=costs(case, chosen, measurements),
        least=least,
        notes=notes,
        left_out=found.left_out,
    )


def targets_of(target: float | Sequence[float] | None) -> tuple[float, ...]:
    """The targets that are asked for, the largest first; `TARGETS` where none is."""
    if target is None:
        return TARGETS
    every = tuple(target) if isinstance(target, Sequence) else (target,)
    for one in every:
        if not (np.isfinite(one) and 0 < one < 1):
            raise InputError(f"target: {one!r} found: an error between 0 and 1 is needed")
    return tuple(sorted({float(one) for one in every}, reverse=True)) or TARGETS


def _left(case: Case) -> tuple[str, ...]:
    """Where the motion leaves the domain of the model, in a sentence.

    Raises
    ------
    InputError
        Where it comes to a configuration from which it is not determined.
    """
    scene = case.equations.scene
    if not (scene.conditions or scene.constraints):
        return ()
    found = simulate_one(
        case.model(),
        case.horizon,
        initial=case.initial,
        parameters=case.parameters,
        inputs=case.inputs,
        samples=2,
        beyond_domain=True,
        estimate=False,
    )
    if found.ending is Ending.SINGULAR:
        raise InputError(f"{scene.name}: the motion {found.reason}: take a shorter horizon")
    leaving = [crossing for crossing in found.crossings if crossing.leaving]
    if not leaving:
        return ()
    return (
        f"the motion leaves the domain of the model at t = {leaving[0].time:.4g} s:"
        f" {leaving[0].sentence}; later errors are those of the equations, not of the system",
    )


def _family(
    case: Case, found: Survey, stick: Yardstick, spread: float, team: Team | None
) -> Family:
    """States around the start, and what they are compared with: the two most accurate choices."""
    starts = family(case, stick.truth.scale, CONFIRMING, spread=spread)
    first, second = (m.choice for m in finest(found.measurements))
    if team is None:
        known = tuple(solutions(case, starts, first, second))
        return Family(starts, first, second, known, spread, TRAINING)
    workers = Workers(team, to_text(case))
    known = tuple(workers.solutions(starts, first, second))
    errors = partial(workers.errors, starts, known)
    return Family(starts, first, second, known, spread, TRAINING, errors)
