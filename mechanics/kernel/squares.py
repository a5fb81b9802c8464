"""Roots of squares are absolute values, before a field sees them: sqrt(L^2) = |L|.

A root is many-valued: the false sqrt((x - y)^2) = x - y is zero at half of all points of a field,
where |x - y| = x - y is so at none. L is found as the root of the radicand's polynomial, with
cosines for the squares of sines; factors that are declared positive leave the bars.
"""

from collections.abc import Collection, Mapping
from fractions import Fraction
from functools import reduce
from operator import mod

from flint import fmpq, fmpq_mpoly_ctx

from mechanics.kernel.angles import Form, Forms, node_of
from mechanics.kernel.ring import square_root as polynomial_root
from mechanics.kernel.statement import Range
from mechanics.program import Builder, Node, Program
from mechanics.program.interpret import include
from mechanics.program.operations import CONSTANT, COS, INPUT, SIN, SQRT

MOST_UNKNOWNS = 24


def square_root(builder: Builder, form: Form) -> Node | None:
    """One of the two quotients of polynomials whose square a form is, or None if none is seen.

    Parameters
    ----------
    builder : Builder
        Whose nodes the monomials of the form are made of.
    form : mapping of monomials to Fraction
    """
    found = _root(builder, form)
    unit = builder.constant(found[0]).sqrt() if found is not None else None
    if found is None or unit is None or unit.constant is None:
        return None
    return unit * node_of(builder, found[1])


def roots_of_squares(program: Program, signs: Mapping[str, Range]) -> Program:
    """The same program with |L| in the place of sqrt(L^2).

    Parameters
    ----------
    program : Program
        One without such roots is returned as it is.
    signs : mapping of str to Range
        What is known of the inputs.
    """
    codes, first = program.operations, program.operands[0]
    # The root of a constant is known to the field as it stands.
    if all(codes[first[n]] == CONSTANT for n, code in enumerate(codes) if code == SQRT):
        return program
    builder = Builder()
    forms = Forms(builder)

    def root(x: Node) -> Node:
        found = _root(builder, forms.of(x.number))
        if found is None:
            return x.sqrt()
        factor, inner = found
        return builder.constant(factor).sqrt() * _modulus(builder, inner, signs)

    outputs = include(builder, program, operations={"sqrt": root})
    return builder.program(outputs, inputs=program.inputs)


def _root(builder: Builder, form: Form) -> tuple[Fraction, Form] | None:
    """A positive number and a form whose square is the rest, up to sign."""
    unknowns = {number for monomial in form for number, _ in monomial}
    if not form or len(unknowns) > MOST_UNKNOWNS:
        return None
    circles = _circles(builder, unknowns)
    numbers = sorted(unknowns.union(*circles))
    # Even powers of what stands below leave no negative powers.
    below = {n: (1 - min(0, *(dict(m).get(n, 0) for m in form))) // 2 for n in numbers}
    for leading in zip(*circles, strict=True) if circles else ((),):
        # Division replaces squares of what leads: of sines first, then of cosines.
        numbers.sort(key=lambda n: (n not in leading, n))
        context = fmpq_mpoly_ctx.get([f"x{k}" for k in range(len(numbers))], "lex")
        unknown = dict(zip(numbers, context.gens(), strict=True))
        radicand = context.constant(0)
        for monomial, factor in form.items():
            powers = dict(monomial)
            term = context.constant(fmpq(factor.numerator, factor.denominator))
            for number, x in unknown.items():
                term *= x ** (powers.get(number, 0) + 2 * below[number])
            radicand += term
        ones = (unknown[s] ** 2 + unknown[c] ** 2 - 1 for s, c in circles)
        for polynomial in (radicand, reduce(mod, ones, radicand)):
            unit = polynomial.leading_coefficient() if polynomial else fmpq(0)
            root = polynomial_root(polynomial / unit) if unit > 0 else None
            if root is not None:
                inner: Form = {}
                for monomial, value in root.to_dict().items():
                    powers = {n: int(k) - below[n] for n, k in zip(numbers, monomial, strict=True)}
                    key = tuple((n, k) for n, k in sorted(powers.items()) if k)
                    inner[key] = Fraction(int(value.p), int(value.q))
                return Fraction(int(unit.p), int(unit.q)), inner
    return None


def _circles(builder: Builder, unknowns: Collection[int]) -> list[tuple[int, int]]:
    """Sines and cosines of the angles of which one is among the unknowns."""
    first = builder.operands[0]
    angles = {first[n] for n in unknowns if builder.operations[n] in (SIN, COS)}
    return [
        (Node(builder, angle).sin().number, Node(builder, angle).cos().number)
        for angle in sorted(angles)
    ]


def _modulus(builder: Builder, form: Form, signs: Mapping[str, Range]) -> Node:
    """|L|, the positive factors of a single monomial outside."""
    if len(form) > 1:
        return abs(node_of(builder, form))
    ((monomial, factor),) = form.items()
    outside = [
        pair for pair in monomial if pair[1] % 2 == 0 or _is_positive(builder, pair[0], signs)
    ]
    inside = tuple(pair for pair in monomial if pair not in outside)
    result = node_of(builder, {tuple(outside): abs(factor)})
    return result * abs(node_of(builder, {inside: Fraction(1)})) if inside else result


def _is_positive(builder: Builder, number: int, signs: Mapping[str, Range]) -> bool:
    code, name = builder.operations[number], builder.operands[0][number]
    if code == INPUT:
        return signs.get(builder.inputs[name], Range.FREE) in (Range.POSITIVE, Range.NONNEGATIVE)
    return code == SQRT
