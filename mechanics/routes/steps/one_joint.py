r"""Scenes that are too large to be written out: their structure, and one joint in full.

    omega = R^T Omega + e q'                R(q): axes of the carrier from those of the body,
    alpha = R^T Omega' + e q'' + R^T Omega x e q'                          e: along the joint
    a     = R^T A + alpha x r + omega x (omega x r)      r: from the joint to the mass centre C
    e . (I alpha + omega x I omega + r x m a) = e . (tau + sum of rho x S)

Omega and Omega' are the angular velocity and acceleration of the carrier, A the acceleration of
the joint minus gravity, all along the carrier's axes: what the recursion from body to body hands
on. S are the forces of contacts and cut joints, rho their arms from the joint. The joint is one
that moves no other body, so that every route finds this row:

    free body     J = m a - S,   e . (I alpha + omega x I omega) = e . (tau - r x J + (rho - r) x S)
    moving point  H_B = I omega + r x m v,   e . (H_B' + v_B x m v) = e . (tau + rho x S)
    Kane          dv/dq' = e x r,   domega/dq' = e
    Lagrange      d/dt dT/dq' and dT/dq share m v . (omega x (e x r)) + (omega x e) . I omega
"""

from collections.abc import Iterator
from dataclasses import dataclass

from sympy import Add, Expr, Matrix, Symbol, symbols
from sympy.physics.vector import Dyadic, Point, Vector

from mechanics.equations import Line, Step, Term
from mechanics.kinematics.motion import poses
from mechanics.kinematics.printer import Printer
from mechanics.mechanism import Mechanism
from mechanics.program.derivatives import gradient
from mechanics.routes.steps.writer import Numbers, Writer
from mechanics.scene import Gravity, RigidBody, Scene
from mechanics.scene.loads import Torque
from mechanics.symbolic import tidy

CARRIER = ("Omega_x:z", "Omega_x:z_dot", "A_x:z")
OWN = ("omega_x:z", "alpha_x:z", "a_x:z", "v_x:z", "J_x:z")
"""Of the body: angular velocity and acceleration, the mass centre's acceleration less gravity and
velocity, the force of the joint."""
MOTION = (
    "angular velocity",
    "angular acceleration",
    "acceleration of the mass centre",
)


@dataclass(frozen=True)
class Contact:
    """A force on the body at another point than the joint, that of a contact or of a cut joint."""

    other: str
    arm: Matrix
    force: Matrix
    at: Point


@dataclass(frozen=True)
class Joint:
    """A hinge that moves one body alone, by one coordinate relative to what carries it.

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
    contacts : tuple of Contact
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
    contacts: tuple[Contact, ...]


def large_steps(scene: Scene, mechanism: Mechanism) -> dict[str, tuple[Step, ...]]:
    """By route: one joint in full, where there is a hinge that moves one body alone.

    The structure of the scene, and the motion of the body, stand before the first.
    """
    joint = last_joint(scene, mechanism)
    if joint is None:
        return {"free_body": (_structure(scene),)}
    row = Row(scene, joint, Writer(Printer(scene, mechanism), mechanism, (), {}))
    name = _words(joint.body.name)
    kinematics = Step(f"One joint in full: {name}", _introduction(row), row.motion())
    return {
        "free_body": (_structure(scene), kinematics, free_body(row)),
        "moving_point": (moving_point(row),),
        "kane": (kane(row),),
        "lagrange": (lagrange(row),),
    }


def last_joint(scene: Scene, mechanism: Mechanism) -> Joint | None:
    """The last body that a hinge moves, and that moves no other; None where there is none."""
    if {symbol.name for symbol in scene.parameters} & {str(s) for s in _introduced()}:
        return None
    for body in reversed(scene.bodies):
        if isinstance(body, RigidBody):
            for carrier, at in _holders(scene, body):
                joint = _joint(scene, body, carrier, at)
                if joint is not None and _moves_alone(mechanism, joint):
                    return joint
    return None


def _holders(scene: Scene, body: RigidBody) -> Iterator[tuple[RigidBody, Point]]:
    """Bodies, and points at which they hold a body."""
    for reaction in scene.reactions:
        if reaction.at is not None and reaction.by is not None and not reaction.parts:
            pair = {reaction.on, reaction.by}
            if body.name in pair:
                carrier = scene.body(str((pair - {body.name}).pop()))
                if isinstance(carrier, RigidBody):
                    yield carrier, reaction.at


def _joint(scene: Scene, body: RigidBody, carrier: RigidBody, at: Point) -> Joint | None:
    loads = [o for o in scene.loads if not isinstance(o, Gravity) and body.name in _touched(o)]
    torques = [load for load in loads if isinstance(load, Torque)]
    if len(torques) < len(loads):
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
    contacts = _contacts(scene, body, carrier, at)
    if axis.free_symbols & {*scene.q} or contacts is None:
        return None
    acting = (load.vector if load.on == body.name else -load.vector for load in torques)
    torque = Add(*(axis.dot(_column(scene, body, one)) for one in acting))
    return Joint(
        body, carrier, at, q, scene.qd[place], _second(scene, place), rotation, axis, arm,
        tidy(torque), contacts,
    )  # fmt: skip


def _contacts(
    scene: Scene, body: RigidBody, carrier: RigidBody, at: Point
) -> tuple[Contact, ...] | None:
    """Where else forces hold a body; None where a couple does."""
    places: dict[Point, str] = {}
    for one in scene.reactions:
        if body.name not in (one.on, one.by) or (carrier.name in (one.on, one.by)):
            continue
        if one.at is None or one.parts:
            return None
        places[one.at] = (one.by if one.on == body.name else one.on) or "the ground"
    found = []
    for k, (place, other) in enumerate(places.items(), start=1):
        index = f"_{k}" if len(places) > 1 else ""
        vector = place.pos_from(at)
        fixed = not any(f not in (body.frame,) for _, f in vector.args)
        rho, force = (Matrix(symbols(f"{s}{index}_x:z", real=True)) for s in ("rho", "S"))
        found.append(Contact(other, _column(scene, body, vector) if fixed else rho, force, place))
    return tuple(found)


def _moves_alone(mechanism: Mechanism, joint: Joint) -> bool:
    """Whether no other body is displaced by the coordinate of a joint."""
    here = poses(mechanism)
    q = mechanism.builder.input(joint.coordinate.name)
    for body in mechanism.bodies:
        if body.name != joint.body.name:
            entries = [*here.positions[body.centre]]
            if body.frame is not None:
                entries += [entry for line in here.rotations[body.frame] for entry in line]
            if not gradient(entries, [1] * len(entries), (q,))[0].is_zero:
                return False
    return True


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


@dataclass(frozen=True)
class Row:
    """The quantities that the routes share, along the axes of the body.

    Components that the motion in a plane leaves at zero are zero.
    """

    scene: Scene
    joint: Joint
    writer: Writer

    def own(self, letter: str) -> Matrix:
        """Components of a vector of `CARRIER` or `OWN` by its first letters."""
        names = next(n for n in (*CARRIER, *OWN) if n.replace("_x:z", "") == letter)
        turning = letter.lower().startswith(("omega", "alpha"))
        column = Matrix(symbols(names, real=True))
        if not isinstance(self.joint.body.inertia, Dyadic):
            column = Matrix([0, 0, column[2]]) if turning else Matrix([*column[:2], 0])
        return column

    @property
    def mass(self) -> Expr:
        """Of the body."""
        return self.scene.plain(self.joint.body.mass)

    @property
    def centre(self) -> str:
        """A letter for the mass centre that the scene does not use."""
        return self._letter("CGKM")

    @property
    def place(self) -> str:
        """A letter for the joint that the scene does not use."""
        return self._letter("BDPQ")

    def _letter(self, letters: str) -> str:
        taken = {point.name for point in self.writer.mechanism.points}
        taken |= {reaction.name[:1] for reaction in self.scene.reactions}
        return next((letter for letter in letters if letter not in taken), letters[0])

    @property
    def inertia(self) -> Matrix:
        """About the mass centre."""
        return _inertia(self.scene, self.joint.body)

    @property
    def spin_rate(self) -> Expr:
        """e . (I alpha + omega x I omega)."""
        omega = self.own("omega")
        return self.joint.axis.dot(
            self.inertia * self.own("alpha") + omega.cross(self.inertia * omega)
        )

    @property
    def falls(self) -> bool:
        """Whether there is gravity."""
        return any(isinstance(load, Gravity) for load in self.scene.loads)

    @property
    def tangent(self) -> Matrix:
        """e x r."""
        return self.joint.axis.cross(self.joint.arm)

    def pushes(self) -> Matrix:
        """The sum of S."""
        return sum((c.force for c in self.joint.contacts), Matrix([0, 0, 0]))

    def moment(self) -> Expr:
        """e . (tau + sum of rho x S)."""
        moments = (self.joint.axis.dot(c.arm.cross(c.force)) for c in self.joint.contacts)
        return Add(self.joint.torque, *moments)

    def motion(self) -> tuple[Line, ...]:
        """omega, alpha and a from what the carrier hands on."""
        back, axis, arm = self.joint.rotation.T, self.joint.axis, self.joint.arm
        omega, alpha = self.own("omega"), self.own("alpha")
        handed = back * self.own("Omega")
        turn = axis * self.joint.rate
        values = {
            "omega": handed + turn,
            "alpha": back * self.own("Omega_dot") + axis * self.joint.second + handed.cross(turn),
            "a": back * self.own("A") + alpha.cross(arm) + omega.cross(omega.cross(arm)),
        }
        numbers = Numbers("F")
        return tuple(
            numbers(symbol, tidy(value), word)
            for (letter, column), word in zip(values.items(), MOTION, strict=True)
            for symbol, value in zip(self.own(letter), column, strict=True)
            if symbol != 0
        )

    def result(self, numbers: Numbers, label: str) -> Line:
        """The row in which every route ends."""
        moment = self.spin_rate + self.joint.axis.dot(
            self.joint.arm.cross(self.mass * self.own("a"))
        )
        leading = {*self.own("alpha"), *self.own("a")}
        parts = sorted(
            Add.make_args(tidy(moment)), key=lambda part: not part.free_symbols & leading
        )
        left = tuple(Term(part) for part in parts)
        return numbers(left, tidy(self.moment()), label)


def free_body(row: Row) -> Step:
    """The joint's force from the momentum, put into the moments about the mass centre."""
    numbers = _after(row)
    joint, a, force = row.joint, row.own("a"), row.own("J")
    couples = Add(
        joint.torque,
        joint.axis.dot(force.cross(joint.arm)),
        *(joint.axis.dot((c.arm - joint.arm).cross(c.force)) for c in joint.contacts),
    )
    c, total = row.centre, tidy(couples)
    text = (
        f"$\\vec J$ is the force of the joint on the body. Moments about the mass centre ${c}$"
        " along the axis are the rate of angular momentum."
    )
    if not total.free_symbols & {*force}:
        line = row.result(numbers, f"moments about ${c}$, where $\\vec J$ has none along the axis")
        return Step("Free body", text, (line,))
    forces = [
        numbers(symbol, tidy(row.mass * one - push), "momentum")
        for symbol, one, push in zip(force, a, row.pushes(), strict=True)
        if symbol in total.free_symbols
    ]
    moments = numbers(tidy(row.spin_rate), total, f"moments about ${c}$")
    into = ", ".join(f"({line.number})" for line in forces)
    end = row.result(numbers, f"{into} into ({moments.number})")
    return Step("Free body", text, (*forces, moments, end))


def moving_point(row: Row) -> Step:
    """Moments about the joint, whose force has none there."""
    numbers, joint, letter = Numbers("P"), row.joint, row.writer.letter("spin")
    b, c = row.place, row.centre
    spin = joint.axis.dot(row.inertia * row.own("omega") + joint.arm.cross(row.mass * row.own("v")))
    lines = (
        numbers(rf"\vec e \cdot \vec{{{letter}}}_{{{b}}}", tidy(spin), "about the joint"),
        numbers(rf"\vec e \cdot \vec\tau_{{{b}}}", tidy(row.moment()), "moments about the joint"),
    )
    spins = rf"\vec{{{letter}}}_{{{b}}} = \vec{{{letter}}}_{{{c}}} + \vec r \times m \vec v"
    text = (
        f"The moment centre is the joint ${b}$, because its force has no moment there. ${spins}$"
        rf" with the velocity $\vec v$ of the mass centre ${c}$. In the rate of it"
        rf" $\dot{{\vec r}} \times m \vec v$ and $\vec v_{{{b}}} \times m \vec v$ of the"
        rf" principle cancel, since $\dot{{\vec r}} = \vec v - \vec v_{{{b}}}$."
    )
    text += r" Weight is in $\vec a$." if row.falls else ""
    rate = rf"\dot{{\vec{{{letter}}}}}_{{{b}}} + \vec v_{{{b}}} \times m \vec v"
    law = rf"$\vec e \cdot ({rate})$ from (P1) is (P2)"
    return Step("Moments about the joint", text, (*lines, row.result(numbers, law)))


def kane(row: Row) -> Step:
    """Partial velocities of the rate of the coordinate, active and inertia forces."""
    numbers, joint = Numbers("K"), row.joint
    name, force = joint.rate.name, row.writer.letter("active")
    vectors = {rf"\vec v_{{{row.centre}}}": row.tangent, r"\vec \omega": joint.axis}
    partial = [
        numbers(rf"\frac{{\partial {vector}}}{{\partial <<{name}>>}}", column)
        for vector, column in vectors.items()
        if any(column)
    ]
    active = numbers(rf"{force}_{{<<{name}>>}}", tidy(row.moment()), "active force")
    against = -row.spin_rate - row.mass * row.own("a").dot(row.tangent)
    inertia = numbers(rf"{force}^{{*}}_{{<<{name}>>}}", tidy(against), "inertia force")
    law = rf"({active.number}) and ({inertia.number}) into ${force} + {force}^{{*}} = 0$"
    text = "No other body moves with this speed, and reactions of the joint do no work."
    text += " Weight is counted with the inertia force, by $\\vec a$." if row.falls else ""
    return Step("Kane's equation", text, (*partial, active, inertia, row.result(numbers, law)))


def lagrange(row: Row) -> Step:
    """Both derivatives of the kinetic energy; what they share cancels."""
    numbers, joint = Numbers("L"), row.joint
    q, rate = joint.coordinate.name, joint.rate.name
    t, forces = row.writer.letter("kinetic"), row.writer.letter("forces")
    v, omega = row.own("v"), row.own("omega")
    spin = row.inertia * omega
    momentum = row.mass * v.dot(row.tangent) + joint.axis.dot(spin)
    shared = row.mass * v.dot(omega.cross(row.tangent)) + omega.cross(joint.axis).dot(spin)
    grown = row.spin_rate + row.mass * row.own("a").dot(row.tangent)
    potential = row.writer.letter("potential")
    stored = rf" + \frac{{\partial {potential}}}{{\partial <<{q}>>}}" if row.falls else ""
    by_rate = rf"\frac{{\partial {t}}}{{\partial <<{rate}>>}}"
    cancels = tidy(shared)
    lines = (
        numbers(by_rate, tidy(momentum)),
        numbers(
            rf"\frac{{d}}{{dt}} {by_rate}{stored}",
            (Term(tidy(grown)), *([Term(cancels, cancels=True)] if cancels != 0 else [])),
        ),
        numbers(rf"\frac{{\partial {t}}}{{\partial <<{q}>>}}", cancels),
        numbers(rf"{forces}_{{<<{q}>>}}", tidy(row.moment()), "generalized force"),
    )
    text = (
        r"Of the kinetic energy $\frac{1}{2} m v^2 + \frac{1}{2} \vec\omega \cdot \mathbf{I}"
        r" \vec{\omega}$ of this body alone, because no other moves with the coordinate."
    )
    text += " What gravity does is in $\\vec a$." if row.falls else ""
    ends = "(L2) less (L3) is (L4)"
    return Step("Lagrange's equation", text, (*lines, row.result(numbers, ends)))


def _after(row: Row) -> Numbers:
    """Numbers that follow those of the motion."""
    numbers = Numbers("F")
    for _ in row.motion():
        numbers("", "")
    return numbers


def _words(name: str) -> str:
    return name.replace("_", " ")


def _introduction(row: Row) -> str:
    joint = row.joint
    body, carrier = _words(joint.body.name), _words(joint.carrier.name)
    less = ", less gravity," if row.falls else ""
    text = (
        f"{body} is cut free of {carrier} at their joint. Its motion follows from that of"
        f" {carrier}, whose angular velocity is $\\vec\\Omega$ and the acceleration of the"
        f" joint{less} $\\vec A$, along the axes of {carrier}; all else is along the axes of"
        f" {body}. $<<{joint.second.name}>>$ is in $\\vec\\alpha$, and by it in $\\vec a$."
    )
    several = len(joint.contacts) > 1
    for k, contact in enumerate(joint.contacts, start=1):
        index = f"_{k}" if several else ""
        text += (
            f" $\\vec S{index}$ is the force of {_words(contact.other)} on it, and"
            f" $\\vec\\rho{index}$ leads there from the joint."
        )
    return text + (
        " The other joints go alike, from the last body to the first: each hands its force and"
        " moment on to what carries it."
    )


def _inertia(scene: Scene, body: RigidBody) -> Matrix:
    if isinstance(body.inertia, Dyadic):
        return body.inertia.to_matrix(body.frame).applyfunc(scene.plain)
    return Matrix.diag(0, 0, scene.plain(body.inertia))


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
        f"{bodies} {'body' if bodies == 1 else 'bodies'},"
        f" {freedoms} {'degree' if freedoms == 1 else 'degrees'} of freedom,"
        f" {len(scene.reactions)} reactions, {len(scene.constraints)} constraints.{held}"
    )
    return Step("Structure", text, ())
