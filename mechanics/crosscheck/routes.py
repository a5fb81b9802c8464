"""The four routes, by name, and how a scene is derived by one of them."""

from collections.abc import Sequence
from typing import Any

from mechanics.checks.admissible import check_scene
from mechanics.equations import Equations, written_out
from mechanics.errors import InputError, wanted
from mechanics.importers import as_scene
from mechanics.nearest import instead
from mechanics.routes.derivation import ROUTES, Route
from mechanics.scene import Scene


def named_routes(names: Sequence[str]) -> tuple[Route, ...]:
    """Routes by name, in the order of `ROUTES`; all of them for no name.

    Raises
    ------
    InputError
        For a name that is no route.
    """
    known = [route.name for route in ROUTES]
    for name in names:
        if name not in known:
            raise InputError(f"route {name!r}: {instead(name, known, 'routes')}")
    return tuple(route for route in ROUTES if not names or route.name in names)


def derive(scene: Any, route: str | Route = "free_body") -> Equations:
    """Equations of motion of a scene by one route, after the scene was found admissible.

    Those of a scene that is too large for a person to read are a program alone, without matrices.

    Parameters
    ----------
    scene : Scene, or a System, KanesMethod or LagrangesMethod of SymPy's
    route : str or Route
        ``"free_body"``, ``"moving_point"``, ``"kane"`` or ``"lagrange"``, or one of `ROUTES`.

    Raises
    ------
    SceneError
        When the scene cannot be right.
    InputError
        For a name that is no route.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> equations = derive(rod_pendulum.scene(), "lagrange")
    >>> equations.mass, equations.forcing
    (Matrix([[l**2*m/3]]), Matrix([[g*l*m*sin(theta)/2 + u]]))
    """
    scene = as_scene(scene)
    wanted(scene, Scene, "derive", "pass what scene() of a system gives")
    chosen = route if isinstance(route, Route) else named_routes((route,))[0]
    mechanism = check_scene(scene)
    return chosen.equations(scene, mechanism, chosen.rows(mechanism))


def derive_textbook(scene: Any, route: str = "free_body") -> Equations:
    """The same for whoever needs M and f written out.

    Raises
    ------
    InputError
        Where the scene is too large for that.
    """
    return written_out(derive(scene, route))
