"""Faults in the routes themselves."""

from benchmarks.faults.fault import faults_in

FREE_BODY = (
    *faults_in(
        "mechanics.routes.free_body",
        (
            "growth = rates(momentum, rate_table(scene))",
            "growth = inertia_matrix(scene, motion.body, motion.rotation)"
            " * motion.angular_acceleration",
            "free_body: no gyroscopic moment",
        ),
        (
            "applied=Add(*(_dot(load.force, along)",
            "applied=-Add(*(_dot(load.force, along)",
            "free_body: loads with the wrong sign",
        ),
        (
            "(moment(load, centre) for load in loads)",
            "(moment(load, 0 * centre) for load in loads)",
            "free_body: moments of loads about the origin",
        ),
        (
            "symbol: moment(unit, centre)",
            "symbol: moment(unit, 0 * centre)",
            "free_body: moments of reactions about the origin",
        ),
    ),
    *faults_in(
        "mechanics.routes.elimination",
        ("Mul(-factor, pivot.value))", "Mul(factor, pivot.value))", "elimination: rows are added"),
        (
            "merged.get(symbol, S.Zero) - factor * value",
            "merged.get(symbol, S.Zero) + factor * value",
            "elimination: coefficients are added",
        ),
        (
            "scale, factor = S.One, own / divisor",
            "scale, factor = S.One, own",
            "elimination: the pivot does not divide",
        ),
        (
            "= (step.row.value - others) / step.pivot",
            "= (step.row.value + others) / step.pivot",
            "elimination: reactions, wrong sign",
        ),
        (
            "tidied.items() if value != 0}",
            "tidied.items() if value.is_number}",
            "elimination: coefficients with symbols are lost",
        ),
    ),
)

MOVING_POINT = (
    *faults_in(
        "mechanics.routes.balance",
        ("terms = [-self.moving_term]", "terms = []", "moving_point: v_B x P counts twice"),
        (
            "self.momentum_rate + self.moving_term - self.applied",
            "self.momentum_rate - self.applied",
            "moving_point: v_B x P is left out",
        ),
        (
            "+ self.moving_term - self.applied",
            "+ self.moving_term + self.applied",
            "moving_point: loads with the wrong sign",
        ),
        (
            "-axis[k] * one[j] * two[i]",
            "axis[k] * one[j] * two[i]",
            "moving_point: a cross product with a plus",
        ),
        (
            "arm = load.at - self.centre.position",
            "arm = load.at",
            "moving_point: moments of loads about the origin",
        ),
        (
            "dot(self.principle.axis, part.spin_rate),",
            "0 * dot(self.principle.axis, part.spin_rate),",
            "moving_point: bodies count as points",
        ),
    ),
    *faults_in(
        "mechanics.routes.moving_point",
        (
            "if len(own) == 1:",
            "if own[1:]:",
            "moving_point: the reactions inside are taken for those that cross",
        ),
    ),
    *faults_in(
        "mechanics.routes.twists",
        (
            "offset = (w.cross(v) / square)",
            "offset = (v.cross(w) / square)",
            "moving_point: the axis on the other side",
        ),
    ),
    *faults_in(
        "mechanics.routes.common",
        (
            "forcing.append(right)",
            "forcing.append(-right)",
            "momentum routes: f has the wrong sign",
        ),
    ),
)

KANE = (
    *faults_in(
        "mechanics.routes.kane",
        (
            "model.vector(action.force, dynamic)))",
            "model.vector(-action.force, dynamic)))",
            "kane: forces at mass centres, wrong sign",
        ),
        (
            "velocity = motion.centre.velocity + motion.angular_velocity",
            "velocity = motion.centre.velocity - motion.angular_velocity",
            "kane: points of loads move the wrong way",
        ),
        (
            "arm = action.at - motion.centre.position",
            "arm = action.at",
            "kane: loads act about the origin",
        ),
        (
            "back = [order.index(i) for i in range(len(order))]",
            "back = list(range(len(order)))",
            "kane: columns stay in SymPy's order",
        ),
        (
            "dynamic.to(form) for form in velocity_forms(scene)]",
            "dynamic.to(-2 * form + scene.u[0]) for form in velocity_forms(scene)]",
            "kane: constraints hold the first speed",
        ),
    ),
    *faults_in(
        "mechanics.routes.sympy_model",
        (
            "centre.set_acc(inertial",
            "centre.set_acc(inertial, 0 * inertial.x) if True else (inertial",
            "kane: mass centres have no acceleration",
        ),
        (
            "new.set_ang_acc(inertial, _vector(new, turn.alpha, dynamic))",
            "new.set_ang_acc(inertial, _vector(new, -turn.alpha, dynamic))",
            "kane: angular accelerations have the wrong sign",
        ),
        (
            "turning.set_ang_vel(model.frame, model.vector(moving.omega",
            "turning.set_ang_vel(model.frame, model.vector(-moving.omega",
            "kane: couples act on a body that turns backwards",
        ),
        (
            "if not isinstance(body, RigidBody) or body.inertia == 0:",
            "if True:",
            "kane: every body is a point mass",
        ),
    ),
    *faults_in(
        "mechanics.routes.pressing",
        (
            "friction * self.rest).applyfunc",
            "-friction * self.rest).applyfunc",
            "friction: the pressing part, wrong sign",
        ),
    ),
)

LAGRANGE = (
    *faults_in(
        "mechanics.routes.lagrange",
        (
            "method = _method(scene, motions, dynamic, kinetic - stored)",
            "method = _method(scene, motions, dynamic, kinetic + stored)",
            "lagrange: L = T + V",
        ),
        (
            "terms.append(half * motion.body.mass *",
            "terms.append(motion.body.mass *",
            "lagrange: T without its half",
        ),
        (
            "terms.append(half * canonical(omega.dot(inertia * omega)))",
            "pass",
            "lagrange: no energy of turning",
        ),
        (
            "vector(action.force)))",
            "vector(-action.force)))",
            "lagrange: forces have the wrong sign",
        ),
        (
            "change.T * (forcing - mass * drift)",
            "change.T * forcing",
            "lagrange: speeds whose definition turns, left out",
        ),
        ("bias - matrix * drift,", "bias + matrix * drift,", "lagrange: b in speeds, wrong sign"),
    ),
)

ROWS = (*FREE_BODY, *MOVING_POINT, *KANE, *LAGRANGE)
