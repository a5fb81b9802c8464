"""A number that stands for a parameter is no mistake: an edit is told where it has that value."""

import pytest

import mechanics
from benchmarks.corpus.load import cases
from benchmarks.corpus.trial import tried
from mechanics.judge.check import derived
from systems import rod_pendulum

ROD = derived(rod_pendulum.scene())
RIGHT = "m*l^2/3*theta'' = m*9.81*l/2*sin(theta) + u"


def test_one_edit_is_told_with_the_value() -> None:
    (entry,) = mechanics.check(ROD, RIGHT.replace("+ u", "- u")).judged
    assert entry.verdict.name == "REFUTED"
    assert entry.blame is not None
    (edit,) = entry.blame.repairs[0].edits
    assert (edit.written, edit.right) == ("-", "+")
    assert "g = 9.81" in entry.blame.searched


def test_what_is_right_there_is_told_to_be_so() -> None:
    wrong, right = mechanics.check(ROD, [RIGHT.replace("+ u", "- u"), RIGHT]).judged
    assert [wrong.verdict.name, right.verdict.name] == ["REFUTED", "REFUTED"]
    assert right.right_if == ("g = 9.81",)
    assert wrong.blame is not None
    assert [e.written for e in wrong.blame.repairs[0].edits] == ["-"]


def test_where_one_edit_is_enough_no_value_is_supposed() -> None:
    (entry,) = mechanics.check(ROD, "m*l^2/3*theta'' = 9.81*m*g*l/2*sin(theta) + u").judged
    assert entry.blame is not None
    assert "where" not in entry.blame.searched


@pytest.mark.parametrize("mistake", ["a term", "a sine"])
def test_an_edit_is_told_with_the_values_of_the_file(mistake: str) -> None:
    name = f"burkardt_elastic/pendulum_elastic_deriv, {mistake}"
    (case,) = (case for case in cases() if case.name == name)
    trial = tried(case)
    assert (trial.verdict, trial.named) == ("REFUTED", 1)
