"""The inertia of a body taken wrongly.

I_C -> I_C + m d^2        parallel axis counted twice: I_C was about the joint already
I_C -> I_C - m d^2        parallel axis forgotten: I_C taken for that about the joint
I_C -> 0                  a point mass
"""

from collections.abc import Iterator, Mapping, Sequence

from sympy import Expr, Matrix, Rational, S, eye

from mechanics.blame.mistakes.fault_model import Change, Fault, Part, Right
from mechanics.blame.pieces import Kind, Origin, Piece, inner
from mechanics.kinematics.symbolic import BodyMotion
from mechanics.scene import RigidBody, Scene
from mechanics.scene.rates import rate_table, rates
from mechanics.scene.topology import tree
from mechanics.symbolic import canonical


def faults(right: Right) -> Iterator[Fault]:
    """Every body that turns and has an inertia, and then all of them."""
    turning = [
        name
        for name, motion in right.derivation.bodies.items()
        if motion.turns and isinstance(motion.body, RigidBody) and motion.body.inertia != 0
    ]
    growth = {name: _transfer(right, name) for name in turning}
    several = [(name,) for name in turning] + ([tuple(turning)] if len(turning) > 1 else [])
    for names in several:
        title, grown = ", ".join(names), {name: growth[name] for name in names}
        for factor, words in (
            (S.One, f"parallel axis counted twice: {title}"),
            (-S.One, f"parallel axis forgotten: {title}"),
        ):
            rows = tuple(
                (*row, *_added(right, index, grown, factor)) for index, row in enumerate(right.rows)
            )
            if rows != right.rows:
                yield Fault(words, rows, right.unknowns)
        yield from right.fault(f"rotational inertia is missing: {title}", _without(names))


def _without(names: tuple[str, ...]) -> Change:
    def change(piece: Piece) -> Sequence[Part]:
        own = piece.origin.kind is Kind.ANGULAR and piece.origin.body in names
        return () if own else ((S.One, piece),)

    return change


def _added(
    right: Right, index: int, grown: Mapping[str, Matrix | None], factor: Rational
) -> Iterator[Part]:
    """What m d^2 more (or less) in the inertia of bodies adds to a row."""
    for name, growth in grown.items():
        value = S.Zero if growth is None else _in_row(right, index, name, growth)
        if value != 0:
            yield factor, Piece(Origin(Kind.ANGULAR, name), value)


def _in_row(right: Right, index: int, name: str, growth: Matrix) -> Expr:
    """The rate of an angular momentum along the direction of a row, or times w_r."""
    if not right.free:
        turning = right.derivation.bodies[name].angular_velocity
        return inner(growth, turning.diff(right.scene.u[index]))
    row = right.derivation.momenta[index]
    own = row.body == name and row.kind == "angular"
    return inner(growth, row.direction) if own else S.Zero


def _transfer(right: Right, name: str) -> Matrix | None:
    """d/dt of (m d^2 - m d d^T) w, d from the inboard joint to the mass centre, 3 x 1, in N m."""
    scene, motion = right.scene, right.derivation.bodies[name]
    arm = _arm(scene, name, motion)
    if arm is None:
        return None
    square = canonical(inner(arm, arm))
    if square == 0 or square.free_symbols & {*scene.q, *scene.input_symbols}:
        return None
    tensor = motion.body.mass * (square * eye(3) - arm * arm.T)
    return rates((tensor * motion.angular_velocity).applyfunc(canonical), rate_table(scene))


def _arm(scene: Scene, name: str, motion: BodyMotion) -> Matrix | None:
    """From the joint that holds a body to its mass centre."""
    for reaction in tree(scene).joints.get(name, ()):
        if reaction.at is not None:
            return motion.centre.position - scene.position(reaction.at)
    return None
