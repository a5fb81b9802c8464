"""Pairs and laws of a scene with constraints, at points where these hold.

Programs are compared at free points, which is not enough where two routes agree on the constraints
only; here the matrices in SymPy are compared, on the constraints where they differ off them.
"""

from collections.abc import Iterator, Mapping

from mechanics.checks import laws
from mechanics.checks.agreement import compare, compare_pairs, require_regular
from mechanics.checks.energy import check_energy
from mechanics.checks.friction import check_friction
from mechanics.checks.reactions import check_multipliers, check_reactions
from mechanics.equations import Equations
from mechanics.kernel import Finding
from mechanics.routes import kane
from mechanics.routes.kane_reactions import auxiliary_equations
from mechanics.scene import Scene

Pairs = dict[tuple[str, str], Finding]


def check_constrained(
    scene: Scene, derived: Mapping[str, Equations], support: Equations | None
) -> tuple[Pairs, list[Finding]]:
    """Pairs of routes, and the laws.

    Raises
    ------
    SingularError
        When a route does not determine the accelerations.
    """
    for equations in derived.values():
        require_regular(equations)
    return compare_pairs(derived), list(_laws(scene, derived, support))


def _laws(
    scene: Scene, derived: Mapping[str, Equations], support: Equations | None
) -> Iterator[Finding]:
    yield laws.check_kinematics(scene)
    yield from laws.check_potentials(scene)
    yield from laws.check_dampers(scene)
    yield from laws.check_ideal(scene)
    yield from check_friction(scene)
    for equations in derived.values():
        yield check_energy(equations, support)
        if equations.conjugate:
            yield laws.check_mass_matrix(equations)
    if "free_body" in derived:
        yield from check_reactions(derived["free_body"], auxiliary_equations(scene))
    reference = kane.derive_with_multipliers(scene)
    yield laws.check_mass_matrix(reference)
    for equations in derived.values():
        yield compare(reference, equations)
        if equations.multipliers:
            yield check_multipliers(reference, equations)
