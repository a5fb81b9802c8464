"""C functions as the instructions of CasADi's graphs, of which trees of formulas are made.

c ? x : 0  ->  if_else_zero(c, x)       c ? x : y  ->  if_else_zero(c, x) + if_else_zero(!c, y)
"""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import casadi

from mechanics.program.c.condition import Atom, Condition, negation
from mechanics.program.c.select import truth
from mechanics.program.casadi_reader import Instruction
from mechanics.program.composed import COMPOSED
from mechanics.program.operations import BY_NAME

OPS = {row.name: getattr(casadi, row.casadi) for row in BY_NAME.values() if row.casadi} | {
    name: getattr(casadi, f"OP_{name.upper()}") for name in COMPOSED if name != "not_equal"
}
OPS["not_equal"] = casadi.OP_NE
TRUTHS = frozenset(OPS[row.name] for row in BY_NAME.values() if row.boolean) | {casadi.OP_NE}


@dataclass
class Instructions:
    """Instructions as they are read, equal ones once."""

    nodes: list[Instruction] = field(default_factory=list)
    _places: dict[tuple[Instruction, str], int] = field(default_factory=dict)

    def number(self, value: Fraction, kind: str) -> int:
        """A constant."""
        return self._kept(Instruction(casadi.OP_CONST, (), value), kind)

    def input(self, place: int, entry: int, kind: str) -> int:
        """An entry of an argument."""
        return self._kept(Instruction(casadi.OP_INPUT, (place, entry), None), kind)

    def apply(self, operation: str, operands: tuple[int, ...], kind: str) -> int:
        """An operation; constants change their sign."""
        if operation == "negate" and (value := self.constant(operands[0])) is not None:
            return self.number(-value, kind)
        return self._kept(Instruction(OPS[operation], operands, None), kind)

    def constant(self, node: int) -> Fraction | None:
        """The number that an instruction is."""
        return self.nodes[node].constant

    def is_truth(self, node: int) -> bool:
        """Whether its value is 0 or 1."""
        return self.nodes[node].op in TRUTHS

    def under(self, condition: Condition) -> AbstractContextManager[Any]:
        """Conditions are found again in what is selected."""
        return nullcontext()

    def choose(self, condition: Condition, yes: int, no: int, kind: str, where: Any) -> int:
        """A choice as products, as CasADi writes it."""
        if isinstance(condition, bool):
            return yes if condition else no
        if (signed := self._sign(condition, yes, no)) is not None:
            return self.apply("sign", (signed,), kind)
        holds = truth(self, condition, kind, where)
        if self.constant(no) == 0:
            return holds if self.constant(yes) == 1 else self._if(holds, yes, kind)
        otherwise = truth(self, negation(condition), kind, where)
        first, second = self._if(holds, yes, kind), self._if(otherwise, no, kind)
        return self.apply("add", (first, second), kind)

    def _if(self, holds: int, value: int, kind: str) -> int:
        return self._kept(Instruction(casadi.OP_IF_ELSE_ZERO, (holds, value), None), kind)

    def _kept(self, node: Instruction, kind: str) -> int:
        if (node, kind) not in self._places:
            self._places[node, kind] = len(self.nodes)
            self.nodes.append(node)
        return self._places[node, kind]

    def _sign(self, condition: Condition, yes: int, no: int) -> int | None:
        """x, where what is chosen is 1 for 0 < x, else -1 for x < 0, else x."""
        if not (isinstance(condition, Atom) and condition.relation == "<" and condition.holds):
            return None
        zero, x = condition.operands
        nodes = self.nodes
        if self.constant(zero) != 0 or self.constant(yes) != 1 or nodes[no].op != casadi.OP_ADD:
            return None
        first, second = (nodes[i] for i in nodes[no].operands)
        if first.op != casadi.OP_IF_ELSE_ZERO or second.op != casadi.OP_IF_ELSE_ZERO:
            return None
        (below, minus), (above, same) = first.operands, second.operands
        fits = (
            nodes[below].op == casadi.OP_LT
            and nodes[below].operands[0] == x
            and self.constant(nodes[below].operands[1]) == 0
            and self.constant(minus) == -1
            and nodes[above].op == casadi.OP_NOT
            and nodes[nodes[above].operands[0]][:2] == nodes[below][:2]
            and same == x
        )
        return x if fits else None
