"""Energies that count in what a scene declares as a force with a potential.

    F = -k (r - l) e_r        V = k (r - l)^2 / 2        dV/dq_i = -F . dr/dq_i

A scene has no potential for such a force, and its energy is right without; a person's energy is
right with it, too. Forces that hold speeds, inputs or time have none.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import combinations

from sympy import Expr, Integral, S, integrate
from sympy.matrices import MatrixBase

from mechanics.kernel import Finding
from mechanics.scene import Force, Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import Hamiltonian, Lagrangian, PotentialEnergy, TotalEnergy
from mechanics.symbolic import canonical, is_zero

SIGNS = {PotentialEnergy: -1, TotalEnergy: -1, Hamiltonian: -1, Lagrangian: 1}
"""What makes of an energy with a potential the one without it."""
LARGEST = 60
"""Operations of a generalized force that is integrated."""


def right_with_potentials(
    scene: Scene, row: Published, check: Callable[[Published], Finding]
) -> Finding | None:
    """The finding of a refuted energy that is right with the potentials of forces; else None.

    Parameters
    ----------
    scene : Scene
    row : Published
    check : callable
        The finding of another row.
    """
    sign = SIGNS.get(type(row.quantity))
    if sign is None or any(isinstance(side, MatrixBase) for side in row.sides):
        return None
    found = dict(_potentials(scene))
    for names in (tuple(found), *combinations(found, 1)):
        if not names:
            continue
        added = sum((found[name] for name in names), S.Zero)
        finding = check(replace(row, sides=tuple(side + sign * added for side in row.sides)))
        if finding.shown:
            words = f"{finding.evidence}, with the potential of {' and '.join(names)}"
            return replace(finding, evidence=words)
    return None


def _potentials(scene: Scene) -> Iterator[tuple[str, Expr]]:
    constants = {*scene.q, *scene.parameters}
    for load in scene.loads:
        if not isinstance(load, Force) or load.by is not None:
            continue
        force, place = scene.vector(load.vector, load.name), scene.position(load.at)
        if not (force.free_symbols | place.free_symbols) <= constants:
            continue
        forces = [canonical(force.dot(place.diff(q))) for q in scene.q]
        if all(Q.count_ops() <= LARGEST for Q in forces):
            potential = _potential(scene, forces)
            if potential is not None:
                yield load.name, potential


def _potential(scene: Scene, forces: list[Expr]) -> Expr | None:
    """V with dV/dq = -Q, coordinate by coordinate; None where there is none."""
    found: Expr = S.Zero
    for q, force in zip(scene.q, forces, strict=True):
        found += integrate(canonical(-force - found.diff(q)), q)
    if found.has(Integral):
        return None
    right = all(is_zero(found.diff(q) + force) for q, force in zip(scene.q, forces, strict=True))
    return found if right and found != 0 else None
