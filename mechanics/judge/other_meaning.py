"""A name of the scene that people also use for an energy.

T = ... is a reaction T of the scene, and wrong;    "right if T is the kinetic energy"
"""

from dataclasses import replace

from mechanics.checks.ledger import check_row
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError
from mechanics.kernel import Verdict
from mechanics.reading.about import ENERGY_NAMES, named_quantity
from mechanics.reading.tree import Name
from mechanics.report.answer.judged import Judged


def energy_instead(truth: Equations, entry: Judged) -> Judged:
    """A refuted statement, with the energy that it gives rightly where that is what it means.

    It counts as right only where the person says so: ``about="kinetic energy"``.
    """
    row, written = entry.statement.row, entry.statement.written
    if (
        entry.finding.undefined
        or entry.finding.verdict is not Verdict.REFUTED
        or row is None
        or written is None
    ):
        return entry
    name = written.sides[0]
    if len(written.sides) < 2 or not isinstance(name, Name) or name.name not in ENERGY_NAMES:
        return entry
    words = ENERGY_NAMES[name.name]
    if name.order or isinstance(row.quantity, type(named_quantity(words))):
        return entry
    meant = replace(row, quantity=named_quantity(words), sides=row.sides[-1:])
    try:
        found = check_row(truth.scene, meant, truth)
    except (InputError, SceneError, ExpressionError):
        return entry  # it cannot be an energy
    if not found.shown:
        return entry
    hint = f"{name.name} is the {words}, not the scene's {name.name}: say so, about {words!r}"
    return replace(entry, right_if=(*entry.right_if, hint), blame=None)
