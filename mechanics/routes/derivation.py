"""The four routes by name, and the equations of a scene by one of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from mechanics.equations import Equations, Step
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.routes import free_body, kane, lagrange, moving_point, steps
from mechanics.routes.rows import Rows
from mechanics.routes.textbook import Printer, textbook
from mechanics.scene import Scene


@dataclass(frozen=True)
class Route:
    """A way to the equations of motion.

    Attributes
    ----------
    name : str
    rows : callable
        Rows of a mechanism as a program.
    steps : callable
        How they are derived, for people, up to the result.
    """

    name: str
    rows: Callable[[Mechanism], Rows]
    steps: Callable[[Printer, Mechanism], tuple[Step, ...]]

    def derive(self, scene: Scene) -> Equations:
        """Equations of a scene, which is not asked whether it is admissible."""
        mechanism = lower(scene, Builder())
        return self.written(scene, mechanism, self.rows(mechanism))

    def written(self, scene: Scene, mechanism: Mechanism, rows: Rows) -> Equations:
        """Its rows as equations in SymPy; Kane's with dependent speeds put in."""
        if rows.route == "kane":
            rows = kane.with_dependent_speeds(mechanism, rows)
        return textbook(scene, mechanism, rows, self.steps)


ROUTES: tuple[Route, ...] = (
    Route("free_body", free_body.derive, steps.free_body),
    Route("moving_point", moving_point.derive, steps.moving_point),
    Route("kane", kane.derive, steps.kane),
    Route("lagrange", lagrange.derive, steps.lagrange),
)


def by_route(name: str, scene: Scene) -> Equations:
    """Equations of a scene by one route; see `Route.derive`."""
    (route,) = (route for route in ROUTES if route.name == name)
    return route.derive(scene)
