"""Outputs of a scene and their Jacobians: against SymPy's own geometry, and against Kane's forces.

J u + v_0 = dr/ds of r(q + s q', w + s w', t + s)        by a complex step, from positions alone
J^T F     = what a force F at the point adds to the right side of Kane's rows
"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy
from linkages import slider_crank
from sympy import Expr, Matrix, lambdify, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

import mechanics
from mechanics.compiled import Model
from mechanics.compiled.programs.of_model import PARTS
from mechanics.compiled.proof import prove_compiled
from mechanics.compiled.translation_validation.derived import GROUPS
from mechanics.compiled.translation_validation.laws import LAWS
from mechanics.errors import InputError, SceneError
from mechanics.scene import (
    RigidBody,
    Scene,
    force,
    gravity,
    orientation,
    parameters,
    pin,
    position,
    quaternion,
    reaction,
    velocity,
)
from mechanics.scene.namespace import RESERVED

t = dynamicsymbols._t
a, b, s, fx, fy, fz = dynamicsymbols("a b s fx fy fz")
g, L, m, A, B, C, h, Omega = parameters(
    "g L m A B C h Omega", typical="9.81 1/2 2 1/10 1/5 1/4 1/3 3/2"
)
VALUES: Mapping[Expr, float] = {e: float(e.typical) for e in (g, L, m, A, B, C, h, Omega)}


def arm() -> Scene:
    """Two hinges in space, on a base that is moved by hand; h is of the outputs alone."""
    N, O = ReferenceFrame("N"), Point("O")
    base = O.locatenew("base", s * N.x)
    one = pin("one", None, "upper", at=base, axis=N.z, angle=a)
    two = pin("two", "upper", "lower", at=one.point.locatenew("E", L * one.frame.x),
              axis=one.frame.y, angle=b)  # fmt: skip
    F, G = one.frame, two.frame
    tip = two.point.locatenew("T", L * G.x + h * G.z)
    bodies = (
        RigidBody("upper", base.locatenew("C1", L / 2 * F.x), F, m, inertia(F, A, B, C)),
        RigidBody("lower", two.point.locatenew("C2", L * G.x), G, m, inertia(G, C, B, A)),
    )
    outputs = {
        "tool": position(tip), "tool_own": position(tip, in_=G), "camera": orientation(G),
        "wrist": orientation(G, in_=F), "slip": velocity(tip, along=F.y),
        "moving": velocity(tip, in_=G), "carried": velocity(tip, on="upper"),
    }  # fmt: skip
    return Scene("arm", N, O, bodies=bodies, joints=(one, two), loads=(gravity(-g * N.z),),
                 inputs=(s,), outputs=outputs)  # fmt: skip


def table() -> Scene:
    """A rod on a table that turns by itself; nothing but time and one angle moves it."""
    N, O = ReferenceFrame("N"), Point("O")
    T = N.orientnew("T", "Axis", (Omega * t, N.z))
    joint = pin("J", None, "rod", at=O.locatenew("P", L * T.x), axis=T.x + T.y, angle=a)
    F = joint.frame
    rod = RigidBody("rod", joint.point.locatenew("C", L * F.z), F, m, inertia(F, A, B, C))
    outputs = {"tool": position(rod.centre), "camera": orientation(F),
               "slip": velocity(rod.centre, along=T.x)}  # fmt: skip
    return Scene("table", N, O, bodies=(rod,), joints=(joint,), loads=(gravity(-g * N.z),),
                 outputs=outputs)  # fmt: skip


def top() -> Scene:
    """A body in a ball joint, turned by a quaternion."""
    N, O = ReferenceFrame("N"), Point("O")
    turning = quaternion("e0 e1 e2 e3", "wx wy wz")
    F = turning.orient("F", N)
    body = RigidBody("top", O.locatenew("C", L * F.z), F, m, inertia(F, B, B, C))
    forces = [reaction(f"R{k}", O, "top", None, along) for k, along in enumerate((N.x, N.y, N.z))]
    tip = body.centre.locatenew("T", h * F.x)
    outputs = {"tool": position(tip), "camera": orientation(F), "slip": velocity(tip, along=F.y)}
    return Scene("top", N, O, bodies=(body,), reactions=tuple(forces), rotations=(turning,),
                 loads=(gravity(-g * N.z),), outputs=outputs)  # fmt: skip


SCENES: Mapping[str, Callable[[], Scene]] = {"arm": arm, "table": table, "top": top}


@pytest.fixture(
    scope="module",
    params=["arm", *(pytest.param(name, marks=pytest.mark.campaign) for name in ("table", "top"))],
)
def model(request: pytest.FixtureRequest) -> Model:
    return mechanics.compile(mechanics.derive(SCENES[request.param](), "kane"), compiler=None)


def state(model: Model) -> dict[str, Any]:
    """A state that is nothing special."""
    known, random = model.quantities, np.random.default_rng(5)
    groups = {n: random.uniform(-1, 1, len(getattr(known, n))) for n in ("q", "u", "inputs")}
    names = {symbol.name: value for symbol, value in VALUES.items()}
    return {**groups, "p": [names[entry.name] for entry in known.p]}


def along_the_motion(model: Model, at: Mapping[str, Any]) -> Callable[[Expr], np.ndarray]:
    """Value and rate of an expression of the user's, by a complex step of 1e-30 s."""
    scene, known = model.equations.scene, model.quantities
    inputs = dict(zip((e.name for e in known.inputs), at["inputs"], strict=True))
    now = dict(zip(scene.coordinates, at["q"], strict=True)) | {t: inputs.get("t", 0.0)}
    now |= {f: inputs[f.name] for f in scene.inputs}
    rates = dict(zip(scene.coordinates, model.coordinate_rates(**at), strict=True)) | {t: 1.0}
    rates |= {f: inputs[f"{f.name}_dot"] for f in scene.inputs}

    @cache
    def found(entries: tuple[Expr, ...]) -> np.ndarray:
        # Functions of time first: they hold the time.
        order = sorted(now, key=lambda f: f == t)
        stand = [sympy.Dummy() for _ in order]
        plain = Matrix(entries).xreplace(dict(zip(order[:-1], stand[:-1], strict=True)))
        plain = plain.xreplace({t: stand[-1]})
        code = lambdify([*stand, *VALUES], list(plain), "mpmath")
        step = mpmath.mpc(0, "1e-30")
        moved = [mpmath.mpf(now[f]) + step * mpmath.mpf(rates[f]) for f in order]
        values = [mpmath.mpc(v) for v in code(*moved, *map(mpmath.mpf, VALUES.values()))]
        return np.array([[float(v.real), float(v.imag * mpmath.mpf("1e30"))] for v in values]).T

    return lambda matrix: found(tuple(matrix))


def assert_close(found: Any, wanted: Any) -> None:
    np.testing.assert_allclose(np.asarray(found, dtype=float), wanted, rtol=1e-12, atol=1e-13)


def test_the_jacobian_times_u_is_the_velocity_of_exact_positions(model: Model) -> None:
    scene, at = model.equations.scene, state(model)
    still = {**at, "u": 0 * at["u"]}
    motion = along_the_motion(model, at)
    for name, output in scene.outputs.items():
        value, slope = model.output(name, **at), model.output(f"{name}_jacobian", **at)
        frame = getattr(output, "in_", None) or scene.frame
        if hasattr(output, "frame"):
            turned = frame.dcm(output.frame)
            assert_close(value, motion(turned)[0].reshape(3, 3))
            R, rate = (k.reshape(3, 3) for k in motion(scene.frame.dcm(output.frame)))
            spin = rate @ R.T
            basis = motion(scene.frame.dcm(frame))[0].reshape(3, 3)
            omega = basis.T @ [spin[2, 1], spin[0, 2], spin[1, 0]]
            # What turns at u = 0 is given by time: of these scenes the table alone.
            drift = [0, 0, float(Omega.typical)] if scene.name == "table" else np.zeros(3)
            assert_close(slope @ at["u"] + basis.T @ drift, omega)
            continue
        r, v = motion(output.point.pos_from(scene.origin).to_matrix(scene.frame))
        basis = motion(scene.frame.dcm(frame))[0].reshape(3, 3)
        if name.startswith("tool"):
            assert_close(value, basis.T @ r)
            rest = along_the_motion(model, still)
            _, drift = rest(output.point.pos_from(scene.origin).to_matrix(scene.frame))
            assert_close(slope @ at["u"] + basis.T @ drift, basis.T @ v)
        elif output.on is None:
            wanted = basis.T @ v
            if output.along is not None:
                direction = motion(output.along.to_matrix(scene.frame))[0]
                wanted = direction @ v
            assert_close(value, wanted)
            assert_close(slope @ at["u"] + model.output(name, **still), value)


@pytest.mark.campaign
def test_a_point_that_a_body_carries_moves_with_it() -> None:
    """The tip is a point of the lower body, so there both velocities are one."""
    scene = arm()
    own = scene.outputs["moving"]
    outputs = {"own": own, "same": velocity(own.point, on="lower", in_=own.in_)}
    model = mechanics.compile(mechanics.derive(replace(scene, outputs=outputs), "kane"))
    at = state(model)
    assert_close(model.own(**at), model.same(**at))
    assert_close(model.own_jacobian(**at), model.same_jacobian(**at))


@pytest.mark.parametrize("route", ["kane", pytest.param("lagrange", marks=pytest.mark.campaign)])
def test_the_transposed_jacobian_gives_the_generalized_force(route: str) -> None:
    scene = arm()
    tip, N = scene.outputs["tool"].point, scene.frame
    push = force("push", tip, fx * N.x + fy * N.y + fz * N.z, on="lower")
    pushed = replace(scene, loads=(*scene.loads, push), inputs=(s, fx, fy, fz))
    model = mechanics.compile(mechanics.derive(pushed, route), compiler=None)
    at = state(model)
    names = [entry.name for entry in model.quantities.inputs]
    F = np.array([at["inputs"][names.index(name)] for name in ("fx", "fy", "fz")])
    free = at["inputs"].copy()
    free[[names.index(name) for name in ("fx", "fy", "fz")]] = 0
    gain = model.forcing(**at) - model.forcing(**{**at, "inputs": free})
    assert_close(model.tool_jacobian(at["q"], p=at["p"], inputs=at["inputs"]).T @ F, gain)


def test_what_is_compiled_is_proved(model: Model) -> None:
    wanted = [n for name in model.equations.scene.outputs for n in (name, f"{name}_jacobian")]
    assert set(wanted) < set(model.casadi)
    findings = prove_compiled(model, wanted)
    assert len(findings) == len(wanted)
    assert all(finding.shown for finding in findings), [f for f in findings if not f.shown]


def test_states_in_batches_and_velocities_along_a_direction() -> None:
    model = mechanics.compile(mechanics.derive(arm(), "kane"))
    at = state(model)
    q = np.array([at["q"], 2 * at["q"]])
    rest = {"p": at["p"], "inputs": at["inputs"]}
    assert model.camera(q, **rest).shape == (2, 3, 3)
    assert model.tool_jacobian(q, **rest).shape == (2, 3, 2)
    assert np.shape(model.slip(at["q"], at["u"], **rest)) == ()
    assert model.slip_jacobian(q, **rest).shape == (2, 2)
    assert_close(model.tool(q, **rest)[0], model.tool(at["q"], **rest))
    with pytest.raises(InputError, match=r"u is missing: pass 2 values"):
        model.slip(at["q"], **rest)
    with pytest.raises(AttributeError, match=r"the model of 'arm' has no tol: its functions are"):
        model.tol(at["q"])


def test_a_motion_has_columns_of_outputs() -> None:
    model = mechanics.compile(mechanics.derive(table(), "kane"), compiler=None)
    motion = mechanics.simulate(model, 0.1, samples=3)
    at = {"q": motion.coordinates["a"][:, None], "u": motion.speeds["a_dot"][:, None],
          "inputs": motion.times[:, None]}  # fmt: skip
    found = np.array([motion.columns[f"tool_{axis}"] for axis in "xyz"]).T
    assert_close(model.tool(**at), found)
    assert_close(model.camera(**at)[:, 0, 1], motion.columns["camera_xy"])
    assert_close(model.slip(**at), motion.columns["slip"])
    assert [motion.units[name] for name in ("tool_x", "camera_xy", "slip")] == ["m", "1", "m/s"]


@pytest.mark.campaign
def test_a_loop_has_the_jacobian_of_all_speeds() -> None:
    scene = slider_crank("slider")
    outputs = {"end": position(scene.bodies[-1].centre), "rod": orientation(scene.bodies[0].frame)}
    model = mechanics.compile(mechanics.derive(replace(scene, outputs=outputs), "kane"),
                              compiler=None)  # fmt: skip
    assert all(f.shown for f in prove_compiled(model, ["end", "end_jacobian"]))
    assert model.end_jacobian(np.zeros(len(model.quantities.q))).shape == (3, len(scene.u))


def test_names_that_every_model_has_are_reserved() -> None:
    model = mechanics.compile(mechanics.derive(replace(table(), outputs={}), "kane"))
    names = {*(n for n in dir(model) if not n.startswith("_")), *model.casadi, *PARTS, *LAWS}
    names |= {output for name in model.casadi for output, _ in model.program(name).shapes}
    names |= {*GROUPS, "c", "constants", "t"}
    names |= {f"{kind}_energy" for kind in ("kinetic", "potential", "total")}
    assert names == RESERVED


REFUSED: Mapping[str, tuple[Callable[[Any], Any], str]] = {
    "a function": (lambda P: {"energy": position(P)}, "output energy: there is energy already"),
    "a jacobian": (lambda P: {"x": position(P), "x_jacobian": position(P)},
                   "output x_jacobian: there is x_jacobian already, of another output"),
    "an entry": (lambda P: {"tip_x": velocity(P), "tip": position(P)}, "there is tip_x already"),
    "a coordinate": (lambda P: {"a": position(P)}, "a coordinate or an input"),
    "a rate": (lambda P: {"a_dot": position(P)}, "a derivative of a"),
    "a parameter": (lambda P: {"L": position(P)}, "there is L already, a parameter"),
    "a reaction": (lambda P: {"one_x": position(P)}, "there is one_x already, a reaction"),
    "no identifier": (lambda P: {"tool tip": position(P)}, "cannot be the name of a function"),
    "a keyword": (lambda P: {"lambda": position(P)}, "cannot be the name of a function"),
    "single precision": (lambda P: {"single_tool": position(P)}, "cannot be the name"),
    "no output": (lambda P: {"tool": P}, "output tool is T, a Point: it has to be a Position"),
    "no body": (lambda P: {"tool": velocity(P, on="hand")}, "output tool: arm: there is no body"),
    "nowhere": (lambda P: {"tool": position(Point("Q"))}, "output tool: point Q: it is not placed"),
    "no unit": (lambda P: {"tool": velocity(P, along=2 * ReferenceFrame("Q").x)}, "output tool"),
}  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize(("make", "words"), REFUSED.values(), ids=REFUSED)
def test_outputs_that_cannot_be_are_refused(make: Callable[[Any], Any], words: str) -> None:
    scene = arm()
    with pytest.raises(SceneError) as caught:
        replace(scene, outputs=make(scene.outputs["tool"].point))
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_point_of_an_output_is_placed_by_lengths() -> None:
    scene, (k, _) = arm(), parameters("k c", units="N/m N*s/m")
    point = scene.outputs["tool"].point.locatenew("K", k * scene.frame.x)
    with pytest.raises(SceneError, match=r"point K: k has the unit .*, not m: correct"):
        replace(scene, outputs={"tool": position(point)})


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: position("P"), "position: point is 'P'"),
        (lambda: orientation(Point("P")), "orientation: frame is P"),
        (lambda: velocity(Point("P"), along="x"), "velocity: along is 'x'"),
        (lambda: velocity(Point("P"), along=ReferenceFrame("N").x, in_=ReferenceFrame("N")),
         "leave one out"),
        (lambda: position(Point("P"), in_=pi), "position: in_ is pi"),
    ],
)  # fmt: skip
def test_what_is_no_output_is_refused(make: Callable[[], Any], words: str) -> None:
    with pytest.raises(SceneError) as caught:
        make()
    assert words in str(caught.value)
