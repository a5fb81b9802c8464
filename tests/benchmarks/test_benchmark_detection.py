"""The campaign of mutants and rewritings on a small sample: its goals, and why to trust it."""

import json
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest
from sympy import Symbol, cos, sin, symbols, sympify

import mechanics
from benchmarks.detection import __main__ as campaign
from benchmarks.detection.case import NothingToDrawError, case
from benchmarks.detection.equivalent import same
from benchmarks.detection.figures import line, mended, missed, summary, tables
from benchmarks.detection.forms.every import FORMS
from benchmarks.detection.models import OBJECTS, wrong_model
from benchmarks.detection.mutate import KINDS, made, mutations
from benchmarks.detection.rows import Row, holds, subject
from benchmarks.detection.tree import at, negative, number, places, product, put, read, written
from benchmarks.detection.trial import Result, judged
from benchmarks.detection.undone import distance, undone
from benchmarks.detection.vocabulary import vocabulary
from benchmarks.detection.whole import judged_whole
from mechanics.blame.result import Blame, Edit, Mistake, Repair
from mechanics.claims.statement import Statement
from mechanics.errors import MechanicsError
from mechanics.judge.check import Judged
from mechanics.kernel import Finding, Verdict
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion
from systems import ALL

pytestmark = pytest.mark.campaign

NAMES = tuple(system.name for system in ALL)
MUTANTS, REWRITINGS = 9, 5
BLAMED = ("elastic_pendulum", "rocker", "cartpole")

by_system = pytest.mark.parametrize("name", NAMES)


def results(name: str, cases: Sequence[str]) -> list[Result]:
    return list(campaign.run(cases, 2, [name], 0))


@pytest.mark.sample(2)
@by_system
def test_every_wrong_mutant_is_refuted(name: str) -> None:
    found = results(name, [f"m{i}" for i in range(MUTANTS)])
    assert [line(result) for result in found if missed(result)] == []
    assert {result.verdict for result in found} == {"REFUTED"}


@pytest.mark.sample(2)
@by_system
def test_no_right_rewriting_is_refuted(name: str) -> None:
    found = results(name, [f"r{i}" for i in range(REWRITINGS)])
    assert [line(result) for result in found if missed(result)] == []
    assert {result.verdict for result in found} <= {"PROVED", "CERTIFIED"}


@pytest.mark.sample(1)
@pytest.mark.parametrize("kind", ["k", "b", "s"])
def test_whole_models_and_boxes_are_judged(kind: str) -> None:
    found = [judged_whole(f"{kind}{i}", 2, NAMES) for i in range(8)]
    assert [line(result) for result in found if missed(result)] == []
    assert len({result.system for result in found}) > 1


def test_a_wrong_model_is_wrong_in_equations_that_sympy_forms() -> None:
    about, source = subject("cartpole"), Random(5)
    models = [model for _ in range(60) if (model := wrong_model(about, source)) is not None]
    assert len({model.where for model in models}) > 3
    for _, build in OBJECTS:
        assert mechanics.check(about.free_body, build(about.scene), blame=False).ok
        assert not mechanics.check(about.free_body, build(models[0].scene), blame=False).ok


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
            assert all(made(row.trees, [mutation])[i] == row.trees[i] for i in others)


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
    assert put(tree, {(1,): y}) == product(number(Fraction(-1, 2)), y, y)
    # A number moves to the front, and must not move what is put in beside it.
    both = put(product(x, y), {(0,): y, (1,): product(number(3), x)})
    assert both == product(number(3), y, x)
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


def test_the_first_repair_undoes_what_was_done() -> None:
    found = list(campaign.run([f"m{i}" for i in range(20)], 2, BLAMED, 20))
    assert [line(r) for r in found if len(r.kinds) == 1 and missed(r)] == []
    double = [r for r in found if len(r.kinds) == 2]
    assert sum(mended(r) for r in double) >= 0.9 * len(double)


def judged_repair(edits: Sequence[Mistake], sides: Sequence[str], kind: str = "sign") -> str:
    """How a repair of an acceleration of the rod is judged."""
    drawn = next(c for i in range(300) if (c := case(f"m{i}", 2, ["rod_pendulum"])).kinds == (kind,)
                 and c.row.about == "acceleration" and c.form == "LaTeX")  # fmt: skip
    scene = drawn.about.scene
    names = {s.name: s for s in (*scene.q, *scene.u, *scene.ud, *scene.input_symbols,
                                 *scene.parameters)}  # fmt: skip
    typed = tuple(sympify(side, locals=names) for side in sides)
    row = published("1", EquationOfMotion(), *typed, label="")
    finding = Finding("", Verdict.PROVED, "")
    repair = Repair(tuple(Edit(m, "a", "b") for m in edits), "", finding, row)
    statement = Statement(row, "", "1")
    blamed = Judged(statement, finding, (), Blame((), (repair,)))
    return undone(drawn, blamed, 0.0).how


RIGHT = ("theta_ddot", "3*g/(2*l)*sin(theta) + 3*u/(m*l**2)")
SCALED = ("2*theta_ddot", "3*g/l*sin(theta) + 6*u/(m*l**2)")
WRONG = ("theta_ddot", "3*g/(2*l)*sin(theta)")


@pytest.mark.parametrize(
    ("edits", "sides", "how"),
    [
        ([Mistake.SIGN], RIGHT, "exactly"),
        ([Mistake.SIGN], SCALED, "as good"),
        ([Mistake.MISSING], SCALED, "edits of sizes [2] for mistakes of sizes [1]"),
        ([Mistake.SIGN, Mistake.FACTOR], SCALED, "2 edits for 1 mistakes"),
        ([Mistake.SIGN], WRONG, "the repair is shown, but wrong at independent states"),
    ],
)
def test_a_repair_is_judged(edits: Sequence[Mistake], sides: Sequence[str], how: str) -> None:
    assert judged_repair(edits, sides) == how


def test_mistakes_in_what_simplifies_are_as_large_as_they_are_seen() -> None:
    x, y, z = symbols("x y z")
    assert distance(x + y, x + y) == 0
    assert distance(x * sin(y), x * cos(y)) == 1
    assert distance(x * y**2 + z, x * y**3 + z) == 1
    assert distance(x + y + z, x) == 4
    assert distance(x**3, x**2 * y) == 3


def test_one_command_prints_everything(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file = tmp_path / "results.json"
    sizes = ["--count", "4", "--rewritings", "2", "--conventions", "1", "--blame", "1"]
    words = ["detection", *sizes, "--systems", "cartpole", "--seed", "2", "--json", str(file)]
    monkeypatch.setattr("sys.argv", words)
    campaign.main()
    printed = capsys.readouterr().out
    assert "| wrong mutants REFUTED | 100.00 % (4 of 4) | 100 % |" in printed
    assert "0 misses" in printed
    assert [entry["name"] for entry in json.loads(file.read_text())] == [
        "m0", "m1", "m2", "m3", "r0", "r1", "c0",
    ]  # fmt: skip
    monkeypatch.setattr("sys.argv", [*words[:1], *words[9:13], "--only", "m2"])
    campaign.main()
    again = capsys.readouterr().out
    assert again.startswith("m2 cartpole")
    assert "mistake made" in again


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
