r"""Results as JSON, stable.

    {"systems": [{"name", "ok", "routes", "findings", "witnesses", "published",
      "compiled"}]}

| key | what it is |
| --- | --- |
| name | name of the system |
| ok | true when every finding and every published row is PROVED or CERTIFIED, and every witness
  SUPPORTED |
| routes | by route: `seconds` of the derivation, `operations` of M and f after sharing, `form` of
  forward dynamics as it was compiled, and the operations of `forward_dynamics` in that form;
  `kane_sympy` and `lagrange_sympy` are SymPy's own methods, which are not compiled, or `absent`
  with the reason |
| findings | list of `subject`, `verdict`, `evidence`, `error_bound`, `witness` |
| witnesses | the same, of numbers that share no code with the routes: SUPPORTED at best |
| published | list of `tag`, `label`, `verdict`, `evidence`, `error_bound`, `witness` |
| compiled | list of `subject`, `max_eps`, `states` |

A verdict is one of PROVED, CERTIFIED, SUPPORTED, REFUTED, UNDECIDED. `error_bound` is a number for
CERTIFIED and null otherwise. `witness` is null, or for REFUTED `{"state": {name: value}, "left",
"right"}` with exact decimal or rational values as text and the enclosures of the two sides there.
`max_eps` is null where the residual is not finite, since JSON knows no infinity.
"""

from collections.abc import Sequence
from math import isfinite
from typing import Any

from mechanics.kernel import Finding
from mechanics.report.result import SystemResult
from mechanics.scene import Scene
from mechanics.scene.json.write import to_json as scene_json
from mechanics.scene.system import System


def to_json(results: Sequence[SystemResult] | Scene | System) -> dict[str, Any]:
    """Results, a scene or a system as a tree of dicts, lists, text and numbers for `json.dumps`.

    Parameters
    ----------
    results : sequence of SystemResult, Scene or System

    Returns
    -------
    dict
        As the docstring of this module says, or as ``docs/scene.schema.json`` says of a scene,
        which `from_json` reads. Keys are only ever added.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> to_json(rod_pendulum.scene())["coordinates"]
    ['theta']
    """
    if isinstance(results, Scene | System):
        return scene_json(results)
    return {"systems": [_system(result) for result in results]}


def _system(result: SystemResult) -> dict[str, Any]:
    return {
        "name": result.name,
        "ok": result.ok,
        "routes": {
            name: {
                "seconds": route.seconds,
                "operations": route.operations,
                "form": route.form,
                "forward_dynamics": route.forward,
                "absent": route.absent,
            }
            for name, route in result.columns.items()
        },
        "findings": [
            {"subject": finding.subject, **verdict_json(finding)} for finding in result.findings
        ],
        "witnesses": [
            {"subject": finding.subject, **verdict_json(finding)} for finding in result.witnesses
        ],
        "published": [
            {"tag": entry.row.tag, "label": entry.row.label, **verdict_json(entry.finding)}
            for entry in result.published
        ],
        "compiled": [
            {
                "subject": entry.subject,
                "max_eps": entry.max_eps if isfinite(entry.max_eps) else None,
                "states": entry.states,
            }
            for entry in result.compiled
        ],
    }


def verdict_json(finding: Finding) -> dict[str, Any]:
    """`verdict`, `evidence`, `error_bound` and `witness` of a finding."""
    witness = finding.witness
    return {
        "verdict": finding.verdict.name,
        "evidence": finding.evidence,
        "error_bound": finding.error_bound,
        "witness": None
        if witness is None
        else {
            "state": dict(witness.state),
            "solved": dict(witness.solved),
            "left": witness.left,
            "right": witness.right,
        },
    }
