"""Findings on a terminal: how many of each verdict, and what is behind one that is not shown."""

from collections import Counter
from collections.abc import Sequence

from rich.console import Console
from rich.markup import escape

from mechanics.kernel import Finding, Verdict

STYLES = {
    Verdict.PROVED: "green",
    Verdict.CERTIFIED: "green",
    Verdict.SUPPORTED: "yellow",
    Verdict.UNDECIDED: "yellow",
    Verdict.REFUTED: "bold red",
}


def counted(findings: Sequence[Finding]) -> str:
    """How many findings have each verdict, as markup."""
    counts = Counter(finding.verdict for finding in findings)
    words = [
        f"[{STYLES[verdict]}]{counts[verdict]} {verdict.name}[/]"
        for verdict in Verdict
        if counts[verdict]
    ]
    return ", ".join(words)


def explain(console: Console, finding: Finding) -> None:
    """Print a finding with its witness."""
    style = STYLES[finding.verdict]
    name = finding.verdict.name
    console.print(f"[{style}]{name}[/] {escape(finding.subject)}: {escape(finding.evidence)}")
    if finding.witness is not None:
        state = ", ".join(f"{symbol} = {value}" for symbol, value in finding.witness.state)
        if state:
            console.print(f"  at {escape(state)}")
        if solved := ", ".join(f"{name} = {value}" for name, value in finding.witness.solved):
            console.print(f"  with {escape(solved)}")
        console.print(f"  left  {escape(finding.witness.left)}")
        console.print(f"  right {escape(finding.witness.right)}")
