"""Equations as fast functions: ``compile(equations) -> Model``.

A model is data and calls. It takes and gives NumPy arrays, one state or a batch of them, by machine
code where a C compiler is found and by CasADi's virtual machine where none is.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechanics.compiled.calls.arguments import as_doubles
from mechanics.compiled.calls.checked import checked
from mechanics.compiled.calls.direct_states import ManyStates
from mechanics.compiled.calls.functions import Functions
from mechanics.compiled.calls.many_states import look_at, written
from mechanics.compiled.calls.one_state import CALLS, OneState
from mechanics.compiled.fixed import read_fixed
from mechanics.compiled.graphs import STATE, Graphs
from mechanics.compiled.machine.evaluator import FLAGS
from mechanics.compiled.machine.native import find_compiler
from mechanics.compiled.programs.of_model import Programs
from mechanics.compiled.right_hand_side import RightHandSide
from mechanics.equations import Equations
from mechanics.errors import wanted
from mechanics.scene.outputs import JACOBIAN, Velocity

Array = NDArray[np.floating]


@dataclass(frozen=True, eq=False, repr=False)
class Model(Functions):
    """Compiled functions of one set of equations: those of mechanics as methods.

    The rest, and all of them by name, are in `Functions`.

    Examples
    --------
    >>> from dataclasses import replace
    >>> from systems import elastic_pendulum
    >>> scene = elastic_pendulum.scene()
    >>> seen = replace(scene, outputs={"middle": position(scene.bodies[-1].centre)})
    >>> model, q, u = compile(derive(seen)), [0.0, 0.0], [0.0, 1.0]
    >>> model.output("middle", q)
    array([ 0. , -0.5,  0. ])
    >>> ud = model.forward_dynamics(q, u)
    >>> bool(abs(model.mass_matrix(q, u) @ ud - model.forcing(q, u)).max() < 1e-12)
    True
    >>> bool(abs(model.residual(q, u, ud)).max() < 1e-12), model.multipliers(q, u).shape
    (True, (0,))
    >>> model.inverse_dynamics(q, u, ud).shape, model.coordinate_rates(q, u)
    ((2,), array([0., 1.]))
    >>> round(float(model.energy(q, u)["kinetic"]), 12)
    0.166666666667
    """

    def __repr__(self) -> str:
        return f"<model of {self.equations.scene.name} by {self.equations.route}: {self.backend}>"

    def __getattr__(self, name: str) -> Callable[..., Array]:
        """An output of the scene as a method; see `output`."""
        graphs = tuple(self.__dict__.get("casadi", ()))
        if name in graphs and name.removesuffix(JACOBIAN) in self.equations.scene.outputs:
            return partial(self.output, name)
        raise AttributeError(
            f"the model of {self.equations.scene.name!r} has no {name}: its functions are"
            f" {', '.join(graphs)}"
            if graphs
            else name
        )

    @cached_property
    def right_hand_side(self) -> RightHandSide:
        """y' = f(y, inputs, p), for integrators."""
        return RightHandSide(self.casadi, self.compiler, self.flags)

    @cached_property
    def _one(self) -> OneState:
        return OneState(self)

    @cached_property
    def _states(self) -> ManyStates:
        return ManyStates(self)

    def forward_dynamics(
        self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None,
        check: bool = True, out: Array | None = None, threads: int = 1,
    ) -> Array:  # fmt: skip
        """u' from the state: (n,) or (batch, n).

        With `check`, a state at which a value is no number raises InputError, SingularError or
        RangeError, which name it; without, the array holds what the machine gives. From 512 states
        on they are computed by vectors, with sines and cosines of their own, in `threads` parts at
        a time: results differ by a few units in the last place from those of single states. They
        are written to `out`, if that is given; arrays are not copied, whatever their strides.

        Arrays of float64 take the shortest way, half a microsecond for one state, lists and other
        types some more; parameters by name, `out`, and batches of fewer states take 30 us. Threads
        pay from 1e5 states on.
        """
        if out is None:
            one = self._one["forward_dynamics" if check else "unchecked"]
            found = one(q, u, inputs, p)
            if found is None:
                found = one(*map(as_doubles, (q, u, inputs, p)))
            if found is not None:
                return found
        if threads == 1 and isinstance(q, np.ndarray) and q.ndim == 2:
            found = self._states[check, np.ndim(inputs) == 1](q, u, inputs, p, out)
            if found is not None:
                return found
        arrays = {"q": q, "u": u, "inputs": inputs, "p": p}
        return self._solved(check, arrays, None if out is None else {"ud": out}, threads)["ud"]

    def multipliers(
        self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None, check: bool = True
    ) -> Array:
        """Multipliers lambda, the reactions that maintain the constraints; as forward_dynamics."""
        found = self._one["multipliers"](q, u, inputs, p) if check else None
        if found is not None:
            return found
        arrays = {"q": q, "u": u, "inputs": inputs, "p": p}
        return self._solved(check, arrays)["multipliers"]

    def _solved(
        self,
        check: bool,
        arrays: Mapping[str, Any],
        out: Mapping[str, Array] | None = None,
        threads: int = 1,
    ) -> dict[str, Array]:
        name = "forward_dynamics"
        given, count = self._given(name, np.float64, arrays)
        several = self._many(name, np.float64, given, count, check) is not None
        if several or not check:
            found, met = self._evaluated(name, np.float64, given, count, out, threads, check)
            if not check or not met:
                return found
        code, scene = self.program(name), self.equations.scene
        look_at(code, out or {}, count, np.float64, threads)
        looked = checked(
            scene, code, self.entries, given,
            lambda watched: self._evaluated(watched, np.float64, given, count)[0],
        )  # fmt: skip
        return found if several else written(looked, out or {})

    def mass_matrix(
        self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None
    ) -> Array:
        """M of the route's rows: (rows, n) or (batch, rows, n)."""
        return self._output("mass_matrix", q=q, u=u, inputs=inputs, p=p)

    def forcing(self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None) -> Array:
        """Right side f of the route's rows: (rows,) or (batch, rows)."""
        return self._output("forcing", q=q, u=u, inputs=inputs, p=p)

    def residual(
        self, q: ArrayLike, u: ArrayLike, ud: ArrayLike, multipliers: Any = None,
        *, inputs: Any = None, p: Any = None,
    ) -> Array:  # fmt: skip
        """[M u' - f - B lambda; A u' - b], in the units of the rows."""
        return self._output(
            "residual", q=q, u=u, inputs=inputs, p=p, ud=ud, multipliers=multipliers
        )

    def inverse_dynamics(
        self, q: ArrayLike, u: ArrayLike, ud: ArrayLike, *, inputs: Any = None, p: Any = None
    ) -> Array:
        """Generalized forces, conjugate to u, which added to the loads give u'."""
        return self._output("inverse_dynamics", q=q, u=u, inputs=inputs, p=p, ud=ud)

    def coordinate_rates(
        self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None
    ) -> Array:
        """q' = N u + n."""
        return self._output("coordinate_rates", q=q, u=u, inputs=inputs, p=p)

    def energy(
        self, q: ArrayLike, u: ArrayLike, p: Any = None, *, inputs: Any = None
    ) -> dict[str, Array]:
        """``kinetic``, ``potential`` and ``total`` energy, in J."""
        values = self._one["energy"](q, u, inputs, p)
        if values is None:
            values = self.evaluate("energy", q=q, u=u, inputs=inputs, p=p).values()
        return {n: v[..., 0] for n, v in zip(CALLS["energy"].outputs, values, strict=True)}

    def output(
        self, name: str, q: ArrayLike, u: Any = None, p: Any = None, *, inputs: Any = None
    ) -> Array:
        """An output of the scene, or its Jacobian by the speeds: ``model.tool(q)`` for short.

        Positions and velocities (3,), orientations (3, 3), their Jacobians (3, n); a velocity along
        a direction is a number, its Jacobian (n,); a batch stands before. Speeds and inputs that it
        does not depend on may be left out.
        """
        declared = self.equations.scene.outputs.get(name.removesuffix(JACOBIAN))
        function, given = self.casadi[name], {"q": q, "u": u, "inputs": inputs, "p": p}
        for place, group in enumerate(STATE):
            missing = group in ("u", "inputs") and given[group] is None
            if missing and not function.jac_sparsity(0, place).nnz():
                given[group] = np.zeros(function.numel_in(place))
        (found,) = self.evaluate(name, **given).values()
        if isinstance(declared, Velocity) and declared.along is not None:
            return found[..., 0, :] if name.endswith(JACOBIAN) else found[..., 0]
        return found

    def _output(self, name: str, **arrays: Any) -> Array:
        """The one output of a function, whose inputs are given in order."""
        found = self._one[name](*arrays.values())
        if found is None:
            (out,) = CALLS[name].outputs
            found = self.evaluate(name, **arrays)[out]
        return found


def compile(
    equations: Equations,
    *,
    compiler: str | None = "auto",
    flags: str = FLAGS[0],
    form: str = "auto",
    fixed: Mapping[str, Any] | None = None,
    outputs: Sequence[str] | None = None,
    reciprocals: bool = True,
) -> Model:
    """Compile equations of motion.

    Graphs and machine code are made when they are first used; what is not used is not derived.

    Parameters
    ----------
    equations : Equations
        M, f, the residual and the reactions of a scene that is too large to be written out are
        those of rows conjugate to u, whatever the route.
    compiler : str or None
        Path or name of a C compiler; ``"auto"`` looks for one ($CC, cc, gcc, clang); None uses
        CasADi's virtual machine.
    flags : str
        Settings of the compiler. ``"-O2"`` rounds every operation as it is written;
        ``"-O3 -march=native"`` does too, faster on this machine only; with ``-ffast-math`` sums are
        reordered, and NaN and infinity are no longer reported.
    form : str
        Of forward dynamics: the name of one of `mechanics.compiled.FORMS`; ``"auto"`` takes the one
        that suits the equations best.
    fixed : mapping of str to number, optional
        Parameters that are numbers from here on: ``{"g": 9.81, "c": 0}``. A float is the decimal
        that was typed, 981/100; a text may be a fraction. Terms with a zero factor are dropped.
    outputs : sequence of str, optional
        The functions to have, such as ``("forward_dynamics", "energy")``; by default all.
    reciprocals : bool
        Whether quotients by one divisor are gathered where they are added, and several are products
        with its reciprocal: fewer divisions, each product off by at most 1.5 units in the last
        place instead of 0.5.

    Raises
    ------
    InputError
        If there is no such form, parameter or output, the equations have no such form, or a value
        is no number, negative where it must not be, or a divisor that is zero.
    SingularError
        If the equations do not determine the accelerations at the fixed values.
    """
    wanted(equations, Equations, "compile", "pass derive(scene, route)")
    found = find_compiler() if compiler == "auto" else compiler
    table = read_fixed(equations.scene, fixed or {})
    graphs = Graphs(equations, form, table, outputs)
    return Model(equations, graphs, found, Programs(graphs, reciprocals), flags)
