"""The scene: one mechanical system, declared once, completed and validated."""

from dataclasses import dataclass
from functools import cached_property

from sympy import Symbol

from mechanics.nearest import plural
from mechanics.scene.angles import angular
from mechanics.scene.assembly import with_joints, with_rotations
from mechanics.scene.declaration import Declaration
from mechanics.scene.validate import validate
from mechanics.scene.wellformed import check_types


@dataclass(frozen=True, eq=False, repr=False)
class Scene(Declaration):
    """One mechanical system.

    Parameters
    ----------
    name : str
    frame : ReferenceFrame
        Inertial.
    origin : Point
        Fixed in the inertial frame.
    coordinates : tuple of dynamic symbols
        Generalized coordinates q.
    bodies, loads, reactions, constraints : tuples
        See the modules of these names.
    inputs : tuple of dynamic symbols
        Given functions of time: control forces, prescribed motions.
    speeds : tuple of (dynamic symbol, Expr)
        Generalized speeds u with their definition in q and q', linear in q'. Empty: u = q'.
    definitions : mapping of Symbol to Expr
        Parameters that stand for expressions in others (I_C for what the shapes give); they are
        expanded for proofs that need them.
    example : mapping of str to float
        Initial values of a motion worth looking at, by plain name (``"theta"``, ``"theta_dot"``).
    conditions : tuple of Condition
        Where the model is valid: contact that can only push, friction that holds.
    equilibria : tuple of mappings of str to number or constant Expr
        States of rest beside that where all coordinates are 0, by plain name
        (``{"theta": pi}``): what a person writes has to have a value there, too. Each has to be
        shown to be an equilibrium, for all values of the parameters or for their typical ones.
    rotations : tuple of Rotation
        Each brings four coordinates and three speeds; what was declared stands before them. Speeds
        of the other coordinates that are not declared are their rates.
    joints : tuple of Joint
        Their coordinates, reactions, constraints and rotations are added to those above.
    plane : Vector or None
        Normal of the plane that a scene of joints keeps: a pin then has two reactions, and not the
        three that hold it in the plane. None: joints hold in space.
    outputs : mapping of str to Output
        Positions, orientations and velocities that somebody wants computed, with their Jacobians:
        ``{"tool": position(P), "camera": orientation(F), "slip": velocity(Q, along=F.x)}``.
    notes : tuple of str
        What a reader of models did beside what stands there: ``"read 1.5708 as pi/2: joint q"``;
        what a source prints that no body can have, which is refused otherwise.
    redundant : str
        What is done about constraints that follow from those before them, three of a planar loop
        that a pin closes in space: ``"refuse"``, or ``"drop"``, which leaves them out with their
        reactions before equations are derived, and adds a note that names these. Rigid bodies do
        not determine how such loads are shared; the reactions that remain are right for joints that
        give way where one was left out.

    Raises
    ------
    SceneError
        When the scene cannot be right; the message names what is wrong.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> x, (m, k), N, O = dynamicsymbols("x"), parameters("m k"), ReferenceFrame("N"), Point("O")
    >>> P = O.locatenew("P", x * N.x)
    >>> rail = [reaction(f"R{e}", at=P, on="mass", by=None, along=e) for e in (N.y, N.z)]
    >>> Scene("oscillator", N, O, coordinates=(x,), bodies=(Particle("mass", P, m),),
    ...       loads=(spring("spring", O, P, k, along=N.x),), reactions=tuple(rail))
    <scene oscillator: 1 body, 1 coordinate, 0 constraints>
    """

    def __post_init__(self) -> None:
        check_types(self)
        for complete in (with_joints, with_rotations):
            for name, value in complete(self).items():
                object.__setattr__(self, name, value)
        validate(self)

    @cached_property
    def angles(self) -> frozenset[Symbol]:
        """Coordinates that are angles; readers of statements ask for them often."""
        return angular(self)

    def __repr__(self) -> str:
        return (
            f"<scene {self.name}: {plural(len(self.bodies), 'body')},"
            f" {plural(len(self.coordinates), 'coordinate')},"
            f" {plural(len(self.constraints), 'constraint')}>"
        )
