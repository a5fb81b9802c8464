"""Parameters that code makes of others: what they may be, before numbers are fitted to the rest.

    r1 = 0.5*l1; r2 = 0.5*0.15; ...    ->    r1 = l1/2, and then r2 = 3/40

Nothing here is a verdict: values are proposed, the ledger decides.
"""

from collections.abc import Iterator, Sequence
from itertools import islice, product

from sympy import Expr, Integer, Rational, Symbol

from mechanics.compiled.dimensions import known_dimensions
from mechanics.compiled.fixed import fix
from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.judge.numbers_of_parameters import values_for
from mechanics.scene.published import Published

FACTORS = (Rational(1, 2), Integer(1), Integer(2))
MOST = 3
"""Parameters that are looked for."""
TRIALS = 30


def multiples_for(
    truth: Equations, rows: Sequence[Published], free: Sequence[Symbol], held: Sequence[Symbol]
) -> Iterator[dict[Symbol, Expr]]:
    """Values with which all rows may hold, some of them multiples of what the rows hold.

    Parameters
    ----------
    rows : sequence of Published
        About the motion, in plain symbols.
    free : sequence of Symbol
        Parameters that the rows do not hold.
    held : sequence of Symbol
        Parameters that they hold.
    """
    if not 0 < len(free) <= MOST:
        return
    dimensions = known_dimensions(truth)
    ways = [
        [None, *(k * h for h in held if dimensions.get(h) == dimensions.get(p) for k in FACTORS)]
        for p in free
    ]
    made = (dict(zip(free, way, strict=True)) for way in product(*ways) if any(way))
    for table in islice(made, TRIALS):
        some = {p: value for p, value in table.items() if value is not None}
        rest = [p for p in free if p not in some]
        try:
            fitted = values_for(fix(truth, some), rows, rest) if rest else {}
        except MechanicsError:
            continue  # there the scene does not move
        if fitted or not rest:
            yield some | fitted
