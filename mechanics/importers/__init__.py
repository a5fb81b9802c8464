"""Models of other programs, read as scenes, and scenes written for them."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from mechanics.scene import Scene
from mechanics.scene.declaration import DROP

if TYPE_CHECKING:
    from mechanics.importers.dh import from_dh
    from mechanics.importers.mjcf import from_mjcf
    from mechanics.importers.sympy_scene import from_sympy
    from mechanics.importers.sympy_system import to_sympy
    from mechanics.importers.urdf import from_urdf

__all__ = ["from_dh", "from_mjcf", "from_sympy", "from_urdf", "to_sympy"]

_MODULES = {
    "from_dh": "dh",
    "from_mjcf": "mjcf",
    "from_sympy": "sympy_scene",
    "from_urdf": "urdf",
    "to_sympy": "sympy_system",
}


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)


def as_scene(thing: Any, name: str = "") -> Any:
    """The scene of a model of SymPy's, one that asks for it without its redundant constraints.

    Anything else as it is.

    Parameters
    ----------
    name : str, optional
        Of the scene.
    """
    import sympy.physics.mechanics as me

    if isinstance(thing, (me.System, me.KanesMethod, me.LagrangesMethod)):
        return import_module(f"{__name__}.sympy_scene").from_sympy(thing, name=name)
    if isinstance(thing, Scene) and thing.redundant == DROP:
        return import_module("mechanics.routes.redundant").without_redundant(thing)
    return thing
