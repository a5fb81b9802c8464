"""Where code has a value: nowhere less than what was derived.

A field knows no NaN: ``sqrt(-1 - x*x)*sqrt(-1 - x*x) + 1 + x*x`` is 0 there, and no number at any
real x. So what each operation of the code demands is compared with what the operations demand that
it should be equal to, by the kernel. What the code of a function divides by may be zero where the
matrix of the equations is singular, which its status tells; it must not be so everywhere.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from mechanics.compiled.translation_validation.physics import Physics
from mechanics.kernel import Finding, Range, undecided
from mechanics.kernel.definedness import Gap, Kind, Space, gaps, undefined
from mechanics.program import Node, Obligation
from mechanics.program.operations import INPUT, Sign
from mechanics.program.program import reachable
from mechanics.program.residues import Residues


def where_defined(
    finding: Finding,
    physics: Physics,
    written: Iterable[Obligation],
    truth: Sequence[Obligation],
) -> Finding:
    """The finding of code that is shown, with where it is defined.

    Parameters
    ----------
    finding : Finding
        That it is what it should be, where both have a value.
    physics : Physics
        In whose builder the code was read.
    written : iterable of Obligation
        Of the code.
    truth : sequence of Obligation
        Of what it should be.
    """
    rest = list(unmatched(written, truth))
    if not finding.shown or not rest:
        return finding
    builder = physics.builder
    base = {name: physics.typical(name) for name in builder.inputs}
    positive = frozenset(n for n, known in physics.ranges.items() if known is Range.POSITIVE)
    space = Space(positive, base, (base,), truth=tuple(truth))
    found = gaps(builder, rest, space)
    for test, tell in ((_refutes, _refuted), (_doubtful, _undecided)):
        if worst := [gap for gap in found if test(gap)]:
            return tell(finding, worst[0], physics)
    if found:
        # A set without interior that holds no state at rest.
        names = sorted({gap.obligation.operation for gap in found})
        return replace(finding, domain=f"except where {' or '.join(names)} has no value")
    return finding


def divides_by_zero(physics: Physics, written: Iterable[Obligation]) -> str:
    """Words for a divisor that is zero everywhere; empty where there is none."""
    builder, values = physics.builder, Residues(physics.builder)
    divisors = [Node(builder, o.node) for o in written if o.sign is Sign.NONZERO]
    if any(map(values.is_zero, divisors)):
        return "something is divided by what is zero everywhere"
    return ""


def counterparts(
    physics: Physics, rest: Sequence[Obligation], truth: Sequence[Obligation]
) -> list[tuple[Node, Node]]:
    """Arguments of obligations, and what the same is demanded of in the truth.

    Residues at a point propose which are equal; whether they are is for the kernel to decide. Empty
    unless every obligation has a counterpart.
    """
    builder, values = physics.builder, Residues(physics.builder)
    pairs: list[tuple[Node, Node]] = []
    for one in rest:
        left = Node(builder, one.node)
        theirs = (
            Node(builder, other.node)
            for other in truth
            if other.sign is one.sign and set(other.conditions) <= set(one.conditions)
        )
        right = next((node for node in theirs if values.is_zero(left - node)), None)
        if right is None:
            return []
        pairs.append((left, right))
    return pairs


def unmatched(written: Iterable[Obligation], truth: Sequence[Obligation]) -> Iterable[Obligation]:
    """Obligations that the truth does not have as they stand."""
    known: dict[tuple[Sign, int], list[frozenset[tuple[int, bool]]]] = {}
    for obligation in truth:
        key = obligation.sign, obligation.node
        known.setdefault(key, []).append(frozenset(obligation.conditions))
    for obligation in written:
        conditions = frozenset(obligation.conditions)
        theirs = known.get((obligation.sign, obligation.node), ())
        if not any(other <= conditions for other in theirs):
            yield obligation


def _refutes(gap: Gap) -> bool:
    return gap.kind is Kind.NOWHERE or (gap.kind is Kind.OPEN and gap.at_rest)


def _doubtful(gap: Gap) -> bool:
    return gap.kind in (Kind.UNKNOWN, Kind.OPEN) or gap.at_rest


def _refuted(finding: Finding, gap: Gap, physics: Physics) -> Finding:
    if physics.known.constrained:
        # The states that were tried need not be on the constraints.
        return _undecided(finding, gap, physics)
    where = "at any state" if gap.kind is Kind.NOWHERE else f"at {_state(gap, physics)}"
    words = f"{gap.obligation.operation} has no real value {where}, where the motion has one"
    return undefined(finding.subject, words, gap)


def _undecided(finding: Finding, gap: Gap, physics: Physics) -> Finding:
    where = f", at {_state(gap, physics)}" if gap.state else ", at rest" if gap.at_rest else ""
    words = (
        f"correct where it has a value, but {gap.obligation.operation} may have none{where}: this"
        f" needs an argument that {gap.obligation.sign.value}"
    )
    return undecided(finding.subject, words)


def _state(gap: Gap, physics: Physics) -> str:
    """What the argument depends on, at a state."""
    builder = physics.builder
    nodes = [gap.obligation.node, *(node for node, _ in gap.obligation.conditions)]
    held = {
        builder.inputs[builder.operands[0][n]]
        for n in reachable(builder, nodes)
        if builder.operations[n] == INPUT
    }
    return ", ".join(f"{n} = {v}" for n, v in gap.state if n in held) or "every state"
