"""Five hundred single edits of the C text: each is caught by the mathematics, or changes nothing.

An edit is one token: an operator, a name, an index, a literal down to its last digit, a type, a
bound, or a statement dropped or said twice, or two names that change places. Hashes play no part:
the texts are judged as they stand.
"""

import random
from collections import Counter

import pytest

from mechanics.kernel import Verdict

pytestmark = pytest.mark.campaign

PARTS, EDITS = 10, 50
FEWEST_REFUTED, MOST_HARMLESS = 3, 10
"""Of the edits of one part."""


@pytest.mark.sample(1)
@pytest.mark.parametrize("part", range(PARTS))
def test_every_edit_is_caught_or_harmless(edited, judged, alike, needed, part: int) -> None:
    source, compiler = random.Random(part), needed("gcc")
    counts: Counter[str] = Counter()
    harmless: list[str] = []
    for _ in range(EDITS):
        change = edited(source)
        findings = judged(change)
        assert findings, change.words
        verdicts = {finding.verdict for finding in findings if not finding.shown}
        if verdicts:
            counts["refuted" if Verdict.REFUTED in verdicts else "refused or undecided"] += 1
            for finding in findings:
                assert finding.verdict is not Verdict.REFUTED or finding.witness, change.words
            continue
        # Independently of all algebra: the machine code of the edited text, run.
        assert alike(change, compiler), f"neither caught nor harmless: {change.words}"
        harmless.append(change.words)
    print(dict(counts), f"{len(harmless)} harmless:", *harmless, sep="\n  ")
    assert sum(counts.values()) + len(harmless) == EDITS
    assert counts["refuted"] >= FEWEST_REFUTED
    assert len(harmless) <= MOST_HARMLESS
