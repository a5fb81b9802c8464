"""Faults in what is lowered, in derivatives of programs, and in the routes as programs."""

from benchmarks.faults.fault import faults_in

LOWERED = (
    *faults_in(
        "mechanics.mechanism",
        (
            "rotation = tuple(tuple(map(self.read, step[i, :])) for i in range(3))",
            "rotation = tuple(tuple(map(self.read, step[:, i])) for i in range(3))",
            "lowered: frames turn the other way, their turns do not",
        ),
        (
            "turn[i, i], turn[j, j], turn[i, j], turn[j, i] = c, c, -s, s",
            "turn[i, i], turn[j, j], turn[i, j], turn[j, i] = c, c, s, -s",
            "lowered: turns go the other way, their frames do not",
        ),
        (
            "self.points.append(Place(child.name, self.of_point[parent], step))",
            "self.points.append(Place(child.name, 0, step))",
            "lowered: every point starts at the origin",
        ),
        (
            "matrix = dyadic_matrix(body.inertia, body.frame)",
            "matrix = dyadic_matrix(body.inertia, self.scene.frame)",
            "lowered: inertias in the inertial frame",
        ),
        (
            "mass, centre = self.expression(body.mass, where), self.point(body.centre)",
            "mass, centre = self.builder.one, self.point(body.centre)",
            "lowered: every mass is 1 kg",
        ),
        (
            "about if i == j else zero for j in range(3)) for i in range(3))",
            "about * 2 if i == j else zero for j in range(3)) for i in range(3))",
            "lowered: scalar inertias are doubled",
        ),
        (
            "fields.append(Field(load.name, self.vector(load.field, where)))",
            "fields.append(Field(load.name, self.vector(-load.field, where)))",
            "lowered: gravity pulls up",
        ),
        (
            "for e in (load.stiffness, load.length))",
            "for e in (load.stiffness, load.length - load.length))",
            "lowered: springs have no natural length",
        ),
        (
            "coefficient = self.expression(load.coefficient, where)",
            "coefficient = -self.expression(load.coefficient, where)",
            "lowered: dampers drive",
        ),
        (
            "return Push(load.name, self.of_body[load.on], self.named(load.by), None, vector)",
            "return Push(load.name, self.of_body[load.on], GROUND, None, vector)",
            "lowered: couples push off the ground",
        ),
        (
            "return Push(load.name, on, self.named(load.by), at, vector)",
            "return Push(load.name, on, self.named(load.by), 0, vector)",
            "lowered: forces act at the origin",
        ),
        (
            "on, by = self.of_body[load.on], self.named(load.by)",
            "by, on = self.of_body[load.on], self.named(load.by)",
            "lowered: torsion springs push the wrong body",
        ),
        (
            "GROUND if reaction.by is None else self.of_body[reaction.by],",
            "GROUND,",
            "lowered: every reaction is the ground's",
        ),
        (
            "q_rates=tuple(read(scene.coordinate_rates[rate]) for rate in scene.qd),",
            "q_rates=tuple(2 * read(scene.coordinate_rates[rate]) for rate in scene.qd),",
            "lowered: q' = 2 u",
        ),
        (
            "table[self.read(symbol)] = self.read(rate)",
            "table[self.read(symbol)] = self.builder.zero",
            "lowered: inputs have no rates",
        ),
        (
            "table.update(zip(self.u, self.ud, strict=True))",
            "table.update(zip(self.u, self.u, strict=True))",
            "lowered: u' = u",
        ),
        (
            "table.update(zip(self.qd, self.qdd, strict=True))",
            "table.update(zip(self.qd, self.qd, strict=True))",
            "lowered: q'' = q'",
        ),
        (
            "if self.parents[other] in inside:",
            "if self.parents[other] == body:",
            "lowered: subtrees end at the first neighbour",
        ),
    ),
)

LANGUAGE = (
    *faults_in(
        "mechanics.program.forward",
        (
            "return left if right is None else right if left is None else left + right",
            "return left if right is None else right if left is None else left",
            "tangent: half of the product rule",
        ),
        (
            "return a if b is None else -b if a is None else a - b",
            "return a if b is None else b if a is None else a - b",
            "tangent: what is subtracted grows the sum",
        ),
        (
            "return -a if a is not None else None",
            "return a",
            "tangent: no sign of what is negated",
        ),
    ),
    *faults_in(
        "mechanics.program.derivatives",
        (
            "accumulate(second[number], -weight)",
            "accumulate(second[number], weight)",
            "gradient: what is subtracted counts with a plus",
        ),
        (
            "adjoints[number] = adjoints[number] + value if number in adjoints else value",
            "adjoints[number] = value",
            "gradient: of all ways the last one counts",
        ),
        (
            "accumulate(b, weight * Node(builder, a))",
            "accumulate(b, weight * Node(builder, b))",
            "gradient: of x y by y it says y",
        ),
    ),
    *faults_in(
        "mechanics.program.vectors",
        (
            "a[2] * b[0] - a[0] * b[2],",
            "a[0] * b[2] - a[2] * b[0],",
            "vectors: a cross product with another sign along y",
        ),
        (
            "for x, y in zip(a[1:], b[1:], strict=True):",
            "for x, y in zip(a[1:2], b[1:2], strict=True):",
            "vectors: dot products of two components",
        ),
        (
            "return tuple(dot(row, vector) for row in matrix)",
            "return tuple(dot(row, vector) for row in transpose(matrix))",
            "vectors: matrices act transposed",
        ),
        (
            "columns = transpose(b)",
            "columns = b",
            "vectors: the second factor is transposed",
        ),
        (
            "return tuple(x - y for x, y in zip(a, b, strict=True))",
            "return tuple(y - x for x, y in zip(a, b, strict=True))",
            "vectors: differences the other way round",
        ),
    ),
    *faults_in(
        "mechanics.program.sympy_reader",
        (
            "above = b.multiply(b.number_of(coefficient), above)",
            "above = b.multiply(b.number_of(abs(coefficient)), above)",
            "read: products without their sign",
        ),
        (
            "return b.divide(above, reduce(b.multiply, below)) if below else above",
            "return b.multiply(above, reduce(b.multiply, below)) if below else above",
            "read: quotients are products",
        ),
        (
            "return self.leaf(self.builder.number_of(value))",
            "return self.leaf(self.builder.number_of(round(value)))",
            "read: fractions are rounded",
        ),
        (
            "return reduce(self.builder.add, numbers)",
            "return reduce(self.builder.add, numbers[:2])",
            "read: sums end after two terms",
        ),
    ),
)

MOVED = (
    *faults_in(
        "mechanics.kinematics.motion",
        (
            "product(rotations[frame.parent], frame.rotation)",
            "product(frame.rotation, rotations[frame.parent])",
            "programs: rotations in the wrong order",
        ),
        (
            "return product(product(rotation, inertia), transpose(rotation))",
            "return product(product(transpose(rotation), inertia), rotation)",
            "programs: inertias turn the other way",
        ),
        (
            "steps = [times(rotations[frame], column) for frame, column in place.step]",
            "steps = [column for frame, column in place.step]",
            "programs: steps are not turned",
        ),
        (
            "if not held and all(map(filter_.is_zero, turning.omega)):",
            "if True:",
            "programs: no body turns",
        ),
    ),
    *faults_in(
        "mechanics.kinematics.chain",
        (
            "add(outer.alpha, cross(outer.omega, own), gain),",
            "add(outer.alpha, gain),",
            "programs, composed: alpha without omega x own",
        ),
        (
            "add(outer.omega, own),",
            "own,",
            "programs, composed: the parent's omega is left out",
        ),
        (
            "scale(2, cross(frame.omega, relative)),",
            "cross(frame.omega, relative),",
            "programs, composed: Coriolis without its 2",
        ),
        (
            "acceleration = add(cross(frame.alpha, arm), cross(frame.omega, across))",
            "acceleration = add(cross(frame.alpha, arm), across)",
            "programs, composed: centripetal is a velocity",
        ),
        (
            "return scale(rate, frame.turn.axis), scale(gain, frame.turn.axis)",
            "return scale(-rate, frame.turn.axis), scale(-gain, frame.turn.axis)",
            "programs, composed: turning backwards",
        ),
    ),
    *faults_in(
        "mechanics.kinematics.differentiate",
        (
            "dot(turning[2], rotation[1]),",
            "dot(turning[1], rotation[2]),",
            "programs, differentiated: omega_x has the wrong sign",
        ),
        (
            "accelerations = tangent(velocities, table)",
            "accelerations = tangent(points, table)",
            "programs, differentiated: accelerations are velocities",
        ),
    ),
)

LOADED = (
    *faults_in(
        "mechanics.routes.loads",
        (
            "return add(cross(subtract(self.at, about), self.force), self.couple)",
            "return add(cross(self.at, self.force), self.couple)",
            "programs: moments about the origin",
        ),
        (
            "found.append(Wrench(load.name, i, at, scale(body.mass, pull), none))",
            "found.append(Wrench(load.name, i, at, pull, none))",
            "programs: gravity does not know the mass",
        ),
        (
            "line.stiffness * (distance - line.length), direction",
            "line.stiffness * distance, direction",
            "programs: springs pull without their length",
        ),
        (
            "couple = scale(-(torsion.stiffness * torsion.angle), where.vector(torsion.axis))",
            "couple = scale(torsion.stiffness * torsion.angle, where.vector(torsion.axis))",
            "programs: torsion springs push on",
        ),
        (
            "found += _pulls(line, where, line.coefficient * rate, direction, none)",
            "found += _pulls(line, where, -line.coefficient * rate, direction, none)",
            "programs: dampers drive",
        ),
        (
            "rubbing = scale(-size, where.vector(load.along))",
            "rubbing = scale(size, where.vector(load.along))",
            "programs: friction pushes on",
        ),
        (
            "((line.first, line.by, tension), (line.second, line.on, -tension))",
            "((line.first, line.by, tension), (line.second, line.on, tension))",
            "programs: both ends are pulled the same way",
        ),
        (
            "Wrench(name, by, at, tuple(-x for x in force), tuple(-x for x in couple))",
            "Wrench(name, by, at, force, couple)",
            "programs: action is not opposite to reaction",
        ),
        (
            "total = total - body.mass * dot(pull, where.positions[body.centre])",
            "total = total + body.mass * dot(pull, where.positions[body.centre])",
            "programs: the potential of gravity has the wrong sign",
        ),
        (
            "total = total + half * line.stiffness * (stretch * stretch)",
            "total = total + line.stiffness * (stretch * stretch)",
            "programs: springs store twice",
        ),
        (
            "groups[wrench.body].append(wrench)",
            "groups[0].append(wrench)",
            "programs: the first body takes all loads",
        ),
    ),
)

DERIVED = (
    *faults_in(
        "mechanics.routes.free_body",
        (
            "rate = tuple(tangent(momentum, mechanism.rates))",
            "rate = times(motion.inertia, motion.turning.alpha)",
            "programs, free_body: no gyroscopic moment",
        ),
        (
            "Row(row.body, row.rate - row.applied, dict(row.coefficients), place)",
            "Row(row.body, row.rate + row.applied, dict(row.coefficients), place)",
            "programs, free_body: loads with the wrong sign",
        ),
        (
            "mass * dot(centre.acceleration, along),",
            "dot(centre.acceleration, along),",
            "programs, free_body: m a without m",
        ),
        (
            "arms = {reaction: unit.moment(centre) for reaction, unit in acting.items()}",
            "arms = {reaction: unit.couple for reaction, unit in acting.items()}",
            "programs, free_body: reactions have no moment",
        ),
    ),
    *faults_in(
        "mechanics.routes.elimination",
        (
            "row.value = row.value * keep - factor * pivot.value",
            "row.value = row.value * keep + factor * pivot.value",
            "programs, elimination: rows are added",
        ),
        (
            "merged[r] = merged[r] - factor * c if r in merged else -(factor * c)",
            "merged[r] = merged[r] - factor * c if r in merged else factor * c",
            "programs, elimination: new coefficients, wrong sign",
        ),
        (
            "total = total - coefficient * values[reaction]",
            "total = total + coefficient * values[reaction]",
            "programs, elimination: reactions, wrong sign",
        ),
    ),
    *faults_in(
        "mechanics.routes.moving_point",
        (
            "moving = add(self.spin_rate, cross(self.velocity, self.momentum))",
            "moving = self.spin_rate",
            "programs, moving_point: v_B x P is left out",
        ),
        (
            "subtract(subtree.torque, cross(principle.offset, subtree.force))",
            "add(subtree.torque, cross(principle.offset, subtree.force))",
            "programs, moving_point: the centre on the other side",
        ),
        (
            "torque = add(torque, subtree.torque, cross(arm, subtree.force))",
            "torque = add(torque, subtree.torque)",
            "programs, moving_point: outboard loads have no arm",
        ),
        (
            "spin = add(spin, times(motion.inertia, motion.turning.omega))",
            "spin = add(spin, motion.turning.omega)",
            "programs, moving_point: H is omega",
        ),
    ),
    *faults_in(
        "mechanics.routes.kane",
        (
            "spin = add(times(motion.inertia, alpha), cross(omega, times(motion.inertia, omega)))",
            "spin = times(motion.inertia, alpha)",
            "programs, kane: no gyroscopic moment",
        ),
        (
            "scale(body.mass, centre.acceleration), add(none, *(w.force for w in wrenches))",
            "centre.acceleration, add(none, *(w.force for w in wrenches))",
            "programs, kane: m a without m",
        ),
        (
            "return force, subtract(spin, torque)",
            "return force, add(spin, torque)",
            "programs, kane: moments of loads, wrong sign",
        ),
    ),
    *faults_in(
        "mechanics.routes.lagrange",
        (
            "energy = kinetic_energy(mechanism) - potential(mechanism, poses(mechanism))",
            "energy = kinetic_energy(mechanism) + potential(mechanism, poses(mechanism))",
            "programs, lagrange: L = T + V",
        ),
        (
            "total = total + half * mass * dot(velocity, velocity)",
            "total = total + mass * dot(velocity, velocity)",
            "programs, lagrange: T without its half",
        ),
        (
            "return tuple(rate - slope for rate, slope in zip(rates, gradients[:n], strict=True))",
            "return tuple(rate + slope for rate, slope in zip(rates, gradients[:n], strict=True))",
            "programs, lagrange: dL/dq, wrong sign",
        ),
        (
            "conservative = tuple(gradient(mechanism.q_rates, conservative, mechanism.u))",
            "pass",
            "programs, lagrange: rows are not projected on the speeds",
        ),
        (
            "rows = [row - force for row, force in zip(conservative, forces, strict=True)]",
            "rows = [row + force for row, force in zip(conservative, forces, strict=True)]",
            "programs, lagrange: loads, wrong sign",
        ),
        (
            "weights += wrench.moment(centre.position)",
            "weights += wrench.couple",
            "programs: forces have no moment in their power",
        ),
    ),
)

CHECKED = (
    *faults_in(
        "mechanics.checks.agreement",
        (
            "places = {residue: j for j, residue in enumerate(filter_.values(two))}",
            "places = {residue: j for j, residue in enumerate(filter_.values(one))}",
            "pairs: a route is matched with itself",
        ),
        (
            "right = [-entry for entry in remainder(mechanism.builder, every, unknowns)]",
            "right = list(remainder(mechanism.builder, every, unknowns))",
            "pairs: f has the wrong sign",
        ),
        (
            "for signed, sign in ((residue, 1), (-residue % filter_.prime, -1)):",
            "for signed, sign in ((residue, -1), (-residue % filter_.prime, 1)):",
            "pairs: equal rows are taken for opposite ones",
        ),
    ),
    *faults_in(
        "mechanics.checks.laws",
        (
            "released = [-slope for slope in gradient(alone.q_rates, slopes, alone.u)]",
            "released = gradient(alone.q_rates, slopes, alone.u)",
            "laws: forces go up the potential",
        ),
        (
            "return work, growth - power",
            "return work, growth + power",
            "laws: loads take out what they bring in",
        ),
    ),
    *faults_in(
        "mechanics.checks.admissible",
        (
            "independent = _rank(filter_, columns, size)",
            "independent = _rank(filter_, columns, size)[:-1]",
            "admissible: the last independent reaction is lost",
        ),
        (
            "metric = [filter_.values(row) for row in coefficients(momenta, mechanism.u)]",
            "metric = [filter_.values(momenta) for row in coefficients(momenta, mechanism.u)]",
            "admissible: momenta for the metric",
        ),
    ),
)  # fmt: skip

ROWS = (*LOWERED, *LANGUAGE, *MOVED, *LOADED, *DERIVED, *CHECKED)
