"""Which values of a program use which, which are the same for all states, which must be finite."""

from collections.abc import Sequence

from mechanics.compiled.c.status import watched
from mechanics.program.operations import INPUT, SIGN
from mechanics.program.routine import Routine

OUTPUT = -1
"""Stands for the outputs among the users of a node."""


def users(code: Routine) -> list[list[int]]:
    """For each node the nodes that use it, once for each use; an output is node -1."""
    users: list[list[int]] = [[] for _ in code.nodes]
    for k, node in enumerate(code.nodes):
        for operand in code.operands(k):
            # The text of a sign repeats its operand.
            users[operand] += [k, k] if node.operation == SIGN else [k]
    for nodes in code.outputs:
        for node_at in nodes:
            users[node_at].append(OUTPUT)
    return users


def constant(code: Routine, shared: Sequence[str]) -> list[bool]:
    """For each node whether it is the same for all states; the last entry is for outputs."""
    found: list[bool] = []
    for node in code.nodes:
        if node.operation == INPUT:
            found.append(code.inputs[node.operands[0]][0] in shared)
        else:
            found.append(all(found[i] for i in node.operands))
    return [*found, False]


def looked_at(code: Routine) -> tuple[int, ...]:
    """Nodes that have to be finite: outputs and what is watched, but for numbers."""
    found = watched(code)
    outputs = [node for nodes in code.outputs for node in nodes]
    every = dict.fromkeys((*outputs, *found.divisors, *found.others))
    return tuple(k for k in every if code.nodes[k].constant is None)
