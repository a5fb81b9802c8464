"""Rows about energies, and the mass matrix that the kinetic energy has.

    T = sum (m v . v + omega . I omega) / 2        M_ij = d2T / du_i du_j
    L = T - V        H = sum q_i' dT/dq_i' - L        d/dt dF'/dq_i' - dF'/dq_i = 0

A potential energy is known up to a constant, and so is its sum or difference with T: what is
compared is what they are above their values at q = u = u' = 0, and where there is none their
derivatives by q, u and u'; under constraints their rates along the motions that these admit.
A Lagrangian is known up to the rate F' of any function of q and t, on which Lagrange's operator
is zero.
"""

from collections.abc import Sequence
from dataclasses import replace

from sympy import Add, Expr, S, Symbol, nan, oo, zoo
from sympy.matrices import MatrixBase

from mechanics.checks.ledger_compare import equal
from mechanics.errors import InputError
from mechanics.kernel import Finding, Verdict
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene import quantities as q
from mechanics.scene.potential import potential
from mechanics.scene.published import Quantity
from mechanics.scene.rates import coordinate_rate_table, rate, rate_table, speeds_in_rates

SHARES: dict[type[Quantity], tuple[int, int]] = {
    q.PotentialEnergy: (0, 1), q.TotalEnergy: (1, 1), q.Lagrangian: (1, -1),
}  # fmt: skip
"""How often the kinetic and the potential energy are in what is known up to a constant."""

ENERGIES: tuple[type[Quantity], ...] = (q.KineticEnergy, q.Hamiltonian, *SHARES, q.MassMatrix)

SAME_MOTION = "equal up to the rate of a function of coordinates and time: it gives the same motion"


def check_energy(
    kinematics: Kinematics, quantity: Quantity, sides: Sequence[Expr | MatrixBase], subject: str
) -> Finding:
    """Whether each typed side is the energy, or the mass matrix.

    Raises
    ------
    InputError
        As `energy_pairs`.
    """
    found = equal(kinematics, subject, *energy_pairs(kinematics, quantity, sides, subject))
    if isinstance(quantity, q.Lagrangian) and found.verdict is Verdict.REFUTED:
        pairs = _motion_pairs(kinematics, sides)
        if pairs and (same := equal(kinematics, subject, *pairs)).shown:
            return replace(same, evidence=f"{SAME_MOTION}; {same.evidence}")
    return found


def _motion_pairs(
    kinematics: Kinematics, sides: Sequence[Expr]
) -> tuple[list[Expr], list[Expr]] | None:
    """Lagrange's operator on the typed sides less L; None where constraints reduce the motion."""
    scene = kinematics.scene
    if not scene.unconstrained:
        return None
    table, speeds = coordinate_rate_table(scene), speeds_in_rates(scene)
    left_out = (*scene.ud, *(table[qd] for qd in scene.qd), *_reactions(scene))
    energy = kinematics.energy_in_rates - potential(scene)
    rest = [side.xreplace(speeds) - energy for side in sides]
    found = [
        rate(difference.diff(table[s]), table) - difference.diff(s)
        for difference in rest for s in scene.q
    ]  # fmt: skip
    found += [difference.diff(s) for difference in rest for s in dict.fromkeys(left_out)]
    return found, [S.Zero] * len(found)


def energy_pairs(
    kinematics: Kinematics, quantity: Quantity, sides: Sequence[Expr | MatrixBase], subject: str
) -> tuple[list[Expr], list[Expr]]:
    """Entries of the typed sides, and what they have to be.

    Raises
    ------
    InputError
        When a mass matrix has not as many rows and columns as there are speeds, or an energy is a
        matrix.
    """
    if isinstance(quantity, q.MassMatrix):
        return _mass_matrix(kinematics, sides, subject)
    if any(isinstance(side, MatrixBase) for side in sides):
        raise InputError(f"{subject}: an energy is no matrix")
    if isinstance(quantity, q.KineticEnergy):
        return list(sides), [energy_of(kinematics, quantity)] * len(sides)
    scene, energy = kinematics.scene, energy_of(kinematics, quantity)
    if not scene.unconstrained:
        return _along_motions(scene, sides, energy)
    above = _above(scene, sides, energy)
    if above is not None:
        return above
    # By what has to be left out too: no constant depends on it.
    lefts = [side.diff(symbol) for side in sides for symbol in _moving(scene)]
    return lefts, [energy.diff(symbol) for symbol in _moving(scene)] * len(sides)


def energy_of(kinematics: Kinematics, quantity: Quantity) -> Expr:
    """The energy that a row is about, in J."""
    if isinstance(quantity, q.Hamiltonian):
        return _hamiltonian(kinematics)
    kinetic, stored = SHARES.get(type(quantity), (1, 0))
    energy: Expr = stored * potential(kinematics.scene)
    return energy + kinetic * kinematics.kinetic_energy if kinetic else energy


def _hamiltonian(kinematics: Kinematics) -> Expr:
    """In q and u."""
    scene, energy = kinematics.scene, kinematics.energy_in_rates
    twice = Add(*(qd * energy.diff(qd) for qd in scene.qd))
    return (twice - energy).xreplace(scene.coordinate_rates) + potential(scene)


def _along_motions(
    scene: Scene, sides: Sequence[Expr], energy: Expr
) -> tuple[list[Expr], list[Expr]]:
    """Their rates along the motions that constraints and norms admit.

    Off these, what is written with other coordinates has other slopes: x for l - z.
    """
    table, left_out = rate_table(scene), (*scene.ud, *_reactions(scene))
    lefts = [e for side in sides for e in (rate(side, table), *(side.diff(s) for s in left_out))]
    return lefts, [rate(energy, table), *(S.Zero for _ in left_out)] * len(sides)


def _above(
    scene: Scene, sides: Sequence[Expr], energy: Expr
) -> tuple[list[Expr], list[Expr]] | None:
    """Energies less their values at rest; None where one of them has no value there."""
    still = dict.fromkeys(_moving(scene), S.Zero)
    resting = [typed.xreplace(still) for typed in (energy, *sides)]
    if any(value.has(nan, zoo, oo, -oo) for value in resting):
        return None
    right, *lefts = (e - rest for e, rest in zip((energy, *sides), resting, strict=True))
    return lefts, [right] * len(lefts)


def _moving(scene: Scene) -> tuple[Symbol, ...]:
    """What the constant in an energy does not depend on."""
    return (*scene.q, *scene.u, *scene.ud, *_reactions(scene))


def _reactions(scene: Scene) -> tuple[Symbol, ...]:
    return tuple(reaction.symbol for reaction in scene.reactions)


def _mass_matrix(
    kinematics: Kinematics, sides: Sequence[Expr | MatrixBase], subject: str
) -> tuple[list[Expr], list[Expr]]:
    size = len(kinematics.scene.u)
    for side in sides:
        if not isinstance(side, MatrixBase) or side.shape != (size, size):
            raise InputError(
                f"{subject}: a mass matrix of {kinematics.scene.name} has {size} rows and {size}"
                " columns"
            )
    return [entry for side in sides for entry in side], list(kinematics.mass_matrix) * len(sides)
