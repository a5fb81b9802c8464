"""Decide a statement: PROVED, CERTIFIED, REFUTED or UNDECIDED, never a tolerance.

The field speaks first because it is quick and its answer tells where to look: if it says zero, the
normal form tries to turn the certificate into a proof; if it says not zero, balls look for a
witness. What neither settles is UNDECIDED. Only this package makes findings.
"""

from dataclasses import replace
from functools import cache
from math import ceil, inf

from mechanics.kernel.canaries import canaries
from mechanics.kernel.constraints import on_constraints
from mechanics.kernel.finding import COMPONENT, Finding, Verdict, undecided
from mechanics.kernel.normal import proves
from mechanics.kernel.statement import LEFT, RATES, RIGHT, ZERO, Statement
from mechanics.kernel.trial import Answer, Trial, trial
from mechanics.kernel.witness import boundaries, find_witness, first_witness

PROOF = "both sides have the same normal form"
SAME = "both sides are the same expression"


def decide(statement: Statement, *, try_normal: bool = True) -> Finding:
    """Decide whether both sides of a statement are equal wherever both have a value.

    Parameters
    ----------
    statement : Statement
    try_normal : bool
        False to be content with a certificate where a proof would cost time.

    Returns
    -------
    Finding

    Raises
    ------
    ExpressionError
        If an expression holds an operation without an exact meaning.
    AssertionError
        If the kernel decides a statement wrongly that is known to be true or false.
    """
    check_canaries()
    return _decided(statement, try_normal)


@cache
def check_canaries() -> None:
    """Decide what is known, once in a process, before anything else.

    Raises
    ------
    AssertionError
        If a verdict is not the known one: nothing that this kernel says can be trusted.
    """
    for statement, shown in canaries():
        finding = _decided(statement, try_normal=True)
        right = finding.shown if shown else finding.verdict is Verdict.REFUTED
        if not right:
            raise AssertionError(
                f"{statement.subject} is known and was found {finding.verdict.name}:"
                " the kernel is broken, trust none of its verdicts"
            )


def _decided(statement: Statement, try_normal: bool) -> Finding:
    subject, outputs = statement.subject, statement.program.outputs
    if outputs[LEFT] == outputs[RIGHT]:
        return Finding(subject, Verdict.PROVED, SAME)
    # First at unconstrained points, on every component at once.
    constrained = outputs.get(ZERO) or outputs.get(RATES)
    where = ", also where the constraints do not hold" if constrained else ""
    is_proved = cache(lambda: try_normal and proves(statement))
    outcome = trial(statement, is_proved)
    if outcome.answer is Answer.PROVED:
        return Finding(subject, Verdict.PROVED, PROOF + where)
    if outcome.answer is Answer.ZERO and not outcome.off_boundaries:
        return _certified(subject, outcome, where)
    if constrained:
        return _decided_on_constraints(statement, try_normal)
    # Where cases meet, sides may differ that are equal everywhere else.
    if outcome.answer is Answer.ZERO:
        witness = first_witness(statement, boundaries(statement))
    else:
        witness = find_witness(statement)
    if witness is not None:
        words = "the enclosures at a real state are disjoint"
        return Finding(subject, Verdict.REFUTED, words, witness=witness)
    if outcome.answer is Answer.ZERO:
        return _certified(subject, outcome)
    # Only here can the normal form know more than the field: |x|, signs of roots.
    if is_proved():
        return Finding(subject, Verdict.PROVED, PROOF)
    return undecided(subject, _doubt(outcome))


def _decided_on_constraints(statement: Statement, try_normal: bool) -> Finding:
    """On the component of the start."""
    constrained = on_constraints(statement)
    if constrained is None:
        words = "not equal off the constraints, and no exact point on them is known"
        return undecided(statement.subject, words)
    finding = _decided(constrained, try_normal)
    solved = [name for name in statement.program.inputs if name in constrained.program.outputs]
    if not finding.shown or not solved:
        return finding
    # x y = 0 holds where x = 0 and where y = 0: a point knows its own component only.
    start = statement.typical
    here = ", ".join(f"{name} = {float(start[name]):.3g}" for name in solved if name in start)
    words = f"{finding.evidence}{COMPONENT}{', '.join(solved)}"
    return replace(finding, evidence=f"{words} (at the start {here})" if here else words)


def _certified(subject: str, outcome: Trial, where: str = "") -> Finding:
    exponent = min(outcome.log2_bound, 0.0)
    words = f"{outcome.words}{where}; chance of error below 2^{ceil(exponent)}"
    return Finding(subject, Verdict.CERTIFIED, words, error_bound=2.0 ** max(exponent, -1000.0))


def _doubt(outcome: Trial) -> str:
    if outcome.log2_bound == inf:
        return outcome.words
    known = ", ".join(outcome.unknown)
    why = f"known by congruence only: {known}" if known else "no operation is known to be the cause"
    return f"{outcome.words}, but none of the real states tried tells the sides apart ({why})"
