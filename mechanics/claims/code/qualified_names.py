"""Words in the name of a function that say which acceleration or energy it returns.

cart_acceleration, thetaDDot, get_alpha, total_energy     the scene's
minus_alpha, energy_per_mass, tip_acceleration, thdd_deg  another one: open
crane_acceleration, pendel_energy                         a word that nothing knows: quoted
"""

import re

from mechanics.claims.code.function_names import spoken
from mechanics.claims.counting_words import COUNTED
from mechanics.claims.foreign_units import LAST_WORDS
from mechanics.claims.guess import is_short_for
from mechanics.claims.spelled_rates import bases, key
from mechanics.scene import Scene

HEAD = re.compile(
    r"acc|accels?|accelerations?|alphas?|ddot|dd|qdd|ddq|(?:co)?energ(?:y|ies)|lagrangian"
    r"|hamiltonian|momentum"
)
"""What is qualified."""
OTHERWISE = frozenset((
    *["per", "minus", "neg", "negative", "reversed", "jerk", "deceleration"],
    *(unit.lower() for unit in LAST_WORDS if len(unit) > 2),
))  # fmt: skip
"""What makes anything another one."""
_QUALIFIERS = (
    "half halved twice doubled specific dimensionless normalized normalised scaled mean average avg"
    " not relative tip rim end centre center cm com cg error loss change delta initial"
    " desired above below linearized linearised approx"
)
QUALIFIERS = frozenset(_QUALIFIERS.split())
"""What makes an acceleration or energy another one."""
_PLAIN = (
    "angular rotational generalized joint joints system total mechanical full exact nonlinear state"
    " vector all get compute calc calculate eval evaluate fun func function fn fcn ode rhs dynamics"
    " eom model motion forward of the my new next time at numeric num value val from with by for"
    " under given and to body rigid pendulum kinetic potential conserved mass torque force input"
    " control"
)
PLAIN = frozenset(_PLAIN.split())
"""What tells nothing apart."""


def another_quantity_word(scene: Scene, title: str) -> str:
    """The word by which a function returns something else than the scene has; empty for none.

    Parameters
    ----------
    scene : Scene
    title : str
        The name of the function.
    """
    words = _words(title)
    said = OTHERWISE | {*(QUALIFIERS if _is_headed(scene, words) else ())}
    return next((w for w in words if w in said - _words_of(scene)), "")


def unknown_qualifiers(scene: Scene, title: str) -> tuple[str, ...]:
    """Words beside an acceleration or energy in the name of a function that nothing knows.

    Parameters
    ----------
    scene : Scene
    title : str
    """
    words = _words(title)
    if not _is_headed(scene, words):
        return ()
    known = {*PLAIN, *_words_of(scene), *(word for some in COUNTED for word in some)}
    rest = [w for w in words if len(w) > 1 and w not in known and not HEAD.fullmatch(w)]
    return tuple(w for w in rest if not _orders(scene, w))


def _is_headed(scene: Scene, words: list[str]) -> bool:
    return any(HEAD.fullmatch(word) or 2 in _orders(scene, word) for word in words)


def _orders(scene: Scene, word: str) -> set[int]:
    """The orders of the rates of coordinates that a word may be, th and thdd of theta."""
    names = [re.sub(r"\d", "", key(q.name)).lower() for q in scene.q]
    every = ((word, 0), *bases(word))
    return {order for base, order in every if any(is_short_for(base, name) for name in names)}


def _words_of(scene: Scene) -> set[str]:
    """Words of a scene, its bodies and its inputs."""
    names = [scene.name, *(body.name for body in scene.bodies), *map(str, scene.input_symbols)]
    return {word for name in names for word in re.findall("[a-z]+", name.lower())}


def _words(title: str) -> list[str]:
    return [re.sub(r"\d", "", word) for word in spoken(title).split() if not word.isdigit()]
