"""Functions of a model for JAX are those of NumPy: compiled, mapped and differentiated."""

from typing import Any

import numpy as np
import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.program import Builder
from mechanics.program.interpret import interpret
from mechanics.program.jax_domain import jax_arrays
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import OPERATIONS
from systems import cartpole, four_bar

jax = pytest.importorskip("jax")
jax.config.update("jax_enable_x64", True)
EPS = np.finfo(float).eps


def near(found: Any, right: Any) -> bool:
    """Whether arrays differ by rounding alone."""
    found, right = np.asarray(found), np.asarray(right)
    scale = 1 + np.max(np.abs(right), initial=0)
    return (
        found.shape == right.shape and np.max(np.abs(found - right), initial=0) < 200 * EPS * scale
    )


@pytest.fixture(scope="module")
def model() -> mechanics.Model:
    return mechanics.compile(mechanics.derive(cartpole.scene(), "kane"))


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["forward_dynamics", "mass_matrix", "energy", "inverse_dynamics"])
def test_compiled_and_mapped_it_gives_what_numpy_gives(model: mechanics.Model, name: str) -> None:
    sizes = dict(model.program(name).inputs)
    draw = np.random.default_rng(1)
    arrays = {group: draw.uniform(0.5, 1.5, (7, size)) for group, size in sizes.items()}
    found = jax.jit(jax.vmap(model.jax[name]))(*arrays.values())
    right = model.evaluate(name, **arrays)
    assert found.keys() == right.keys()
    assert all(near(found[key], right[key]) for key in right)


@pytest.mark.campaign
def test_its_derivative_is_the_jacobian_of_casadi(model: mechanics.Model) -> None:
    q, u, f, p = [0.3, 0.7], [0.1, -0.4], [0.2], model.typical
    state = np.array(q)
    found = jax.jacobian(lambda q: model.jax["forward_dynamics"](q, np.array(u), f, p)["ud"])(state)
    jacobian = model.casadi["forward_dynamics"].jacobian()(q, u, f, p, 0, 0)[0]
    assert near(found, np.array(jacobian))
    energy = model.jax["energy"]
    slope = jax.grad(lambda u: energy(state, u, np.array(f), p)["kinetic"][0])(np.array(u))
    assert near(slope, model.mass_matrix(q, u, inputs=f) @ u)


@pytest.mark.campaign
def test_a_loop_has_its_multipliers() -> None:
    loop = mechanics.compile(mechanics.derive(four_bar.scene(), "kane"))
    draw = np.random.default_rng(1)
    sizes = loop.program("forward_dynamics").inputs
    arrays = [draw.uniform(0.5, 1.5, size) for _, size in sizes]
    found = loop.jax["forward_dynamics"](*arrays)
    right = loop.casadi["forward_dynamics"](*arrays)
    assert near(found["ud"], np.array(right[0])[:, 0])
    assert near(found["multipliers"], np.array(right[1])[:, 0])


@pytest.mark.sample(2)
@pytest.mark.parametrize("row", [row for row in OPERATIONS if row.arity and row.name != "entry"],
                         ids=lambda row: row.name)  # fmt: skip
def test_every_operation_of_the_table_is_what_numpy_has(row: Any) -> None:
    b = Builder()
    operands = [b.input(name) for name in "xyz"[: row.arity]]
    program = b.program({"f": [b.call(row.name, *operands)]})
    start = 1.25 if row.name == "acosh" else 0.25
    values = {name: np.array([start, start + 0.5]) for name in "xyz"}
    (found,) = interpret(program, jax_arrays(), values)["f"]
    (right,) = interpret(program, Arrays(), values)["f"]
    np.testing.assert_allclose(found, right, rtol=8 * EPS)


def test_a_wrong_call_is_named(model: mechanics.Model) -> None:
    function = model.jax["forward_dynamics"]
    with pytest.raises(InputError, match="it takes q, u, inputs, p: give each once"):
        function([0, 0])
    with pytest.raises(InputError, match=r"q has the shape \(3,\), \(2,\) expected"):
        function([0, 0, 0], [0, 0], [0], model.typical)
    with pytest.raises(KeyError):
        model.jax["nothing"]
