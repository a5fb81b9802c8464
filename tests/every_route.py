"""Equations of one scene by several routes, lowered once."""

from collections.abc import Sequence

from mechanics.checks.admissible import check_scene
from mechanics.crosscheck.routes import named_routes
from mechanics.equations import Equations
from mechanics.scene import Scene


def derive_with(scene: Scene, names: Sequence[str] = ()) -> dict[str, Equations]:
    """Equations of motion by several routes, all of them for no name."""
    mechanism = check_scene(scene)
    return {
        route.name: route.equations(scene, mechanism, route.rows(mechanism))
        for route in named_routes(names)
    }
