r"""Scenes that are too large to be written out: their structure, and one joint in full.

    omega = R^T Omega + e q'                R(q): axes of the carrier from those of the body,
    alpha = R^T Omega' + e q'' + R^T Omega x e q'                          e: along the joint
    a     = R^T A + alpha x r + omega x (omega x r)      r: from the joint to the mass centre C
    e . (I alpha + omega x I omega + r x m a) = e . tau

Omega and Omega' are the angular velocity and acceleration of the carrier, A the acceleration of
the joint minus gravity, all along the carrier's axes: what the recursion from body to body hands
on. The free body is cut at its joint; moments about the joint's axis leave out its reactions.
"""

from dataclasses import dataclass

from sympy import Add, Expr, Matrix, Symbol, symbols
from sympy.physics.vector import Dyadic, Point, Vector

from mechanics.equations import Line, Step
from mechanics.scene import Gravity, RigidBody, Scene
from mechanics.scene.loads import Torque
from mechanics.symbolic import tidy

CARRIER = ("Omega_x:z", "Omega_x:z_dot", "A_x:z")
OWN = ("omega_x:z", "alpha_x:z", "a_x:z")


@dataclass(frozen=True)
class Joint:
    """A body that carries no other, turned by one coordinate relative to what carries it.

    Attributes
    ----------
    body, carrier : RigidBody
    at : Point
        Of the joint.
    coordinate, rate, second : Symbol
    rotation : Matrix
        R: components along the carrier's axes from those along the body's.
    axis, arm : Matrix
        e and r, along the body's axes.
    torque : Expr
        e . tau of the loads, which are couples.
    """

    body: RigidBody
    carrier: RigidBody
    at: Point
    coordinate: Symbol
    rate: Symbol
    second: Symbol
    rotation: Matrix
    axis: Matrix
    arm: Matrix
    torque: Expr


def large_steps(scene: Scene) -> tuple[Step, ...]:
    """The structure of a scene, and its last joint in full where one is a hinge at a leaf."""
    found = last_joint(scene)
    return (_structure(scene), *(() if found is None else (_joint_step(scene, found),)))


def last_joint(scene: Scene) -> Joint | None:
    """The last body that a hinge holds and nothing else; None where there is none."""
    for body in reversed(scene.bodies):
        if isinstance(body, RigidBody) and (found := _joint(scene, body)) is not None:
            return found
    return None


def _joint(scene: Scene, body: RigidBody) -> Joint | None:
    holding = [r for r in scene.reactions if body.name in (r.on, r.by)]
    others = {name for r in holding for name in (r.on, r.by)} - {body.name}
    places = {r.at for r in holding if r.at is not None}
    loads = [o for o in scene.loads if not isinstance(o, Gravity) and body.name in _touched(o)]
    if {symbol.name for symbol in scene.parameters} & {str(s) for s in _introduced()}:
        return None
    if len(others) != 1 or len(places) != 1 or None in others:
        return None
    torques = [load for load in loads if isinstance(load, Torque)]
    if len(torques) < len(loads):
        return None
    carrier, at = scene.body(str(others.pop())), places.pop()
    if not isinstance(carrier, RigidBody):
        return None
    rotation = carrier.frame.dcm(body.frame).applyfunc(lambda entry: tidy(scene.plain(entry)))
    free = rotation.free_symbols & {*scene.q}
    arm = _column(scene, body, body.centre.pos_from(at))
    if len(free) != 1 or arm.free_symbols & {*scene.q}:
        return None
    q = free.pop()
    place = scene.q.index(q)
    skew = (rotation.T * rotation.diff(q)).applyfunc(tidy)
    axis = Matrix([skew[2, 1], skew[0, 2], skew[1, 0]])
    if axis.free_symbols & {*scene.q}:
        return None
    acting = (load.vector if load.on == body.name else -load.vector for load in torques)
    torque = Add(*(axis.dot(_column(scene, body, one)) for one in acting))
    return Joint(
        body, carrier, at, q, scene.qd[place], _second(scene, place), rotation, axis, arm,
        tidy(torque),
    )  # fmt: skip


def _column(scene: Scene, body: RigidBody, vector: Vector) -> Matrix:
    """Components along the axes of a body."""
    return vector.to_matrix(body.frame).applyfunc(lambda entry: tidy(scene.plain(entry)))


def _second(scene: Scene, place: int) -> Symbol:
    return Symbol(f"{scene.q[place].name}_ddot", real=True)


def _touched(load: object) -> set[str]:
    """Names of bodies that a load holds, or names that could be some."""
    return {value for value in vars(load).values() if isinstance(value, str)}


def _introduced() -> list[Symbol]:
    return [symbol for names in (*CARRIER, *OWN) for symbol in symbols(names, real=True)]


def equation(scene: Scene, joint: Joint) -> tuple[Line, ...]:
    """omega, alpha, a by components, then the moments about the joint's axis."""
    carried = [Matrix(symbols(names, real=True)) for names in CARRIER]
    own = [Matrix(symbols(names, real=True)) for names in OWN]
    (turning, growth, push), (omega, alpha, gain) = carried, own
    back, axis, arm = joint.rotation.T, joint.axis, joint.arm
    handed = back * turning
    values = (
        handed + joint.rate * axis,
        back * growth + joint.second * axis + handed.cross(joint.rate * axis),
        back * push + alpha.cross(arm) + omega.cross(omega.cross(arm)),
    )
    inertia = _inertia(scene, joint.body)
    spin = inertia * alpha + omega.cross(inertia * omega)
    moment = spin + arm.cross(scene.plain(joint.body.mass) * gain)
    words = ("angular velocity", "angular acceleration", "acceleration of the mass centre, less g")
    lines = [
        Line(symbol, tidy(entry), word, f"F{3 * k + i}")
        for k, (name, value, word) in enumerate(zip(own, values, words, strict=True))
        for i, (symbol, entry) in enumerate(zip(name, value, strict=True), start=1)
    ]
    moments = Line(tidy(axis.dot(moment)), joint.torque, "moments about the joint's axis", "F10")
    return (*lines, moments)


def _inertia(scene: Scene, body: RigidBody) -> Matrix:
    if isinstance(body.inertia, Dyadic):
        return body.inertia.to_matrix(body.frame).applyfunc(scene.plain)
    return Matrix.diag(0, 0, scene.plain(body.inertia))


def _joint_step(scene: Scene, joint: Joint) -> Step:
    lines = equation(scene, joint)
    body, carrier = (part.name.replace("_", " ") for part in (joint.body, joint.carrier))
    text = (
        f"{body} is cut free of {carrier} at their joint. Its motion follows from that of"
        f" {carrier}, whose angular velocity is $\\Omega$ and the acceleration of the joint, less"
        f" gravity, $A$, along the axes of {carrier}; all else is along the axes of {body}. The"
        " other joints go alike, from the last body to the first: each hands its force and moment"
        " on to what carries it."
    )
    return Step(f"One joint in full: {body}", text, lines)


def _structure(scene: Scene) -> Step:
    """Who is held by whom, and what is unknown."""
    holds: dict[str, list[str]] = {}
    for reaction in scene.reactions:
        names = (name or "the ground" for name in (reaction.on, reaction.by))
        pair = " and ".join(names).replace("_", " ")
        holds.setdefault(pair, []).append(reaction.name)
    freedoms, bodies = scene.degrees_of_freedom, len(scene.bodies)
    pairs = "; ".join(f"{pair}: {len(own)}" for pair, own in holds.items())
    held = f" Reactions between {pairs}." if pairs else ""
    text = (
        f"{bodies} {'body' if bodies == 1 else 'bodies'}, {freedoms} degrees of freedom,"
        f" {len(scene.reactions)} reactions, {len(scene.constraints)} constraints.{held}"
    )
    return Step("Structure", text, ())
