"""First step of the chain: derived equations = graph, output by output."""

from collections.abc import Iterator
from typing import Any

from mechanics.compiled.fixed import words
from mechanics.compiled.translation_validation.code import Code
from mechanics.compiled.translation_validation.defined import divides_by_zero, where_defined
from mechanics.compiled.translation_validation.derived import Derived
from mechanics.compiled.translation_validation.laws import LAWS, Law, Outputs, law_of
from mechanics.compiled.translation_validation.physics import Entry, Physics
from mechanics.compiled.translation_validation.stages import cut_at_slopes
from mechanics.compiled.translation_validation.step import composed
from mechanics.errors import InputError
from mechanics.kernel import Finding, undecided
from mechanics.program.operations import Sign
from mechanics.program.program import reachable

STEP = "step"

LARGEST = 3000
"""Nodes of two sides beyond which its normal form outgrows every limit."""


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
    rates : Code, optional
        For the step: the graph of (q', u'), which is a function of its own to decide about.
    **options
        As for `mechanics.kernel.decide`.

    Raises
    ------
    InputError
        If it is not known what the function should be.
    """
    subject = f"compiled {name.replace('_', ' ')} = derived, {known.route}"
    if known.fixed:
        subject += f", {words(known.fixed)}"
    physics = Physics(known)
    law = law_of(name, known.program.outputs)
    if law is None and (name != STEP or rates is None):
        raise InputError(f"function {name!r}: what it should be is known for {', '.join(LAWS)}")
    outputs = code.results(physics.builder, physics.inputs)
    written = tuple(physics.builder.obligations)
    physics.builder.obligations = {}
    entries = list(_entries(law, outputs, physics, rates))
    truth = tuple(physics.builder.obligations)
    sides = [node.number for _, *pair in entries for node in pair]
    if len(reachable(physics.builder, sides)) > LARGEST:
        options["try_normal"] = False
    found = None
    if rates is not None and law is None:
        found = physics.decide_together(subject, list(cut_at_slopes(physics, outputs, rates)))
    if found is None or not found.shown:
        found = physics.decide_entries(subject, entries, **options)
    if not found.shown:
        return found
    if doubt := divides_by_zero(physics, written):
        return undecided(subject, doubt)
    # What a graph divides by are pivots, which its status tells.
    others = [obligation for obligation in written if obligation.sign is not Sign.NONZERO]
    return where_defined(found, physics, others, truth)


def _entries(
    law: Law | None, outputs: Outputs, physics: Physics, rates: Code | None
) -> Iterator[Entry]:  # fmt: skip
    if law is not None:
        yield from law(physics, outputs)
        return
    assert rates is not None  # `prove_derived` refuses a step without them
    other = composed(physics.builder, rates, physics.known.time, physics.inputs)
    for output, nodes in outputs.items():
        for i, (x, y) in enumerate(zip(nodes, other[output], strict=True)):
            yield f"{output}[{i}]", x, y
