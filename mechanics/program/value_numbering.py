"""One node for all nodes of one value: global value numbering.

    s (c x) - c (s x) = 0,    s s + c c = 1,    (a - b/2) + b/2 = a

Values are compared at a point of a finite field, up to the sign, so that what is equal by algebra
is found, too. What is computed first stays. It proposes only: two nodes that are equal on one
branch of a root alone may be one for it, so that the outputs are compared in numbers, too, and who
takes the program has it proved.

Source: Alpern, Wegman and Zadeck, Detecting equality of variables in programs, POPL 1988; the
comparison is Schwartz and Zippel's.
"""

import numpy as np

from mechanics.program.builder import Builder, Node
from mechanics.program.interpret import Nodes, include, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import ARITY, OPERATIONS
from mechanics.program.program import Program, reachable
from mechanics.program.residues import Residues

STATES = 32
SEED = 1
CLOSE = 2.0**-26
"""Half of the digits of a double."""


def with_one_value(program: Program) -> Program:
    """The same program, each value computed once; it holds no linear systems."""
    old, new = Builder(), Builder()
    outputs = include(old, program)
    numbers = reachable(old, [node.number for nodes in outputs.values() for node in nodes])
    filter_ = Residues(old)
    values = filter_.values([Node(old, number) for number in numbers])
    operations = Nodes(new).operations
    first: dict[int, Node] = {0: new.zero}
    found: dict[int, Node] = {}
    for number, value in zip(numbers, values, strict=True):
        code = old.operations[number]
        if not ARITY[code]:
            ((found[number],),) = include(new, old.program({"x": [Node(old, number)]})).values()
        elif value in first:
            found[number] = first[value]
            continue
        else:
            operands = (found[old.operands[k][number]] for k in range(ARITY[code]))
            found[number] = operations[OPERATIONS[code].name](*operands)
        first.setdefault(value, found[number])
        first.setdefault(-value % filter_.prime, -found[number])
    named = {name: [found[node.number] for node in nodes] for name, nodes in outputs.items()}
    other = new.program(named, program.inputs)
    return other if other.count < program.count and _same(program, other) else program


def _same(one: Program, two: Program) -> bool:
    """Whether the outputs are equal at ordinary states, wherever the first has numbers."""
    generator = np.random.default_rng(SEED)
    inputs = {name: generator.uniform(-2, 2, STATES) for name in one.inputs}
    with np.errstate(all="ignore"):
        pairs = [interpret(program, Arrays(), inputs) for program in (one, two)]
        for name, nodes in pairs[0].items():
            for left, right in zip(nodes, pairs[1][name], strict=True):
                left, right = (np.broadcast_to(side, STATES) for side in (left, right))
                near = np.abs(left - right) <= CLOSE * (1 + np.abs(left))
                if not np.all(near | ~np.isfinite(left)):
                    return False
    return True
