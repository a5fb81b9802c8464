"""Grades: right, wrong, incomplete, in doubt, not judged; a hint is no answer."""

import csv
import io
import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from mechanics.blame.reference import Reference
from mechanics.cli.app import app
from mechanics.errors import InputError
from mechanics.grading.grade import grade
from mechanics.grading.group import Group, grade_files
from mechanics.grading.page import group_csv, group_html
from mechanics.grading.submission import things_in
from mechanics.judge.check import derived
from mechanics.judge.sources import Aside, Beside
from mechanics.worker import Limits
from systems import elastic_pendulum

SCENE = elastic_pendulum.scene()
SIX = (
    r"\[ (M+m)\ddot x + 2kx"
    r" + \frac{ML}{2}(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = 0 \]"
)
SEVEN = (
    r"\[ \frac{ML}{2}\ddot x\cos\theta + \frac{ML^2}{3}\ddot\theta + \frac{MgL}{2}\sin\theta = 0 \]"
)
LAW = "(M+m)*x'' + 2*k*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta))"
TWO = "(M+m)*x'^2/2 + M*L*x'*theta'*cos(theta)/2 + M*L^2*theta'^2/6"
FILES = {
    "right.tex": f"{SIX}\n{SEVEN}",
    "slip.tex": f"{SIX}\n{SEVEN.replace('{3}', '{12}')}",
    "half.tex": SIX,
    "other.tex": f"{SIX}\n{SEVEN}\n" + r"\[ V = kx^2 + \frac{MgL}{2}\cos\theta \]",
    "doubt.txt": "x'' = w*x",
    "nothing.txt": "hello",
    "notebook.ipynb": json.dumps(
        {"cells": [{"cell_type": "markdown", "source": [f"My result:\n{SIX}\n", SEVEN]}]}
    ),
    "empty.tex": "",
}
HOSTILE = {"loop.py": "def f(x, theta, x_dot, theta_dot):\n    while True: pass\n"}
PATIENT = Limits(60)
"""What is right is graded on a slow machine, too."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("submissions")
    for name, text in (FILES | HOSTILE).items():
        (path / name).write_text(text)
    return path


@pytest.fixture(scope="module")
def found(folder: Path) -> Group:
    files = [folder / name for name in FILES]
    return grade_files(SCENE, files, run_python=True, limits=PATIENT, jobs=2)


def grades(found: Group) -> dict[str, object]:
    return {one.name: one for one in found.grades}


def test_verdicts_and_scores(found: Group) -> None:
    told = {name: (one.verdict, one.score) for name, one in grades(found).items()}
    assert told == {
        "right.tex": ("right", 1.0),
        "slip.tex": ("wrong", 0.5),
        "half.tex": ("incomplete", 0.5),
        "other.tex": ("wrong", 2 / 3),
        "doubt.txt": ("in doubt", 0.0),
        "nothing.txt": ("in doubt", 0.0),
        "notebook.ipynb": ("right", 1.0),
        "empty.tex": ("not judged", None),
    }


def test_the_change_is_named_and_the_hint_is_no_answer(found: Group) -> None:
    slip = grades(found)["slip.tex"]
    assert slip.change == "write 3 for 12"
    assert "parallel axis" in slip.hint
    assert "3" not in slip.hint
    assert grades(found)["half.tex"].missing == "1 of 2 independent equations of motion"
    assert ("something is missing", 3) in found.mistakes


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("require", "name", "verdict"),
    [("motion", "other.tex", "right"), ("motion", "slip.tex", "wrong"),
     ("right", "half.tex", "right"), ("all", "half.tex", "incomplete")],
)  # fmt: skip
def test_what_is_required(folder: Path, require: str, name: str, verdict: str) -> None:
    (one,) = grade_files(SCENE, [folder / name], require=require).grades
    assert one.verdict == verdict


def test_what_does_not_end_is_stopped_and_not_judged(folder: Path) -> None:
    files = [folder / name for name in HOSTILE]
    (one,) = grade_files(SCENE, files, run_python=True, limits=Limits(2)).grades
    assert (one.verdict, one.score) == ("not judged", None)
    assert one.remarks == ("it took more than 2 s",)


def test_python_is_not_run_unless_that_is_allowed(folder: Path) -> None:
    (one,) = grade_files(SCENE, [folder / "loop.py"]).grades
    assert one.verdict == "not judged"
    assert "--run-python" in one.remarks[0]


def test_tables_and_pages(found: Group) -> None:
    rows = list(csv.DictReader(io.StringIO(group_csv(found))))
    assert [row["submission"] for row in rows] == list(FILES)
    assert rows[1]["change"] == "write 3 for 12"
    page = group_html(found)
    assert "write 3 for 12" in page
    assert "<script" not in page


@pytest.mark.campaign
def test_the_command(folder: Path, tmp_path: Path) -> None:
    files = [str(folder / "right.tex"), str(folder / "slip.tex")]
    run = CliRunner().invoke(app, ["grade", "elastic_pendulum", *files, "--json", "-",
                                   "--report", str(tmp_path / "pages")])  # fmt: skip
    assert run.exit_code == 1
    assert [g["verdict"] for g in json.loads(run.stdout)["grades"]] == ["right", "wrong"]
    assert (tmp_path / "pages" / "index.html").exists()
    assert "the factor is wrong" in (tmp_path / "pages" / "002-slip.tex.html").read_text()
    assert CliRunner().invoke(app, ["grade", "elastic_pendulum", files[0]]).exit_code == 0


def test_a_file_that_is_not_there_is_named() -> None:
    run = CliRunner().invoke(app, ["grade", "elastic_pendulum", "nowhere.tex"])
    assert isinstance(run.exception, InputError)
    assert str(run.exception) == "file nowhere.tex: it is not there: name a file or folder"


def test_no_submission_and_an_unknown_requirement_are_refused(folder: Path) -> None:
    with pytest.raises(InputError, match="no submission"):
        grade_files(SCENE, [])
    with pytest.raises(InputError, match="require 'some': it can be all, motion, right"):
        grade_files(SCENE, [folder / "right.tex"], require="some")
    with pytest.raises(InputError, match=r"--value \(values=\) 'q': .* no such parameter"):
        grade_files(SCENE, [folder / "right.tex"], options={"values": {"q": 1}})


def test_what_a_notebook_does_not_show_is_not_graded(tmp_path: Path) -> None:
    cells = [f"<!-- {SIX} -->", f"~~{SEVEN}~~", f"<del>{SIX}</del> <s>{SEVEN}</s>"]
    cells += [f"\n[//]: # ({SIX})\n", "the end = none"]
    path = tmp_path / "struck.ipynb"
    path.write_text(json.dumps({"cells": [{"cell_type": "markdown", "source": cells}]}))
    (shown,) = things_in(path)
    assert shown.strip() == "the end = none"


@pytest.mark.parametrize(
    "later",
    ["f = lambda x: 0", "del f\ndef g(x): return 0", "ONE = 0", "globals()['f'] = lambda x: 0",
     "f.__code__ = (lambda x: 0).__code__"],
)  # fmt: skip
def test_a_function_that_a_later_cell_binds_again_is_the_later_one(
    tmp_path: Path, later: str
) -> None:
    cells = [
        {"cell_type": "code", "source": [text]}
        for text in ("%matplotlib inline\nONE = 1", "def f(x):\n    return ONE", "f(0)", later)
    ]
    path = tmp_path / "again.ipynb"
    path.write_text(json.dumps({"cells": cells}))
    function, *_ = things_in(path, run_python=True)
    assert function(0) == 0
    cells.append({"cell_type": "code", "source": ["raise RuntimeError('wrong')"]})
    path.write_text(json.dumps({"cells": cells}))
    with pytest.raises(InputError, match="it ends in RuntimeError: wrong"):
        things_in(path, run_python=True)


def test_the_function_is_the_last_one_that_is_no_part_of_another(tmp_path: Path) -> None:
    path = tmp_path / "parts.py"
    path.write_text("def f(x):\n    return g(x) + 1\n\ndef g(x):\n    return 2*x\n")
    (function,) = things_in(path, run_python=True)
    assert function(3) == 7


def test_commented_code_is_an_aside_of_a_notebook_and_other_comments_are_its_prose(
    tmp_path: Path,
) -> None:
    cells = [
        {"cell_type": "markdown", "source": ["x'' = -x"]},
        {"cell_type": "code", "source": ["# x'' = x\n# the equation above is wrong"]},
    ]
    path = tmp_path / "commented.ipynb"
    path.write_text(json.dumps({"cells": cells}))
    prose, aside = things_in(path)
    assert prose == "x'' = -x\n\nthe equation above is wrong"
    assert aside == Aside("x'' = x", "a comment of code cell 2")


@pytest.mark.parametrize("kind", ["markdown", "raw"])
def test_cells_beside_a_function_are_its_comments(tmp_path: Path, kind: str) -> None:
    cells = [
        {"cell_type": kind, "source": ["The function below is wrong."]},
        {"cell_type": "code", "source": ["def f(x):\n    return -x"]},
    ]
    path = tmp_path / "beside.ipynb"
    path.write_text(json.dumps({"cells": cells}))
    function, beside = things_in(path, run_python=True)
    assert (function(1), beside) == (-1, Beside("The function below is wrong."))


def test_what_says_nothing_new_counts_once() -> None:
    reference = Reference(derived(SCENE))
    again = [f"{k}*({LAW}) = 0" for k in range(1, 31)]
    assert grade(reference, "one", again[:1]).score == 0.5
    assert grade(reference, "thirty", again).score == 0.5
    energies = [f"T = {TWO}", f"T = {TWO}"]
    assert grade(reference, "energy", [*again, *energies]).score == 2 / 3
