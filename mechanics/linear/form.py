"""Linear equations of motion in deviations x of independent coordinates.

M x'' + C x' + K x = E(w),    E(w) = E_0 w + E_1 w' + E_2 w'' + ...
q - q_0 - q_0' t = G x

y = (x, x') without what is cyclic:   y' = A y + B w,   outputs C y + D w
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from sympy import Expr, Float, Matrix, Symbol, eye, zeros

from mechanics.errors import InputError
from mechanics.kernel import enclose
from mechanics.linear.algebra import inverse, is_zero, reduced, written
from mechanics.linear.first_order import Array, first_order
from mechanics.linear.outputs import COORDINATES, INPUTS, RATES, entry_names
from mechanics.linear.values import Numbers, evaluate
from mechanics.program import Builder, Program
from mechanics.program.interpret import include
from mechanics.program.sympy_printer import expressions, written_size
from mechanics.program.sympy_reader import read
from mechanics.scene import Scene

LARGEST = 200_000
"""Operations of a matrix that is written out; beyond it, give values."""
BITS = 192
"""Of the numbers that stand in its place."""


@dataclass(frozen=True, eq=False, repr=False)
class Linear:
    """Linear equations of motion; rows as the route wrote them.

    Attributes
    ----------
    scene : Scene
    route : str
        The route that derived the nonlinear equations.
    point : mapping of Symbol to Expr
        The operating point: a value for every coordinate and input.
    coordinates : tuple of Symbol
        The independent coordinates whose deviations are x, n of them.
    inputs : tuple of Symbol
        Their deviations are w, p of them.
    program : Program
        Its outputs, row by row: ``"mass"``, ``"damping"``, ``"stiffness"`` (n x n), ``"reach"``
        (number of all coordinates x n), and ``"inputs 0"``, ``"inputs 1"``, ... (n x p), of
        parameters and of symbols of the operating point; of outputs see `mechanics.linear.outputs`.
    names : mapping of str to Symbol
        The symbol of each input of the program.
    conjugate : bool
        Whether the rows are power-conjugate to x', so that M and K at rest are the second
        derivatives of kinetic and potential energy.
    speeds : mapping of Symbol to Expr
        All speeds at the operating point; they are zero at rest.
    cyclic : tuple of Symbol
        Of the coordinates, those that drift along a steady motion and have no effect.
    ignorable : tuple of Symbol
        Of the coordinates at rest, those that have no effect: the system may rest at any value.
    no_outputs : str
        Why the outputs of the scene are no C y + D w; empty where they are.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, z = ReferenceFrame("N"), Point("O"), dynamicsymbols("z")
    >>> m, k = parameters("m k", units="kg N/m", typical="2 8")
    >>> P = O.locatenew("P", z * N.z)
    >>> pull = spring("pull", O, P, k, along=N.z)
    >>> bob = Scene("bob", N, O, (z,), (Particle("bob", P, m),), loads=(pull,))
    >>> linear = linearize(derive(bob, "kane"), at={z: 0})
    >>> print(linear.mass, linear.stiffness)
    Matrix([[m]]) Matrix([[k]])
    """

    scene: Scene
    route: str
    point: Mapping[Symbol, Expr]
    coordinates: tuple[Symbol, ...]
    inputs: tuple[Symbol, ...]
    program: Program
    names: Mapping[str, Symbol]
    conjugate: bool
    speeds: Mapping[Symbol, Expr] = field(default_factory=dict)
    cyclic: tuple[Symbol, ...] = ()
    ignorable: tuple[Symbol, ...] = ()
    no_outputs: str = ""

    def __repr__(self) -> str:
        names = ", ".join(map(str, self.coordinates))
        return f"<linear equations of {self.scene.name} by {self.route}: {names}>"

    @cached_property
    def mass(self) -> Matrix:
        """M, n x n."""
        return self._matrix("mass", len(self.coordinates))

    @cached_property
    def damping(self) -> Matrix:
        """C, n x n."""
        return self._matrix("damping", len(self.coordinates))

    @cached_property
    def stiffness(self) -> Matrix:
        """K, n x n."""
        return self._matrix("stiffness", len(self.coordinates))

    @cached_property
    def reach(self) -> Matrix:
        """G, (number of all coordinates) x n; no row of a coordinate that has no effect."""
        return self._matrix("reach", len(self.scene.q))

    @cached_property
    def input_matrices(self) -> tuple[Matrix, ...]:
        """E_0, E_1, ..., n x p each: one for every order of derivative of the inputs."""
        orders = sum(name.startswith("inputs ") for name in self.program.outputs)
        return tuple(self._matrix(f"inputs {k}", len(self.coordinates)) for k in range(orders))

    def _matrix(self, name: str, rows: int) -> Matrix:
        return matrix_of(self.program, name, self.names, rows)

    def with_matrices(self, inputs: tuple[Symbol, ...], **changed: Matrix) -> "Linear":
        """The same with other matrices, by the names of the program's outputs; no G."""
        builder = Builder()
        kept = include(builder, self.program)
        names = {s.name: s for m in changed.values() for entry in m for s in entry.free_symbols}
        gone = "inputs ", "output "
        outputs = {name: nodes for name, nodes in kept.items() if not name.startswith(gone)}
        outputs |= {name: read(builder, tuple(matrix)) for name, matrix in changed.items()}
        return replace(
            self,
            inputs=inputs,
            program=builder.program(outputs),
            names={**self.names, **names},
            conjugate=False,
            ignorable=(),
            no_outputs="these equations were changed: take the outputs of the scene's own",
        )

    def dynamic_stiffness(self, s: Expr) -> Matrix:
        """D(s) = M s^2 + C s + K, n x n."""
        return self.mass * s**2 + self.damping * s + self.stiffness

    def input_polynomial(self, s: Expr) -> Matrix:
        """E(s) = E_0 + E_1 s + E_2 s^2 + ..., n x p."""
        total = zeros(len(self.coordinates), len(self.inputs))
        for order, matrix in enumerate(self.input_matrices):
            total += matrix * s**order
        return total

    @property
    def undamped(self) -> bool:
        """Whether C = 0."""
        return all(is_zero(entry) for entry in self.damping)

    @property
    def moves(self) -> bool:
        """Whether it is about a steady motion."""
        return any(value != 0 for value in self.speeds.values())

    @property
    def state_symbols(self) -> tuple[Symbol, ...]:
        """(x, x') as plain symbols."""
        return (*self.coordinates, *self._rates)

    @property
    def states(self) -> tuple[Symbol, ...]:
        """y: the same without coordinates that are cyclic."""
        return (*(q for q in self.coordinates if q not in self.cyclic), *self._rates)

    @property
    def _rates(self) -> tuple[Symbol, ...]:
        rates = dict(zip(self.scene.q, self.scene.qd, strict=True))
        return tuple(rates[q] for q in self.coordinates)

    @cached_property
    def A(self) -> Matrix:
        """Of y' = A y + B w, s x s with s states."""
        n, kept = len(self.coordinates), len(self.coordinates) - len(self.cyclic)
        solved = inverse(self.mass) * Matrix.hstack(-self.stiffness[:, :kept], -self.damping)
        upper = Matrix.hstack(zeros(kept, kept), eye(n)[:kept, :])
        return Matrix.vstack(upper, solved).applyfunc(reduced)

    @cached_property
    def B(self) -> Matrix:
        """Of y' = A y + B w, s x p.

        Raises
        ------
        InputError
            If derivatives of inputs drive the system.
        """
        self.require_direct_inputs()
        solved = (inverse(self.mass) * self.input_matrices[0]).applyfunc(reduced)
        return zeros(len(self.coordinates) - len(self.cyclic), len(self.inputs)).col_join(solved)

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of the r entries of the outputs of the scene; the states where it has none."""
        return entry_names(self.scene) or tuple(symbol.name for symbol in self.states)

    @cached_property
    def C(self) -> Matrix:
        """Of the deviations C y + D w of the outputs, r x s.

        Raises
        ------
        InputError
            If an output of the scene changes with a coordinate that drifts, or with the rate of an
            input.
        """
        if not self.scene.outputs:
            return eye(len(self.states))
        self.require_outputs()
        kept, rows = len(self.coordinates) - len(self.cyclic), len(self.outputs)
        return Matrix.hstack(self._matrix(COORDINATES, rows)[:, :kept], self._matrix(RATES, rows))

    @cached_property
    def D(self) -> Matrix:
        """Of the deviations C y + D w of the outputs, r x p; raises as `C` does."""
        if not self.scene.outputs:
            return zeros(len(self.states), len(self.inputs))
        self.require_outputs()
        return self._matrix(INPUTS, len(self.outputs))

    def require_outputs(self) -> None:
        """Refuse outputs of the scene that are no C y + D w."""
        if self.no_outputs:
            raise InputError(f"{self.scene.name}: {self.no_outputs}")

    def require_direct_inputs(self) -> None:
        """Refuse derivatives of inputs."""
        if "inputs 1" in self.program.outputs:
            raise InputError(
                f"{self.scene.name}: derivatives of the inputs drive the system, which y' = A y +"
                " B w cannot say: declare the highest derivative as the input"
            )

    def to_control(self, values: Numbers | None = None) -> Any:
        """A, B, C, D as a `StateSpace` of the package `control`, in numbers.

        Parameters
        ----------
        values : mapping, optional
            Parameter values by name or symbol; typical values stand for those that are missing.

        Raises
        ------
        InputError
            If the package is missing, derivatives of inputs drive the system, or an output is no
            C y + D w.
        ValueMissingError
            If a parameter has neither a value nor a typical one.
        """
        try:
            import control
        except ImportError:
            raise InputError(
                "the package control is not installed: pip install 'mechanics[control]'"
            ) from None
        a, b = self.state_space(values)
        return control.ss(
            a, b, *self.output_space(values), name=self.scene.name,
            states=[symbol.name for symbol in self.states], outputs=list(self.outputs),
            inputs=[symbol.name for symbol in self.inputs],
        )  # fmt: skip

    def output_space(self, values: Numbers | None = None) -> tuple[Array, Array]:
        """C and D in numbers."""
        if not self.scene.outputs:
            return np.eye(len(self.states)), np.zeros((len(self.states), len(self.inputs)))
        self.require_outputs()
        kept = len(self.coordinates) - len(self.cyclic)
        place, rates, through = self.numbers(values, COORDINATES, RATES, INPUTS)
        return np.hstack([place[:, :kept], rates]), through

    def state_space(self, values: Numbers | None = None) -> tuple[Array, Array]:
        """A and B in numbers; see `mechanics.linear.state_space`."""
        self.require_direct_inputs()
        names = "mass", "damping", "stiffness", "inputs 0"
        kept = len(self.coordinates) - len(self.cyclic)
        mass, damping, stiffness, drive = self.numbers(values, *names)
        return first_order(mass, damping, stiffness, drive, kept, self.scene.name)

    def numbers(self, values: Numbers | None, *names: str) -> list[Array]:
        """Matrices of the program, by name, each entry the double nearest to the exact one.

        Raises
        ------
        ValueMissingError
            If a parameter has neither a value nor a typical one.
        SingularError
            If an entry has no value.
        """
        found = evaluate(self.scene, self.program, self.names, values, names)
        rows = {name: len(self.outputs) for name in (COORDINATES, RATES, INPUTS)}
        counts = [rows.get(name, len(self.coordinates)) for name in names]
        return [
            np.array(found[name]).reshape(count, len(found[name]) // count)
            for name, count in zip(names, counts, strict=True)
        ]

    def coordinate_index(self, name: str) -> int:
        """Place of a coordinate among `coordinates`."""
        return _index("coordinate", name, self.coordinates, self)

    def input_index(self, name: str) -> int:
        """Place of an input among `inputs`."""
        return _index("input", name, self.inputs, self)


def matrix_of(program: Program, name: str, names: Mapping[str, Symbol], rows: int) -> Matrix:
    """An output of a program as a matrix of so many rows.

    Raises
    ------
    ExpressionError
        If it is too long to be written out.
    """
    builder = Builder()
    part = builder.program({name: include(builder, program)[name]})
    columns = len(part.outputs[name]) // rows if rows else 0
    if part.inputs or written_size(part) <= LARGEST:
        entries = expressions(part, names, limit=LARGEST)[name]
        return Matrix(rows, columns, [written(entry) for entry in entries])
    return Matrix(rows, columns, [number(ball) for ball in enclose(part, {}, BITS)[name]])


def number(ball: Any) -> Float:
    """The middle of an enclosure, with the digits that it has."""
    digits = max(ball.rel_accuracy_bits() * 3 // 10, 15) if ball != 0 else 15
    return Float(ball.mid().str(digits, radius=False), digits)


def _index(kind: str, name: str, symbols: tuple[Symbol, ...], linear: Linear) -> int:
    names = [symbol.name for symbol in symbols]
    if name not in names:
        raise InputError(
            f"{linear.scene.name}: {name!r} is no {kind} of the linear equations:"
            f" there are {', '.join(names) or 'none'}"
        )
    return names.index(name)
