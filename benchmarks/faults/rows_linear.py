"""Faults in linear equations about states of rest and steady motions."""

from benchmarks.faults.fault import faults_in

EXPANSION = faults_in(
    "mechanics.linear.linearize",
    ("mass = product(by_rates, turn)", "mass = by_rates", "linear: M multiplies the speeds' rates"),
    (
        "difference(product(by_speeds, turn), product(by_rates, carried))",
        "product(by_speeds, turn)",
        "linear: C forgets that rates bend with the place",
    ),
    (
        "padded(build, product(by_place, reach), len(own)), product(by_speeds, carried)",
        "padded(build, product(by_place, reach), len(own)), product(by_rates, carried)",
        "linear: K takes the mass for the damping",
    ),
    (
        "turn = inverse(build, [rates[i] for i in own])",
        "turn = [rates[i] for i in own]",
        "linear: Y is not inverted",
    ),
    (
        "across = [list(column) for column in zip(*turn, strict=True)]",
        "across = turn",
        "linear: Y is not transposed",
    ),
    (
        "[[-entry for entry in row] for row in place.matrix(coefficients(moving.rows, order))]",
        "[[entry for entry in row] for row in place.matrix(coefficients(moving.rows, order))]",
        "linear: inputs have the wrong sign",
    ),
    (
        "side = [-row[column] for row in rows]",
        "side = [row[column] for row in rows]",
        "linear: dependent coordinates deviate the other way",
    ),
    (
        "self._left([-row for row in moving.rows], self._forces())",
        "self._left([row - row for row in moving.rows], self._forces())",
        "linear: nobody asks whether forces balance",
    ),
    (
        "nodes = [*moving.configuration, *moving.redundant]",
        "nodes = [c - c for c in (*moving.configuration, *moving.redundant)]",
        "linear: nobody asks whether constraints hold",
    ),
)

ELIMINATION = faults_in(
    "mechanics.linear.reduction",
    (
        "totals = [total + factor * plain[i]",
        "totals = [total - factor * plain[i]",
        "linear: rows of dependent speeds have the wrong sign",
    ),
    ("sides.append(-side)", "sides.append(side)", "linear: dependent speeds have the wrong sign"),
    (
        "directions = {**mechanism.given_rates, **dict(zip(mechanism.q, rates, strict=True))}",
        "directions = {**mechanism.given_rates}",
        "linear: rates of dependent speeds forget that constraints turn",
    ),
    (
        "total = total + matrix[i][column] * value",
        "total = total - matrix[i][column] * value",
        "linear: multipliers are put in with the wrong sign",
    ),
)

EFFECT = faults_in(
    "mechanics.linear.effect",
    (
        "found = {i for i, nodes in enumerate(slopes) if differ(nodes)}",
        "found = {i for i, nodes in enumerate(slopes) if not differ(nodes)}",
        "linear: what has an effect is taken for cyclic",
    ),
    (
        "sides = [-entry for entry in remainder(",
        "sides = [entry for entry in remainder(",
        "linear: effects are asked of motions backwards",
    ),
)

STABILITY = (
    *faults_in(
        "mechanics.linear.stability",
        (
            "k = 2 * (j + 1) - (i + 1)",
            "k = 2 * (j + 1) - i",
            "stability: the Hurwitz matrix is shifted by a row",
        ),
        (
            "from_top = [S.One, *reversed(ratios)]",
            "from_top = [S.One, *ratios]",
            "stability: coefficients in reverse order",
        ),
        (
            "slopes = [(k + 1) * entry for",
            "slopes = [entry for",
            "stability: P' without its factors",
        ),
        (
            "if rank == linear.A.rows - zeros else",
            "if rank != linear.A.rows - zeros else",
            "stability: poles at 0 count where they are semisimple",
        ),
        (
            "(linear.mass * s + linear.stiffness)",
            "(linear.mass * s - linear.stiffness)",
            "stability: K has the wrong sign",
        ),
    ),
    *faults_in(
        "mechanics.linear.first_order",
        (
            "[-stiffness[:, :kept], -damping, drive]",
            "[-stiffness[:, :kept], damping, drive]",
            "first order: C has the wrong sign",
        ),
    ),
    *faults_in(
        "mechanics.linear.form",
        (
            "Matrix.hstack(-self.stiffness[:, :kept], -self.damping)",
            "Matrix.hstack(self.stiffness[:, :kept], -self.damping)",
            "A: K has the wrong sign",
        ),
    ),
)

SPEED = faults_in(
    "mechanics.linear.speed_form",
    (
        "mass = difference(mass, product(inward, by_rates))",
        "mass = difference(mass, product(inward, inward))",
        "form in v: M without Routh's reduction",
    ),
    (
        "return mass, damping, difference(stiffness, product(across, by_place))",
        "return mass, damping, stiffness",
        "form in v: K forgets the momenta that are kept",
    ),
    (
        "heavy = difference(put(stiffness, 1, 1), fast)",
        "heavy = put(stiffness, 1, 1)",
        "form in v: K0 holds K2",
    ),
)

ROWS = (*EXPANSION, *ELIMINATION, *EFFECT, *STABILITY, *SPEED)
