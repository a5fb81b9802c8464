"""A C function as straight-line code: ``lower(source, name, parameters) -> CProgram``.

    int f(const double q[2], double ud[2])     q[0], q[1] -> nodes,   nodes -> ud[0], ud[1], status

Arguments are bound by their place, whatever the text calls them. Functions of the same file are
read where they are called; those of the library are operations.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi
from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.exact.c.condition import Atom
from mechanics.exact.c.library import FAR, FUNCTIONS, FUSED, SINCOS
from mechanics.exact.c.parse import Source
from mechanics.exact.c.program import CProgram, Parameter
from mechanics.exact.c.types import declared, parameters, signature
from mechanics.exact.c.unsigned import Integers, has_unsigned
from mechanics.exact.c.values import (
    Address,
    Array,
    Pointer,
    Real,
    Truth,
    Value,
    Variable,
    as_decision,
)
from mechanics.exact.c.whole import unknown

DEEPEST = 8
"""Calls of own functions inside each other."""


def lower(source: Source, name: str, given: Sequence[Parameter]) -> CProgram:
    """Read a C function.

    Parameters
    ----------
    source : Source
    name : str
    given : sequence of Parameter
        What its arguments are, in order.

    Raises
    ------
    ExpressionError
        For a construct that is not known here, or arguments of other types; by file and line.
    """
    if name not in source.functions:
        raise ExpressionError(f"{source.file}: there is no function {name}")
    function = source.functions[name]
    declarations = {signature(p.type) for p in source.prototypes[name]}
    if len(declarations) > 1:
        raise ExpressionError(
            f"{function.coord}: {name} is declared as {' and as '.join(sorted(declarations))}"
        )
    machine = Functions(source)
    arrays = machine.arguments(function, given)
    result = machine.body(function)
    returns = declared(_returned(function)).kind
    outputs = {
        (array.place, entry): tuple(written)
        for array in arrays
        if array.place is not None and not array.constant
        for entry, written in array.entries.items()
    }
    status = None if returns == "void" else as_decision(result, function.coord)
    writer = machine.writer
    return CProgram(
        name, tuple(writer.nodes), tuple(writer.kinds), outputs, status,
        tuple(machine.beyond), tuple(machine.late), machine.counted,
    )  # fmt: skip


def _returned(function: Any) -> Any:
    return c_ast.Typename(None, [], None, function.decl.type.type, function.coord)


class Functions(Integers):
    """Arguments and calls."""

    def __init__(self, source: Source) -> None:
        super().__init__(has_unsigned(source))
        self.source = source
        self.depth = 0

    def arguments(self, function: Any, given: Sequence[Parameter]) -> list[Array]:
        """Declare the arguments of the function that is read; arrays in order."""
        known = parameters(function.decl.type)
        where = function.coord
        if len(known) != len(given):
            raise ExpressionError(
                f"{where}: {function.decl.name} has {len(known)} arguments,"
                f" {len(given)} are expected: {', '.join(p.name for p in given)}"
            )
        arrays: list[Array] = []
        for place, (p, declaration) in enumerate(zip(given, known, strict=True)):
            kind = declared(declaration)
            expected = "int" if p.kind == "size_t" else p.kind
            if kind.kind != expected or kind.depth != (0 if expected == "int" else 1):
                raise ExpressionError(
                    f"{where}: argument {place + 1}, {declaration.name}, is {kind.words}:"
                    f" {p.name} of type {p.kind} is expected"
                )
            if kind.depth and (p.output is kind.constant or kind.size not in (None, p.size)):
                raise ExpressionError(
                    f"{where}: argument {place + 1}, {declaration.name}, is declared as"
                    f" {kind.words} with {kind.size} entries: {p.name} has {p.size}, and is"
                    f" {'written' if p.output else 'read'}"
                )
            if not kind.depth:
                counter = Variable(declaration.name, kind, unknown(p.name))
                self.declare(declaration.name, counter, where)
                continue
            array = Array(declaration.name, kind.kind, p.size, place, p.stride, not p.output)
            self.declare(declaration.name, array, where)
            arrays.append(array)
        return arrays

    def body(self, function: Any) -> Value | None:
        """Run the statements of a function; what it returns."""
        *statements, last = function.body.block_items or [c_ast.EmptyStatement()]
        for statement in statements:
            self.statement(statement)
        if isinstance(last, c_ast.Return):
            returned = declared(_returned(function))
            return self.converted(self.value(last.expr), returned, last.coord)
        self.statement(last)
        if declared(_returned(function)).kind != "void":
            raise ExpressionError(f"{function.coord}: {function.decl.name} returns nothing")
        return None

    def call(self, node: Any) -> Value | None:
        """A call of the library, of what stands in for it, or of another function of the file."""
        name = getattr(node.name, "name", "")
        given = node.args.exprs if node.args else []
        if any(name in scope for scope in self.scopes):
            raise ExpressionError(f"{node.coord}: {name} is a variable here, and is called")
        if name == "isfinite" and len(given) == 1:
            value = self.value(given[0])
            if isinstance(value, Real):
                return Truth(Atom("finite", (value.node,)), exact=False)
        elif name in FAR and len(given) == 1:
            angle = self.real(self.value(given[0]), FAR[name], node.coord)
            return Truth(Atom("far", (angle,)))
        elif name in SINCOS and len(given) == 3:
            self._sincos(node, SINCOS[name])
            return None
        elif name in FUSED and len(given) == 3:
            kind = FUSED[name]
            x, y, z = (self.real(self.value(g), kind, node.coord) for g in given)
            product = self.writer.add(casadi.OP_MUL, (x, y), kind)
            return Real(self.writer.add(casadi.OP_ADD, (product, z), kind), kind)
        elif name in FUNCTIONS and len(given) == FUNCTIONS[name].arity:
            op, _, kind = FUNCTIONS[name]
            nodes = tuple(self.real(self.value(g), kind, node.coord) for g in given)
            return Real(self.writer.add(op, nodes, kind), kind)
        elif name in self.source.functions:
            return self._own(self.source.functions[name], given, node.coord)
        raise ExpressionError(f"{node.coord}: the call {name}() is not known here")

    def unwritten(self, *nodes: Any) -> None:
        """Refuse calls that write where C may leave them out, or reorder them."""
        for node in nodes:
            name = getattr(node.name, "name", "") if isinstance(node, c_ast.FuncCall) else ""
            if name in SINCOS or (name in self.source.functions and self._writes(name)):
                raise ExpressionError(f"{node.coord}: {name}() may write, inside an expression")
            self.unwritten(*(child for _, child in node.children()))

    def _writes(self, name: str) -> bool:
        kinds = [declared(p) for p in parameters(self.source.functions[name].decl.type)]
        return any(kind.depth and not kind.constant for kind in kinds)

    def _sincos(self, node: Any, kind: str) -> None:
        angle, *targets = node.args.exprs
        x = self.real(self.value(angle), kind, node.coord)
        for op, target in zip((casadi.OP_SIN, casadi.OP_COS), targets, strict=True):
            at = self.value(target)
            real = Real(self.writer.add(op, (x,), kind), kind)
            if isinstance(at, Address):
                self.assign(at.variable, real, node.coord)
            elif isinstance(at, Pointer):
                self.store(at, real, node.coord)
            else:
                raise ExpressionError(f"{node.coord}: an address is expected")

    def _own(self, function: Any, given: Sequence[Any], where: Any) -> Value | None:
        known = parameters(function.decl.type)
        if self.depth == DEEPEST or len(known) != len(given):
            raise ExpressionError(f"{where}: the call {function.decl.name}() is not known here")
        scope: dict[str, Variable | Array] = {}
        for declaration, argument in zip(known, given, strict=True):
            kind = declared(declaration)
            value = self.converted(self.value(argument), kind, where)
            guards = len(self.guards)
            scope[declaration.name] = Variable(declaration.name, kind, value, guards)
        # The scopes of the caller are out of sight.
        outer, self.scopes = self.scopes, [scope]
        inside, self.lane_scope = self.lane_scope, 0
        self.depth += 1
        result = self.body(function)
        self.depth -= 1
        self.scopes, self.lane_scope = outer, inside
        return result
