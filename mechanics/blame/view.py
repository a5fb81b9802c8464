"""Speeds and accelerations in which an equation is written: u and u', or q' and q''.

u = U(q, q'),    u' = dU/dt        where a person writes q' though the scene declares u
"""

from dataclasses import dataclass
from functools import cached_property

from sympy import Expr, Symbol

from mechanics.equations import Equations
from mechanics.kinematics.constraints import velocity_forms
from mechanics.scene import Scene
from mechanics.scene.rates import coordinate_rate_table, rate, rate_table, speeds_in_rates
from mechanics.scene.symbols import plain_symbol


@dataclass(frozen=True)
class View:
    """A way to write the equations of a scene.

    Attributes
    ----------
    truth : Equations
    in_rates : bool
        Whether in q' and q''; else in u and u'.
    """

    truth: Equations
    in_rates: bool

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self.truth.scene

    @cached_property
    def speeds(self) -> tuple[Symbol, ...]:
        """Speeds in which equations are written."""
        return self.scene.qd if self.in_rates else self.scene.u

    @cached_property
    def accelerations(self) -> tuple[Symbol, ...]:
        """Their rates."""
        return second_rates(self.scene) if self.in_rates else self.scene.ud

    @cached_property
    def clock(self) -> dict[Symbol, Expr]:
        """Rate of every symbol."""
        return coordinate_rate_table(self.scene) if self.in_rates else rate_table(self.scene)

    @cached_property
    def _table(self) -> dict[Symbol, Expr]:
        if not self.in_rates:
            return {}
        scene = self.scene
        own = speeds_in_rates(scene)
        return own | {ud: rate(own[u], self.clock) for u, ud in zip(scene.u, scene.ud, strict=True)}

    def seen(self, expression: Expr) -> Expr:
        """An expression in these speeds."""
        return expression.xreplace(self._table) if self._table else expression

    def slope(self, speed: Symbol, index: int) -> Expr:
        """du/dspeed of one of the scene's speeds: how often its equation is in that of `speed`."""
        return self.seen(self.scene.u[index]).diff(speed)

    def forms(self) -> list[Expr]:
        """Constraints, linear in the speeds."""
        return [self.seen(form) for form in velocity_forms(self.scene)]


def second_rates(scene: Scene) -> tuple[Symbol, ...]:
    """q'' as plain symbols."""
    return tuple(plain_symbol(q, 2) for q in scene.coordinates)


def view_of(truth: Equations, expression: Expr) -> View:
    """The view in which an expression is written."""
    scene = truth.scene
    rates = {*scene.qd, *second_rates(scene)} - {*scene.u, *scene.ud}
    return View(truth, bool(expression.free_symbols & rates))
