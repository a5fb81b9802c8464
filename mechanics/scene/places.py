"""Points and directions of a scene by name, as ledgers of published equations refer to them."""

from collections.abc import Iterator

from sympy import Matrix
from sympy.physics.vector import Point

from mechanics.errors import InputError
from mechanics.nearest import instead
from mechanics.scene.geometry import point_path
from mechanics.scene.scene import Scene

AXES = ("x", "y", "z")


def points(scene: Scene) -> dict[str, Point]:
    """Every point that the scene mentions, and those on the way to them from the origin.

    Raises
    ------
    InputError
        When two of them have the same name.
    """
    found: dict[str, Point] = {}
    for end in _mentioned(scene):
        for point in point_path(scene.origin, end):
            if found.setdefault(point.name, point) != point:
                raise InputError(
                    f"{scene.name}: there are two points named {point.name}: rename one of them"
                )
    return found


def point_named(scene: Scene, name: str) -> Point:
    """The point of that name.

    Raises
    ------
    InputError
        When the scene has none.
    """
    known = points(scene)
    if name not in known:
        raise InputError(
            f"{scene.name}: there is no point {name!r}: {instead(name, sorted(known), 'points')}"
        )
    return known[name]


def direction(along: str) -> Matrix:
    """3 x 1 unit vector of an axis of the inertial frame: ``"x"``, ``"-z"``.

    Raises
    ------
    InputError
        When `along` is no axis.
    """
    sign, axis = (-1, along[1:]) if along.startswith("-") else (1, along)
    if axis not in AXES:
        raise InputError(f"direction {along!r} is no axis: write x, y, z, -x, -y or -z")
    return Matrix([sign * int(axis == name) for name in AXES])


def _mentioned(scene: Scene) -> Iterator[Point]:
    yield scene.origin
    for body in scene.bodies:
        yield body.centre
    acting = (action for reaction in scene.reactions for action in reaction.actions)
    for part in (*scene.loads, *acting):
        yield from (value for value in vars(part).values() if isinstance(value, Point))
    for output in scene.outputs.values():
        yield from (value for value in vars(output).values() if isinstance(value, Point))
