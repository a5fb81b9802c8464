"""`mechanics check`: what it prints, its JSON and its exit codes."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from mechanics.cli.app import app

SEVEN = (
    r"M \frac{L}{2} \ddot{x} \cos \theta+M \frac{L^{2}}{3} \ddot{\theta}"
    r"+M g \frac{L}{2} \sin \theta=0 \tag{7}"
)


def run(*arguments: str, text: str | None = None):
    return CliRunner().invoke(app, ["check", *arguments], input=text)


def test_right_equations_exit_with_zero(tmp_path: Path) -> None:
    file = tmp_path / "seven.tex"
    file.write_text(SEVEN)
    result = run("elastic_pendulum", str(file))
    assert result.exit_code == 0
    assert result.stdout.startswith("PROVED  (7)")


def test_wrong_equations_exit_with_one_and_show_a_state(tmp_path: Path) -> None:
    file = tmp_path / "seven.tex"
    file.write_text(SEVEN.replace("{3}", "{12}"))
    result = run("elastic_pendulum", str(file))
    assert result.exit_code == 1
    assert "REFUTED  (7)" in result.stdout
    assert "the state: L=" in result.stdout
    assert "write 3 for 12: the factor is wrong" in result.stdout


@pytest.mark.campaign
def test_json_has_everything(tmp_path: Path) -> None:
    file = tmp_path / "seven.tex"
    file.write_text(SEVEN.replace(r"\theta", r"\phi").replace("{3}", "{4}"))
    result = run("elastic_pendulum", str(file), "--name", "phi=theta", "--json", "-")
    assert result.exit_code == 1
    found = json.loads(result.stdout)
    assert (found["verdict"], found["ok"]) == ("REFUTED", False)
    (statement,) = found["statements"]
    assert statement["tag"] == "(7)"
    assert statement["about"] == "EquationOfMotion"
    assert statement["witness"]["left"] != statement["witness"]["right"]
    assert statement["right_if"] == ["every rod is a point mass at its mass centre"]
    assert found["names"]["phi"] == {"meaning": "theta", "why": "as given"}
    declared = run(
        "elastic_pendulum", str(file), "--name", "phi=theta", "--convention", "point mass"
    )
    assert declared.exit_code == 0


def test_a_function_of_a_python_file(tmp_path: Path) -> None:
    file = tmp_path / "mine.py"
    file.write_text("def a(y, M, m, k):\n    return [-2 * k * y[0] / (M + m), 0 * m]\n")
    result = run("elastic_pendulum", f"{file}:a", "--name", "y=x theta x_dot theta_dot")
    assert result.exit_code == 1
    assert "REFUTED  x_ddot  a: x_ddot" in result.stdout
    assert "name the function to check" in str(run("elastic_pendulum", str(file)).exception)
    assert "it has no b" in str(run("elastic_pendulum", f"{file}:b").exception)


def test_doubt_exits_with_three() -> None:
    result = run("elastic_pendulum", "-", text="x = unknown_thing*k")
    assert result.exit_code == 3
    assert "unknown_thing: the scene has no such name" in " ".join(result.stdout.split())


def test_what_is_chosen_alone_has_the_exit_code() -> None:
    text = "F_s = -k*x\n(M + m)*x'' + 2*k*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta)) = 0"
    assert run("elastic_pendulum", "-", text=text).exit_code == 3
    result = run("elastic_pendulum", "-", "--only", "line 2", text=text)
    assert result.exit_code == 0
    assert "not judged, as you asked: 'line 1: F_s = -k*x'" in result.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("elastic_pendulum", "no_such_file.tex"), "file no_such_file.tex: it cannot be read"),
        (("elastic_pendulum", "-", "--name", "phi"), "write mine=the scene's"),
        (("elastic_pendulum", "-", "--name", "phi=psi"), "has no 'psi': its names are"),
        (("elastic_pendulum", "-", "--name", "zz=theta"), "no text has 'zz': it has"),
        (("elastic_pendulum", "-", "--about", "love"), "the quantities are equation of motion"),
        (("elastic_pendulum", "-", "--notation", "word"), "the notations are latex, text"),
        (("elastic_pendulum", "-", "--convention", "x"), "the conventions are other vertical"),
        (("elastic_pendulum", "-", "--only", "line 7"), "left side; there are 1 in line 1"),
    ],
)
def test_bad_input_is_an_input_error(arguments: tuple[str, ...], words: str) -> None:
    result = run(*arguments, text="x = k")
    assert words in str(result.exception)
