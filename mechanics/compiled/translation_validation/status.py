"""What a C function returns: the same decision as specified, about the same values.

    scalar    0 if every value is finite, else 3 if an input is not, else 1 if a divisor is zero,
              else 2
    batch     1 if an angle of some lane is too far, plus 2 if a value is not finite

Conditions of the text are about values. Which of them are the same, up to their sign, is proposed
by residues at a point; the decisions are compared for every truth of their conditions, and the
kernel decides whether these values are the same.
"""

import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from mechanics.compiled.c.flow import looked_at
from mechanics.compiled.c.lanes import FAR, WILD
from mechanics.compiled.c.status import watched
from mechanics.compiled.translation_validation.code import entries
from mechanics.compiled.translation_validation.derived import Derived
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.compiled.translation_validation.physics import Entry, Physics
from mechanics.compiled.translation_validation.prove import Graph, read_beside, written_nodes
from mechanics.errors import ExpressionError
from mechanics.kernel import Finding, undecided
from mechanics.program import Node
from mechanics.program.c.condition import (
    Atom,
    Choice,
    Condition,
    Decision,
    atoms,
    choice,
    equivalent,
    joined,
    renamed,
)  # fmt: skip
from mechanics.program.c.parse import Source
from mechanics.program.operations import ABS, ADD, COS, INPUT, NEGATE, SIN, SUBTRACT
from mechanics.program.residues import Residues

IDEAL = (
    "; the inline sine is read as a sine for every angle: what a lane holds whose angle is too far,"
    " before the C library's sine mends it, is compared by runs of binaries only"
)
"""Said of functions of many states: their text alone does not decide it."""

OK, SINGULAR, OVERFLOW, BAD_INPUT = range(4)

LARGEST = {
    "double": Fraction(float(np.finfo(np.float64).max)),
    "float": Fraction(float(np.finfo(np.float32).max)),
}


def prove_status(kernel: Kernel, source: Source, graph: Graph, known: Derived) -> Finding:
    """Decide whether the status of a C function is the one that is specified.

    Parameters
    ----------
    kernel : Kernel
        Whose outputs are the graph's.
    source : Source
        Of its file.
    known : Derived
        For the signs of the inputs.
    """
    subject = f"{kernel.file}: status of {kernel.symbol}"
    try:
        values = _Values(kernel, source, graph, known)
    except ExpressionError as error:
        return undecided(subject, f"refused: {error}")
    found = values.found()
    wanted = values.lanes() if kernel.lanes else values.scalar()
    if not equivalent(found, wanted):
        return undecided(subject, difference(found, wanted))
    if kernel.lanes and (missed := values.not_far()):
        return undecided(subject, missed)
    return values.same(subject)


class _Values:
    """Values of text and program, as keys: the same for values that are equal up to their sign.

    Which are is proposed by residues at a point, and decided by the kernel at the end.
    """

    def __init__(self, kernel: Kernel, source: Source, graph: Graph, known: Derived) -> None:
        self.kernel, self.graph = kernel, graph
        self.physics = Physics(known)
        builder, given = self.physics.builder, dict(self.physics.inputs)
        for group, size in graph.written.inputs:
            # Prepared parameters are free here.
            given.setdefault(group, entries(builder, group, size))
        self.text = read_beside(self.physics, kernel, source, graph, given)
        every = range(len(graph.written.nodes))
        self._program = written_nodes(self.physics, kernel, graph, given, every)
        self._residues = Residues(builder)
        self._members: dict[int, dict[int, int]] = {}

    def key(self, node: Node) -> int:
        """A value up to its sign."""
        (residue,) = self._residues.values([node])
        key = min(residue, self._residues.prime - residue)
        self._members.setdefault(key, {})[node.number] = 1 if residue == key else -1
        return key

    def same(self, subject: str) -> Finding:
        """Whether values of one key are equal up to their signs."""
        builder = self.physics.builder
        # Constants have no conditions, and no values that these are about.
        pairs: list[Entry] = [("none", builder.one, builder.one)] if not self._members else []
        # Conditions are sets: the order in which their values were met is that of their hashes.
        for key, members in sorted(self._members.items(), key=lambda item: min(item[1])):
            first, *others = sorted(members)
            for other in others or [first]:
                sign = 0 if key == 0 else members[first] * members[other]
                left = Node(builder, first)
                pairs.append(("value", left, Node(builder, other) * sign if sign else builder.zero))
        found = self.physics.decide_entries(subject, pairs, try_normal=False)
        if not found.shown:
            return undecided(subject, f"the conditions are about other values: {found.evidence}")
        words = f"the same decision about the same values: {found.evidence}"
        return replace(found, evidence=words + IDEAL if self.kernel.lanes else words)

    def found(self) -> Decision | None:
        """What the text decides, about keys."""
        status = self.text.function.status
        return None if status is None else renamed(status, self._named)

    def _named(self, atom: Atom) -> Condition:
        nodes = [Node(self.physics.builder, operand) for operand in atom.operands]
        keys = [self.key(node) for node in nodes]
        if atom.relation == "==" and keys[1] == 0:
            return Atom("zero", (keys[0],))
        if atom.relation == "<=" and self.kernel.lanes:
            return self._wild(*nodes) or Atom(atom.relation, tuple(keys))
        return Atom(atom.relation, tuple(keys))

    def _wild(self, size: Node, limit: Node) -> Condition | None:
        """``fabs(a + b + ...) <= largest`` as: a, b, ... are finite."""
        builder = self.physics.builder
        operations, (first, second, _) = builder.operations, builder.operands
        if operations[size.number] != ABS or limit.constant != LARGEST[self.kernel.kind]:
            return None
        wanted = {self.key(self._program[k]): k for k in looked_at(self.graph.written)}
        found: set[int] = set()
        # A sum is finite only where its terms and the sums of some of them are.
        stack = [(first[size.number], False)]
        while stack:
            at, inside = stack.pop()
            key = self.key(Node(builder, at))
            found.add(key)
            inner = inside or key in wanted
            if operations[at] in (ADD, SUBTRACT):
                stack += [(first[at], inner), (second[at], inner)]
            elif operations[at] == NEGATE:
                stack.append((first[at], inside))
            elif not inside and key not in wanted and builder.constant_at(at) is None:
                return None
        if not found.issuperset(wanted):
            return None
        return self._finite(self._program[k] for k in wanted.values())

    def _finite(self, nodes: Iterable[Node]) -> Condition:
        result: Condition = True
        for node in nodes:
            result = joined(True, result, Atom("finite", (self.key(node),)))
        return result

    def scalar(self) -> Decision:
        """What is specified for a function of one state."""
        code, at = self.graph.written, self._program
        values = looked_at(code)
        used = {i for k in range(len(code.nodes)) for i in code.operands(k)}
        used |= {i for nodes in code.outputs for i in nodes}
        inputs = [k for k in sorted(used) if code.nodes[k].operation == INPUT]
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
        for name, at in self.text.signature.entries():
            last = renamed(choice(self.text.function.outputs[at][-1].condition, 1, 0), self._named)
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
                 if group not in (self.kernel.shared or ())}  # fmt: skip
        moving: set[int] = set()
        found: dict[int, None] = {}
        for k, node in enumerate(self.graph.written.nodes):
            if node.constant is not None:
                continue
            if node.operation == INPUT:
                moving |= {k} if node.operands[0] in place else set()
            elif moving.intersection(node.operands):
                moving.add(k)
                if node.operation in (SIN, COS):
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
