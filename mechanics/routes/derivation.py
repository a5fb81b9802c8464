"""The four routes by name, and the equations of a scene by one of them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from mechanics.equations import Equations, Line, Rows, Step
from mechanics.kernel.ring import TooLarge
from mechanics.kinematics.printer import Printer
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.routes import free_body, kane, lagrange, moving_point
from mechanics.routes.steps import free_body as free_body_steps
from mechanics.routes.steps import kane as kane_steps
from mechanics.routes.steps import lagrange as lagrange_steps
from mechanics.routes.steps import moving_point as moving_point_steps
from mechanics.routes.steps.form import common_form
from mechanics.routes.steps.writer import Writer
from mechanics.routes.textbook import textbook
from mechanics.scene import Scene

LARGEST_TEXTBOOK = 320
"""Operations of Kane's rows up to which the equations are written out; a free body takes 309."""
MOST_IN_SPACE = 3
"""Bodies with a full inertia up to which they are: more in space are no reading for a person."""


@dataclass(frozen=True, repr=False)
class Route:
    """A way to the equations of motion.

    Attributes
    ----------
    name : str
    rows : callable
        Rows of a mechanism as a program.
    steps : callable
        How they are derived, for people, the result last.
    """

    name: str
    rows: Callable[[Mechanism], Rows]
    steps: Callable[[Writer], tuple[Step, ...]]

    def __repr__(self) -> str:
        return f"<route {self.name}>"

    def derive(self, scene: Scene) -> Equations:
        """Equations of a scene, which is not asked whether it is admissible."""
        mechanism = lower(scene, Builder())
        return self.equations(scene, mechanism, self.rows(mechanism))

    def equations(self, scene: Scene, mechanism: Mechanism, rows: Rows) -> Equations:
        """Rows that it derived as equations, written in SymPy where a person can read them.

        Kane's have their dependent speeds put in there.
        """
        program = as_program(scene, mechanism, rows)
        if not is_written_out(mechanism):
            return program
        own = kane.with_dependent_speeds(mechanism, rows) if rows.route == "kane" else rows
        try:
            return textbook(as_program(scene, mechanism, own))
        except TooLarge:
            return program


ROUTES: tuple[Route, ...] = (
    Route("free_body", free_body.derive, free_body_steps.steps),
    Route("moving_point", moving_point.derive, moving_point_steps.steps),
    Route("kane", kane.derive, kane_steps.steps),
    Route("lagrange", lagrange.derive, lagrange_steps.steps),
)


def by_route(name: str, scene: Scene) -> Equations:
    """Equations of a scene by one route; see `Route.derive`."""
    return _named(name).derive(scene)


def is_written_out(mechanism: Mechanism) -> bool:
    """Whether a scene is small enough for its equations to be read, by any route.

    Decided by counts alone, before anything is written. Quaternions leave quotients all over them.
    """
    if any(frame.spin is not None for frame in mechanism.frames):
        return False
    in_space = sum(body.inertia is not None and not body.scalar for body in mechanism.bodies)
    if in_space > MOST_IN_SPACE:
        return False
    rows = kane.derive(mechanism).values
    return mechanism.builder.program({"rows": rows}).count <= LARGEST_TEXTBOOK


def steps_of(equations: Equations, goal: tuple[Line, ...] = ()) -> tuple[Step, ...]:
    """The derivation in steps, in the order in which it is carried out; the result is last.

    Parameters
    ----------
    equations : Equations
        Written out.
    goal : tuple of Line
        The common form of the scene, see `goal_of`; found out where it is not given.
    """
    if equations.mechanism is None or equations.rows is None:
        return (equations.result,)
    printer = Printer(equations.scene, equations.mechanism)
    pressing = {
        equations.mechanism.reactions[f.reaction].name for f in equations.mechanism.frictions
    }
    pressed = {s: value for s, value in equations.reactions if s.name in pressing}
    writer = Writer(printer, equations.mechanism, goal or goal_of((equations,)), pressed)
    return _named(equations.rows.route).steps(writer)


def goal_of(derived: Sequence[Equations]) -> tuple[Line, ...]:
    """What all routes give, once: by the first of them whose rows are power-conjugate to u.

    Where none is, Lagrange's or, without multipliers, Kane's are derived. Empty where the scene is
    too large to be written out.
    """
    written = [one for one in derived if one.textbook is not None]
    if not written:
        return ()
    conjugate = (one for one in written if one.conjugate)
    other = "lagrange" if written[0].scene.constraints else "kane"
    first = next(conjugate, None) or by_route(other, written[0].scene)
    return common_form(first if first.textbook is not None else written[0])


def _named(name: str) -> Route:
    return next(route for route in ROUTES if route.name == name)


def as_program(scene: Scene, mechanism: Mechanism, rows: Rows) -> Equations:
    """Rows of a route as equations without matrices."""
    multipliers = tuple(map(Printer(scene, mechanism).symbol, rows.multipliers))
    return Equations(
        scene, rows.route, multipliers, rows.conjugate, mechanism, rows, chosen=rows.chosen
    )
