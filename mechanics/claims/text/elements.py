"""Entries of arrays, as MATLAB and Julia write states: y(3), dy(2, 1), dydt = [...], u[1].

    dydt(1) = y(3)    ->    y(3) is the rate of y(1)        theta = y(1)    ->    y(1) is theta

The state is q, q' in the scene's order, in pairs where the text says so.
"""

import re
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from mechanics.claims.definitions import definitions
from mechanics.claims.kinds import angular
from mechanics.claims.lines import Aside, Entry, Line
from mechanics.claims.names import Match, Naming, column
from mechanics.claims.text.letters import plain
from mechanics.claims.text.next_state import with_rates
from mechanics.claims.tree import (
    ENTRY,
    Call,
    Name,
    Node,
    Number,
    Product,
    Sum,
    Table,
    constant,
    ended,
    names,
    parts,
    with_parts,
)
from mechanics.scene import Scene
from mechanics.scene.symbols import DOTS

ELEMENT = re.compile(r"(?P<array>\w+)(?P<open>[(\[])(?P<index>\d+)[)\]]")
RATES = ("d{}dt", "d{}", "{}dot", "{}_dot", "{}d", "{}p", "D{}", "d{}_dt", "dot_{}", "{}prime")
"""What people call the rate of an array."""
INPUTS = ("u", "tau", "F", "Q", "U")
WHY = "an entry of an array, in the scene's order"
BY_KIND = "an entry of an array: angles are those that sines are taken of"
SAID = "an entry of an array, as the text has it"

Meaning = tuple[str, int]
"""Name of the scene, and order of the derivative."""


def element(array: str, arguments: Sequence[Node], brackets: str = "()") -> str | None:
    """The name of an entry; a column may have a second number: dy(2, 1)."""
    numbers = [constant(one) for one in arguments]
    if len(numbers) == 2 and 1 in numbers:
        numbers = numbers[:1] if numbers[1] == 1 else numbers[1:]
    first = 1 if brackets == "()" else 0
    if len(numbers) != 1 or numbers[0] is None or numbers[0].denominator != 1:
        return None
    index = int(numbers[0])
    return f"{array}{brackets[0]}{index}{brackets[1]}" if index >= first else None


def with_states(lines: Sequence[Entry], naming: Naming) -> tuple[list[Entry], tuple[Match, ...]]:
    """The lines with the rate of a state entry by entry, and what the entries mean."""
    size = 2 * len(naming.vocabulary.scene.q)
    lines = [_named_result(line, size) for line in lines]
    own = definitions(lines, naming)
    spelled = {name: Name(0, name) for name in own} | _spelled_columns(lines)
    arrays = _arrays(lines)
    from_zero = any(0 in indices for indices in arrays.values())
    lines = [_of_own(line, spelled, from_zero) for line in lines]
    arrays = _arrays(lines)
    if not arrays:
        return _of_one_freedom(lines, naming)
    tables = {name: line for name, line in own.items() if isinstance(line.sides[1], Table)}
    tables |= _columns_of_state(lines, arrays, size)
    lines = _with_locals(lines, naming, (*arrays, *tables))
    returned = _returned(lines, tables, size) or _returned_by_entries(lines, arrays, size)
    found: dict[str, tuple[str, str]] = {}
    rates: dict[str, str] = {}
    passed = {name: places for name, places in arrays.items() if name != returned}
    state = _returned_state(passed, tables, size) if returned else ""
    lines = with_rates(lines, returned, state, 1 - from_zero, _place) if state else lines
    for array in arrays:
        rate = next((name for name in _named_rates(array) if name in (*arrays, *tables)), "")
        if not rate and array == state:
            rate = returned
        said = _said(lines, naming, array)
        of_another = array == returned or any(array in _named_rates(other) for other in arrays)
        if rate or said or not of_another:
            found |= _meanings(lines, naming, array, rate, arrays, said)
            rates[rate] = array
    columns = {
        name for name, line in own.items()
        if not isinstance(line.sides[1], Name) and name not in rates
    }  # fmt: skip
    expanded = [_expanded(line, rates, found, arrays, columns, size) for line in lines]
    matches = tuple(Match(name, base, why) for name, (base, why) in found.items())
    every = [
        n.name for line in expanded if isinstance(line, Line) for s in line.sides for n in names(s)
    ]
    once = frozenset(name for name in every if every.count(name) == 1)
    return [_told(line, naming, found, once) for line in expanded], matches


RESULT = "result"
"""What a function returns without giving it a name."""
LOCAL = "{} as assigned"
"""A name of the scene that code gives to a value of its own: phi = ...; dy(2) = phi;"""


def _named_result(line: Entry, size: int) -> Entry:
    """``[v; a]`` alone, with as many entries as a state has: what a function returns."""
    (side,) = line.sides if isinstance(line, Line) and len(line.sides) == 1 else (None,)
    if not isinstance(line, Line) or not isinstance(side, Table):
        return line
    rows, columns = len(side.rows), len(side.rows[0])
    if rows * columns != size or size < 2 or rows == columns:
        return line
    return replace(line, sides=(ended(Name(side.at, RESULT), side.at), side))


def _of_one_freedom(
    lines: Sequence[Entry], naming: Naming
) -> tuple[list[Entry], tuple[Match, ...]]:
    """``[v, a]`` of arguments by name: the rates of the only coordinate and its speed."""
    scene = naming.vocabulary.scene
    if len(scene.q) != 1 or scene.speeds:
        return list(lines), ()
    found = {f"{RESULT}({i})": (scene.q[0].name + DOTS[i], WHY) for i in (1, 2)}
    arrays = {RESULT: {1, 2}}
    expanded = [_expanded(line, {RESULT: RESULT}, found, arrays, (), 2) for line in lines]
    if expanded == list(lines):
        return expanded, ()
    matches = tuple(Match(name, base, why) for name, (base, why) in found.items())
    return [_told(line, naming, found, ()) for line in expanded], matches


def _returned(lines: Sequence[Entry], tables: Mapping[str, Line], size: int) -> str:
    """The one column that nothing uses, with as many entries as a state has."""
    every = [
        n.name for line in lines if isinstance(line, Line) for s in line.sides for n in names(s)
    ]
    columns = [
        name for name, line in tables.items()
        if every.count(name) == 1 and len(_cells(line.sides[1])) == size
    ]  # fmt: skip
    return columns[0] if len(columns) == 1 else ""


def _returned_by_entries(lines: Sequence[Entry], arrays: Mapping[str, set[int]], size: int) -> str:
    """The one array that gets all its entries, as many as a state has: y(1) = x(3); y(2) = ...

    Behind these stand zeros, the rates of inputs that are held.
    """
    assigned: dict[str, list[int]] = {}
    for line in lines:
        left = line.sides[0] if isinstance(line, Line) and len(line.sides) == 2 else None
        part = ELEMENT.fullmatch(left.name) if isinstance(left, Name) else None
        if part and isinstance(line, Line):
            place = int(part["index"])
            held = place > size and constant(line.sides[1]) == 0
            assigned.setdefault(part["array"], []).extend([] if held else [place])
    whole = [
        array for array, places in assigned.items()
        if {*places} == {p for p in arrays[array] if p in places or p <= size}
        and len({*places}) == size > 1
        and not any(array in _named_rates(other) for other in arrays)
    ]  # fmt: skip
    return whole[0] if len(whole) == 1 and len(arrays) > 1 else ""


def _columns_of_state(
    lines: Sequence[Entry], arrays: Mapping[str, set[int]], size: int
) -> dict[str, Line]:
    """Columns that are the rate of an array, whatever the scene calls so: xdot = [x(2); ...]."""
    rates = {name for array in arrays for name in _named_rates(array)}
    return {
        line.sides[0].name: line
        for line in lines
        if isinstance(line, Line) and len(line.sides) == 2 and isinstance(line.sides[0], Name)
        and line.sides[0].name in rates and len(_cells(line.sides[1])) == size > 1
    }  # fmt: skip


def _returned_state(arrays: Mapping[str, set[int]], tables: Container[str], size: int) -> str:
    """The one array that what is returned is the rate of, where no other has that name."""
    if any(name in tables for array in arrays for name in _named_rates(array)):
        return ""
    fitting = [array for array, places in arrays.items() if max(places) >= size // 2]
    fitting = [array for array in fitting if len(arrays[array]) == size] or fitting
    plain = [array for array in fitting if array not in INPUTS] or fitting
    return plain[0] if len(plain) == 1 else ""


def _cells(table: Node) -> list[Node]:
    return [cell for row in table.rows for cell in row] if isinstance(table, Table) else []


def _with_locals(lines: Sequence[Entry], naming: Naming, arrays: Sequence[str]) -> list[Entry]:
    """The lines with names of their own for what code assigns to a coordinate's and returns."""
    rates = {name for array in arrays for name in _named_rates(array) if name in arrays}
    assigned: dict[str, int] = {}
    passed: set[str] = set()
    for line in lines:
        left, right = line.sides if isinstance(line, Line) and len(line.sides) == 2 else (None,) * 2
        if not isinstance(left, Name) or right is None:
            continue
        part = ELEMENT.fullmatch(left.name)
        if left.name in rates or (part and part["array"] in rates):
            passed |= {c.name for c in (_cells(right) or [right]) if isinstance(c, Name)}
        elif not left.order and not isinstance(right, Name):
            assigned[left.name] = assigned.get(left.name, 0) + 1
    coordinates = {
        name for name in passed
        if assigned.get(name) == 1 and naming.is_function(name)
        and (naming.lookup(name) or ("", 1))[1] == 0
    }  # fmt: skip

    def renamed(node: Node) -> Node:
        if isinstance(node, Name) and node.name in coordinates:
            return ended(replace(node, name=LOCAL.format(node.name)), node.end)
        inside = parts(node)
        new = tuple(map(renamed, inside))
        return node if new == inside else ended(with_parts(node, new), node.end)

    return [
        replace(line, sides=tuple(map(renamed, line.sides))) if isinstance(line, Line) else line
        for line in lines
    ]


def _of_own(line: Entry, own: Mapping[str, Node], from_zero: bool) -> Entry:
    r"""The line with entries of what the text defines: qdd(1), where qdd = M \ f."""
    if not isinstance(line, Line):
        return line

    def entry(node: Node) -> Node:
        part = ELEMENT.fullmatch(node.name) if isinstance(node, Name) else None
        if part is None or part["array"] not in own:
            inside = parts(node)
            new = tuple(map(entry, inside))
            return node if new == inside else ended(with_parts(node, new), node.end)
        place = int(part["index"]) + (from_zero and part["open"] == "[")
        array = own[part["array"]]
        if isinstance(array, Table) and 0 < place <= len(array.rows):
            return ended(replace(array.rows[place - 1][0], at=node.at), node.end)
        array, index = Name(node.at, part["array"]), Number(node.at, Fraction(place))
        return ended(Call(node.at, ENTRY, (array, index)), node.end)

    return replace(line, sides=tuple(map(entry, line.sides)))


def _spelled_columns(lines: Sequence[Entry]) -> dict[str, Node]:
    r"""Columns of the scene's names on a left side, as they are spelled: qdd in qdd = M \ f."""
    pairs = [line for line in lines if isinstance(line, Line) and len(line.sides) == 2]
    return {
        plain("".join(line.source.partition("=")[0].split()))[0]: line.sides[0]
        for line in pairs
        if isinstance(line.sides[0], Table) and len(line.sides[0].rows[0]) == 1
    }


def _named_rates(array: str) -> tuple[str, ...]:
    return tuple(form.format(array) for form in RATES)


def _arrays(lines: Sequence[Entry]) -> dict[str, set[int]]:
    """Arrays of which entries are used, and which."""
    found: dict[str, set[int]] = {}
    for line in lines:
        for side in line.sides if isinstance(line, Line) else ():
            for name in names(side):
                if part := ELEMENT.fullmatch(name.name):
                    found.setdefault(part["array"], set()).add(int(part["index"]))
    return found


def _said(lines: Sequence[Entry], naming: Naming, array: str) -> dict[int, Meaning]:
    """What ``theta = y(1)`` says of entries."""
    found: dict[int, Meaning] = {}
    beyond = 2 * len(naming.vocabulary.scene.q)
    for line in lines:
        if not isinstance(line, Line) or len(line.sides) != 2:
            continue
        for one, other in (line.sides, line.sides[::-1]):
            place = _place(other, array)
            target = naming.target(one.name) if isinstance(one, Name) else None
            if place is None or place > beyond or not isinstance(one, Name) or target is None:
                continue
            moves = naming.is_function(one.name) or target[0] in naming.vocabulary.momenta
            if moves and not ELEMENT.match(one.name):
                found.setdefault(place, (target[0], target[1] + one.order))
    return found


def _meanings(
    lines: Sequence[Entry], naming: Naming, array: str, rate: str, arrays: Mapping[str, set[int]],
    said: Mapping[int, Meaning],
) -> dict[str, tuple[str, str]]:  # fmt: skip
    """What the entries of an array mean, and those of its rate, by name."""
    scene = naming.vocabulary.scene
    used = arrays[array] | arrays.get(rate, set()) | _listed(lines, rate, 0 in arrays[array])
    if scene.speeds:
        return _of_speeds(scene, array, rate, used)
    first = 0 if 0 in used else 1
    coordinates = [q.name for q in scene.q]
    size = len(coordinates)
    places: dict[int, Meaning]
    why = WHY
    if said:
        places, why = _with_rates(lines, array, rate, said, coordinates, used), SAID
    elif entries := column(naming, array) if max(used) - first < size else ():
        places = {first + i: (entry, 0) for i, entry in enumerate(entries)}
    elif rate:
        order = _order(lines, array, rate, size, first)
        by_kind = _by_kind(scene, order[:size], _places_of_angles(lines, array))
        if by_kind is None:
            return {}
        coordinates, why = by_kind, WHY if by_kind == coordinates else BY_KIND
        places = {place: (coordinates[k % size], k // size) for k, place in enumerate(order)}
    elif array in INPUTS and max(used) - first < len(scene.input_symbols):
        inputs = [symbol.name for symbol in scene.input_symbols]
        places = {first + i: (name, 0) for i, name in enumerate(inputs)}
    else:
        return {}
    brackets = _brackets(lines, array)
    of_rate = _brackets(lines, rate) or brackets
    if not brackets:
        return {}
    found: dict[str, tuple[str, str]] = {}
    for place, (base, order_of) in places.items():
        if order_of < len(DOTS):
            found[f"{array}{brackets[0]}{place}{brackets[1]}"] = base + DOTS[order_of], why
        if rate and order_of + 1 < len(DOTS):
            found[f"{rate}{of_rate[0]}{place}{of_rate[1]}"] = base + DOTS[order_of + 1], why
    return found


def _listed(lines: Sequence[Entry], rate: str, from_zero: bool) -> set[int]:
    """Places of what is listed as a rate: dxdt = [v; a]."""
    for line in lines:
        left = line.sides[0] if isinstance(line, Line) and len(line.sides) == 2 else None
        if isinstance(line, Line) and isinstance(left, Name) and left.name == rate:
            return {i + (not from_zero) for i in range(len(_cells(line.sides[1])))}
    return set()


def _of_speeds(
    scene: Scene, array: str, rate: str, used: Container[int]
) -> dict[str, tuple[str, str]]:
    """Entries of the column of declared speeds, w(1), and of its rate, wdot(1)."""
    speeds = [symbol.name for symbol in scene.u]
    first = 0 if 0 in used else 1
    places = range(first, first + len(speeds))
    if not rate or not all(place in used for place in places) or first + len(speeds) in used:
        return {}
    brackets = "()" if first else "[]"
    found: dict[str, tuple[str, str]] = {}
    for place, speed in zip(places, speeds, strict=True):
        for b in (brackets, "[]"):
            found[f"{array}{b[0]}{place}{b[1]}"] = speed, WHY
            found[f"{rate}{b[0]}{place}{b[1]}"] = speed + DOTS[1], WHY
    return found


def _with_rates(
    lines: Sequence[Entry], array: str, rate: str, said: Mapping[int, Meaning],
    coordinates: Sequence[str], used: Container[int],
) -> dict[int, Meaning]:  # fmt: skip
    """What is said of entries, what their rates are, and the speed of the only coordinate left.

    The others are in the one usual order that has what is said.
    """
    places = dict(said)
    for i, j in _pairs(lines, array, rate) if rate else ():
        if i in places and j not in places:
            base, order = places[i]
            places[j] = base, order + 1
    left = [place for place in range(max(places, default=0) + 2) if place in used]
    left = [place for place in left if place not in places]
    free = [q for q in coordinates if q not in {base for base, _ in places.values()}]
    if rate and len(left) == len(free) == 1:
        places[left[0]] = free[0], 1
    elif rate and left:
        size, first = len(coordinates), 0 if 0 in used else 1
        blocks = list(range(first, first + 2 * size))
        usual = [
            {place: (coordinates[k % size], k // size) for k, place in enumerate(order)}
            for order in ((blocks, [*blocks[::2], *blocks[1::2]]) if size > 1 else (blocks,))
        ]
        fitting = [one for one in usual if places.items() <= one.items()]
        places = fitting[0] if len(fitting) == 1 else places
    return places


def _brackets(lines: Sequence[Entry], array: str) -> str:
    for line in lines:
        for side in line.sides if isinstance(line, Line) else ():
            for name in names(side):
                part = ELEMENT.fullmatch(name.name)
                if part and part["array"] == array:
                    return "()" if part["open"] == "(" else "[]"
    return ""


def _order(lines: Sequence[Entry], array: str, rate: str, size: int, first: int) -> list[int]:
    """Places of q and then of q': in blocks, unless lines say otherwise."""
    blocks = list(range(first, first + 2 * size))
    pairs = dict(_pairs(lines, array, rate, first))
    if len(pairs) == size == len({*pairs.values()}) and not {*pairs} & {*pairs.values()}:
        return [*sorted(pairs), *(pairs[place] for place in sorted(pairs))]
    in_pairs = [*blocks[::2], *blocks[1::2]]
    for order in (blocks, in_pairs):
        next_of = dict(zip(order[:size], order[size:], strict=True))
        if all(next_of.get(i) == j for i, j in pairs.items()):
            return order
    return blocks


def _by_kind(scene: Scene, places: Sequence[int], angles: Container[int]) -> list[str] | None:
    """The coordinates at the places of q: in the scene's order, unless angles stand elsewhere.

    None where several other orders have them there.
    """
    coordinates = [q.name for q in scene.q]
    turning = {symbol.name for symbol in angular(scene)}
    used = [place in angles for place in places]
    pairs = list(zip(coordinates, used, strict=True))
    if all(name in turning for name, angle in pairs if angle) or sum(used) > len(turning):
        return coordinates
    if sum(used) < len(turning):
        return None
    kinds = {
        True: iter([name for name in coordinates if name in turning]),
        False: iter([name for name in coordinates if name not in turning]),
    }
    return [next(kinds[angle]) for angle in used]


def _places_of_angles(lines: Sequence[Entry], array: str) -> set[int]:
    """Places of the entries of which sines and cosines are taken: 1 in cos(x(1) - x(2)), too."""
    pairs = [line.sides for line in lines if isinstance(line, Line) and len(line.sides) == 2]
    own = {left.name: _place(right, array) for left, right in pairs if isinstance(left, Name)}
    found: set[int] = set()
    todo = [side for line in lines if isinstance(line, Line) for side in line.sides]
    while todo:
        node = todo.pop()
        todo += parts(node)
        of = (
            node.arguments[0]
            if isinstance(node, Call) and node.function in ("sin", "cos")
            else None
        )
        for term in of.terms if isinstance(of, Sum) else (of,):
            last = term.factors[-1] if isinstance(term, Product) else term
            place = _place(last, array) if last is not None else None
            if place is None and isinstance(last, Name) and not last.order:
                place = own.get(last.name)
            found |= {place} if place is not None else set()
    return found


def _pairs(lines: Sequence[Entry], array: str, rate: str, first: int = 1) -> list[tuple[int, int]]:
    """Places i and j of ``dy(i) = y(j)``, or of ``dy(i) = v`` where v is y(j)."""
    found: list[tuple[int, int]] = []
    own = {
        line.sides[0].name: place
        for line in lines
        if isinstance(line, Line) and len(line.sides) == 2 and isinstance(line.sides[0], Name)
        and (place := _place(line.sides[1], array)) is not None
    }  # fmt: skip
    for line in lines:
        if not isinstance(line, Line) or len(line.sides) != 2:
            continue
        left, right = line.sides
        if not isinstance(left, Name):
            continue
        cells = [right]
        places = [_place(left, rate)]
        if left.name == rate and isinstance(right, Table):
            cells = [cell for row in right.rows for cell in row]
            places = list(range(first, first + len(cells)))
        for i, cell in zip(places, cells, strict=True):
            j = _place(cell, array)
            if j is None and isinstance(cell, Name) and not cell.order:
                j = own.get(cell.name)
            if i is not None and j is not None:
                found.append((i, j))
    return found


def _place(node: Node, array: str) -> int | None:
    part = ELEMENT.fullmatch(node.name) if isinstance(node, Name) else None
    return int(part["index"]) if part and part["array"] == array else None


def _expanded(
    line: Entry, rates: Mapping[str, str], found: Mapping[str, object],
    arrays: Mapping[str, set[int]], columns: Container[str], size: int,
) -> Entry:  # fmt: skip
    """``dydt = [a; b]`` as an equation of columns."""
    if not isinstance(line, Line) or len(line.sides) != 2:
        return line
    left, right = line.sides
    if not isinstance(left, Name) or not isinstance(right, Table) or left.name not in rates:
        return line
    cells = _stacked([cell for row in right.rows for cell in row], columns, size)
    used = arrays[rates[left.name]] | arrays.get(left.name, set())
    first = 0 if 0 in used else 1
    labels = [
        next((n for n in (f"{left.name}({i})", f"{left.name}[{i}]") if n in found), "")
        for i in range(first, first + len(cells))
    ]
    if not all(labels):
        return line
    column_of = Table(left.at, tuple((Name(left.at, n),) for n in labels))
    return replace(line, sides=(column_of, Table(right.at, tuple((cell,) for cell in cells))))


def _stacked(cells: Sequence[Node], columns: Container[str], size: int) -> list[Node]:
    """Entries one by one; a column of the person's own among them has what they lack."""
    own = [isinstance(c, Name) and not c.order and c.name in columns for c in cells]
    if not any(own) or len(cells) >= size or (size - len(cells)) % sum(own):
        return list(cells)
    height = (size - len(cells)) // sum(own) + 1
    found: list[Node] = []
    for cell, column_of in zip(cells, own, strict=True):
        entries = [
            ended(Call(cell.at, ENTRY, (cell, Number(cell.at, Fraction(i + 1)))), cell.end)
            for i in range(height)
        ]
        found += entries if column_of else [cell]
    return found


def _told(
    line: Entry, naming: Naming, found: Mapping[str, tuple[str, str]], once: Container[str]
) -> Entry:
    """A line that only names an entry says nothing else."""
    if not isinstance(line, Line) or len(line.sides) != 2:
        return line
    if isinstance(line.sides[0], Table) and isinstance(line.sides[1], Table):
        return _without_names(line, naming, found)
    if constant(line.sides[1]) == 0 and _beyond(line.sides[0], naming, found):
        return Aside(f"{line.source[:60]}: taken as an input that is held", line.at)
    inputs = {symbol.name for symbol in naming.vocabulary.scene.input_symbols}
    for one, other in (line.sides, line.sides[::-1]):
        if not isinstance(one, Name) or not isinstance(other, Name):
            continue
        passed = other.name in INPUTS and other.name in once and not naming.knows(other.name)
        if one.name in inputs and (passed or _beyond(other, naming, found)):
            return Aside(f"{line.source[:60]}: taken as the name of an argument", line.at)
        if other.name not in found:
            if naming.is_function(one.name) is False and ELEMENT.fullmatch(other.name):
                return Aside(f"{line.source[:60]}: the value of a parameter is not used", line.at)
            continue
        target = naming.lookup(one.name)
        order = target[1] + one.order if target is not None else len(DOTS)
        if target is None and one.name in once and not ELEMENT.match(one.name):
            return Aside(f"{line.source[:60]}: the name of an entry, not used", line.at)
        if target is None or order >= len(DOTS) or ELEMENT.match(one.name):
            continue
        if found[other.name] == (target[0] + DOTS[order], SAID):
            return Aside(f"{line.source[:60]}: taken as the name of an entry", line.at)
    return line


def _beyond(entry: Node, naming: Naming, found: Iterable[str]) -> bool:
    """Whether an entry stands behind those of the state: u = x(5), of an array of four."""
    part = ELEMENT.fullmatch(entry.name) if isinstance(entry, Name) else None
    if part is None or int(part["index"]) <= 2 * len(naming.vocabulary.scene.q):
        return False
    return any(name.startswith(f"{part['array']}{part['open']}") for name in found)


def _without_names(line: Line, naming: Naming, found: Mapping[str, tuple[str, str]]) -> Entry:
    """A column without entries that are the names of what they have to be: of x'' stands xdd."""
    left, right = line.sides
    if not isinstance(left, Table) or not isinstance(right, Table):
        return line

    def same(label: Node, cell: Node) -> bool:
        if not isinstance(label, Name) or not isinstance(cell, Name) or ELEMENT.match(cell.name):
            return False
        target, told = naming.lookup(cell.name), found.get(label.name)
        order = target[1] + cell.order if target is not None else len(DOTS)
        return bool(target and told and order < len(DOTS) and told[0] == target[0] + DOTS[order])

    if len(left.rows) != len(right.rows) or len(left.rows[0]) != 1:
        return line
    kept = [k for k, row in enumerate(left.rows) if not same(row[0], right.rows[k][0])]
    meanings = [
        [found.get(n.name, ("",))[0] if isinstance(n, Name) else "" for n in (row[0], cell[0])]
        for row, cell in zip(left.rows, right.rows, strict=True)
    ]
    # Beside accelerations by their names, dz(1) = z(3) says only what dz is.
    if all(meanings[k][0] == meanings[k][1] != "" for k in kept) and len(kept) < len(left.rows):
        return Aside(f"{line.source[:60]}: taken as the names of what is returned", line.at)
    if len(kept) == len(left.rows):
        return line
    tables = (Table(t.at, tuple(t.rows[k] for k in kept)) for t in (left, right))
    return replace(line, sides=tuple(tables))
