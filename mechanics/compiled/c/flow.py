"""Which values of a program use which, which are the same for all states, which must be finite."""

from collections.abc import Sequence

import casadi as ca

from mechanics.compiled.c.status import watched
from mechanics.compiled.programs.program import Program

OUTPUT = -1
"""Stands for the outputs among the users of a node."""


def users(code: Program) -> list[list[int]]:
    """For each node the nodes that use it, once for each use; an output is node -1."""
    users: list[list[int]] = [[] for _ in code.nodes]
    for k, node in enumerate(code.nodes):
        if node.operation in (ca.OP_INPUT, ca.OP_CONST):
            continue
        # The text of these repeats its operand.
        twice = node.operation in (ca.OP_SQ, ca.OP_SIGN)
        for operand in node.operands:
            users[operand] += [k, k] if twice else [k]
    for nodes in code.outputs:
        for node_at in nodes:
            users[node_at].append(OUTPUT)
    return users


def constant(code: Program, shared: Sequence[str]) -> list[bool]:
    """For each node whether it is the same for all states; the last entry is for outputs."""
    found: list[bool] = []
    for node in code.nodes:
        if node.operation == ca.OP_INPUT:
            found.append(code.inputs[node.operands[0]][0] in shared)
        else:
            found.append(all(found[i] for i in node.operands))
    return [*found, False]


def looked_at(code: Program) -> tuple[int, ...]:
    """Nodes that have to be finite: outputs and what is watched, but for numbers."""
    found = watched(code)
    outputs = [node for nodes in code.outputs for node in nodes]
    every = dict.fromkeys((*outputs, *found.divisors, *found.others))
    return tuple(k for k in every if code.nodes[k].constant is None)
