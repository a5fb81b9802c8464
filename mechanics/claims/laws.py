"""General laws in the prose, which say nothing of the scene: F = m a, tau = I alpha.

They are told from claims by their names: on each side one that nothing explains, and used nowhere
else; or one with an index, q_i, of which no scene has any.
"""

import re
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction

from mechanics.claims.about import LETTERS
from mechanics.claims.lines import Aside, Entry, Line
from mechanics.claims.names import Naming, column
from mechanics.claims.tree import Name, Node, Number, Power, Product, Sum, constant, names, parts

PLAIN = (Number, Name, Sum, Product, Power)
INDEXED = re.compile(r"[A-Za-z]+_[ijk]")
"""Any of several, as in Lagrange's equations for q_i."""
MOST_KNOWN = 2
"""Names of the scene in a general law: V = m g h."""
FACTORS = (None, -1, Fraction(1, 2), 1, 2)
"""Numbers in laws."""


def without_laws(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines, with a remark in place of each general law that stands beside claims."""
    used = [_used(line) for line in lines]
    counts = Counter(name for held in used for name in held)
    laws = [
        isinstance(line, Line) and _is_law(line, naming, {n for n in held if counts[n] == 1})
        for line, held in zip(lines, used, strict=True)
    ]
    claims = [isinstance(line, Line) and not law for line, law in zip(lines, laws, strict=True)]
    if not any(claims):
        return list(lines)
    return [
        _aside(line, naming) if law and isinstance(line, Line) else line
        for line, law in zip(lines, laws, strict=True)
    ]


def _used(line: Entry) -> set[str]:
    sides = line.sides if isinstance(line, Line) else ()
    return {name.name for side in sides for name in names(side)}


def _is_law(line: Line, naming: Naming, only_here: set[str]) -> bool:
    """Whether it speaks of no state, and each side of what is only here; or of any coordinate."""
    every = [name for side in line.sides for name in names(side)]
    indexed = [n for n in every if INDEXED.fullmatch(n.name) and n.name not in LETTERS]
    indexed = [n for n in indexed if naming.target(n.name) is None]  # E_k is an energy
    if indexed:
        # A force F_k beside the scene's own acceleration, or an acceleration of its own at a step.
        moves = any(_moves(n.name, naming) for n in every)
        return not moves and not any(n.order > 1 and _of_scene(n, naming) for n in indexed)
    if len(line.sides) != 2 or not all(map(_is_plain, line.sides)):
        return False
    inputs = _inputs(naming)
    for name in every:
        if name.given or "(" in name.name or column(naming, name.name):
            return False  # of columns and matrices
        if _moves(name.name, naming):
            return False
    if all(isinstance(side, Name) for side in line.sides):
        return False
    if len({n.name for n in every if naming.target(n.name) is not None}) > MOST_KNOWN:
        return False
    unknown = [{n.name for n in names(side)} & only_here for side in line.sides]
    unknown = [{n for n in held if naming.target(n) is None} for held in unknown]
    told = all(
        held or _is_input(side, inputs) for side, held in zip(line.sides, unknown, strict=True)
    )
    return told and not unknown[0] & unknown[1]


def _inputs(naming: Naming) -> set[str]:
    return {symbol.name for symbol in naming.vocabulary.scene.input_symbols}


def _moves(name: str, naming: Naming) -> bool:
    """Whether a name is a coordinate of the scene or its rate."""
    found = naming.target(name)
    known = found is not None and found[0] not in _inputs(naming)
    return known and naming.is_function(name) is True


def _of_scene(name: Name, naming: Naming) -> bool:
    """Whether a name with an index is a coordinate of the scene with a number, or with none."""
    base = name.name[:-2]
    return any(_moves(f"{base}{number}", naming) for number in ("", "_0", "_1"))


def _is_plain(node: Node) -> bool:
    value = constant(node) if isinstance(node, Number) else None
    return isinstance(node, PLAIN) and (value in FACTORS) and all(map(_is_plain, parts(node)))


def _is_input(side: Node, inputs: set[str]) -> bool:
    return isinstance(side, Name) and side.name in inputs


def _aside(line: Line, naming: Naming) -> Aside:
    unknown = dict.fromkeys(
        n.name for side in line.sides for n in names(side) if naming.target(n.name) is None
    )
    held = ", ".join(unknown)
    words = f"{line.source[:60]}: a general law, not judged: nothing else uses {held}"
    return Aside(words, line.at)
