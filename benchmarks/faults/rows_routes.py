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
            "model.vector(action.force, dynamic)))",
            "model.vector(-action.force, dynamic)))",
            "kane (SymPy): forces at mass centres, wrong sign",
        ),
        (
            "velocity = motion.centre.velocity + motion.angular_velocity",
            "velocity = motion.centre.velocity - motion.angular_velocity",
            "kane (SymPy): points of loads move the wrong way",
        ),
        (
            "arm = action.at - motion.centre.position",
            "arm = action.at",
            "kane (SymPy): loads act about the origin",
        ),
        (
            "back = [order.index(i) for i in range(len(order))]",
            "back = list(range(len(order)))",
            "kane (SymPy): columns stay in SymPy's order",
        ),
        (
            "dynamic.to(form) for form in velocity_forms(scene)]",
            "dynamic.to(-2 * form + scene.u[0]) for form in velocity_forms(scene)]",
            "kane (SymPy): constraints hold the first speed",
        ),
    ),
    *faults_in(
        "mechanics.routes.sympy_model",
        (
            "centre.set_acc(inertial",
            "centre.set_acc(inertial, 0 * inertial.x) if True else (inertial",
            "kane (SymPy): mass centres have no acceleration",
        ),
        (
            "new.set_ang_acc(inertial, _vector(new, turn.alpha, dynamic))",
            "new.set_ang_acc(inertial, _vector(new, -turn.alpha, dynamic))",
            "kane (SymPy): angular accelerations have the wrong sign",
        ),
        (
            "turning.set_ang_vel(model.frame, model.vector(moving.omega",
            "turning.set_ang_vel(model.frame, model.vector(-moving.omega",
            "kane (SymPy): couples act on a body that turns backwards",
        ),
        (
            "if not isinstance(body, RigidBody) or body.inertia == 0:",
            "if True:",
            "kane (SymPy): every body is a point mass",
        ),
    ),
    *faults_in(
        "mechanics.routes.pressing",
        (
            "friction * self.rest).applyfunc",
            "-friction * self.rest).applyfunc",
            "kane (SymPy): friction, the pressing part, wrong sign",
        ),
    ),
)

BY_LAGRANGES_METHOD = (
    *faults_in(
        "mechanics.routes.lagrange_sympy",
        (
            "kinetic_energy(scene, motions) - potential(scene))",
            "kinetic_energy(scene, motions) + potential(scene))",
            "lagrange (SymPy): L = T + V",
        ),
        (
            "terms.append(half * motion.body.mass *",
            "terms.append(motion.body.mass *",
            "lagrange (SymPy): T without its half",
        ),
        (
            "terms.append(half * canonical(omega.dot(inertia * omega)))",
            "pass",
            "lagrange (SymPy): no energy of turning",
        ),
        (
            "vector(action.force)))",
            "vector(-action.force)))",
            "lagrange (SymPy): forces have the wrong sign",
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

ROWS = (*TEXTBOOK, *PRESSING, *DEPENDENT, *BY_KANES_METHOD, *BY_LAGRANGES_METHOD)
