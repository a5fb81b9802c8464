"""Faults in what rolls, and in ropes."""

from benchmarks.faults.fault import faults_in

LEANING = faults_in(
    "mechanics.scene.joints.roll",
    (
        '"Axis", (yaw, base.axes(frame)[2]))',
        '"Axis", (-yaw, base.axes(frame)[2]))',
        "a wheel yaws backwards",
    ),
    (
        '"Axis", (lean, base.axes(heading)[0]))',
        '"Axis", (lean, base.axes(heading)[1]))',
        "a wheel leans about its axle",
    ),
    (
        '"Axis", (spin, base.axes(hub)[1]))',
        '"Axis", (-spin, base.axes(hub)[1]))',
        "a wheel spins backwards",
    ),
    (
        "base.sign * r * base.axes(hub)[2])",
        "r * base.axes(hub)[2])",
        "a wheel stands on the other side of its plane",
    ),
    (
        "base.sign * r * base.axes(hub)[2])",
        "base.sign * r * base.axes(heading)[2])",
        "a wheel that leans stays as high",
    ),
    (
        "rolled = base.sign * r * spin.diff(_T)",
        "rolled = -base.sign * r * spin.diff(_T)",
        "a wheel rolls backwards",
    ),
    (
        "x.diff(_T) - rolled * cos(yaw)",
        "x.diff(_T) - rolled * sin(yaw)",
        "a wheel rolls along another heading",
    ),
    (
        "rows = {FORWARD: (forward, ahead - rolled), SIDE: (side, across)}",
        "rows = {FORWARD: (side, ahead - rolled), SIDE: (forward, across)}",
        "friction of a wheel is exchanged",
    ),
    (
        "total = spin.diff(_T) + yaw.diff(_T) * sin(lean)",
        "total = spin.diff(_T) + yaw.diff(_T) * cos(lean)",
        "the total spin rate counts yaw by the cosine",
    ),
    (
        "across = y.diff(_T) * cos(yaw) - x.diff(_T) * sin(yaw)",
        "across = y.diff(_T) * cos(yaw) + x.diff(_T) * sin(yaw)",
        "the velocity to the side has a wrong sign",
    ),
)

GUIDED = faults_in(
    "mechanics.scene.joints.roll",
    (
        "slip = x.diff(_T) - r * angle.diff(_T) *",
        "slip = x.diff(_T) + r * angle.diff(_T) *",
        "an upright wheel rolls backwards",
    ),
    (
        "contact.locatenew(ends.name, r * base.normal)",
        "contact.locatenew(ends.name, -r * base.normal)",
        "an upright wheel hangs below its plane",
    ),
    (
        "slip = (big - side * r) * phi.diff(_T) + side * r * angle.diff(_T)",
        "slip = big * phi.diff(_T) + side * r * angle.diff(_T)",
        "a wheel in a ring rolls as if its centre were at the contact",
    ),
    (
        "slip = (big - side * r) * phi.diff(_T) + side * r * angle.diff(_T)",
        "slip = (big - side * r) * phi.diff(_T) - side * r * angle.diff(_T)",
        "a wheel in a ring rolls backwards",
    ),
    (
        "(big - side * r) * out)",
        "(big + side * r) * out)",
        "a wheel is on the other side of its ring",
    ),
    (
        "(phi, angle), -side * out, along",
        "(phi, angle), side * out, along",
        "a ring pulls its wheel",
    ),
    (
        'reaction_couple(f"{name}_m{FORWARD}", on, by, along)',
        'reaction_couple(f"{name}_m{FORWARD}", on, by, axle)',
        "a couple of a guided wheel acts about its axle",
    ),
    (
        'reaction(f"{name}_{SIDE}", contact, on, by, axle)',
        'reaction(f"{name}_{SIDE}", centre, on, by, axle)',
        "the force to the side acts at the centre",
    ),
)

TOUCHING = faults_in(
    "mechanics.scene.joints.roll",
    (
        "place.dot(n) - shape.height, press.name",
        "place.dot(n) + shape.height, press.name",
        "what touches hangs below its plane",
    ),
    (
        "moving.dot(along) + shape.turning.dot(along)",
        "moving.dot(along) - shape.turning.dot(along)",
        "what touches rolls backwards",
    ),
    (
        "moving.dot(along) + shape.turning.dot(along)",
        "moving.dot(along)",
        "what touches does not roll, but stays",
    ),
    (
        "parts = [(a**2 * n.dot(e), e)",
        "parts = [(a * n.dot(e), e)",
        "an ellipsoid forgets the squares of its semi-axes",
    ),
    (
        "way = sum((-part / height * e for part, e in parts), Vector(0))",
        "way = -height * n",
        "an ellipsoid touches below its centre",
    ),
    (
        "r / steep * (rolling + leaning)",
        "r / steep * (rolling - leaning)",
        "a wheel by its axle leans the other way",
    ),
    (
        "rolling = -frame.ang_vel_in(base.frame).dot(axle) * ahead",
        "rolling = frame.ang_vel_in(base.frame).dot(axle) * ahead",
        "a wheel by its axle rolls backwards",
    ),
    (
        "way = -r / steep * (n - slope * axle)",
        "way = -r / steep * (n + slope * axle)",
        "a wheel by its axle touches elsewhere",
    ),
    (
        'word: reaction(f"{ends.name}_{word}", contact, ends.child, ends.parent, along)',
        'word: reaction(f"{ends.name}_{word}", ends.at, ends.child, ends.parent, along)',
        "friction acts at the parent's point",
    ),
)

ROPES = faults_in(
    "mechanics.scene.joints.rope",
    (
        "total += distance",
        "total = distance",
        "a rope is as long as its last part",
    ),
    (
        "(two, one, -unit) if two is not None",
        "(two, one, unit) if two is not None",
        "a rope pushes",
    ),
    (
        "else (one, two, unit)",
        "else (one, two, -unit)",
        "the end of a rope on the ground pushes",
    ),
    (
        "at = second if two is not None else first",
        "at = ends[0][1]",
        "all of a rope pulls where it begins",
    ),
    (
        "parts=tuple(pulls[1:])",
        "parts=tuple(pulls[2:])",
        "a rope forgets what its second part does",
    ),
    (
        "span / distance if direction is None",
        "span if direction is None",
        "a rope pulls by its length",
    ),
    (
        "Reaction(name, str(on), by, back, at)",
        "Reaction(name, str(on), None, back, at)",
        "a rope pulls at one end only",
    ),
)

ROWS = (*LEANING, *GUIDED, *TOUCHING, *ROPES)
