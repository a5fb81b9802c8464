"""Speeds and accelerations in which an equation is written: u and u', or q' and q''.

u = U(q, q'),    u' = dU/dt        where a person writes q' though the scene declares u
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from sympy import Expr, Symbol

from mechanics.blame.derivation import Derivation
from mechanics.blame.groups import second_rates
from mechanics.blame.pieces import Piece, merged
from mechanics.blame.rows import Row
from mechanics.routes.rows import velocity_forms
from mechanics.scene import Scene
from mechanics.scene.rates import coordinate_rate_table, rate, rate_table, speeds_in_rates


@dataclass(frozen=True, eq=False, repr=False)
class View:
    """A way to write the equations of a derivation.

    Attributes
    ----------
    in_rates : bool
        Whether in q' and q''; else in u and u'.
    """

    derivation: Derivation
    in_rates: bool

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self.derivation.scene

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

    @cached_property
    def forms(self) -> list[Expr]:
        """Constraints, linear in the speeds."""
        kinematics = self.derivation.truth.kinematics
        forms = velocity_forms(kinematics.mechanism)
        return [self.seen(form) for form in kinematics.printer(forms)] if forms else []

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """Lagrange's equation of each speed."""
        rows = self.derivation.generalized_rows
        if not self.in_rates:
            return rows
        return tuple(
            Row(f"Lagrange's equation of {speed.name}", merged(self._weighted(speed, rows)))
            for speed in self.speeds
        )

    def _weighted(self, speed: Symbol, rows: Sequence[Row]) -> Iterator[tuple[Expr, Piece]]:
        """Pieces of the equation of a speed, from those of the scene's speeds."""
        for u, row in zip(self.scene.u, rows, strict=True):
            slope = self.seen(u).diff(speed)  # how often the equation of u is in that of the speed
            if slope != 0:
                for piece in row.pieces:
                    yield slope, Piece(piece.origin, self.seen(piece.value))
