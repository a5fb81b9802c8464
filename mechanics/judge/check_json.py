r"""What became of a person's equations, as JSON, stable.

    {"scene", "verdict", "ok", "statements": [...], "names": {...}, "remarks": [...],
     "unjudged": [sentence], "aside": [line or sentence]}

| key | what it is |
| --- | --- |
| verdict | the worst of all |
| statements | list of `tag`, `source`, `place`, `about`, `verdict`, `evidence`, `error_bound`,
  `witness`, `terms`, `domain`, `right_if`, `blame`, `notes` |
| names | by the person's name: `meaning` in the scene, and `why` |
| unjudged | sentences of the text, and definitions that nothing uses, compared with nothing |
| aside | lines and sentences that were set aside by `only` |

`domain` says where the verdict holds, or what was written is undefined; empty for everywhere.
`witness` is as in `mechanics.report.json_report`, `terms` has each `term` of both sides with its
`value` there; `about` is null where a line could not be read.
`blame` is null where a statement is not refuted or that was not asked for; else

    {"differences": [...], "repairs": [...], "explanations": [sentence], "searched": sentence}

| key | what it is |
| --- | --- |
| differences | list of `group`, `written`, `right`, and `origin`, a list of sentences |
| repairs | the smallest changes, all equally small, the likeliest first: list of `edits`, the whole
  statement as `repaired`, and its `verdict`, `evidence`, `error_bound` |
| edits | list of `mistake`, a word of `mechanics.blame.result.Mistake`, its `sentence`, `written`,
  `right`, `definition`: the name of the person's definition that it stands in, or empty, and
  `span`: where it stands in `source`, `[from, to]`, or null |

Formulas are in the person's own notation. `written` is empty for a missing term, `right` for one
too many. Keys are only ever added.
"""

from typing import Any

from mechanics.blame.result import Blame, Edit, Repair
from mechanics.errors import wanted
from mechanics.report.answer.check import Check
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.term_values import term_values
from mechanics.report.json_report import verdict_json


def to_json(found: Check) -> dict[str, Any]:
    """A result as a tree of dicts, lists, text and numbers that `json.dumps` accepts.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> answer = check(rod_pendulum.scene(), "l*theta'' = 3/2*g*sin(theta) + 3*u/(m*l)")
    >>> check_json(answer)["verdict"]
    'PROVED'
    """
    wanted(found, (Check,), "check_json", "pass check(scene, equations)")
    return {
        "scene": found.scene.name,
        "verdict": found.verdict.name,
        "ok": found.ok,
        "statements": [_statement(entry) for entry in found.judged],
        "names": {m.name: {"meaning": m.meaning, "why": m.why} for m in found.names},
        "remarks": [*found.remarks, *found.suggested],
        "unjudged": list(found.unjudged),
        "aside": list(found.aside),
    }


def _statement(entry: Judged) -> dict[str, Any]:
    statement = entry.statement
    return {
        "tag": statement.tag,
        "source": statement.source,
        "place": statement.place,
        "about": None if statement.row is None else type(statement.row.quantity).__name__,
        **verdict_json(entry.finding),
        "verdict": entry.verdict.name,
        "terms": [
            {"term": term, "value": value}
            for term, value in term_values(statement, entry.finding.witness)
        ],
        "domain": entry.finding.domain,
        "right_if": list(entry.right_if),
        "blame": None if entry.blame is None else _blame(entry.blame),
        "notes": list(statement.notes),
    }


def _blame(blame: Blame) -> dict[str, Any]:
    return {
        "differences": [
            {
                "group": row.group,
                "written": row.written,
                "right": row.right,
                "origin": list(row.origin),
            }
            for row in blame.differences
        ],
        "repairs": [_repair(repair) for repair in blame.repairs],
        "explanations": list(blame.explanations),
        "searched": blame.searched,
    }


def _repair(repair: Repair) -> dict[str, Any]:
    verdict = verdict_json(repair.finding)
    del verdict["witness"]  # what is right has none
    return {
        "edits": [_edit(edit) for edit in repair.edits],
        "repaired": repair.repaired,
        **verdict,
    }


def _edit(edit: Edit) -> dict[str, Any]:
    return {
        "mistake": edit.mistake.name,
        "sentence": edit.mistake.value,
        "written": edit.written,
        "right": edit.right,
        "definition": edit.definition,
        "span": None if edit.span is None else list(edit.span),
    }
