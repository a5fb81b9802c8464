"""Bad input: exit code 2, one line on stderr that names what is wrong, and where it is."""

from pathlib import Path
from typing import Any

import pytest

ONE = "two_mass_chain"
ROWS = [
    ("crosscheck nothing", "system 'nothing' is not known elastic_pendulum"),
    ("crosscheck rocker(2)", "rocker has no size"),
    ("crosscheck pendulum_chain(0)", "0 links one or more"),
    ("crosscheck {tmp}/missing.py", "missing.py no such file"),
    ("crosscheck {tmp}", "is not known"),
    (f"crosscheck {ONE} --routes bogus", "route 'bogus' free_body, moving_point, kane, lagrange"),
    (f"crosscheck {ONE} --routes kane,bogus", "route 'bogus'"),
    (f"crosscheck {ONE} --states -1", "--states"),
    (f"crosscheck {ONE} --states many", "--states integer"),
    (f"crosscheck {ONE} --report {{tmp}}", "it is a folder"),
    (f"crosscheck {ONE} --json {{tmp}}", "it is a folder"),
    (f"crosscheck {ONE} --report {{tmp}}/no/report.html", "there is no folder make it first"),
    (f"crosscheck {ONE} --json {{tmp}}/no/result.json", "there is no folder make it first"),
    (f"crosscheck {ONE} --bogus", "--bogus"),
    ("derive", "SYSTEM"),
    (f"derive {ONE} --route bogus", "route 'bogus' kane"),
    (f"derive {ONE} --format bogus", "--format 'text', 'latex', 'python'"),
    (f"ensemble {ONE} --out {{tmp}}/e", "--vary"),
    (f"ensemble {ONE} --vary x1=0:1:5", "--out"),
    (f"ensemble {ONE} --vary x1=0:1 --out {{tmp}}/e", "--vary 'x1=0:1' name=from:to:count"),
    (f"ensemble {ONE} --vary x1=0:1:1 --out {{tmp}}/e", "vary x1 at least 2"),
    (f"ensemble {ONE} --vary x1=0:1:-5 --out {{tmp}}/e", "--vary name=from:to:count"),
    (f"ensemble {ONE} --vary x1=a:1:5 --out {{tmp}}/e", "--vary 'a' no number"),
    (f"ensemble {ONE} --vary x1=0:1e400:5 --out {{tmp}}/e", "vary x1 two finite numbers"),
    (f"ensemble {ONE} --vary x1=0:1:9999999999999 --out {{tmp}}/e", "at most 1e+12 motions"),
    (f"ensemble {ONE} --vary z=0:1:5 --out {{tmp}}/e", "no 'z' to set x1, x1_dot"),
    (f"ensemble {ONE} --vary x1=0:1:5 --vary x1=0:1:5 --out {{tmp}}/e", "x1 is given twice"),
    (f"ensemble {ONE} --vary x1=0:1:5 --set x1=1 --out {{tmp}}/e", "x1 is varied and has a value"),
    (f"ensemble {ONE} --vary x1=0:1:5 --out {{tmp}}/no/e", "there is no folder make it first"),
    (f"ensemble {ONE} --vary x1=0:1:5 --out {{tmp}}/e --threads 2 --processes 2", "give one of"),
    (f"ensemble {ONE} --vary x1=0:1:5 --out {{tmp}}/e --method rk4", "fixed steps: give step"),
    (f"simulate {ONE}", "--out"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --duration -1", "duration -1.0 positive"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --duration nan", "duration nan positive"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --duration inf", "duration inf"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --duration 0", "duration 0.0 positive"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --samples 1", "--samples"),
    (f"simulate {ONE} --out {{tmp}}/a.txt", ".txt use .csv or .parquet"),
    (f"simulate {ONE} --out {{tmp}}/no/a.csv", "there is no folder make it first"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --plot {{tmp}}/a.png", ".png use .svg"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --set m", "--set 'm' name=value"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --set m=heavy", "--set 'heavy' no number"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --set m=1/0", "--set '1/0' no number"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --set m=-1", "parameter m -1 negative"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --set m=1 --set m=2", "m is given twice"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --set z=1", "no 'z' to set x1, x1_dot"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --set x1=1e400", "--set x1 1.8e308"),
    (f"simulate {ONE} --out {{tmp}}/a.csv --set x1=1e99999999", "--set x1 1.8e308"),
    ("linearize rocker --at theta=1e99999999", "--at theta 1.8e308"),
    ("linearize rocker --at theta=1e99999999*pi", "--at theta 1.8e308"),
    ("codegen rocker --out=", "the name of what to write is empty"),
    ("fmu rocker --out=", "the name of what to write is empty"),
    ("codegen rocker --out {tmp}/c --fix g=1e99999999", "--fix g 1.8e308"),
    ("linearize rocker --at zz=2", "no coordinate or input 'zz' theta, f"),
    ("modes rocker --at theta=2", "theta = 2 no equilibrium"),
    ("linearize rocker --at theta=pi/0", "--at 'pi/0' no number pi/2"),
    ("linearize rocker --at theta=pie", "--at 'pie' no number"),
    ("linearize rolling_disc --speeds u9=2", "'u9' no speed u1, u2"),
    ("linearize rolling_disc --speeds u2=v/0", "--speeds 'u2=v/0' '0' no number"),
    ("linearize rolling_disc --speeds u2=2 --at lean=1", "lean = 1 u2 = 2 no steady motion"),
    ("modes rolling_disc --over u2", "--over u2 range --from 0 --to 10"),
    ("modes rolling_disc --over u2 --from 5 --to 1", "--over u2 range"),
    ("modes rolling_disc --over zz --from 0 --to 1", "depend on 'zz' R, g, m --speeds u1=zz"),
    ("modes rolling_disc --plot {tmp}/a.svg", "--plot --over NAME"),
    ("modes rolling_disc --over u2 --from 0 --to 1 --plot {tmp}/a.png", ".png use .svg"),
    ("bogus", "'bogus'"),
]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("command", "words"), ROWS, ids=[command for command, _ in ROWS])
def test_bad_input_is_one_line(run: Any, tmp_path: Path, command: str, words: str) -> None:
    ran = run(*(part.format(tmp=tmp_path) for part in command.split()))
    assert ran.code == 2
    assert ran.out == ""
    assert ran.err.startswith("error: ")
    assert ran.err.count("\n") == 1, ran.err
    for word in words.split():
        assert word in ran.err, ran.err


FILES = [
    ("def scene(:", "no Python file invalid syntax line 1"),
    ("\x00", "no Python file"),
    ("import nothing_of_that_name", "line 1 ModuleNotFoundError"),
    ("1 / 0", "line 1 ZeroDivisionError"),
    ("import sys\nsys.exit(0)", "line 2 SystemExit"),
    ("scene = 3", "no function scene()"),
    ("", "no function scene()"),
    ("def scene():\n    pass", "returned a NoneType return a Scene"),
    ("def scene():\n    return 3", "returned an int return a Scene"),
    ("def scene():\n    raise KeyError('mass')", "line 2 KeyError 'mass'"),
    ("def scene():\n    assert False, 'no\\nway'", "line 2 AssertionError no way"),
    ("def scene():\n    return m", "line 2 NameError 'm'"),
    ("def scene(n):\n    return n", "TypeError missing 'n'"),
    ("def scene():\n    return 1\nPUBLISHED = 3", "PUBLISHED tuple published(...)"),
    ("def scene():\n    return 1\nPUBLISHED = (3,)", "PUBLISHED tuple published(...)"),
    (
        "from mechanics.scene import gravity\ndef scene():\n    return gravity(3)",
        "gravity 3 vector",
    ),
]


@pytest.mark.parametrize(("text", "words"), FILES, ids=[text[:40] or "empty" for text, _ in FILES])
def test_a_file_that_is_no_system_is_one_line(
    run: Any, tmp_path: Path, text: str, words: str
) -> None:
    path = tmp_path / "mine.py"
    path.write_text(text, encoding="utf-8")
    ran = run("crosscheck", path)
    assert ran.code == 2
    assert ran.out == ""
    assert ran.err.count("\n") == 1, ran.err
    for word in words.split():
        assert word in ran.err, ran.err


def test_a_scene_that_cannot_be_right_is_one_line(run: Any, pendulum: Any) -> None:
    ran = run("crosscheck", pendulum(("reactions=(", "reactions=() and (")))
    assert ran.code == 2
    assert ran.err.count("\n") == 1
    assert "reactions are incomplete" in ran.err


def test_angles_may_be_multiples_of_pi(run: Any) -> None:
    ran = run("linearize", "elastic_pendulum", "--at", "theta=pi")
    assert ran.code == 0
    # Upright: gravity turns the pendulum away.
    assert "K = [[2*k, 0], [0, -L*M*g/2]]" in ran.out
    assert run("linearize", "elastic_pendulum", "--at", "theta=3.14159").code == 2


def test_a_defect_of_the_program_has_an_exit_code_of_its_own(
    run: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("mechanics.cli.small_motions.about", None)
    ran = run("linearize", "elastic_pendulum")
    assert ran.code == 70
    assert "TypeError" in ran.err
