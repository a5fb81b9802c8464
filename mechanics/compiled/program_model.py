"""A model whose functions are compiled from programs, for scenes too large to be written out.

Functions are CasADi's, to embed, differentiate, map and optimise over; calls take and give NumPy
arrays of one state or of a batch.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechanics.compiled.outputs import programs
from mechanics.equations import ProgramEquations
from mechanics.errors import InputError, ValueMissingError
from mechanics.mechanism import Mechanism
from mechanics.program import Program
from mechanics.program.builder import Node
from mechanics.program.casadi_printer import print_function

Array = NDArray[np.float64]

STATE = ("q", "u", "inputs", "p")


@dataclass(frozen=True, eq=False, repr=False)
class ProgramModel:
    """Compiled functions of a scene.

    Arrays have shape (n,) for one state or (batch, n) for many. `p` are all parameters in the order
    of `parameters`, or a mapping from names to numbers, the rest being typical; None takes typical
    values of all.

    Attributes
    ----------
    equations : ProgramEquations
    programs : mapping of str to Program
        What each function computes, exactly.
    casadi : mapping of str to casadi.Function
        Inputs ``q``, ``u``, ``inputs``, ``p``, and ``ud`` where it is needed.
    inputs, parameters : tuples of str
        Names of the entries.
    """

    equations: ProgramEquations
    programs: Mapping[str, Program]
    casadi: Mapping[str, ca.Function]
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]

    def __repr__(self) -> str:
        scene = self.equations.scene
        return f"<model of {scene.name}: {len(scene.u)} speeds, {len(self.casadi)} functions>"

    def forward_dynamics(
        self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None
    ) -> Array:
        """u' from the state, (n,) or (batch, n)."""
        return self.evaluate("forward_dynamics", q=q, u=u, inputs=inputs, p=p)["ud"]

    def inverse_dynamics(
        self, q: ArrayLike, u: ArrayLike, ud: ArrayLike, *, inputs: Any = None, p: Any = None
    ) -> Array:
        """Generalized forces, conjugate to u, which added to the loads give u'."""
        return self.evaluate("inverse_dynamics", q=q, u=u, inputs=inputs, p=p, ud=ud)["forces"]

    def mass_matrix(
        self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None
    ) -> Array:
        """M, (n, n) or (batch, n, n)."""
        return self.evaluate("mass_matrix", q=q, u=u, inputs=inputs, p=p)["mass_matrix"]

    def energy(
        self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None
    ) -> dict[str, Array]:
        """``kinetic``, ``potential`` and ``total`` energy, in J."""
        found = self.evaluate("energy", q=q, u=u, inputs=inputs, p=p)
        return {name: values[..., 0] for name, values in found.items()}

    def evaluate(self, name: str, **arrays: Any) -> dict[str, Array]:
        """Every output of a function, by name.

        Raises
        ------
        InputError
            If there is no such function, or an array has a wrong size.
        ValueMissingError
            For a parameter that has no value.
        """
        if name not in self.casadi:
            raise InputError(
                f"function {name!r}: the model of {self.equations.scene.name} has"
                f" {', '.join(self.casadi)}"
            )
        function = self.casadi[name]
        columns = [self._column(function, k, arrays) for k in range(function.n_in())]
        batch = max((len(column) for column in columns if column is not None), default=1)
        given = [np.broadcast_to(column, (batch, column.shape[1])).T.copy() for column in columns]
        single = all(np.ndim(array) < 2 for array in arrays.values() if not _named(array))
        found = {}
        for k in range(function.n_out()):
            rows, width = function.size_out(k)
            values = np.empty((batch, rows, width))
            found[function.name_out(k)] = values
        mapped = function.map(batch)
        results = mapped(*given)
        for k, result in enumerate(results if function.n_out() > 1 else [results]):
            rows, width = function.size_out(k)
            table = np.array(result).reshape(rows, batch, width).swapaxes(0, 1)
            shaped = table if width > 1 else table[:, :, 0]
            found[function.name_out(k)] = shaped[0] if single else shaped
        return found

    def _column(self, function: ca.Function, place: int, arrays: Mapping[str, Any]) -> Array:
        group, size = function.name_in(place), function.size1_in(place)
        value = arrays.get(group)
        if group == "p" and _named(value):
            value = self._numbers(value or {})
        if value is None:
            value = np.zeros(0)
        array = np.atleast_2d(np.asarray(value, dtype=float))
        if array.ndim != 2 or array.shape[1] != size:
            raise InputError(
                f"{function.name()}: {group} has the shape {np.shape(value)}: ({size},) or"
                f" (batch, {size}) is needed"
            )
        return array

    def _numbers(self, given: Mapping[str, float]) -> list[float]:
        if unknown := sorted(set(given) - set(self.parameters)):
            raise InputError(
                f"parameter {unknown[0]!r}: the parameters are {', '.join(self.parameters)}"
            )
        typical = {
            symbol.name: getattr(symbol, "typical", None)
            for symbol in self.equations.scene.parameters
        }
        values = []
        for name in self.parameters:
            value = given.get(name, typical[name])
            if value is None:
                raise ValueMissingError(
                    f"parameter {name}: it has no value: pass p={{{name!r}: number}}, or give it a"
                    " typical value"
                )
            values.append(float(value))
        return values


def _named(value: Any) -> bool:
    return value is None or isinstance(value, Mapping)


def compile_programs(equations: ProgramEquations) -> ProgramModel:
    """The model of equations that are programs.

    Raises
    ------
    InputError
        For constraints and friction.
    """
    mechanism, scene = equations.mechanism, equations.scene
    made = programs(mechanism)
    names = {
        "q": _names(mechanism, mechanism.q),
        "u": _names(mechanism, mechanism.u),
        "ud": _names(mechanism, mechanism.ud),
    }
    used = {name for program in made.values() for name in program.inputs}
    parameters = tuple(symbol.name for symbol in scene.parameters)
    rest = used - {*names["q"], *names["u"], *names["ud"], *parameters}
    given = tuple(name for name in mechanism.builder.inputs if name in rest)
    groups = {"q": names["q"], "u": names["u"], "inputs": given, "p": parameters}
    n = len(names["u"])
    shapes = {"mass_matrix": (n, n), "ud_q": (n, len(names["q"])), "ud_u": (n, n)}
    functions = {}
    for name, program in made.items():
        needed = {**groups, "ud": names["ud"]} if name == "inverse_dynamics" else groups
        own = {output: shape for output, shape in shapes.items() if output in program.outputs}
        functions[name] = print_function(program, name, needed, own)
    return ProgramModel(equations, made, functions, given, parameters)


def _names(mechanism: Mechanism, nodes: tuple[Node, ...]) -> tuple[str, ...]:
    build = mechanism.builder
    return tuple(build.inputs[build.operands[0][node.number]] for node in nodes)
