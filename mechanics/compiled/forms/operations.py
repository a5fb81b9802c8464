"""What a graph costs: operations, equal ones shared, a division counted twice."""

import casadi as ca

FREE = frozenset({ca.OP_INPUT, ca.OP_CONST, ca.OP_OUTPUT})
DIVISIONS = frozenset({ca.OP_DIV, ca.OP_INV})


def operations(graph: ca.SX) -> int:
    """Operations of a graph, as CasADi lists them: many are weighed, few are read."""
    function = ca.Function("graph", ca.symvar(graph), [ca.cse(ca.densify(graph))])
    every = [function.instruction_id(k) for k in range(function.n_instructions())]
    return sum(2 if code in DIVISIONS else 1 for code in every if code not in FREE)
