"""The campaign of mutants and rewritings on a small sample: its goals, and why to trust it."""

from collections.abc import Sequence
from fractions import Fraction
from random import Random

import pytest
from sympy import Symbol

from benchmarks.detection import __main__ as campaign
from benchmarks.detection.case import NothingToDrawError, case
from benchmarks.detection.equivalent import same
from benchmarks.detection.figures import line, missed, summary, tables
from benchmarks.detection.forms.every import FORMS
from benchmarks.detection.mutate import KINDS, mutations
from benchmarks.detection.rows import Row, holds, subject
from benchmarks.detection.tree import at, negative, number, places, product, put, read, written
from benchmarks.detection.trial import Result, judged
from benchmarks.detection.vocabulary import vocabulary
from mechanics.errors import MechanicsError
from systems import ALL

NAMES = tuple(system.name for system in ALL)
MUTANTS, REWRITINGS = 14, 7
BLAMED = ("elastic_pendulum", "rocker", "cartpole")

by_system = pytest.mark.parametrize("name", NAMES)


def results(name: str, cases: Sequence[str]) -> list[Result]:
    return list(campaign.run(cases, 2, [name], 0))


@by_system
def test_every_wrong_mutant_is_refuted(name: str) -> None:
    found = results(name, [f"m{i}" for i in range(MUTANTS)])
    assert [line(result) for result in found if missed(result)] == []
    assert {result.verdict for result in found} == {"REFUTED"}


@by_system
def test_no_right_rewriting_is_refuted(name: str) -> None:
    found = results(name, [f"r{i}" for i in range(REWRITINGS)])
    assert [line(result) for result in found if missed(result)] == []
    assert {result.verdict for result in found} <= {"PROVED", "CERTIFIED"}


def test_conventions_that_are_not_declared_are_named() -> None:
    found = [judged(f"c{i}", 2, ["cartpole", "double_pendulum"]) for i in range(6)]
    assert [line(result) for result in found if missed(result)] == []
    assert all(result.right_if for result in found)


@by_system
def test_all_right_rows_hold_and_there_are_many(name: str) -> None:
    about = subject(name)
    assert len(about.rows) >= 10
    assert {"motion"} <= {row.about for row in about.rows}
    assert all(holds(about, row, row.trees) for row in about.rows)


@by_system
def test_every_mistake_changes_its_place_and_nothing_else(name: str) -> None:
    about = subject(name)
    known = vocabulary(about.scene)
    row = about.rows[0]
    for kind, _ in KINDS:
        for mutation in mutations(kind, row.trees, known):
            assert at(row.trees[mutation.side], mutation.path) == mutation.was != mutation.now
            others = [i for i in range(len(row.trees)) if i != mutation.side]
            assert all(mutation.into(row.trees)[i] == row.trees[i] for i in others)


def test_every_kind_of_mistake_occurs() -> None:
    about = subject("pendulum_chain")
    known = vocabulary(about.scene)
    found = {m.kind for row in about.rows for kind, _ in KINDS
             for m in mutations(kind, row.trees, known)}  # fmt: skip
    assert found == {kind for kind, _ in KINDS}


def test_a_case_is_the_same_again() -> None:
    one, two = (case("m7", 3, NAMES) for _ in range(2))
    assert one.written.text == two.written.text
    assert one.mutations == two.mutations
    assert case("m7", 4, NAMES).written.text != one.written.text


def test_equations_that_only_look_wrong_are_recognised() -> None:
    about = subject("elastic_pendulum")
    row = next(row for row in about.rows if row.name == "published (6)")
    turned = tuple(negative(tree) for tree in row.trees)
    assert holds(about, row, turned) is True
    assert same(about, row, turned)
    wrong = (row.trees[0], read(about.scene.parameters[0]))
    assert holds(about, row, wrong) is False
    assert not same(about, row, wrong)


def test_a_potential_energy_is_known_up_to_a_constant() -> None:
    about = subject("rocker")
    row = next(row for row in about.rows if row.about == "potential energy")
    length = about.scene.parameters[0]
    assert holds(about, row, (read(written(row.trees[0]) + length**2),)) is True
    theta = about.scene.q[0]
    assert holds(about, row, (read(written(row.trees[0]) + theta),)) is False


def test_trees_are_put_together_as_people_write_them() -> None:
    x, y = (read(Symbol(name)) for name in "xy")
    tree = product(number(Fraction(-1, 2)), x, y)
    assert negative(tree) == product(number(Fraction(1, 2)), x, y)
    assert put(tree, (1,), y) == product(number(Fraction(-1, 2)), y, y)
    assert {path for path, _ in places(tree)} == {(), (0,), (1,), (2,)}


def test_every_form_is_written() -> None:
    about = subject("cartpole")
    row = next(row for row in about.rows if row.about == "acceleration")
    texts = {name: make(about, row, row.trees, {}, Random(1)) for name, make in FORMS}
    assert len(texts) == 7
    assert all(text is not None and text.text for text in texts.values())


def test_what_cannot_be_drawn_is_told() -> None:
    about = subject("two_mass_chain")
    assert all(row.about != "reaction" for row in about.rows)
    nothing = Row("nothing", "motion", (number(0), number(0)))
    known = vocabulary(about.scene)
    assert all(not mutations(kind, nothing.trees, known) for kind, _ in KINDS)
    assert issubclass(NothingToDrawError, ValueError)


def test_figures_are_printed(capsys: pytest.CaptureFixture[str]) -> None:
    found = list(campaign.run(["m0", "m1", "r0", "c0"], 2, ["cartpole"], 1))
    text = "\n".join([*summary(found), *tables(found)])
    assert "| wrong mutants REFUTED | 100.00 % (2 of 2) | 100 % |" in text
    assert "| right rewritings falsely REFUTED | 0.00 % (0 of 1) | 0 |" in text
    assert found[0].undone is not None
    assert found[1].undone is None


def test_a_miss_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object, **__: object) -> None:
        raise MechanicsError("nothing can be read")

    monkeypatch.setattr("mechanics.check", fails)
    (found,) = campaign.run(["m0"], 2, ["cartpole"], 0)
    assert missed(found) == "wrong, but error"
    assert "nothing can be read" in line(found)
