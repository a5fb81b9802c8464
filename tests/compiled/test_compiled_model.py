"""Models: arrays in, arrays out, the same numbers by machine code and by the virtual machine."""

import dataclasses

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from sympy import cos, symbols

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_model
from mechanics.compiled.machine.native import find_compiler
from mechanics.errors import CompilerError, InputError, ValueMissingError
from mechanics.scene import Parameter, Scene

SYSTEMS = ("elastic_pendulum", "rocker", "two_mass_chain", "rolling_disc", "four_bar")
ROUTES = ("free_body", "moving_point", "kane", "lagrange")


def states(model: Model, name: str, count: int) -> dict[str, np.ndarray]:
    random = np.random.default_rng(5)
    drawn = {g: random.uniform(0.3, 1.3, (count, n)) for g, n in model.program(name).inputs}
    # A step is short: a long one amplifies roundings.
    return drawn | ({"h": 0.01 * drawn["h"]} if "h" in drawn else {})


@pytest.fixture
def pendulum(modelled) -> Model:
    return modelled("elastic_pendulum", "free_body")


def test_forward_dynamics_by_hand(pendulum: Model) -> None:
    # Equations (6) and (7) of the seed, solved by Cramer's rule, at x = 0.1, theta = 2.5, at rest.
    c, s = np.cos(2.5), np.sin(2.5)
    f1, f2 = -2 * 10 * 0.1, -9.81 / 2 * s
    det = 2 * (1 / 3) - (c / 2) ** 2
    expected = [(f1 / 3 - c / 2 * f2) / det, (2 * f2 - c / 2 * f1) / det]
    assert_allclose(pendulum.forward_dynamics([0.1, 2.5], [0, 0]), expected, rtol=1e-14)


def test_energy_and_momenta_by_hand(pendulum: Model) -> None:
    q, u = [0.1, 0.5], [0.2, 0.3]
    c, s = np.cos(0.5), np.sin(0.5)
    vx, vy = 0.2 + 0.15 * c, 0.15 * s
    energy = pendulum.energy(q, u)
    assert energy["kinetic"] == pytest.approx(0.02 + (vx**2 + vy**2) / 2 + 0.3**2 / 24)
    assert energy["potential"] == pytest.approx(10 * 0.01 - 9.81 * c / 2)
    assert energy["total"] == pytest.approx(energy["kinetic"] + energy["potential"])
    momenta = pendulum.evaluate("momenta", q=q, u=u)
    assert_allclose(momenta["linear"], [0.2 + vx, vy, 0], rtol=1e-14)
    lever = (0.1 + s / 2) * vy + c / 2 * vx
    assert_allclose(momenta["angular"], [0, 0, lever + 0.3 / 12], rtol=1e-14)
    assert_allclose(momenta["generalized"], [0.2 + vx, 0.3 / 3 + 0.1 * c], rtol=1e-14)


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", ROUTES)
@pytest.mark.parametrize("system", SYSTEMS)
def test_laws_of_every_model(derived, system: str, route: str) -> None:
    model = compile_model(derived(system, route), compiler=None)
    given = states(model, "forward_dynamics", 16)
    solved = model.evaluate("forward_dynamics", **given)
    residual = model.residual(
        given["q"], given["u"], solved["ud"], solved["multipliers"],
        inputs=given["inputs"], p=given["p"],
    )  # fmt: skip
    assert_allclose(residual, 0, atol=1e-8)
    forces = model.evaluate("inverse_dynamics", ud=solved["ud"], **given)["forces"]
    assert_allclose(forces, 0, atol=1e-8)
    jacobian = model.evaluate("jacobians", **given)
    step = 1e-6
    for group in ("q", "u", "inputs", "p"):
        assert jacobian[f"ud_{group}"].shape == (
            16,
            len(model.quantities.ud),
            given[group].shape[1],
        )
        for k in range(given[group].shape[1]):
            shift = step * np.eye(given[group].shape[1])[k]
            ahead, behind = (
                model.evaluate("forward_dynamics", **(given | {group: given[group] + sign * shift}))
                for sign in (1, -1)
            )
            slope = (ahead["ud"] - behind["ud"]) / (2 * step)
            assert_allclose(jacobian[f"ud_{group}"][:, :, k], slope, rtol=1e-4, atol=1e-4)


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", SYSTEMS)
def test_routes_agree_in_numbers(modelled, system: str) -> None:
    models = [modelled(system, route) for route in ("free_body", "moving_point")]
    given = states(models[0], "forward_dynamics", 16)
    first, second = (model.evaluate("forward_dynamics", **given)["ud"] for model in models)
    assert_allclose(first, second, rtol=1e-9)


@pytest.mark.campaign
@pytest.mark.sample(1)
@pytest.mark.sample(0)
@pytest.mark.parametrize("system", SYSTEMS)
def test_virtual_machine_and_machine_code_agree(compiler, derived, modelled, system: str) -> None:
    native = modelled(system, "free_body")
    virtual = compile_model(derived(system, "free_body"), compiler=None)
    assert virtual.backend == "CasADi virtual machine (no C compiler)"
    assert compiler in native.backend
    for name in native.casadi:
        given = states(native, name, 8)
        for kind, rtol in ((np.float64, 1e-9), (np.float32, 2e-2)):
            fast, slow = (m.evaluate(name, kind, **given) for m in (native, virtual))
            for out, values in fast.items():
                assert values.dtype == slow[out].dtype == kind
                assert_allclose(values, slow[out], rtol=rtol, atol=rtol)


def test_one_state_is_a_batch_of_one_and_shared_arrays_are_repeated(pendulum: Model) -> None:
    given = states(pendulum, "mass_matrix", 5)
    batch = pendulum.evaluate("mass_matrix", **given)["mass_matrix"]
    assert batch.shape == (5, 2, 2)
    for k in range(5):
        one = pendulum.mass_matrix(given["q"][k], given["u"][k], p=given["p"][k])
        assert_array_equal(one, batch[k])
    shared = pendulum.mass_matrix(given["q"], given["u"][0], p=given["p"][0])
    assert_array_equal(shared[0], batch[0])
    assert pendulum.forward_dynamics(np.zeros((0, 2)), np.zeros((0, 2))).shape == (0, 2)


def test_parameters_by_name_over_typical_ones(pendulum: Model) -> None:
    assert_array_equal(pendulum.typical, [1, 1, 9.81, 10, 1])
    named = pendulum.mass_matrix([0, 0], [0, 0], p={"m": 4, "L": 3})
    assert_array_equal(named, [[5, 1.5], [1.5, 3]])


def test_typical_values_follow_from_definitions(modelled) -> None:
    model = modelled("rocker", "kane")
    names = [entry.name for entry in model.quantities.p]
    values = dict(zip(names, model.typical, strict=True))
    ratio = (9 * np.pi + 26) / (12 * (np.pi + 2))
    assert values["I_C"] == pytest.approx(ratio * values["M"] * values["R"] ** 2, rel=1e-15)


def test_units_follow_from_use(modelled) -> None:
    units = {
        entry.name: entry.unit
        for system in ("rocker", "rolling_disc")
        for group in ("q", "u", "ud", "inputs", "reactions")
        for entry in getattr(modelled(system, "free_body").quantities, group)
    }
    assert units["theta"] == "rad" and units["theta_dot"] == "rad/s"
    assert units["x"] == "m" and units["u2"] == "rad/s" and units["u4_dot"] == "m/s^2"
    assert units["f"] == "N" and units["N"] == "N"


def test_buffer_reads_and_writes_its_arrays(pendulum: Model, derived) -> None:
    virtual = compile_model(derived("elastic_pendulum", "free_body"), compiler=None)
    for model in (pendulum, virtual):
        for name in ("forward_dynamics", "jacobians"):
            buffer = model.buffer(name)
            for theta in (0.3, 0.7):
                buffer.inputs["p"][:] = model.typical
                buffer.inputs["q"][:] = 0.1, theta
                buffer.run()
                expected = model.evaluate(name, q=[0.1, theta], u=[0, 0])
                for out, values in expected.items():
                    assert_array_equal(buffer.outputs[out], values)


def test_wrong_arrays_are_named(pendulum: Model, modelled) -> None:
    with pytest.raises(InputError, match=r"q: shape \(2,\) or \(batch, 2\) expected, \(3,\) found"):
        pendulum.forward_dynamics([1, 2, 3], [0, 0])
    with pytest.raises(InputError, match="u is missing: pass 2 values: x_dot, theta_dot"):
        pendulum.forward_dynamics([1, 2], None)
    with pytest.raises(InputError, match="batches of different size: q 3, u 2"):
        pendulum.forward_dynamics(np.zeros((3, 2)), np.zeros((2, 2)))
    with pytest.raises(InputError, match="no real numbers"):
        pendulum.forward_dynamics(["a", "b"], [0, 0])
    with pytest.raises(InputError, match="no real numbers"):
        pendulum.forward_dynamics([1j, 0], [0, 0])
    with pytest.raises(InputError, match="there is no parameter K: the parameters are L, M, g"):
        pendulum.forward_dynamics([0, 0], [0, 0], p={"K": 1})
    with pytest.raises(InputError, match="there is no input ud"):
        pendulum.evaluate("energy", q=[0, 0], u=[0, 0], ud=[0, 0])
    with pytest.raises(InputError, match="function 'speed': the model of"):
        pendulum.evaluate("speed", q=[0, 0], u=[0, 0])
    with pytest.raises(InputError, match="inputs is missing: pass 1 value: f"):
        modelled("rocker", "kane").forward_dynamics([0.1], [0])


def test_a_parameter_without_a_value_is_named(derived) -> None:
    equations = derived("two_mass_chain", "kane")
    scene: Scene = equations.scene
    bare = Parameter("c", positive=True)
    definitions = {scene.parameters[0]: 2 * bare}
    changed = dataclasses.replace(scene, definitions=definitions)
    model = compile_model(dataclasses.replace(equations, scene=changed))
    with pytest.raises(ValueMissingError, match="parameter c: a number is needed"):
        model.forward_dynamics([0, 0], [0, 0])
    assert model.forward_dynamics([0, 0], [0, 0], p=[1.0, 1.0]).shape == (2,)


def test_a_broken_compiler_is_an_error_and_none_is_not(derived, monkeypatch) -> None:
    equations = derived("two_mass_chain", "kane")
    broken = compile_model(equations, compiler="false")
    with pytest.raises(CompilerError, match="refused the generated code"):
        broken.forward_dynamics([0, 0], [0, 0])
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    assert find_compiler() is None
    model = compile_model(equations)
    assert "virtual machine" in model.backend
    assert model.forward_dynamics([0.1, 0], [0, 0]).shape == (2,)


def test_reactions_by_hand(pendulum: Model) -> None:
    # At rest at theta = 0 and x = 0 the pivot carries the pendulum, the rod carries both.
    found = pendulum.evaluate("reactions", q=[0, 0], u=[0, 0])["reactions"]
    named = dict(zip([e.name for e in pendulum.quantities.reactions], found, strict=True))
    assert named == pytest.approx({"N": 9.81, "T": 0, "N1": 2 * 9.81})


def test_mass_matrix_is_that_of_the_seed(pendulum: Model) -> None:
    L, M, m, theta = symbols("L M m theta")
    rows = [[M + m, M * L / 2 * cos(theta)], [M * L / 2 * cos(theta), M * L**2 / 3]]
    values = {L: 2, M: 3, m: 5, theta: 0.7}
    expected = [[float(entry.subs(values)) for entry in row] for row in rows]
    p = {"L": 2, "M": 3, "m": 5}
    assert_allclose(pendulum.mass_matrix([0, 0.7], [0, 0], p=p), expected, rtol=1e-15)
