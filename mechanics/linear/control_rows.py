"""Rows about the linear equations, transfer functions, feedback and stability.

M x'' = E w - C x' - K x,    D(s) X = E(s) W,    w = gain (reference - output)
"""

from collections.abc import Callable, Mapping
from dataclasses import replace

from sympy import Abs, Expr, Matrix, Symbol
from sympy.core.relational import Relational

from mechanics.errors import InputError
from mechanics.kernel import Finding, undecided
from mechanics.kinematics.symbolic import Kinematics
from mechanics.linear.algebra import coefficients, sign
from mechanics.linear.case import Case, Pairs, compare, numbers, require_conjugate
from mechanics.linear.form import Linear
from mechanics.linear.stability import (
    coefficient_ratios,
    conditions,
    stability,
    stability_region,
)
from mechanics.linear.transfer import characteristic_polynomial, transfer_function
from mechanics.scene import RigidBody
from mechanics.scene.linear_quantities import (
    EquilibriumStability,
    FeedbackLaw,
    InertiaAbout,
    LinearizedEquation,
    LinearQuantity,
    PoleEquation,
    StabilityBoundary,
    StabilityRegion,
    TransferFunction,
    TransformedEquation,
)
from mechanics.scene.places import point_named
from mechanics.scene.symbols import plain_symbol
from mechanics.symbolic import Arithmetic, decide

Check = Callable[[Case], Finding]


def linearized(case: Case) -> Finding:
    """The typed equation at the accelerations of the linear equations."""
    linear = case.linear
    left, right = case.equation()
    n = len(linear.coordinates)
    rates = [plain_symbol(q, 2) for q in case.scene.coordinates]
    accelerations = [rates[case.scene.q.index(q)] for q in linear.coordinates]
    state = Matrix(linear.state_symbols)
    forces = _drive(linear) - linear.stiffness * state[:n, :] - linear.damping * state[n:, :]

    def experiment(a: Arithmetic) -> Pairs:
        found = a.solve(numbers(a, linear.mass), [a.value(entry) for entry in forces])
        for symbol, number in zip(accelerations, found, strict=True):
            a.assign(symbol, number)
        return compare(a, left, right)

    return case.holds(experiment, accelerations)


def _drive(linear: Linear) -> Matrix:
    """E_0 w + E_1 w' + ... with the inputs and their rates as symbols."""
    total = Matrix.zeros(len(linear.coordinates), 1)
    dots = ("", "_dot", "_ddot", "_dddot")
    for matrix, suffix in zip(linear.input_matrices, dots, strict=False):
        column = [Symbol(w.name + suffix, real=True) for w in linear.inputs]
        if column:
            total += matrix * Matrix(column)
    return total


def inertia_about(case: Case) -> Finding:
    """The typed inertia against the parallel-axis theorem and against the linear equation."""
    quantity: InertiaAbout = case.quantity
    require_conjugate(case.linear)
    j = case.linear.coordinate_index(quantity.coordinate)
    return case.equal(parallel_axis(case.linear, quantity), case.linear.mass[j, j])


def parallel_axis(linear: Linear, quantity: InertiaAbout) -> Expr:
    """I_C + M r^2 about the normal z of the plane, at the operating point."""
    scene = linear.scene
    body = scene.body(quantity.body)
    point = dict(linear.point)
    arm = scene.position(body.centre) - scene.position(point_named(scene, quantity.about))
    arm = arm.xreplace(point)
    total = body.mass * (arm[0] ** 2 + arm[1] ** 2)
    if isinstance(body, RigidBody):
        total += Kinematics(scene).bodies[body.name].inertia[2, 2].xreplace(point)
    return total


def transformed(case: Case) -> Finding:
    """The typed equation at the images that solve D(s) X = E(s) W."""
    quantity: TransformedEquation = case.quantity
    linear = case.closed(quantity.feedback)
    images, s = dict(quantity.laplace.images), quantity.laplace.s
    unknowns = [_image(case, images, q) for q in linear.coordinates]
    given = [_image(case, images, w) for w in linear.inputs]
    left, right = case.equation()
    forces = linear.input_polynomial(s) * Matrix(given)

    def experiment(a: Arithmetic) -> Pairs:
        stiffness = numbers(a, linear.dynamic_stiffness(s))
        found = a.solve(stiffness, [a.value(entry) for entry in forces])
        for symbol, number in zip(unknowns, found, strict=True):
            a.assign(symbol, number)
        return compare(a, left, right)

    return case.holds(experiment, unknowns)


def _image(case: Case, images: Mapping[str, Symbol], symbol: Symbol) -> Symbol:
    if symbol.name not in images:
        raise InputError(f"{case.subject}: {symbol} has no image in the s-domain: add one")
    return images[symbol.name]


def transfer(case: Case) -> Finding:
    """The typed ratio against the derived transfer function."""
    quantity: TransferFunction = case.quantity
    linear = case.closed(quantity.feedback)
    return case.equal(transfer_function(linear, quantity.output, quantity.given, quantity.s))


def feedback_law(case: Case) -> Finding:
    """The typed law where the input is gain times error."""
    quantity: FeedbackLaw = case.quantity
    loop = quantity.feedback
    images = dict(quantity.laplace.images) if quantity.laplace else {}
    given = Symbol(loop.input, real=True)
    output = Symbol(loop.output, real=True)
    if images:
        given, output, reference = (
            _image(case, images, symbol) for symbol in (given, output, loop.reference)
        )
    else:
        reference = loop.reference
    left, right = case.equation()

    def experiment(a: Arithmetic) -> Pairs:
        a.assign(given, a.value(loop.gain) * (a.value(reference) - a.value(output)))
        return compare(a, left, right)

    return case.holds(experiment, [given])


def pole_equation(case: Case) -> Finding:
    """The typed equation in s against det D(s) = 0."""
    quantity: PoleEquation = case.quantity
    polynomial = characteristic_polynomial(case.closed(quantity.feedback), quantity.s)
    return case.same_roots(polynomial, quantity.s)


def equilibrium_stability(case: Case) -> Finding:
    """The typed word against the signs of the stability conditions."""
    (word,) = case.row.sides
    if word not in ("stable", "unstable"):
        raise InputError(f"{case.subject}: {word!r}: write 'stable' or 'unstable'")
    found = stability(case.linear)
    if found.stable is None:
        return undecided(case.subject, found.value)
    # All conditions are positive, or some are negative: of those the claim is decided.
    known, claim = 1 if found.stable else -1, 1 if word == "stable" else -1
    every = (*conditions(case.linear), *coefficient_ratios(case.linear))
    pairs = [(c, claim * Abs(c)) for c in every if sign(c) == known]
    finding = decide(case.subject, lambda a: [(a.value(c), a.value(size)) for c, size in pairs])
    return replace(finding, evidence=found.value) if finding.shown else finding


def stability_boundary(case: Case) -> Finding:
    """The typed gain against the derived borderline."""
    quantity: StabilityBoundary = case.quantity
    bound, _ = _borderline(case, quantity)
    return case.equal(bound)


def region(case: Case) -> Finding:
    """The typed inequality against the derived one: residuals scaled to slope one in the gain."""
    quantity: StabilityRegion = case.quantity
    gain = quantity.feedback.gain
    bound, side = _borderline(case, quantity)
    side = side if quantity.stable else -side
    (inequality,) = case.row.sides
    if not isinstance(inequality, Relational) or inequality.rel_op not in (">", "<"):
        raise InputError(f"{case.subject}: {inequality}: write an inequality, K > M*g/3")
    residual = case.plain(inequality.gts) - case.plain(inequality.lts)
    if not residual.is_polynomial(gain) or residual.as_poly(gain).degree() != 1:
        raise InputError(f"{case.subject}: {inequality} is not linear in {gain}")
    slope = coefficients(residual, gain)[-1]
    slope_sign = sign(slope)
    if slope_sign is None:
        return undecided(case.subject, f"the sign of {slope} is open")
    typed = residual / (slope * slope_sign)
    return case.decide(lambda a: [(a.value(typed), a.value(side * (gain - bound)))])


def _borderline(case: Case, quantity: StabilityBoundary | StabilityRegion) -> tuple[Expr, int]:
    """The one bound, and 1 if it is stable above, -1 if below."""
    found = stability_region(case.closed(quantity.feedback), quantity.feedback.gain)
    bounds = [*((b, 1) for b in found.lower), *((b, -1) for b in found.upper)]
    if len(bounds) != 1:
        raise InputError(f"{case.subject}: there are {len(bounds)} bounds of stability, not one")
    return bounds[0]


CHECKS: dict[type[LinearQuantity], Check] = {
    LinearizedEquation: linearized,
    InertiaAbout: inertia_about,
    TransformedEquation: transformed,
    TransferFunction: transfer,
    FeedbackLaw: feedback_law,
    PoleEquation: pole_equation,
    EquilibriumStability: equilibrium_stability,
    StabilityBoundary: stability_boundary,
    StabilityRegion: region,
}
