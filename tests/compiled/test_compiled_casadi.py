"""CasADi users get functions like any other: named, differentiable, mapped, serialised, in Opti.

The laws hold for every function of every system.
"""

import subprocess
from collections.abc import Callable
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from shared_scenes import WITH_FRICTION

from mechanics.compiled import Model
from mechanics.compiled.graphs import STATE
from systems import ALL

SYSTEMS = [system.name for system in ALL]
SMOOTH = [system.name for system in ALL if system.name not in WITH_FRICTION]
Modelled = Callable[[str, str], Model]
POINTS = 3


@pytest.fixture(params=SYSTEMS)
def model(request: pytest.FixtureRequest, modelled: Modelled) -> Model:
    return modelled(request.param, "free_body")


def points(model: Model, function: ca.Function) -> list[np.ndarray]:
    """States of ordinary size, one column a point, for every input of a function."""
    random = np.random.default_rng(5)
    found = []
    for i in range(function.n_in()):
        name, size = function.name_in(i), function.numel_in(i)
        near = random.uniform(-0.7, 0.7, size=(size, POINTS))
        if name == "p":
            near = model.typical[:, None] * (1 + 0.3 * near)
        found.append(1e-2 * np.abs(near) if name == "h" else near)
    return found


def at(columns: list[np.ndarray], i: int) -> list[np.ndarray]:
    return [group[:, i] for group in columns]


def assert_close(one: object, other: object, rtol: float = 1e-9) -> None:
    one, other = np.array(one, dtype=float), np.array(other, dtype=float)
    scale = float(np.max(np.abs(other), initial=0.0)) + 1e-9
    np.testing.assert_allclose(one, other, rtol=0, atol=rtol * scale)


@pytest.mark.sample(2)
def test_names_are_kept(model: Model) -> None:
    assert next(iter(model.casadi)) == "forward_dynamics"
    for name, function in model.casadi.items():
        assert function.name() == name
        inputs, outputs = function.name_in(), function.name_out()
        assert tuple(inputs[:4]) == STATE
        assert len({*inputs, *outputs}) == len(inputs) + len(outputs)
        sizes = {group: len(entries) for group, entries in model.entries.items()}
        for group in inputs:
            assert function.size_in(group) == (sizes[group], 1)
        named = function(**dict(zip(inputs, at(points(model, function), 0), strict=True)))
        assert set(named) == set(outputs)


@pytest.mark.sample(2)
def test_functions_are_differentiable(model: Model) -> None:
    """J by `factory`, forward and reverse directions, and differences of the values: one thing."""
    for function in model.casadi.values():
        point = at(points(model, function), 0)
        inputs = [ca.MX.sym(f"x{i}", function.size_in(i)) for i in range(function.n_in())]
        value = ca.vertcat(*(ca.vec(out) for out in function.call(inputs)))
        stacked = ca.vertcat(*inputs)
        seed, weight = ca.MX.sym("s", stacked.numel()), ca.MX.sym("w", value.numel())
        every = ca.Function(
            "every", [*inputs, seed, weight],
            [value, ca.jacobian(value, stacked), ca.jtimes(value, stacked, seed),
             ca.jtimes(value, stacked, weight, True)],
        )  # fmt: skip
        random = np.random.default_rng(11)
        d, w = random.normal(size=stacked.numel()), random.normal(size=value.numel())
        here, slope, along, back = every(*point, d, w)
        assert_close(along, slope @ d)
        assert_close(back, slope.T @ w)
        flat, h = np.concatenate(point), 1e-6
        sides = []
        for sign in (1, -1):
            moved = np.split(flat + sign * h * d, np.cumsum([len(g) for g in point])[:-1])
            sides.append(np.array(every(*moved, d, w)[0]))
        difference = (sides[0] - sides[1]) / (2 * h)
        # Rounding of the values, over the step, and its square.
        noise = 1e-15 * float(np.max(np.abs(np.array(here)), initial=0.0)) / h
        size = float(np.max(np.abs(np.array(along)), initial=0.0)) + 1.0
        assert np.max(np.abs(difference - np.array(along)), initial=0.0) <= 1e-5 * size + 9 * noise


@pytest.mark.sample(2)
def test_second_derivatives_exist(model: Model) -> None:
    """What Newton's method in an optimiser needs: a symmetric Hessian of the accelerations, by
    parameters too, in which even a linear oscillator is not linear.
    """
    function = model.casadi["forward_dynamics"]
    point = at(points(model, function), 0)
    inputs = [ca.MX.sym(f"x{i}", function.size_in(i)) for i in range(4)]
    total = ca.sum1(function.call(inputs)[0])
    hessian, _ = ca.hessian(total, ca.vertcat(*inputs))
    found = np.array(ca.Function("hessian", inputs, [hessian])(*point))
    assert np.all(np.isfinite(found)) and np.any(found != 0)
    assert_close(found, found.T)


@pytest.mark.sample(2)
def test_functions_map(model: Model) -> None:
    for function in model.casadi.values():
        columns = points(model, function)
        mapped = function.map(POINTS)(*columns)
        mapped = mapped if isinstance(mapped, tuple) else (mapped,)
        for i in range(POINTS):
            single = function.call(at(columns, i))
            for many, one in zip(mapped, single, strict=True):
                width = one.shape[1]
                assert_close(many[:, i * width : (i + 1) * width], one, rtol=1e-14)


@pytest.mark.sample(2)
def test_functions_survive_serialisation(model: Model, tmp_path: Path) -> None:
    for name, function in model.casadi.items():
        point = at(points(model, function), 1)
        function.save(str(tmp_path / f"{name}.casadi"))
        copies = (
            ca.Function.deserialize(function.serialize()),
            ca.Function.load(str(tmp_path / f"{name}.casadi")),
        )
        for copy in copies:
            assert copy.name() == name and copy.name_in() == function.name_in()
            assert copy.name_out() == function.name_out()
            for one, other in zip(copy.call(point), function.call(point), strict=True):
                np.testing.assert_array_equal(np.array(one), np.array(other))


@pytest.mark.sample(2)
@pytest.mark.parametrize("model", SMOOTH, indirect=True)
def test_functions_stand_in_opti(model: Model) -> None:
    """Find the inverse dynamics by IPOPT: u' is given, the generalized forces are wanted."""
    inverse = model.casadi["inverse_dynamics"]
    q, u, inputs, p, ud = at(points(model, inverse), 0)
    opti = ca.Opti()
    sought = opti.variable(len(ud))
    forces = np.array(inverse(q, u, inputs, p, ud))
    opti.minimize(ca.sumsqr(sought - ud))
    opti.subject_to(inverse(q, u, inputs, p, sought) == forces)
    opti.set_initial(sought, np.zeros(len(ud)))
    opti.solver("ipopt", {"print_time": False, "ipopt.print_level": 0, "ipopt.sb": "yes"})
    np.testing.assert_allclose(np.atleast_1d(opti.solve().value(sought)), ud, rtol=1e-6, atol=1e-6)


def test_generated_c_comes_back_as_an_external_function(
    modelled: Modelled, compiler: str, tmp_path: Path
) -> None:
    """CasADi's own C of our graph, compiled with its derivative and loaded again."""
    function = modelled("pendulum_chain", "free_body").casadi["forward_dynamics"]
    generator = ca.CodeGenerator("dynamics.c")
    generator.add(function)
    generator.add(function.forward(1))
    file = generator.generate(f"{tmp_path}/")
    library = tmp_path / "dynamics.so"
    subprocess.run(
        [compiler, "-O1", "-fPIC", "-shared", file, "-o", str(library), "-lm"], check=True
    )
    loaded = ca.external("forward_dynamics", str(library))
    point = at(points(modelled("pendulum_chain", "free_body"), function), 0)
    for one, other in zip(loaded.call(point), function.call(point), strict=True):
        assert_close(one, other, rtol=1e-12)
    assert loaded.name_in() == function.name_in()
    x = ca.MX.sym("q", 4)
    slope = ca.Function("slope", [x], [ca.jacobian(loaded(x, *point[1:])[0], x)])
    own = ca.Function("own", [x], [ca.jacobian(function(x, *point[1:])[0], x)])
    assert_close(slope(point[0]), own(point[0]), rtol=1e-9)
