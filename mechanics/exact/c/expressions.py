"""Expressions of C, lowered to nodes.

What C does silently is refused by name: a float beside a double, a double made an integer, an
integer quotient of what is not known. Integers beside real numbers are exact.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import casadi
from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.exact.c.condition import Atom, Choice, Condition, choice, joined, negation
from mechanics.exact.c.library import ARITHMETIC
from mechanics.exact.c.literal import literal, rounded
from mechanics.exact.c.program import BEYOND, Writer
from mechanics.exact.c.select import chosen, select
from mechanics.exact.c.types import REALS, declared
from mechanics.exact.c.values import (
    INTEGERS,
    Address,
    Array,
    Pointer,
    Real,
    Truth,
    Value,
    Variable,
    as_condition,
    as_decision,
    compared,
    of_decision,
    words,
)
from mechanics.exact.c.whole import Whole, divided, plus, times, whole


class Expressions:
    """Evaluates expressions in the scope of a function.

    Attributes
    ----------
    writer : Writer
    scopes : list of dict of str to Variable or Array
        The innermost last.
    beyond, late : list of str
        As in `CProgram`.
    written : bool
        Whether an output was written already.
    lane : Whole or None
        Which lane is at hand, inside the loop over them.
    """

    def __init__(self) -> None:
        self.writer = Writer()
        self.scopes: list[dict[str, Variable | Array]] = [{}]
        self.beyond: list[str] = []
        self.late: list[str] = []
        self.written = False
        self.lane: Whole | None = None

    def find(self, name: str, where: Any) -> Variable | Array:
        """The variable or array of a name."""
        for scope in reversed(self.scopes):
            if name in scope:
                return scope[name]
        raise ExpressionError(f"{where}: {name} is not declared")

    def call(self, node: Any) -> Value | None:
        """Value of a function call; a subclass knows the functions."""
        raise NotImplementedError

    def unwritten(self, *nodes: Any) -> None:
        """Refuse expressions that may write; a subclass knows the functions."""
        raise NotImplementedError

    def value(self, node: Any) -> Value:
        """Value of an expression."""
        if isinstance(node, c_ast.Constant):
            return self._literal(node)
        if isinstance(node, c_ast.ID):
            return self._named(node)
        if isinstance(node, c_ast.ArrayRef):
            return self.read(self.element(node), node.coord)
        if isinstance(node, c_ast.BinaryOp):
            return self._binary(node)
        if isinstance(node, c_ast.UnaryOp):
            return self._unary(node)
        if isinstance(node, c_ast.TernaryOp):
            return self._ternary(node)
        if isinstance(node, c_ast.Cast):
            return self._cast(node)
        if isinstance(node, c_ast.FuncCall):
            found = self.call(node)
            if found is None:
                raise ExpressionError(f"{node.coord}: {node.name.name} gives no value")
            return found
        raise ExpressionError(f"{node.coord}: {type(node).__name__} is not known here")

    def real(self, value: Value | None, kind: str, where: Any) -> int:
        """The node of a real number of a type.

        Raises
        ------
        ExpressionError
            If it has another type, so that C would convert it.
        """
        if isinstance(value, Real):
            if value.kind != kind:
                wrong = f"a {value.kind} stands where a {kind} is expected"
                raise ExpressionError(f"{where}: {wrong}: precisions are mixed")
            return value.node
        if isinstance(value, Truth | Choice):
            return chosen(self.writer, as_decision(value, where), kind, where)
        if isinstance(value, Whole) and value.known is not None:
            if rounded(Fraction(value.known), kind) != value.known:
                raise ExpressionError(f"{where}: no {kind} holds the integer {value.known}")
            return self.writer.number(Fraction(value.known), kind)
        raise ExpressionError(f"{where}: a {kind} is expected, {words(value)} found")

    def element(self, node: Any) -> Pointer:
        """The place in an array that ``a[i]`` names."""
        base, index = self.value(node.name), self.value(node.subscript)
        if not isinstance(base, Pointer) or not isinstance(index, Whole):
            raise ExpressionError(f"{node.coord}: an array and an integer are expected")
        return Pointer(base.array, plus(base.offset, index))

    def entry(self, at: Pointer, where: Any) -> int | None:
        """Entry of an array, of this lane where it has lanes; None beyond its end.

        Raises
        ------
        ExpressionError
            If it is no entry of this lane.
        """
        array = at.array
        if array.stride:
            rest = dict(plus(at.offset, self.lane or whole(0), -1).terms)
            found = rest.pop((array.stride,), 0)
            if self.lane is None or rest:
                raise ExpressionError(
                    f"{where}: {array.name}[{at.offset}] is no entry of the lane"
                    f" {self.lane or '(outside of the loop over lanes)'}:"
                    f" k * {array.stride} + lane is expected"
                )
        elif at.offset.known is None:
            raise ExpressionError(f"{where}: {array.name}[{at.offset}] is no entry that is known")
        else:
            found = at.offset.known
        return found if 0 <= found < array.size else None

    def read(self, at: Pointer, where: Any) -> Value:
        """Value of an entry."""
        array, entry = at.array, self.entry(at, where)
        if array.kind not in REALS:
            raise ExpressionError(f"{where}: arrays of {array.kind} are not known here")
        if entry is None:
            self.beyond.append(f"{where}: {array.name}[{at.offset}]")
            node = self.writer.input(BEYOND, len(self.beyond) - 1, array.kind)
            return Real(node, array.kind)
        if array.place is None or not array.constant:
            if entry not in array.entries:
                raise ExpressionError(f"{where}: {array.name}[{entry}] is read before it is set")
            return Real(array.entries[entry][-1].node, array.kind)
        if self.written:
            self.late.append(f"{where}: {array.name}[{at.offset}]")
        return Real(self.writer.input(array.place, entry, array.kind), array.kind)

    def _literal(self, node: Any) -> Value:
        if node.type in ("char", "string"):
            raise ExpressionError(f"{node.coord}: {node.value} is not known here")
        kind, value = literal(node.value)
        return whole(int(value)) if kind == "int" else Real(self.writer.number(value, kind), kind)

    def _named(self, node: Any) -> Value:
        found = self.find(node.name, node.coord)
        if isinstance(found, Array):
            return Pointer(found, whole(0))
        if found.value is None:
            raise ExpressionError(f"{node.coord}: {node.name} is read before it is set")
        return found.value

    def _unary(self, node: Any) -> Value:
        if node.op == "&":
            found = self.find(node.expr.name, node.coord) if type(node.expr) is c_ast.ID else None
            if isinstance(found, Variable):
                return Address(found)
            if isinstance(node.expr, c_ast.ArrayRef):
                return self.element(node.expr)
            raise ExpressionError(f"{node.coord}: this address is not known here")
        value = self.value(node.expr)
        if node.op == "!":
            return Truth(negation(self.condition(value, node.coord)))
        if node.op == "*" and isinstance(value, Pointer):
            return self.read(value, node.coord)
        if node.op == "+":
            return value
        if node.op == "-" and isinstance(value, Whole):
            return times(whole(-1), value)
        if node.op == "-" and isinstance(value, Real):
            constant = self.writer.nodes[value.node].constant
            if constant is not None:
                return Real(self.writer.number(-constant, value.kind), value.kind)
            return Real(self.writer.add(casadi.OP_NEG, (value.node,), value.kind), value.kind)
        raise ExpressionError(f"{node.coord}: {node.op} of {words(value)} is not known here")

    def condition(self, value: Value, where: Any) -> Condition:
        """A value that decides; a real number does by being zero or not."""
        if isinstance(value, Real):
            zero = self.writer.number(Fraction(0), value.kind)
            return Atom("==", (value.node, zero), False)
        return as_condition(value, where)

    def _binary(self, node: Any) -> Value:
        if node.op in ("&&", "||"):
            self.unwritten(node.right)
        elif not isinstance(node.right, c_ast.Constant):
            # C may begin with either side.
            self.unwritten(node.left, node.right)
        left, right = self.value(node.left), self.value(node.right)
        return self.combined(node.op, left, right, node.coord)

    def combined(self, op: str, left: Value, right: Value, where: Any) -> Value:
        """left op right."""
        if op in ("&&", "||"):
            sides = (self.condition(left, where), self.condition(right, where))
            return Truth(joined(op == "&&", *sides))
        if isinstance(left, Whole) and isinstance(right, Whole):
            return _integer(op, left, right, where)
        if isinstance(left, Pointer) and isinstance(right, Whole) and op in "+-":
            return Pointer(left.array, plus(left.offset, right, 1 if op == "+" else -1))
        kinds = {side.kind for side in (left, right) if isinstance(side, Real)}
        if not kinds and op in INTEGERS:
            return of_decision(compared(op, as_decision(left, where), as_decision(right, where)))
        if not kinds:
            raise ExpressionError(f"{where}: {words(left)} {op} {words(right)} is not known here")
        if len(kinds) > 1:
            raise ExpressionError(f"{where}: a float stands beside a double: precisions are mixed")
        (kind,) = kinds
        x, y = self.real(left, kind, where), self.real(right, kind, where)
        if op in ARITHMETIC:
            return Real(self.writer.add(ARITHMETIC[op], (x, y), kind), kind)
        if op in (">", ">="):
            x, y, op = y, x, op.replace(">", "<")
        if op in ("<", "<=", "=="):
            return Truth(Atom(op, (x, y)))
        if op == "!=":
            return Truth(Atom("==", (x, y), False))
        raise ExpressionError(f"{where}: {op} of real numbers is not known here")

    def _ternary(self, node: Any) -> Value:
        self.unwritten(node.iftrue, node.iffalse)
        yes, no = self.value(node.iftrue), self.value(node.iffalse)
        if isinstance(node.cond, c_ast.BinaryOp) and node.cond.op == "<":
            sides = self.value(node.cond.left), self.value(node.cond.right)
            if sides == (yes, no) and isinstance(yes, Whole) and isinstance(no, Whole):
                return self.least(yes, no, node.coord)
        condition = self.condition(self.value(node.cond), node.coord)
        kinds = {side.kind for side in (yes, no) if isinstance(side, Real)}
        if not kinds:
            return of_decision(choice(condition, *(as_decision(s, node.coord) for s in (yes, no))))
        kind = kinds.pop()
        x, y = (self.real(side, kind, node.coord) for side in (yes, no))
        return Real(select(self.writer, condition, x, y, kind, node.coord), kind)

    def least(self, left: Whole, right: Whole, where: Any) -> Whole:
        """``left < right ? left : right``."""
        x, y = left.known, right.known
        if x is None or y is None:
            raise ExpressionError(f"{where}: which of {left} and {right} is less is not known here")
        return whole(min(x, y))

    def _cast(self, node: Any) -> Value:
        kind, value = declared(node.to_type), self.value(node.expr)
        if kind.depth == 0 and kind.kind in REALS:
            return Real(self.real(value, kind.kind, node.coord), kind.kind)
        if kind.depth == 0 and kind.kind == "int" and isinstance(value, Whole):
            return value
        raise ExpressionError(
            f"{node.coord}: a cast of {words(value)} to {kind.words} is not known here"
        )


def _integer(op: str, left: Whole, right: Whole, where: Any) -> Value:
    if op in ("+", "-"):
        return plus(left, right, 1 if op == "+" else -1)
    if op == "*":
        return times(left, right)
    try:
        if op in ("/", "%"):
            return divided(left, right, op == "%")
    except ExpressionError as error:
        raise ExpressionError(f"{where}: {error}") from None
    x, y = left.known, right.known
    far = op in ("<<", ">>") and y is not None and not 0 <= y < 32
    if x is None or y is None or far or op not in INTEGERS:
        raise ExpressionError(f"{where}: {left} {op} {right} is not known here")
    return whole(int(INTEGERS[op](x, y)))
