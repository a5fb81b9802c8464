"""Statements of C, run once.

    if (...) status = 2;            both ways, and what differs afterwards depends on the condition
    if (...) continue;              the rest under the opposite condition

Inputs may be the same arrays as outputs, so a read after a write is noted. A variable that is read
before it is set, a constant that is changed, a number that is set under a condition are refused; an
output may be written under one.
"""

from __future__ import annotations

from typing import Any

from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.exact.c.condition import Condition, choice, joined, negation
from mechanics.exact.c.loops import Guard, Loops
from mechanics.exact.c.program import Written
from mechanics.exact.c.types import REALS, Type, declared
from mechanics.exact.c.values import (
    Array,
    Pointer,
    Real,
    Value,
    Variable,
    as_decision,
    of_decision,
)
from mechanics.exact.c.whole import Whole, whole


class Statements(Loops):
    """Runs statements."""

    def declare(self, name: str, thing: Variable | Array, where: Any) -> None:
        """Add to the innermost scope."""
        if name in self.scopes[-1]:
            raise ExpressionError(f"{where}: {name} is declared twice")
        thing.guards = len(self.guards)
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
            self.loop(node)
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
        depth = len(self.guards)
        for statement in node.block_items or ():
            if _is_skip(statement):
                # What follows runs where this does not hold.
                condition = negation(self.condition(self.value(statement.cond), statement.coord))
                if condition is not True:
                    self.guards.append(Guard(condition, False))
            else:
                self.statement(statement)
        del self.guards[depth:]
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
                number = self.real(given, kind.kind, node.coord)
                array.entries[i] = [Written(True, number)]
        self.declare(node.name, array, node.coord)

    def _assignment(self, node: Any) -> None:
        value = self.value(node.rvalue)
        if node.op != "=":
            old = self.value(node.lvalue)
            value = self.combined(node.op[:-1], old, value, node.coord)
        if isinstance(node.lvalue, c_ast.ID):
            target = self.find(node.lvalue.name, node.coord)
            if isinstance(target, Variable):
                gathers = node.op == "|=" and target.type.kind == "int"
                self.assign(target, value, node.coord, gathers)
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

    def assign(self, variable: Variable, value: Value, where: Any, gathers: bool = False) -> None:
        """Set a variable; `gathers` where a flag gathers what all lanes say."""
        if variable.type.constant and not variable.type.depth:
            raise ExpressionError(f"{where}: the constant {variable.name} is changed")
        if not gathers and not self.is_own(variable):
            raise ExpressionError(f"{where}: {variable.name} is carried from lane to lane")
        guards = [guard for guard in self.guards[variable.guards :] if guard.condition is not True]
        if guards and (variable.type.kind in REALS or not all(guard.both for guard in guards)):
            raise ExpressionError(f"{where}: {variable.name} is set under a condition only")
        variable.value = self.converted(value, variable.type, where)

    def store(self, at: Pointer, value: Value, where: Any) -> None:
        """Set an entry of an array."""
        array, entry = at.array, self.entry(at, where)
        if array.constant:
            raise ExpressionError(f"{where}: {array.name} must not be changed")
        if entry is None:
            raise ExpressionError(
                f"{where}: {array.name}[{at.offset}] is beyond its {array.size} entries"
            )
        outside = array.place is not None
        if self.lane and outside and not array.stride:
            raise ExpressionError(f"{where}: {array.name} is written by every lane")
        condition: Condition = True
        for guard in self.guards[array.guards :]:
            condition = joined(True, condition, guard.condition)
        if condition is not True and not outside:
            raise ExpressionError(f"{where}: {array.name}[{entry}] is set under a condition only")
        written = Written(condition, self.real(value, array.kind, where))
        if condition is not False:
            before = [] if condition is True else array.entries.get(entry, [])
            array.entries[entry] = [*before, written]
            self.written = self.written or outside

    def _if(self, node: Any) -> None:
        condition = self.condition(self.value(node.cond), node.coord)
        variables = [v for s in self.scopes for v in s.values() if isinstance(v, Variable)]
        before = [v.value for v in variables]
        ends: list[list[Value | None]] = []
        written, outputs = self.written, False
        # What is never run has to be known, too.
        for branch, holds in ((node.iftrue, condition), (node.iffalse, negation(condition))):
            for variable, value in zip(variables, before, strict=True):
                variable.value = value
            self.written = written
            if branch is not None:
                self.guards.append(Guard(holds, True))
                self._block(c_ast.Compound([branch]))
                self.guards.pop()
            ends.append([v.value for v in variables])
            outputs = outputs or self.written
        self.written = outputs
        for variable, yes, no in zip(variables, *ends, strict=True):
            if isinstance(condition, bool):
                variable.value = yes if condition else no
            elif yes != no:
                sides = (as_decision(side, node.coord) for side in (yes, no))
                variable.value = of_decision(choice(condition, *sides))


def _is_skip(node: Any) -> bool:
    """``if (...) continue;``."""
    if not isinstance(node, c_ast.If) or node.iffalse is not None:
        return False
    return isinstance(node.iftrue, c_ast.Continue)
