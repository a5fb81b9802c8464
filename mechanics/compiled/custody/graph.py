"""First step of the chain: derived equations = graph, output by output."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

from mechanics.compiled.custody.code import Code
from mechanics.compiled.custody.derived import Derived
from mechanics.compiled.custody.laws import LAWS, Pair
from mechanics.compiled.custody.step import composed
from mechanics.compiled.fixed import words
from mechanics.errors import InputError
from mechanics.exact import Arithmetic, Finding, decide

Named = Callable[[Arithmetic], Iterator[Pair]]
STEP = "step"


def prove_derived(
    name: str, code: Code, known: Derived, rates: Code | None = None, **options: Any
) -> Finding:
    """Decide whether a graph is what was derived.

    Parameters
    ----------
    name : str
        What the function should be.
    code : Code
        Of the graph, with named constants as inputs.
    known : Derived
    rates : Code, optional
        For the step: the graph of (q', u'), which is a function of its own to decide about.
    **options
        As for `mechanics.exact.decide`.

    Raises
    ------
    InputError
        If it is not known what the function should be.
    """
    subject = f"compiled {name.replace('_', ' ')} = derived, {known.route}"
    if known.fixed:
        subject += f", {words(known.fixed)}"
    if name == STEP and rates is not None:
        other = composed(rates, known.time)
        return decide_entries(subject, _same(code, other, known), **options)
    if name not in LAWS:
        raise InputError(f"function {name!r}: what it should be is known for {', '.join(LAWS)}")

    def pairs(a: Arithmetic) -> Iterator[Pair]:
        fix(a, known)
        results = code.results(code.numbers(a, known.symbols))
        yield from LAWS[name](a, results, known)

    return decide_entries(subject, pairs, **options)


def fix(a: Arithmetic, known: Derived) -> None:
    """Let fixed parameters have their values: how a graph was simplified is not relied on."""
    for symbol, value in known.fixed.items():
        a.assign(symbol, a.value(value))


def _same(code: Code, other: Code, known: Derived) -> Named:
    """Both graphs at the same arguments."""

    def pairs(a: Arithmetic) -> Iterator[Pair]:
        fix(a, known)
        left = code.results(code.numbers(a, known.symbols, whole_angles=True))
        right = other.results(other.numbers(a, known.symbols, whole_angles=True))
        for name, numbers in left.items():
            for i, (x, y) in enumerate(zip(numbers, right[name], strict=True)):
                yield f"{name}[{i}]", x, y

    return pairs


def decide_entries(subject: str, pairs: Named, **options: Any) -> Finding:
    """Decide about all pairs at once; where that fails, name the first entry that differs."""
    found = decide(subject, lambda a: [(x, y) for _, x, y in pairs(a)], **options)
    if found.shown:
        return found
    names: list[str] = []
    decide(subject, lambda a: _noted(pairs, names, a), **{**options, "try_normal": False})
    for name in dict.fromkeys(names):
        single = decide(subject, partial(_only, pairs, name), **options)
        if not single.shown:
            return replace(single, evidence=f"{name}: {single.evidence}")
    return found


def _noted(pairs: Named, names: list[str], a: Arithmetic) -> list[tuple[Any, Any]]:
    found = list(pairs(a))
    names[:] = [name for name, _, _ in found]
    return [(x, y) for _, x, y in found]


def _only(pairs: Named, wanted: str, a: Arithmetic) -> list[tuple[Any, Any]]:
    return [(x, y) for name, x, y in pairs(a) if name == wanted]
