"""Dimension of what was written, and how far the argument of a function without brackets goes.

    F_0 cos omega t      [omega] = 1/s, [omega t] = 1       cos(omega t)
    cos theta theta'^2   [theta] = 1, theta moves           cos(theta) theta'^2

An argument is a number. Of what stands side by side the first part that is one and moves is it; of
constants all that is one; where nothing is known of a name, all that stands there.
"""

from collections.abc import Container, Sequence
from fractions import Fraction

from mechanics.claims.kinds import ANGLES
from mechanics.claims.names import Naming
from mechanics.claims.tree import Call, Name, Node, Number, Power, Product, Rate, Sum, constant
from mechanics.claims.tree import names as names_in
from mechanics.scene.unit_names import Dimension, dimension_of_unit

NONE = dimension_of_unit("1", "") or ()
SECOND = dimension_of_unit("s", "") or ()
OF_ANY = frozenset(("abs", "Abs", "fabs", "absolute", "sign", "sgn", "sqrt", "max", "min"))
"""Functions of what has a dimension."""
DEEPEST = 20
"""Definitions that use others."""


def dimension(naming: Naming, node: Node, depth: int = 0) -> Dimension | None:
    """Dimension of a tree, by the units that the scene declares; None where it is not known."""
    match node:
        case Number() | Call(function="pi"):
            return NONE
        case Name():
            return _of_name(naming, node, depth)
        case Sum(terms=terms):
            return next((d for t in terms if (d := dimension(naming, t, depth)) is not None), None)
        case Product(factors=factors):
            return _total([dimension(naming, factor, depth) for factor in factors])
        case Power(base=base, exponent=exponent):
            return _times(dimension(naming, base, depth), constant(exponent))
        case Call(function="sqrt", arguments=(of,)):
            return _times(dimension(naming, of, depth), Fraction(1, 2))
        case Call(function=function, arguments=arguments):
            return dimension(naming, arguments[0], depth) if function in OF_ANY else NONE
        case Rate(of=of, order=order):
            return _total([dimension(naming, of, depth), _times(SECOND, Fraction(-order))])
    return None


def _of_name(naming: Naming, name: Name, depth: int) -> Dimension | None:
    found = naming.lookup(name.name)
    if found is not None:
        base, order = found
        order += name.order
        of = naming.vocabulary.dimensions.get(base)
    elif name.name == "t" and name.order == 0:
        return SECOND
    elif name.name in naming.own and depth < DEEPEST:
        of, order = dimension(naming, naming.own[name.name], depth + 1), name.order
    else:
        return None
    return _total([of, _times(SECOND, Fraction(-order))])


def _times(of: Dimension | None, factor: Fraction | None) -> Dimension | None:
    if of is None or factor is None:
        return NONE if of == NONE else None
    return tuple(entry * factor.numerator / factor.denominator for entry in of)


def _total(found: Sequence[Dimension | None]) -> Dimension | None:
    if any(one is None for one in found):
        return None
    return tuple(sum(column) for column in zip(*(one for one in found if one), strict=True))


def arguments(naming: Naming, factors: Sequence[Node], apart: Container[int] = ()) -> list[int]:
    """How many of some factors, which stand side by side, can be the argument: the best first.

    None where all have a dimension, and of numbers.

    Parameters
    ----------
    naming : Naming
    factors : sequence of Node
    apart : container of int
        Places of factors before which an operator or bracket stands: where nothing is known of a
        dimension, what is before them is the argument.
    """
    whole: list[int] = []
    plain: list[int] = []
    unknown: list[int] = []
    held: list[Name] = []
    found: Dimension | None = NONE
    for k, factor in enumerate(factors, 1):
        held += names_in(factor)
        found = _total([found, dimension(naming, factor)])
        if not held or found not in (None, NONE):
            continue
        last, behind = factors[k - 1], factors[k] if k < len(factors) else None
        if found == NONE and any(_turns(naming, name) for name in held):
            whole.append(k)
            break
        if found == NONE:
            plain.append(k)
            continue
        unknown.append(k)
        timed = isinstance(behind, Name) and _is_time(naming, behind)
        turns = isinstance(last, Name) and _turns(naming, last)
        ends = k in apart or (isinstance(behind, Name) and behind.order > 0)
        if not timed and (turns or ends):
            break
    return [*whole, *reversed(plain), *reversed(unknown)]


def first_with_name(factors: Sequence[Node]) -> int:
    """How many factors it takes to hold a name, or all."""
    return next((k for k, factor in enumerate(factors, 1) if names_in(factor)), len(factors))


def _turns(naming: Naming, name: Name) -> bool:
    """Whether a name is the time, moves, or is spelled like an angle."""
    letters = name.name.split("_")[0].rstrip("0123456789")
    return _is_time(naming, name) or bool(naming.is_function(name.name)) or letters in ANGLES


def _is_time(naming: Naming, name: Name) -> bool:
    return name.name == "t" and not naming.knows("t")
