"""Potential energy of the conservative loads.

gravity           V = - sum_bodies m field . r
spring            V = k (d - l)^2 / 2
torsion spring    V = k angle^2 / 2
"""

from sympy import Abs, Add, Expr, Matrix, Rational, sqrt

from mechanics.errors import SceneError
from mechanics.scene.loads import CONSERVATIVE, Gravity, Load, Spring, TorsionSpring
from mechanics.scene.scene import Scene


def potential(scene: Scene) -> Expr:
    """Potential energy of all conservative loads, in J."""
    loads = (load for load in scene.loads if isinstance(load, CONSERVATIVE))
    return Add(*(load_potential(scene, load) for load in loads))


def load_potential(scene: Scene, load: Load) -> Expr:
    """Potential energy of one conservative load, in J."""
    half = Rational(1, 2)
    if isinstance(load, Gravity):
        field = scene.vector(load.field, load.name)
        return Add(*(-b.mass * scene.position(b.centre).dot(field) for b in scene.bodies))
    if isinstance(load, Spring):
        distance, _ = elongation(scene, load)
        stretch = distance - scene.plain(load.length, load.name)
        return half * scene.plain(load.stiffness, load.name) * stretch**2
    if isinstance(load, TorsionSpring):
        angle, stiffness = (scene.plain(e, load.name) for e in (load.angle, load.stiffness))
        return half * stiffness * angle**2
    raise SceneError(f"load {load.name}: it is not conservative and has no potential")


def elongation(scene: Scene, load: Spring) -> tuple[Expr, Matrix]:
    """Distance d of a spring and the unit direction from its first to its second end."""
    span = scene.position(load.second) - scene.position(load.first)
    if load.along is not None:
        direction = scene.vector(load.along, load.name)
        return span.dot(direction), direction
    distance = sqrt(sum(entry**2 for entry in span))
    if distance.has(Abs):
        raise SceneError(
            f"load {load.name}: its ends move on one line, so that its length is {distance}:"
            " give the direction with along="
        )
    return distance, span / distance
