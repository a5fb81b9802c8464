"""Random mechanisms: quaternions, loops in a plane or in space, rolling contacts, against NumPy.

    [M  A^T] [q''    ]   [F]        M = sum m Jv^T Jv + Jw^T I Jw                             (1)
    [A  0  ] [-lambda] = [b]        F = sum Jv^T (m g - m a0) - Jw^T (I w0' + w x I w)        (2)

Jv and Jw are complex steps of positions and rotation matrices as SymPy's points and frames give
them, a0 and w0' differences of velocities along q + q' t. A quaternion is four coordinates with its
norm a row of A. Nothing of the package is used but the scene's own points and frames.
"""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import combinations

import numpy as np
import pytest
from hypothesis import Phase, given, seed, settings
from hypothesis import strategies as st
from sympy import Expr, Matrix, Rational, lambdify
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia
from trees_of_joints import Drawn, joined, mass_of, trees

from mechanics import compile, derive
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import check_laws, derive_rows
from mechanics.routes.derivation import ROUTES
from mechanics.scene import (
    Joint,
    RigidBody,
    Scene,
    ball,
    euler,
    free,
    gravity,
    pin,
    quaternion,
    roll,
    slide,
    universal,
)

Array = np.ndarray
GRAVITY = Rational(981, 100)
TURNS = (Matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), Matrix([[3, -4, 0], [4, 3, 0], [0, 0, 5]]) / 5,
         Matrix([[-5, -12, 0], [12, -5, 0], [0, 0, 13]]) / 13,
         Matrix([[8, 15, 0], [-15, 8, 0], [0, 0, 17]]) / 17)  # fmt: skip
"""Turns about z with rational entries: a loop closes at the coordinates 0 in exact numbers."""


@dataclass(frozen=True)
class Made:
    """A scene, and what is known of it without the package.

    Attributes
    ----------
    norms : tuple of tuples of Expr
        Coordinates of each quaternion, whose squares add up to 1.
    gaps : tuple of Expr
        0 where loops are closed and wheels touch.
    rolls : tuple of (Point, ReferenceFrame, axle or None, radius)
        What rolls on the plane z = 0; without an axle it is a ball.
    """

    scene: Scene
    norms: tuple[tuple[Expr, ...], ...] = ()
    gaps: tuple[Expr, ...] = ()
    rolls: tuple[tuple[Point, ReferenceFrame, int | None, Rational], ...] = ()


def body_of(i: int, joint: Joint, flat: bool = False) -> RigidBody:
    mass, centre, moments = mass_of(i)
    F = joint.frame
    x, y, z = centre
    place = joint.point.locatenew(f"C{i}", x * F.x + y * F.y + (0 if flat else z) * F.z)
    return RigidBody(joint.child, place, F, mass, inertia(F, *moments[:3], *(
        (0, 0, 0) if flat else moments[3:])))  # fmt: skip


def tree(drawn: tuple[Drawn, ...], charts: tuple[bool, ...]) -> Made:
    """Joints of every kind; balls and free bodies are turned by quaternions where no chart is."""
    N, O = ReferenceFrame("N"), Point("O")
    frames, points, names = [N], [O], [None]
    joints, norms = [], []
    for i, (own, chart) in enumerate(zip(drawn, charts, strict=False), start=1):
        outer = frames[own.parent]
        fixed = outer.orientnew(f"F{i}", "Axis", (own.angle * Rational(1, 2), outer.x))
        at = points[own.parent].locatenew(f"P{i}", outer.x / 5 - outer.y * Rational(i, 10))
        if chart or own.kind not in ("ball", "free"):
            joint = joined(own, f"J{i}", names[own.parent], at, fixed)
        else:
            rotation = quaternion(
                " ".join(f"J{i}_e{k}" for k in range(4)), " ".join(f"J{i}_w{k}" for k in range(3))
            )
            norms.append(rotation.coordinates)
            if own.kind == "ball":
                joint = ball(f"J{i}", names[own.parent], f"body{i}", at=at, frame=fixed,
                             rotation=rotation)  # fmt: skip
            else:
                q = dynamicsymbols(f"J{i}_q1:4")
                joint = free(f"J{i}", f"body{i}", at=at, frame=fixed, coordinates=q,
                             rotation=rotation)  # fmt: skip
        joints.append(joint)
        frames.append(joint.frame)
        points.append(joint.point)
        names.append(joint.child)
    bodies = tuple(body_of(i, joint) for i, joint in enumerate(joints, start=1))
    return Made(Scene("tree", N, O, bodies=bodies, joints=tuple(joints),
                      loads=(gravity(-GRAVITY * N.z),)), tuple(norms))  # fmt: skip


@dataclass(frozen=True)
class Dyad:
    """Two bodies from one body or the ground to another: where it begins and ends, what slides."""

    first: int
    second: int
    turns: tuple[int, int, int]
    slides: bool


@st.composite
def linkages(draw: st.DrawFn) -> tuple[Dyad, ...]:
    """A crank, and up to four dyads, each a loop."""
    found = []
    for k in range(draw(st.integers(1, 4))):
        bodies = list(range(2 + 2 * k))
        first, second = draw(st.sampled_from([*combinations(bodies, 2)]))
        if draw(st.booleans()):
            first, second = second, first
        turns = tuple(draw(st.integers(0, len(TURNS) - 1)) for _ in range(3))
        found.append(Dyad(first, second, turns, draw(st.booleans())))
    return tuple(found)


def linkage(dyads: tuple[Dyad, ...]) -> Made:
    """Bodies in the plane z = 0; the coordinates 0 are a pose."""
    N, O = ReferenceFrame("N"), Point("O")
    frames, points, names = [N], [O], [None]
    joints, gaps = [], []

    def added(name: str, on: int, place: tuple[int, int], turn: int, sliding: bool) -> int:
        F = frames[on]
        at = points[on].locatenew(f"P{name}", place[0] * F.x / 7 + place[1] * F.y / 7)
        fixed = ReferenceFrame(f"F{name}")
        fixed.orient_explicit(F, TURNS[turn])
        q = dynamicsymbols(f"q{name}")
        if sliding:
            joint = slide(name, names[on], f"body{name}", at=at, axis=fixed.x, distance=q)
        else:
            joint = pin(name, names[on], f"body{name}", at=at, axis=fixed.z, angle=q)
        joints.append(joint)
        frames.append(joint.frame)
        points.append(joint.point)
        names.append(joint.child)
        return len(frames) - 1

    added("A", 0, (0, 0), 1, False)
    for k, dyad in enumerate(dyads):
        one = added(f"B{k}", dyad.first, (3 + k, 2), dyad.turns[0], dyad.slides)
        two = added(f"C{k}", one, (5, -1 - k), dyad.turns[1], False)
        # The end of the dyad is at a point of the other body: here in numbers, at the pose 0.
        still = {q: 0 for joint in joints for q in joint.coordinates}
        tip = points[two].locatenew(f"T{k}", frames[two].x * Rational(6 + k, 7))
        F = frames[dyad.second]
        reach = tip.pos_from(points[dyad.second]).to_matrix(F).subs(still)
        at = points[dyad.second].locatenew(f"G{k}", reach[0] * F.x + reach[1] * F.y)
        joints.append(pin(f"D{k}", names[dyad.second], names[two], at=at, axis=F.z, onto=tip))
        gap = tip.pos_from(at).to_matrix(N)
        gaps += [gap[0], gap[1]]
    carrying = [joint for joint in joints if joint.carries]
    bodies = tuple(body_of(i, joint, flat=True) for i, joint in enumerate(carrying, start=1))
    return Made(Scene("linkage", N, O, bodies=bodies, joints=tuple(joints), plane=N.z,
                      loads=(gravity(-GRAVITY * N.y),)), (), tuple(gaps))  # fmt: skip


@dataclass(frozen=True)
class Crank:
    """A loop in space: a crank's length, the tip of the rod, the post and axis of the rocker."""

    length: int
    tip: tuple[int, int, int]
    post: tuple[int, int, int]
    turn: int
    axis: int


@st.composite
def cranks(draw: st.DrawFn) -> Crank:
    places = st.tuples(st.integers(3, 6), st.integers(-3, 3), st.integers(-3, 3))
    turn = draw(st.integers(0, len(TURNS) - 1))
    return Crank(draw(st.integers(1, 3)), draw(places), draw(places), turn, draw(st.integers(0, 2)))


def space(drawn: Crank) -> Made:
    """Crank, Cardan joint, rod, ball and rocker; the coordinates 0 are a pose."""
    N, O = ReferenceFrame("N"), Point("O")
    q1, q2, q3, q4 = dynamicsymbols("q1:5")
    crank = pin("A", None, "bodyA", at=O, axis=N.z, angle=q1)
    end = O.locatenew("E", Rational(drawn.length, 7) * crank.frame.x + crank.frame.z / 9)
    rod = universal("B", "bodyA", "bodyB", at=end, frame=crank.frame, axes="yz", angles=(q2, q3))
    tip = rod.point.locatenew("T", along(rod.frame, drawn.tip))
    post, fixed = O.locatenew("G", along(N, drawn.post)), ReferenceFrame("F")
    fixed.orient_explicit(N, TURNS[drawn.turn])
    rocker = pin("C", None, "bodyC", at=post, axis=[*fixed][drawn.axis], angle=q4)
    still = dict.fromkeys((q1, q2, q3, q4), 0)
    reach = tip.pos_from(post).to_matrix(rocker.frame).subs(still)
    hung = post.locatenew("H", sum((x * e for x, e in zip(reach, rocker.frame, strict=True)), 0))
    close = ball("D", "bodyB", "bodyC", at=tip, frame=rod.frame, onto=hung)
    bodies = tuple(body_of(i, joint) for i, joint in enumerate((crank, rod, rocker), start=1))
    scene = Scene("loop in space", N, O, bodies=bodies, joints=(crank, rod, rocker, close),
                  loads=(gravity(-GRAVITY * N.z),))  # fmt: skip
    return Made(scene, (), tuple(tip.pos_from(hung).to_matrix(N)))


def along(frame: ReferenceFrame, place: tuple[int, int, int]) -> Expr:
    return sum((Rational(x, 7) * e for x, e in zip(place, frame, strict=True)), 0)


@dataclass(frozen=True)
class Roller:
    """A wheel or a ball on the ground, and what hangs on it."""

    kind: str
    more: str


def roller(drawn: Roller) -> Made:
    N, O, r = ReferenceFrame("N"), Point("O"), Rational(3, 10)
    x, y, z, a, b, c, d = dynamicsymbols("x y z a b c d")
    norms: tuple[tuple[Expr, ...], ...] = ()
    gaps: tuple[Expr, ...] = ()
    if drawn.kind == "disc":
        joints = [roll("R", None, "body1", at=O, normal=N.z, radius=r, coordinates=(x, y),
                       angles=(a, b, c))]  # fmt: skip
        rolls = ((joints[0].point, joints[0].frame, 1, r),)
    else:
        rotation = euler("zxy", a, b, c)
        if drawn.kind.endswith("quaternion"):
            rotation = quaternion("e0 e1 e2 e3", "w1 w2 w3")
            norms = (rotation.coordinates,)
        air = free("F", "body1", at=O, frame=N, coordinates=(x, y, z), rotation=rotation)
        axle = 1 if drawn.kind.startswith("wheel") else None
        own = {} if axle is None else {"axis": air.frame.y}
        joints = [air, roll("R", None, "body1", at=O, normal=N.z, radius=r,
                            onto=(air.point, air.frame), **own)]  # fmt: skip
        rolls = ((air.point, air.frame, axle, r),)
        height = r if axle is None else r * (1 - air.frame.y.dot(N.z) ** 2) ** Rational(1, 2)
        gaps = (z - height,)
    carrier = joints[0]
    if drawn.more != "none":
        F = carrier.frame
        at = carrier.point.locatenew("E", F.x / 10)
        joints.append(pin("H", "body1", "body2", at=at, axis=F.z, angle=d) if drawn.more == "pin"
                      else slide("H", "body1", "body2", at=at, axis=F.z, distance=d))  # fmt: skip
    carrying = [joint for joint in joints if joint.carries]
    bodies = tuple(body_of(i, joint) for i, joint in enumerate(carrying, start=1))
    example = {} if drawn.kind == "disc" else {"z": r}
    scene = Scene("roller", N, O, bodies=bodies, joints=tuple(joints),
                  loads=(gravity(-GRAVITY * N.z),), example=example)  # fmt: skip
    return Made(scene, norms, gaps, rolls)


class Reference:
    """Equations (1) and (2) in numbers."""

    def __init__(self, made: Made) -> None:
        scene = made.scene
        self.q = list(scene.coordinates)
        self.made, N, O = made, scene.frame, scene.origin
        pairs = [(body.centre, body.frame) for body in scene.bodies]
        pairs += [(point, frame) for point, frame, *_ in made.rolls]
        entries = [[*point.pos_from(O).to_matrix(N), *N.dcm(frame)] for point, frame in pairs]
        rows = [sum((e**2 for e in norm), -1) for norm in made.norms]
        self.poses: Callable[..., list] = lambdify([self.q], entries, "numpy", cse=True)
        self.gaps: Callable[..., list] = lambdify([self.q], [*made.gaps, *rows], "numpy", cse=True)
        self.bodies = [(float(body.mass), np.array(body.inertia.to_matrix(body.frame), dtype=float))
                       for body in scene.bodies]  # fmt: skip
        (self.field,) = (np.array(load.field.to_matrix(N), dtype=float).ravel()
                         for load in scene.loads)  # fmt: skip

    def pose(self, q: Array) -> tuple[Array, Array]:
        found = np.array(self.poses(q))
        return found[:, :3], found[:, 3:].reshape(-1, 3, 3)

    def velocity(self, q: Array, v: Array) -> tuple[Array, Array]:
        """Of the points, and angular, by a complex step along v."""
        step = 1e-30
        points, frames = self.pose(q + 1j * step * v)
        W = (frames.imag / step) @ np.swapaxes(frames.real, 1, 2)
        return points.imag / step, np.stack([W[:, 2, 1], W[:, 0, 2], W[:, 1, 0]], axis=1)

    def row(self, q: Array, v: Array) -> Array:
        """Rates of all constraints."""
        found = list(np.imag(self.gaps(q + 1e-30j * v)) / 1e-30) if self.gaps(q) else []
        points, turning = self.velocity(q, v)
        _, frames = self.pose(q)
        n = np.array([0.0, 0.0, 1.0])
        for k, (_, _, axle, r) in enumerate(self.made.rolls, start=len(self.bodies)):
            down = n if axle is None else n - frames[k].real[:, axle].dot(n) * frames[k][:, axle]
            arm = -float(r) * down / np.sqrt(down.dot(down))
            found += list((points[k] + np.cross(turning[k], arm))[:2])
        return np.array(found)

    def rate(self, along: Callable[[float], Array]) -> Array:
        """Derivative at 0: differences of the sixth order."""
        h = 4e-3
        pairs = ((1, 45), (2, -9), (3, 1))
        return sum(w * (along(k * h) - along(-k * h)) for k, w in pairs) / (60 * h)

    def accelerations(self, q: Array, v: Array) -> Array:
        count = len(q)
        unit = [self.velocity(q, e) for e in np.eye(count)]
        _, frames = self.pose(q)
        _, turning = self.velocity(q, v)
        bias = self.rate(lambda t: np.stack(self.velocity(q + t * v, v)))
        M, F = np.zeros((count, count)), np.zeros(count)
        for i, (mass, tensor) in enumerate(self.bodies):
            Jv = np.array([points[i] for points, _ in unit]).T
            Jw = np.array([omega[i] for _, omega in unit]).T
            I = frames[i] @ tensor @ frames[i].T
            M += mass * Jv.T @ Jv + Jw.T @ I @ Jw
            F += Jv.T @ (mass * (self.field - bias[0, i]))
            F -= Jw.T @ (I @ bias[1, i] + np.cross(turning[i], I @ turning[i]))
        A = np.array([self.row(q, e) for e in np.eye(count)]).T.reshape(-1, count)
        b = -self.rate(lambda t: self.row(q + t * v, v)).reshape(-1) if len(A) else np.zeros(0)
        kkt = np.block([[M, A.T], [A, np.zeros((len(A),) * 2)]])
        return np.linalg.solve(kkt, np.concatenate([F, b]))[:count]

    def state(self, rng: np.random.Generator) -> tuple[Array, Array]:
        """On the constraints, near the coordinates of the example."""
        q = rng.uniform(-0.3, 0.3, len(self.q))
        for norm in self.made.norms:
            q[self.q.index(norm[0])] = 0.8
        if self.made.rolls and self.made.gaps:
            q[[str(x) for x in self.q].index("z(t)")] = 0.3
        for _ in range(30):
            gap = np.real(np.array(self.gaps(q + 0j), dtype=complex))
            if not len(gap):
                break
            J = np.array([np.imag(self.gaps(q + 1e-30j * e)) / 1e-30 for e in np.eye(len(q))]).T
            q = q - np.linalg.lstsq(J, gap, rcond=None)[0]
        v = rng.uniform(-1, 1, len(q))
        A = np.array([self.row(q, e) for e in np.eye(len(q))]).T.reshape(-1, len(q))
        return q, v - np.linalg.pinv(A) @ (A @ v) if len(A) else v

    def regular(self, q: Array) -> bool:
        gap = self.gaps(q + 0j)
        A = np.array([self.row(q, e) for e in np.eye(len(q))]).T.reshape(-1, len(q))
        closed = not gap or np.abs(np.array(gap)).max() < 1e-13
        return closed and (not len(A) or np.linalg.svd(A)[1].min() > 1e-2)


def assert_all_agree(made: Made, number: int) -> bool:
    """Whether accelerations were compared too: not where the drawn pose is singular."""
    scene = made.scene
    programs = derive_rows(check_scene(scene), [route.name for route in ROUTES])
    found = [*compare_pairs(programs.routes).values(), *check_laws(programs)]
    assert not [finding for finding in found if not finding.shown]
    reference = Reference(made)
    q, v = reference.state(np.random.default_rng(number))
    if not reference.regular(q):
        return False
    values = dict(zip(reference.q, q, strict=True))
    rates = dict(zip(reference.q, v, strict=True))
    seconds = dict(zip(reference.q, reference.accelerations(q, v), strict=True))
    u, expected = speeds(scene, made, values, rates), speeds(scene, made, values, seconds)
    model = compile(derive(scene, "kane"), compiler=None, form="auto")
    answer = model.forward_dynamics(np.array([values[x] for x in scene.coordinates]), u)
    assert np.all(np.abs(answer - expected) < 1e-8 * (1 + np.abs(expected).max()))
    return True


def speeds(scene: Scene, made: Made, values: dict, rates: dict) -> Array:
    """Rates of coordinates, or w = 2 (e0 e' - e0' e - e x e'), in the order of the scene."""
    turned = {}
    for joint in scene.joints:
        for rotation in joint.rotations:
            e = np.array([values[x] for x in rotation.coordinates])
            d = np.array([rates[x] for x in rotation.coordinates])
            w = 2 * (e[0] * d[1:] - d[0] * e[1:] - np.cross(e[1:], d[1:]))
            turned |= dict(zip(map(str, rotation.speeds), w, strict=True))
    named = {str(x).removesuffix("(t)"): value for x, value in rates.items()}
    turned = {name.removesuffix("(t)"): value for name, value in turned.items()}
    found = []
    for u in map(str, scene.u):
        u = u.removesuffix("(t)")
        found.append(turned[u] if u in turned else named[u.removesuffix("_dot")])
    return np.array(found)


KINDS = ("disc", "ball", "ball quaternion", "wheel", "wheel quaternion")
MECHANISMS = st.one_of(
    st.builds(partial, st.just(tree), trees(), st.tuples(*[st.booleans()] * 3)),
    st.builds(partial, st.just(linkage), linkages()),
    st.builds(partial, st.just(space), cranks()),
    st.builds(partial, st.just(roller), st.builds(Roller, st.sampled_from(KINDS),
                                                  st.sampled_from(("none", "pin", "slide")))),
)  # fmt: skip


@pytest.mark.campaign
@pytest.mark.parametrize("kind", ["ball", "free"])
def test_quaternions_move_as_numpy_says(kind: str) -> None:
    assert assert_all_agree(tree((Drawn(0, kind, 0, 1),), (False,)), 1)


@pytest.mark.campaign
def test_random_mechanisms_agree(
    request: pytest.FixtureRequest, capsys: pytest.CaptureFixture[str]
) -> None:
    compared: dict[str, bool] = {}
    kinds: Counter[str] = Counter()

    @seed(13)
    @settings(max_examples=request.config.getoption("draws"), deadline=None, database=None,
              phases=(Phase.explicit, Phase.generate))  # fmt: skip
    @given(make=MECHANISMS, number=st.integers(0, 99))
    def agree(make: partial[Made], number: int) -> None:
        drawn = f"{make.func.__name__} {make.args} {number}"
        if drawn not in compared:
            compared[drawn] = assert_all_agree(make(), number)
            kinds[make.func.__name__] += 1

    try:
        agree()
    finally:
        with capsys.disabled():
            words = ", ".join(f"{count} {kind}" for kind, count in sorted(kinds.items()))
            moved = sum(compared.values())
            print(
                f"\n{len(compared)} different mechanisms agree ({words}), {moved} in numbers, too"
            )
    assert moved > len(compared) / 2
