"""Which loads depend on reactions, and which body carries the point that a load acts on."""

from sympy.physics.vector import Point

from mechanics.errors import SceneError
from mechanics.scene.loads import Coulomb, Load
from mechanics.scene.scene import Scene


def frictions(scene: Scene) -> tuple[Coulomb, ...]:
    """The loads that depend on reactions."""
    return tuple(load for load in scene.loads if isinstance(load, Coulomb))


def carrier_of(scene: Scene, load: Load, point: Point, stated: str | None) -> str | None:
    """Name of the body that carries a point; None for the ground and for supports moved by hand."""
    if stated is not None:
        return stated
    centred = [body.name for body in scene.bodies if body.centre == point]
    if len(centred) == 1:
        return centred[0]
    position = scene.position(point)
    if not centred and not (position.free_symbols & set(scene.q)):
        return None
    raise SceneError(
        f"load {load.name}: it is unclear which body carries point {point.name}: name it"
    )
