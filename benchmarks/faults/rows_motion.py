"""Faults in the kinematics, both ways, in the constraints, and in SymPy's derivatives."""

from benchmarks.faults.fault import faults_in

DIFFERENTIATED = (
    *faults_in(
        "mechanics.kinematics.textbook.differentiate",
        (
            "return PointMotion(position, velocity, rates(velocity, table))",
            "return PointMotion(position, velocity, 2 * rates(velocity, table))",
            "differentiated accelerations count twice",
        ),
        (
            "[skew[2, 1], skew[0, 2], skew[1, 0]]",
            "[skew[1, 2], skew[2, 0], skew[0, 1]]",
            "differentiated: omega has the wrong sign",
        ),
        (
            "skew = turning * rotation.T",
            "skew = rotation.T * turning",
            "differentiated: omega in the body's frame",
        ),
        (
            "omega, rates(omega, table))",
            "omega, zeros(3, 1))",
            "differentiated: no angular acceleration",
        ),
    ),
)

COMPOSED = (
    *faults_in(
        "mechanics.kinematics.textbook.chain",
        (
            "own = axis * rate(angle, table)",
            "own = -axis * rate(angle, table)",
            "composed: turning about an axis, wrong sign",
        ),
        (
            "else step.T * outer.omega",
            "else step * outer.omega",
            "composed: omega carried on the wrong way",
        ),
        ("omega = carried + own", "omega = own", "composed: the parent's omega is left out"),
        (
            "+ 2 * turn.omega.cross(c1)",
            "+ turn.omega.cross(c1)",
            "composed: Coriolis without its 2",
        ),
        ("+ turn.alpha.cross(c)", "- turn.alpha.cross(c)", "composed: alpha x r, wrong sign"),
        (
            "+ turn.omega.cross(across)",
            "- turn.omega.cross(across)",
            "composed: centrifugal, wrong sign",
        ),
        ("v = c1 + across", "v = c1 - across", "composed: omega x r, wrong sign"),
        ("omega, rates(omega, table))", "omega, omega)", "composed: omega for alpha"),
        (
            "turn[j, i] = c, c, -s, s",
            "turn[j, i] = c, c, s, -s",
            "composed: axis and angle of the turn backwards",
        ),
        (
            "axes = [i for i in range(3) if vector[i] != 0]\n    return all(",
            "axes = [i for i in range(3) if vector[i] != 0]\n    return True or all(",
            "composed: nothing is turned",
        ),
    ),
)

CONSTRAINTS = (
    *faults_in(
        "mechanics.kinematics.constraints",
        ("bias.append(-rest)", "bias.append(rest)", "b of A u' = b has the wrong sign"),
        ("bias.append(-rest)", "bias.append(0 * rest)", "b of A u' = b is left out"),
        (
            "collect_linear(rate(form, table), scene.ud)",
            "collect_linear(rate(form - scene.u[0], table), scene.ud)",
            "every constraint holds the first speed",
        ),
        (
            "expression = rate(expression, table)",
            "expression = rate(expression * scene.q[0], table)",
            "closures are multiplied by the first coordinate",
        ),
    ),
)

SYMPY = (
    *faults_in(
        "sympy.functions.elementary.trigonometric",
        (
            "        if argindex == 1:\n            return -sin(self.args[0])",
            "        if argindex == 1:\n            return sin(self.args[0])",
            "SymPy: d cos x / dx = sin x",
        ),
        (
            "        if argindex == 1:\n            return cos(self.args[0])",
            "        if argindex == 1:\n            return -cos(self.args[0])",
            "SymPy: d sin x / dx = -cos x",
        ),
    ),
    *faults_in(
        "sympy.core.power",
        (
            "dbase = self.base.diff(s)",
            "dbase = 2*self.base.diff(s)",
            "SymPy: d x^n / dx = 2 n x^(n-1)",
        ),
    ),
    *faults_in(
        "sympy.core.add",
        (
            "return self.func(*[a.diff(s) for a in self.args])",
            "return self.func(*[a.diff(s) for a in self.args[1:]])",
            "SymPy: the first term of a sum is constant",
        ),
    ),
)

ROWS = (*DIFFERENTIATED, *COMPOSED, *CONSTRAINTS, *SYMPY)
