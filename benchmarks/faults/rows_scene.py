"""Faults in what all routes read: geometry, lowering, loads, inertias, shapes, topology."""

from benchmarks.faults.fault import faults_in

GEOMETRY = (
    *faults_in(
        "mechanics.scene.geometry",
        (
            "Matrix(parent.dcm(child))",
            "Matrix(child.dcm(parent))",
            "each step of a rotation is taken backwards",
        ),
        (
            "return child._pos_dict[parent]",
            "return parent._pos_dict[child]",
            "each step between points is taken backwards",
        ),
        (
            "for column, frame in vector.args)",
            "for column, frame in vector.args[:1])",
            "a vector given in two frames loses the second",
        ),
        (
            'orient it"\n        )\n    return path',
            'orient it"\n        )\n    return (path[0], path[-1])',
            "a frame hangs on the inertial one directly",
        ),
    ),
    *faults_in(
        "mechanics.scene.declaration",
        (
            "known[child] = known[parent] + step",
            "known[child] = known[parent] - step",
            "steps between points are subtracted",
        ),
        (
            "known[child] = known[parent] + step",
            "known[child] = step",
            "a point counts from its parent, not from the origin",
        ),
        (
            "known[child] = known[parent] * step",
            "known[child] = step * known[parent]",
            "rotations are composed in the wrong order",
        ),
        (
            "known[child] = known[parent] * step",
            "known[child] = step",
            "a rotation counts from the parent frame",
        ),
        (
            "else self.rotation(frame) * plain",
            "else self.rotation(frame).T * plain",
            "vectors are turned the wrong way",
        ),
        (
            "total += plain if frame",
            "total = plain if frame",
            "of a vector in several frames only the last counts",
        ),
    ),
)

LOWERING = (
    *faults_in(
        "mechanics.scene.declaration",
        (
            "return {rate: rate for rate in self.qd}",
            "return {rate: -rate for rate in self.qd}",
            "q' = -u",
        ),
        (
            "symbol - to_plain(definition, table",
            "2 * symbol - to_plain(definition, table",
            "declared speeds count twice",
        ),
        (
            "(solution,) = linsolve(rows, *unknown.values())",
            "(solution,) = linsolve(rows, *[*unknown.values()][::-1])",
            "rates of the coordinates come in reverse order",
        ),
    ),
    *faults_in(
        "mechanics.scene.symbols",
        (
            "return name + DOTS[order]",
            "return name + DOTS[min(order, 1)]",
            "q'' is called q'",
        ),
        (
            "function.diff(t, order) if order else function]",
            "function.diff(t, min(order, 1)) if order else function]",
            "the third derivative takes the place of the first",
        ),
        (
            "plain = expression.xreplace(dict(table))",
            "plain = expression.xreplace({**table, dynamicsymbols._t: 0 * dynamicsymbols._t})",
            "time stands still wherever it is written",
        ),
        (
            "expression = sympify(expression)\n    if",
            "expression = -sympify(expression)\n    if",
            "every expression changes its sign",
        ),
    ),
    *faults_in(
        "mechanics.scene.declared",
        (
            "return decimals(read)",
            "return 2 * decimals(read)",
            "every declared scalar counts twice",
        ),
    ),
    *faults_in(
        "mechanics.scene.rates",
        (
            "table.update(zip(scene.u, scene.ud, strict=True))",
            "table.update(zip(scene.u, scene.u, strict=True))",
            "u' = u",
        ),
        ("table.update(zip(scene.u, scene.ud, strict=True))", "pass", "speeds are constant"),
        (
            "Add(*(rate(term, table) for term in expression.args))",
            "Add(*(rate(term, table) for term in expression.args[1:]))",
            "the first term of a sum is not differentiated",
        ),
        (
            "    moving.sort(key=lambda symbol: symbol.name)",
            "    moving = sorted(moving, key=lambda symbol: symbol.name)[:1]",
            "a product is differentiated by one of its factors",
        ),
        (
            "expression.diff(symbol) * table[symbol] for",
            "-expression.diff(symbol) * table[symbol] for",
            "rates have the wrong sign",
        ),
        (
            "table.update(zip(scene.qd, second, strict=True))",
            "table.update(zip(scene.qd, (-s for s in second), strict=True))",
            "where q' stands for itself, q'' has the wrong sign",
        ),
        (
            "= plain_symbol(function, order + 1)",
            "= S.Zero",
            "a support that is moved by hand has no velocity",
        ),
        (
            "{u: scene.rates(definition) for",
            "{u: -scene.rates(definition) for",
            "speeds in rates have the wrong sign",
        ),
    ),
)

LOADS = (
    *faults_in(
        "mechanics.scene.actions",
        (
            "        return stated\n",
            "        return scene.bodies[0].name\n",
            "a spring hangs on the first body",
        ),
    ),
    *faults_in(
        "mechanics.scene.potential",
        (
            "distance - scene.plain(load.length, load.name)",
            "distance + scene.plain(load.length, load.name)",
            "tension with length added",
        ),
        (
            "span = scene.position(load.second) - scene.position(load.first)",
            "span = scene.position(load.second)",
            "a spring starts at the origin",
        ),
        (
            "span = scene.position(load.second) - scene.position(load.first)",
            "span = 2 * (scene.position(load.second) - scene.position(load.first))",
            "the length of a spring counts twice",
        ),
        (
            "return span.dot(direction), direction",
            "return -span.dot(direction), direction",
            "distance along has the wrong sign",
        ),
        (
            "sqrt(sum(entry**2 for entry in span))",
            "sqrt(sum(entry**2 for entry in span[:2, 0]))",
            "distance leaves out z",
        ),
        ("Add(*(-b.mass *", "Add(*(b.mass *", "the potential of gravity has the wrong sign"),
        (
            "load.name) * stretch**2",
            "load.name) * 2 * stretch**2",
            "the energy of a spring without its half",
        ),
        (
            "distance - scene.plain(load.length, load.name)",
            "distance + scene.plain(load.length, load.name)",
            "energy of a spring, length added",
        ),
        (
            "return half * stiffness * angle**2",
            "return stiffness * angle**2",
            "the energy of a torsion spring without its half",
        ),
    ),
    *faults_in(
        "mechanics.scene.loads",
        (
            "return Spring(name, first, second, k",
            "return Spring(name, second, first, k",
            "a spring changes its ends when it is declared",
        ),
        (
            "return Damper(name, first, second, c",
            "return Damper(name, first, second, 2 * c",
            "a damper counts twice when it is declared",
        ),
        (
            "return TorsionSpring(name, turn, axis, k",
            "return TorsionSpring(name, turn, -axis, k",
            "a torsion spring changes its axis when it is declared",
        ),
        (
            "return Force(name, at, vector, on, by)",
            "return Force(name, at, -vector, on, by)",
            "a force changes its sign when it is declared",
        ),
        (
            "return Torque(name, vector, on, by)",
            "return Torque(name, vector, on, None)",
            "a torque forgets the other body when it is declared",
        ),
        (
            "return Coulomb(name, normal, along, speed, mu)",
            "return Coulomb(name, normal, along, speed, 2 * mu)",
            "friction counts twice when it is declared",
        ),
    ),
    *faults_in(
        "mechanics.scene.reactions",
        (
            "reactions, True)",
            "reactions, False)",
            "a closure counts as a condition on speeds",
        ),
    ),
)

BODIES = (
    *faults_in(
        "mechanics.scene.bodies",
        ("    return value\n", "    return value**2\n", "the mass of a body is squared"),
    ),
    *faults_in(
        "mechanics.scene.shapes",
        (
            "return self.length**2 / 12, sympify(0)",
            "return self.length**2 / 3, sympify(0)",
            "a rod about its end",
        ),
        (
            "return self.width**2 / 12, self.height**2 / 12",
            "return self.width**2 / 6, self.height**2 / 12",
            "a rectangle, b^2/6",
        ),
        (
            "return self.radius**2 / 4, self.radius**2 / 4",
            "return self.radius**2 / 2, self.radius**2 / 4",
            "a disc, R^2/2 one way",
        ),
        (
            "return self.radius**2 / 2, self.radius**2 / 2",
            "return self.radius**2, self.radius**2",
            "a ring, R^2 each way",
        ),
        (
            "4 * self.radius / (3 * pi)",
            "3 * self.radius / (4 * pi)",
            "centroid of a half disc, 3 R / 4 pi",
        ),
        (
            "own - self.centroid[1] ** 2",
            "own + self.centroid[1] ** 2",
            "a half disc moved to its centroid the wrong way",
        ),
        (
            "return pi * self.radius**2 / 2",
            "return pi * self.radius**2",
            "the area of a half disc is that of the disc",
        ),
        (
            "return 2 * pi * self.radius",
            "return pi * self.radius",
            "the length of a ring is half of it",
        ),
    ),
    *faults_in(
        "mechanics.scene.composite",
        ("Matrix([[c, -s], [s, c]])", "Matrix([[c, s], [-s, c]])", "parts are turned clockwise"),
        (
            "part.mass * offset * offset.T",
            "offset * offset.T",
            "the parallel-axis theorem without the mass",
        ),
        (
            "total += part.mass * part.centroid",
            "total += part.centroid",
            "a centroid that does not weigh its parts",
        ),
        ("sympify(density) * shape.size", "sympify(density)", "a density counts as a mass"),
    ),
)

TOPOLOGY = (
    *faults_in(
        "mechanics.scene.topology",
        (
            "if self.parent[body] in inside:",
            "if self.parent[body] == name:",
            "a subtree ends at the children",
        ),
        ("cut = set(multipliers(scene))", "cut = set()", "loops are not cut"),
        (
            "for name in c.reactions)",
            "for name in c.reactions[:0])",
            "no constraint has a reaction",
        ),
    ),
)

ROWS = (*GEOMETRY, *LOWERING, *LOADS, *BODIES, *TOPOLOGY)
