"""Where constraints hold: closed states, charts of their component, points of the field on them."""

import json
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import pytest
from linkages import LINKAGES, parallelogram, peaucellier, slider_crank
from sympy import Expr, Rational
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from benchmarks.space.deriving import distinct
from mechanics.checks.admissible import check_scene
from mechanics.crosscheck import derive
from mechanics.errors import SceneError
from mechanics.judge.check import check
from mechanics.kernel import enclose
from mechanics.mechanism import Mechanism, lower, name_of
from mechanics.program import Builder
from mechanics.program.interpret import include
from mechanics.program.residues import Residues
from mechanics.routes.redundant import without_redundant
from mechanics.scene import Particle, RigidBody, Scene, holonomic, parameters, pin, reaction
from mechanics.scene.json.read import from_json
from mechanics.scene.json.write import to_json
from systems import ALL, four_bar, four_bar_chain, rolling_disc

SCENES: dict[str, Callable[[], Scene]] = {
    "four_bar": four_bar.scene,
    "rolling_disc": rolling_disc.scene,
    **LINKAGES,
}


def lowered(name: str) -> Mechanism:
    return lower(SCENES[name](), Builder())


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_the_start_is_closed(name: str) -> None:
    mechanism = lowered(name)
    closure = mechanism.closure
    program = mechanism.builder.program({"off": closure.configuration or [mechanism.builder.zero]})
    assert closure.start.keys() >= set(program.inputs)
    off = enclose(program, closure.start, 400)["off"]
    assert all(abs(entry) < 2.0**-190 for entry in off)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_constraints_vanish_at_the_point_of_the_closed_filter(name: str) -> None:
    mechanism = lowered(name)
    anywhere, closed = mechanism.filters
    every = [*mechanism.closure.configuration, *mechanism.closure.rates]
    assert len(every) >= len(mechanism.constraints)
    assert set(closed.values(every)) == {0}
    assert 0 not in anywhere.values(every)


def test_filters_begin_with_the_point_of_the_closure(monkeypatch: pytest.MonkeyPatch) -> None:
    """A point that closes n loops of distinct lengths is found after many draws: once is enough."""
    mechanism = lower(four_bar_chain.scene(6, distinct), Builder())
    monkeypatch.setattr("mechanics.program.residues.TRIED_POINTS", 0)
    _, closed = mechanism.filters
    assert set(closed.values([*mechanism.closure.configuration, *mechanism.closure.rates])) == {0}
    _, fresh = replace(mechanism, closure=replace(mechanism.closure, choice=None)).filters
    assert any(fresh.values([*mechanism.closure.configuration]))


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_values_of_dependent_inputs_close_real_states_too(name: str) -> None:
    mechanism = lowered(name)
    closure, build = mechanism.closure, mechanism.builder
    program = build.program({"off": [*closure.configuration, *closure.rates]})
    values = {name_of(old): new for old, new in closure.values.items()}
    moved = build.program(include(build, program, values))
    near = {
        name: (closure.start.get(name, Fraction(k + 1, 3)) * (1 + Fraction(k % 5, 90)))
        for k, name in enumerate(moved.inputs)
    }
    off = enclose(moved, near, 400)["off"]
    assert all(abs(entry) < 2.0**-300 for entry in off)


def test_scenes_without_constraints_have_one_filter() -> None:
    for system in ALL:
        scene = system.scene()
        anywhere, closed = lower(scene, Builder()).filters
        assert (anywhere is closed) != bool(scene.constraints)


def test_a_parallelogram_and_its_twin_are_told_apart_by_the_example() -> None:
    equal = []
    for folded in (False, True):
        mechanism = lower(parallelogram(folded, "rocker"), Builder())
        q1, _, q3 = mechanism.q
        _, closed = mechanism.filters
        equal.append(closed.is_zero(q1.cos() - q3.cos()) and closed.is_zero(q1.sin() - q3.sin()))
    assert equal == [True, False]


def test_bars_of_a_rhombus_meet_across_it_as_in_the_example() -> None:
    """Peaucellier's inversor: |OB| |OP| = L^2 - l^2, so that P keeps its distance along x."""
    mechanism = lower(peaucellier(), Builder())
    _, closed = mechanism.filters
    r, L, l = (mechanism.builder.input(name) for name in "rLl")
    q2, q4, q5, q6, q7 = (mechanism.q[k] for k in (1, 3, 4, 5, 6))
    assert closed.is_zero(2 * r * (L * q2.cos() + l * q6.cos()) - L * L + l * l)
    assert closed.is_zero(q6.cos() + q5.cos())
    assert closed.is_zero(q7.sin() + q4.sin())
    assert not closed.is_zero(q6.sin() - q4.sin())


def test_without_typical_values_no_start_is_known() -> None:
    scene = slider_crank("slider")
    plain = dict(zip(scene.parameters, parameters("r l m g"), strict=False))
    assert len(plain) == 4
    x, y = dynamicsymbols("x y")
    N, O = ReferenceFrame("N"), Point("O")
    (L,) = parameters("L")
    bead = Scene(
        "bead", N, O, coordinates=(x, y),
        bodies=(Particle("bead", O.locatenew("B", x * N.x + y * N.y), L),),
        reactions=(reaction("S", O.locatenew("B2", x * N.x + y * N.y), "bead", None, N.y),),
        constraints=(holonomic("rail", y - L, "S"),),
    )  # fmt: skip
    closure = lower(bead, Builder()).closure
    assert closure.start == {}
    assert closure.values


def three_parallel_rods() -> Scene:
    """A third rod, parallel to both: off the component its constraints would stop all motion."""
    scene = parallelogram(False, "coupler")
    (m,) = parameters("m_4")
    s = dynamicsymbols("s")
    N = scene.frame
    bead = Particle("bead", scene.origin.locatenew("bead", s * N.x), m)
    q1, q2, q3 = scene.coordinates
    at = bead.centre
    return replace(
        scene,
        coordinates=(*scene.coordinates, s),
        bodies=(*scene.bodies, bead),
        reactions=(
            *scene.reactions,
            reaction("E", at, "bead", None, N.y),
            reaction("T", scene.body("rocker").centre, "rocker", "crank", N.x),
        ),
        constraints=(*scene.constraints, holonomic("rods turn equally", q3 - q1 + 0 * q2, "T")),
    )


def test_redundant_constraints_of_a_parallelogram_are_refused_or_dropped() -> None:
    scene = three_parallel_rods()
    words = "redundant constraints: rods turn equally follow from along x: "
    with pytest.raises(SceneError, match=words):
        check_scene(scene)
    left = without_redundant(scene)
    assert {c.name for c in scene.constraints} - {c.name for c in left.constraints} == {
        "rods turn equally"
    }
    assert {r.name for r in scene.reactions} - {r.name for r in left.reactions} == {"T"}
    assert without_redundant(left) is left
    check_scene(left)


def loop_in_space() -> Scene:
    ground, origin = ReferenceFrame("N"), Point("O")
    (m,) = parameters("m", typical="1")
    joints, bodies, at, axis, carrier = [], [], origin, ground.z, None
    for k, length in enumerate((1, 2, Rational(3, 2))):
        name = f"rod {k}"
        joint = pin(f"p{k}", carrier, name, at=at, axis=axis, angle=dynamicsymbols(f"q{k}"))
        centre = joint.point.locatenew(f"c{k}", length * joint.frame.x / 2)
        tensor = inertia(joint.frame, m, 2 * m, 2 * m)
        bodies.append(RigidBody(name, centre, joint.frame, m, tensor))
        at = joint.point.locatenew(f"e{k}", length * joint.frame.x)
        axis, carrier = joint.frame.z, name
        joints.append(joint)
    foot = origin.locatenew("D", 2 * ground.x)
    joints.append(pin("last", None, carrier, at=foot, axis=ground.z, onto=(at, axis)))
    example = {"q0": 1.0, "q1": -0.9, "q2": -2.0}
    return Scene(
        "loop", ground, origin, bodies=tuple(bodies), joints=tuple(joints), example=example
    )


def test_a_planar_loop_that_pins_close_in_space_has_three_redundant_constraints() -> None:
    scene = loop_in_space()
    words = "last_z_closes, last_mx_closes, last_my_closes: it restricts no speed: .* redundant="
    with pytest.raises(SceneError, match=words):
        check_scene(scene)
    left = without_redundant(scene)
    assert [len(s.constraints) for s in (scene, left)] == [5, 2]
    assert len(scene.reactions) - len(left.reactions) == 3
    assert "last_mx, last_my, last_z" in left.notes[0]
    check_scene(left)


def test_redundant_constraints_are_dropped_where_the_scene_says_so() -> None:
    scene = replace(loop_in_space(), redundant="drop")
    left = derive(from_json(json.dumps(to_json(scene))), "kane").scene
    assert [len(s.constraints) for s in (scene, left)] == [5, 2]
    assert "last_mx, last_my, last_z left out" in left.notes[-1]
    with pytest.raises(SceneError, match="loop: redundant is 'keep': it has to be 'refuse' or 'd"):
        replace(scene, redundant="keep")


def test_statements_on_a_loop_of_which_no_exact_point_is_known_are_judged() -> None:
    scene = replace(loop_in_space(), redundant="drop")
    assert not lower(derive(scene, "kane").scene, Builder()).closure.values
    (judged,) = check(scene, "q0'' = 1").judged
    assert not judged.finding.shown


def bead_in_a_plane(*constraints: Expr) -> Scene:
    x, y = dynamicsymbols("x y")
    ground, origin = ReferenceFrame("N"), Point("O")
    (m,) = parameters("m", typical="1")
    at = origin.locatenew("B", x * ground.x + y * ground.y)
    return Scene(
        "bead",
        ground,
        origin,
        coordinates=(x, y),
        bodies=(Particle("bead", at, m),),
        reactions=tuple(reaction(f"R{k}", at, "bead", None, ground.y) for k in (0, 1)),
        constraints=tuple(holonomic(f"c{k}", c, f"R{k}") for k, c in enumerate(constraints)),
    )


def test_constraints_that_touch_are_not_redundant() -> None:
    """On y = 0 and y = x^2 nothing moves, although their rows are equal where both hold.

    Nor does anything on y = 0 and y + (k - 1) x = 0, but for k = 1.
    """
    x, y = dynamicsymbols("x y")
    (k,) = parameters("k")
    scene = bead_in_a_plane(y, y - x**2)
    assert without_redundant(scene) is scene
    with pytest.raises(SceneError, match="c1 may be redundant at some states only"):
        without_redundant(bead_in_a_plane(y, y + (k - 1) * x))


def test_constraints_that_contradict_each_other_are_not_redundant() -> None:
    y, t = dynamicsymbols("y"), dynamicsymbols._t
    with pytest.raises(SceneError, match="c1: it contradicts the others"):
        without_redundant(bead_in_a_plane(y, y - t))


@pytest.mark.parametrize("loops", [1, 2])
def test_lengths_without_typical_values_have_regular_states(loops: int) -> None:
    """Lengths solved from equations of equal bars leave only states in line, which are singular."""
    a, d = parameters("a d")
    scene = four_bar_chain.scene(loops, lambda kind, _: a if kind == "crank" else d)
    mechanism = lower(scene, Builder())
    _, closed = mechanism.filters
    for k in range(loops):
        crank, coupler, rocker = mechanism.q[2 * k : 2 * k + 3]
        assert closed.is_zero((crank - rocker).sin())
        assert not closed.is_zero((crank - coupler).sin())


def test_a_singular_example_is_told_to_be_one() -> None:
    a, d = parameters("a d")
    scene = four_bar_chain.scene(1, lambda kind, _: a if kind == "crank" else d)
    with pytest.raises(SceneError, match=r"constraint x0: .* give an example of a state"):
        check_scene(replace(scene, example={}))


def test_an_angle_that_depends_has_its_half_and_its_third() -> None:
    """Inputs are drawn again until the distance and half of the angle are in the field."""
    for offset in range(10):
        b = Builder()
        q, t = b.input("q"), b.input("t")
        value = b.call("atan2", t, t * t + offset)
        filter_ = Residues(b, {q: value})
        nodes = [q.cos(), q.sin(), (q / 2).cos(), (q / 3).cos(), t / (t * t + offset)]
        c, s, half, third, slope = filter_.values(nodes)
        p = filter_.prime
        assert (c * c + s * s - 1) % p == 0
        assert (s - slope * c) % p == 0
        assert (2 * half * half - 1 - c) % p == 0
        assert (4 * pow(third, 3, p) - 3 * third - c) % p == 0
