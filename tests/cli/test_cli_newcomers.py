"""What newcomers meet first: the list of systems, `python -m mechanics`, units, routes."""

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mechanics
from mechanics.linear.damped import DampedModes
from systems import rod_pendulum


@pytest.mark.campaign
def test_the_systems_that_an_error_names_are_those_that_are_listed(run: Any) -> None:
    listed = run("systems").out
    error = run("derive", "nothing").err
    named = re.search(r"the systems are ([\w, ]+)", error)[1].split(", ")
    rows = re.findall(r"^  (\w+)", listed, re.MULTILINE)
    assert named == rows


@pytest.mark.campaign
def test_the_package_runs_as_a_module() -> None:
    ran = subprocess.run(
        [sys.executable, "-m", "mechanics", "derive", "nothing"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ran.returncode == 2
    assert ran.stderr.startswith("error: system 'nothing' is not known")


def test_parameters_without_a_unit_are_named(run: Any, pendulum: Any) -> None:
    ran = run("crosscheck", pendulum(), "--states", "0")
    assert "No unit is declared for g, l, m" in " ".join(ran.out.split())


def test_derive_names_them_beside_the_equations(run: Any, pendulum: Any) -> None:
    ran = run("derive", pendulum())
    assert "No unit is declared for g, l, m" in ran.err and "No unit" not in ran.out


def test_without_a_compiler_simulate_and_codegen_say_so(
    run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    ran = run("simulate", "rod_pendulum", "--duration", "0.1", "--out", tmp_path / "motion.csv")
    assert ran.code == 0 and "no C compiler" in ran.out
    ran = run("codegen", "rod_pendulum", "-o", tmp_path / "c", "--outputs", "energy")
    assert ran.code == 0 and "no C compiler was found" in ran.err


def test_an_ensemble_to_a_folder_without_a_compiler_says_what_to_install(
    run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    many = ("--vary", "theta=0:1:3", "--duration", "0.125", "--out", tmp_path / "many")
    ran = run("ensemble", "rod_pendulum", *many)
    assert ran.code == 2 and ran.err.count("\n") == 1
    assert "install gcc or clang" in ran.err and "executor out" not in ran.err


@pytest.mark.parametrize("route", mechanics.ROUTES, ids=lambda route: route.name)
def test_derive_takes_a_route_or_its_name(route: Any) -> None:
    scene = rod_pendulum.scene()
    one, other = mechanics.derive(scene, route), mechanics.derive(scene, route.name)
    assert one.route == other.route == route.name
    assert one.mass == other.mass


def test_zero_has_no_sign() -> None:
    poles = np.array([complex(-0.0, 2.0), complex(-0.0, 0.0)])
    shapes = np.array([[complex(1, 0), complex(-0.0, 0)], [complex(-0.0, -0.0), complex(1, 0)]])
    told = " ".join(DampedModes(poles, shapes).words)
    assert "-0" not in told
    assert "damping ratio 0," in told


def test_what_is_no_equilibrium_names_force_coordinate_and_units(run: Any) -> None:
    ran = run("linearize", "cartpole", "--at", "theta=1")
    assert ran.code == 2
    assert "theta = 1 rad" in ran.err
    assert "the torque on theta at rest is g*l*mp*sin(1) N m, not zero" in ran.err
