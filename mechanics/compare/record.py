"""A comparison as plain data, and in words."""

from typing import Any

from mechanics.compare.compare import Cause, Comparison
from mechanics.kernel import Finding


def to_record(found: Comparison) -> dict[str, Any]:
    """The layout of one entry of ``mechanics compare --json``."""
    return {
        "scene": found.scene,
        "against": found.against,
        "agree": found.agree,
        "states": found.states,
        "quantities": [
            {
                "quantity": row.quantity,
                "unit": row.unit,
                "difference": row.difference if row.alike else None,
                "rounding": row.allowed,
                **_finding(row.finding),
            }
            for row in found.rows
        ],
        "causes": [_cause(cause) for cause in found.causes],
        "others": [_cause(cause) for cause in found.others],
        "unexplained": list(found.unexplained),
        "proof": None if found.proof is None else _finding(found.proof),
        "notes": list(found.notes),
    }


def _cause(cause: Cause) -> dict[str, Any]:
    return {
        "causes": list(cause.names),
        "words": cause.words,
        "quantities": list(cause.quantities),
        **_finding(cause.finding),
    }


def _finding(finding: Finding) -> dict[str, Any]:
    witness = finding.witness
    return {
        "verdict": finding.verdict.name,
        "evidence": finding.evidence,
        "witness": None
        if witness is None
        else {"state": dict(witness.state), "left": witness.left, "right": witness.right},
    }


def told(found: Comparison) -> list[str]:
    """What a person reads below the table: what the numbers are, and why they differ."""
    lines = [f"note: {note}" for note in found.notes]
    if found.agree:
        return [*lines, f"SUPPORTED: {found.against} and the scene agree at {found.states} states"]
    for cause in found.causes:
        names = " and ".join(cause.names)
        lines.append(f"{cause.finding.verdict.name}: {names}: {cause.words}")
        lines.append(f"  explains {', '.join(cause.quantities)}: {cause.finding.evidence}")
    for cause in found.others:
        lines.append(f"  so would {' and '.join(cause.names)}: {cause.words}")
    if found.proof is not None:
        verdict, evidence = found.proof.verdict.name, found.proof.evidence
        lines.append(f"our side, {verdict}: {found.proof.subject}, whatever is changed: {evidence}")
    if found.unexplained:
        lines.append(f"no cause of the table explains {', '.join(found.unexplained)}")
    return lines
