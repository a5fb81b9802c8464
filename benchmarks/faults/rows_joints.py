"""Faults in what makes scenes: joints, Euler angles, quaternions, ends of springs."""

from benchmarks.faults.fault import faults_in

CARRYING = faults_in(
    "mechanics.scene.joints.kinds",
    (
        "distance * line.unit)\n    couples",
        "-distance * line.unit)\n    couples",
        "a slide moves backwards",
    ),
    (
        "distance * line.unit)\n    frame",
        "2 * distance * line.unit)\n    frame",
        "a sleeve moves twice as far",
    ),
    (
        "frame = line.turned(name, angle)",
        "frame = line.turned(name, -angle)",
        "a sleeve turns backwards",
    ),
    (
        "line.turned(name, angle), at, (angle,), along_axes(line.frame), line.across",
        "line.turned(name, angle), at, (angle,), line.across, line.across",
        "a pin forgets the force along its axis",
    ),
    (
        "(angle,), along_axes(line.frame), line.across",
        "(angle,), along_axes(line.frame), line.across[:1]",
        "a pin forgets a couple",
    ),
    (
        "(angle,), along_axes(line.frame), line.across",
        "(angle,), along_axes(line.frame), along_axes(line.frame)",
        "a pin bears a couple about its axis",
    ),
    (
        "(distance,), line.across, couples",
        "(distance,), along_axes(line.frame), couples",
        "a slide bears a force along its axis",
    ),
    (
        "couples = along_axes(line.frame)",
        "couples = along_axes(line.frame)[:2]",
        "a slide forgets a couple",
    ),
    (
        "(second, turned[letters[1]])",
        "(second, own[letters[1]])",
        "a universal joint turns about two axes of the parent",
    ),
    (
        "couples = ((third, turned[third]),)",
        "couples = ((third, own[third]),)",
        "a universal joint bears a couple about an axis of the parent",
    ),
    (
        "x * frame.x + y * frame.y)",
        "x * frame.x + y * turned.y)",
        "a planar joint counts y in the child's frame",
    ),
    (
        'frame.orientnew(name, "Axis", (angle, frame.z))',
        'frame.orientnew(name, "Axis", (-angle, frame.z))',
        "a planar joint turns clockwise",
    ),
    (
        "at, (), forces, (), turning)",
        "at, (), forces[:2], (), turning)",
        "a ball joint forgets a force",
    ),
    (
        "ends.carries(frame, at, (), axes, axes)",
        "ends.carries(frame, at, (), axes, axes[:2])",
        "a weld forgets a couple",
    ),
    (
        "y * frame.y + z * frame.z",
        "y * turned.y + z * frame.z",
        "a free body counts y in its own frame",
    ),
)

CLOSING = (
    *faults_in(
        "mechanics.scene.joints.kinds",
        (
            "ends.closes_about(line, onto, line.across)",
            "ends.closes_about(line, onto, along_axes(line.frame))",
            "a sleeve that closes a loop holds its sliding",
        ),
        (
            "ends.closes(line.frame, onto, line.across, (), ())",
            "ends.closes(line.frame, onto, line.across[:1], (), ())",
            "a pin that closes a loop holds one direction",
        ),
    ),
    *faults_in(
        "mechanics.scene.joints.ends",
        (
            "reaction(name, point, self.child, self.parent, along))",
            "reaction(name, self.at, self.child, self.parent, along))",
            "forces that close a loop act at the parent's point",
        ),
        (
            "reaction(name, point, self.child, self.parent, along))",
            "reaction(name, point, self.child, None, along))",
            "forces that close a loop forget the parent",
        ),
        (
            "sides.append(u.dot(v))",
            "sides.append(u.dot(v) - 1)",
            "axes are held parallel that have to be normal",
        ),
        (
            "reaction_couple(name, self.child, self.parent, u.cross(v))",
            "reaction_couple(name, self.child, self.parent, u)",
            "a couple that closes a loop acts about what it holds",
        ),
        (
            "((e2, own.unit), (e1, own.unit))",
            "((e1, own.unit), (e2, own.unit))",
            "couples that close a loop exchange their axes",
        ),
        (
            "((e2, own.unit), (e1, own.unit))",
            "((e1, own.unit), (e1, own.unit))",
            "a loop is closed about one axis twice",
        ),
    ),
)

ENDS = faults_in(
    "mechanics.scene.joints.ends",
    (
        'reaction(f"{self.name}_{word}", at=point,',
        'reaction(f"{self.name}_{word}", at=self.at,',
        "forces of a joint act at the parent's point",
    ),
    (
        'reaction_couple(f"{self.name}_m{word}", self.child, self.parent, along)',
        'reaction_couple(f"{self.name}_m{word}", self.child, None, along)',
        "couples of a joint forget the parent",
    ),
)

AXES = faults_in(
    "mechanics.scene.joints.axes",
    (
        "frame.orient_explicit(middle, self.matrix.T)",
        "frame.orient_explicit(middle, self.matrix)",
        "about an oblique axis: turned there and not back",
    ),
    ("(angle, inner.z))", "(angle, inner.x))", "about an oblique axis: a turn across it"),
    (
        "Matrix.hstack(e1, n.cross(e1), n)",
        "Matrix.hstack(e1, e1.cross(n), n)",
        "the axes of a joint are left-handed",
    ),
    (
        "n = column if square == 1 else column / sqrt(square)",
        "n = column",
        "the axis of a joint is no unit vector",
    ),
    (
        "unit = axes[k][1] if n[k].is_positive else -axes[k][1]",
        "unit = axes[k][1]",
        "the axis of a joint loses its sign",
    ),
    (
        'zip("xyz", (frame.x, frame.y, frame.z), strict=True)',
        'zip("xyz", (frame.y, frame.x, frame.z), strict=True)',
        "x and y of a joint's frame are exchanged",
    ),
)

PLANE = (
    *faults_in(
        "mechanics.scene.joints.plane",
        (
            "if parallel if reaction.at is not None else across:",
            "if across if reaction.at is not None else parallel:",
            "in a plane what leaves it stays",
        ),
    ),
    *faults_in(
        "mechanics.scene.assembly",
        (
            "if names & {*c.reactions}]",
            "if not names & {*c.reactions}]",
            "in a plane the constraints of a loop go",
        ),
    ),
)

EULER = faults_in(
    "mechanics.scene.euler",
    (
        "(angle, getattr(frame, axis))",
        "(angle, getattr(parent, axis))",
        "Euler angles about axes of the parent",
    ),
    (
        "(angle, getattr(frame, axis))",
        "(-angle, getattr(frame, axis))",
        "Euler angles turn backwards",
    ),
    (
        "zip(self.order, self.angles, strict=True)",
        "zip(self.order, self.angles[::-1], strict=True)",
        "Euler angles in reverse order",
    ),
)

QUATERNIONS = (
    *faults_in(
        "mechanics.scene.rotations",
        (
            "factor, skew = 2 / self.square, _skew(vector)",
            "factor, skew = 1 / self.square, _skew(vector)",
            "quaternion: the matrix without its 2",
        ),
        (
            "factor, skew = 2 / self.square, _skew(vector)",
            "factor, skew = 2 / self.square, -_skew(vector)",
            "quaternion: the matrix is transposed",
        ),
        (
            "(-HALF * vector.dot(w),",
            "(HALF * vector.dot(w),",
            "quaternion: e0' has the wrong sign",
        ),
        (
            "(scalar * w + vector.cross(w))",
            "(scalar * w - vector.cross(w))",
            "quaternion: rates from w in the parent's components",
        ),
        (
            "*(HALF * (scalar * w",
            "*((scalar * w",
            "quaternion: rates without their half",
        ),
        (
            "e0.diff(t) * vector - vector.cross(vector.diff(t))",
            "e0.diff(t) * vector + vector.cross(vector.diff(t))",
            "quaternion: w is declared in the parent's components",
        ),
        (
            "(u, 2 * w / self.square)",
            "(u, w / self.square)",
            "quaternion: w is declared without its 2",
        ),
        (
            "return e0**2 + e1**2 + e2**2 + e3**2",
            "return e0**2 + e1**2 + e2**2",
            "quaternion: the norm forgets a part",
        ),
    ),
    *faults_in(
        "mechanics.scene.declaration",
        (
            "to_plain(r.square - 1, table",
            "to_plain(r.square - 2, table",
            "quaternion: the square of the norm is 2",
        ),
        (
            "if u not in turning\n        ]",
            "if u in turning\n        ]",
            "quaternion: other speeds are not solved for",
        ),
    ),
    *faults_in(
        "mechanics.kinematics.chain",
        (
            "return spin.omega, tuple(tangent(spin.omega, rates))",
            "return scale(-1, spin.omega), tuple(tangent(spin.omega, rates))",
            "quaternion: the chain turns backwards",
        ),
        (
            "return spin.omega, tuple(tangent(spin.omega, rates))",
            "return spin.omega, scale(2, tuple(tangent(spin.omega, rates)))",
            "quaternion: the angular acceleration counts twice",
        ),
    ),
    *faults_in(
        "mechanics.routes.kane_sympy",
        (
            "q.diff(dynamicsymbols._t) - rate for",
            "q.diff(dynamicsymbols._t) + rate for",
            "kane (SymPy): a quaternion changes backwards",
        ),
    ),
    *faults_in(
        "mechanics.routes.lagrange_sympy",
        (
            "table = {q.diff(t): rate for",
            "table = {q.diff(t): -rate for",
            "lagrange (SymPy): a quaternion changes backwards",
        ),
    ),
    *faults_in(
        "mechanics.routes.sympy_model",
        (
            "omega = [self.scalar(speed) for speed",
            "omega = [-self.scalar(speed) for speed",
            "SymPy: a quaternion turns backwards",
        ),
    ),
)

SPRINGS = (
    *faults_in(
        "mechanics.scene.loads",
        (
            "along, slack, first_on, second_on)",
            "along, slack, second_on, first_on)",
            "a spring exchanges the bodies at its ends when it is declared",
        ),
    ),
    *faults_in(
        "mechanics.mechanism",
        (
            "self.carrier(load.first, load.first_on",
            "self.carrier(load.first, load.second_on",
            "the first end of a spring is on the second body",
        ),
        (
            "self.carrier(load.second, load.second_on",
            "self.carrier(load.second, load.first_on",
            "the second end of a spring is on the first body",
        ),
    ),
)

ROWS = (*CARRYING, *CLOSING, *ENDS, *AXES, *PLANE, *EULER, *QUATERNIONS, *SPRINGS)
