r"""A linear model by its matrices: s' = A s + B u, where s = (x, x', theta, theta').

    A = [0 1; -k/m -c/m], B = [0; 1/m]    ->    x'' = -k/m x - c/m x' + F/m

The text has to say what the state is; a row that only says that x' is the rate of x says nothing.
"""

import re
from collections.abc import Sequence
from fractions import Fraction

from mechanics.claims.definitions import used
from mechanics.claims.lines import Aside, Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.tree import Call, Name, Node, Number, Table, constant, product, total

MATRICES = ("A", "B")
NOTE = "A and B are read as those of s' = A s + B u"

State = tuple[tuple[str, int], ...]
"""Coordinates and the orders of their rates."""


SPOKEN = re.compile(
    r"(?:\$|\\\()\s*(?:\\left\s*)?\[(?P<cells>[^][$=&]+?)(?:\\right\s*)?\]"
    r"\s*\^\s*\{?\s*(?:T|\\top|\\intercal|\\mathsf\s*\{?T\}?)\s*\}?\s*(?:\$|\\\))"
)
"""A column that stands by itself between words: $[x, \\dot{x}]^T$."""
CELL = re.compile(
    r"\s*(?:\\(?P<dot>d?dot)\s*(?:\{\s*)?)?\\?(?P<name>[A-Za-z]+)\s*\}?(?:_\s*\{?(?P<low>\w+)\}?)?\s*\}?\s*"
)


def with_state_space(lines: Sequence[Entry], naming: Naming, text: str = "") -> list[Entry]:
    """The lines; matrices A and B of a state that the text gives, as the equations that they are.

    Parameters
    ----------
    lines : sequence of Entry
    naming : Naming
        A scene or person that has a name A means that.
    text : str
        Where a column between words may be the state.
    """
    found = {
        name: line for line in lines
        if isinstance(line, Line) and (name := _matrix_name(line, naming))
    }  # fmt: skip
    state = next((s for line in lines if (s := _state(line, naming))), _spoken(text, naming))
    scene = naming.vocabulary.scene
    inputs = [Name(-1, symbol.name) for symbol in scene.input_symbols]
    held = {n.name for n in used([line for line in lines if line not in found.values()])}
    if held & {*MATRICES}:  # an equation of matrices says what they are
        return list(lines)
    if state is None or "A" not in found or len(inputs) > 1 or bool(inputs) != ("B" in found):
        return list(lines)
    tables = {name: _table(line.sides[1]) for name, line in found.items()}
    A, B = tables["A"], tables.get("B")
    size = len(state)
    if A is None or len(A) != size or len(A[0]) != size:
        return list(lines)
    if inputs and (B is None or len(B) != size or len(B[0]) != 1):
        return list(lines)
    rows = list(_rows(found["A"], state, A, B if inputs else None, inputs))
    out: list[Entry] = []
    for line in lines:
        if line is found["A"]:
            out += rows
        elif line is found.get("B"):
            out.append(Aside(NOTE, line.at))
        else:
            out.append(line)
    return out


def _rows(
    line: Line, state: State, A: Sequence[Sequence[Node]], B: Sequence[Sequence[Node]] | None,
    inputs: Sequence[Name],
) -> list[Line]:  # fmt: skip
    """One equation for each row."""
    names = [Name(line.at, base, order) for base, order in state]
    found = []
    for number, (name, entries) in enumerate(zip(names, A, strict=True), start=1):
        pairs = [*zip(entries, names, strict=True)]
        pairs += [*zip(B[number - 1], inputs, strict=True)] if B is not None else []
        terms = [_times(one, by) for one, by in pairs if constant(one) != 0]
        rate = Name(line.at, name.name, name.order + 1)
        if terms == [rate]:
            continue
        right = total(line.at, terms) if terms else Number(line.at, Fraction(0))
        tag = f"row {number}"
        found.append(
            Line((rate, right), tag, line.at, f"{line.source[:40]}, row {number}", (NOTE,))
        )
    return found


def _times(entry: Node, by: Name) -> Node:
    return by if constant(entry) == 1 else product(entry.at, [entry, by])


def _matrix_name(line: Entry, naming: Naming) -> str:
    left = line.sides[0] if isinstance(line, Line) and len(line.sides) == 2 else None
    if not isinstance(left, Name) or left.order or left.name not in MATRICES:
        return ""
    return "" if naming.target(left.name) is not None else left.name


def _table(node: Node) -> Sequence[Sequence[Node]] | None:
    return node.rows if isinstance(node, Table) else None


def _spoken(text: str, naming: Naming) -> State | None:
    """The only column between words that has all coordinates and their rates."""
    found = {_of_cells(column["cells"].split(","), naming) for column in SPOKEN.finditer(text)}
    return found.pop() if len(found) == 1 else None


def _of_cells(cells: Sequence[str], naming: Naming) -> State | None:
    matches = [CELL.fullmatch(cell) for cell in cells]
    known: list[tuple[str, int]] = []
    for cell in matches:
        name = (cell["name"] + (f"_{cell['low']}" if cell["low"] else "")) if cell else ""
        if cell is None or (target := naming.lookup(name)) is None:
            return None
        known.append((target[0], target[1] + len((cell["dot"] or "").removesuffix("ot"))))
    return _whole(known, naming)


def _whole(known: Sequence[tuple[str, int]], naming: Naming) -> State | None:
    """The state, where it has each coordinate and each rate once."""
    wanted = {(q.name, order) for q in naming.vocabulary.scene.q for order in (0, 1)}
    return tuple(known) if {*known} == wanted and len(known) == len(wanted) else None


def _state(line: Entry, naming: Naming) -> State | None:
    """All coordinates and their rates in the order of a column or row."""
    for side in line.sides[1:] if isinstance(line, Line) else ():
        table = (
            side.arguments[0] if isinstance(side, Call) and side.function == "transpose" else side
        )
        rows = _table(table) or ()
        if not rows or 1 not in (len(rows), len(rows[0])):
            continue
        cells = [cell for row in rows for cell in row]
        targets = [naming.lookup(c.name) if isinstance(c, Name) else None for c in cells]
        known = tuple(
            (target[0], target[1] + cell.order) for target, cell in zip(targets, cells, strict=True)
            if target is not None and isinstance(cell, Name)
        )  # fmt: skip
        if len(known) == len(cells) and (state := _whole(known, naming)):
            return state
    return None
