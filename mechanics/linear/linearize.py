"""Linearization about an operating point that is first proved to be an equilibrium.

    M u' = f + B lambda,  A u' = b,  q' = N u         at rest: u = u' = 0,  f + B lambda_0 = 0

    Y^T B = 0,  A N^-1 G = 0,  q - q_0 = G x,  u = N^-1 G x'

    (Y^T M N^-1 G) x'' - (Y^T df/du N^-1 G) x' - (Y^T d(f + B lambda_0)/dq G) x = Y^T df/dw w

Y is N^-1 G where the rows are power-conjugate to u: the result is then conjugate to x'.
Terms of second order (u times x, changes of M, N, A and G) are left out. With constraints, G spans
the deviations that they admit to first order.
"""

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from sympy import Abs, Expr, Matrix, Symbol, eye, sign, sympify

from mechanics.compiled.bordered import bind
from mechanics.equations import Equations
from mechanics.errors import InputError, wanted
from mechanics.kinematics.printer import symbols
from mechanics.linear.algebra import independent_rows, inverse, is_zero, null_space, reduced
from mechanics.linear.form import Linear
from mechanics.mechanism import name_of
from mechanics.program.sympy_printer import expressions
from mechanics.reading.kinds import angular
from mechanics.routes.rows import acceleration_forms, coefficients
from mechanics.scene import Scene
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS

Values = Mapping[str | Expr, Expr | int]


@dataclass(frozen=True)
class Rest:
    """What the symbols are at the operating point: q_0, w_0, and zero for every rate."""

    point: dict[Symbol, Expr]
    table: dict[Symbol, Expr]

    def of(self, expression: Expr) -> Expr:
        """Value of an expression there."""
        return reduced(sympify(expression).xreplace(self.table))

    def gradient(self, column: Sequence[Expr], symbols: Sequence[Symbol]) -> Matrix:
        """Derivatives of the entries by the symbols, there."""
        rows = list(column)
        return Matrix(
            len(rows), len(symbols), lambda i, j: self.of(sympify(rows[i]).diff(symbols[j]))
        )


def linearize(
    equations: Equations,
    at: Values,
    inputs: Values | None = None,
    parameters: Mapping[Symbol, Expr] | None = None,
) -> Linear:
    """Linearize equations of motion about an equilibrium.

    Parameters
    ----------
    equations : Equations
        By any route.
    at : mapping
        A value for every coordinate, by name, dynamic symbol or plain symbol.
    inputs : mapping, optional
        A value for every input of the scene.
    parameters : mapping of Symbol to Expr, optional
        Relations between parameters that hold there, ``{l3: l1}`` for a parallelogram.

    Returns
    -------
    Linear

    Raises
    ------
    InputError
        If a value is missing, a name unknown, a constraint broken, or the point is no equilibrium:
        the message gives the force that is left over.
    ExpressionError
        If it cannot be told whether the point is an equilibrium.
    """
    wanted(equations, Equations, "linearize", "pass derive(scene, route)")
    scene = equations.scene
    rest = _rest(scene, at, inputs or {}, parameters or {})
    _placed(scene, rest)
    return _expand(equations, rest)


def _rest(scene: Scene, at: Values, inputs: Values, parameters: Mapping[Symbol, Expr]) -> Rest:
    point = _complete(scene, "coordinate", scene.q, at)
    point |= _complete(scene, "input", scene.input_symbols, inputs)
    still: tuple[Symbol, ...] = (*scene.u, *scene.ud, *scene.qd)
    table = {symbol: sympify(0) for symbol in still}
    for symbol in scene.input_symbols:
        table.update({rate: sympify(0) for rate in _rates(symbol)})
    known = dict(parameters)
    values = {symbol: value.subs(known) for symbol, value in point.items()}
    return Rest(values, {**known, **table, **values})


def _complete(
    scene: Scene, kind: str, symbols: Sequence[Symbol], given: Values
) -> dict[Symbol, Expr]:
    """The given values by plain symbol: one for every symbol, and for no other."""
    values: dict[Symbol, Expr] = {}
    names = {symbol.name: symbol for symbol in symbols}
    for key, value in given.items():
        name = key if isinstance(key, str) else str(scene.plain(key, "operating point"))
        if name not in names:
            raise InputError(
                f"{scene.name}: {name!r} is no {kind}: there are {', '.join(names) or 'none'}"
            )
        values[names[name]] = sympify(value, rational=True)
    for symbol in symbols:
        if symbol not in values:
            raise InputError(
                f"{scene.name}: the operating point gives no value for {kind} {symbol}:"
                " give one for each, zero if that is meant"
            )
    return values


def _rates(symbol: Symbol) -> list[Symbol]:
    return [Symbol(symbol.name + dots, real=True) for dots in DOTS[1:]]


def _placed(scene: Scene, rest: Rest) -> None:
    """The point satisfies the constraints, and nothing moves or changes with time there."""
    for name, expression in (
        *((f"the rate {qd}", scene.coordinate_rates[qd]) for qd in scene.qd),
        *((f"constraint {c.name}", scene.plain(c.expression)) for c in scene.constraints),
    ):
        left = rest.of(expression)
        if not is_zero(left):
            raise InputError(
                f"{scene.name}: {name} is {left} at the operating point, not zero: give"
                " coordinates that satisfy the constraints, exactly"
            )


@dataclass(frozen=True)
class Slopes:
    """The equations at the operating point, to first order.

    Attributes
    ----------
    mass, reactions, constraints : Matrix
        M, B and A there.
    forcing : Matrix
        f there, which the reactions balance.
    by_speeds : Matrix
        df/du.
    by_coordinates : callable
        d(f + B lambda)/dq at given multipliers.
    by_inputs : list of Matrix
        df/dw, df/dw', ...
    kinematic : Matrix
        N: of the rates of the coordinates by the speeds.
    """

    mass: Matrix
    reactions: Matrix
    constraints: Matrix
    forcing: Matrix
    by_speeds: Matrix
    by_coordinates: Callable[[Matrix], Matrix]
    by_inputs: list[Matrix]
    kinematic: Matrix


def _written(equations: Equations, rest: Rest) -> Slopes:
    """Slopes of matrices in SymPy."""
    scene, forcing = equations.scene, equations.forcing
    if any(sympify(entry).has(TIME) for entry in forcing):
        raise _timed(scene)
    _smooth(equations, rest)
    orders = [scene.input_symbols]
    orders += [tuple(_rates(w)[k] for w in scene.input_symbols) for k in range(len(DOTS) - 1)]
    rates = [scene.coordinate_rates[qd] for qd in scene.qd]

    def by_coordinates(multipliers: Matrix) -> Matrix:
        whole = forcing
        if equations.multipliers:
            whole = forcing + equations.reaction_matrix * multipliers
        return rest.gradient(whole, scene.q)

    return Slopes(
        mass=equations.mass.applyfunc(rest.of),
        reactions=equations.reaction_matrix.applyfunc(rest.of),
        constraints=equations.constraint_matrix.applyfunc(rest.of),
        forcing=forcing.applyfunc(rest.of),
        by_speeds=rest.gradient(forcing, scene.u),
        by_coordinates=by_coordinates,
        by_inputs=[rest.gradient(forcing, symbols) for symbols in orders],
        kinematic=rest.gradient(rates, scene.u),
    )


def _derived(equations: Equations, rest: Rest) -> Slopes:
    """Slopes of a program, by its exact derivatives."""
    scene, (mechanism, route) = equations.scene, equations.program
    if scene.explicit_time:
        raise _timed(scene)
    for friction in mechanism.frictions:
        raise InputError(
            f"{scene.name}: load {friction.name} has no slope at the operating point: nothing"
            " is linear there; linearize a scene without this friction"
        )
    build, rows = mechanism.builder, route.values
    orders = [
        [build.input(w.name + dots) for w in scene.input_symbols] for dots in DOTS
    ]  # fmt: skip
    groups = {
        "mass": (rows, mechanism.ud),
        "reactions": (rows, route.multipliers),
        "speeds": (rows, mechanism.u),
        "coordinates": (rows, mechanism.q),
        "constraints": (acceleration_forms(mechanism), mechanism.ud),
        "kinematic": (mechanism.q_rates, mechanism.u),
        **{f"inputs {k}": (rows, order) for k, order in enumerate(orders)},
    }
    nodes = {name: coefficients(*pair) for name, pair in groups.items()}
    outputs = {name: [entry for row in matrix for entry in row] for name, matrix in nodes.items()}
    outputs["rows"] = list(rows)
    program = build.program(outputs)
    values = {s.name: v for s, v in rest.table.items() if not sympify(v).free_symbols}
    other, bound = bind(program, {n: v for n, v in values.items() if n in program.inputs})
    names = {**symbols(scene), **{s.name: v for s, v in rest.table.items()}}
    found = expressions(other.program(bound), names, limit=sys.maxsize)
    matrices = {
        name: Matrix(len(pair[0]), len(pair[1]), found[name]) for name, pair in groups.items()
    }
    multipliers = [names[name_of(node)] for node in route.multipliers]
    still = dict.fromkeys(multipliers, sympify(0))

    def by_coordinates(static: Matrix) -> Matrix:
        at = dict(zip(multipliers, static, strict=True))
        return -matrices["coordinates"].xreplace(at)

    return Slopes(
        mass=matrices["mass"],
        reactions=-matrices["reactions"],
        constraints=matrices["constraints"],
        forcing=-Matrix(len(rows), 1, found["rows"]).xreplace(still),
        by_speeds=-matrices["speeds"],
        by_coordinates=by_coordinates,
        by_inputs=[-matrices[f"inputs {k}"] for k in range(len(orders))],
        kinematic=matrices["kinematic"],
    )


def _timed(scene: Scene) -> InputError:
    return InputError(
        f"{scene.name}: the forces depend on time itself, so that nothing is an equilibrium:"
        " declare what changes as an input"
    )


def _expand(equations: Equations, rest: Rest) -> Linear:
    scene = equations.scene
    if equations.textbook is None:
        slopes = _derived(equations, rest)
    else:
        slopes = _written(equations, rest)
    kinematic, constraint = inverse(slopes.kinematic), slopes.constraints
    if constraint.rows:
        reach, free = null_space((constraint * kinematic).applyfunc(reduced))
    else:
        reach, free = eye(len(scene.q)), tuple(range(len(scene.q)))
    speeds = kinematic * reach
    conjugate = equations.conjugate and slopes.mass.rows == len(scene.u)
    still = slopes.reactions
    # Rows conjugate to u, projected on the admitted speeds, are conjugate to x'.
    left = speeds.T if conjugate else null_space(still.T)[0].T
    static = _static(equations, rest, left, slopes, free if conjugate else ())

    def projected(matrix: Matrix) -> Matrix:
        return (left * matrix).applyfunc(reduced)

    drives = [projected(matrix) for matrix in slopes.by_inputs]
    while len(drives) > 1 and drives[-1].is_zero_matrix:
        drives.pop()
    return Linear(
        scene=scene,
        route=equations.route,
        point=rest.point,
        coordinates=tuple(scene.q[j] for j in free),
        inputs=scene.input_symbols,
        mass=projected(slopes.mass * speeds),
        damping=projected(-slopes.by_speeds * speeds),
        stiffness=projected(-slopes.by_coordinates(static) * reach),
        input_matrices=tuple(drives),
        reach=reach,
        conjugate=conjugate,
    )


def _smooth(equations: Equations, rest: Rest) -> None:
    """Refuse a point at which a load jumps, as friction does at rest."""
    for entry in equations.forcing:
        for kink in sorted(sympify(entry).atoms(sign, Abs), key=str):
            if is_zero(rest.of(kink.args[0])) is not False:
                raise InputError(
                    f"{equations.scene.name}: {kink} has no slope at the operating point: nothing"
                    " is linear there; linearize a scene without the friction that it comes from"
                )


def _static(
    equations: Equations, rest: Rest, left: Matrix, slopes: Slopes, moved: Sequence[int]
) -> Matrix:
    """Return the static reactions lambda_0; refuse a point out of balance.

    Rows are the forces on the coordinates that are `moved`, where these are given.
    """
    scene, turning = equations.scene, angular(equations.scene)
    out_of_balance = (left * slopes.forcing).applyfunc(reduced)
    for row, entry in enumerate(out_of_balance, 1):
        if not is_zero(entry):
            units = {q: " rad" if q in turning else " m" for q in scene.q}
            place = ", ".join(f"{s} = {value}{units.get(s, '')}" for s, value in rest.point.items())
            left_over = f"row {row} of the equations at rest leaves {entry}"
            if moved:
                q = scene.q[moved[row - 1]]
                torque = q in turning
                left_over = (
                    f"the {'torque' if torque else 'force'} on {q} at rest is"
                    f" {entry} {'N m' if torque else 'N'}"
                )
            raise InputError(
                f"{scene.name}: {place} is no equilibrium: {left_over}, not zero"
                f" ({equations.route})"
            )
    still = slopes.reactions
    if not still.cols:
        return Matrix(0, 1, [])
    rows = list(independent_rows(still))
    return -inverse(still.extract(rows, list(range(still.cols)))) * slopes.forcing.extract(
        rows, [0]
    )
