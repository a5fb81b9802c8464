"""How much a reduced output deviates at states that are searched for: what no bound is below."""

from fractions import Fraction

from mechanics.program import Builder, Program
from mechanics.program.interpret import include
from mechanics.reduce.reduce import Reduction
from mechanics.reduce.scale import scales


def difference(reduction: Reduction) -> Program:
    """Reduced less whole, the outputs in their order."""
    builder = Builder()
    sides = [
        [node for nodes in include(builder, program).values() for node in nodes]
        for program in (reduction.program, reduction.start.reduced({}))
    ]
    return builder.program({"difference": [x - y for x, y in zip(*sides, strict=True)]})


def largest_deviations(reduction: Reduction) -> tuple[Fraction, ...]:
    """The largest deviation of each output that a search finds, enclosed from below."""
    program = difference(reduction)
    return scales(program, {name: reduction.start.box[name] for name in program.inputs})
