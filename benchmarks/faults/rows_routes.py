"""Faults in what is written out of routes, and in the adapters over SymPy's methods."""

from benchmarks.faults.fault import faults_in

TEXTBOOK = faults_in(
    "mechanics.routes.textbook",
    (
        "right = [-entry for entry in remainder(",
        "right = [entry for entry in remainder(",
        "written out: f has the wrong sign",
    ),
)

PRESSING = faults_in(
    "mechanics.routes.elimination",
    (
        "signed = {index: -c",
        "signed = {index: c",
        "friction: the pressing part, wrong sign",
    ),
)

DEPENDENT = faults_in(
    "mechanics.routes.kane",
    (
        "total = total + weight * plain[d]",
        "total = total - weight * plain[d]",
        "kane: dependent speeds move the other way",
    ),
)

BY_KANES_METHOD = (
    *faults_in(
        "mechanics.routes.kane_sympy",
        (
            "square[free:, :], right[free:, :])",
            "square[free:, :], -right[free:, :])",
            "kane (SymPy): b has the wrong sign",
        ),
        (
            '"velocity_constraints": forms,',
            '"velocity_constraints": [-2 * form + speeds[0] for form in forms],',
            "kane (SymPy): constraints hold the first speed",
        ),
        (
            "kinematic = [value - u for",
            "kinematic = [value + u for",
            "kane (SymPy): the declared speeds have the wrong sign",
        ),
        (
            "rows = (active + inertial)",
            "rows = (active - inertial)",
            "kane (SymPy): reactions, inertia with the wrong sign",
        ),
    ),
    *faults_in(
        "mechanics.routes.friction_reactions",
        (
            "friction * self.rest).applyfunc",
            "-friction * self.rest).applyfunc",
            "kane (SymPy): friction, the pressing part, wrong sign",
        ),
    ),
)

BY_BOTH_METHODS = faults_in(
    "mechanics.routes.sympy_model",
    (
        "yield self._material(name, at), signed",
        "yield self._material(name, at), -signed",
        "SymPy: forces have the wrong sign",
    ),
    (
        "yield self.turned(body.frame), signed",
        "yield self.turned(body.frame), -signed",
        "SymPy: couples have the wrong sign",
    ),
    (
        "point.v2pt_theory(centre, self.frame, self.turned(body.frame))",
        "point.set_vel(self.frame, centre.vel(self.frame))",
        "SymPy: points of loads do not turn with their bodies",
    ),
    (
        "velocity.dt(self.frame).express(self.frame)",
        "-velocity.dt(self.frame).express(self.frame)",
        "SymPy: mass centres accelerate backwards",
    ),
    (
        "child.dcm(parent).applyfunc",
        "parent.dcm(child).applyfunc",
        "SymPy: frames turn backwards",
    ),
    (
        "if not isinstance(body, RigidBody) or body.inertia == 0:",
        "if True:",
        "SymPy: every body is a point mass",
    ),
    (
        "arm = self.point(at).pos_from(self.point(body.centre))",
        "arm = -self.point(at).pos_from(self.point(body.centre))",
        "SymPy: loads act on the other side of the mass centre",
    ),
)

BY_LAGRANGES_METHOD = (
    *faults_in(
        "mechanics.routes.lagrange_sympy",
        (
            "_kinetic_energy(model) - potential",
            "_kinetic_energy(model) + potential",
            "lagrange (SymPy): L = T + V",
        ),
        (
            "return me.kinetic_energy(model.frame, *model.bodies.values())",
            "return 2 * me.kinetic_energy(model.frame, *model.bodies.values())",
            "lagrange (SymPy): T without its half",
        ),
        (
            "change.T * (forcing - mass * drift)",
            "change.T * forcing",
            "lagrange (SymPy): speeds whose definition turns, left out",
        ),
        (
            "bias - matrix * drift,",
            "bias + matrix * drift,",
            "lagrange (SymPy): b in speeds, wrong sign",
        ),
    ),
)

ROWS = (
    *TEXTBOOK,
    *PRESSING,
    *DEPENDENT,
    *BY_KANES_METHOD,
    *BY_BOTH_METHODS,
    *BY_LAGRANGES_METHOD,
)
