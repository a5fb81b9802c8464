"""`derive`, `simulate`, `codegen`, `linearize`, `modes`, `--help`: what they write is usable."""

import csv
import json
import re
import shlex
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest
from sympy import Matrix

import systems
from mechanics.cli.app import COMMANDS
from mechanics.cli.app import command as imported
from mechanics.cli.lines import fitted
from mechanics.crosscheck import ROUTES, derive
from mechanics.symbolic import is_zero

LISTED = {name: line for commands in COMMANDS.values() for name, line in commands.items()}


def test_equations_fit_a_terminal_and_are_read_again(run: Any, tmp_path: Path) -> None:
    """A line that is too long goes on below, from an operator on."""
    lines = run("derive", "rocker").out.splitlines()
    assert max(map(len, lines)) <= 80
    equation = [line for line in lines[1:] if not line.startswith("  rocker:")]
    assert equation[1].startswith("    + ")
    path = tmp_path / "rocker.txt"
    path.write_text("\n".join(equation), encoding="utf-8")
    checked = run("check", "rocker", str(path))
    assert (checked.code, checked.out.split()[0]) == (0, "PROVED")


def test_a_long_line_is_broken_where_the_fewest_brackets_are_open() -> None:
    text = "a*(b + c*(d - e)) + f = g"
    assert fitted(text, 24) == "a*(b + c*(d - e)) + f\n    = g"
    assert fitted(text, 20) == "a*(b + c*(d - e))\n    + f = g"
    assert fitted(text, 15) == "a*(b\n    + c*(d\n    - e)) + f\n    = g"
    assert fitted("no_operator_is_near_enough", 5) == "no_operator_is_near_enough"


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", systems.ALL, ids=lambda system: system.name)
@pytest.mark.parametrize("route", [route.name for route in ROUTES])
def test_derived_python_builds_the_same_matrices(run: Any, system: Any, route: str) -> None:
    ran = run("derive", system.name, "--route", route, "--format", "python")
    assert ran.code == 0, ran.err
    names: dict[str, Any] = {}
    exec(ran.out, names)
    equations = derive(system.scene(), route)
    back = {symbol.name: symbol for symbol in (*equations.scene.q, *equations.scene.u,
            *equations.scene.input_symbols, *equations.scene.parameters)}  # fmt: skip
    for name, wanted in (
        ("matrix_M", equations.mass),
        ("matrix_f", equations.forcing),
        ("matrix_B", equations.reaction_matrix),
        ("matrix_A", equations.constraint_matrix),
        ("matrix_b", equations.constraint_bias),
    ):
        built: Matrix = names[name]
        assert built.shape == wanted.shape
        same = {s: back[s.name] for s in built.free_symbols if s.name in back}
        difference = built.xreplace(same) - wanted
        assert all(entry == 0 or is_zero(entry) for entry in difference), name
    assert [s.name for s in names["coordinates"]] == [s.name for s in equations.scene.q]
    assert [s.name for s in names["multipliers"]] == [s.name for s in equations.multipliers]


def test_names_that_python_or_sympy_know_are_replaced(run: Any, pendulum: Any) -> None:
    renamed = pendulum(
        ('"theta"', '"lambda"'), ('"m l g"', '"S sin def"'), ('reaction("S"', 'reaction("Matrix"')
    )
    ran = run("derive", renamed, "--format", "python", "--route", "lagrange")
    assert ran.code == 0, ran.err
    names: dict[str, Any] = {}
    exec(ran.out, names)
    assert [s.name for s in names["coordinates"]] == ["lambda"]
    assert sorted(s.name for s in names["parameters"]) == ["S", "def", "sin"]
    length, mass = (s for s in names["parameters"] if s.name != "def")
    length, mass = (length, mass) if length.name == "sin" else (mass, length)
    assert is_zero(names["matrix_M"][0] - mass * length**2)


@pytest.mark.parametrize("form", ["text", "latex"])
def test_derived_text_and_latex(run: Any, form: str) -> None:
    ran = run("derive", "four_bar", "--format", form, "--route", "moving_point")
    assert ran.code == 0
    assert ("align" in ran.out) == (form == "latex")
    assert "q" in ran.out


@pytest.mark.campaign
def test_simulate_writes_the_samples(run: Any, tmp_path: Path) -> None:
    table, plot = tmp_path / "motion.csv", tmp_path / "motion.svg"
    settings = ("--duration", 1, "--set", "theta=1/2", "--samples", 11)
    ran = run("simulate", "elastic_pendulum", *settings, "--out", table, "--plot", plot)
    assert ran.code == 0, ran.err
    with table.open(newline="") as file:
        rows = [row for row in csv.reader(file) if not row[0].startswith("#")]
    head, samples = rows[0], rows[1:]
    assert len(samples) == 11
    column = next(i for i, name in enumerate(head) if name.split()[0] == "theta")
    assert float(samples[0][column]) == 0.5
    assert float(samples[-1][0]) == 1.0
    assert "<svg" in plot.read_text(encoding="utf-8")


def test_simulate_writes_reactions_where_the_route_gives_them(run: Any, tmp_path: Path) -> None:
    table = tmp_path / "motion.csv"
    command = ("simulate", "elastic_pendulum", "--duration", 1, "--reactions", "--out", table)
    ran = run(*command)
    assert ran.code == 0, ran.err
    assert table.read_text(encoding="utf-8").splitlines()[0].endswith("total_energy,T,N,N1")
    ran = run(*command, "--route", "kane")
    assert ran.code == 2 and "take free_body" in ran.err and ran.err.count("\n") == 1


@pytest.mark.campaign
def test_codegen_writes_a_folder(run: Any, tmp_path: Path) -> None:
    ran = run("codegen", "two_mass_chain", "-o", tmp_path / "c")
    assert ran.code == 0, ran.err
    written = [Path(line) for line in ran.out.splitlines()]
    assert all(path.is_file() for path in written)
    assert {path.suffix for path in written} >= {".c", ".h", ".json"}


def test_linearize_and_modes(run: Any) -> None:
    ran = run("modes", "two_mass_chain")
    assert ran.code == 0
    assert "omega_1^2 = k/(6*m)" in ran.out
    ran = run("linearize", "rocker")
    assert ran.code == 0
    assert "K = " in ran.out


@pytest.mark.campaign
def test_linearize_and_modes_about_a_steady_motion(run: Any) -> None:
    ran = run("linearize", "rolling_disc", "--speeds", "u2=v/R")
    assert ran.code == 0
    assert "about the steady motion u2 = v/R, u4 = v\nignorable coordinates: yaw, spin" in ran.out
    ran = run("modes", "rolling_disc", "--speeds", "u2=5")
    assert ran.code == 0
    assert ran.out.count("s = 0, a neighbouring steady motion") == 2
    assert "frequency 6.65612 rad/s" in ran.out


@pytest.mark.campaign
def test_modes_over_a_speed_are_a_table_a_plot_and_json(run: Any, tmp_path: Path) -> None:
    over = ("--over", "u2", "--from", 0, "--to", 8, "--points", 17)
    ran = run("modes", "rolling_disc", *over, "--plot", tmp_path / "a.svg")
    assert ran.code == 0
    # Critical: v^2 = g R / 3, R = 1/2 m.
    critical = (9.81 * 0.5 / 3) ** 0.5 / 0.5
    place = ran.out.rpartition("stability changes at u2 = ")[2]
    assert abs(float(place) / critical - 1) < 1e-8
    assert "</svg>" in (tmp_path / "a.svg").read_text(encoding="utf-8")
    record = json.loads(run("modes", "rolling_disc", *over, "--json", "-").out)
    assert record["states"] == ["lean", "lean_dot", "yaw_dot", "spin_dot"]
    assert len(record["values"]) == len(record["poles"]) == len(record["unstable"]) == 17
    assert record["unstable"][0] and not record["unstable"][-1]
    (border,) = record["borders"]
    assert abs(border / critical - 1) < 1e-8
    fastest = max(imaginary for _, imaginary in record["poles"][-1])
    assert abs(fastest**2 - 12 / 5 * (64 - 9.81 / 1.5)) < 1e-9


@pytest.mark.campaign
def test_linearize_gives_a_bicycle_in_its_speed(run: Any, tmp_path: Path) -> None:
    file = tmp_path / "bicycle.py"
    file.write_text("from whipple_bicycle import whipple_bicycle as scene\n", encoding="utf-8")
    ran = run("linearize", file, "--speeds", "tR_dot=-v/rR")
    assert ran.code == 0
    assert "M x'' + v C1 x' + (g K0 + v^2 K2) x = 0, x = deviations of lean, steer" in ran.out
    # Meijaard and others 2007, equations (6.1) to (6.5).
    assert "M = [[80.81722, 2.31941332208709], [2.31941332208709, 0.297841881996856]]" in ran.out
    assert "K2 = [[0, 76.5973458957322], [0, 2.65431523794604]]" in ran.out


def test_damped_modes_have_frequencies_ratios_and_shapes(run: Any, pendulum: Any) -> None:
    friction = ("parameters, reaction", "parameters, reaction, damper")
    ran = run("modes", pendulum(friction, ("*LOADS", "damper('c', O, C, l / 10, along=N.x)")))
    assert ran.code == 0
    assert "damping ratio" in " ".join(ran.out.split()) and "rad/s" in ran.out
    assert "shape (1)" in " ".join(ran.out.split())


@pytest.mark.parametrize("name", ["double_pendulum", "elastic_pendulum"])
def test_small_motions_fit_a_terminal(run: Any, name: str) -> None:
    """Matrices, which are there to be copied, stay on one line."""
    lines = [line for c in ("modes", "linearize") for line in run(c, name).out.splitlines()]
    assert max(len(line) for line in lines if "= [[" not in line) <= 80


@pytest.mark.parametrize("command", LISTED)
def test_help_starts_with_what_it_is_for_and_two_examples(
    run: Any, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    ran = run(command, "--help")
    assert ran.code == 0
    assert max(map(len, ran.out.splitlines())) <= 80
    usage, purpose, *examples = re.split(r"\n\s*\n", ran.out.strip())
    assert usage.split()[:3] == ["Usage:", "mechanics", command]
    assert " ".join(purpose.split()) == LISTED[command]
    told = [" ".join(example.split()) for example in examples[:2]]
    assert all(f"{example} ".startswith(f"mechanics {command} ") for example in told)
    assert told[0] != told[1]
    for example in told:
        words = re.split(r" [|] | && ", example)[0]
        assert imported(command).make_context(command, shlex.split(words)[2:])


@pytest.mark.campaign
def test_the_console_command_in_a_process_of_its_own() -> None:
    code = "from mechanics.cli import main; main()"
    ran = subprocess.run(
        [sys.executable, "-c", code, "modes", "nothing"], capture_output=True, text=True
    )
    assert ran.returncode == 2
    assert ran.stdout == ""
    told, command, carets = ran.stderr.splitlines()
    assert told.startswith("error: system 'nothing' is not known")
    assert command[carets.index("^") : carets.rindex("^") + 1] == "nothing"


def test_the_list_of_commands_says_what_each_says_of_itself() -> None:
    for name, line in LISTED.items():
        assert imported(name).help.partition("\n")[0] == line


def test_help_imports_no_mathematics() -> None:
    code = (
        "import sys, atexit; from mechanics.cli import main;"
        "atexit.register(lambda: print(*sys.modules)); main()"
    )
    ran = subprocess.run([sys.executable, "-c", code, "--help"], capture_output=True, text=True)
    assert ran.returncode == 0
    assert not {"sympy", "numpy", "casadi", "scipy"} & set(ran.stdout.split())


def test_the_version_is_that_of_the_package(run: Any) -> None:
    ran = run("--version")
    assert ran.code == 0 and ran.err == ""
    assert ran.out == f"mechanics {version('mechanics')}\n"


@pytest.mark.parametrize("route", ["moving_point", "kane"])
def test_all_routes_print_the_rocker_with_one_sign(run: Any, route: str) -> None:
    rows = [
        run("derive", "rocker", "--route", name).out.replace("\n    ", " ").splitlines()[-1]
        for name in ("free_body", route)
    ]
    assert rows[0].startswith("theta_ddot*(I_C + M*R**2*(cos(theta) + 5/4)) = ")
    assert rows[0] == rows[1]
