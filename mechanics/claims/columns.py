"""Columns that a letter stands for, as in robotics, and matrices that depend on them.

D(q) q'' + C(q, q') q' + g(q) = tau        q = (q1, q2), tau = (tau1, tau2)
"""

from collections import Counter
from collections.abc import Container, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from mechanics.claims.definitions import definitions, gathers
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import COORDINATES, Naming, column
from mechanics.claims.place import Refused
from mechanics.claims.spelled_rates import bases, key
from mechanics.claims.text.elements import ELEMENT
from mechanics.claims.tree import Call, Name, Node, Number, Product, Sum, Table, names, parts
from mechanics.scene.symbols import DOTS

SYMMETRIC = ("M", "D", "H", "B", "A", "I", "J")
"""What people call the mass matrix, of which one of two entries may be written."""


def with_columns(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines behind a definition of every column that is used beside matrices undefined."""
    sides = [side for line in lines if isinstance(line, Line) for side in line.sides]
    used = dict.fromkeys(n.name for side in sides for n in names(side))
    defined = definitions(lines, naming)
    own = {key(name): name for name in defined}
    free = [name for name in used if name not in defined and not naming.knows(name)]
    once = used_once(sides)
    lines = [_accelerations(line, naming, once) for line in lines]
    # x(1) is an entry itself, also beside x1 = x(1).
    whole = [name for name in free if ELEMENT.fullmatch(name) is None]
    gathered = [line for name in whole if (line := _gathered(naming, name, own)) is not None]
    if not gathered and not any(map(_holds_matrix, sides)):
        return list(lines)
    gathered += _inputs(naming, sides, free, defined)
    made = {line.sides[0].name for line in gathered if isinstance(line.sides[0], Name)}
    found = (_defined(naming, name, {key(n): n for n in used}) for name in free if name not in made)
    return [*(line for line in found if line is not None), *gathered, *lines]


def with_entries(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines; ``x = (x_1, x_2) = (s, s')`` is what x_1 and x_2 are.

    Beside two columns a name says nothing more: ``x' = (x_1', x_2') = (x_2, F/m)``.
    """
    made: list[Entry] = []
    for line in lines:
        tables = [s for s in line.sides if isinstance(s, Table)] if isinstance(line, Line) else []
        same = len({(len(table.rows), len(table.rows[0])) for table in tables}) == 1
        if not isinstance(line, Line) or len(tables) < 2 or not same:
            made.append(line)
            continue
        kept = tuple(side for side in line.sides if not isinstance(side, Name))
        cells = [[cell for row in table.rows for cell in row] for table in tables]
        own = [c.name for c in cells[0] if isinstance(c, Name) and not c.order]
        free = len({*own}) == len(cells[0]) and not any(map(naming.knows, own))
        state = all(isinstance(c, Name) and naming.is_function(c.name) for c in cells[1])
        if len(kept) == len(tables) == 2 and free and state:
            pairs = zip(*cells, strict=True)
            made += (replace(line, sides=pair, at=pair[0].at) for pair in pairs)
            continue
        made.append(replace(line, sides=kept))
    return made


def _inputs(
    naming: Naming, sides: Sequence[Node], free: Sequence[str], defined: Mapping[str, Line]
) -> list[Line]:
    """What the one unknown term of a sum of columns is: f in f - V - G, the inputs."""
    inputs = [symbol.name for symbol in naming.vocabulary.scene.input_symbols]
    tables = {name for name, line in defined.items() if isinstance(line.sides[1], Table)}
    beside = {
        name.name for side in sides for s in _sums(side) for name in s.terms
        if isinstance(name, Name) and any(_ends(t) in tables for t in s.terms)
    }  # fmt: skip
    unknown = [name for name in free if name in beside and not column(naming, name)]
    named = {n.name for side in sides for n in names(side)} & {*inputs}
    if len(unknown) != 1 or not 1 < len(inputs) == len(naming.vocabulary.scene.q) or named:
        return []
    (name,) = unknown
    table = stacked(0, [Name(0, entry) for entry in inputs])
    return [Line((Name(0, name), table), "", 0, f"{name} = ({', '.join(inputs)})")]


def _sums(node: Node) -> list[Sum]:
    inner = [found for part in parts(node) for found in _sums(part)]
    return [node, *inner] if isinstance(node, Sum) else inner


def _ends(node: Node) -> str:
    """The name of a term but for its sign."""
    last = node.factors[-1] if isinstance(node, Product) else node
    return last.name if isinstance(last, Name) else ""


def used_once(sides: Sequence[Node]) -> frozenset[str]:
    """Names that stand at one place only."""
    every = Counter(name.name for side in sides for name in names(side))
    return frozenset(name for name, count in every.items() if count == 1)


def _accelerations(line: Entry, naming: Naming, once: Container[str]) -> Entry:
    r"""``qdd = M \ f``, which nothing uses: what a function returns, and a claim."""
    left = line.sides[0] if isinstance(line, Line) and len(line.sides) == 2 else None
    if not isinstance(line, Line) or not isinstance(left, Name) or left.name not in once:
        return line
    made = _defined(naming, left.name, {})
    table = made.sides[1] if made is not None else None
    held = names(table) if table is not None else []
    orders = [n.order + (naming.lookup(n.name) or ("", 0))[1] for n in held]
    if table is None or set(orders) != {2}:
        return line
    return replace(line, sides=(table, line.sides[1]))


def _gathered(naming: Naming, name: str, own: Mapping[str, str]) -> Line | None:
    """What a matrix or column is of which the text defines the entries: M_11, M_12, ..."""
    base = key(name.split("(")[0])
    numbers = range(1, len(naming.vocabulary.scene.q) + 1)
    places = [[f"{base}{i}{j}" for j in numbers] for i in numbers]
    if base in SYMMETRIC:
        places = [[p if p in own else f"{base}{p[-1]}{p[-2]}" for p in row] for row in places]
    rows: tuple[tuple[Node, ...], ...] = ()
    if len(numbers) > 1 and all(place in own for row in places for place in row):
        rows = tuple(tuple(Name(0, own[place]) for place in row) for row in places)
    elif len(numbers) > 1 and all(f"{base}{i}" in own for i in numbers):
        rows = tuple((Name(0, own[f"{base}{i}"]),) for i in numbers)
    if not rows:
        return None
    words = "; ".join(", ".join(n.name for cell in row for n in names(cell)) for row in rows)
    return Line((Name(0, name), Table(0, rows)), "", 0, f"{name} = ({words})")


def _defined(naming: Naming, name: str, used: Mapping[str, str]) -> Line | None:
    """What a column is, or one that is differentiated: qdd."""
    # q2_dot is the rate of q2 rather than the second one of q.
    rates = () if any(map(str.isdigit, name)) else bases(name)
    for base, order in ((name, 0), *rates):
        entries = column(naming, base)
        # The person's own q1, q2 beside q: what they mean is guessed as for any other name.
        own = tuple(f"{base}{i}" for i in range(1, len(entries) + 1))
        if base in COORDINATES and all(entry in used for entry in own):
            entries = tuple(used[entry] for entry in own)
        if entries and not naming.knows(name):
            table = stacked(0, [Name(0, entry, order, True) for entry in entries])
            words = ", ".join(entry + DOTS[order] for entry in entries)
            return Line((Name(0, name), table), "", 0, f"{name} = ({words})")
    return None


def names_a_column(line: Line, naming: Naming) -> bool:
    """Whether a line says which names a column of the person's own is made of.

    What would be taken for a column of the scene can be another one: q = (x, 2 theta).
    """
    left, *right = line.sides
    if not isinstance(left, Name) or left.order or naming.knows(left.name) or len(right) != 1:
        return False
    if not isinstance(right[0], Table):
        return False
    held = names(right[0])
    moves = any(naming.is_function(name.name) for name in held)  # u = (F, 0), and no interval
    return moves or bool(held and column(naming, left.name)) or gathers(right)


def _holds_matrix(node: Node) -> bool:
    return isinstance(node, Table) or any(map(_holds_matrix, parts(node)))


def dependent(naming: Naming, name: Name, arguments: Sequence[Node]) -> Name | None:
    """The name before ``(q)`` or ``(q, q')``, where that is no product; None where it may be one.

    A name of the scene stays what it is: g(q) is the person's own beside the constant g.
    """
    inside = [a for a in arguments if isinstance(a, Name)]
    vectors = [a for a in inside if column(naming, a.name)]
    moving = all(a in vectors or a.name == "t" or naming.is_function(a.name) for a in inside)
    if len(inside) != len(arguments) or not moving or not (vectors or len(inside) > 1):
        return None
    if naming.is_function(name.name) is not False:
        return name
    told = ", ".join(a.name + "'" * a.order for a in inside)
    return Name(name.at, f"{name.name}({told})", name.order)


def derived_by(naming: Naming, name: Name, arguments: Sequence[Node]) -> Name | None:
    """The coordinate by which the primes of ``V'(x)`` differentiate; None where they are dots.

    Raises
    ------
    Refused
        Where the name is one of the scene's.
    """
    by = arguments[0] if len(arguments) == 1 else None
    if not name.primes or not isinstance(by, Name) or by.order or by.name == "t":
        return None
    if not naming.is_function(by.name):
        return None
    if naming.is_function(name.name) is not None:
        told = f"{name.name}'({by.name}) is a derivative by {by.name}, and {name.name} the scene's"
        raise Refused(name.at, f"{told}: write it out")
    return by


TRANSPOSED = ("T", "top", "intercal")
"""What stands above a matrix that is turned."""


def transposed(naming: Naming, base: Node, arguments: Sequence[Node], power: Node) -> Node | None:
    """``A^T`` or ``(a, b)^T``; None for a power.

    Where the scene has a T of its own, only what is seen to be a matrix is turned.
    """
    if not isinstance(power, Name) or power.name not in TRANSPOSED or power.order:
        return None
    if len(arguments) > 1:
        return stacked(base.at, arguments)  # a row that is turned
    matrix = isinstance(base, Table) or (isinstance(base, Name) and column(naming, base.name))
    if naming.knows(power.name) and not matrix:
        return None
    return Call(base.at, "transpose", (base,))


def stacked(at: int, entries: Sequence[Node]) -> Table:
    """A column: of vectors people write (a, b), as a row as well."""
    return Table(at, tuple((entry,) for entry in entries))


DIAGONAL = "diag"


def diagonal(at: int, entries: Sequence[Node]) -> Table:
    """A matrix with these entries on its diagonal: J = diag(I_x, I_y, I_z)."""
    zero = Number(at, Fraction(0))
    return Table(at, tuple(
        tuple(entry if i == j else zero for j in range(len(entries)))
        for i, entry in enumerate(entries)
    ))  # fmt: skip


def crossed(at: int, left: Node, right: Node, chain: bool) -> Call:
    """A vector product; of what turns out to be numbers it is a product.

    In a chain without brackets, a x b x c, no more than two can be columns.
    """
    together = chain and isinstance(right, Call) and right.function == "cross"
    return Call(at, "cross", (left, *(parts(right) if together else (right,))))
