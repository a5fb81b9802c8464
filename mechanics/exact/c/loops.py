"""Loops of C.

    for (int i = 0; i < 4; ++i) { ... }                four times
    for (size_t i = 0; i < count; ++i) { ... }         once, for lane i: entry k at k * stride + i
    for (size_t i = 0; i < count; i += 256) {          once, for the block of lanes that begins at i
        size_t n = count - i < 256 ? count - i : 256;  as many as are left
        for (size_t j = 0; j < n; ++j) { ... } }       once, for the lane i + j

A lane reads and writes its own entries only, so what holds for one lane holds for all, whatever the
count. Blocks of n = min(count - i, 256) lanes are all lanes, each once.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.exact.c.condition import Condition
from mechanics.exact.c.expressions import Expressions
from mechanics.exact.c.types import Type, declared
from mechanics.exact.c.values import Variable
from mechanics.exact.c.whole import Whole, plus, unknown, whole

MOST_TURNS = 4096
"""Of a loop with constant bounds."""

MOST_TURNS_IN_ALL = 20_000
"""Of all loops together: five that nest ask for a trillion."""


class Guard(NamedTuple):
    """A condition under which statements run, and whether the other way is run too."""

    condition: Condition
    both: bool


class Block(NamedTuple):
    """Lanes from `first` on: `bound` of them, at most `size`."""

    first: Whole
    bound: Whole
    size: int


class Loops(Expressions):
    """Runs loops.

    Attributes
    ----------
    counted : str
        The argument that counts the lanes, once a loop over them was read.
    block : Block or None
        The block of lanes at hand.
    guards : list of Guard
        Under which the statement at hand runs.
    lane_scope : int
        Number of scopes outside of the loop over lanes or blocks.
    """

    def __init__(self) -> None:
        super().__init__()
        self.counted = ""
        self.block: Block | None = None
        self.guards: list[Guard] = []
        self.lane_scope = 0
        self.turns = 0

    def statement(self, node: Any) -> None:
        """Run one statement; a subclass knows them."""
        raise NotImplementedError

    def is_own(self, variable: Variable) -> bool:
        """Whether a variable belongs to the lane or block at hand alone."""
        if self.lane is None and self.block is None:
            return True
        return any(variable in scope.values() for scope in self.scopes[self.lane_scope :])

    def least(self, left: Whole, right: Whole, where: Any) -> Whole:
        """``left < right ? left : right``: the lanes that are left of a block."""
        block = self.block
        if (
            block is not None
            and right.known == block.size
            and left == plus(unknown(self.counted), block.first, -1)
        ):
            return block.bound
        return super().least(left, right, where)

    def loop(self, node: Any) -> None:
        """Run a loop."""
        where = node.coord
        counter = node.init.decls[0] if isinstance(node.init, c_ast.DeclList) else None
        if counter is None or len(node.init.decls) != 1 or declared(counter).kind != "int":
            raise ExpressionError(f"{where}: a loop is expected as for (int i = 0; i < n; ++i)")
        step = self._step(node.next, counter.name, where)
        cond = node.cond
        if not (isinstance(cond, c_ast.BinaryOp) and cond.op == "<" and _is(cond.left, counter)):
            raise ExpressionError(f"{where}: a loop is expected as for (int i = 0; i < n; ++i)")
        first, last = self.value(counter.init), self.value(cond.right)
        if not isinstance(first, Whole) or not isinstance(last, Whole) or first.known is None:
            raise ExpressionError(f"{where}: the bounds of this loop are not known here")
        if last.known is None:
            if first.known != 0:
                raise ExpressionError(f"{where}: a loop over lanes begins with the first, 0")
            if step == 1:
                self._over_lanes(node, counter, last)
            else:
                self._over_blocks(node, counter, last, step)
            return
        if last.known - first.known > MOST_TURNS:
            raise ExpressionError(f"{where}: more than {MOST_TURNS} turns of a loop")
        for turn in range(first.known, last.known, step):
            self.turns += 1
            if self.turns > MOST_TURNS_IN_ALL:
                raise ExpressionError(f"{where}: more than {MOST_TURNS_IN_ALL} turns of all loops")
            self._turn(node, counter, whole(turn))

    def _step(self, node: Any, counter: str, where: Any) -> int:
        """1 for ``++i``, n for ``i += n``."""
        if isinstance(node, c_ast.UnaryOp) and node.op in ("++", "p++"):
            if getattr(node.expr, "name", None) == counter:
                return 1
        elif isinstance(node, c_ast.Assignment) and node.op == "+=":
            step = self.value(node.rvalue)
            known = step.known if isinstance(step, Whole) else None
            if getattr(node.lvalue, "name", None) == counter and known is not None and known > 0:
                return known
        raise ExpressionError(f"{where}: a loop is expected as for (int i = 0; i < n; ++i)")

    def _turn(self, node: Any, counter: Any, value: Whole) -> None:
        kind = Type("int", True, 0, None, "const int")
        variable = Variable(counter.name, kind, value, len(self.guards))
        self.scopes.append({counter.name: variable})
        self.statement(node.stmt)
        self.scopes.pop()

    def _over_lanes(self, node: Any, counter: Any, last: Whole) -> None:
        """The body once, for a lane that stands for all of them."""
        if self.lane is not None:
            raise ExpressionError(f"{node.coord}: a loop over lanes inside of another")
        if self.block is None:
            self._count(last, node.coord)
        elif last != self.block.bound:
            raise ExpressionError(f"{node.coord}: {last} lanes are not all of this block")
        own = unknown(f"lane {counter.name}")
        self.lane = plus(self.block.first, own) if self.block else own
        outer, self.lane_scope = self.lane_scope, len(self.scopes)
        self._turn(node, counter, own)
        self.lane, self.lane_scope = None, outer

    def _over_blocks(self, node: Any, counter: Any, last: Whole, size: int) -> None:
        """The body once, for a block that stands for all of them."""
        if self.lane is not None or self.block is not None or self.guards:
            raise ExpressionError(f"{node.coord}: a loop over blocks inside of another")
        self._count(last, node.coord)
        first = unknown(f"block {counter.name}")
        self.block = Block(first, unknown(f"lanes of block {counter.name}"), size)
        outer, self.lane_scope = self.lane_scope, len(self.scopes)
        self._turn(node, counter, first)
        self.block, self.lane_scope = None, outer

    def _count(self, last: Whole, where: Any) -> None:
        """All lanes are counted by one argument."""
        name = str(last)
        if len(last.terms) != 1 or self.counted not in ("", name):
            raise ExpressionError(f"{where}: {last} is not the number of lanes")
        self.counted = name


def _is(node: Any, counter: Any) -> bool:
    return isinstance(node, c_ast.ID) and bool(node.name == counter.name)
