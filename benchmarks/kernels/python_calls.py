"""One state from Python: what a call costs when the states come one by one.

Every contender gets NumPy arrays of one state and gives an array of accelerations.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
import sympy
from sympy.physics.mechanics import dynamicsymbols

from benchmarks.kernels.case import Array, Case
from benchmarks.kernels.lanes import missing
from benchmarks.kernels.race import Contender, Lap
from benchmarks.peers import explicit_kane


def contenders() -> tuple[Contender, ...]:
    """Ways to call from Python."""
    return (
        Contender("model.forward_dynamics", _here, _ours),
        Contender("model.buffer", _here, _buffer),
        Contender("CasADi with its buffers", _here, _casadi_buffer),
        Contender("CasADi with NumPy arrays", _here, _casadi),
        Contender("SymPy lambdify and numpy.linalg.solve", _here, _lambdify),
        Contender("PyDy, Cython", lambda: missing("pydy") or missing("Cython"), _pydy),
    )


def _here() -> str:
    return ""


def _lap(call: Callable[[], object], result: Callable[[], Array]) -> Lap:
    return Lap(lambda: call(), 1, lambda: np.reshape(result(), (-1, 1)))


def _state(case: Case) -> tuple[Array, Array, Array]:
    q, u, inputs = (np.ascontiguousarray(a[:, 0]) for a in (case.q, case.u, case.inputs))
    return q, u, inputs


def _ours(case: Case) -> Lap:
    q, u, inputs = _state(case)
    call = partial(case.model.forward_dynamics, q, u, inputs=inputs, p=case.p)
    return _lap(call, call)


def _buffer(case: Case) -> Lap:
    buffer = case.model.buffer("forward_dynamics")
    for name, value in zip(("q", "u", "inputs", "p"), (*_state(case), case.p), strict=True):
        buffer.inputs[name][:] = value
    return _lap(buffer.run, lambda: buffer.outputs["ud"])


def _casadi_buffer(case: Case) -> Lap:
    function = case.model.casadi["forward_dynamics"]
    buffer, trigger = function.buffer()
    arrays = [*_state(case), case.p.copy()]
    found = np.zeros(case.links + 1)
    for i, array in enumerate(arrays):
        buffer.set_arg(i, memoryview(array))
    buffer.set_res(0, memoryview(found))
    # The result holds what the trigger uses, so that it lives.
    return _lap(trigger, lambda: (buffer, arrays, found)[2])


def _casadi(case: Case) -> Lap:
    function = case.model.casadi["forward_dynamics"]
    arrays = [*_state(case), case.p]
    return _lap(lambda: function(*arrays), lambda: np.array(function(*arrays)[0])[:, 0])


def _lambdify(case: Case) -> Lap:
    mass, forcing = explicit_kane(case.links)
    q, u, inputs = _state(case)
    arguments = _symbols(case)
    flat = [symbol for group in arguments for symbol in group]
    function = sympy.lambdify(flat, (mass, forcing), cse=True)

    def call() -> Array:
        m, f = function(*q, *u, *inputs, *case.p)
        return np.linalg.solve(m, f)[:, 0]

    return _lap(call, call)


def _pydy(case: Case) -> Lap:
    from pydy.codegen.ode_function_generators import generate_ode_function

    mass, forcing = explicit_kane(case.links)
    coordinates, speeds, (force,), constants = _symbols(case)
    rhs = generate_ode_function(
        forcing, coordinates, speeds, constants, mass_matrix=mass,
        coordinate_derivatives=sympy.Matrix(speeds), specifieds=[force],
        generator="cython", constants_arg_type="array", specifieds_arg_type="array",
    )  # fmt: skip
    q, u, inputs = _state(case)
    state = np.concatenate([q, u])
    return _lap(
        lambda: rhs(state, 0.0, inputs, case.p),
        lambda: rhs(state, 0.0, inputs, case.p)[case.links + 1 :],
    )


def _symbols(case: Case) -> tuple[list, list, list, list]:
    """Coordinates, speeds, the force and parameters as in `explicit_kane`, in our order."""
    n = case.links
    g = sympy.symbols("g")
    lengths, masses = sympy.symbols(f"l:{n}"), sympy.symbols(f"m:{n + 1}")
    q, u = dynamicsymbols(f"q:{n + 1}"), dynamicsymbols(f"u:{n + 1}")
    return list(q), list(u), [dynamicsymbols("F")], [g, *lengths, *masses]
