"""Decide an experiment: it becomes a statement of the kernel, which makes the verdict."""

from collections.abc import Callable, Sequence
from typing import Any

import sympy

from mechanics.errors import ZeroDivisorError
from mechanics.kernel import Finding, Verdict, undecided
from mechanics.kernel import decide as decide_statement
from mechanics.kernel.field import Inadmissible
from mechanics.kernel.normal import proves
from mechanics.kernel.statement import TARGET
from mechanics.kernel.trial import Answer, trial
from mechanics.symbolic.arithmetic import Arithmetic, Experiment, statement


def decide(
    subject: str, experiment: Experiment, *, target: float = TARGET, try_normal: bool = True
) -> Finding:
    """Decide whether all pairs of an experiment are equal.

    Parameters
    ----------
    subject : str
        What is checked, in words.
    experiment : callable
        Takes an `Arithmetic`, returns pairs (left, right) of its numbers; runs once.
    target : float
        Largest chance of error that a CERTIFIED finding may have.
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
    try:
        claim = statement(subject, experiment, target)
    except Inadmissible as reason:
        return undecided(subject, str(reason))
    except ZeroDivisorError:
        return undecided(subject, "division by zero, everywhere")
    return decide_statement(claim, try_normal=try_normal)


def answer(experiment: Experiment, target: float) -> Answer:
    """What the field says of an experiment: for what is only proposed, and proved afterwards."""
    try:
        claim = statement("", experiment, target)
    except (Inadmissible, ZeroDivisorError):
        return Answer.FAILED
    return trial(claim, lambda: False).answer


def proved(experiment: Experiment) -> bool:
    """Whether all pairs of an experiment have the same normal form; False says nothing."""
    try:
        claim = statement("", experiment, TARGET)
    except (Inadmissible, ZeroDivisorError):
        return False
    return trial(claim, lambda: proves(claim)).answer is Answer.PROVED


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
