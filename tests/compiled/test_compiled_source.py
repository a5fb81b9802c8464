"""The printed C computes what the graph says, rounding by rounding."""

import casadi as ca
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics.compiled.c.names import RESERVED, Namer, identifier
from mechanics.compiled.c.source import function_source, literal
from mechanics.compiled.machine import native
from mechanics.compiled.machine.native import NativeKernel, library_source
from mechanics.compiled.machine.virtual import NumpyKernel, VirtualKernel
from mechanics.errors import CompilerError, ExpressionError
from mechanics.program.casadi_reader import read_routine
from mechanics.program.operations import OPERATIONS

ENTRIES = {"s": ("x", "lambda", "I", "y1")}


def function(*outputs: ca.SX, of: ca.SX) -> ca.Function:
    return ca.Function("f", [of], [ca.vertcat(*outputs)], ["s"], ["out"])


BINARY = (
    lambda p, q: p + q,
    lambda p, q: p - q,
    lambda p, q: p * q,
    lambda p, q: p / q,
    lambda p, q: -(p - q),
    lambda p, q: -p * q,
    lambda p, q: (p / q) / (q / p),
    lambda p, q: p - (q - p) - (q + p),
    lambda p, q: (p + q) ** 2 - p * (q * p),
    lambda p, q: 1 / (p + 3) + 2 * (p - q),
    lambda p, q: ca.if_else(p < q, p, q * 3),
    lambda p, q: ca.fmax(p, q) * ca.fabs(q) - ca.sign(p),
    lambda p, q: ca.sqrt(ca.fabs(p)) - q * 0.1,
)


@pytest.mark.campaign
@settings(max_examples=20, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 12), st.integers(0, 99), st.integers(0, 99)), min_size=8))
def test_machine_code_rounds_like_numpy(compiler: str, steps: list[tuple[int, int, int]]) -> None:
    s = ca.SX.sym("s", 4)
    values = [s[i] for i in range(4)]
    for operation, left, right in steps:
        values.append(BINARY[operation](values[left % len(values)], values[right % len(values)]))
    made = function(*values[-6:], of=s)
    # CasADi divides numbers by zero on its own: what is infinite has no text.
    constants = [made.instruction_constant(k) for k in range(made.n_instructions())
                 if made.instruction_id(k) == ca.OP_CONST]  # fmt: skip
    assume(np.isfinite(constants).all())
    code = read_routine(made)
    states = np.random.default_rng(0).normal(size=(64, 4))
    for kind in (np.float64, np.float32):
        given_states = [states.astype(kind)]
        (native,) = NativeKernel(code, ENTRIES, kind, compiler)(given_states, 64)
        (plain,) = NumpyKernel(code, kind)(given_states, 64)
        assert native.dtype == kind
        np.testing.assert_array_equal(native, plain)


def test_every_operation_of_the_table_agrees_with_casadi(compiler: str) -> None:
    s = ca.SX.sym("s", 4)
    x, y = s[0], s[1]
    outputs = [
        ca.sin(x), ca.cos(x), ca.tan(x), ca.asin(x), ca.acos(x), ca.atan(x), ca.atan2(x, y),
        ca.sinh(x), ca.cosh(x), ca.tanh(x), ca.asinh(x), ca.acosh(x + 2), ca.atanh(x),
        ca.exp(x), ca.expm1(x), ca.log(y), ca.log1p(x), ca.erf(x), ca.sqrt(y), ca.fabs(x),
        ca.sign(x),
        ca.floor(x * 7), ca.ceil(x * 7), ca.hypot(x, y), ca.copysign(y, x), ca.fmax(x, y),
        ca.fmin(x, y), y**x, y**0.3, x < y, x <= y, x == y, x != y,
        ca.logic_and(x < y, x > 0), ca.logic_or(x < y, x > 0), ca.logic_not(x < y),
        ca.if_else(x > 0, x, y), x + y, x - y, x * y, x / y, 1 / x, -x, x * x, 2 * x,
    ]  # fmt: skip
    made = function(*outputs, of=s)
    code = read_routine(made)
    printed = {row.code for row in OPERATIONS if row.c and row.arity}
    assert {node.operation for node in code.nodes} >= printed
    states = np.random.default_rng(1).uniform([-1, 0, 0, 0], 1, size=(32, 4))
    (reference,) = VirtualKernel(made)([states], 32)
    for kernel in (
        NativeKernel(code, ENTRIES, np.float64, compiler),
        NumpyKernel(code, np.float64),
    ):
        np.testing.assert_allclose(kernel([states], 32)[0], reference, rtol=1e-14, atol=1e-15)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_literals_are_exact(value: float) -> None:
    with np.errstate(over="ignore"):
        single = float(np.float32(value))
    for kind, rounded in (("double", value), ("float", single)):
        text = literal(value, kind)
        if np.isinf(rounded):
            assert text.endswith("INFINITY")
            continue
        text = text.removesuffix("f") if kind == "float" else text
        assert (float.fromhex(text) if "x" in text else float(text)) == rounded
        assert "x" in text or "." in text


@pytest.mark.campaign
@given(st.text(max_size=12))
def test_every_name_becomes_an_identifier(name: str) -> None:
    text = identifier(name)
    assert text.isascii() and text.isidentifier()
    assert text not in RESERVED and not text.startswith("_")


def test_names_that_c_reserves_or_that_meet_are_told_apart() -> None:
    namer = Namer(["q"])
    names = ["lambda", "I", "y1", "int", "N1", "q", "v3", "a'", "a*", "θ", "2x"]
    found = [namer.local(name) for name in names]
    assert found[:6] == ["lambda", "I_", "y1_", "int_", "N1", "q_"]
    assert len(set(found)) == len(found)


def test_inputs_are_read_before_outputs_are_written() -> None:
    s = ca.SX.sym("s", 4)
    text = function_source(read_routine(function(s[1], s[0] * s[1], s[0], of=s)), ENTRIES)
    body = text.splitlines()
    reads = [i for i, line in enumerate(body) if "= s[" in line]
    writes = [i for i, line in enumerate(body) if line.strip().startswith("out[")]
    assert max(reads) < min(writes)


def test_an_unused_array_is_no_warning(compiler: str) -> None:
    s = ca.SX.sym("s", 4)
    text = function_source(read_routine(function(ca.SX(1), of=s)), ENTRIES)
    assert "(void)s;" in text


def test_a_compiler_that_refuses_is_quoted(compiler: str) -> None:
    s = ca.SX.sym("s", 4)
    code = read_routine(function(s[0], of=s))
    with pytest.raises(CompilerError, match=r"(?s)refused.*compiler=None"):
        NativeKernel(code, {"s": ("x", "y", "z", "1 +")}, np.float64, "false")
    with pytest.raises(CompilerError, match="cannot be run"):
        NativeKernel(code, ENTRIES, np.float64, "/no/such/compiler")
    assert "f_batch" in library_source(code, ENTRIES, np.float64)


def test_an_operation_without_c_is_named() -> None:
    s = ca.SX.sym("s", 4)
    with pytest.raises(ExpressionError, match="OP_ERFINV"):
        read_routine(function(ca.erfinv(s[0]), of=s))


def test_long_programs_are_compiled_without_optimisation(compiler: str, monkeypatch) -> None:
    s = ca.SX.sym("s", 4)
    code = read_routine(function(ca.sin(s[0]) * s[1] + s[2] / s[3], of=s))
    states = [np.random.default_rng(2).normal(size=(16, 4))]
    levels: list[str] = []
    compile_and_load = native.load

    def recorded(source: str, path: str, level: str) -> object:
        levels.append(level)
        return compile_and_load(source, path, level)

    monkeypatch.setattr(native, "load", recorded)
    results = [NativeKernel(code, ENTRIES, np.float64, compiler)(states, 16)]
    monkeypatch.setattr(native, "LONG", 1)
    results.append(NativeKernel(code, ENTRIES, np.float64, compiler)(states, 16))
    assert levels == ["-O2", "-O0"]
    np.testing.assert_array_equal(*results)
