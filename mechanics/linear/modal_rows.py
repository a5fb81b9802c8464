"""Rows about natural modes and the dimensionless eigenvalue problem.

K a = Lambda M a,  Lambda = omega^2:    in a mode, Lambda a = M^-1 K a
"""

from collections.abc import Callable, Sequence

from sympy import Dummy, Expr, Matrix, S, Symbol, cos, diag, sin, sqrt

from mechanics.errors import InputError
from mechanics.kernel import Finding, undecided
from mechanics.linear.algebra import reduced
from mechanics.linear.case import Case, Pairs, compare, numbers, require_conjugate
from mechanics.linear.dimensionless import dimensionless
from mechanics.linear.modes import Convention, Modes, characteristic, modes
from mechanics.linear.printed_decimals import check_rounded
from mechanics.scene.linear_quantities import (
    BackSubstitution,
    CharacteristicPolynomial,
    DimensionlessMatrices,
    DimensionlessParameter,
    DimensionlessProblem,
    Eigenvalue,
    EigenvalueProblem,
    LinearQuantity,
    ModalMatrix,
    ModeShape,
    PrintedEigenvalues,
    PrintedShapes,
    TrialSolution,
)
from mechanics.scene.symbols import entries
from mechanics.symbolic import Arithmetic

Check = Callable[[Case], Finding]


def trial_solution(case: Case) -> Finding:
    """x'' = -omega^2 x from x = a sin phi, x' = omega a cos phi; and every mode is a solution."""
    quantity: TrialSolution = case.quantity
    t, omega, phase = quantity.time, quantity.omega, quantity.phase
    amplitudes = Matrix(quantity.amplitudes)
    (side,) = case.forms()
    x = Matrix(entries(side))
    if x.rows != amplitudes.rows:
        raise InputError(f"{case.subject}: {x.rows} entries typed, {amplitudes.rows} amplitudes")
    velocity, acceleration = x.diff(t), x.diff(t, 2)
    pairs = [
        *zip(acceleration, -(omega**2) * x, strict=True),
        *zip(x.subs(t, 0), amplitudes * sin(phase), strict=True),
        *zip(velocity.subs(t, 0), omega * amplitudes * cos(phase), strict=True),
    ]
    linear, found = case.linear, modes(case.linear)
    for j, value in enumerate(found.eigenvalues):
        motion = dict(zip(amplitudes, found.shapes.col(j), strict=True)) | {omega: sqrt(value)}
        left = linear.mass * acceleration.subs(motion) + linear.stiffness * x.subs(motion)
        pairs += [(entry, S.Zero) for entry in left]
    return case.decide(lambda a: [(a.value(one), a.value(two)) for one, two in pairs])


def eigenvalue_problem(case: Case) -> Finding:
    """The typed equation where omega^2 a = M^-1 K a."""
    quantity: EigenvalueProblem = case.quantity
    linear = case.linear
    return _pencil(
        case, linear.stiffness, linear.mass, quantity.amplitudes, quantity.omega, power=2
    )


def dimensionless_problem(case: Case) -> Finding:
    """The typed equation where lambda a = M'^-1 K' a."""
    quantity: DimensionlessProblem = case.quantity
    form = dimensionless(case.linear)
    return _pencil(
        case, form.stiffness, form.mass, quantity.amplitudes, quantity.parameter, power=1
    )


def dimensionless_matrices(case: Case) -> Finding:
    """The two typed matrices, as the equation K' a = lambda M' a."""
    form = dimensionless(case.linear)
    n = form.mass.rows
    stiffness, mass = (Matrix(n, n, entries(side)) for side in case.forms())
    amplitudes, products = _symbols("a", n), _symbols("b", n)
    a_typed, b_typed = stiffness * Matrix(amplitudes), mass * Matrix(products)

    def experiment(a: Arithmetic) -> Pairs:
        _put_products(a, form.stiffness, form.mass, amplitudes, products)
        rank = a.rank(numbers(a, mass))
        return [*compare(a, list(a_typed), list(b_typed)), (a.rational(rank), a.rational(n))]

    return case.decide(experiment)


def _pencil(
    case: Case,
    stiffness: Matrix,
    mass: Matrix,
    amplitudes: Sequence[Symbol],
    symbol: Symbol,
    power: int,
) -> Finding:
    """An equation linear in a and Lambda a, at Lambda a = M^-1 K a (Lambda = symbol^power)."""
    left, right = case.equation()
    products = _symbols("b", len(amplitudes))
    lefts = [_with_products(case, e, amplitudes, products, symbol, power) for e in left]
    rights = [_with_products(case, e, amplitudes, products, symbol, power) for e in right]

    def experiment(a: Arithmetic) -> Pairs:
        _put_products(a, stiffness, mass, amplitudes, products)
        return compare(a, lefts, rights)

    return case.holds(experiment, amplitudes)


def _with_products(
    case: Case,
    entry: Expr,
    amplitudes: Sequence[Symbol],
    products: Sequence[Symbol],
    symbol: Symbol,
    power: int,
) -> Expr:
    """The entry with the products symbol^power * a_i as symbols of their own."""
    polynomial = entry.expand().as_poly(symbol, *amplitudes)
    if polynomial is None:
        raise InputError(f"{case.subject}: {entry} is no polynomial in {symbol} and amplitudes")
    total = S.Zero
    for (order, *places), coefficient in polynomial.terms():
        if order not in (0, power) or sum(places) > 1:
            raise InputError(
                f"{case.subject}: {entry} is not linear in the amplitudes and {symbol**power}"
            )
        # Without an amplitude a term is a force that no free vibration has: it stays.
        chosen = products if order else amplitudes
        factor = chosen[places.index(1)] if 1 in places else symbol**order
        total += coefficient * factor
    return total


def _put_products(
    a: Arithmetic,
    stiffness: Matrix,
    mass: Matrix,
    amplitudes: Sequence[Symbol],
    products: Sequence[Symbol],
) -> None:
    forces = stiffness * Matrix(amplitudes)
    solved = a.solve(numbers(a, mass), [a.value(entry) for entry in forces])
    for symbol, number in zip(products, solved, strict=True):
        a.assign(symbol, number)


def _symbols(name: str, n: int) -> list[Symbol]:
    return [Dummy(f"{name}_{i + 1}", real=True) for i in range(n)]


def characteristic_polynomial(case: Case) -> Finding:
    """The typed polynomial in omega against det(K - omega^2 M)."""
    quantity: CharacteristicPolynomial = case.quantity
    square = Dummy("Lambda")
    require_conjugate(case.linear)
    derived = characteristic(case.linear, square).xreplace({square: quantity.omega**2})
    return case.equal(derived)


def eigenvalue(case: Case) -> Finding:
    """The typed omega^2 against the derived one."""
    quantity: Eigenvalue = case.quantity
    found = modes(case.linear)
    return case.equal(found.eigenvalues[_mode(case, found, quantity.mode)])


def back_substitution(case: Case) -> Finding:
    """The typed equation where a is any multiple of the mode shape; its rank is that derived."""
    quantity: BackSubstitution = case.quantity
    found = modes(case.linear)
    j = _mode(case, found, quantity.mode)
    left, right = case.equation()
    value, size = found.eigenvalues[j], Dummy("c", real=True)
    shape = size * found.shapes.col(j)

    def experiment(a: Arithmetic) -> Pairs:
        for symbol, entry in zip(quantity.amplitudes, shape, strict=True):
            a.assign(symbol, a.value(entry))
        return compare(a, left, right)

    repeated = sum(reduced(other - value) == 0 for other in found.eigenvalues)
    return case.holds(experiment, quantity.amplitudes, len(left) - repeated)


def mode_shape(case: Case) -> Finding:
    """The typed shape against the derived one, scaled alike or up to a factor."""
    quantity: ModeShape = case.quantity
    found = modes(case.linear)
    shape = found.shapes.col(_mode(case, found, quantity.mode))
    if quantity.scaled:
        return case.equal(shape)
    (side,) = case.forms()
    typed = entries(side)
    if all(entry == 0 for entry in typed):
        return undecided(case.subject, "a shape of zeros is a multiple of any")
    n = len(typed)
    pairs = [(typed[i] * shape[j], typed[j] * shape[i]) for i in range(n) for j in range(i)]
    return case.decide(lambda a: [(a.value(one), a.value(two)) for one, two in pairs])


def modal_matrix(case: Case) -> Finding:
    """The typed modal matrix against the derived one."""
    return case.equal(modes(case.linear).shapes)


def dimensionless_parameter(case: Case) -> Finding:
    """The typed lambda against the group that was found."""
    quantity: DimensionlessParameter = case.quantity
    return case.equal(dimensionless(case.linear).parameter(quantity.omega))


def printed_eigenvalues(case: Case) -> Finding:
    """Typed decimals against enclosures of lambda = group * omega^2."""
    quantity: PrintedEigenvalues = case.quantity
    found = modes(case.linear, _convention(quantity.largest_first))
    group = dimensionless(case.linear).group
    derived = diag(*(reduced(group * value) for value in found.eigenvalues))
    return check_rounded(case, [list(derived)])


def printed_shapes(case: Case) -> Finding:
    """Typed decimals against enclosures of the unit shapes; the sign of a column is free."""
    quantity: PrintedShapes = case.quantity
    found = modes(case.linear, Convention.MATLAB).shapes
    if not quantity.largest_first:
        found = found[:, ::-1]
    columns = [list(found.col(j)) for j in range(found.cols)]
    return check_rounded(case, columns, free_signs=True)


def _convention(largest_first: bool) -> Convention:
    return Convention.MATLAB if largest_first else Convention.ENGINEERING


def _mode(case: Case, found: Modes, mode: int) -> int:
    if not 1 <= mode <= len(found.eigenvalues):
        raise InputError(f"{case.subject}: there is no mode {mode}")
    return mode - 1


CHECKS: dict[type[LinearQuantity], Check] = {
    TrialSolution: trial_solution,
    EigenvalueProblem: eigenvalue_problem,
    CharacteristicPolynomial: characteristic_polynomial,
    Eigenvalue: eigenvalue,
    BackSubstitution: back_substitution,
    ModeShape: mode_shape,
    ModalMatrix: modal_matrix,
    DimensionlessProblem: dimensionless_problem,
    DimensionlessParameter: dimensionless_parameter,
    DimensionlessMatrices: dimensionless_matrices,
    PrintedEigenvalues: printed_eigenvalues,
    PrintedShapes: printed_shapes,
}
