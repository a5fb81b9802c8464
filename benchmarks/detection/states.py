"""Real states at which right equations are known to hold, found without the checker.

    phi(q) = 0  by Newton,    A u + a = 0,    (u', lambda)  by Kane's method,    256 bits

A statement whose residual is not zero at one of them is wrong, whatever a checker says.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from random import Random

import sympy
from flint import arb, arb_mat, fmpq

from benchmarks.detection.tree import Tree, read
from mechanics.checks.ledger_compare import ordered
from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.kernel.balls import precision
from mechanics.scene import Scene
from mechanics.scene.rates import TIME, rate, rate_table
from mechanics.scene.symbols import DOTS, plain_symbol

BITS = 256
PAIRS = 2
ZERO, WRONG = -150, -60
"""Powers of two: what is smaller is rounding, what is larger is an error."""

Numbers = Mapping[sympy.Symbol, arb]


class NoStateError(MechanicsError):
    """A scene for which no admissible state was found."""


@dataclass(frozen=True, eq=False)
class States:
    """States of a scene; the two of a pair have the same parameters, inputs and time."""

    pairs: tuple[tuple[Numbers, Numbers], ...]

    @property
    def all(self) -> tuple[Numbers, ...]:
        """Every state."""
        return tuple(state for pair in self.pairs for state in pair)


def value(tree: Tree, numbers: Numbers) -> arb:
    """What a tree is worth at a state; not finite where it is not defined."""
    match tree.kind:
        case "number":
            return arb(fmpq(tree.value.numerator, tree.value.denominator))
        case "symbol":
            return numbers[tree.value]
        case "pi":
            return arb.pi()
    parts = [value(part, numbers) for part in tree.parts]
    match tree.kind:
        case "sum":
            return sum(parts[1:], parts[0])
        case "product":
            result = parts[0]
            for part in parts[1:]:
                result = result * part
            return result
        case "power":
            exponent = tree.parts[1].value
            return parts[0] ** (int(exponent) if exponent.denominator == 1 else parts[1])
    return getattr(arb, {"sign": "sgn", "Abs": "__abs__"}.get(tree.kind, tree.kind))(parts[0])


def vanishes(number: arb) -> bool | None:
    """Whether a number is zero; None where that cannot be told, or the number is not finite."""
    if not number.is_finite():
        return None
    if abs(number) < arb(2) ** ZERO:
        return True
    return False if abs(number) > arb(2) ** WRONG else None


def states(scene: Scene, kane: Equations, free_body: Equations, seed: int = 1) -> States:
    """States of a scene.

    Parameters
    ----------
    kane : Equations
        Gives the accelerations.
    free_body : Equations
        Gives the reactions, with the accelerations of `kane`.

    Raises
    ------
    NoStateError
        When none is found, or the two do not agree.
    """
    source = Random(seed)
    found: list[tuple[Numbers, Numbers]] = []
    with precision(BITS):
        while len(found) < PAIRS:
            given = _given(scene, source)
            one, two = (_state(scene, kane, free_body, given, source) for _ in range(2))
            if one is not None and two is not None:
                found.append((one, two))
            elif source.random() < 0.01:
                raise NoStateError(f"{scene.name}: no admissible state was found")
    return States(tuple(found))


def _velocity_forms(scene: Scene) -> list[sympy.Expr]:
    """The constraints as expressions in q and u that vanish, linear in u."""
    plain = ((c, scene.plain(c.expression, c.name)) for c in scene.constraints)
    return [rate(e, rate_table(scene)) if c.holonomic else e for c, e in plain]


def _of(expr: sympy.Expr, numbers: Numbers) -> arb:
    return value(read(expr), numbers)


def _draw(source: Random, low: int, high: int) -> arb:
    return arb(source.randint(16 * low, 16 * high) * 2 + 1) / 32


def _given(scene: Scene, source: Random) -> dict[sympy.Symbol, arb]:
    """Parameters, inputs with their rates, definitions."""
    free = set(scene.parameters).union(*(e.free_symbols for e in scene.definitions.values()))
    free -= scene.definitions.keys()
    moved = [plain_symbol(f, order) for f in scene.inputs for order in range(len(DOTS))]
    found = {s: _draw(source, 1, 3) for s in sorted(free, key=str)}
    found |= {s: _draw(source, -2, 2) for s in (*moved, TIME)}
    for name, expression in ordered(scene.definitions):
        found[name] = _of(expression, found)
    return found


def _state(
    scene: Scene, kane: Equations, free_body: Equations, given: Numbers, source: Random
) -> Numbers | None:
    numbers = dict(given) | {s: _draw(source, -2, 2) for s in (*scene.q, *scene.u)}
    if not (_closed(scene, numbers) and _admissible(scene, numbers)):
        return None
    solution = _solved(kane, numbers)
    again = _solved(free_body, numbers)
    if solution is None or again is None:
        return None
    numbers |= {s: solution[s] for s in scene.ud}
    for acceleration in scene.ud:
        if not vanishes(solution[acceleration] - again[acceleration]):
            raise NoStateError(f"{scene.name}: the routes do not agree on {acceleration}")
    numbers |= {s: again[s] for s in free_body.multipliers}
    for reaction, expression in free_body.reactions:
        numbers[reaction] = _of(expression, numbers)
    for coordinate, speed in scene.coordinate_rates.items():
        numbers[coordinate] = _of(speed, numbers)
    table = rate_table(scene)
    for function, speed in zip(scene.coordinates, scene.coordinate_rates.values(), strict=True):
        numbers[plain_symbol(function, 2)] = _of(rate(speed, table), numbers)
    return numbers


def _closed(scene: Scene, numbers: dict[sympy.Symbol, arb]) -> bool:
    """Newton's method for the last coordinates; True where all constraints hold."""
    forms = [scene.plain(c.expression, c.name) for c in scene.constraints if c.holonomic]
    if not forms:
        return True
    unknown = scene.q[-len(forms) :]
    slopes = [[form.diff(s) for s in unknown] for form in forms]
    for _ in range(60):
        rest = [_of(form, numbers) for form in forms]
        if all(vanishes(number) for number in rest):
            return True
        step = _linear([[_of(e, numbers) for e in row] for row in slopes], rest)
        if step is None:
            return False
        for name, change in zip(unknown, step, strict=True):
            numbers[name] = (numbers[name] - change).mid()
    return False


def _admissible(scene: Scene, numbers: dict[sympy.Symbol, arb]) -> bool:
    """Solves the constraints for dependent speeds."""
    forms = _velocity_forms(scene)
    slopes = [[_of(form.diff(u), numbers) for u in scene.u] for form in forms]
    for columns in _choices(len(scene.u), len(forms)):
        still = numbers | dict.fromkeys((scene.u[i] for i in columns), arb(0))
        rest = [-_of(form, still) for form in forms]
        found = _linear([[row[i] for i in columns] for row in slopes], rest)
        if found is not None:
            numbers |= {scene.u[i]: x for i, x in zip(columns, found, strict=True)}
            return True
    return not forms


def _choices(count: int, chosen: int) -> Iterator[Sequence[int]]:
    """Sets of dependent speeds, the last ones first."""
    return iter(list(combinations(range(count), chosen))[::-1]) if chosen else iter(())


def _solved(equations: Equations, numbers: Numbers) -> dict[sympy.Symbol, arb] | None:
    left, right = equations.system
    rows = [[_of(left[i, j], numbers) for j in range(left.cols)] for i in range(left.rows)]
    found = _linear(rows, [_of(entry, numbers) for entry in right])
    return None if found is None else dict(zip(equations.unknowns, found, strict=True))


def _linear(rows: Sequence[Sequence[arb]], right: Sequence[arb]) -> list[arb] | None:
    try:
        return list(arb_mat([list(row) for row in rows]).solve(arb_mat([[x] for x in right])))
    except ZeroDivisionError:
        return None
