"""Is this text sine and cosine? ``verify_sine(text) -> Finding``.

    PROVED      for all floating numbers up to the limit that mechanics_far has, to so many ulp
    REFUTED     at a witness the computed value is farther from the enclosure of the true one

The text is read twice: with fused operations, as machines compute it that have them, and without.
"""

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import ldexp

import numpy as np
from flint import arb, fmpq
from pycparser import c_ast, c_generator

from mechanics.compiled.translation_validation.sine.affine import SMALLEST
from mechanics.compiled.translation_validation.sine.bounds import Largest, largest_errors
from mechanics.compiled.translation_validation.sine.machine import sincos
from mechanics.compiled.translation_validation.sine.quadrant import check_parity, check_quadrants
from mechanics.compiled.translation_validation.sine.reduction import reduced, small
from mechanics.compiled.translation_validation.sine.rounding import unit
from mechanics.errors import ExpressionError
from mechanics.kernel import Finding, enclosed, refuted, undecided
from mechanics.kernel.balls import precision
from mechanics.program.c.literal import literal
from mechanics.program.c.parse import Source, parse

MOST = 1.6
"""Largest error that is accepted, in ulp."""
READINGS: Mapping[str, Mapping[str, str]] = {"fused": {"__FMA__": "1"}, "not fused": {}}
"""Macros that a compiler defines, or does not."""
PREFIX = "mechanics_"
"""Begins the names of its functions."""
SUFFIX = {"double": "", "float": "f"}
FEW, TRIALS = 8, 60
"""Angles of each kind that are tried to find a witness: before a proof, and where it fails."""


@dataclass(frozen=True)
class Far:
    """An angle, the value that a function computes, and the ball of those that are accepted."""

    function: str
    x: float
    value: float
    allowed: arb


def verify_sine(
    text: str,
    kind: str = "double",
    *,
    file: str = "code.c",
    includes: Mapping[str, str] | None = None,
) -> Finding:
    """Prove that ``mechanics_sincos`` computes sine and cosine.

    Parameters
    ----------
    text : str
        C source that holds it, and maybe more.
    kind : ``"double"`` or ``"float"``
    file : str
        Name for messages.
    includes : mapping of str to str
        Text of each file that it includes.
    """
    name = f"mechanics_sincos{SUFFIX[kind]}"
    subject = f"{file}: {name} = sine and cosine"
    limit, found, why = Fraction(0), Largest(0.0, 0.0, 0.0), ""
    sources: list[Source] = []
    try:
        sources += [parse(text, file, includes, macros) for macros in READINGS.values()]
        limit = _limit(sources[0], kind)
        for source in sources:
            # What is wrong is seen at a few angles, most often, and a proof takes seconds.
            if (far := _seen(_inline(source), name, kind, limit)) is not None:
                return _refuted(subject, "", far)
        for source in sources:
            found = found.joined(_proved(_inline(source), name, kind, limit))
    except ExpressionError as error:
        why = str(error)
    else:
        bounds = [(Fraction(0), arb(error), Fraction(MOST)) for error in (found.sine, found.cosine)]
        finding = enclosed(subject, bounds, _evidence(found, limit))
        if finding.shown:
            return finding
        why = f"the error is bounded by {max(found.sine, found.cosine):.3g} ulp only"
    for source in sources:
        far = _far(source, name, kind, limit, TRIALS)
        if far is not None:
            return _refuted(subject, f"{why}; ", far)
    return undecided(subject, why)


def _refuted(subject: str, why: str, far: Far) -> Finding:
    words = f"{why}see the witness of {far.function}"
    return refuted(subject, words, far.value, far.allowed, (("x", f"{far.x!r}, {far.x.hex()}"),))


def _inline(source: Source) -> str:
    """The functions of the inline sine alone, in one layout: what was proved once stays so."""
    write = c_generator.CGenerator().visit
    texts = [write(node) for n, node in sorted(source.functions.items()) if n.startswith(PREFIX)]
    return "\n".join(texts)


@lru_cache(maxsize=16)
def _seen(text: str, name: str, kind: str, limit: Fraction) -> Far | None:
    return _far(parse(text), name, kind, limit, FEW)


@lru_cache(maxsize=16)
def _proved(text: str, name: str, kind: str, limit: Fraction) -> Largest:
    source = parse(text)
    known = reduced(source, name, kind, limit)
    check_quadrants(source, name, kind, max((one.turns for one in known), default=0))
    check_parity(source, name)
    return largest_errors(source, name, kind, known, small(source, name, kind, limit))


def _evidence(found: Largest, limit: Fraction) -> str:
    return (
        f"off by at most {found.sine:.3f} and {found.cosine:.3f} ulp for all |x| <="
        f" {float(limit):g}, with fused operations and without; odd and even to the last bit;"
        " |s^2 + c^2 - 1| <="
        f" {found.square:.2g}; beyond that limit mechanics_far is not zero"
    )


def _limit(source: Source, kind: str) -> Fraction:
    """L of ``return !(fabs(x) <= L);``.

    Raises
    ------
    ExpressionError
        If the text of ``mechanics_far`` is another one.
    """
    f = SUFFIX[kind]
    name = f"mechanics_far{f}"
    if name not in source.functions:
        raise ExpressionError(f"there is no function {name}")
    function = source.functions[name]
    match function.body.block_items:
        case [
            c_ast.Return(
                expr=c_ast.UnaryOp(
                    op="!",
                    expr=c_ast.BinaryOp(
                        op="<=" | "<",
                        left=c_ast.FuncCall(
                            name=c_ast.ID(name=called),
                            args=c_ast.ExprList(exprs=[c_ast.ID(name=x)]),
                        ),
                        right=c_ast.Constant(value=number),
                    ),
                )
            )
        ] if called == f"fabs{f}" and x == function.decl.type.args.params[0].name:
            return literal(number).value
    raise ExpressionError(f"{name} is not !(fabs{f}(x) <= limit)")


def _far(source: Source, name: str, kind: str, limit: Fraction, trials: int) -> Far | None:
    """An angle at which the error is larger."""
    with precision(300):
        for x in _angles(kind, limit, trials):
            try:
                values = sincos(source, name, x)
            except (ExpressionError, OverflowError):
                return None
            true = arb(fmpq(*x.as_integer_ratio())).sin_cos()
            for which, value, exact in zip(("sin", "cos"), values, true, strict=True):
                error = abs(_exact(value) - exact)
                if exact.contains(0) or not error > MOST * unit(kind, abs(exact)):
                    continue
                room = (MOST * unit(kind, abs(exact))).upper()
                return Far(which, x, value, exact + arb(0, room))
    return None


def _exact(value: float) -> arb:
    return arb(fmpq(*value.as_integer_ratio())) if np.isfinite(value) else arb.pos_inf()


def _angles(kind: str, limit: Fraction, trials: int) -> Iterator[float]:
    """Angles of all sizes, next to multiples of pi/2 and half way between, to be tried."""
    draw, largest = random.Random(1), float(limit or 1)
    turn = np.pi / 2
    for _ in range(trials):
        n = draw.randrange(int(largest / turn) + 1)
        for x in (
            draw.uniform(-largest, largest),
            draw.uniform(-turn, turn),
            draw.uniform(-100, 100),
            n * turn,
            (n + 0.5) * turn,
            ldexp(draw.uniform(-1, 1), -draw.randrange(-SMALLEST[kind] - 30)),
        ):
            yield float(np.float32(x)) if kind == "float" else x
