"""Options that are for another kind of thing than what is checked are refused by name."""

from pathlib import Path
from typing import Any

import pytest
from sympy import Symbol

from mechanics import BlackBox, check
from mechanics.errors import InputError
from mechanics.grading.group import grade_files
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
TEXT = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
C = "double acc(double theta, double u, double m, double l, double g) {\nreturn %s; }\n"
ACC = "3*g/(2*l)*sin(theta) + 3*u/(m*l*l)"
HARMLESS = "what is not here changes nothing"


def rate(theta: float, u: float, m: float, l: float, g: float) -> float:
    return 3 / 2 * g / l * theta + u


@pytest.mark.parametrize(
    ("thing", "option", "words"),
    [
        (TEXT, {"function": "acc"}, "--function (function=): it names a function of C"),
        (rate, {"function": "rate"}, "of Python: file.py:NAME"),
        (rate, {"notation": "latex"}, "--notation (notation=): it is for texts"),
        (TEXT, {"convention": HARMLESS}, f"--convention '{HARMLESS}': it is for C, C++ and MATLAB"),
        (TEXT, {"convention": "single precision as exact"}, "it is for code that rounds"),
        (rate, {"convention": HARMLESS}, "there is only rate, a function of Python: leave it out"),
        (BlackBox(rate), {"about": "energy"}, "there is only a black box: leave it out"),
        (BlackBox(rate), {"values": {"g": 1}}, "--value (values=): it is for what is read"),
        (Symbol("theta"), {"function": "acc"}, "there is only objects of SymPy"),
    ],
)
def test_an_option_for_another_kind_of_thing_is_refused(
    thing: Any, option: dict[str, Any], words: str
) -> None:
    with pytest.raises(InputError) as refused:
        check(SCENE, thing, **option)
    assert words in str(refused.value)


@pytest.mark.parametrize("name", ["own.c", "own.m", "own.jl"])
def test_a_file_of_code_has_no_notation(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text("function a = acc(theta)\na = theta;\nend" if name != "own.c" else C % ACC)
    with pytest.raises(InputError, match=f"there is only {name}, code in"):
        check(SCENE, path, notation="latex")


def test_an_option_that_one_of_several_things_takes_is_taken(tmp_path: Path) -> None:
    path = tmp_path / "own.c"
    path.write_text(C % ACC + C.replace("acc", "other") % "g")
    assert check(SCENE, [TEXT, path], function="acc").ok


TWO = {
    "own.m": "function a = %s(theta, u, m, l, g)\na = %s;\nend\n",
    "own.jl": "function %s(theta, u, m, l, g)\nreturn %s\nend\n",
    "own.cpp": "double %s(double theta, double u, double m, double l, double g)\n{ return %s; }\n",
}


@pytest.mark.parametrize("name", TWO)
def test_the_function_of_a_file_is_the_one_that_is_named(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text(TWO[name] % ("acc", ACC) + TWO[name] % ("wrong", ACC.replace("3*u", "2*u")))
    with pytest.raises(InputError, match=r"--function \(function=\) says which"):
        check(SCENE, path)
    assert check(SCENE, path, function="acc").ok
    assert check(SCENE, path, function="wrong", blame=False).verdict.name == "REFUTED"
    with pytest.raises(InputError, match="there is no function nix: there are acc, wrong"):
        check(SCENE, path, function="nix")


def test_the_function_of_a_submission_in_c_is_the_one_that_is_named(tmp_path: Path) -> None:
    (tmp_path / "own.c").write_text(C % ACC + C.replace("acc", "last") % "g/l")
    (tmp_path / "own.txt").write_text(TEXT)
    paths = sorted(tmp_path.iterdir())
    assert grade_files(SCENE, paths, function="acc", jobs=1).all_right
    with pytest.raises(InputError, match=r"--function \(function=\) acc: no submission is code"):
        grade_files(SCENE, paths[1:], function="acc", jobs=1)


def test_a_value_that_changes_nothing_is_named() -> None:
    free = "theta'' = 3*g/(2*l)*sin(theta)"
    remarks = check(SCENE, free, values={"m": 3, "g": 10}, blame=False).remarks
    assert [words for words in remarks if "makes no difference" in words] == [
        "m = 3 makes no difference: no statement has m, and the verdicts are the same without it"
    ]
    number = TEXT.replace("m*l^2", "2*l^2")  # m is 2 here
    found = check(SCENE, number, values={"m": 2}, blame=False)
    assert found.ok and not any("no difference" in words for words in found.remarks)
