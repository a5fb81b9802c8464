"""`mechanics check` on C functions by name, black boxes, and a scene of the person's own."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from mechanics.cli.app import app
from mechanics.cli.isolation import answered
from mechanics.cli.load import run_file

C_FILE = """
#include <math.h>
double swing(double theta, double u, double m, double l, double g)
{
    return 3*g/(2*l)*sin(theta) + 3*u/(m*l*l);
}
double wrong(double theta, double u, double m, double l, double g)
{
    return 3*g/(5*l)*sin(theta) + 3*u/(m*l*l);
}
"""
SIMULATOR = """
import math

def rate(state, torque):
    theta, omega = (float(str(entry)) for entry in state)
    return [omega, 3 * 9.8 / (2 * 0.5) * math.sin(theta) + 3 * torque / (2 * 0.5**2)]

def step(state, torque):
    return [y + 0.01 * slope for y, slope in zip(state, rate(state, torque))]
"""
VALUES = ("--value", "m=2", "--value", "l=1/2", "--value", "g=9.8")
NAMES = ("--name", "state=theta theta_dot", "--name", "torque=u")
SCENE = """
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
from mechanics import Particle, Scene, gravity, parameters, reaction

theta, (m, L, g) = dynamicsymbols("theta"), parameters("m L g")

def scene():
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    tip = origin.locatenew("P", -L * rod.y)
    return Scene("mine", ground, origin, coordinates=(theta,), bodies=(Particle("bob", tip, m),),
                 loads=(gravity(-g * ground.y),),
                 reactions=(reaction("S", at=tip, on="bob", by=None, along=rod.y),))
"""


def run(*arguments: str, text: str | None = None):
    return CliRunner().invoke(app, ["check", *map(str, arguments)], input=text)


@pytest.fixture
def simulator(tmp_path: Path) -> str:
    file = tmp_path / "sim.py"
    file.write_text(SIMULATOR)
    return str(file)


SAID = """# {}
from math import sin

def helper(x):
    # {}
    return sin(x)

def f(theta, theta_dot, u, m, l, g):
    return 3*g/(2*l)*helper(theta) + 3*u/(m*l**2)
"""


@pytest.mark.parametrize(
    ("above", "inside", "code"),
    [("This is wrong.", "", 3), ("", "only valid for small angles", 3), ("of steel", "a sine", 0)],
)
def test_what_a_file_and_its_helpers_say_is_read(
    tmp_path: Path, above: str, inside: str, code: int
) -> None:
    file = tmp_path / "said.py"
    file.write_text(SAID.format(above, inside))
    found = run("rod_pendulum", f"{file}:f", "--no-blame")
    assert found.exit_code == code
    assert code or found.stdout.startswith("The formulas are PROVED. 2 sentences around them were")


def test_a_c_function_is_chosen_by_its_name(tmp_path: Path) -> None:
    file = tmp_path / "swing.c"
    file.write_text(C_FILE)
    right = run("rod_pendulum", file, "--function", "swing")
    assert (right.exit_code, right.stdout.startswith("PROVED")) == (0, True)
    assert run("rod_pendulum", file).exit_code == 1
    missing = run("rod_pendulum", file, "--function", "swings")
    assert "there is no function swings: there are swing, wrong" in str(missing.exception)


@pytest.mark.parametrize("call", ["rate", "step"])
def test_a_black_box_is_supported_and_no_more(simulator: str, call: str) -> None:
    stepping = ("--step", "0.01") if call == "step" else ()
    arguments = ("rod_pendulum", f"{simulator}:{call}", "--black-box", *VALUES, *NAMES, *stepping)
    found = run(*arguments, "--json", "-")
    assert found.exit_code == 3, found.output
    statements = json.loads(found.stdout)["statements"]
    assert [entry["verdict"] for entry in statements] == ["SUPPORTED", "SUPPORTED"]
    heavier = [a.replace("m=2", "m=3") for a in arguments]
    found = run(*heavier)
    assert found.exit_code == 1
    assert "REFUTED" in found.stdout


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--black-box", *NAMES), "what is g, l, m inside?"),
        (("--black-box", *NAMES, *VALUES, "--integrator", "leapfrog"), "integrator 'leapfrog'"),
        (("--black-box", *NAMES, *VALUES, "--value", "x=1"), "the scene has no parameter 'x'"),
        (("--black-box", *NAMES, "--value", "g"), "write name=value"),
        ((*NAMES, "--step", "0.1"), "--step belongs to a black box: add --black-box"),
        ((*NAMES, "--integrator", "rk4"), "--integrator belongs to a black box: add --black-box"),
        (
            ("--black-box", *NAMES, *VALUES, "--name", "zz=theta"),
            "--name zz=theta: no text has 'zz'",
        ),
    ],
)
def test_bad_options_of_a_black_box(simulator: str, options: tuple, words: str) -> None:
    found = run("rod_pendulum", f"{simulator}:rate", *options)
    assert words in str(found.exception)
    assert "\n" not in str(found.exception)


@pytest.mark.campaign
def test_a_scene_of_ones_own(tmp_path: Path) -> None:
    scene, file = tmp_path / "my_scene.py", tmp_path / "equations.tex"
    scene.write_text(SCENE)
    file.write_text(r"m L^2 \ddot\theta + m g L \sin\theta = 0 \tag{1}")
    found = run(scene, file)
    assert (found.exit_code, found.stdout.split()[:2]) == (0, ["PROVED", "(1)"])
    file.write_text(r"m L^2 \ddot\theta + m g \sin\theta = 0 \tag{1}")
    found = run(scene, file)
    assert found.exit_code == 1
    assert "REFUTED  (1)" in found.stdout


def test_a_value_of_a_parameter_stands_for_it(tmp_path: Path) -> None:
    file = tmp_path / "numbers.txt"
    file.write_text("x''*cos(theta)/2 + L/3*theta'' + 9.81*sin(theta)/2 = 0")
    found = run("elastic_pendulum", file, "--value", "g=9.81")
    assert found.exit_code == 0, found.output
    assert "judged where g = 9.81" in found.output
    assert run("elastic_pendulum", file, "--no-blame").exit_code == 3


def test_a_method_of_an_object_is_named_and_that_of_a_class_needs_one(tmp_path: Path) -> None:
    file = tmp_path / "cart.py"
    file.write_text(
        "class Cart:\n    def rates(self, theta_dot, F):\n        return 0.0, 0.0\n\n\n"
        "cart = Cart()\n"
    )
    refused = CliRunner().invoke(app, ["check", "cartpole", f"{file}:Cart.rates"])
    assert "name one of an object" in str(refused.exception)
    read = CliRunner().invoke(app, ["check", "cartpole", f"{file}:cart.rates"])
    assert read.exit_code == 1
    missing = CliRunner().invoke(app, ["check", "cartpole", f"{file}:Dog.rates"])
    assert "it has no Dog.rates" in str(missing.exception)


def test_a_file_that_changes_within_a_second_is_read_anew(tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    file = tmp_path / "mine.py"
    for value in (1, 2):
        file.write_text(f"x = {value}\n", encoding="utf-8")
        assert run_file(file).x == value
    assert [*tmp_path.iterdir()] == [file]


def raised(error: BaseException) -> int:
    raise error


ENDS = {
    "os._exit": lambda: os._exit(0),
    "thread": lambda: [threading.Thread(target=os._exit, args=(0,)).start(), time.sleep(9)],
    "signal": lambda: os.kill(os.getpid(), signal.SIGKILL),
    "exit": lambda: raised(SystemExit(0)),
    "no Exception": lambda: raised(GeneratorExit()),
}


@pytest.mark.parametrize("how", ENDS)
def test_a_command_that_sends_no_exit_code_has_none(how: str) -> None:
    assert answered(ENDS[how]) is None


@pytest.mark.parametrize("code", [0, 1, 3])
def test_a_command_has_the_exit_code_that_it_sends(code: int) -> None:
    assert answered(lambda: code) == code


def test_code_that_ends_its_process_is_not_judged(tmp_path: Path) -> None:
    path = tmp_path / "ends.py"
    path.write_text("import os\nos._exit(0)\n")
    command = [sys.executable, "-m", "mechanics", "check", "rod_pendulum", f"{path}:f"]
    found = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (found.returncode, found.stdout) == (2, "")
    assert "not judged" in found.stderr
