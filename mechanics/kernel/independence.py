"""Which rows are linearly independent, and what is zero, at one random point of a field.

Rows that are independent at one point are so as functions: what is returned is certain. That no
more are, and that something is zero everywhere, holds but for the chance of an unlucky point, below
2^-90 for degrees up to 2^20. This chooses rows and pivots; it makes no verdict.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from flint import fmpz_mod_ctx, fmpz_mod_mat

from mechanics.kernel.angles import base_angles, turns_of
from mechanics.kernel.draws import Draws
from mechanics.kernel.field import Inadmissible, Residues
from mechanics.kernel.primes import common_modulus, draw_prime
from mechanics.kernel.statement import POSITIVE, Range
from mechanics.program import Program, interpret

BITS = 127
MOST_DRAWS = 64

Values = dict[str, tuple[Any, ...]]


def at_a_point(program: Program, signs: Mapping[str, Range]) -> tuple[int, Values]:
    """A prime, and the residues of a program's outputs at a random admissible point.

    Parameters
    ----------
    program : Program
        Outputs called ``"positive"`` are squares at the point.
    signs : mapping of str to Range
        What is known of the inputs.

    Raises
    ------
    Inadmissible
        If none of some points is admissible.
    """
    seed = program.digest
    program = base_angles(program)
    turns = turns_of(program)
    modulus = common_modulus(turns)
    draws = Draws(seed, "point")
    for _ in range(MOST_DRAWS):
        prime = draw_prime(BITS, modulus, draws)
        domain = Residues(prime, modulus, draws, turns)
        inputs = {name: domain.input(signs.get(name, Range.FREE)) for name in program.inputs}
        try:
            outputs = interpret(program, domain, inputs, release=False)
            for entry in outputs.get(POSITIVE, ()):
                domain.positive(entry)
        except Inadmissible:
            continue
        return prime, {name: tuple(v % prime for v in vs) for name, vs in outputs.items()}
    raise Inadmissible(f"no admissible point among {MOST_DRAWS} for {program!r}")


def zeros(program: Program, output: str, signs: Mapping[str, Range]) -> tuple[bool, ...]:
    """Which entries of an output are zero at the point."""
    _, outputs = at_a_point(program, signs)
    return tuple(value == 0 for value in outputs[output])


def pivot_columns(rows: list[list[int]], p: int) -> list[int]:
    """Pivot columns of a matrix of residues modulo p."""
    if not rows:
        return []
    reduced, rank = fmpz_mod_mat(rows, fmpz_mod_ctx(p)).rref()
    return [next(c for c in range(reduced.ncols()) if reduced[i, c] != 0) for i in range(rank)]
