"""Reactions that friction depends on, taken out of equations that are projected on the speeds.

    M u' = f + G N              rows of the method; N enters by its friction only             (1)
    C N  = d - a u'             one equation a reaction, from the motion that opens its joint  (2)

    (c M + G adj(C) a) u' = c f + G adj(C) d,          c = det C                               (3)

Nothing is divided by c, which friction at two contacts of one body makes zero where it jams.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, Matrix, S, Symbol

from mechanics.errors import SingularError
from mechanics.routes.sympy_model import Opening
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.scene.topology import tree
from mechanics.symbolic import canonical, collect_linear

Reactions = tuple[tuple[Symbol, Expr], ...]


def pressing(scene: Scene) -> tuple[Symbol, ...]:
    """The reactions that friction depends on, in the order of the scene."""
    named = {load.normal for load in frictions(scene)}
    return tuple(reaction.symbol for reaction in scene.reactions if reaction.name in named)


def opened(
    scene: Scene, wanted: Sequence[Symbol], distances: Sequence[Expr]
) -> tuple[Opening, ...]:
    """For each reaction everything outboard of its joint, moved along its direction.

    Raises
    ------
    SingularError
        When a reaction closes a loop of bodies.
    """
    bodies = tree(scene)
    found = []
    for symbol, distance in zip(wanted, distances, strict=True):
        reaction = scene.reaction(symbol.name)
        outer = next((name for name in bodies.order if reaction in bodies.joints[name]), None)
        if outer is None:
            raise SingularError(
                f"{scene.name}: the reaction {symbol}, on which friction depends, closes a loop of"
                " bodies: friction is derived in a tree of bodies"
            )
        found.append(Opening(reaction, bodies.subtree(outer), distance))
    return tuple(found)


@dataclass(frozen=True)
class Pressed:
    """Equation (2), in plain symbols."""

    normals: tuple[Symbol, ...]
    matrix: Matrix
    slope: Matrix
    rest: Matrix

    def put_into(self, mass: Matrix, forcing: Matrix) -> tuple[Matrix, Matrix]:
        """M and f of equation (3) from M and f + G N of equation (1)."""
        split = [collect_linear(entry, self.normals) for entry in forcing]
        rest = Matrix([left for _, left in split])
        scale, inverse = self._inverse
        friction = Matrix([columns for columns, _ in split]) * inverse
        return (
            (scale * mass + friction * self.slope).applyfunc(canonical),
            (scale * rest + friction * self.rest).applyfunc(canonical),
        )

    @property
    def _inverse(self) -> tuple[Expr, Matrix]:
        """c and c C^-1; c = 1 where it is a number."""
        scale = canonical(self.matrix.det(method="berkowitz"))
        adjugate = self.matrix.adjugate()
        return (S.One, adjugate / scale) if scale.is_number else (scale, adjugate)

    def solve(self, ud: Sequence[Symbol]) -> Reactions:
        """The reactions as functions of the accelerations."""
        sides = self.rest - self.slope * Matrix(ud)
        scale, inverse = self._inverse
        values = inverse * sides / scale
        return tuple(zip(self.normals, map(canonical, values), strict=True))


def pressed(scene: Scene, equations: Sequence[tuple[Symbol, Expr]]) -> Pressed:
    """Split ``expression = 0`` for each reaction into equation (2).

    Raises
    ------
    SingularError
        When an equation holds a reaction that no friction depends on: the joint is in a loop.
    """
    normals = tuple(symbol for symbol, _ in equations)
    others = {reaction.symbol for reaction in scene.reactions} - set(normals)
    matrix, slope, rest = [], [], []
    for symbol, expression in equations:
        columns, left = collect_linear(expression, (*normals, *scene.ud))
        if held := sorted(map(str, left.free_symbols & others)):
            raise SingularError(
                f"{scene.name}: the reaction {symbol}, on which friction depends, is in a loop with"
                f" {', '.join(held)}: friction is derived in a tree of bodies"
            )
        matrix.append(columns[: len(normals)])
        slope.append(columns[len(normals) :])
        rest.append(-left)
    return Pressed(normals, Matrix(matrix), Matrix(slope), Matrix(rest))
