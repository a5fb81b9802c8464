"""What the program says and makes of everything that it ships with: a record to hold a rewrite.

    python -m benchmarks.record write FILE
    python -m benchmarks.record compare FILE

Public interfaces alone are asked, so that a record outlives what is inside: verdicts of
`crosscheck`, of `check` on published rows, on texts and codes of others and on a sample of the
detection campaign; operation counts; names and evidence of exported folders; headings and verdicts
of reports. Nothing in it depends on time, on a hash seed or on what ran before. `compare` prints a
line for each difference, ``system | what | before | now``, and exits with 1 where there is one.

    {system: {what: finding or count, as text}}
"""

import argparse
import json
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from html.parser import HTMLParser
from math import floor, log2
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from sympy import Eq

import mechanics
from benchmarks.detection.__main__ import names, run
from benchmarks.detection.trial import Result
from mechanics.judge.check import Check
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.system import System
from systems import ALL, SEED

Entries = Iterator[tuple[str, str]]
"""What, and what is said of it."""

Record = dict[str, dict[str, str]]

STATES = 64
"""For the residuals of compiled functions, whose size is not recorded."""

CASES = names(150, 40, 5, 3)
"""Of the detection campaign; all wrong mutants are blamed."""

FOLDERS = ("elastic_pendulum", "rolling_disc")
"""Whose C is written: without constraints, and with them."""


def record(systems: Iterable[System], parts: Iterable[str]) -> Record:
    """Everything that some parts of the record say of some systems."""
    return {system.name: {what: said for part in parts for what, said in PARTS[part](system)}
            for system in systems}  # fmt: skip


def difference(before: Record, now: Record) -> list[str]:
    """Lines ``system | what | before | now``, for what is in either record."""
    keys = sorted({(s, w) for found in (before, now) for s, table in found.items() for w in table})
    pairs = [(s, w, before.get(s, {}).get(w, "-"), now.get(s, {}).get(w, "-")) for s, w in keys]
    return [" | ".join(row) for row in pairs if row[2] != row[3]]


# -------------------------------------------------------------------- crosscheck, its JSON, report


def verdicts(system: System) -> Entries:
    """What `crosscheck` finds."""
    result = mechanics.crosscheck(system, mechanics.CrossCheck(states=STATES))
    (told,) = mechanics.to_json([result])["systems"]
    yield "crosscheck", "ok" if told["ok"] else "not ok"
    yield from _numbered((f"finding {f['subject']}", _verdict(f)) for f in told["findings"])
    rows = ((f"published {p['tag']} {p['label']}", _verdict(p)) for p in told["published"])
    yield from _numbered(rows)
    measured = ((f"residual {c['subject']}", f"{c['states']} states") for c in told["compiled"])
    yield from _numbered(measured)
    for name, route in told["routes"].items():
        for count in ("operations", "form", "forward_dynamics"):
            yield f"route {name} {count}", str(route[count])


def report(system: System) -> Entries:
    """Headings of the report, and its rows with a verdict, of the systems that come first."""
    if system not in SEED:
        return
    result = mechanics.crosscheck(system, mechanics.CrossCheck(states=STATES, motion=True))
    lines = _Lines()
    lines.feed(mechanics.to_html([result]))
    words = {verdict.name.lower() for verdict in mechanics.Verdict}
    kept = [f"report {tag}: {text}" for tag, text in lines.found
            if tag != "tr" or words & set(text.split())]  # fmt: skip
    yield from ((line, f"{kept.count(line)} times") for line in dict.fromkeys(kept))


class _Lines(HTMLParser):
    """Headings and rows of tables as text, without formulas and evidence."""

    KINDS = ("h1", "h2", "h3", "h4", "tr")

    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[str, str]] = []
        self._texts: list[list[str]] = []
        self._without: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "math" or ("class", "evidence") in attrs:
            self._without.append(tag)
        if tag in self.KINDS:
            self._texts.append([])

    def handle_data(self, data: str) -> None:
        if self._texts and not self._without:
            self._texts[-1].append(data)

    def handle_endtag(self, tag: str) -> None:
        if self._without and tag == self._without[-1]:
            self._without.pop()
        if tag in self.KINDS:
            self.found.append((tag, " ".join(" ".join(self._texts.pop()).split())))


# -------------------------------------------------------------------- compiled and exported


def operations(system: System) -> Entries:
    """CasADi instructions of every output of the model of each route."""
    for route in mechanics.ROUTES:
        graphs = mechanics.compile(mechanics.derive(system.scene(), route.name)).casadi
        for name in graphs:
            yield f"operations {route.name} {name}", str(graphs[name].n_instructions())


def folder(system: System) -> Entries:
    """Names of the files of an exported folder, counts and evidence of its manifest."""
    if system.name not in FOLDERS:
        return
    model = mechanics.compile(mechanics.derive(system.scene(), "kane"))
    with TemporaryDirectory() as place:
        mechanics.write_c(model, place, name="model", system=system.name, measure=False)
        told = json.loads((Path(place) / "manifest.json").read_text())
        yield "folder files", " ".join(sorted(path.name for path in Path(place).iterdir()))
    for name, function in told["functions"].items():
        counts = f"{function['operations']} operations, {function['divisions']} divisions"
        yield f"folder {name}", f"{counts}, {function['inputs']} -> {function['outputs']}"
    for step in told["chain"]["steps"]:
        rows = ((f"folder {step['step']}: {f['subject']}", _verdict(f)) for f in step["findings"])
        yield from _numbered(rows)


# -------------------------------------------------------------------- what others wrote


def ledger(system: System) -> Entries:
    """Published equations of motion of a system, as if a person asked."""
    truth = mechanics.derive(system.scene(), "free_body")
    rows = [row for row in system.published
            if isinstance(row.quantity, EquationOfMotion) and len(row.sides) == 2]  # fmt: skip
    for row in rows:
        try:
            found = mechanics.check(truth, Eq(*row.sides, evaluate=False))
        except mechanics.MechanicsError as error:
            yield f"ledger {row.tag}", f"{type(error).__name__}: {error}"
            continue
        yield f"ledger {row.tag}", _checked(found)


def texts(system: System) -> Entries:
    """Equations and codes of others, right ones and wrong ones: those of `tests/published`."""
    truth = mechanics.derive(system.scene(), "free_body")
    for name, (thing, options) in _texts().get(system.name, {}).items():
        yield f"text {name}", _checked(mechanics.check(truth, thing, **options))


def _texts() -> dict[str, dict[str, tuple[Any, dict[str, Any]]]]:
    """By system and name: what is checked, and with what declared."""
    from tests.published import test_published_acrobot as acrobot
    from tests.published import test_published_cartpole as cartpole
    from tests.published import test_published_double_inverted_pendulum as inverted
    from tests.published import test_published_double_pendulum as double
    from tests.published import test_published_rolling_disc as disc

    state: dict[str, Any] = {"names": cartpole.STATE}
    mirror = ("other vertical", "other sign of displacements", "other sign of inputs")
    lacking = "- m2*l1*lc2*dtheta1^2*sin(theta2) "
    rod = {"names": {"th": "theta", "thdot": "theta_dot"}}
    return {
        "cartpole": {
            **{name: (function, state) for name, (function, _, _) in cartpole.CASES.items()},
            "Florian": (cartpole.written(), {}),
            "Florian, parallel axis twice": (cartpole.written(shape="7"), {}),
            "Florian, angle for rate": (cartpole.written(w=r"\theta^2"), {}),
            "Florian, 1983": (cartpole.written(g="-g"), {}),
            "Florian, 1983, declared": (cartpole.written(g="-g"), {"convention": mirror}),
        },
        "acrobot": {
            **{v: (acrobot.dsdt(v), {"names": acrobot.STATE}) for v in ("book", "nips")},
            "rows of the book": (acrobot.ROWS.format(missing=lacking), {}),
            "rows of the paper": (acrobot.ROWS.format(missing=""), {}),
        },
        "rod_pendulum": {"Gymnasium": (acrobot.pendulum, rod)},
        "double_inverted_pendulum": {
            "energies as published": (inverted.text(inverted.WRONG), {}),
            "energies mended": (inverted.text(inverted.RIGHT), {}),
            "by Lagrange, as published": (inverted.by_lagrange(lambda one, two: one), {}),
            "by Lagrange, mended": (inverted.by_lagrange(lambda one, two: two), {}),
        },
        "double_pendulum": {
            name: (line, {"names": double.MOMENTA}) for name, line in double.LINES.items()
        },
        "rolling_disc": {
            "by Kane": (disc.by_kane(), {"names": disc.NAMES}),
            **{f"by Lagrange, gravity {up:+}": (disc.by_lagrange(up), {"names": disc.NAMES})
               for up in (1, -1)},
        },
    }  # fmt: skip


def campaign(cases: Sequence[str] = CASES) -> Record:
    """Verdicts and first edits of cases of the detection campaign, by system."""
    every = [system.name for system in ALL]
    found: Record = {name: {} for name in every}
    for case in run(cases, 1, every, len(CASES)):
        found[case.system][f"case {case.name}"] = _case(case)
    return found


def _case(case: Result) -> str:
    parts = [case.verdict, *(f"right if {words}" for words in case.right_if)]
    if case.undone is not None:
        parts += [f"undone {case.undone.how.split(':')[0]}", *case.undone.edits]
    return "; ".join(parts)


# -------------------------------------------------------------------- as text


def _checked(found: Check) -> str:
    """Verdict and first repair of each statement."""
    told = mechanics.check_json(found)["statements"]
    return "; ".join(f"{entry['tag']}: {_verdict(entry)}{_repair(entry)}" for entry in told)


def _repair(entry: Mapping[str, Any]) -> str:
    blame = entry["blame"]
    if blame is None:
        return ""
    edits = [f"{e['mistake']} {e['written']} -> {e['right']}"
             for repair in blame["repairs"][:1] for e in repair["edits"]]  # fmt: skip
    return f" ({', '.join([*edits, *blame['explanations']])})"


def _verdict(finding: Mapping[str, Any]) -> str:
    """The verdict, with its chance of error rounded up to a power of two."""
    bound = finding.get("error_bound")
    return finding["verdict"] + (f" 2^{floor(log2(bound)) + 1}" if bound else "")


def _numbered(rows: Iterable[tuple[str, str]]) -> Entries:
    """Rows under names of their own: the second of a name is ``name #2``."""
    seen: dict[str, int] = {}
    for name, said in rows:
        seen[name] = seen.get(name, 0) + 1
        yield (name if seen[name] == 1 else f"{name} #{seen[name]}"), said


PARTS = {
    "verdicts": verdicts, "operations": operations, "folder": folder, "report": report,
    "ledger": ledger, "texts": texts,
}  # fmt: skip


def everything() -> Record:
    """The whole record."""
    found = record(ALL, PARTS)
    for name, cases in campaign().items():
        found[name] |= cases
    return found


def main() -> None:
    """Write the record, or compare with one."""
    parser = argparse.ArgumentParser(description=str(__doc__).splitlines()[0])
    parser.add_argument("action", choices=("write", "compare"))
    parser.add_argument("file", type=Path)
    options = parser.parse_args()
    now = everything()
    if options.action == "write":
        options.file.write_text(json.dumps(now, indent=1, sort_keys=True) + "\n")
        return
    lines = difference(json.loads(options.file.read_text()), now)
    print("\n".join([*lines, f"{len(lines)} differences"]))
    sys.exit(bool(lines))


if __name__ == "__main__":
    main()
