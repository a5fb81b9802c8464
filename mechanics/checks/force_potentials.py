"""Energies that count in what a scene declares as a force with a potential.

    F = -k (r - l) e_r        V = k (r - l)^2 / 2        dV/dq_i = -F . dr/dq_i

A scene has no potential for such a force or torque, and its energy is right without; a person's
energy is right with it, too. Parts with speeds and parts with time do no part of it. Inputs
do no part of it, or all: the potential of a spring k (q - u) to a place that is moved is
k (q - u)^2 / 2, which vanishes with the force.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace

from sympy import Add, Expr, Integral, S, integrate, linsolve
from sympy.matrices import MatrixBase
from sympy.physics.mechanics import dynamicsymbols
from sympy.solvers.solveset import NonlinearError

from mechanics.kernel import Finding
from mechanics.scene import Force, Scene, Torque
from mechanics.scene.generalized_forces import arms
from mechanics.scene.published import Published
from mechanics.scene.quantities import Hamiltonian, Lagrangian, PotentialEnergy, TotalEnergy
from mechanics.scene.symbols import plain_symbol
from mechanics.symbolic import canonical, is_zero, operations

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
    check : callable
        The finding of another row.
    """
    for added, names in potentials_beside(scene, row):
        whole = with_potentials(row, added)
        finding = check(whole)
        moved = added.free_symbols & {*scene.input_symbols}
        # The ledger leaves an energy a part of inputs alone; a spring has none of its own.
        own = any(not is_zero(scene.plain(side).diff(z)) for side in whole.sides for z in moved)
        if finding.shown and not own:
            words = f"{finding.evidence}, with the potential of {' and '.join(names)}"
            return replace(finding, evidence=words)
    return None


def potentials_beside(scene: Scene, row: Published) -> Iterator[tuple[Expr, tuple[str, ...]]]:
    """What makes of an energy with potentials of forces the scene's own, and which forces."""
    sign = SIGNS.get(type(row.quantity))
    if sign is None or any(isinstance(side, MatrixBase) for side in row.sides):
        return
    for added, names in _sums(scene):
        yield sign * added, names


def with_potentials(row: Published, added: Expr) -> Published:
    """A row with something added to all sides."""
    return replace(row, sides=tuple(side + added for side in row.sides)) if added else row


def _sums(scene: Scene) -> Iterator[tuple[Expr, tuple[str, ...]]]:
    """Sums of potentials, and what they are of: all, and those of springs."""
    for inputs in (False, True) if scene.input_symbols else (False,):
        found = dict(_potentials(scene, inputs))
        # A pull that is the same everywhere may be no part of an energy; one that springs have is.
        elastic = [
            n for n, V in found.items() if any(V.diff(q, p) != 0 for q in scene.q for p in scene.q)
        ]
        for names in dict.fromkeys((tuple(found), tuple(elastic))):
            if names:
                yield sum((found[name] for name in names), S.Zero), names


def _potentials(scene: Scene, inputs: bool) -> Iterator[tuple[str, Expr]]:
    """Potentials of loads, and of those together that have none alone: a coupled spring's."""
    left: dict[str, list[Expr]] = {}
    for name, forces in _conservative(scene, inputs):
        potential = _potential(scene, forces)
        if potential is None:
            left[name] = forces
        else:
            yield name, _from_rest(scene, potential, forces) if inputs else potential
    if len(left) > 1:
        forces = [canonical(Add(*some)) for some in zip(*left.values(), strict=True)]
        potential = _potential(scene, forces)
        if potential is not None:
            names = " and ".join(left)
            yield names, _from_rest(scene, potential, forces) if inputs else potential


def _conservative(scene: Scene, inputs: bool) -> Iterator[tuple[str, list[Expr]]]:
    """Generalized forces of loads at rest, where coordinates and constants alone make them."""
    constants = {*scene.q, *scene.parameters}
    rates = (plain_symbol(q, 1) for q in scene.coordinates)
    rest = dict.fromkeys((*rates, *scene.u), S.Zero)
    if inputs:
        constants |= {*scene.input_symbols}
    else:
        rest |= dict.fromkeys(scene.input_symbols, S.Zero)
    for load in scene.loads:
        if not isinstance(load, Force | Torque):
            continue
        vector = scene.vector(load.vector, load.name).subs(rest)
        forces = [_at_rest(canonical(vector.dot(arm))) for arm in arms(scene, load)]
        if all(operations(Q) <= LARGEST and Q.free_symbols <= constants for Q in forces):
            yield load.name, forces


def _at_rest(force: Expr) -> Expr:
    """The terms of a generalized force without time: a drive F_0 cos(omega t) is none of them."""
    return Add(*(term for term in Add.make_args(force) if not term.has(dynamicsymbols._t)))


def _from_rest(scene: Scene, potential: Expr, forces: list[Expr]) -> Expr:
    """A potential that vanishes where a linear force does; any other as it is."""
    try:
        places = list(linsolve(forces, *scene.q))
    except NonlinearError:
        return potential
    there = [potential.subs(zip(scene.q, place, strict=True)) for place in places]
    return potential - there[0] if there else potential


def _potential(scene: Scene, forces: list[Expr]) -> Expr | None:
    """V with dV/dq = -Q, coordinate by coordinate; None where there is none."""
    found: Expr = S.Zero
    for q, force in zip(scene.q, forces, strict=True):
        found += integrate(canonical(-force - found.diff(q)), q)
    if found.has(Integral):
        return None
    right = all(is_zero(found.diff(q) + force) for q, force in zip(scene.q, forces, strict=True))
    return found if right and found != 0 else None
