"""An energy by its letter in what another one is said to be: H = E - m R^2 w^2 sin^2(theta).

It is the scene's own, up to a constant, as what is said of the other one is. Alone it may be the
value that is kept, H = ... = E; and where forces of the scene have potentials it may count them.
"""

from collections.abc import Sequence
from dataclasses import replace

from mechanics.checks.force_potentials import potentials_beside
from mechanics.checks.ledger_energy import energy_of
from mechanics.claims.about import LETTERS, QUANTITIES
from mechanics.claims.names import unexplained
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.judge.converted_rows import each_side
from mechanics.judge.meanings import UNITS, candidates
from mechanics.scene.published import Quantity
from mechanics.scene.quantities import Hamiltonian, Lagrangian, TotalEnergy
from mechanics.scene.symbols import symbols_of

UP_TO_A_CONSTANT = (Hamiltonian, Lagrangian, TotalEnergy)


def with_energy_letters(truth: Equations, statements: Sequence[Statement]) -> list[Statement]:
    """Statements of energies with the scene's own in place of letters that mean nothing else."""
    return [_with_energies(truth, statement) for statement in statements]


def _with_energies(truth: Equations, statement: Statement) -> Statement:
    row = statement.row
    if row is None or not statement.doubt or not isinstance(row.quantity, UP_TO_A_CONSTANT):
        return statement
    unknown = [s for s in symbols_of(row.sides) if _meant(truth, s.name)]
    if not symbols_of(row.sides) - {*unknown}:
        return statement  # H = T + V names its parts, and says nothing of the scene
    names = sorted(symbol.name for symbol in unknown)
    sides = [(s, side) for s in unknown for side in row.sides]
    added = all(abs(side.diff(s)) in (0, 1) and side not in (s, -s) for s, side in sides)
    if not (names and added) or statement.doubt != unexplained(truth.scene, names):
        return statement
    if any(potentials_beside(truth.scene, row)):
        return statement
    table = {
        s: energy_of(truth.kinematics, quantity)
        for s in unknown if (quantity := _meant(truth, s.name)) is not None
    }  # fmt: skip
    notes = (*statement.notes, *(f"{name} is read as the {LETTERS[name][0][0]}" for name in names))
    other = each_side(row, lambda side: side.xreplace(table))
    letter = statement.letter
    if letter is not None:
        letter = replace(letter, sides=tuple(side.xreplace(table) for side in letter.sides))
    return replace(statement, row=other, letter=letter, doubt="", notes=notes)


def _meant(truth: Equations, name: str) -> Quantity | None:
    """The energy that a letter means, where the scene has no other one that it may be."""
    every = [word for rank in LETTERS.get(name, ()) for word in rank if UNITS.get(word) == "J"]
    words = [word for word in every if any(True for _ in candidates(truth, word))]
    return QUANTITIES[words[0]]() if len(words) == 1 and words[0] in QUANTITIES else None
