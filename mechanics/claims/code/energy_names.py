"""Energies and mass matrices by the names of functions that return them.

potential_energy, totalEnergy, E_kin    the scene's
pole_kinetic_energy, spring_energy      of a part of it, which is asked for
"""

from mechanics.claims.code.function_names import function_name, spoken
from mechanics.claims.counting_words import ONE_OF_SEVERAL
from mechanics.errors import InputError
from mechanics.scene import Gravity, RigidBody, Scene
from mechanics.scene.loads import Spring, TorsionSpring

ENERGIES = frozenset(
    ("kinetic energy", "potential energy", "energy", "Lagrangian", "Hamiltonian")
)  # fmt: skip
SHORT = {
    "e": "energy", "ke": "kinetic energy", "pe": "potential energy", "kinetic": "kinetic energy",
    "potential": "potential energy", "e tot": "energy", "e kin": "kinetic energy",
    "e pot": "potential energy",
}  # fmt: skip
MASSES = ("mass", "mass matrix", "inertia", "inertia matrix", "m")
"""Names of functions that fill a square matrix."""
OF_SPRINGS = frozenset(("spring", "elastic", "strain"))
OF_GRAVITY = frozenset(("gravity", "gravitational", "height"))
OF_TURNING = frozenset(("rotational", "rotation", "translational", "translation", "spin"))


def named_by_title(title: str, count: int, size: int) -> str | None:
    """What a function returns by its own name, potential_energy; None where that does not tell.

    Parameters
    ----------
    title : str
    count : int
        How many numbers it returns.
    size : int
        How many speeds the scene has.
    """
    words = spoken(title)
    if count == size * size > 1 and words in MASSES:
        return "mass matrix"
    word = SHORT.get(words) or function_name(title).word
    return word if count == 1 and word in ENERGIES else None


def refuse_energy_of_a_part(scene: Scene, title: str) -> None:
    """Refuse an energy whose name says that it is that of a part of the scene.

    Raises
    ------
    InputError
    """
    said = function_name(title)
    part = sorted(said.owner & _parts(scene))
    digits = [word for word in said.owner if word.isdigit() and len(scene.bodies) > 1]
    if said.word in ENERGIES and (part or digits):
        raise InputError(
            f"{title} returns the {said.word} of {' '.join(part + digits)!r} alone, and only that"
            f" of the whole scene is judged: return the sum; if it is that, say so, --about"
            f" '{said.word}' (about=)"
        )


def _parts(scene: Scene) -> frozenset[str]:
    """Words for what has a part of the energy of a scene."""
    found: set[str] = set()
    if len(scene.bodies) > 1:
        found |= ONE_OF_SEVERAL.union(
            *(body.name.lower().replace("_", " ").split() for body in scene.bodies)
        )
    kinds = {type(load) for load in scene.loads}
    if Gravity in kinds and kinds & {Spring, TorsionSpring}:
        found |= OF_SPRINGS | OF_GRAVITY
    if any(isinstance(body, RigidBody) for body in scene.bodies):
        found |= OF_TURNING
    return frozenset(found)
