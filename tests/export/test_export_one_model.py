"""What is cross-checked is what is exported and simulated: one model, whoever asks for it."""

import functools
import zipfile
from pathlib import Path

import pytest
from serial_arms import serial_arm

from mechanics import compile, crosscheck, derive
from mechanics.crosscheck import CrossCheck
from mechanics.crosscheck.fmu import write_fmu
from mechanics.equations import Equations
from mechanics.export import write_c as write_and_prove
from mechanics.export.evidence.verify import Outcome, verify
from systems import SEED

pytestmark = pytest.mark.campaign

# What is shown about both is tested elsewhere.
write_c = functools.partial(write_and_prove, prove=False, batch=False)
SYSTEMS = {system.name: system for system in SEED}


@functools.cache
def checked(name: str) -> Equations:
    """The equations of one route, after all that a cross-check reads of them."""
    result = crosscheck(SYSTEMS[name], CrossCheck(("free_body", "kane"), 100))
    assert all(finding.shown for finding in result.pairs.values())
    return result.routes["free_body"].equations


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_folder_holds_what_was_checked(name: str, tmp_path: Path) -> None:
    write_c(compile(checked(name)), tmp_path / "checked")
    write_c(compile(derive(SYSTEMS[name].scene(), "free_body")), tmp_path / "new")
    assert contents(tmp_path / "checked") == contents(tmp_path / "new")


def test_an_arm_in_space_is_exported_as_it_was_checked(tmp_path: Path) -> None:
    """With a fixed quarter turn between its joints: its model was another one after a check."""
    equations, few = derive(serial_arm(2, fixed="x").scene, "free_body"), ["forward_dynamics"]
    write_c(compile(equations, outputs=few), tmp_path / "before", functions=few)
    assert equations.system
    write_c(compile(equations, outputs=few), tmp_path / "after", functions=few)
    assert contents(tmp_path / "before") == contents(tmp_path / "after")
    found = verify(tmp_path / "after", derive(serial_arm(2, fixed="x").scene), measure=False)
    assert found.outcome is Outcome.SHOWN


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_unit_holds_what_was_checked(name: str, tmp_path: Path) -> None:
    found = []
    for equations in (checked(name), derive(SYSTEMS[name].scene(), "free_body")):
        path = write_fmu(
            compile(equations, compiler=None), tmp_path / "a.fmu", step=0.01, prove=False
        )
        with zipfile.ZipFile(path) as archive:
            found.append({file: archive.read(file) for file in archive.namelist()})
    assert "sources/model.c" in found[0] and found[0] == found[1]


def test_a_simulation_integrates_the_graphs_of_the_model() -> None:
    model = compile(checked("rocker"), compiler=None)
    assert model.right_hand_side.graphs is model.casadi
    # Where the model was not asked for what a motion needs, it is made in the model's own form.
    less = compile(checked("rocker"), compiler=None, outputs=["energy"])
    graphs = less.right_hand_side.graphs
    left, right = (str(g["forward_dynamics"]) for g in (graphs, model.casadi))
    assert left == right
