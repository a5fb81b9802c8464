r"""What became of a person's equations, as JSON, stable.

    {"scene", "verdict", "ok", "statements": [...], "names": {...}, "remarks": [...]}

| key | what it is |
| --- | --- |
| verdict | the worst of all |
| statements | list of `tag`, `source`, `place`, `about`, `verdict`, `evidence`, `error_bound`,
  `witness`, `right_if`, `notes` |
| names | by the person's name: `meaning` in the scene, and `why` |

`witness` is as in `mechanics.report.json_report`; `about` is null where a line could not be read.
"""

from typing import Any

from mechanics.report.answer.check import Check
from mechanics.report.answer.judged import Judged
from mechanics.report.json_report import verdict_json


def to_json(found: Check) -> dict[str, Any]:
    """A result as a tree of dicts, lists, text and numbers that `json.dumps` accepts."""
    return {
        "scene": found.scene.name,
        "verdict": found.verdict.name,
        "ok": found.ok,
        "statements": [_statement(entry) for entry in found.judged],
        "names": {m.name: {"meaning": m.meaning, "why": m.why} for m in found.names},
        "remarks": list(found.remarks),
    }


def _statement(entry: Judged) -> dict[str, Any]:
    statement = entry.statement
    return {
        "tag": statement.tag,
        "source": statement.source,
        "place": statement.place,
        "about": None if statement.row is None else type(statement.row.quantity).__name__,
        **verdict_json(entry.finding),
        "right_if": list(entry.right_if),
        "notes": list(statement.notes),
    }
