"""Linearisation about an operating point that is first proved to be an equilibrium.

    M u' = f + B lambda,  A u' = b,  q' = N u         at rest: u = u' = 0,  f + B lambda_0 = 0

    Y^T B = 0,  A N^-1 G = 0,  q - q_0 = G x,  u = N^-1 G x'

    (Y^T M N^-1 G) x'' - (Y^T df/du N^-1 G) x' - (Y^T d(f + B lambda_0)/dq G) x = Y^T df/dw w

Y is N^-1 G where the rows are power-conjugate to u: the result is then conjugate to x'.
Terms of second order (u times x, changes of M, N, A and G) are left out. With constraints, G spans
the deviations that they admit to first order.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sympy import Abs, Expr, Matrix, Symbol, eye, sign, sympify

from mechanics.equations import Equations
from mechanics.errors import InputError, wanted
from mechanics.linear.algebra import independent_rows, inverse, is_zero, null_space, reduced
from mechanics.linear.form import Linear
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


def linearise(
    equations: Equations,
    at: Values,
    inputs: Values | None = None,
    parameters: Mapping[Symbol, Expr] | None = None,
) -> Linear:
    """Linearise equations of motion about an equilibrium.

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
    wanted(equations, Equations, "linearise", "pass derive(scene, route)")
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


def _expand(equations: Equations, rest: Rest) -> Linear:
    scene = equations.scene
    if any(sympify(entry).has(TIME) for entry in equations.forcing):
        raise InputError(
            f"{scene.name}: the forces depend on time itself, so that nothing is an equilibrium:"
            " declare what changes as an input"
        )
    _smooth(equations, rest)
    kinematic = inverse(rest.gradient([scene.coordinate_rates[qd] for qd in scene.qd], scene.u))
    constraint = equations.constraint_matrix.applyfunc(rest.of)
    if constraint.rows:
        reach, free = null_space((constraint * kinematic).applyfunc(reduced))
    else:
        reach, free = eye(len(scene.q)), tuple(range(len(scene.q)))
    speeds = kinematic * reach
    conjugate = equations.conjugate and equations.mass.rows == len(scene.u)
    still = equations.reaction_matrix.applyfunc(rest.of)
    # Rows conjugate to u, projected on the admitted speeds, are conjugate to x'.
    left = speeds.T if conjugate else null_space(still.T)[0].T
    forcing = _static(equations, rest, left, still)

    def projected(matrix: Matrix) -> Matrix:
        return (left * matrix).applyfunc(reduced)

    orders = [scene.input_symbols]
    orders += [tuple(_rates(w)[k] for w in scene.input_symbols) for k in range(len(DOTS) - 1)]
    drives = [projected(rest.gradient(forcing, symbols)) for symbols in orders]
    while len(drives) > 1 and drives[-1].is_zero_matrix:
        drives.pop()
    return Linear(
        scene=scene,
        route=equations.route,
        point=rest.point,
        coordinates=tuple(scene.q[j] for j in free),
        inputs=scene.input_symbols,
        mass=projected(equations.mass.applyfunc(rest.of) * speeds),
        damping=projected(-rest.gradient(forcing, scene.u) * speeds),
        stiffness=projected(-rest.gradient(forcing, scene.q) * reach),
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
                    " is linear there; linearise a scene without the friction that it comes from"
                )


def _static(equations: Equations, rest: Rest, left: Matrix, still: Matrix) -> Matrix:
    """Return f + B lambda_0 with the static reactions; refuse a point out of balance."""
    forcing = equations.forcing
    out_of_balance = (left * forcing.applyfunc(rest.of)).applyfunc(reduced)
    for row, entry in enumerate(out_of_balance, 1):
        if not is_zero(entry):
            place = ", ".join(f"{symbol} = {value}" for symbol, value in rest.point.items())
            raise InputError(
                f"{equations.scene.name}: {place} is no equilibrium: row {row} of the equations"
                f" ({equations.route}) at rest leaves {entry}, not zero"
            )
    if not equations.multipliers:
        return forcing
    rows = list(independent_rows(still))
    static = -inverse(still.extract(rows, list(range(still.cols)))) * Matrix(
        [rest.of(forcing[i]) for i in rows]
    )
    return forcing + equations.reaction_matrix * static
