"""The generated forward dynamics against kernels by hand: operations, exactness, numbers.

Rewrite the baseline with ``MECHANICS_UPDATE_BASELINE=1 pytest tests/benchmarks``.
"""

import json
import os
from pathlib import Path

import numpy as np
import pytest
from sympy import lambdify, symbols

from benchmarks import parsimony
from benchmarks.c_kernels import CKernel, read
from benchmarks.hand import PEERS, Peer, counted
from benchmarks.machine_code import timed
from mechanics.compiled.sampling import sample
from mechanics.errors import CompilerError, ExpressionError
from mechanics.symbolic import Arithmetic, decide

ROUTES = ("free_body", "moving_point", "kane", "lagrange")
BASELINE = Path(__file__).parents[2] / "benchmarks" / "parsimony.json"
ALLOWED = 1.1

by_peer = pytest.mark.parametrize("peer", PEERS, ids=lambda peer: peer.name)
by_suffix = pytest.mark.parametrize("suffix", ["", "_fixed"], ids=["free", "fixed"])


def fixed(peer: Peer, suffix: str) -> dict[str, str]:
    return dict(peer.fixed) if suffix else {}


@pytest.mark.sample(2)
@by_peer
@by_suffix
@pytest.mark.parametrize("route", ROUTES)
def test_no_more_than_by_hand(peer: Peer, suffix: str, route: str) -> None:
    generated = counted(peer.model(route, fixed(peer, suffix)))
    hand = peer.kernel(suffix)
    assert generated.operations <= ALLOWED * hand.operations
    assert generated.counts.get("divide", 0) <= hand.counts.get("divide", 0)
    assert generated.counts.get("call", 0) == hand.counts.get("call", 0)


@by_peer
@by_suffix
def test_the_kernel_by_hand_is_exact(peer: Peer, suffix: str) -> None:
    equations, kernel = peer.equations("free_body"), peer.kernel(suffix)
    model = peer.model("free_body", fixed(peer, suffix))
    left, right = equations.system

    def rows(a: Arithmetic) -> list[tuple[object, object]]:
        for symbol, value in model.casadi.fixed.items():
            a.assign(symbol, a.value(value))
        solution = [a.value(kernel.outputs["ud", i]) for i in range(left.cols)]
        products = [
            sum((a.value(left[i, j]) * x for j, x in enumerate(solution)), a.rational(0))
            for i in range(left.rows)
        ]
        return [(product, a.value(right[i])) for i, product in enumerate(products)]

    assert decide(f"{kernel.name} by hand", rows).verdict.name == "PROVED"


@pytest.mark.sample(2)
@by_peer
@by_suffix
def test_the_kernel_by_hand_gives_the_same_numbers(peer: Peer, suffix: str) -> None:
    model, kernel = peer.model(fixed=fixed(peer, suffix)), peer.kernel(suffix)
    states = sample(model.quantities, 200, seed=5, decades=1.0)
    symbols = [e.symbol for g in ("q", "u", "inputs", "p") for e in getattr(model.quantities, g)]
    outputs = [kernel.outputs["ud", i] for i in range(len(model.quantities.ud))]
    expected = lambdify(symbols, outputs)(*np.hstack(states.groups).T)
    q, u, inputs, p = states.groups
    found = model.forward_dynamics(q, u, inputs=inputs, p=p)
    np.testing.assert_allclose(found.T, np.array(expected), rtol=1e-9, atol=1e-9)


@pytest.mark.campaign
@by_peer
def test_operations_do_not_grow(peer: Peer) -> None:
    counts = {variant.label: variant.operations for variant in parsimony.variants(peer)}
    baseline = json.loads(BASELINE.read_text()) if BASELINE.exists() else {}
    if os.environ.get("MECHANICS_UPDATE_BASELINE"):
        baseline[peer.name] = counts
        BASELINE.write_text(json.dumps(dict(sorted(baseline.items())), indent=2) + "\n")
    known = baseline[peer.name]
    assert counts.keys() == known.keys()
    grown = {label: (known[label], n) for label, n in counts.items() if n > known[label]}
    assert not grown, f"{peer.name}: (baseline, now) {grown}"


@pytest.mark.campaign
@by_peer
def test_less_that_is_asked_for_is_less_to_compute(peer: Peer) -> None:
    counts = {variant.label: variant.operations for variant in parsimony.variants(peer)}
    everything, some, one = list(counts.values())[:3]
    dropped, all_fixed, _ = (
        n for label, n in counts.items() if label.startswith(("dropped", "all"))
    )
    assert everything > some > one > dropped
    assert one > all_fixed


@pytest.mark.campaign
def test_the_table_is_printed(compiler: str) -> None:
    lines = list(parsimony.table(PEERS[2], 3, compiler))
    assert len(lines) == 2 + len(list(parsimony.variants(PEERS[2])))
    assert all(line.count("|") == 6 for line in lines)


COUNTED = """
#include <math.h>
/* nothing here counts: 1 + 2 */
void f(const double q[2], const double p[1], double r[1])
{
    const double a = -2.0 / 3.0 * q[0], b = sin(a);
    r[0] = -b + 0x1.8p+0 * (a - q[1]) / p[0];
}
"""


def kernel(source: str) -> CKernel:
    return read(source, {"q": symbols("x y"), "p": symbols("L:1")})["f"]


def test_the_rule_of_counting() -> None:
    assert kernel(COUNTED).counts == {
        "multiply": 2, "call": 1, "sign": 1, "add": 2, "divide": 1
    }  # fmt: skip


@pytest.mark.parametrize(
    ("line", "what"),
    [("if (q[0] > 0.0) return;", "If"), ("r[0] = q[0] % 2;", "BinaryOp"),
     ("r[0] = gamma(q[0]);", "FuncCall")],
)  # fmt: skip
def test_what_cannot_be_counted_is_named(line: str, what: str) -> None:
    with pytest.raises(ExpressionError, match=what):
        kernel(f"void f(const double q[2], double r[1])\n{{ {line} }}")


def test_a_compiler_that_refuses_is_named(compiler: str) -> None:
    with pytest.raises(CompilerError, match="failed"):
        timed("void f(const double q[1]) { this is no C; }", ["f"], compiler)
    with pytest.raises(CompilerError, match="cannot be run"):
        timed("void f(const double q[1]) { }", ["f"], "/nowhere/cc")
