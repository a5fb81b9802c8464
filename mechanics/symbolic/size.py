"""How long an expression is where it is written out: the operations of its tree.

SymPy's `count_ops` walks through each part as often as it is written. Here each part is counted
once and added as often as it is written: expressions share most of their parts.
"""

import sympy

from mechanics.program.postorder import postorder


def operations(expr: sympy.Basic) -> int:
    """Operations of an expression that is written out, numbers and symbols being free.

    A sum or product of n parts has n - 1; a power, a function or a derivative has one, at least.

    Examples
    --------
    >>> from sympy.abc import x, y
    >>> operations(x + y), operations(2 * sympy.sin(x) ** 2), operations(x)
    (1, 3, 0)
    """
    counts: dict[sympy.Basic, int] = {}
    for node in postorder(expr, lambda part: part.args, counts):
        own = max(len(node.args) - 1, 1) if node.args else 0
        counts[node] = own + sum(counts[part] for part in node.args)
    return counts[expr]
