"""Which names the lines of a person use, and which they define themselves.

    T = L - 2 x    T is defined where the scene has no such name        x' = v    defines v

A definition holds in all lines, also in those before it. One that nothing judged uses is no part of
any verdict.
"""

from collections import Counter
from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import replace

from mechanics.claims.about import ENERGY_NAMES, LETTERS, MATRIX_NAMES, OF_CONSTANTS
from mechanics.claims.conserved import NOTE as CONSTANT
from mechanics.claims.lines import Aside, Entry, Line
from mechanics.claims.names import Naming, column
from mechanics.claims.partials import undifferentiated
from mechanics.claims.tree import (
    COMPOSED,
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Rate,
    Sum,
    Table,
    constant,
    ended,
    inverse,
    names,
    parts,
    with_parts,
)


def used(lines: Sequence[Entry]) -> list[Name]:
    """Every name, in order."""
    return [
        n for line in lines if isinstance(line, Line) for side in line.sides for n in names(side)
    ]


def own(lines: Sequence[Entry], naming: Naming) -> list[str]:
    """Names that lines define; those of momenta are the scene's."""
    defined = definitions(lines, naming)
    counts = Counter(name.name for name in used(lines) if name.at != COMPOSED)
    again = {name for name, count in counts.items() if count > 1}
    return [name for name, line in defined.items() if not _momentum(line, defined, again, naming)]


def defines(line: Line, naming: Naming) -> bool:
    """Whether a name that nothing explains stands alone on the left."""
    left = line.sides[0]
    return (
        len(line.sides) > 1
        and isinstance(left, Name)
        and left.order == 0
        and not naming.knows(left.name)
        and not (_of_inputs(left.name, naming) and not gathers(line.sides[1:]))
    )


def _of_inputs(name: str, naming: Naming) -> bool:
    """Whether a name is the column of inputs: tau = M q'' + ... is what they are for a motion."""
    inputs = {symbol.name for symbol in naming.vocabulary.scene.input_symbols}
    return any((naming.lookup(entry) or ("",))[0] in inputs for entry in column(naming, name))


def definitions(lines: Sequence[Entry], naming: Naming) -> dict[str, Line]:
    """The first definition of each name."""
    found: dict[str, Line] = {}
    for line in lines:
        if isinstance(line, Line) and defines(line, naming) and isinstance(line.sides[0], Name):
            found.setdefault(line.sides[0].name, line)
    return found


def apart(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines; ``a = b = c`` with a and b unknown defines both: M_12 = M_21 = ... ."""
    known = set(definitions(lines, naming))
    found: list[Entry] = []
    for line in lines:
        if isinstance(line, Line) and len(line.sides) > 2 and defines(line, naming):
            *lefts, last = line.sides
            others = [side for side in lefts[1:] if isinstance(side, Name)]
            free = {side.name for side in others} - known
            plain = all(not side.order and naming.target(side.name) is None for side in others)
            if len(others) == len(lefts) - 1 == len(free) and plain:
                found += [replace(line, sides=(side, last)) for side in lefts]
                known |= free
                continue
        found.append(line)
    return found


def turned(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines; ``x' = v`` is turned round where nothing else says what v is.

    So is ``a = v = b``: a name amid other sides is what the person calls them. Of ``w^2 = k/m`` w
    is the root.
    """
    lines = _rooted(lines, naming)
    known = set(definitions(lines, naming))
    lines = _rooted([_divided(line, naming, known, lines) for line in lines], naming)
    known = set(definitions(lines, naming))
    found: list[Entry] = []
    for line in lines:
        amid = _named_amid(line, naming, known) if isinstance(line, Line) else None
        if isinstance(line, Line) and amid is not None:
            known.add(amid.name)
            rest = tuple(side for side in line.sides if side is not amid)
            line = replace(line, sides=(amid, *rest))
        elif isinstance(line, Line) and (name := _named_rate(line, naming, known)) not in (
            None,
            *known,
        ):
            known.add(str(name))
            line = replace(line, sides=line.sides[::-1])
        found.append(line)
    return found


def with_rates(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines, in which a rate that alone says how something turns is a name: psi' = R/r q'.

    Nothing else says what psi is, and its rate is used elsewhere.
    """
    every = used(lines)
    counts = Counter(name.name for name in every if name.order)
    at_rest = {name.name for name in every if not name.order}
    lefts = [n.sides[0] for n in lines if isinstance(n, Line) and len(n.sides) == 2]
    given = {side.name for side in lefts if isinstance(side, Name) and side.order == 1}
    own = {
        name for name in given - at_rest
        if counts[name] > 1 and naming.target(name) is None and name not in LETTERS
        and not column(naming, name)
    }  # fmt: skip

    def named(node: Node) -> Node:
        if isinstance(node, Name):
            again = replace(node, name=f"{node.name}_dot", order=node.order - 1)
            return again if node.name in own else node
        inside = parts(node)
        new = tuple(map(named, inside))
        return node if new == inside else ended(with_parts(node, new), node.end)

    return [
        replace(line, sides=tuple(map(named, line.sides))) if isinstance(line, Line) else line
        for line in lines
    ]  # fmt: skip


def _divided(line: Entry, naming: Naming, known: Container[str], lines: Sequence[Entry]) -> Entry:
    """``2 zeta w = c/m``, where w is known and zeta used elsewhere, as what zeta is.

    So is ``2 pi = omega T``: a frequency is a claim by its letter, and need not be used.
    """
    if not isinstance(line, Line) or len(line.sides) != 2:
        return line
    left, right = line.sides
    if isinstance(right, Product) and not names(left):
        left, right = right, left
    if not isinstance(left, Product):
        return line

    def free(node: Node) -> bool:
        base = node.base if isinstance(node, Power) else node
        unknown = isinstance(base, Name) and not base.order and base.name not in known
        return unknown and isinstance(base, Name) and naming.target(base.name) is None

    wanted = [factor for factor in left.factors if free(factor)]
    rest = [factor for factor in left.factors if not free(factor)]
    held = [name for factor in rest for name in names(factor)]
    if len(wanted) != 1 or any(constant(factor) == 0 for factor in rest):
        return line
    if not all(
        n.order == 0 and (n.name in known or naming.is_function(n.name) is False) for n in held
    ):
        return line
    name = names(wanted[0])[0].name
    elsewhere = [other for other in lines if isinstance(other, Line) and other is not line]
    told = _of_constants(name) or name in {n.name for n in used(elsewhere)}
    if not told or name in {n.name for n in names(right)}:
        return line
    sides = (wanted[0], Product(right.at, (right, *map(inverse, rest))))
    return replace(line, sides=sides, notes=(*line.notes, f"{name} is defined by this"))


def _rooted(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines with definitions of powers of names as those of the names."""
    known = set(definitions(lines, naming))
    found: list[Entry] = []
    for line in lines:
        if isinstance(line, Line) and (rooted := _root(line, naming, known)) is not None:
            line, name = rooted
            known.add(name)
        found.append(line)
    return found


def _root(line: Line, naming: Naming, known: Container[str]) -> tuple[Line, str] | None:
    """A definition of a power of a name, as one of the name, and which name."""
    left, *others = line.sides
    if not isinstance(left, Power) or not isinstance(left.base, Name) or not others:
        return None
    name, power = left.base, constant(left.exponent)
    if name.order or power is None or power <= 1 or power.denominator != 1:
        return None
    again = name.name in known and not _of_constants(name.name)
    if naming.target(name.name) is not None or again:
        return None
    if any(name.name == held.name for side in others for held in names(side)):
        return None
    root = Number(COMPOSED, 1 / power)
    sides = (name, *(Power(side.at, side, root) for side in others))
    notes = line.notes
    if power % 2 == 0:
        notes = (*notes, f"{name.name} is the positive root")
    return replace(line, sides=sides, notes=notes), name.name


def _of_constants(name: str) -> bool:
    """Whether a name means a frequency only, of which a text may give several."""
    return {word for rank in LETTERS.get(name, (("",),)) for word in rank} <= OF_CONSTANTS


def without_unknown_rates(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines without sides that only name what the others are: x'' = w' = ..., = tau/I = ... .

    Those are the rate of a name, or hold one, that nothing explains and nothing else uses; of
    letters for energies only what the first side is by definition: L = T - V = ... . Where that is
    all that a line says, and another line says what the first side is, it is a remark.
    """
    known = set(definitions(lines, naming))
    counts = Counter(name.name for name in used(lines))
    once = {name for name, count in counts.items() if count == 1} - known
    constant_at = {line.at for line in lines if isinstance(line, Line) and CONSTANT in line.notes}
    found: list[Entry] = []
    for line in lines:
        if isinstance(line, Line) and _only_names(line, lines, naming, once):
            words = f"{line.source[:60]}: names what another line gives"
            line = Aside(words, line.at)
        if isinstance(line, Line) and (other := _multiple(line, naming, once)):
            words = f"{line.source[:60]}: says what {other} is, which nothing else uses"
            line = Aside(words, line.at)
        if isinstance(line, Line) and len(line.sides) > 2:
            first, *rest = line.sides
            told = _told_in_turn(line, counts, naming, known)
            kept = tuple(
                side for side in rest
                if not _unknown_rate(side, naming, known)
                and not _named(first, side, naming, once | told.get(id(side), set()), known)
                and not _is_hamiltonian(first, side, naming)
            )  # fmt: skip
            kept = (first, *kept) if not _unknown_rate(first, naming, known) else kept
            if len(kept) == 1 and line.at in constant_at and isinstance(first, Name):
                words = f"{line.source[:60]}: names what is said to be constant"
                found.append(Aside(words, line.at))
                continue
            if 1 < len(kept) < len(line.sides):
                left = [side for side in line.sides if side not in kept]
                own = dict.fromkeys(
                    n.name
                    for side in left
                    for n in names(side)
                    if naming.target(n.name) is None and not _energy(n.name)
                )
                words = f"the side that says what {', '.join(own)} is in {line.source}"
                quoted = (words,) if own else ()  # T - V is what L is by its law
                line = replace(line, sides=kept, unjudged=(*line.unjudged, *quoted))
        found.append(line)
    return found


def _told_in_turn(
    line: Line, counts: Mapping[str, int], naming: Naming, known: Container[str]
) -> dict[int, set[str]]:
    """Names of each side that stand in this line only, where each side has one of its own.

    K = I w^2 + m v^2/2 = a + m (l w)^2/2 = b: the last side but one says what w is, the one before
    what I and v are. Two sides in one name only say something of it that may be wrong.
    """
    sides = [{n.name for n in names(side)} for side in line.sides]
    here = Counter(n.name for side in line.sides for n in names(side))
    only = {n for n, count in here.items() if counts[n] == count and naming.target(n) is None}
    found: dict[int, set[str]] = {}
    told: set[str] = set()
    for side, held in zip(reversed(line.sides[1:]), reversed(sides[1:]), strict=True):
        free = {name for name in held & only if name not in known}
        if free - told:
            found[id(side)] = free
            told |= free
    return found


def _is_hamiltonian(first: Node, side: Node, naming: Naming) -> bool:
    """Whether a side is p q' - L for the Hamiltonian on the left, by names of any motion."""
    if not isinstance(first, Name) or ENERGY_NAMES.get(first.name) != "Hamiltonian":
        return False
    if not isinstance(side, Sum) or len(side.terms) != 2:
        return False
    power, minus = side.terms
    factors = power.factors if isinstance(power, Product) else ()
    names_of = [(f.name.partition("_")[0], f.order) for f in factors if isinstance(f, Name)]
    last = minus.factors[-1] if isinstance(minus, Product) else None
    coordinates = {q.name for q in naming.vocabulary.scene.q}
    only = coordinates if len(coordinates) == 1 else set()  # its momentum is any p
    return (
        len(factors) == 2
        and sorted(names_of, key=lambda pair: pair[1]) in [[("p", 0), (q, 1)] for q in ("q", *only)]
        and isinstance(minus, Product)
        and [constant(f) for f in minus.factors[:-1]] == [-1]
        and isinstance(last, Name)
        and ENERGY_NAMES.get(last.name) == "Lagrangian"
        and all(naming.lookup(n.name) is None or n.name in ("p", *only) for n in names(side))
    )


def _only_names(line: Line, lines: Sequence[Entry], naming: Naming, once: Container[str]) -> bool:
    """Whether a line is H = T + V, T = T_1 + T_2 or tau = M q'' + C q' + G, and another gives it.

    Each term is a name that nothing else uses, or has one that depends on what moves; two energies
    stand by the law of what they make.
    """
    first, side = line.sides[0], line.sides[-1]
    if len(line.sides) != 2 or not isinstance(first, Name):
        return False
    terms = side.terms if isinstance(side, Sum) else ()
    free = [[name for name in names(term) if name.name in once] for term in terms]
    plain = all(isinstance(term, Name) for term in terms) and all(free)
    if plain or any(name.name in ENERGY_NAMES for some in free for name in some):
        says = not _named(first, side, naming, once)
    else:
        says = not all(any(name.given for name in some) for some in free)
    if says or not terms:
        return False
    lefts = [n.sides[0] for n in lines if isinstance(n, Line) and n is not line and n.sides[1:]]
    named = {(left.name, left.order) for left in lefts if isinstance(left, Name)}
    return (first.name, first.order) in named


def _multiple(line: Line, naming: Naming, once: Container[str]) -> str:
    """The name that nothing else uses, a multiple of a parameter by a line: l = L/2; else empty."""
    first, side = line.sides[0], line.sides[-1]
    held = names(side)
    if len(line.sides) != 2 or not isinstance(first, Name) or len(held) != 1:
        return ""
    name = held[0].name
    numbers = [constant(factor) for factor in _factors(side) if not isinstance(factor, Name)]
    own = naming.target(first.name) is not None and not naming.is_function(first.name)
    plain = own and numbers and all((number or 0) > 0 for number in numbers)
    free = name in once and naming.target(name) is None and not held[0].order
    return name if plain and free and not first.order else ""


def _factors(node: Node) -> list[Node]:
    inside = node.factors if isinstance(node, Product) else ()
    return [one for factor in inside for one in _factors(factor)] if inside else [node]


def _energy(name: str) -> str:
    """The energy that a name is, or is a part of: V, V_eff; empty where it is none."""
    return ENERGY_NAMES.get(name) or ENERGY_NAMES.get(name.partition("_")[0], "")


def _named(
    first: Node, side: Node, naming: Naming, once: Container[str], known: Container[str] = ()
) -> bool:
    """Whether a side says by names of its own what the others are."""
    unknown = [
        n.name for n in names(side)
        if naming.target(n.name) is None and n.name != "t" and n.name not in known
    ]  # fmt: skip
    if not unknown or not all(name in once for name in unknown):
        return False
    if not all(map(_energy, unknown)):
        return not any(map(_energy, unknown))
    if isinstance(side, Call):  # p = dL/dq'
        return _momentum_of(first, side, naming)
    energy = ENERGY_NAMES.get(first.name, "") if isinstance(first, Name) else ""
    if energy == "Hamiltonian" and not naming.vocabulary.scene.explicit_time:
        energy = "energy"
    return _is_law(energy, side)


def _is_law(energy: str, side: Node) -> bool:
    """Whether a side is T - V for a Lagrangian, T + V for an energy, T + V_g + V_s with several.

    So is T_c + T_p for a kinetic energy. A Lagrangian T + U has the force function, U = -V.
    """
    terms = side.terms if isinstance(side, Sum) else ()
    if energy in ("kinetic energy", "potential energy") and len(terms) > 1:
        low = [t.name for t in terms if isinstance(t, Name) and t.name not in ENERGY_NAMES]
        return len(low) == len(terms) and {_energy(name) for name in low} == {energy}
    if energy == "energy" and len(terms) > 2 and all(isinstance(term, Name) for term in terms):
        kinds = [_energy(term.name) for term in terms if isinstance(term, Name)]
        return sorted(kinds) == ["kinetic energy", *["potential energy"] * (len(terms) - 1)]
    if len(terms) != 2 or not isinstance(terms[0], Name):
        return False
    sign = {"Lagrangian": -1, "energy": 1}.get(energy)
    second, minus = terms[1], 1
    if isinstance(second, Product) and constant(second.factors[0]) == -1:
        second, minus = second.factors[-1], -1
    if energy == "Lagrangian" and isinstance(second, Name) and second.name == "U":
        sign = minus  # the potential, or the force function
    kinds = [_energy(n.name) for n in (terms[0], second) if isinstance(n, Name)]
    if kinds == ["potential energy", "kinetic energy"]:
        kinds, minus = kinds[::-1], minus if energy == "energy" else 0
    return kinds == ["kinetic energy", "potential energy"] and minus == sign


def _momentum_of(first: Node, side: Call, naming: Naming) -> bool:
    """Whether a derivative of a Lagrangian is the momentum on the first side, by definition."""
    momentum = naming.momentum(first.name) if isinstance(first, Name) else None
    of, by = (*side.arguments, None, None)[:2]
    if momentum is None or not isinstance(of, Name) or not isinstance(by, Name):
        return False
    speed = naming.lookup(by.name)
    lagrangian = ENERGY_NAMES.get(of.name) == "Lagrangian"
    return (
        lagrangian
        and speed is not None
        and speed[1] + by.order == 1
        and momentum[0] == (f"p_{speed[0]}")
    )


def _unknown_rate(side: Node, naming: Naming, known: Container[str]) -> bool:
    if not isinstance(side, Name) or not side.order or side.name in known:
        return False
    return naming.target(side.name) is None


def _named_amid(line: Line, naming: Naming, known: Container[str]) -> Name | None:
    """A name that nothing explains among more than two sides of which the first is no such name."""
    if len(line.sides) < 3 or defines(line, naming):
        return None
    for side in line.sides[1:]:
        if isinstance(side, Name) and not side.order and naming.target(side.name) is None:
            return None if side.name in known else side
    return None


def _named_rate(line: Line, naming: Naming, known: Container[str]) -> str | None:
    """The unknown name on the right of a rate of the scene, or of what a line defines."""
    if len(line.sides) != 2:
        return None
    left, right = line.sides
    if not (isinstance(left, Name) and isinstance(right, Name)) or right.order:
        return None
    own = left.order == 1 and left.name in known and naming.target(left.name) is None
    if not (own or _order(left, naming) == 1) or naming.target(right.name) is not None:
        return None
    return right.name


def _order(name: Name, naming: Naming) -> int:
    """How often what a name of the scene means is differentiated; 0 for any other name."""
    found = naming.lookup(name.name)
    return 0 if found is None else name.order + found[1]


def momenta(lines: Sequence[Entry], naming: Naming) -> dict[str, tuple[str, int]]:
    """Momenta that lines define by another name than the scene's: p_1, p_theta."""
    defined = definitions(lines, naming)
    counts = Counter(name.name for name in used(lines) if name.at != COMPOSED)
    again = {name for name, count in counts.items() if count > 1}
    return {
        name: meant for name, line in defined.items()
        if (meant := naming.momentum(name)) is not None
        and naming.vocabulary.momentum(name) is None and _momentum(line, defined, again, naming)
    }  # fmt: skip


def _momentum(
    line: Line, defined: Mapping[str, Line], elsewhere: Container[str], naming: Naming
) -> bool:
    """Whether a definition is that of a generalized momentum: by its name, and it holds rates.

    A text may call a position p_x; and what it goes on with is its own, as the momentum of a body.
    """
    left = line.sides[0]
    if not isinstance(left, Name) or naming.momentum(left.name) is None:
        return False
    if left.name in elsewhere:
        return False
    todo, seen = list(line.sides[1:]), {left.name}
    while todo:
        node = todo.pop()
        if isinstance(node, Rate) or (isinstance(node, Name) and _order(node, naming)):
            return True
        if isinstance(node, Name) and node.name in defined and node.name not in seen:
            seen.add(node.name)
            todo += defined[node.name].sides[1:]
        todo += parts(node)
    return False


def needed(lines: Sequence[Entry]) -> frozenset[str]:
    """Names that lines use which are no definitions of energies themselves.

    An energy that is differentiated only, as in Lagrange's equations, is judged beside these.
    """
    found: set[str] = set()
    for line in lines:
        if isinstance(line, Line):
            left, *others = line.sides
            name = left.name if isinstance(left, Name) and others else ""
            if name not in ENERGY_NAMES:
                sides = others if name in LETTERS else line.sides
                found |= {name for side in sides for name in undifferentiated(side)}
    return frozenset(found)


def in_order(defined: Mapping[str, Line]) -> list[str]:
    """Names, each behind those that its definition uses; of a circle, the first one last."""
    needs = {name: iter(_needs(line, defined)) for name, line in defined.items()}
    found: list[str] = []
    begun: set[str] = set()
    for start in defined:
        path = [] if start in begun else [start]
        while path:
            begun.add(path[-1])
            after = next((n for n in needs[path[-1]] if n not in begun), None)
            if after is None:
                found.append(path.pop())
            else:
                path.append(after)
    return found


def _needs(line: Line, defined: Mapping[str, Line]) -> list[str]:
    return [n.name for side in line.sides[1:] for n in names(side) if n.name in defined]


def reached(
    lines: Sequence[Entry],
    defined: Mapping[str, Line],
    needed: Container[str],
    held: Callable[[Sequence[Node]], Sequence[str]],
) -> frozenset[str]:
    """Names that judged lines hold, and that the definitions of these use in turn.

    A definition is no judged line, but for that of a letter with a meaning or a mass matrix, and
    where further sides are equal to it: these are judged by their right.
    """
    names_of = {id(line): name for name, line in defined.items()}
    todo: list[str] = []
    for line in lines:
        if isinstance(line, Line):
            name = names_of.get(id(line))
            if name is None:
                left = line.sides[0]
                again = isinstance(left, Name) and not left.order and _of_constants(left.name)
                todo += held(line.sides[again:])
            elif len(line.sides) > 2:
                todo += held(line.sides[1:])
            elif (name in LETTERS and name not in needed) or name in MATRIX_NAMES:
                todo += [n.name for side in line.sides[1:] for n in names(side)]
    found: set[str] = set()
    while todo:
        name = todo.pop()
        if name not in found:
            found.add(name)
            todo += _needs(defined[name], defined) if name in defined else []
    return frozenset(found)


def gathers(sides: Sequence[Node]) -> bool:
    """Whether a definition only puts names and numbers into a column or row: (F, 0)."""
    (side,) = sides if len(sides) == 1 else (None,)
    if not isinstance(side, Table) or min(len(side.rows), len(side.rows[0])) > 1:
        return False
    cells = [cell for row in side.rows for cell in row]
    plain = all(isinstance(cell, Name) or constant(cell) is not None for cell in cells)
    return plain and any(isinstance(cell, Name) for cell in cells)
