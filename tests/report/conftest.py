"""Results for the tests of the report: a small one by hand, and one of real derivations."""

import itertools

import numpy as np
import pytest
from sympy import Matrix, Symbol, cos, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.blame.result import Blame, Difference, Edit, Mistake, Repair
from mechanics.claims.names import Match
from mechanics.claims.read import read_source
from mechanics.equations import Equations, Line, Matrices, Step
from mechanics.judge.check import check, derived
from mechanics.kernel import Finding, Verdict, Witness
from mechanics.report.answer.check import Check
from mechanics.report.answer.judged import Judged
from mechanics.report.result import (
    LedgerResult,
    Modes,
    Motion,
    ResidualResult,
    RouteResult,
    SystemResult,
)
from mechanics.scene import Particle, Scene, parameters, reaction, spring
from mechanics.scene.published import Quantity, published
from systems import elastic_pendulum

x, f = dynamicsymbols("x f")
m, k = parameters("m k", units="kg N/m", typical="2 8", meanings=("mass of the block", "stiffness"))
WITNESS = Witness((("x", "1/3"), ("m", "2.5")), "1.25 +/- 1e-30", "-1.25 +/- 1e-30")


def block() -> Scene:
    """A block on a rail, held by a spring."""
    ground = ReferenceFrame("N")
    origin = Point("O")
    centre = origin.locatenew("C", x * ground.x)
    return Scene(
        "block <on a spring>",
        ground,
        origin,
        coordinates=(x,),
        bodies=(Particle("block", centre, m),),
        loads=(spring("k", origin, centre, k, along=ground.x),),
        reactions=(reaction("N", at=centre, on="block", by=None, along=ground.y),),
        example={"x": 0.5},
    )


def equations(scene: Scene, route: str) -> Equations:
    none = Matrix.zeros(0, 1)
    matrices = Matrices(Matrix([[m]]), Matrix([-k * scene.q[0]]), Matrix.zeros(1, 0), none, none)
    return Equations(
        scene,
        route,
        (),
        conjugate=True,
        textbook=matrices,
        reactions=((Symbol("N", real=True), m * cos(scene.q[0])),) if route == "free_body" else (),
    )


def steps(equations: Equations) -> tuple[Step, ...]:
    (x,), (acceleration,) = equations.scene.q, equations.scene.ud
    return (
        Step("Kinematics", "The position $x$ and its rate.", (Line("r_x", x),)),
        Step("Free body", "", (Line(m * acceleration, -k * x, "block, along N.x"),)),
        equations.result,
    )


@pytest.fixture
def small() -> SystemResult:
    """Every part of a report once, with every verdict."""
    scene = block()
    routes = {
        name: RouteResult(
            equations(scene, name),
            seconds,
            operations,
            "fewest",
            operations + 5,
            steps=steps(equations(scene, name)),
        )
        for name, seconds, operations in (
            ("free_body", 0.004, 12),
            ("moving_point", 0.25, 9),
            ("kane", 3.5, 1234),
        )
    }
    verdicts = (Verdict.CERTIFIED, Verdict.REFUTED, Verdict.UNDECIDED)
    pairs = {
        (one, two): Finding(
            f"{one} = {two}: accelerations",
            verdict,
            "said by the test",
            2.0**-100 if verdict is Verdict.CERTIFIED else None,
            WITNESS if verdict is Verdict.REFUTED else None,
        )
        for (one, two), verdict in zip(itertools.combinations(routes, 2), verdicts, strict=True)
    }
    other = Finding("kinematics: both ways", Verdict.SUPPORTED, "numbers agree")
    row = published(
        "(1)",
        Quantity(),
        m * x.diff(dynamicsymbols._t, 2) + k * x,
        0,
        label="motion",
        note="a sign was read as meant",
    )
    t = np.linspace(0, 3, 31)
    columns = {
        "t": t,
        "x": 0.5 * np.cos(2 * t),
        "x_dot": -np.sin(2 * t),
        "kinetic_energy": np.sin(2 * t) ** 2,
        "potential_energy": np.cos(2 * t) ** 2,
        "total_energy": np.ones(31),
    }
    return SystemResult(
        scene.name,
        scene,
        routes,
        findings=(*pairs.values(), other),
        published=(LedgerResult(row, Finding("(1)", Verdict.PROVED, "zero in the normal form")),),
        compiled=(ResidualResult("kane: equation (1), double", 3.25, 100_000),),
        modes=(Modes("Modes", ((r"$\omega_1$", sqrt(k / m), "2.000 rad/s"),)),),
        motion=Motion(scene.name, columns, "the whole duration was integrated"),
        remarks=("No C compiler was found.",),
        pairs=pairs,
    )


SIX = (
    r"(M+m) \ddot{x}+2 k x+\frac{M L}{2}\left(\ddot{\theta} \cos \theta"
    r"-\dot{\theta}^{2} \sin \theta\right)=0 \tag{6}"
)
SEVEN = (
    r"M \frac{L}{2} \ddot{x} \cos \theta+M \frac{L^{2}}{12} \ddot{\theta}"
    r"-M g \frac{L}{2} \sin \theta=0 \tag{7}"
)
TYPED = "M*L/2*x''*cos(theta) + M*L**2/12*theta'' + M*g*L/2*sin(theta) = 0"


def edit(source: str, mistake: Mistake, written: str, right: str, nth: int = 0) -> Edit:
    """An edit of the nth place where something stands."""
    at = -1
    for _ in range(nth + 1):
        at = source.index(written, at + 1)
    return Edit(mistake, written, right, (at, at + len(written)))


def blame_of(source: str) -> Blame:
    """Two errors of (7), with an alternative of the second kind."""
    proved = Finding("(7)", Verdict.PROVED, "both sides have the same normal form")
    factor = edit(source, Mistake.FACTOR, "12", "3")
    sign = edit(source, Mistake.SIGN, "-", "+")
    other = Edit(Mistake.MISSING, "", r"+2 M g \frac{L}{2} \sin \theta", (len(source) - 2,) * 2)
    fixed = source.replace("12", "3")
    return Blame(
        (
            Difference(
                "coefficient of theta_ddot", r"M \frac{L^{2}}{12}", r"M \frac{L^{2}}{3}",
                ("pendulum: rate of angular momentum", "pendulum: v_B x P"),
            ),
            Difference("products of speeds", "", " + ".join([r"\dot{\theta}^{2} L"] * 12)),
            Difference("gravity", "", r"M g \frac{L}{2} \sin \theta", ("load gravity",)),
        ),
        (
            Repair((factor, sign), fixed.replace("-M", "+M"), proved),
            Repair((factor, other), fixed, proved),
        ),
        ("the parallel axis is left out: pendulum",),
    )  # fmt: skip


@pytest.fixture(scope="session")
def answered() -> Check:
    """A check with a statement of every kind; its blame is typed by hand."""
    scene = elastic_pendulum.scene()
    made = check(scene, [f"{SIX} \\\\ {SEVEN}", TYPED])
    six, seven, typed = made.judged
    lost = read_source(scene, "x = what*k").statements[0]
    wrong = edit(TYPED, Mistake.FACTOR, "12", "3")
    repaired = Repair((wrong,), TYPED.replace("12", "3"), six.finding)
    bound = Finding("", Verdict.CERTIFIED, "zero at a random point", 2.0**-100)
    return Check(
        scene,
        (
            Judged(six.statement, six.finding),
            Judged(seven.statement, seven.finding, ("theta is minus",), blame_of(source(seven))),
            Judged(typed.statement, typed.finding, (), Blame((), (repaired,))),
            Judged(typed.statement, typed.finding, (), Blame((), (), (), "208 edits were tried")),
            Judged(six.statement, bound),
            Judged(lost, Finding("", Verdict.UNDECIDED, lost.doubt)),
            Judged(six.statement, Finding("", Verdict.SUPPORTED, "numbers agree")),
        ),
        (Match("phi", "theta", "as given"), Match("y", "x", "the only coordinate left")),
        ("I_B is taken as defined by: I_B = 1",),
        derived(scene),
    )


def source(entry: Judged) -> str:
    """What was written, as the statement keeps it."""
    return entry.statement.source
