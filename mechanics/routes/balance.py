"""One momentum principle written out for one free body.

    value = dH_B/dt + v_B x P - sum tau_B        along an axis            (1)
    value = dP/dt - sum F                        along a direction        (2)

For a screw both are added. The terms are made when they are asked for: elimination needs the value,
a report the rest.
"""

from dataclasses import dataclass

from sympy import Add, Expr, Matrix, Symbol

from mechanics.kinematics.textbook.motion import BodyMotion, PointMotion
from mechanics.routes.twists import Principle
from mechanics.scene.actions import Action


@dataclass(frozen=True)
class Part:
    """A body of the free body: its motion, H_C and dH_C/dt, 3 x 1 inertial components."""

    motion: BodyMotion
    spin: Matrix
    spin_rate: Matrix


@dataclass(frozen=True)
class Balance:
    """One principle for one free body; every term is projected on the principle's directions.

    Attributes
    ----------
    principle : Principle
    centre : PointMotion
        Of the moment centre B.
    parts : tuple of Part
    loads : tuple of Action
    coefficients : dict of Symbol to Expr
        What a unit of each kept reaction contributes.
    """

    principle: Principle
    centre: PointMotion
    parts: tuple[Part, ...]
    loads: tuple[Action, ...]
    coefficients: dict[Symbol, Expr]

    @property
    def momentum(self) -> Expr:
        """H_B = sum of H_C + (r_C - r_B) x m v_C, or P."""
        terms = []
        for part in self.parts:
            mass, c = part.motion.body.mass, part.motion.centre
            terms += [
                dot(self.principle.axis, part.spin),
                mass * triple(self.principle.axis, self._arm(part), c.velocity),
                mass * dot(self.principle.along, c.velocity),
            ]
        return Add(*terms)

    @property
    def momentum_rate(self) -> Expr:
        """dH_B/dt = sum of dH_C/dt + (r_C - r_B) x m a_C + (v_C - v_B) x m v_C, or dP/dt."""
        terms = [-self.moving_term]  # v_C x v_C = 0 leaves - v_B x P of the last sum
        for part in self.parts:
            mass, c = part.motion.body.mass, part.motion.centre
            terms += [
                dot(self.principle.axis, part.spin_rate),
                mass * triple(self.principle.axis, self._arm(part), c.acceleration),
                mass * dot(self.principle.along, c.acceleration),
            ]
        return Add(*terms)

    @property
    def moving_term(self) -> Expr:
        """v_B x P; zero for a linear principle."""
        axis, speed = self.principle.axis, self.centre.velocity
        return Add(
            *(
                part.motion.body.mass * triple(axis, speed, part.motion.centre.velocity)
                for part in self.parts
            )
        )

    @property
    def applied(self) -> Expr:
        """Moment about B, or force, of the loads."""
        terms = []
        for load in self.loads:
            arm = load.at - self.centre.position
            terms += [
                triple(self.principle.axis, arm, load.force),
                dot(self.principle.axis, load.couple),
                dot(self.principle.along, load.force),
            ]
        return Add(*terms)

    @property
    def value(self) -> Expr:
        """Rates minus loads; equal to the kept reactions' part."""
        return self.momentum_rate + self.moving_term - self.applied

    def _arm(self, part: Part) -> Matrix:
        return part.motion.centre.position - self.centre.position


def dot(one: Matrix, two: Matrix) -> Expr:
    """Scalar product of 3 x 1 columns, terms that are zero left out."""
    return Add(*(x * y for x, y in zip(one, two, strict=True) if x != 0 and y != 0))


def triple(axis: Matrix, one: Matrix, two: Matrix) -> Expr:
    """axis . (one x two), only for the components that the axis has."""
    terms = []
    for k in range(3):
        if axis[k] != 0:
            i, j = (k + 1) % 3, (k + 2) % 3
            terms += [axis[k] * one[i] * two[j], -axis[k] * one[j] * two[i]]
    return Add(*terms)
