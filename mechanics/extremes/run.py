"""Accelerations at the extremes: ``extremes(equations) -> Extremes``.

points -> compiled forms, double and single -> errors against Arb -> what broke, and where
"""

from collections.abc import Iterator, Sequence

import numpy as np

from mechanics.compiled import Model, compile
from mechanics.compiled.graphs import form_names
from mechanics.equations import Equations
from mechanics.errors import InputError, wanted
from mechanics.extremes.axes import axes
from mechanics.extremes.domain import reaches
from mechanics.extremes.points import PAIRED, Walk, usual, walks
from mechanics.extremes.result import Extremes
from mechanics.extremes.survey import GROUPS, computed, survey
from mechanics.extremes.truth import truth
from mechanics.scene.system import Path


def extremes(
    equations: Equations,
    *,
    name: str = "",
    paths: Sequence[Path] = (),
    forms: Sequence[str] = (),
    paired: int = PAIRED,
    compiler: str | None = "auto",
) -> Extremes:
    """Find where compiled equations lose accuracy, along every parameter, coordinate and speed.

    Parameters
    ----------
    equations : Equations
    name : str
        Of the system, for people; by default that of the scene.
    paths : sequence of Path
        Further points worth a visit.
    forms : sequence of str
        Forms of forward dynamics, beside the default one; by default all that suit the equations.
    paired : int
        About how many points the pairs of quantities take together.
    compiler : str or None
        As for `compile`.

    Raises
    ------
    InputError
        If there is no such form, or the equations have no such one.
    ExpressionError
        If an operation of the equations has no enclosure; it is named.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, z, (m, g) = ReferenceFrame("N"), Point("O"), dynamicsymbols("z"), (
    ...     parameters("m g", "kg m/s^2", "2 9.81"))
    >>> P = O.locatenew("P", z * N.z)
    >>> stone = Scene("stone", N, O, (z,), (Particle("stone", P, m),),
    ...     loads=(gravity(-g * N.z),))
    >>> walked = extremes(derive(stone), paired=0, compiler=None, forms=["fewest"])
    >>> [axis.name for axis in walked.axes]
    ['z', 'z_dot', 'g', 'm']
    """
    wanted(equations, Equations, "extremes", "pass derive(scene, route)")
    for rotation in equations.scene.rotations:
        raise InputError(
            f"extremes: {equations.scene.name}: {rotation.name} is a quaternion of norm 1, along"
            " whose coordinates nothing can be walked one by one: declare angles for this"
        )
    default = compile(equations, compiler=compiler)
    chosen = list(dict.fromkeys([*(forms or form_names(equations)), default.form]))
    models = {form: compile(equations, compiler=compiler, form=form) for form in chosen}
    if not forms:
        models = {name: model for name, model in models.items() if _has_form(model)}
    known = default.quantities
    entries = [e for group in GROUPS for e in getattr(known, group)]
    judge = truth(equations, [entry.symbol for entry in entries])
    visited = survey(judge, models, tuple(_cut(models, walks(known, paths, paired))))
    start = usual(known)
    return Extremes(
        system=name or equations.scene.name,
        route=equations.route,
        default=default.form,
        forms=tuple(models),
        unknowns=tuple(e.name for e in (*known.ud, *known.multipliers)),
        axes=axes(known),
        usual=tuple(start.tolist()),
        visited=visited,
        reaches=reaches(visited, axes(known), start, models),
        backend=default.backend,
    )


def _has_form(model: Model) -> bool:
    """Whether the equations can be solved in the form of a model; programs tell when asked."""
    try:
        _ = model.form
    except InputError:
        return False
    return True


def _cut(models: dict[str, Model], found: Sequence[Walk]) -> Iterator[Walk]:
    """Lines end at the first value at which no form gives a number in double precision."""
    for walk in found:
        if walk.kind != "line":
            yield walk
            continue
        alive = np.zeros(len(walk), dtype=bool)
        for model in models.values():
            alive |= np.isfinite(computed(model, walk.points, np.float64)).all(axis=1)
        dead = np.flatnonzero(~alive)
        middle = _middle(walk)
        first = max(dead[dead < middle], default=0)
        last = min(dead[dead > middle], default=len(walk) - 1)
        part = slice(int(first), int(last) + 1)
        yield Walk(walk.kind, walk.names, (walk.values[0][part],), walk.points[part])


def _middle(walk: Walk) -> int:
    """The value of a line that is nearest to one."""
    sizes = np.abs(np.array(walk.values[0]))
    with np.errstate(divide="ignore"):
        return int(np.argmin(np.abs(np.log10(sizes))))
