"""A reduction as JSON: what was asked, what was done, and what is proved of it.

Whoever reads it does the same again: `repeat` makes the edits, and proves the bound once more.
"""

import json
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.program import Program
from mechanics.program.c_printer import PRIMARY, UNARY, Text, expression
from mechanics.program.operations import CONSTANT, INPUT, NEGATE, PI
from mechanics.reduce.edits import Edit, Kind
from mechanics.reduce.reduce import Reduction, repeated

DEPTH, LONGEST = 8, 100
"""Operations that are written one within the other, and characters; what is deeper is ``(...)``."""


def record(reduction: Reduction) -> dict[str, Any]:
    """What stands in a JSON report."""
    box, finding = reduction.start.box, reduction.finding
    kept, dropped = reduction.parameters
    entries, couplings = reduction.couplings
    return {
        "scene": reduction.equations.scene.name,
        "of": reduction.of,
        "error": str(reduction.error),
        "absolute": reduction.absolute,
        "boxes": reduction.boxes,
        "over": {n: [str(a), str(b)] for n, (a, b) in sorted(box.items()) if a < b},
        "values": {n: str(a) for n, (a, b) in sorted(box.items()) if a == b},
        "domain": [[name, str(low), str(high)] for name, (low, high) in reduction.box.items()],
        "operations": {"before": reduction.before, "after": reduction.after},
        "outputs": [
            {"output": name, "size": float(size), "bound": float(most), "bounded": finite}
            for name, size, most, finite in zip(
                reduction.outputs, reduction.sizes, reduction.bounds, reduction.bounded, strict=True
            )
        ],
        "parameters": {"kept": list(kept), "dropped": list(dropped)},
        "couplings": {"kept": list(entries), "dropped": list(couplings)},
        "unproved": reduction.unproved,
        "dropped": [words(reduction, edit) for edit in reduction.edits],
        "finding": {
            "subject": finding.subject,
            "verdict": finding.verdict.name,
            "evidence": finding.evidence,
        },
        "base": reduction.place,
        "edits": [[edit.node, edit.kind.name] for edit in reduction.edits],
    }


def record_text(reduction: Reduction) -> str:
    """The record as text of a file."""
    return json.dumps(record(reduction), indent=1, ensure_ascii=False) + "\n"


def repeat(text: str, equations: Equations) -> Reduction:
    """The reduction of a record, made and proved again for equations.

    Raises
    ------
    InputError
        If it is no record, or one of another scene.
    """
    try:
        told = json.loads(text)
        over = {name: tuple(map(Fraction, ends)) for name, ends in told["over"].items()}
        values = {name: Fraction(value) for name, value in told["values"].items()}
        edits = [Edit(int(node), Kind[kind]) for node, kind in told["edits"]]
        return repeated(
            equations, Fraction(told["error"]), of=told["of"], over=over, values=values,
            absolute=bool(told["absolute"]), boxes=int(told["boxes"]), place=int(told["base"]),
            edits=edits, unproved=int(told["unproved"]),
        )  # fmt: skip
    except (
        KeyError,
        TypeError,
        ValueError,
        IndexError,
        AttributeError,
        ZeroDivisionError,
    ) as error:
        words_ = f"{type(error).__name__} {error}"
        raise InputError(f"reduction.json: it is no record of a reduction: {words_}") from None


def words(reduction: Reduction, edit: Edit) -> str:
    """An edit in the names of the scene."""
    program = reduction.start.program
    couplings: Mapping[int, str] = dict(reduction.base.couplings)
    if edit.node in couplings and edit.kind is Kind.ZERO:
        return f"coupling {couplings[edit.node]}"
    code, operands = program.operations[edit.node], program.operands_of(edit.node)
    if edit.kind in (Kind.ANGLE, Kind.ONE):
        whole = _text(program, edit.node)
        return f"{whole} = {'1' if edit.kind is Kind.ONE else _text(program, operands[0])}"
    if code == INPUT:
        return f"parameter {_text(program, edit.node)}"
    lost = edit.node
    if edit.kind is not Kind.ZERO:
        lost = operands[edit.kind is Kind.FIRST]
    return f"term {_text(program, lost)}"


def _text(program: Program, node: int) -> str:
    """A value as deep as fits into a line."""
    texts = (_written(program, node, depth).code for depth in range(DEPTH, 0, -1))
    return next((text for text in texts if len(text) <= LONGEST), "(...)")


def _written(program: Program, node: int, depth: int) -> Text:
    code, first = program.operations[node], program.operands[0]
    if code == CONSTANT:
        value = program.constants[first[node]]
        return Text(f"{float(value):.4g}", UNARY if value < 0 else PRIMARY)
    if code == INPUT:
        return Text(program.inputs[first[node]])
    if code == PI:
        return Text("pi")
    if depth == 0:
        return Text("(...)")
    below = depth if code == NEGATE else depth - 1
    return expression(code, [_written(program, k, below) for k in program.operands_of(node)])
