"""SymPy's own methods agree with the routes of the same name, wherever a table lets them run."""

import pytest
from serial_arms import serial_arm

import systems
from mechanics.checks.admissible import check_scene
from mechanics.crosscheck.by_sympy import METHODS, by_sympy
from mechanics.crosscheck.programs import derive_rows
from mechanics.crosscheck.sympy_table import LARGEST, counts, too_large
from mechanics.scene import Scene
from systems import pendulum_chain

SCENES = [system.name for system in (*systems.ALL, *systems.VARIANTS)]


def scene_of(name: str) -> Scene:
    every = (*systems.ALL, *systems.VARIANTS)
    return next(system.scene() for system in every if system.name == name)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_sympys_methods_give_the_same_motion(name: str) -> None:
    scene = scene_of(name)
    mechanism = check_scene(scene)
    assert too_large(mechanism) == ""
    found = by_sympy(scene, derive_rows(mechanism, [*METHODS]), {}, lambda words: None)
    assert {"kane_sympy", "lagrange_sympy"} == set(found.columns)
    assert {("kane", "kane_sympy"), ("lagrange", "lagrange_sympy")} <= set(found.pairs)
    assert all(finding.shown for finding in found.pairs.values())
    assert all(column.operations > 0 for column in found.columns.values())


@pytest.mark.parametrize(
    "scene", [pendulum_chain.scene(13), serial_arm(4).scene], ids=["links", "arm"]
)
def test_beyond_the_table_a_column_says_why(scene: Scene) -> None:
    mechanism = check_scene(scene)
    words = too_large(mechanism)
    assert any(f"{count} {name}" in words for name, count in counts(mechanism).items())
    found = by_sympy(scene, derive_rows(mechanism, ["kane"]), {}, lambda words: None)
    assert found.columns["kane_sympy"].absent == words and not found.pairs
    assert any(str(most) in words for most in LARGEST.values())
