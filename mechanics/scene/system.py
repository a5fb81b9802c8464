"""A system: how to make its scene, and the equations that its source publishes."""

from collections.abc import Callable
from dataclasses import dataclass

from mechanics.scene.published import Published
from mechanics.scene.scene import Scene


@dataclass(frozen=True)
class System:
    """A scene with the equations published for it.

    Attributes
    ----------
    name : str
        As the command line knows it.
    scene : callable
        Makes a new scene; SymPy's frames and points are mutable.
    published : tuple of Published
        Rows of the source, typed by hand; may be empty.
    """

    name: str
    scene: Callable[[], Scene]
    published: tuple[Published, ...] = ()
