"""What the outputs of code are, where neither names nor arguments tell.

    return thetaacc, xacc    [1/s^2, m/s^2]    ->    theta_ddot, x_ddot: no other order has these

Dimensions decide first. Where several orders have them the scene's is taken; what only another one
proves is neither right nor wrong: "right if f returns theta2_ddot, theta1_ddot".
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from sympy import Symbol

from mechanics.claims.statement import Statement
from mechanics.compiled.dimensions import known_dimensions
from mechanics.equations import Equations
from mechanics.kernel import Verdict
from mechanics.report.answer.judged import Judged
from mechanics.scene.dimensions import MixedDimensions, dimension_of
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.unit_names import Dimension

Known = Mapping[Symbol, Dimension | None]


def of_one_order(truth: Equations, statements: Sequence[Statement]) -> list[Statement]:
    """Statements of code in the only order of its outputs that has the right dimensions."""
    found = list(statements)
    known = known_dimensions(truth) if any(s.taken for s in statements) else {}
    for words, places in _groups(statements).items():
        rows = [dict(statements[k].taken)[words] for k in places]
        own = [found[k].row for k in places]
        if not all(row is not None and _has_one(truth, row, known) for row in own) and all(
            _has_one(truth, row, known) for row in rows
        ):
            for k, row in zip(places, rows, strict=True):
                source = found[k].source.removesuffix(found[k].tag) + row.tag
                told = f"{words}: no other order has these dimensions"
                found[k] = replace(
                    found[k], row=row, tag=row.tag, source=source, taken=(),
                    notes=(*found[k].notes, told),
                )  # fmt: skip
    return found


def _has_one(truth: Equations, row: Published, known: Known) -> bool:
    """Whether the sides of an equation of motion have one dimension, as far as it is known."""
    if not isinstance(row.quantity, EquationOfMotion):
        return True
    try:
        found = {dimension_of(truth.scene, truth.scene.plain(s), known) for s in row.sides}
    except MixedDimensions:
        return False
    return len(found - {None}) <= 1


def right_otherwise(
    judged: Sequence[Judged], shown: Callable[[Statement], bool]
) -> tuple[Judged, ...]:
    """Entries of code, open where all its outputs are right, taken otherwise.

    Parameters
    ----------
    shown : callable
        Whether a statement is right as it is judged.
    """
    found = list(judged)
    for words, places in _groups([entry.statement for entry in judged]).items():
        wrong = [k for k in places if _is_wrong(found[k])]
        if not wrong:
            continue
        others = [(found[k].statement, dict(found[k].statement.taken)[words]) for k in places]
        if all(shown(replace(s, row=row, written=None)) for s, row in others):
            for k in wrong:
                found[k] = replace(found[k], right_if=(words,), open=True)
    return tuple(found)


def _is_wrong(entry: Judged) -> bool:
    return entry.finding.verdict is Verdict.REFUTED and not entry.finding.undefined


def _groups(statements: Sequence[Statement]) -> dict[str, list[int]]:
    """Places of the statements that another reading is about, by its words."""
    found: dict[str, list[int]] = {}
    for k, statement in enumerate(statements):
        for words, _ in statement.taken:
            found.setdefault(words, []).append(k)
    return found
