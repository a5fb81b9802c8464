"""What kind of coordinate a name may be, by what people call angles and displacements.

theta, phi_1    an angle    x, s_2    a displacement    q, xi    either    E, v, omega    neither
"""

import re

from sympy import Derivative, S, Symbol, cos, sin
from sympy.core.function import AppliedUndef

from mechanics.scene import Scene
from mechanics.scene.loads import Force, Gravity, Torque

ANGLES = frozenset(
    ("theta", "phi", "psi", "alpha", "beta", "gamma", "vartheta", "varphi", "th", "ph", "ps")
)
LENGTHS = frozenset("xyzsrdlhuXYZSR")
NEITHER = frozenset((*"vwVWETUKHLPpFfMmIJNGgkct", "tau", "omega", "Omega", "lambda", "Lambda"))
"""Speeds, energies, forces, momenta, parameters."""
WORDS = {"ang": "angle", "rot": "angle", "tilt": "angle", "pos": "length", "disp": "length"}


def kinds(name: str) -> frozenset[str]:
    """``"angle"``, ``"length"``, both or none."""
    letters = re.split(r"[_\d]", name, maxsplit=1)[0]
    if letters in NEITHER:
        return frozenset()
    if letters in ANGLES:
        return frozenset(("angle",))
    if letters in LENGTHS:
        return frozenset(("length",))
    said = {kind for word, kind in WORDS.items() if word in name.lower()}
    return frozenset(said or ("angle", "length"))


def angular(scene: Scene) -> frozenset[Symbol]:
    """Coordinates that are angles: those whose sine or cosine places or turns a body.

    An arc s is none, which does so by s/R.
    """
    return scene.angles


def turning(scene: Scene) -> frozenset[Symbol]:
    """Angles that are the same a whole turn later; none where a load counts turns: a spring."""
    angles = angular(scene)
    return angles if all(_is_plain(load, angles) for load in scene.loads) else frozenset()


def _is_plain(load: object, angles: frozenset[Symbol]) -> bool:
    """Whether a load depends on angles by their sines, cosines and rates alone."""
    if isinstance(load, Gravity):
        return True
    if not isinstance(load, Force | Torque):
        return False
    names = {angle.name for angle in angles}
    entries = [entry for column, _ in load.vector.args for entry in column]
    reduced = [
        e.replace(lambda x: isinstance(x, sin | cos | Derivative), lambda _: S.One) for e in entries
    ]
    return not any(f.func.__name__ in names for e in reduced for f in e.atoms(AppliedUndef))


def quantity(scene: Scene, name: str) -> str:
    """What a name of the scene is: an angle, a length, an input, or a parameter of a unit."""
    if name in {symbol.name for symbol in scene.input_symbols}:
        return "input"
    if name in {symbol.name for symbol in scene.q}:
        return "angle" if name in {symbol.name for symbol in angular(scene)} else "length"
    units = {symbol.name: getattr(symbol, "unit", "") for symbol in scene.parameters}
    return f"parameter in {units[name]}" if name in units else ""
