"""Decide a statement: PROVED, CERTIFIED, REFUTED or UNDECIDED, never a tolerance.

The field speaks first because it is quick and its answer tells where to look: if it says zero, the
normal form tries to turn the certificate into a proof; if it says not zero, balls look for a
witness. What neither settles is UNDECIDED.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import inf, log2
from typing import Any

import sympy

from mechanics.exact.arithmetic import Arithmetic
from mechanics.exact.field_trial import Answer, Experiment, Trial, trial
from mechanics.exact.finding import Finding, Verdict
from mechanics.exact.normal import proves
from mechanics.exact.witness import find_witness

PROOF = "both sides have the same normal form"


def decide(
    subject: str,
    experiment: Experiment,
    *,
    target: float = 2.0**-80,
    seed: int | None = None,
    try_normal: bool = True,
) -> Finding:
    """Decide whether all pairs of an experiment are equal.

    Parameters
    ----------
    subject : str
        What is checked, in words.
    experiment : callable
        Takes an `Arithmetic`, returns pairs (left, right) of its numbers; runs several times.
    target : float
        Largest chance of error that a CERTIFIED finding may have.
    seed : int, optional
        Makes the finding reproducible; by default points and primes are the system's randomness.
    try_normal : bool
        False to be content with a certificate where a proof would cost time.

    Returns
    -------
    Finding

    Raises
    ------
    ValueError
        If the experiment compares nothing, or the target is no probability.
    ExpressionError
        If an expression or graph holds an operation without an exact meaning.
    """
    if not 0 < target < 1:
        raise ValueError(f"target {target} is no probability between 0 and 1")
    outcome = trial(experiment, log2(target), seed)
    if outcome.answer is Answer.ZERO:
        if try_normal and proves(experiment):
            return Finding(subject, Verdict.PROVED, PROOF)
        return _certified(subject, outcome)
    if outcome.answer is Answer.NONZERO:
        witness = find_witness(experiment, seed)
        if witness is not None:
            return Finding(
                subject, Verdict.REFUTED, "the enclosures at a real state are disjoint",
                witness=witness,
            )  # fmt: skip
        # Only here can the normal form know more: |x|, signs of roots.
        if try_normal and proves(experiment):
            return Finding(subject, Verdict.PROVED, PROOF)
    return Finding(subject, Verdict.UNDECIDED, _doubt(outcome))


def _certified(subject: str, outcome: Trial) -> Finding:
    exponent = min(outcome.log2_bound, 0.0)
    words = f"{outcome.words}; chance of error below 2^{exponent:.0f}"
    return Finding(subject, Verdict.CERTIFIED, words, error_bound=2.0 ** max(exponent, -1000.0))


def _doubt(outcome: Trial) -> str:
    if outcome.log2_bound == inf:
        return outcome.words
    known = ", ".join(outcome.opaque)
    why = f"known by congruence only: {known}" if known else "no operation is known to be the cause"
    return f"{outcome.words}, but none of the real states tried tells the sides apart ({why})"


def prove_equal(
    subject: str,
    left: sympy.Expr | Sequence[sympy.Expr],
    right: sympy.Expr | Sequence[sympy.Expr],
    **options: Any,
) -> Finding:
    """Decide whether expressions are equal, entry by entry.

    Parameters
    ----------
    left, right : sympy.Expr, or sequences (matrices) of equally many
    **options
        As for `decide`.

    Raises
    ------
    ValueError
        If the numbers of entries differ or are zero.
    """
    lefts, rights = _entries(left), _entries(right)
    if len(lefts) != len(rights):
        raise ValueError(
            f"{subject}: {len(lefts)} entries on the left, {len(rights)} on the right: "
            "compare equally many"
        )
    if not lefts:
        raise ValueError(f"{subject}: nothing to compare: pass at least one entry")
    return decide(subject, _comparison(lefts, rights), **options)


def prove_zero(subject: str, expr: sympy.Expr | Sequence[sympy.Expr], **options: Any) -> Finding:
    """Decide whether expressions are zero; options as for `decide`."""
    entries = _entries(expr)
    return prove_equal(subject, entries, [sympy.S.Zero] * len(entries), **options)


def is_zero(expr: sympy.Expr) -> bool | None:
    """Tell whether an expression is zero everywhere, or None where that stays undecided.

    Raises
    ------
    ExpressionError
        If it holds an operation without an exact meaning.
    """
    expr = sympy.sympify(expr)
    if expr.is_Number:
        return bool(expr.is_zero)
    finding = prove_zero("expression", expr)
    if finding.shown:
        return True
    return False if finding.verdict is Verdict.REFUTED else None


def _entries(side: Any) -> list[sympy.Expr]:
    if isinstance(side, sympy.Basic) and not isinstance(side, sympy.MatrixBase | sympy.Tuple):
        return [side]
    if isinstance(side, int | float):
        return [sympy.sympify(side)]
    return [sympy.sympify(entry) for entry in side]


def _comparison(
    lefts: Sequence[sympy.Expr], rights: Sequence[sympy.Expr]
) -> Callable[[Arithmetic], list[tuple[Any, Any]]]:
    def experiment(a: Arithmetic) -> list[tuple[Any, Any]]:
        return [(a.value(x), a.value(y)) for x, y in zip(lefts, rights, strict=True)]

    return experiment
