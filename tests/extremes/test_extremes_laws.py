"""Laws of a walk to the extremes, over systems, forms and precisions."""

import json

import numpy as np
import pytest

from mechanics.compiled import FORMS, compile
from mechanics.extremes import CAUSES, Cause, point, reproduce, to_record
from mechanics.extremes.result import PRECISIONS, STABLE, tolerance
from systems import SEED, VARIANTS

pytestmark = pytest.mark.campaign

NAMES = [system.name for system in (*SEED, *VARIANTS)]


@pytest.fixture(params=NAMES)
def found(request, walked):
    return walked(request.param)


@pytest.mark.sample(0)
def test_equations_hold_to_sixteen_roundings_wherever_numbers_are_normal(found) -> None:
    for precision in PRECISIONS:
        assert found.worst(found.default, precision) < STABLE
        reached = sum(int(v.figure(found.default, precision).normal.sum()) for v in found.visited)
        assert reached > 500
        # None of the forms does worse on these systems.
        assert all(found.worst(form, precision) < STABLE for form in found.forms)


def test_the_error_is_at_most_what_the_condition_makes_of_the_residual(found) -> None:
    """|x^ - x| <= eta eps |K^-1| (|K| |x^| + |k|); |x^| is |x| but for that error."""
    compared = 0
    for visited in found.visited:
        for figures in visited.figures:
            epsilon = np.finfo(PRECISIONS[figures.precision]).eps
            with np.errstate(invalid="ignore"):
                bound = figures.backward * epsilon * visited.sensitivity
            # The true value is known to 2^-80 of itself.
            room = 1.25 * bound + 2.0**-80
            known = np.isfinite(figures.relative) & np.isfinite(bound) & (bound < 0.1)
            assert (figures.relative[known] <= room[known]).all()
            compared += int(known.sum())
    assert compared > found.points


def test_what_broke_is_told_wherever_something_did(found) -> None:
    for visited in found.visited:
        for figures in visited.figures:
            accurate = figures.causes == CAUSES.index(Cause.ACCURATE)
            assert (figures.backward[accurate] <= STABLE).all()
            assert (figures.relative[accurate] <= tolerance(figures.precision)).all()
            told = np.isin(
                figures.causes, [CAUSES.index(Cause.CONDITION), CAUSES.index(Cause.ACCURATE)]
            )
            assert (figures.backward[told] <= STABLE).all()
            lost = ~np.isfinite(figures.backward)
            assert not told[lost].any()
            cancelled = figures.causes == CAUSES.index(Cause.CANCELLATION)
            assert (figures.backward[cancelled] > STABLE).all()


def test_every_quantity_is_walked_and_paired_with_every_other(found) -> None:
    names = [axis.name for axis in found.axes]
    lines = [v.walk.names[0] for v in found.visited if v.walk.kind == "line"]
    pairs = {v.walk.names for v in found.visited if v.walk.kind == "pair"}
    assert lines == names
    assert pairs == {(a, b) for i, a in enumerate(names) for b in names[i + 1 :]}
    for axis in found.axes:
        values = np.array(axis.paired)
        assert values[0] == 0 and (np.diff(values) > 0).all()
        if axis.unit == "kg":
            assert values[1] <= 1.01e-12 and values[-1] >= 0.99e12
        if axis.unit == "m" and axis.group == "p":
            assert values[1] <= 1.01e-9 and values[-1] >= 0.99e9
        if axis.unit == "N/m":
            assert values[-1] >= 0.99e18
        if axis.group == "u":
            assert values[1] == 1e-300 and values[-1] == 1e150
        if axis.unit == "rad":
            wanted = (np.pi / 2, np.pi, 2 * np.pi, float(np.float32(np.pi / 2)), 1e8)
            assert set(wanted) <= set(axis.paired)
            assert any(abs(value / 1e15 - 1) < 1e-7 for value in axis.paired)
            assert {np.nextafter(np.pi / 2, 0), np.nextafter(np.pi / 2, 9)} <= set(axis.walked)


def test_ranges_are_runs_of_accurate_points_and_say_what_ends_them(found) -> None:
    lines = {v.walk.names[0]: v for v in found.visited if v.walk.kind == "line"}
    for reach in found.reaches:
        visited = lines[reach.name]
        figures = visited.figure(reach.form, reach.precision)
        values = np.array(visited.walk.values[0])
        inside = (values >= reach.low) & (values <= reach.high)
        inside &= figures.causes != CAUSES.index(Cause.INPUT)
        assert inside.any()
        assert (figures.causes[inside] == CAUSES.index(Cause.ACCURATE)).all()
        for end, beyond in (
            (reach.below, values[(values < reach.low) & (values > 0)]),
            (reach.above, values[values > reach.high]),
        ):
            assert end.cause is Cause.ACCURATE or len(beyond)
            assert bool(end.where) == (end.cause in (Cause.OVERFLOW, Cause.RANGE, Cause.UNDERFLOW))


def test_figures_of_the_record_are_reproduced(found, derived) -> None:
    record = json.loads(json.dumps(to_record(found), allow_nan=False))
    models = {f: compile(derived(found.system, "kane"), form=f) for f in record["forms"]}
    random = np.random.default_rng(6)
    for _ in range(40):
        walk = int(random.integers(len(record["walks"])))
        entry = record["walks"][walk]
        figures = entry["figures"][int(random.integers(len(entry["figures"])))]
        index = int(random.integers(len(figures["cause"])))
        anew = reproduce(models[figures["form"]], point(record, walk, index), figures["precision"])
        assert anew == {key: figures[key][index] for key in anew}
    assert record["causes"] == [cause.value for cause in CAUSES]
    assert {form.name for form in FORMS} >= set(record["forms"])
