"""What a C function returns: the same decision as specified, about the same values.

    scalar    0 if every value is finite, else 3 if an input is not, else 1 if a divisor is zero,
              else 2
    batch     1 if an angle of some lane is too far, plus 2 if the sum of the values is not finite

Conditions of the text are about values; two values are the same if they are equal at a random point
of a finite field, up to their sign. The decisions are then compared as they stand.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import log2
from typing import Any

import casadi as ca
import numpy as np

from mechanics.compiled.c.flow import looked_at
from mechanics.compiled.c.lanes import FAR, WILD
from mechanics.compiled.c.status import watched
from mechanics.compiled.custody.code import exact
from mechanics.compiled.custody.derived import Derived
from mechanics.compiled.custody.prove import Graph, program_numbers
from mechanics.compiled.custody.text import Text
from mechanics.errors import SingularError
from mechanics.exact import Finding, Inadmissible
from mechanics.exact.c.condition import (
    Atom,
    Choice,
    Condition,
    Decision,
    atoms,
    choice,
    joined,
    renamed,
)  # fmt: skip
from mechanics.exact.field import FieldArithmetic
from mechanics.exact.field_size import Memory
from mechanics.exact.primes import pooled_prime
from mechanics.exact.signals import Restart
from mechanics.kernel import same, undecided

OK, SINGULAR, OVERFLOW, BAD_INPUT = range(4)
BITS = 255
DRAWS = 64
POOL = 16

LARGEST = {
    "double": Fraction(float(np.finfo(np.float64).max)),
    "float": Fraction(float(np.finfo(np.float32).max)),
}

Key = tuple[str, int]


def prove_status(text: Text, graph: Graph, known: Derived) -> Finding:
    """Decide whether the status of a C function is the one that is specified.

    Parameters
    ----------
    text : Text
        Whose outputs are the graph's.
    graph : Graph
    known : Derived
        For the signs of the inputs.
    """
    subject = f"{text.kernel.file}: status of {text.kernel.symbol}"
    point = _Point(text, graph, known)
    found = point.found()
    wanted = point.lanes() if text.kernel.lanes else point.scalar()
    if found == wanted and text.kernel.lanes and (missed := point.not_far()):
        return undecided(subject, missed)
    if found == wanted:
        words = (
            f"the same decision about the same values; chance of error below 2^{point.log2_bound}"
        )
        return same(subject, found, wanted, words, point.log2_bound)
    return undecided(subject, difference(found, wanted))


class _Point:
    """Values of text and program at one random point, as keys."""

    def __init__(self, text: Text, graph: Graph, known: Derived) -> None:
        self.text, self.graph = text, graph
        source = random.Random(f"status of {text.kernel.symbol}")
        memory = Memory()
        for index in range(DRAWS):
            a = FieldArithmetic(pooled_prime(BITS, index % POOL), source, memory)
            try:
                self._evaluate(a, known)
            except (Inadmissible, Restart):
                continue
            return
        raise SingularError(f"{text.kernel.symbol}: it is defined at no random point")

    def _evaluate(self, a: FieldArithmetic, known: Derived) -> None:
        for symbol, value in known.fixed.items():
            a.assign(symbol, a.value(value))
        given = {group: [a.value(s) for s in symbols] for group, symbols in known.symbols.items()}
        for group, size in self.graph.written.inputs:
            # Prepared parameters are free here.
            given.setdefault(group, [a.draw(False) for _ in range(size)])
        text = self.text.numbers(a, given)
        self._text = [text[i] for i in self.text.of]
        self._program = program_numbers(a, self.graph, self.text.kernel.kind, given)
        self._prime = a.prime
        every = [*self._text, *self._program]
        degree = max(max(n.numerator, n.denominator, 1.0) for n in every)
        self.log2_bound = round(2 * log2(len(every)) + log2(2 * degree) + 1 - (BITS - 2)) + 1

    def key(self, number: Any) -> int:
        """A number up to its sign."""
        return min(int(number.residue), self._prime - int(number.residue))

    def found(self) -> Decision | None:
        """What the text decides, about keys."""
        status = self.text.program.status
        return None if status is None else renamed(status, self._named)

    def _named(self, atom: Atom) -> Condition:
        keys = [self.key(self._text[i]) for i in atom.operands]
        if atom.relation == "==" and keys[1] == 0:
            return Atom("zero", (keys[0],))
        if atom.relation == "<=" and self.text.kernel.lanes:
            return self._wild(*atom.operands) or Atom(atom.relation, tuple(keys))
        return Atom(atom.relation, tuple(keys))

    def _wild(self, size: int, limit: int) -> Condition | None:
        """``fabs(a + b + ...) <= largest`` as: a, b, ... are finite."""
        nodes = self.text.program.nodes
        if nodes[size].op != ca.OP_FABS or nodes[limit].constant != LARGEST[self.text.kernel.kind]:
            return None
        wanted = {self.key(self._program[k]): k for k in looked_at(self.graph.written)}
        found: set[int] = set()
        # A sum is finite only where its terms and the sums of some of them are.
        stack = [(i, False) for i in nodes[size].operands]
        while stack:
            at, inside = stack.pop()
            key = self.key(self._text[at])
            found.add(key)
            if nodes[at].op == ca.OP_ADD:
                stack += [(i, inside or key in wanted) for i in nodes[at].operands]
            elif not inside and key not in wanted and nodes[at].constant is None:
                return None
        if not found.issuperset(wanted):
            return None
        return self._finite(self._program[k] for k in wanted.values())

    def _finite(self, numbers: Iterable[Any]) -> Condition:
        result: Condition = True
        for number in numbers:
            result = joined(True, result, Atom("finite", (self.key(number),)))
        return result

    def scalar(self) -> Decision:
        """What is specified for a function of one state."""
        code, at = self.graph.written, self._program
        values = looked_at(code)
        used = {i for node in exact(code).nodes if node.op != ca.OP_INPUT for i in node.operands}
        used |= {i for nodes in code.outputs for i in nodes}
        inputs = [k for k in sorted(used) if code.nodes[k].operation == ca.OP_INPUT]
        zero: Condition = False
        for k in watched(code).divisors:
            zero = joined(False, zero, Atom("zero", (self.key(at[k]),)))
        why = choice(zero, SINGULAR, OVERFLOW)
        bad = choice(self._finite(at[k] for k in inputs), why, BAD_INPUT)
        return choice(self._finite(at[k] for k in values), OK, bad)

    def far(self) -> Condition:
        """Whether an angle of the lane is too far for the inline sine."""
        far: Condition = False
        for angle in self._turned():
            far = joined(False, far, Atom("far", (angle,)))
        return far

    def not_far(self) -> str:
        """Which output is not written once more where an angle is too far, if there is one."""
        far = self.far()
        for name, at in self.text.entries():
            last = renamed(choice(self.text.program.outputs[at][-1].condition, 1, 0), self._named)
            if far is not False and last != choice(far, 1, 0):
                return f"{name} is not written by the library's sine exactly where one is too far"
        return ""

    def lanes(self) -> Decision:
        """What is specified for a function of many states."""
        code, at, far = self.graph.written, self._program, self.far()
        finite = self._finite(at[k] for k in looked_at(code))
        calm, turned = choice(finite, 0, WILD), choice(finite, FAR, FAR + WILD)
        return choice(far, turned, calm)

    def _turned(self) -> list[int]:
        """Angles of sines and cosines that differ from lane to lane."""
        place = {i for i, (group, _) in enumerate(self.graph.written.inputs)
                 if group not in (self.text.kernel.shared or ())}  # fmt: skip
        moving: set[int] = set()
        found: dict[int, None] = {}
        for k, node in enumerate(self.graph.written.nodes):
            if node.constant is not None:
                continue
            if node.operation == ca.OP_INPUT:
                moving |= {k} if node.operands[0] in place else set()
            elif moving.intersection(node.operands):
                moving.add(k)
                if node.operation in (ca.OP_SIN, ca.OP_COS):
                    found[self.key(self._program[node.operands[0]])] = None
        return list(found)


def difference(found: Decision | None, wanted: Decision) -> str:
    """Words for two decisions that are not the same."""
    if found is None:
        return "refused: it returns nothing, a status is specified"
    known = sorted({*atoms(found), *atoms(wanted)}, key=str)
    source = random.Random(1)
    for _ in range(400):
        share = source.random()
        truth = {atom: source.random() < share for atom in known}
        left, right = _value(found, truth), _value(wanted, truth)
        if left != right:
            return (
                f"with some {sum(truth.values())} of {len(known)} conditions true, {left} is"
                f" returned where {right} is specified"
            )
    return "the status is decided in another way than specified"


def _value(decision: Decision, truth: Mapping[Atom, bool]) -> int:
    while isinstance(decision, Choice):
        decision = decision.yes if _holds(decision.condition, truth) else decision.no
    return decision


def _holds(condition: Condition, truth: Mapping[Atom, bool]) -> bool:
    if isinstance(condition, bool):
        return condition
    if isinstance(condition, Atom):
        return truth[Atom(condition.relation, condition.operands)] is condition.holds
    joined_parts: Sequence[bool] = [_holds(part, truth) for part in condition.parts]
    return all(joined_parts) if condition.both else any(joined_parts)
