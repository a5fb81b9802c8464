"""One step of the classical Runge-Kutta method, written down once more from its formula.

    k1 = f(y), k2 = f(y + h/2 k1), k3 = f(y + h/2 k2), k4 = f(y + h k3)
    y(t + h) = y + h/6 (k1 + 2 k2 + 2 k3 + k4)

f is the graph of the rates (q', u'), whose nodes are repeated at each stage. Inputs are held, but
for the time, which goes on.
"""

from __future__ import annotations

from fractions import Fraction

import casadi as ca

from mechanics.compiled.custody.code import CONSTANTS, Code
from mechanics.program.casadi_reader import Instruction as Node

STAGES = ((Fraction(1, 2), Fraction(2)), (Fraction(1, 2), Fraction(2)), (Fraction(1), Fraction(1)))
"""For k2, k3, k4: the share of the step, and the weight in the sum; k1 has weight 1."""


class _Composer:
    """Nodes as they are added."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []

    def add(self, op: int, *operands: int) -> int:
        """Append an operation."""
        self.nodes.append(Node(op, operands, None))
        return len(self.nodes) - 1

    def number(self, value: Fraction) -> int:
        """Append a constant."""
        self.nodes.append(Node(ca.OP_CONST, (), value))
        return len(self.nodes) - 1

    def moved(self, at: int, scale: Fraction, h: int, slope: int) -> int:
        """at + scale h slope."""
        change = self.add(ca.OP_MUL, self.number(scale), self.add(ca.OP_MUL, h, slope))
        return self.add(ca.OP_ADD, at, change)

    def call(self, code: Code, given: dict[str, list[int]]) -> dict[str, list[int]]:
        """Repeat the nodes of a function at other arguments."""
        places: list[int] = []
        for node in code.nodes:
            if node.op == ca.OP_INPUT:
                group, entry = node.operands
                name = code.inputs[group][0] if group < len(code.inputs) else CONSTANTS
                places.append(given[name][entry])
                continue
            operands = tuple(places[i] for i in node.operands)
            self.nodes.append(Node(node.op, operands, node.constant))
            places.append(len(self.nodes) - 1)
        return {
            name: [places[i] for i in nodes]
            for (name, _), nodes in zip(code.shapes, code.outputs, strict=True)
        }


def composed(rates: Code, time: int | None) -> Code:
    """The step of the rates.

    Parameters
    ----------
    rates : Code
        From q, u, inputs, p (and constants) to qd and ud.
    time : int or None
        Entry of the inputs that is the time.
    """
    build = _Composer()
    groups = (*rates.inputs, ("h", 1))
    given = {
        group: [build.add(ca.OP_INPUT, place, entry) for entry in range(size)]
        for place, (group, size) in enumerate((*groups, (CONSTANTS, len(rates.constants))))
    }
    (h,) = given["h"]
    start = given["q"] + given["u"]
    slopes = _slopes(build, rates, given)
    total = slopes
    for share, weight in STAGES:
        y = [build.moved(at, share, h, slope) for at, slope in zip(start, slopes, strict=True)]
        n = len(given["q"])
        stage = {**given, "q": y[:n], "u": y[n:]}
        if time is not None:
            inputs = list(given["inputs"])
            elapsed = build.add(ca.OP_MUL, build.number(share), h)
            inputs[time] = build.add(ca.OP_ADD, inputs[time], elapsed)
            stage["inputs"] = inputs
        slopes = _slopes(build, rates, stage)
        weighted = [build.add(ca.OP_MUL, build.number(weight), slope) for slope in slopes]
        total = [build.add(ca.OP_ADD, x, y) for x, y in zip(total, weighted, strict=True)]
    end = [build.moved(at, Fraction(1, 6), h, s) for at, s in zip(start, total, strict=True)]
    n = len(given["q"])
    shapes = (("q_next", (n, 1)), ("u_next", (len(end) - n, 1)))
    outputs = (tuple(end[:n]), tuple(end[n:]))
    return Code("step", tuple(build.nodes), outputs, groups, shapes, rates.constants)


def _slopes(build: _Composer, rates: Code, given: dict[str, list[int]]) -> list[int]:
    found = build.call(rates, given)
    return [*found["qd"], *found["ud"]]
