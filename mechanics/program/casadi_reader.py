"""CasADi functions as nodes.

A graph's constants are doubles, and each is the dyadic rational that it is: 0.333... is no third,
unless the caller recognises it. What a graph computes on one side of `if_else` alone stands under
that condition, since the other side discards it.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import isfinite
from typing import NamedTuple

import casadi

from mechanics.errors import ExpressionError
from mechanics.program.as_written import AsWritten
from mechanics.program.branches import Choice, Parts, build
from mechanics.program.builder import Builder, Node
from mechanics.program.composed import COMPOSED
from mechanics.program.operations import OPERATIONS
from mechanics.program.routine import Routine, built


class Instruction(NamedTuple):
    """One value of straight-line code: operation of CasADi, operands, constant.

    Operands are numbers of earlier instructions; those of an input are (input, entry).
    """

    op: int
    operands: tuple[int, ...]
    constant: Fraction | None


def read(
    builder: Builder,
    function: casadi.Function,
    arguments: Mapping[str, Sequence[Node]] | None = None,
) -> dict[str, tuple[Node, ...]]:
    """Nodes of the outputs of a CasADi function.

    Parameters
    ----------
    function : casadi.Function
        A graph of scalars (SX), or what expands to one.
    arguments : mapping of str to sequence of Node, optional
        Entries of an input, row by row. By default inputs of the builder: ``"x"`` for a scalar,
        ``"x[0]"`` and so on for a vector or matrix.

    Returns
    -------
    dict of str to tuple of Node
        Entries of each output, row by row.

    Raises
    ------
    ExpressionError
        If the function does not expand, an argument has another number of entries, a constant is
        not finite, or an operation is not supported, which is named.

    Examples
    --------
    >>> x = casadi.SX.sym("x", 2)
    >>> f = casadi.Function("f", [x], [x[0] / x[1] + casadi.sin(x[0])], ["x"], ["y"])
    >>> b = Builder()
    >>> b.program(read(b, f))
    <program of 3 operations: y>
    """
    function = _graph(function)
    instructions, stores = single_assignment(function)
    entries = [_entries(builder, function, i, arguments or {}) for i in range(function.n_in())]
    nodes = nodes_of(builder, instructions, entries, [value for _, _, value in stores])
    outputs: dict[str, tuple[Node, ...]] = {}
    for index in range(function.n_out()):
        stored = {e: n for (o, e, _), n in zip(stores, nodes, strict=True) if o == index}
        rows, columns = function.size_out(index)
        dense = [builder.zero] * (rows * columns)
        for entry, place in enumerate(function.sparsity_out(index).find()):
            dense[place % rows * columns + place // rows] = stored[entry]
        outputs[function.name_out(index)] = tuple(dense)
    return outputs


def read_routine(
    function: casadi.Function, numbers: Sequence[Fraction | None] | None = None
) -> Routine:
    """A function of dense SX arrays as it stands, operation by operation.

    Parameters
    ----------
    numbers : sequence of Fraction or None, optional
        What the entries of the last input are; it keeps those of which none is given.

    Raises
    ------
    ExpressionError
        If an operation is not supported, which is named, or a constant is not finite.
    """
    builder, (instructions, stores) = AsWritten(), single_assignment(function)
    # Made first they stand first in sums and products: 2 x, not x 2.
    builder.constant(2)
    for instruction in instructions:
        if instruction.constant is not None:
            builder.constant(instruction.constant)
    for exact in numbers or ():
        if exact is not None:
            builder.constant(exact)
    inputs = [(function.name_in(i), function.numel_in(i)) for i in range(function.n_in())]
    entries = [[builder.input(f"{name}[{k}]") for k in range(size)] for name, size in inputs]
    if numbers is not None:
        name, _ = inputs.pop()
        left = iter(entries[-1])
        entries[-1] = [next(left) if n is None else builder.constant(n) for n in numbers]
        inputs.append((name, numbers.count(None)))
    every = nodes_of(builder, instructions, entries, range(len(instructions)))
    shapes = tuple((function.name_out(i), function.size_out(i)) for i in range(function.n_out()))
    outputs = {name: [builder.zero] * (rows * columns) for name, (rows, columns) in shapes}
    for output, entry, number in stores:
        outputs[shapes[output][0]][entry] = every[number]
    return built(function.name(), builder, outputs, tuple(inputs), shapes)


def nodes_of(
    builder: Builder,
    instructions: Sequence[Instruction],
    inputs: Sequence[Sequence[Node]],
    wanted: Sequence[int],
) -> tuple[Node, ...]:
    """Nodes of some values of straight-line code, each branch under its condition.

    Parameters
    ----------
    inputs : sequence of sequence of Node
        Entries of each input.
    wanted : sequence of int
        Numbers of instructions.

    Raises
    ------
    ExpressionError
        If an operation is not supported, which is named.
    """
    return build(builder, wanted, _expansion(builder, instructions, inputs))


def _graph(function: casadi.Function) -> casadi.Function:
    if function.is_a("SXFunction"):
        return function
    try:
        return function.expand()
    except RuntimeError as error:
        reason = str(error).strip().splitlines()[-1]
        raise ExpressionError(
            f"casadi function {function.name()} does not expand to scalars: {reason}"
        ) from error


def _entries(
    builder: Builder, function: casadi.Function, index: int, arguments: Mapping[str, Sequence[Node]]
) -> list[Node]:
    """Nodes of the stored entries of an input."""
    name, (rows, columns) = function.name_in(index), function.size_in(index)
    size = rows * columns
    nodes = arguments.get(name)
    if nodes is None:
        names = [name] if size == 1 else [f"{name}[{k}]" for k in range(size)]
        nodes = [builder.input(entry) for entry in names]
    if len(nodes) != size:
        raise ExpressionError(
            f"input {name} of {function.name()} has {size} entries, {len(nodes)} found:"
            " pass all of them, row by row"
        )
    places = function.sparsity_in(index).find()
    return [nodes[place % rows * columns + place // rows] for place in places]


def single_assignment(
    function: casadi.Function,
) -> tuple[list[Instruction], list[tuple[int, int, int]]]:
    """Each value once, and (output, entry, value): CasADi's own slots are used again and again."""
    values: list[Instruction] = []
    stores: list[tuple[int, int, int]] = []
    slots: dict[int, int] = {}
    for k in range(function.n_instructions()):
        operation = function.instruction_id(k)
        operands = tuple(function.instruction_input(k))
        if operation == casadi.OP_OUTPUT:
            output, entry = function.instruction_output(k)
            stores.append((output, entry, slots[operands[0]]))
            continue
        constant = None
        if operation == casadi.OP_CONST:
            constant = _rational(function, function.instruction_constant(k))
        elif operation != casadi.OP_INPUT:
            operands = tuple(slots[slot] for slot in operands)
        slots[function.instruction_output(k)[0]] = len(values)
        values.append(Instruction(operation, operands, constant))
    return values, stores


def _rational(function: casadi.Function, constant: float) -> Fraction:
    if not isfinite(constant):
        raise ExpressionError(
            f"casadi function {function.name()} holds the constant {constant}, which is not finite:"
            " it has no exact value"
        )
    return Fraction(constant)


_NOUGHT = -1
"""Stands for the constant 0 among the numbers of values."""


def _expansion(
    builder: Builder, instructions: Sequence[Instruction], entries: Sequence[Sequence[Node]]
) -> Callable[[int], Parts | Choice]:
    def expand(number: int) -> Parts | Choice:
        if number == _NOUGHT:
            return Parts((), lambda: builder.zero_number)
        operation, operands, constant = instructions[number]
        if constant is not None:
            return Parts((), lambda: builder.constant(constant).number)
        if operation == casadi.OP_INPUT:
            group, entry = operands
            return Parts((), lambda: entries[group][entry].number)
        if operation == casadi.OP_IF_ELSE_ZERO:
            condition, value = operands
            return Choice(condition, value, _NOUGHT)
        if operation == casadi.OP_ADD and (choice := _either(instructions, *operands)):
            return choice
        rule = _RULES.get(operation)
        if rule is None:
            raise ExpressionError(
                f"casadi operation {_name(operation)} is not supported:"
                " write the expression without it"
            )

        def apply(*numbers: int) -> int:
            return rule(builder, *[Node(builder, number) for number in numbers]).number

        return Parts(operands, apply)

    return expand


def _either(instructions: Sequence[Instruction], x: int, y: int) -> Choice | None:
    """(c ? a : 0) + (!c ? b : 0), which is what CasADi makes of `if_else`."""
    first, second = instructions[x], instructions[y]
    if {first.op, second.op} != {casadi.OP_IF_ELSE_ZERO}:
        return None
    for (condition, yes), (other, no) in (
        (first.operands, second.operands), (second.operands, first.operands)
    ):  # fmt: skip
        negation = instructions[other]
        if negation.op == casadi.OP_NOT and negation.operands[0] == condition:
            return Choice(condition, yes, no)
    return None


def _name(operation: int) -> str:
    names = [n for n in dir(casadi) if n.startswith("OP_") and getattr(casadi, n) == operation]
    return names[0] if names else str(operation)


def _call(name: str) -> Callable[..., Node]:
    return lambda b, *operands: b.call(name, *operands)


_RULES: dict[int, Callable[..., Node]] = {
    getattr(casadi, row.casadi): _call(row.name) for row in OPERATIONS if row.casadi
} | {
    casadi.OP_ASSIGN: lambda b, x: x,
    casadi.OP_SQ: lambda b, x: x * x,
    casadi.OP_TWICE: lambda b, x: x * 2,
    casadi.OP_INV: lambda b, x: 1 / x,
    casadi.OP_CONSTPOW: lambda b, x, y: x.power(y),
    casadi.OP_NE: COMPOSED["not_equal"].build,
    **{getattr(casadi, f"OP_{name.upper()}"): COMPOSED[name].build
       for name in COMPOSED if name != "not_equal"},
}  # fmt: skip
"""What an operation means."""
