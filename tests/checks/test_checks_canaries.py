"""Canaries say so when the program is wrong, and are quick enough to be asked every time."""

from typing import Any

import pytest
from sympy import Matrix

from benchmarks.faults.scenes import quaternion_top
from mechanics import kernel
from mechanics.checks import canaries
from mechanics.checks import route_canaries as routes
from mechanics.checks.canaries import check_canaries
from mechanics.crosscheck import CrossCheck, crosscheck
from mechanics.kernel import Finding, Verdict, same
from mechanics.scene.composite import Part
from mechanics.scene.loads import gravity, spring
from mechanics.scene.reactions import nonholonomic
from mechanics.scene.shapes import Rod, Semidisc


def refuted() -> str:
    (wrong,) = (f for f in check_canaries() if f.verdict is Verdict.REFUTED)
    assert wrong.evidence.startswith("do not trust this program: ")
    return wrong.evidence


def test_all_are_alive() -> None:
    found = check_canaries()
    assert len(found) == 5
    assert {finding.verdict for finding in found} == {Verdict.SUPPORTED}


@pytest.mark.campaign
def test_a_scene_whose_equations_stay_programs_asks_them_too() -> None:
    result = crosscheck(quaternion_top(), CrossCheck(("free_body",), states=0))
    assert result.routes["free_body"].equations is None
    asked = [f.subject for f in result.witnesses if f.subject.startswith("canaries: ")]
    assert asked == [finding.subject for finding in check_canaries()]


@pytest.mark.sample(2)
@pytest.mark.parametrize("verdict", list(Verdict))
def test_a_checker_that_always_says_the_same_is_seen(
    monkeypatch: pytest.MonkeyPatch, verdict: Verdict
) -> None:
    monkeypatch.setattr(canaries, "prove_equal", lambda *a: Finding("canary", verdict, "always"))
    words = refuted()
    assert ("is not proved" in words) is (verdict is not Verdict.PROVED)
    assert ("is not refuted" in words) is (verdict is not Verdict.REFUTED)


@pytest.mark.parametrize("shown", [True, False])
def test_a_comparison_of_routes_that_always_says_the_same_is_seen(
    monkeypatch: pytest.MonkeyPatch, shown: bool
) -> None:
    found = same("canary", 1, 1, "") if shown else kernel.refuted("canary", "", 1, 2)
    monkeypatch.setattr(routes, "compare", lambda one, two, filter_: found)
    assert ("one term more" in refuted()) is shown
    assert ("in another order" in refuted()) is not shown


@pytest.mark.parametrize(
    ("owner", "name", "wrong", "words"),
    (
        (Rod, "spread", property(lambda self: (self.length**2 / 3, 0)), "second moment xx"),
        (Semidisc, "size", property(lambda self: self.radius**2), "the mass"),
        (Part, "turn", property(lambda self: Matrix([[1, 0], [0, 1]])), "the centroid"),
    ),
)
def test_a_wrong_shape_is_seen(
    monkeypatch: pytest.MonkeyPatch, owner: type, name: str, wrong: Any, words: str
) -> None:
    monkeypatch.setattr(owner, name, wrong)
    assert words in refuted()


def test_numbers_that_are_read_as_others_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(canaries, "scalar", lambda value, what: 2 * value)
    assert "3 is read as 6" in refuted()


def test_a_load_that_keeps_something_else_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    def swapped(name: str, first: Any, second: Any, **rest: Any) -> Any:
        return spring(name, second, first, **rest)

    monkeypatch.setattr(canaries, "spring", swapped)
    assert "Spring: first P is kept as Q" in refuted()


def test_a_constraint_that_is_kept_as_another_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(canaries, "holonomic", nonholonomic)
    assert "holonomic True is kept as False" in refuted()


def test_gravity_that_keeps_another_field_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(canaries, "gravity", lambda field: gravity(2 * field))
    assert "Gravity: field a*N.x is kept as 2*a*N.x" in refuted()
