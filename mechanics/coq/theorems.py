"""What is written for Coq about a system: statements, and the laws from which they follow.

    balance laws of the isolated bodies   ->   the rows of each route, the published equations
    nothing                               ->   Kane's rows are Lagrange's; the balance of energy

Balance laws are those of procedure (i) before any elimination, with every reaction.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import combinations

from sympy import Expr, Integer, Symbol, fraction, together

from mechanics.checks.admissible import check_scene
from mechanics.checks.laws import energy_rates, is_driven
from mechanics.crosscheck.programs import Programs, derive_rows
from mechanics.crosscheck.routes import named_routes
from mechanics.kinematics import differentiate
from mechanics.program.builder import Node
from mechanics.program.sympy_printer import expressions
from mechanics.routes.free_body import free_body_rows
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.system import System


@dataclass(frozen=True)
class Statement:
    """An equation in plain symbols, and what it is in words.

    Attributes
    ----------
    words : str
    left, right : Expr
    nonzero : frozenset of Symbol
        Positive parameters that have an inverse, where the equation has a quotient.
    """

    words: str
    left: Expr
    right: Expr
    nonzero: frozenset[Symbol] = frozenset()


@dataclass(frozen=True)
class Theorem:
    """One file.

    Attributes
    ----------
    words : str
        What is shown.
    laws : tuple of Statement
        What is assumed.
    goals : tuple of Statement
        What follows.
    """

    words: str
    laws: tuple[Statement, ...]
    goals: tuple[Statement, ...]


@dataclass(frozen=True)
class Source:
    """What theorems are read from; each is written when it is asked for, and may be too long."""

    system: System
    scene: Scene
    programs: Programs

    @cached_property
    def laws(self) -> tuple[Statement, ...]:
        """Rate of momentum = loads and reactions, of every body and direction."""
        mechanism, build = self.programs.mechanism, self.programs.mechanism.builder
        names = [reaction.name for reaction in mechanism.reactions]
        words, rates, acting = [], [], []
        motions = differentiate.motions(mechanism)
        for row in free_body_rows(mechanism, mechanism.filters[0], motions):
            value = row.applied
            for reaction, coefficient in row.coefficients.items():
                value = value + coefficient * build.input(names[reaction])
            name = mechanism.bodies[row.body].name
            words.append(f"{name}: {row.kind} momentum along {row.axis}")
            rates.append(row.rate)
            acting.append(value)
        sides = _written(self.programs, rates), _written(self.programs, acting)
        return tuple(map(Statement, words, *sides))

    def rows(self, route: str) -> tuple[Expr, ...]:
        """Rows of a route, each zero along every motion."""
        return _written(self.programs, self.programs.routes[route].rows.values)

    def route(self, route: str) -> Theorem:
        """Its rows follow from the laws."""
        words = f"the rows of {route} follow from the balance laws of the isolated bodies"
        goals = tuple(
            Statement(f"row {k + 1} of {route}", value, Integer(0))
            for k, value in enumerate(self.rows(route))
        )
        return Theorem(words, self.laws, goals)

    def pair(self, one: str, two: str) -> Theorem:
        """Rows of two routes that are conjugate to the same speeds are the same."""
        sides = zip(self.rows(one), self.rows(two), strict=True)
        goals = tuple(
            Statement(f"row {k + 1}: {one} = {two}", *pair) for k, pair in enumerate(sides)
        )
        return Theorem(f"{one} and {two} give the same rows", (), goals)

    def energy(self, route: str) -> Theorem:
        """Rows times speeds are the rate of energy less the power of loads."""
        rows = self.programs.routes[route].rows
        sides = _written(self.programs, energy_rates(self.programs.mechanism, rows))
        goal = "rows times speeds = rate of T + V less the power of other loads"
        words = f"the rows of {route}, times the speeds, are the balance of energy"
        return Theorem(words, (), (Statement(goal, *sides),))

    def published(self, row: Published) -> Theorem:
        """Typed sides, each beside the first."""
        plain = [self.scene.plain(side, row.tag) for side in row.sides]
        symbols = set().union(*(side.free_symbols for side in plain))
        named = {symbol: Symbol(symbol.name) for symbol in symbols}
        divided = any(fraction(together(side))[1].free_symbols for side in plain)
        nonzero = frozenset(named[s] for s in symbols if divided and s.is_positive)
        first, *others = (side.xreplace(named) for side in plain)
        words = f"equation {row.tag} of the source follows from the balance laws"
        goal = f"{row.tag} {row.label}"
        goals = tuple(Statement(goal, first, one, nonzero) for one in others)
        return Theorem(words, self.laws, goals)


def theorems(system: System) -> dict[str, Callable[[], Theorem]]:
    """By the names of their files: routes, pairs, energy, published equations of motion.

    A theorem raises `ExpressionError` where it is too long to be written.
    """
    scene = system.scene()
    mechanism = check_scene(scene)
    programs = derive_rows(mechanism, [route.name for route in named_routes(())])
    source = Source(system, scene, programs)
    conjugate = [name for name, route in programs.routes.items() if route.rows.conjugate]
    found: dict[str, Callable[[], Theorem]] = {}
    for name in programs.routes:
        found[f"laws_give_{name}"] = partial(source.route, name)
    for one, two in combinations(conjugate, 2):
        found[f"{one}_is_{two}"] = partial(source.pair, one, two)
    for name in conjugate if not is_driven(mechanism) else ():
        found[f"energy_of_{name}"] = partial(source.energy, name)
    for k, row in enumerate(system.published):
        if isinstance(row.quantity, EquationOfMotion):
            found[f"published_{k + 1}"] = partial(source.published, row)
    return found


def _written(programs: Programs, nodes: Sequence[Node]) -> tuple[Expr, ...]:
    return expressions(programs.mechanism.builder.program({"all": list(nodes)}))["all"]
