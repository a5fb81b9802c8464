"""Statements of C, run once.

    for (size_t i = 0; i < count; ++i) { ... }     once, for the lane i: entry k at [k * stride + i]
    for (int i = 0; i < 4; ++i) { ... }            four times
    if (...) status = 2;                           both ways, where only integers change

Inputs may be the same arrays as outputs, so a read after a write is noted. A variable that is read
before it is set, a constant that is changed, an output written under a condition are refused.
"""

from __future__ import annotations

from typing import Any

from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.exact.c_condition import choice
from mechanics.exact.c_expressions import Expressions
from mechanics.exact.c_types import REALS, Type, declared
from mechanics.exact.c_values import (
    Array,
    Pointer,
    Real,
    Value,
    Variable,
    as_condition,
    as_decision,
    of_decision,
)
from mechanics.exact.c_whole import Whole, unknown, whole

MOST_TURNS = 4096
"""Of a loop with constant bounds."""


class Statements(Expressions):
    """Runs statements.

    Attributes
    ----------
    counted : str
        The integer that counts the lanes, once a loop over them was read.
    guards : int
        Conditions under which the statement at hand runs.
    lane_scope : int
        Number of scopes outside of the loop over lanes.
    """

    def __init__(self) -> None:
        super().__init__()
        self.counted = ""
        self.guards = 0
        self.lane_scope = 0

    def declare(self, name: str, thing: Variable | Array, where: Any) -> None:
        """Add to the innermost scope."""
        if name in self.scopes[-1]:
            raise ExpressionError(f"{where}: {name} is declared twice")
        self.scopes[-1][name] = thing

    def converted(self, value: Value | None, kind: Type, where: Any) -> Value:
        """A value as a variable of a type holds it."""
        if kind.depth == 0 and kind.kind in REALS:
            return Real(self.real(value, kind.kind, where), kind.kind)
        if kind.depth == 0 and kind.kind == "int":
            if isinstance(value, Whole):
                return value
            return of_decision(as_decision(value, where))
        if kind.depth == 1 and isinstance(value, Pointer) and value.array.kind == kind.kind:
            if value.array.constant and not kind.constant:
                raise ExpressionError(f"{where}: {value.array.name} must not be changed")
            return value
        raise ExpressionError(f"{where}: {kind.words} cannot hold this value")

    def statement(self, node: Any) -> None:
        """Run one statement."""
        if isinstance(node, c_ast.Decl):
            self._declaration(node)
        elif isinstance(node, c_ast.DeclList):
            for declaration in node.decls:
                self._declaration(declaration)
        elif isinstance(node, c_ast.Assignment):
            self._assignment(node)
        elif isinstance(node, c_ast.If):
            self._if(node)
        elif isinstance(node, c_ast.For):
            self._for(node)
        elif isinstance(node, c_ast.Compound):
            self._block(node)
        elif isinstance(node, c_ast.FuncCall):
            self.call(node)
        elif isinstance(node, c_ast.Cast) and declared(node.to_type).words == "void":
            self._ignored(node.expr)
        elif not isinstance(node, c_ast.EmptyStatement):
            raise ExpressionError(f"{node.coord}: {type(node).__name__} is not known here")

    def _ignored(self, node: Any) -> None:
        if not isinstance(node, c_ast.ID):
            raise ExpressionError(f"{node.coord}: only a name may be ignored")
        self.find(node.name, node.coord)

    def _block(self, node: Any) -> None:
        self.scopes.append({})
        for statement in node.block_items or ():
            self.statement(statement)
        self.scopes.pop()

    def _declaration(self, node: Any) -> None:
        kind = declared(node)
        if isinstance(node.type, c_ast.ArrayDecl):
            self._local_array(node, kind)
            return
        if "static" in (node.storage or ()):
            raise ExpressionError(f"{node.coord}: {node.name} keeps its value between calls")
        variable = Variable(node.name, kind)
        if node.init is not None:
            variable.value = self.converted(self.value(node.init), kind, node.coord)
        elif kind.constant and not kind.depth:
            raise ExpressionError(f"{node.coord}: the constant {node.name} has no value")
        self.declare(node.name, variable, node.coord)

    def _local_array(self, node: Any, kind: Type) -> None:
        if kind.kind not in REALS or kind.size is None:
            raise ExpressionError(f"{node.coord}: the array {node.name} is not known here")
        if "static" in (node.storage or ()) and not kind.constant:
            raise ExpressionError(f"{node.coord}: {node.name} keeps its value between calls")
        array = Array(node.name, kind.kind, kind.size, constant=kind.constant)
        if node.init is not None:
            if not isinstance(node.init, c_ast.InitList) or len(node.init.exprs) > kind.size:
                raise ExpressionError(f"{node.coord}: these values of {node.name} are unknown here")
            for i in range(kind.size):
                # What is left out is zero.
                given = self.value(node.init.exprs[i]) if i < len(node.init.exprs) else whole(0)
                array.entries[i] = Real(self.real(given, kind.kind, node.coord), kind.kind)
        self.declare(node.name, array, node.coord)

    def _assignment(self, node: Any) -> None:
        value = self.value(node.rvalue)
        if node.op != "=":
            old = self.value(node.lvalue)
            value = self.combined(node.op[:-1], old, value, node.coord)
        if isinstance(node.lvalue, c_ast.ID):
            target = self.find(node.lvalue.name, node.coord)
            if isinstance(target, Variable):
                self.assign(target, value, node.coord)
                return
        elif isinstance(node.lvalue, c_ast.ArrayRef):
            self.store(self.element(node.lvalue), value, node.coord)
            return
        elif isinstance(node.lvalue, c_ast.UnaryOp) and node.lvalue.op == "*":
            at = self.value(node.lvalue.expr)
            if isinstance(at, Pointer):
                self.store(at, value, node.coord)
                return
        raise ExpressionError(f"{node.coord}: this assignment is not known here")

    def assign(self, variable: Variable, value: Value, where: Any) -> None:
        """Set a variable."""
        if variable.type.constant and not variable.type.depth:
            raise ExpressionError(f"{where}: the constant {variable.name} is changed")
        outer = self.lane and not any(variable in scope.values() for scope in self.inner())
        if outer:
            raise ExpressionError(f"{where}: {variable.name} is carried from lane to lane")
        if self.guards and variable.type.kind in REALS:
            raise ExpressionError(f"{where}: {variable.name} is set under a condition only")
        variable.value = self.converted(value, variable.type, where)

    def inner(self) -> list[dict[str, Variable | Array]]:
        """Scopes inside the loop over lanes."""
        return self.scopes[self.lane_scope :]

    def store(self, at: Pointer, value: Value, where: Any) -> None:
        """Set an entry of an array."""
        array, entry = at.array, self.entry(at, where)
        if array.constant:
            raise ExpressionError(f"{where}: {array.name} must not be changed")
        if entry is None:
            raise ExpressionError(
                f"{where}: {array.name}[{at.offset}] is beyond its {array.size} entries"
            )
        if self.guards:
            raise ExpressionError(f"{where}: {array.name}[{entry}] is set under a condition only")
        if self.lane and array.place is not None and not array.stride:
            raise ExpressionError(f"{where}: {array.name} is written by every lane")
        array.entries[entry] = Real(self.real(value, array.kind, where), array.kind)
        self.written = self.written or array.place is not None

    def _if(self, node: Any) -> None:
        condition = as_condition(self.value(node.cond), node.coord)
        if isinstance(condition, bool):
            taken = node.iftrue if condition else node.iffalse
            if taken is not None:
                self._block(c_ast.Compound([taken]))
            return
        variables = [v for s in self.scopes for v in s.values() if isinstance(v, Variable)]
        before = [v.value for v in variables]
        self.guards += 1
        ends: list[list[Value | None]] = []
        for branch in (node.iftrue, node.iffalse):
            for variable, value in zip(variables, before, strict=True):
                variable.value = value
            if branch is not None:
                self._block(c_ast.Compound([branch]))
            ends.append([v.value for v in variables])
        self.guards -= 1
        for variable, yes, no in zip(variables, *ends, strict=True):
            if yes != no:
                sides = (as_decision(side, node.coord) for side in (yes, no))
                variable.value = of_decision(choice(condition, *sides))

    # ------------------------------------------------------------------ loops

    def _for(self, node: Any) -> None:
        """``for (int i = a; i < b; ++i)``; over lanes where b is an argument."""
        where = node.coord
        counter = node.init.decls[0] if isinstance(node.init, c_ast.DeclList) else None
        cond, step = node.cond, node.next
        fits = (
            counter is not None
            and len(node.init.decls) == 1
            and isinstance(cond, c_ast.BinaryOp)
            and isinstance(cond.left, c_ast.ID)
            and cond.left.name == counter.name
            and cond.op == "<"
            and isinstance(step, c_ast.UnaryOp)
            and step.op in ("++", "p++")
            and isinstance(step.expr, c_ast.ID)
            and step.expr.name == counter.name
        )
        if counter is None or not fits or declared(counter).kind != "int":
            raise ExpressionError(f"{where}: a loop is expected as for (int i = 0; i < n; ++i)")
        first, last = self.value(counter.init), self.value(cond.right)
        if not isinstance(first, Whole) or not isinstance(last, Whole) or first.known is None:
            raise ExpressionError(f"{where}: the bounds of this loop are not known here")
        if last.known is None:
            self._over_lanes(node, counter, first.known, last)
            return
        if last.known - first.known > MOST_TURNS:
            raise ExpressionError(f"{where}: more than {MOST_TURNS} turns of a loop")
        for turn in range(first.known, last.known):
            self._turn(node, counter, whole(turn))

    def _turn(self, node: Any, counter: Any, value: Whole) -> None:
        kind = Type("int", True, 0, None, "const int")
        self.scopes.append({counter.name: Variable(counter.name, kind, value)})
        self.statement(node.stmt)
        self.scopes.pop()

    def _over_lanes(self, node: Any, counter: Any, first: int, last: Whole) -> None:
        """The body once, for a lane that stands for all of them."""
        if first != 0 or self.lane or self.guards or len(last.terms) != 1:
            raise ExpressionError(f"{node.coord}: a loop over all lanes is expected, i = 0 to n")
        if self.counted:
            raise ExpressionError(f"{node.coord}: a second loop over lanes is not known here")
        self.counted = str(last)
        self.lane, self.lane_scope = f"lane {counter.name}", len(self.scopes)
        self._turn(node, counter, unknown(self.lane))
        self.lane = ""
