"""Second step of the chain: graph = C text, output by output.

The text is read into a program twice. As it was written, with every rounding that a machine makes,
for the third step; and, here, into the builder that holds the graph, with literals as the constants
that they stand for. Sine and cosine by inline text are sine and cosine here; that text has a check
of its own.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from mechanics.compiled.translation_validation.code import EVERY, entries
from mechanics.compiled.translation_validation.kernel import COUNT, Kernel, parameters
from mechanics.errors import ExpressionError
from mechanics.program import Builder, Node, Program
from mechanics.program.as_written import AsWritten
from mechanics.program.c.condition import Decision, atoms
from mechanics.program.c.function import Function
from mechanics.program.c.nodes import Nodes
from mechanics.program.c.parse import Source
from mechanics.program.c.reader import read_function
from mechanics.program.program import reachable

Groups = Sequence[tuple[str, int]]
"""Names and sizes of arrays."""


@dataclass(frozen=True)
class Signature:
    """What the arguments of a C function are.

    Attributes
    ----------
    groups : tuple of (str, int)
        Inputs in the order of the arguments, with their sizes; the integers left out.
    outputs : tuple of (str, int)
        Outputs likewise.
    """

    kernel: Kernel
    groups: tuple[tuple[str, int], ...]
    outputs: tuple[tuple[str, int], ...]

    @property
    def first(self) -> int:
        """Place of the first array among the arguments."""
        return 2 if self.kernel.lanes else 0

    def entries(self) -> Iterator[tuple[str, tuple[int, int]]]:
        """Name and place of every entry of the outputs."""
        for i, (name, size) in enumerate(self.outputs):
            for entry in range(size):
                yield f"{name}[{entry}]", (self.first + len(self.groups) + i, entry)


@dataclass(frozen=True, eq=False)
class Reading:
    """A C function in a builder.

    Attributes
    ----------
    function : Function
        Its nodes are those of the builder.
    """

    signature: Signature
    builder: Builder
    function: Function

    def written(self) -> Iterator[tuple[str, Node]]:
        """Every value that an entry of an output gets; mostly one."""
        for name, at in self.signature.entries():
            for written in self.function.outputs[at]:
                yield name, Node(self.builder, written.node)

    @property
    def doubt(self) -> str:
        """What the text does besides, where it should not; mostly empty."""
        found, lanes = self.function, self.signature.kernel.lanes
        if lanes and found.lanes != COUNT:
            end = found.lanes or "one state"
            return f"refused: its loop ends at {end}, not at the number of lanes"
        if found.beyond:
            return f"refused: {found.beyond[0]} is read, beyond the end of the array"
        if found.late and not lanes:
            return (
                f"refused: {found.late[0]} is read after an output was written, which may be the"
                " same array"
            )
        return ""


def read_into(
    builder: Builder,
    kernel: Kernel,
    source: Source,
    groups: Groups,
    outputs: Groups,
    given: Mapping[str, Sequence[Node]],
    meaning: Mapping[Fraction, Node] | None = None,
) -> Reading:
    """Read a C function.

    Parameters
    ----------
    source : Source
        Of its file, with those that it calls.
    groups, outputs : sequences of (str, int)
        Names and sizes of the arrays that it takes and gives.
    given : mapping of str to sequence of Node
        Entries of the inputs.
    meaning : mapping of Fraction to Node, optional
        What literals stand for.

    Raises
    ------
    ExpressionError
        If the text holds what is not supported, or an output is not written.
    """
    kept = tuple((name, size) for name, size in groups if size)
    asked = tuple((name, size) for name, size in outputs if size)
    signature = Signature(kernel, kept, asked)
    arguments: list[Sequence[Node]] = [()] * signature.first
    arguments += [given[name] for name, _ in kept]
    target = Nodes(builder, arguments, meaning)
    function = read_function(source, kernel.symbol, parameters(kernel, kept, asked), target)
    for name, at in signature.entries():
        if at not in function.outputs:
            raise ExpressionError(f"{kernel.symbol}: {name} is not written")
        if function.outputs[at][0].condition is not True:
            raise ExpressionError(f"{kernel.symbol}: {name} is written under a condition only")
    return Reading(signature, builder, function)


VALUES, ASKED = "values", "asked"


@dataclass(frozen=True, eq=False)
class Text:
    """A C function as it was written, as a program.

    Attributes
    ----------
    reading : Reading
        Its nodes are rounded operations.
    program : Program
        Inputs ``"q[0]"``; outputs ``"values"``: every value that an entry gets, in order;
        ``"asked"``: operands of the conditions of the status; ``"every"``: all that the values are
        computed from.
    counts : tuple of int
        How many values each entry gets.
    status : Decision or None
        Operands of its conditions are nodes of the builder, see `places`.
    places : mapping of int to int
        Where the operands of its conditions stand among those that are asked.
    """

    reading: Reading
    program: Program
    counts: tuple[int, ...]
    status: Decision | None
    places: Mapping[int, int]

    @property
    def signature(self) -> Signature:
        """What its arguments are."""
        return self.reading.signature

    @property
    def kernel(self) -> Kernel:
        """Which function it is."""
        return self.signature.kernel

    @property
    def groups(self) -> tuple[tuple[str, int], ...]:
        """Its inputs."""
        return self.signature.groups

    @property
    def outputs(self) -> tuple[tuple[str, int], ...]:
        """Its outputs."""
        return self.signature.outputs


def read_text(kernel: Kernel, source: Source, groups: Groups, outputs: Groups) -> Text:
    """Read a C function as it was written; arguments as for `read_into`."""
    builder = AsWritten()
    given = {name: entries(builder, name, size) for name, size in groups}
    reading = read_into(builder, kernel, source, groups, outputs, given)
    status = reading.function.status
    found = [] if status is None else atoms(status)
    asked = list(dict.fromkeys(operand for atom in found for operand in atom.operands))
    values = [node for _, node in reading.written()]
    every = reachable(builder, [node.number for node in values])
    program = builder.program({
        VALUES: values,
        ASKED: [Node(builder, number) for number in asked],
        EVERY: [Node(builder, number) for number in every],
    })  # fmt: skip
    counts = [len(reading.function.outputs[at]) for _, at in reading.signature.entries()]
    places = {number: place for place, number in enumerate(asked)}
    return Text(reading, program, tuple(counts), status, places)


def reads_alike(one: Text, two: Text) -> bool:
    """Whether two texts are the same operations on the same values, in the same order."""
    return (
        one.signature == two.signature
        and one.reading.function == two.reading.function
        and _tables(one.reading.builder) == _tables(two.reading.builder)
    )


def _tables(builder: Builder) -> tuple[object, ...]:
    rows = builder.operations, builder.operands, builder.constants, builder.inputs
    return (*rows, builder.systems, list(builder.obligations))
