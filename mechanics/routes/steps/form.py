"""The common form of the equations, in which every route ends.

    sum_j M_ij u'_j + what depends on the state alone  =  what inputs do        M_ii > 0

Rows are power-conjugate to the speeds, so that they are the same by whatever route.
"""

from dataclasses import replace
from itertools import combinations

from sympy import Add, Expr, Matrix, Mul, Rational, cos, expand, factor_terms, sift, sin

from mechanics.equations import Equations, Line, Term
from mechanics.scene import Coulomb, Scene
from mechanics.scene.symbols import plain_symbol
from mechanics.symbolic import operations


def has_common_form(scene: Scene) -> bool:
    """Whether the rows of all routes are combinations of each other by numbers alone.

    Constraints leave multipliers or dependent speeds, friction the reaction that presses.
    """
    return not scene.constraints and not any(isinstance(load, Coulomb) for load in scene.loads)


LARGEST = 400
"""Operations of a sum up to which it is multiplied out; nobody reads longer ones."""


def common_form(equations: Equations) -> tuple[Line, ...]:
    """The equations as lines, numbered E1, E2, ...

    Parameters
    ----------
    equations : Equations
        Written out; by a route whose rows are power-conjugate to u, where the scene has a common
        form.
    """
    common = has_common_form(equations.scene)
    lines = [_row(equations, i, common) for i in range(equations.mass.rows)]
    held = zip(range(equations.constraint_matrix.rows), equations.scene.constraints, strict=False)
    lines += [
        Line(
            _accelerations(equations, equations.constraint_matrix.row(i)),
            _state(equations.scene, equations.constraint_bias[i]) or Rational(0),
            constraint.name,
        )
        for i, constraint in held
    ]
    return tuple(replace(line, number=f"E{k}") for k, line in enumerate(lines, start=1))


def _row(equations: Equations, row: int, common: bool) -> Line:
    """State on the left and inputs on the right, or, with constraints, all of it on the right."""
    scene = equations.scene
    left = _accelerations(equations, equations.mass.row(row))
    inputs = {plain_symbol(f, order) for f in scene.inputs for order in range(3)}
    state, driven = _parted(equations.forcing[row], inputs)
    right = tuple(Term(part) for part in driven)
    if common:
        return Line((*left, *_state(scene, -state)), right or Rational(0))
    factors = equations.reaction_matrix.row(row)
    pulls = zip(factors, equations.multipliers, strict=False)
    right = (
        *_state(scene, state),
        *right,
        *(Term(Mul(collected(factor), pull)) for factor, pull in pulls if factor != 0),
    )
    return Line(left, right or Rational(0))


def _accelerations(equations: Equations, row: Matrix) -> tuple[Term, ...]:
    pairs = zip(row, equations.scene.ud, strict=True)
    return tuple(Term(Mul(collected(entry), one)) for entry, one in pairs if entry != 0)


def _state(scene: Scene, total: Expr) -> tuple[Term, ...]:
    """Terms of what depends on the state, each with its constants before it."""
    moving = {*scene.q, *scene.u, *scene.qd}
    groups: dict[Expr, list[Expr]] = {}
    for term in Add.make_args(_merged(total)):
        own, rest = sift(Mul.make_args(term), lambda f: bool(f.free_symbols & moving), binary=True)
        groups.setdefault(Mul(*own), []).append(Mul(*rest))
    parts = [Mul(factor_terms(Add(*front)), own) for own, front in groups.items()]
    rates = {*scene.u, *scene.qd} - {*scene.q}
    parts.sort(key=lambda part: (not part.free_symbols & rates, str(part)))
    return tuple(Term(part) for part in parts if part != 0)


def collected(total: Expr) -> Expr:
    """A coefficient as a textbook writes it, where that is shorter: factors before brackets."""
    if operations(total) > LARGEST:
        return total
    return min(total, factor_terms(_merged(total)), key=operations)


def _merged(total: Expr) -> Expr:
    """A sum multiplied out, with products of two angles as one where they meet:

    cos a cos b + sin a sin b = cos(a - b),     sin a cos b - cos a sin b = sin(a - b)
    """
    if operations(total) > LARGEST:
        return total
    terms: dict[Expr, Expr] = {}
    for term in Add.make_args(expand(total)):
        number, product = term.as_coeff_Mul()
        terms[product] = number
    together = []
    for product in sorted(terms, key=str):
        angles = sorted({f.args[0] for f in product.atoms(sin, cos)}, key=str)
        for a, b in combinations(angles, 2):
            for first, second, plus, minus in (
                (cos(a) * cos(b), sin(a) * sin(b), cos(a - b), cos(a + b)),
                (sin(a) * cos(b), cos(a) * sin(b), sin(a + b), sin(a - b)),
            ):
                other = product / first * second
                if terms.get(product) and abs(terms[product]) == abs(terms.get(other, 0)):
                    sign = plus if terms[product] == terms[other] else minus
                    together.append(terms.pop(product) * product / first * sign)
                    del terms[other]
    left = [number * product for product, number in terms.items()]
    return Add(*left, *together)


def _parted(forcing: Expr, inputs: set[Expr]) -> tuple[Expr, list[Expr]]:
    """What does not hold the inputs, and what each of them does."""
    state: list[Expr] = []
    driven: list[Expr] = []
    for part in Add.make_args(forcing):
        (driven if part.free_symbols & inputs else state).append(part)
    rest, found = Add(*driven), []
    for symbol in sorted(inputs, key=str):
        slope = rest.diff(symbol)
        if slope != 0 and not slope.free_symbols & inputs:
            flat = slope.expand()
            short = flat if operations(flat) <= operations(slope) else slope
            found.append(Mul(short, symbol, evaluate=short.is_Number))
            rest = (rest - slope * symbol).expand()
    return Add(*state, rest) if not rest.free_symbols & inputs else Add(*state), (
        found if not rest.free_symbols & inputs else [*found, rest]
    )
