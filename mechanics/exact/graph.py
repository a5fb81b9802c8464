"""A CasADi SX graph evaluated over any arithmetic, instruction by instruction.

Work slots are overwritten as the virtual machine goes, so the instructions are first rewritten with
one node a value (static single assignment); an angle can then be traced back to the inputs and
expanded into a rational linear combination of their monomials, as SymPy's arguments are.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import casadi

from mechanics.errors import ExpressionError
from mechanics.exact.graph_angles import Node, Tracer
from mechanics.program.casadi_reader import single_assignment

if TYPE_CHECKING:
    from mechanics.exact.arithmetic import Arithmetic

Binary = Callable[["Arithmetic", Any, Any], Any]
Unary = Callable[["Arithmetic", Any], Any]


def evaluate(a: Arithmetic, function: Any, arguments: Sequence[Sequence[Any]]) -> list[list[Any]]:
    """Return the dense outputs of an SX function over `a`, column by column.

    Raises
    ------
    ExpressionError
        If the function is no SX function, an argument has the wrong length, or an operation is
        unknown.
    """
    if not function.is_a("SXFunction"):
        raise ExpressionError(
            f"casadi function {function.name()} is no SX graph: call expand() on it first"
        )
    inputs = [_stored(function, index, group) for index, group in _checked(function, arguments)]
    nodes, stores = single_assignment(function)
    numbers = evaluated(a, nodes, inputs)
    outputs = [[a.rational(0)] * function.nnz_out(i) for i in range(function.n_out())]
    for output, entry, source in stores:
        outputs[output][entry] = numbers[source]
    return [_dense(a, function, index, entries) for index, entries in enumerate(outputs)]


def evaluated(
    a: Arithmetic,
    nodes: Sequence[Node],
    inputs: Sequence[Sequence[Any]],
    whole_angles: bool = False,
) -> list[Any]:
    """Return the number of every node of straight-line code; inputs are (group, entry).

    Angles kept whole are enough where both sides compute the same angles: sin(a + b) is then not
    known to be sin(a) cos(b) + cos(a) sin(b), but is the same however a + b was computed.

    Raises
    ------
    ExpressionError
        If an operation is unknown.
    """
    numbers: list[Any] = []
    tracer = Tracer(a, nodes, numbers, inputs, whole_angles)
    for node in nodes:
        numbers.append(_number(a, node, numbers, inputs, tracer))
    return numbers


def _checked(function: Any, arguments: Sequence[Sequence[Any]]) -> list[tuple[int, Sequence[Any]]]:
    if len(arguments) != function.n_in():
        raise ExpressionError(
            f"casadi function {function.name()} has {function.n_in()} inputs, "
            f"{len(arguments)} groups of arguments found: pass one group for each input"
        )
    for index, group in enumerate(arguments):
        if len(group) != function.numel_in(index):
            raise ExpressionError(
                f"input {function.name_in(index)} of {function.name()} has "
                f"{function.numel_in(index)} entries, {len(group)} found: pass all of them"
            )
    return list(enumerate(arguments))


def _stored(function: Any, index: int, group: Sequence[Any]) -> list[Any]:
    """Return the structurally nonzero entries among the dense ones."""
    return [group[position] for position in function.sparsity_in(index).find()]


def _dense(a: Arithmetic, function: Any, index: int, entries: list[Any]) -> list[Any]:
    result = [a.rational(0)] * function.numel_out(index)
    for position, entry in zip(function.sparsity_out(index).find(), entries, strict=True):
        result[position] = entry
    return result


def _number(
    a: Arithmetic,
    node: Node,
    numbers: list[Any],
    inputs: Sequence[Sequence[Any]],
    tracer: Tracer,
) -> Any:
    op, operands, constant = node
    if constant is not None:
        return a.rational(constant)
    if op == casadi.OP_INPUT:
        return inputs[operands[0]][operands[1]]
    if op in _CIRCULAR:
        return _CIRCULAR[op](*tracer.circle(operands[0]))
    if op in _EXPONENTIAL:
        return _EXPONENTIAL[op](tracer.exponential(operands[0]))
    if op in (casadi.OP_POW, casadi.OP_CONSTPOW):
        return tracer.power(*operands)
    parts = [numbers[operand] for operand in operands]
    if op in _UNARY:
        return _UNARY[op](a, parts[0])
    if op in _BINARY:
        return _BINARY[op](a, *parts)
    raise ExpressionError(
        f"casadi operation {_name(op)} has no exact meaning here: write the expression without it"
    )


def _name(op: int) -> str:
    names = [n for n in dir(casadi) if n.startswith("OP_") and getattr(casadi, n) == op]
    return names[0] if names else str(op)


_CIRCULAR: dict[int, Callable[[Any, Any], Any]] = {
    casadi.OP_SIN: lambda c, s: s,
    casadi.OP_COS: lambda c, s: c,
    casadi.OP_TAN: lambda c, s: s / c,
}

_EXPONENTIAL: dict[int, Callable[[Any], Any]] = {
    casadi.OP_EXP: lambda e: e,
    casadi.OP_EXPM1: lambda e: e - 1,
    casadi.OP_SINH: lambda e: (e - 1 / e) / 2,
    casadi.OP_COSH: lambda e: (e + 1 / e) / 2,
    casadi.OP_TANH: lambda e: (e * e - 1) / (e * e + 1),
}

_UNARY: dict[int, Unary] = {
    casadi.OP_ASSIGN: lambda a, x: x,
    casadi.OP_NEG: lambda a, x: -x,
    casadi.OP_SQ: lambda a, x: x * x,
    casadi.OP_TWICE: lambda a, x: x + x,
    casadi.OP_INV: lambda a, x: 1 / x,
    casadi.OP_SQRT: lambda a, x: a.sqrt(x),
    casadi.OP_FABS: lambda a, x: a.absolute(x),
    casadi.OP_SIGN: lambda a, x: a.sign(x),
    casadi.OP_NOT: lambda a, x: 1 - x,
    casadi.OP_LOG: lambda a, x: a.function("log", [x]),
    casadi.OP_LOG1P: lambda a, x: a.function("log", [1 + x]),
    casadi.OP_ASIN: lambda a, x: a.function("asin", [x]),
    casadi.OP_ACOS: lambda a, x: a.function("acos", [x]),
    casadi.OP_ATAN: lambda a, x: a.function("atan", [x]),
    casadi.OP_ASINH: lambda a, x: a.function("asinh", [x]),
    casadi.OP_ACOSH: lambda a, x: a.function("acosh", [x]),
    casadi.OP_ATANH: lambda a, x: a.function("atanh", [x]),
    casadi.OP_ERF: lambda a, x: a.function("erf", [x]),
    casadi.OP_FLOOR: lambda a, x: a.function("floor", [x]),
    casadi.OP_CEIL: lambda a, x: a.function("ceil", [x]),
}


def _whole_part(a: Arithmetic, x: Any) -> Any:
    """What is left of a number without its decimals."""
    return a.sign(x) * a.function("floor", [a.absolute(x)])


_BINARY: dict[int, Binary] = {
    casadi.OP_ADD: lambda a, x, y: x + y,
    casadi.OP_SUB: lambda a, x, y: x - y,
    casadi.OP_MUL: lambda a, x, y: x * y,
    casadi.OP_DIV: lambda a, x, y: x / y,
    casadi.OP_FMAX: lambda a, x, y: (x + y + a.absolute(x - y)) / 2,
    casadi.OP_FMIN: lambda a, x, y: (x + y - a.absolute(x - y)) / 2,
    casadi.OP_HYPOT: lambda a, x, y: a.sqrt(x * x + y * y),
    casadi.OP_ATAN2: lambda a, y, x: a.function("atan2", [y, x]),
    casadi.OP_FMOD: lambda a, x, y: x - y * _whole_part(a, x / y),
    casadi.OP_COPYSIGN: lambda a, x, y: a.absolute(x) * a.sign(y),
    casadi.OP_LT: lambda a, x, y: a.indicator("<", x - y),
    casadi.OP_LE: lambda a, x, y: a.indicator("<=", x - y),
    casadi.OP_EQ: lambda a, x, y: a.indicator("==", x - y),
    casadi.OP_NE: lambda a, x, y: 1 - a.indicator("==", x - y),
    casadi.OP_AND: lambda a, x, y: x * y,
    casadi.OP_OR: lambda a, x, y: x + y - x * y,
    casadi.OP_IF_ELSE_ZERO: lambda a, c, x: a.select(c, x, a.rational(0)),
}
