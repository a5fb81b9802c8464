"""Transfer functions and closed loops in s.

D(s) X = E(s) W,   D(s) = M s^2 + C s + K
X_i / W_j = (adj D E)_ij / det D                               transfer function
w = - L_0 x - L_1 x' + R r:   K + E L_0,  C + E L_1,  input E R    closed loop
"""

from collections.abc import Mapping

from sympy import Expr, Matrix, Symbol

from mechanics.errors import InputError
from mechanics.linear.algebra import is_zero, reduced
from mechanics.linear.form import Linear

S_PLANE = Symbol("s")


def transfer_function(linear: Linear, output: str, given: str, s: Symbol = S_PLANE) -> Expr:
    """Transfer function from an input to a coordinate, from rest, common factors cancelled.

    Parameters
    ----------
    linear : Linear
    output, given : str
        Names of an independent coordinate and of an input.
    s : Symbol
        Variable of the Laplace transform.

    Raises
    ------
    InputError
        If there is no coordinate or input of that name.
    SingularError
        If det D(s) vanishes identically.
    """
    row, column = linear.coordinate_index(output), linear.input_index(given)
    stiffness = linear.dynamic_stiffness(s)
    adjugate = stiffness.adjugate(method="berkowitz")
    above = (adjugate * linear.input_polynomial(s))[row, column]
    return reduced(above / stiffness.det(method="berkowitz"))


def characteristic_polynomial(linear: Linear, s: Symbol = S_PLANE) -> Expr:
    """det(M s^2 + C s + K), expanded."""
    return linear.dynamic_stiffness(s).det(method="berkowitz").expand()


def close_loop(
    linear: Linear, law: Mapping[str | Expr, Expr], references: tuple[Symbol, ...] = ()
) -> Linear:
    """Let inputs follow a feedback law; references become inputs, the other inputs stay.

    Parameters
    ----------
    linear : Linear
    law : mapping
        For inputs, by name or symbol, what they are made: ``{f: K * (theta_d - theta)}``, linear in
        deviations of coordinates and their rates (dynamic or plain symbols) and in references.
    references : tuple of Symbol
        Plain symbols of the desired values.

    Raises
    ------
    InputError
        If an input is unknown or enters by its derivatives, or the law is not linear or does not
        vanish in the equilibrium.
    """
    states = linear.state_symbols
    known = (*states, *references)
    size = len(linear.coordinates)
    stiffness, damping = linear.stiffness, linear.damping
    drive = linear.input_matrices[0]
    closed = {}
    for given, expression in law.items():
        name = given if isinstance(given, str) else str(linear.scene.plain(given))
        j = linear.input_index(name)
        _enters_directly(linear, j, name)
        row = _gradient(linear, name, linear.scene.plain(expression), known)
        stiffness = stiffness - drive.col(j) * row[:, :size]
        damping = damping - drive.col(j) * row[:, size : 2 * size]
        closed[j] = row[:, 2 * size :]
    referred = Matrix.zeros(size, len(references))
    for j, row in closed.items():
        referred += drive.col(j) * row
    kept = [j for j in range(len(linear.inputs)) if j not in closed]
    drives = {"inputs 0": referred.row_join(drive.extract(list(range(size)), kept))}
    for order, matrix in enumerate(linear.input_matrices[1:], 1):
        zero = Matrix.zeros(size, len(references))
        drives[f"inputs {order}"] = zero.row_join(matrix.extract(list(range(size)), kept))
    return linear.with_matrices(
        (*references, *(linear.inputs[j] for j in kept)),
        stiffness=stiffness.applyfunc(reduced),
        damping=damping.applyfunc(reduced),
        **drives,
    )


def _enters_directly(linear: Linear, j: int, name: str) -> None:
    if any(not is_zero(entry) for m in linear.input_matrices[1:] for entry in m.col(j)):
        raise InputError(
            f"{linear.scene.name}: input {name} enters by its derivatives, a prescribed motion:"
            " feedback closes on forces and torques"
        )


def _gradient(linear: Linear, name: str, law: Expr, known: tuple[Symbol, ...]) -> Matrix:
    """Row of coefficients of a law that is linear and homogeneous in the known symbols."""
    row = Matrix([[law.diff(symbol) for symbol in known]])
    inside = set().union(*(entry.free_symbols for entry in row))
    homogeneous = sum(c * symbol for c, symbol in zip(row, known, strict=True))
    if inside & set(known) or not is_zero(law - homogeneous):
        raise InputError(
            f"{linear.scene.name}: the law for {name} is {law}, which is not linear in"
            f" {', '.join(symbol.name for symbol in known)} or does not vanish with them:"
            " write it in deviations from the equilibrium"
        )
    return row
