"""Redundant constraints left out: rows of A u + a = 0 that follow from the rows before them.

At points of the component on which all constraints hold, a row that is a combination of others
restricts no motion. Then the others alone have this component, if it has the dimension that their
rank leaves; it has not where constraints touch: y = 0 and y = x^2 admit no motion along x.
"""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from mechanics.closure import closed_state, independent_at
from mechanics.errors import SceneError
from mechanics.mechanism import Mechanism, lower, name_of
from mechanics.program.builder import Builder, Node
from mechanics.routes.rows import coefficients, remainder, velocity_forms
from mechanics.scene import Scene
from mechanics.scene.declaration import REFUSE


def without_redundant(scene: Scene) -> Scene:
    """The scene without the constraints that follow from those before them, and their reactions.

    A planar loop that is closed by a pin in space has three of them: two couples and the force
    across its plane at that pin. Rigid bodies do not determine how such loads are shared; what is
    computed for the reactions that remain is right for joints that give way where one was left out.
    Where special lengths and angles let a mechanism move that is rigid for others, and no exact
    point on its constraints is known, they are told by many digits at the example and beside it.

    Parameters
    ----------
    scene : Scene
        Its constraints are taken in order; the first ones stay.

    Returns
    -------
    Scene
        The same motion, for parameters at which all constraints hold. A joint that lost a reaction
        is declared by what it still holds, and a note says which reactions are left out.

    Raises
    ------
    SceneError
        Where no state on the constraints is known, or constraints touch or contradict each other.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> (x, y), (m,) = dynamicsymbols("x y"), parameters("m", "kg", "1")
    >>> P = O.locatenew("P", x * N.x + y * N.y)
    >>> A, B = (reaction(name, at=P, on="bead", by=None, along=N.y) for name in "AB")
    >>> rails = holonomic("rail", y, "A"), holonomic("second rail", 2 * y, "B")
    >>> bead = Particle("bead", P, m)
    >>> scene = Scene("bead", N, O, (x, y), (bead,), reactions=(A, B), constraints=rails)
    >>> [constraint.name for constraint in without_redundant(scene).constraints]
    ['rail']
    """
    mechanism = lower(scene, Builder())
    anywhere, filter_ = mechanism.filters
    forms = coefficients(velocity_forms(mechanism), mechanism.u)
    width, closure = len(mechanism.u), mechanism.closure
    rests = remainder(mechanism.builder, velocity_forms(mechanism), mechanism.u)
    rows = [filter_.values([*row, rest]) for row, rest in zip(forms, rests, strict=True)]
    kept = {i for i, _ in filter_.eliminate(rows, width)}
    near = independent_beside(mechanism, forms)
    if near is not None:
        kept, rows = set(near), [[0] * (width + 1) for _ in rows]
    gone = [c for i, c in enumerate(scene.constraints) if i not in kept]
    if not gone:
        return scene
    for constraint, row in zip(scene.constraints, rows, strict=True):
        if constraint in gone and any(row):
            raise SceneError(f"constraint {constraint.name}: it contradicts the others: correct it")
    if not (closure.start or closure.values):
        raise SceneError(
            f"{scene.name}: no state is known at which its constraints hold: give an example, and"
            " typical values of the parameters"
        )
    if anywhere.rank(forms) > len(kept):
        speeds = {*map(name_of, mechanism.u)}
        solved = sum(name_of(node) not in speeds for node in closure.values)
        exact = solved == sum(c.holonomic for i, c in enumerate(scene.constraints) if i in kept)
        if not exact and near is None:
            raise SceneError(
                f"{scene.name}: {', '.join(c.name for c in gone)} may be redundant at some states"
                " only, or for some parameters: remove them by hand where they follow"
            )
    lost = {name for constraint in gone for name in constraint.reactions}
    note = (
        f"{', '.join(sorted(lost))} left out: what they maintain follows from other constraints;"
        " rigid bodies do not determine how such loads are shared, the other reactions are those of"
        " joints that give way there"
    )
    return replace(
        scene,
        notes=(*scene.notes, note),
        redundant=REFUSE,
        # What a joint still holds stands in the scene; it is no longer a joint of its kind.
        joints=tuple(j for j in scene.joints if not lost & {r.name for r in j.reactions}),
        constraints=tuple(c for c in scene.constraints if c not in gone),
        reactions=tuple(r for r in scene.reactions if r.name not in lost),
    )


STEP = Fraction(1, 8)


def independent_beside(mechanism: Mechanism, forms: Sequence[Sequence[Node]]) -> list[int] | None:
    """Rows that are independent at the example and beside it, by numbers of many digits.

    None where exact points on the constraints are known, which tell it for all states, and where
    all constraints do not close beside the example, too, or restrict other motions there.

    Parameters
    ----------
    forms : rows of nodes
        A of A u + a = 0.
    """
    build, closure = mechanism.builder, mechanism.closure
    if closure.values or not closure.start:
        return None
    kept = independent_at(build, forms, closure.start)
    for moved in mechanism.q:
        others = [q for q in mechanism.q if q != moved]
        state = {**closure.start, name_of(moved): closure.start.get(name_of(moved), 0) + STEP}
        state = closed_state(build, closure.configuration, others, state)
        if state and independent_at(build, forms, state) == kept:
            return kept
    return None
