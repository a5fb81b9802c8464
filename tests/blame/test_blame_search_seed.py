r"""The seed document's equations with one term changed: the smallest edit changes it back.

written  ->  one mistake  ->  REFUTED, and the first repair is what was written before
"""

import re

import pytest

import mechanics
from mechanics.blame.result import Mistake, Repair
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import elastic_pendulum, rocker

PENDULUM = derived(elastic_pendulum.scene())
ROCKER = derived(rocker.scene())

SIX = (
    r"(M+m) \ddot{x}+2 k x+M \frac{L}{2} \ddot{\theta} \cos \theta"
    r"-M \frac{L}{2} \dot{\theta}^{2} \sin \theta=0"
)
SEVEN = (
    r"M \frac{L}{2} \ddot{x} \cos \theta+M \frac{L^{2}}{3} \ddot{\theta}"
    r"+M g \frac{L}{2} \sin \theta=0"
)
ROCKER_SEVEN = (
    r"\left[I_{C}+M R^{2}\left(\frac{5}{4}+\cos \theta\right)\right] \ddot{\theta}"
    r"-M \frac{R^{2}}{2} \dot{\theta}^{2} \sin \theta-M g \frac{R}{2} \sin \theta"
    r"=f(t)\left(R+\frac{R}{2} \cos \theta\right)"
)
SEEDS = {"six": (PENDULUM, SIX), "seven": (PENDULUM, SEVEN), "rocker": (ROCKER, ROCKER_SEVEN)}


def repairs(truth, text: str) -> tuple[Repair, ...]:
    """The repairs of a refuted equation; each of them is proved."""
    (entry,) = mechanics.check(truth, text).judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.blame is not None
    for repair in entry.blame.repairs:
        assert repair.finding.shown
        # The text that is told is read again: it says what was proved.
        (again,) = mechanics.check(truth, repair.repaired).judged
        assert again.finding.shown, repair.repaired
    assert entry.blame.repairs, entry.blame.searched
    return entry.blame.repairs


def signs(text: str) -> list[int]:
    """Where the signs stand."""
    return [match.start() for match in re.finditer(r"[+-]", text)]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("name", "at"), [(name, at) for name, (_, text) in SEEDS.items() for at in signs(text)]
)
def test_every_sign_is_found(name: str, at: int) -> None:
    """One sign changed is one sign to change back, at its place."""
    truth, right = SEEDS[name]
    wrong = right[:at] + ("-" if right[at] == "+" else "+") + right[at + 1 :]
    first, *_ = repairs(truth, wrong)
    (edit,) = first.edits
    assert (edit.mistake, edit.span) == (Mistake.SIGN, (at, at + 1))
    assert first.repaired == right


ONE = (
    ("six", "2 k x", "k x", Mistake.FACTOR),
    ("six", "2 k x", "2 m x", Mistake.SYMBOL),
    ("six", "2 k x", r"2 k \theta", Mistake.SYMBOL),
    ("six", r"\dot{\theta}^{2}", r"\dot{\theta}^{3}", Mistake.POWER),
    ("six", r"\dot{\theta}^{2}", r"\dot{\theta}", Mistake.POWER),
    ("six", r"\cos", r"\sin", Mistake.FUNCTION),
    ("six", "(M+m)", "(M+M)", Mistake.SYMBOL),
    ("six", "(M+m)", "M", Mistake.MISSING),
    ("six", "+2 k x", "", Mistake.MISSING),
    ("six", r"-M \frac{L}{2} \dot{\theta}^{2} \sin \theta", "", Mistake.MISSING),
    ("six", r"+M \frac{L}{2} \ddot{\theta} \cos \theta", "", Mistake.MISSING),
    ("six", "(M+m) \\ddot{x}", "", Mistake.MISSING),
    ("six", "=0", r"=m \ddot{\theta}", Mistake.EXTRA),
    ("six", "2 k x", "2 k x+m g", Mistake.EXTRA),
    ("seven", r"\frac{L^{2}}{3}", r"\frac{L^{2}}{12}", Mistake.FACTOR),
    ("seven", r"\frac{L^{2}}{3}", r"\frac{7 L^{2}}{3}", Mistake.FACTOR),
    ("seven", r"\frac{L^{2}}{3}", r"\frac{L}{3}", Mistake.POWER),
    ("seven", r"\sin", r"\cos", Mistake.FUNCTION),
    ("seven", r"+M g \frac{L}{2} \sin \theta", "", Mistake.MISSING),
    ("rocker", r"\frac{5}{4}", r"\frac{3}{4}", Mistake.FACTOR),
    ("rocker", r"I_{C}+", "", Mistake.MISSING),
    (
        "rocker",
        r"\left(R+\frac{R}{2} \cos \theta\right)",
        r"\frac{R}{2} \cos \theta",
        Mistake.MISSING,
    ),
    ("rocker", r"-M g \frac{R}{2} \sin \theta", "", Mistake.MISSING),
    ("rocker", r"\dot{\theta}^{2}", r"\ddot{\theta}", Mistake.SYMBOL),
)


@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "right", "wrong", "mistake"), ONE)
def test_one_mistake_is_named(name: str, right: str, wrong: str, mistake: Mistake) -> None:
    """One edit of the same kind mends it."""
    truth, text = SEEDS[name]
    assert right in text
    first, *_ = repairs(truth, text.replace(right, wrong, 1))
    (edit,) = first.edits
    assert edit.mistake is mistake, edit


TWO = (
    ("six", (("2 k x", "3 k x"), (r"-M \frac", r"+M \frac"))),
    ("six", (("2 k x", "k x"), (r"\cos", r"\sin"))),
    ("six", (("(M+m)", "(M-m)"), (r"\dot{\theta}^{2}", r"\dot{\theta}"))),
    ("six", (("+2 k x", ""), (r"-M \frac", r"+M \frac"))),
    ("seven", ((r"\frac{L^{2}}{3}", r"\frac{L^{2}}{12}"), (r"\sin", r"\cos"))),
    ("seven", ((r"\cos", r"\sin"), (r"+M g", r"-M g"))),
    ("rocker", ((r"\frac{5}{4}", r"\frac{1}{4}"), (r"-M g", r"+M g"))),
    ("rocker", (("I_{C}+", ""), (r"\dot{\theta}^{2} \sin", r"\dot{\theta}^{2} \cos"))),
)


@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "changes"), TWO)
def test_two_independent_mistakes_are_both_named(
    name: str, changes: tuple[tuple[str, str], ...]
) -> None:
    """Two edits, one for each."""
    truth, text = SEEDS[name]
    for right, wrong in changes:
        assert right in text
        text = text.replace(right, wrong, 1)
    first, *_ = repairs(truth, text)
    assert len(first.edits) == 2, first


def test_what_no_small_edit_mends_says_what_was_tried() -> None:
    """An equation that has nothing to do with the system has no repair, and says so."""
    text = r"m \ddot{x} = k L \dot{\theta}^{3} + g^{2} m \sin x + k \cos x"
    (entry,) = mechanics.check(PENDULUM, text).judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.blame is not None
    assert entry.blame.repairs == ()
    assert "no edit was found that makes it right" in entry.blame.searched


def test_blame_can_be_switched_off() -> None:
    """Without it a refuted statement has a verdict only."""
    (entry,) = mechanics.check(PENDULUM, SIX.replace("2 k", "3 k"), blame=False).judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.blame is None


def test_two_terms_of_one_sum_are_both_missed() -> None:
    """Two terms that are left out are two edits."""
    text = SIX.replace("+2 k x", "").replace(r"-M \frac{L}{2} \dot{\theta}^{2} \sin \theta", "")
    first, *_ = repairs(PENDULUM, text)
    assert [edit.mistake for edit in first.edits] == [Mistake.MISSING] * 2
    assert sum("k" in edit.right for edit in first.edits) == 1


def test_equally_small_repairs_are_all_shown() -> None:
    """Halving one half of an equation, or doubling the other: both are right, both are told."""
    text = (
        r"(M+m) \ddot{x}+3 k x+M L \left(\ddot{\theta} \cos \theta"
        r"-\dot{\theta}^{2} \sin \theta\right)=0"
    )
    found = repairs(PENDULUM, text)
    assert len(found) > 1
    assert len({repair.repaired for repair in found}) == len(found)
    assert len({len(repair.edits) for repair in found}) == 1
