"""`compile(..., fixed=, outputs=)`: exact values, refusals, and nothing that was not asked for."""

from collections import Counter
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import casadi as ca
import numpy as np
import pytest
from sympy import Rational, pi

from mechanics.compiled import Model, compile, outputs, prove_compiled
from mechanics.compiled.fixed import read_fixed
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.routes import textbook as written
from mechanics.simulate import simulate
from systems import elastic_pendulum, rocker

ONLY = ("forward_dynamics",)


@pytest.mark.parametrize(
    "value", [9.81, "9.81", "981/100", Decimal("9.81"), Fraction(981, 100), Rational(981, 100),
              np.float64(9.81), "9.81e0"],
    ids=repr,
)  # fmt: skip
def test_a_value_is_the_decimal_that_was_typed(value: Any) -> None:
    scene = elastic_pendulum.scene()
    assert list(read_fixed(scene, {"g": value}).values()) == [Rational(981, 100)]


BAD = [
    ({"z": 1}, r"'z': pendulum on elastic support has no such parameter: .* L, M, g, k, m$"),
    ({"I_C": 1}, r"--fix \(fixed=\) 'I_C': .* no such parameter"),
    ([("g", 1)], r"--fix \(fixed=\): .* found: write a mapping such as \{'g': 9.81\}"),
    ({"x": 1}, r"--fix \(fixed=\) 'x': .* no such parameter"),
    ({"g": "heavy"}, r"--fix \(fixed=\) g: 'heavy' is no number: write 9.81 or 1/3"),
    ({"g": None}, r"--fix \(fixed=\) g: None is no number"),
    ({"g": True}, r"--fix \(fixed=\) g: True is no number"),
    ({"g": float("nan")}, r"--fix \(fixed=\) g: nan is no number"),
    ({"g": float("inf")}, r"--fix \(fixed=\) g: inf is no number"),
    ({"g": "1/0"}, r"--fix \(fixed=\) g: '1/0' is no number"),
    ({"g": 1j}, r"--fix \(fixed=\) g: 1j is no number"),
    ({"g": [1]}, r"--fix \(fixed=\) g: \[1\] is no number"),
    ({"M": -1}, r"--fix \(fixed=\) M: -1 is negative: the parameter is declared positive"),
    ({"g": "1e400"}, r"--fix \(fixed=\) g: 1e400 is beyond 1.8e308"),
    ({"g": "1e-400"}, r"--fix \(fixed=\) g: 1e-400 is below the smallest double"),
    ({"g": "1e99999999"}, "g: 1e99999999: doubles lie between 1e-308 and 1.8e308"),
    ({"g": "1e-99999999"}, r"--fix \(fixed=\) g: 1e-99999999: doubles lie between"),
]


@pytest.mark.parametrize(("fixed", "message"), BAD, ids=[str(fixed) for fixed, _ in BAD])
def test_bad_values_are_refused_with_one_line(derived: Any, fixed: Any, message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        compile(derived("elastic_pendulum", "kane"), fixed=fixed)
    assert "\n" not in str(caught.value)


def test_a_divisor_that_is_fixed_to_zero_is_refused() -> None:
    equations = derive(elastic_pendulum.scene())
    length = next(symbol for symbol in equations.scene.parameters if symbol.name == "L")
    divided = equations.forcing / length
    broken = equations.with_matrices(forcing=divided)
    with pytest.raises(InputError, match=r"with L = 0.* fixed, .* is divided by zero") as bad:
        compile(broken, fixed={"L": 0})
    assert "\n" not in str(bad.value)


def test_what_is_defined_by_fixed_parameters_is_fixed() -> None:
    equations = derive(rocker.scene(), "kane")
    model = compile(equations, fixed={"rho": 2700, "h": 0.02, "R": 0.1}, outputs=ONLY)
    assert model.entries["p"] == ("g",)
    # The area is (2 + pi) R^2.
    assert model.fixed["M"] == Rational(27, 50) * (2 + pi)
    assert {"M", "I_C", "R"} <= set(model.fixed)
    with pytest.raises(InputError, match="no such parameter"):
        compile(equations, fixed={"m_1": 1})
    (finding,) = prove_compiled(model)
    assert finding.shown, finding
    free = compile(equations, outputs=ONLY)
    values = {name: float(value.evalf()) for name, value in model.fixed.items()}
    p = {name: values.get(name, 9.81) for name in free.entries["p"]}
    state = {"q": [0.4], "u": [0.3], "inputs": [2.0]}
    one, two = (m.evaluate("forward_dynamics", p=v, **state)["ud"]
                for m, v in ((free, p), (model, [9.81])))  # fmt: skip
    np.testing.assert_allclose(one, two, rtol=1e-14)


def test_a_given_value_overrules_a_definition() -> None:
    equations = derive(rocker.scene(), "kane")
    model = compile(equations, fixed={"rho": 1, "h": 1, "R": 1, "M": 5}, outputs=ONLY)
    assert model.fixed["M"] == 5
    assert model.fixed["I_C"].has(pi)


def test_typical_values_follow_what_is_fixed() -> None:
    free = compile(derive(rocker.scene(), "kane"))
    half = compile(derive(rocker.scene(), "kane"), fixed={"rho": 1350})
    assert free.entries["p"] == half.entries["p"]
    ratio = dict(zip(free.entries["p"], half.typical / free.typical, strict=True))
    assert ratio == pytest.approx({"I_C": 0.5, "M": 0.5, "R": 1, "g": 1})


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiler", ["auto", None])
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_every_backend_holds_the_fixed_model(derived: Any, compiler: Any, kind: Any) -> None:
    equations = derived("elastic_pendulum", "kane")
    model = compile(equations, compiler=compiler, fixed={"M": 1, "m": 1, "L": 1, "k": 10, "g": 10})
    found = model.evaluate("forward_dynamics", kind, q=[0.0, 0.0], u=[0.0, 1.0])["ud"]
    assert found.dtype == kind
    # At rest below the pivot nothing pulls sideways.
    assert found.tolist() == [0.0, 0.0]


def test_outputs_are_all_there_is(derived: Any) -> None:
    model = compile(
        derived("elastic_pendulum", "free_body"), outputs=("forward_dynamics", "energy")
    )
    assert list(model.casadi) == ["forward_dynamics", "energy"]
    assert len(model.casadi) == 2
    with pytest.raises(InputError, match=r"'momenta': .* forward_dynamics, energy, which"):
        model.evaluate("momenta", q=[0, 0], u=[0, 0])
    assert model.energy([0, 0], [1, 0]).keys() == {"kinetic", "potential", "total"}
    assert {f.subject for f in prove_compiled(model)} == {
        "compiled forward dynamics = derived, free_body", "compiled energy = derived, free_body"
    }  # fmt: skip


@pytest.mark.parametrize("outputs", [("speed",), "speed", ("energy", "speed")], ids=str)
def test_an_unknown_output_is_named(derived: Any, outputs: Any) -> None:
    with pytest.raises(InputError, match=r"'speed': the model of .* has forward_dynamics,"):
        compile(derived("rocker", "kane"), outputs=outputs)


def test_no_output_is_refused(derived: Any) -> None:
    with pytest.raises(InputError, match="outputs: none asked for"):
        compile(derived("rocker", "kane"), outputs=())


Spy = Callable[[Any, str], None]


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> tuple[Counter, Spy]:
    """Counts calls of functions, which work on as before."""
    counts: Counter = Counter()

    def watch(module: Any, name: str) -> None:
        own = getattr(module, name)

        def counting(*args: Any, **kwargs: Any) -> Any:
            counts[name] += 1
            return own(*args, **kwargs)

        monkeypatch.setattr(module, name, counting)

    return counts, watch


def watched(calls: tuple[Counter, Spy], route: str) -> tuple[Counter, Any]:
    """Equations, and everything watched that may be left undone when they are compiled."""
    equations = derive(elastic_pendulum.scene(), route)
    counts, watch = calls
    watch(outputs, "momenta")
    watch(outputs, "energies")
    watch(ca, "jacobian")
    watch(written, "_matrices")
    watch(written, "_reactions")
    return counts, equations


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", ["free_body", "moving_point", "kane", "lagrange"])
def test_what_is_not_asked_for_is_not_derived(calls: Any, route: str) -> None:
    counts, equations = watched(calls, route)
    model = compile(equations, fixed={"g": 9.81}, outputs=ONLY)
    assert np.isfinite(model.forward_dynamics([0.1, 0.2], [0, 0])).all()
    assert model.program("forward_dynamics").operations > 0
    assert not counts


def test_what_is_asked_for_is_derived_once(calls: Any) -> None:
    counts, equations = watched(calls, "free_body")
    model = compile(equations)
    state = {"q": [0.1, 0.2], "u": [0.3, 0.4]}
    for _ in range(2):
        model.evaluate("reactions", **state)
        model.evaluate("energy", **state)
        model.evaluate("momenta", **state)
        model.evaluate("jacobians", **state)
    assert counts["momenta"] == 1
    assert not counts["_matrices"] and not counts["_reactions"]
    assert counts["jacobian"] > 0


def test_a_value_for_a_fixed_parameter_is_refused(derived: Any) -> None:
    model = compile(derived("elastic_pendulum", "kane"), fixed={"g": 9.81})
    with pytest.raises(InputError, match=r"no parameter g: .* L, M, k, m, and fixed: g = 981/100"):
        model.forward_dynamics([0, 0], [0, 0], p={"g": 1})


def test_a_restricted_model_knows_no_reactions(derived: Any) -> None:
    model: Model = compile(derived("elastic_pendulum", "free_body"), outputs=ONLY)
    assert model.quantities.reactions == ()
    assert compile(derived("elastic_pendulum", "free_body")).quantities.reactions


@pytest.mark.campaign
def test_a_fixed_model_moves_as_the_free_one(derived: Any) -> None:
    equations = derived("four_bar", "kane")
    values = {"g": 9.81, "l1": 0.11}
    start = {"q1": 0.5}
    free = simulate(compile(equations), 0.2, initial=start, parameters=values)
    fixed = simulate(compile(equations, fixed=values), 0.2, initial=start)
    for name, column in free.coordinates.items():
        np.testing.assert_allclose(fixed.coordinates[name], column, rtol=1e-7, atol=1e-9)
