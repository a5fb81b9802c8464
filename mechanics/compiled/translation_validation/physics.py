"""What was derived, as nodes: inputs by group, and expressions at what their symbols are."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from sympy import Symbol

from mechanics.compiled.translation_validation.derived import Derived
from mechanics.kernel import Finding, Range, Statement, decide
from mechanics.kernel.statement import LEFT, RIGHT
from mechanics.program import Builder, Node
from mechanics.program.sympy_reader import read
from mechanics.routes.rows import substitute
from mechanics.symbolic.arithmetic import range_of

Entry = tuple[str, Node, Node]
"""Name of an entry, and two values that should be equal."""


@dataclass(frozen=True, eq=False)
class Physics:
    """What was derived in a builder; fixed parameters are their values.

    Attributes
    ----------
    inputs : dict of str to list of Node
        By group.
    constants : dict of str to Fraction
        Positive inputs that stand for numbers, see `constant`.
    """

    known: Derived
    builder: Builder = field(default_factory=Builder)
    inputs: dict[str, list[Node]] = field(init=False)
    leaves: dict[Symbol, Node] = field(init=False)
    constants: dict[str, Fraction] = field(default_factory=dict)

    def __post_init__(self) -> None:
        symbols, fixed = self.known.symbols, self.known.fixed
        every = [symbol for group in symbols.values() for symbol in group]
        leaves = {symbol: self.builder.input(symbol.name) for symbol in every}
        leaves |= zip(fixed, read(self.builder, list(fixed.values())), strict=True)
        inputs = {name: [leaves[symbol] for symbol in group] for name, group in symbols.items()}
        object.__setattr__(self, "leaves", leaves)
        object.__setattr__(self, "inputs", inputs)

    @property
    def ranges(self) -> dict[str, Range]:
        """What is declared of the inputs."""
        every = [symbol for group in self.known.symbols.values() for symbol in group]
        numbers = dict.fromkeys(self.constants, Range.POSITIVE)
        return {symbol.name: range_of(symbol) for symbol in every} | numbers

    def constant(self, number: Fraction) -> Node:
        """An input that stands for a positive number."""
        name = f"constant {number}"
        self.constants[name] = number
        return self.builder.input(name)

    def typical(self, name: str) -> Fraction:
        """What an input is at rest: 0, or a typical value of a parameter."""
        for symbol in self.leaves:
            if symbol.name == name:
                value = getattr(symbol, "typical", None)
                return Fraction(int(bool(symbol.is_positive)) if value is None else value)
        return self.constants.get(name, Fraction(0))

    def decide_entries(
        self, subject: str, entries: Sequence[Entry], *, try_normal: bool = True
    ) -> Finding:
        """Decide about all entries at once; where that fails, name the first one that differs.

        For every value of the constants, else for those that they have.
        """
        found = self._decided(subject, entries, try_normal)
        if found.shown or not self.constants:
            return found
        sides = [side for _, *pair in entries for side in pair]
        build = self.builder
        numbers = {build.input(name): build.constant(n) for name, n in self.constants.items()}
        nodes = iter(substitute(build, sides, numbers))
        there = [(name, next(nodes), next(nodes)) for name, _, _ in entries]
        return self._decided(subject, there, try_normal)

    def _decided(self, subject: str, entries: Sequence[Entry], try_normal: bool) -> Finding:
        together = self.decide_together(subject, entries, try_normal)
        if together.shown:
            return together
        for name in dict.fromkeys(name for name, _, _ in entries):
            one = [entry for entry in entries if entry[0] == name]
            single = self.decide_together(subject, one, try_normal)
            if not single.shown:
                return replace(single, evidence=f"{name}: {single.evidence}")
        return together

    def decide_together(
        self, subject: str, entries: Sequence[Entry], try_normal: bool = False
    ) -> Finding:
        """Decide about all entries at once."""
        left, right = [entry[1] for entry in entries], [entry[2] for entry in entries]
        program = self.builder.program({LEFT: left, RIGHT: right})
        return decide(Statement(subject, program, self.ranges), try_normal=try_normal)
