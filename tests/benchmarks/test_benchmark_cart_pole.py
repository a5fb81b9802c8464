"""The cart with one link: the kernel by hand is right, and the generated one takes no more."""

import pytest

from benchmarks.c_kernels import FOLDER, CKernel, read
from mechanics.compiled import Model, compile
from mechanics.compiled.c.source import function_source
from mechanics.crosscheck import derive
from mechanics.symbolic import Arithmetic, decide
from systems import pendulum_chain

ROUTES = ("free_body", "moving_point", "kane", "lagrange")


def modelled(route: str) -> Model:
    return compile(derive(pendulum_chain.scene(1), route), outputs=("forward_dynamics",))


def kernel(model: Model, source: str, name: str) -> CKernel:
    groups = ("q", "u", "inputs", "p")
    symbols = {g: tuple(e.symbol for e in getattr(model.quantities, g)) for g in groups}
    return read(source, symbols)[name]


def by_hand(model: Model) -> CKernel:
    return kernel(model, (FOLDER / "cart_pole.c").read_text(encoding="utf-8"), "cart_pole")


def test_the_kernel_by_hand_is_exact() -> None:
    model = modelled("free_body")
    hand, (left, right) = by_hand(model), model.equations.system

    def rows(a: Arithmetic) -> list[tuple[object, object]]:
        solution = [a.value(hand.outputs["ud", i]) for i in range(left.cols)]
        pairs = []
        for i in range(left.rows):
            terms = [a.value(left[i, j]) * x for j, x in enumerate(solution)]
            pairs.append((sum(terms, a.rational(0)), a.value(right[i])))
        return pairs

    assert decide("cart_pole.c", rows).verdict.name == "PROVED"


@pytest.mark.parametrize("route", ROUTES)
def test_generated_code_takes_no_more_operations(route: str) -> None:
    model = modelled(route)
    text = function_source(model.program("forward_dynamics"), model.entries)
    generated, hand = kernel(model, text, "forward_dynamics"), by_hand(model)
    assert generated.operations <= hand.operations
    for name in ("divide", "call"):
        assert generated.counts[name] <= hand.counts[name]


def test_with_parameters_prepared_it_takes_fewer_divisions() -> None:
    model = modelled("free_body")
    prepared = model.program("forward_dynamics_prepared")
    text = function_source(prepared, model.programs.names("forward_dynamics_prepared"))
    groups = {
        g: tuple(e.symbol for e in getattr(model.quantities, g)) for g in ("q", "u", "inputs")
    }
    groups["c"] = tuple(e.symbol for e in model.programs.constants)
    found = read(text, groups)["forward_dynamics_prepared"]
    assert found.operations <= by_hand(model).operations
    assert found.counts["divide"] == 1
