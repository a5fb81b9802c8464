"""What may stand in place of what: the symbols of the scene with their values, and functions.

theta_1 -> theta_2, theta_dot_1, m_1, ...        sin(x) -> cos(x), tan(x)
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from sympy import Expr, Symbol

from mechanics.blame.search.inverse_evaluation import Sheet
from mechanics.claims.claim import Written
from mechanics.claims.tree import Call, Name, Node, Sum, names
from mechanics.equations import Equations
from mechanics.scene.momenta import momentum_symbols, rate_symbol
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import plain_symbol

TRIGONOMETRIC = ("sin", "cos", "tan")
INVERTED = {"tan": "cot", "cot": "tan", "sec": "csc", "csc": "sec"}
"""What is exchanged besides."""

LARGE = 400
"""Nodes beyond which only symbols that were written are put in place of others."""


@dataclass(frozen=True)
class Word:
    """A symbol of the scene.

    Attributes
    ----------
    name : Name
        As the person writes it.
    values : tuple of int
        At each point.
    kind : str
        ``"coordinate"``, ``"speed"``, ``"acceleration"``, ``"input"``, or the unit of a parameter.
    """

    symbol: Symbol
    name: Name
    values: tuple[int, ...]
    kind: str


@dataclass(frozen=True, eq=False)
class Words:
    """What a scene has to put in place of something else.

    Attributes
    ----------
    held : iterable of Symbol
        Symbols that were written, which come first.
    """

    truth: Equations
    written: Written
    sheets: Sequence[Sheet]
    held: Iterable[Symbol]

    @cached_property
    def symbols(self) -> tuple[Word, ...]:
        """Every symbol, those that were written first.

        None that is zero at all points, as a factor of zero mends whatever it stands before.
        """
        scene = self.truth.scene
        kinds: dict[Symbol, str] = {}
        for kind, group in (
            ("coordinate", scene.q), ("speed", (*scene.u, *scene.qd)), ("acceleration", scene.ud),
            ("acceleration", tuple(plain_symbol(q, 2) for q in scene.coordinates)),
            ("input", scene.input_symbols),
        ):  # fmt: skip
            for symbol in group:
                kinds.setdefault(symbol, kind)
        for symbol in (*scene.parameters, *scene.definitions):
            kinds.setdefault(symbol, str(getattr(symbol, "unit", "")))
        if scene.explicit_time:
            kinds.setdefault(TIME, "time")
        for symbol in momentum_symbols(scene):
            for each in (symbol, rate_symbol(symbol)):
                if each in set(self.held):
                    kinds.setdefault(each, "momentum")
        first = [symbol for symbol in kinds if symbol in set(self.held)]
        large = len(self.sheets[0].tree.nodes) > LARGE
        found = []
        for symbol in dict.fromkeys(first if large else [*first, *kinds]):
            meant = self.written.put.get(symbol, symbol)
            values = tuple(sheet.point.value(meant) for sheet in self.sheets)
            if any(values):
                found.append(Word(symbol, self.written.name_of(symbol), values, kinds[symbol]))
        return tuple(found)

    @cached_property
    def by_symbol(self) -> dict[Symbol, Word]:
        """The words by their symbols."""
        return {word.symbol: word for word in self.symbols}

    def word(self, name: Name) -> Word | None:
        """The word that a name of the person is; None for definitions and other names."""
        if name.name in dict(self.written.definitions):
            return None
        try:
            symbol = self.written.naming.symbol(name.name, name.order)
        except KeyError:
            return None
        return None if symbol is None else self.by_symbol.get(symbol)

    def accelerates(self, node: Node) -> bool:
        """Whether a node is one term with an acceleration: m x'' in m x'' = F."""
        words = [self.word(name) for name in names(node)]
        kinds = {word.kind for word in words if word is not None}
        return not isinstance(node, Sum) and "acceleration" in kinds

    def quadratic(self, term: Expr) -> bool:
        """Whether a term is a product of two speeds, as those that belong to accelerations.

        A speed to the power of a name, as in a slip like w2^w1, has no degree.
        """
        scene = self.truth.scene
        speeds = {*scene.u, *scene.qd}
        degrees = [e for base, e in term.as_powers_dict().items() if base in speeds]
        return all(e.is_number for e in degrees) and bool(sum(degrees) > 1)

    def functions(self, call: Call) -> list[Node]:
        """The same argument under another function."""
        others = [INVERTED[call.function]] if call.function in INVERTED else []
        others += [other for other in TRIGONOMETRIC if call.function in TRIGONOMETRIC]
        names = dict.fromkeys(other for other in others if other != call.function)
        return [Call(call.at, other, call.arguments) for other in names]

    def calls(self, call: Call) -> Iterator[tuple[Node, tuple[int, ...]]]:
        """Sines and cosines of what stands in this one, and of every coordinate."""
        if call.function not in TRIGONOMETRIC:
            return
        angles = [word.name for word in self.symbols if word.kind == "coordinate"]
        for angle in (call.arguments[0], *angles):
            for function in ("sin", "cos"):
                other = Call(call.at, function, (angle,))
                yield other, values_of(self.sheets, other)


def values_of(sheets: Sequence[Sheet], node: Node) -> tuple[int, ...]:
    """What a node is worth that nobody wrote."""
    return tuple(sheet.opaque(node) for sheet in sheets)
