"""An error shows the line that it is about, and underlines what is meant."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from mechanics.cli.excerpt import excerpt, excerpt_of_c
from mechanics.errors import InputError
from mechanics.scene.json.write import to_json
from systems import four_bar

URDF = """<robot name="leg">
  <link name="hip"/>
  <link name="shank">
    <inertial><origin xyz="0 0 -0.2"/><mass value="2"/>
      <inertia ixx="0.03" iyy="0.03" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="knee" type="revolute">
    <parent link="hip"/><child link="shank"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="50" velocity="10"/>
  </joint>
</robot>
"""


def underlined(place: str) -> tuple[str, str]:
    """The file and line that an excerpt names, and what it underlines."""
    *head, line, carets = place.splitlines()
    assert max(len(line), len(carets)) <= 80, place
    start, end = carets.index("^"), carets.rindex("^") + 1
    return (head[0].strip().removeprefix("--> ") if head else "", line[start:end])


@pytest.mark.parametrize(
    ("command", "meant"),
    [
        ("derive rockr", "rockr"),
        ("crosschek rocker", "crosschek"),
        ("crosscheck rocker --routes kane,bogus", "bogus"),
        ("crosscheck rocker --reprot a.html", "--reprot"),
        ("crosscheck rocker --states many", "many"),
        ("crosscheck rocker --states=many", "many"),
        ("derive rocker --format bogus", "bogus"),
        ("simulate rocker --out a.csv --set theta", "theta"),
        ("simulate rocker --out a.csv --set M=heavy", "heavy"),
        ("simulate rocker --out a.csv --set theta=0 --set thta=1", "thta"),
        ("simulate rocker --out a.csv --set M=1 --set M=2", "M=2"),
        ("simulate rocker --out a.txt", "a.txt"),
        ("ensemble rocker --vary theta=a:1:5 --out e", "a"),
        ("linearize rocker --at thta=2", "thta"),
        ("simulate rocker --initial R=3", "--initial"),
        ("linearize rolling_disc --speeds u2=v/0", "0"),
        ("check rocker - --about kinetik", "kinetik"),
        ("codegen rocker --out c --fix gg=9.81", "gg"),
    ],
)
def test_a_part_of_the_command_is_underlined(
    run: Any, monkeypatch: pytest.MonkeyPatch, command: str, meant: str
) -> None:
    monkeypatch.setattr("sys.stdin.read", lambda: "theta'' = 0", raising=False)
    ran = run(*command.split())
    assert ran.code == 2
    assert underlined(ran.place) == ("", meant)


@pytest.mark.parametrize(
    ("command", "meant"),
    [
        ("simulate {file} --out a.csv --set lll=3", "lll"),
        ("simulate {file} --out a.csv --set=lll=3", "lll"),
        ("simulate {file} --out a.csv --set m=-1", "m="),
        ("ensemble {file} --vary thta=0:1:3 --out {folder}", "thta"),
        ("linearize {file} --at theta=1/2,l=1", "1/2,l=1"),
        ("linearize {file} --at theta=k/3", "k"),
        ("codegen {file} --out c --fix gg=9.81", "gg"),
    ],
)
def test_a_slip_of_the_command_is_not_looked_for_in_the_scene(
    run: Any, pendulum: Callable[..., Path], tmp_path: Path, command: str, meant: str
) -> None:
    command = command.format(file=pendulum(), folder=tmp_path / "e")
    ran = run(*command.split())
    assert ran.code == 2
    assert underlined(ran.place) == ("", meant)


def test_a_state_at_which_nothing_rests_is_of_the_command(tmp_path: Path) -> None:
    words = "rocker: theta = 1 rad, f = 0 is no equilibrium: the torque on theta is M*R*g*sin(1)/2"
    file = tmp_path / "mine.py"
    file.write_text('"""The rocker, whose angle theta is small."""', encoding="utf-8")
    place = excerpt(InputError(words), words, ["linearize", str(file), "--at", "theta=1"])
    assert underlined(place)[1].startswith("theta")


def test_values_are_set_by_set(run: Any) -> None:
    assert (
        "Values are set by --set NAME=VALUE." in run("simulate", "rocker", "--initial", "R=3").err
    )


def test_a_folder_that_holds_another_run_is_underlined(
    run: Any, pendulum: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    first = ("ensemble", pendulum(), "--duration", "0.1", "--out", "e", "--vary")
    assert run(*first, "theta=0:1:2").code == 0
    ran = run(*first, "theta=0:1:3")
    assert ran.code == 2
    assert underlined(ran.place) == ("", "e")


def test_what_is_missing_is_said_with_what_it_is_for(run: Any) -> None:
    ran = run("ensemble", "rocker", "--out", "e")
    assert "Add --vary NAME=FROM:TO:COUNT: " in ran.err


@pytest.mark.parametrize(
    ("old", "new", "line", "meant"),
    [
        ('on="bob"', 'on="bib"', 20, "bib"),
        ("along=A.y", "along=A.x", 20, "S"),
        ("gravity(-g * N.y)", "gravity(-g)", 19, "gravity(-g)"),
        ("-l * A.y", "-l * B.y", 16, "B"),
        ("def scene():", "def scene(:", 12, ":"),
        ("(theta,), bodies", "(), bodies", 17, "Scene("),
    ],
)
def test_a_line_of_a_scene_is_underlined(
    run: Any, pendulum: Callable[..., Path], old: str, new: str, line: int, meant: str
) -> None:
    path = pendulum((old, new))
    ran = run("derive", path)
    assert ran.code == 2
    assert underlined(ran.place) == (f"{path}:{line}", meant)


@pytest.mark.parametrize(
    ("old", "new", "line", "meant"),
    [
        ('link="shank"', 'link="shnk"', 8, "shnk"),
        ('mass value="2"', 'mass value="-2"', 4, "<mass"),
        ('type="revolute"', 'type="revolut"', 7, "revolut"),
        ('xyz="0 1 0"', 'xyz="0 1"', 9, "<axis"),
        ("  </joint>\n", "", 11, "r"),
    ],
)
def test_a_line_of_a_robot_is_underlined(
    run: Any, tmp_path: Path, old: str, new: str, line: int, meant: str
) -> None:
    path = tmp_path / "leg.urdf"
    path.write_text(URDF.replace(old, new), encoding="utf-8")
    ran = run("derive", path)
    assert ran.code == 2
    assert underlined(ran.place) == (f"{path}:{line}", meant)


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        ("XML Error: invalid keyword: 'hing' Element 'joint', line 3", "hing"),
        ("Schema violation: unrecognized attribute: 'axes' Element 'joint', line 3", "axes"),
        ("Error: axis too small in joint Element name 'q', id 0, line 3", "<joint "),
    ],
)
def test_what_mujoco_quotes_is_underlined(tmp_path: Path, words: str, meant: str) -> None:
    """In the words of MuJoCo 3.3."""
    path = tmp_path / "arm.xml"
    line = '<joint name="q" type="hing" axes="0 0 0"/>'
    path.write_text(f"<mujoco><worldbody>\n<body>\n  {line}\n", encoding="utf-8")
    refused = f"file {path}: MuJoCo refuses it: {words}"
    where, found = underlined(excerpt(InputError(refused), refused, ["derive", str(path)]))
    assert where == f"{path}:3" and found.startswith(meant)


def test_a_line_of_json_is_underlined(run: Any, tmp_path: Path) -> None:
    path = tmp_path / "bar.json"
    whole = to_json(four_bar.scene())
    whole["bodies"][1]["mass"] = "zz"
    text = json.dumps(whole, indent=1)
    path.write_text(text, encoding="utf-8")
    line = text[: text.index('"zz"')].count("\n") + 1
    assert underlined(run("derive", path).place) == (f"{path}:{line}", "zz")
    whole["bodies"][1] |= {"mass": "m1", "masss": "m1"}
    path.write_text(json.dumps(whole, indent=1), encoding="utf-8")
    assert underlined(run("derive", path).place)[1] == "masss"
    path.write_text('{"format": 1,,}', encoding="utf-8")
    assert underlined(run("derive", path).place) == (f"{path}:1", ",")


C_TEXT = {"arm.c": "int arm_energy(double *e)\n{\n    e[0] = 1;\n    return 0;\n}\n"}


@pytest.mark.parametrize(
    ("words", "line", "meant"),
    [
        ("arm.c: arm_energy = graph: refused: arm.c:4:5: While is not supported", 4, "r"),
        ("arm.c: arm_energy = graph: e[0]: the enclosures are disjoint", 3, "e[0]"),
    ],
)
def test_a_line_of_c_is_underlined(words: str, line: int, meant: str) -> None:
    assert underlined(excerpt_of_c(words, C_TEXT)) == (f"arm.c:{line}", meant)


def test_what_no_file_has_is_not_shown() -> None:
    assert excerpt_of_c("arm.c: arm_power = graph: e[0]: other", C_TEXT) == ""
    assert excerpt_of_c("leg.c:4:5: While is not supported", C_TEXT) == ""


def test_what_a_file_has_instead_of_a_scene_is_listed(run: Any, tmp_path: Path) -> None:
    path = tmp_path / "own.py"
    path.write_text("def swing(): pass\ndef of(size): pass\n", encoding="utf-8")
    assert f"name the function that does, {path}:swing" in run("derive", path).err
    path.write_text("scene = 3\n", encoding="utf-8")
    assert "write def scene(): above the lines that make it" in run("derive", path).err
    assert "did you mean 'rocker'? Or give" in run("derive", "rockr").err


def test_a_name_of_the_example_has_a_suggestion(run: Any, pendulum: Callable[..., Path]) -> None:
    path = pendulum(("bodies=", 'example={"thta": 1}, bodies='))
    assert "the example gives 'thta': did you mean 'theta'?" in run("derive", path).err
