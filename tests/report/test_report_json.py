"""The layout of the JSON report is a promise to programs."""

import dataclasses
import json
import math

from mechanics.kernel import Finding, Verdict
from mechanics.report.json_report import to_json
from mechanics.report.result import ResidualResult, SystemResult


def test_layout(small: SystemResult) -> None:
    (system,) = json.loads(json.dumps(to_json([small]), allow_nan=False))["systems"]
    keys = {"name", "ok", "routes", "findings", "witnesses", "published", "compiled"}
    assert set(system) == keys
    assert system["routes"]["kane"] == {
        "seconds": 3.5, "operations": 1234, "form": "fewest", "forward_dynamics": 1239,
        "absent": "",
    }  # fmt: skip
    assert system["published"] == [
        {
            "tag": "(1)",
            "label": "motion",
            "verdict": "PROVED",
            "evidence": "zero in the normal form",
            "error_bound": None,
            "witness": None,
        }
    ]
    assert system["compiled"] == [
        {"subject": "kane: equation (1), double", "max_eps": 3.25, "states": 100_000}
    ]
    keys = {"subject", "verdict", "evidence", "error_bound", "witness"}
    assert {frozenset(finding) for finding in system["findings"]} == {frozenset(keys)}


def test_witness_and_bound(small: SystemResult) -> None:
    found = to_json([small])["systems"][0]["findings"]
    by_verdict = {finding["verdict"]: finding for finding in found}
    assert by_verdict["CERTIFIED"]["error_bound"] == 2.0**-100
    assert by_verdict["REFUTED"]["witness"] == {
        "state": {"x": "1/3", "m": "2.5"},
        "solved": {},
        "left": "1.25 +/- 1e-30",
        "right": "-1.25 +/- 1e-30",
    }
    assert by_verdict["UNDECIDED"]["witness"] is None


def test_ok_needs_every_row(small: SystemResult) -> None:
    proved = (Finding("a = b", Verdict.PROVED, ""),)
    good = dataclasses.replace(small, findings=proved)
    empty = dataclasses.replace(small, findings=(), published=())
    oks = [system["ok"] for system in to_json([small, good, empty])["systems"]]
    assert oks == [False, True, False]


def test_an_infinite_residual_is_null(small: SystemResult) -> None:
    result = dataclasses.replace(small, compiled=(ResidualResult("a", math.inf, 1),))
    assert to_json([result])["systems"][0]["compiled"][0]["max_eps"] is None
