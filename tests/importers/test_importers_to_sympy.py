"""A law over systems: SymPy's equations of what a scene is written as are the scene's.

And what comes back from there has SymPy's equations, too.
"""

from dataclasses import replace

import pytest

from mechanics import from_sympy, to_sympy
from mechanics.checks.admissible import check_scene
from mechanics.crosscheck.own_equations import compare_own
from mechanics.crosscheck.sympy_table import too_large
from mechanics.errors import InputError
from mechanics.scene.actions import frictions
from systems import EVERY


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", EVERY, ids=lambda system: system.name)
def test_systems_go_out_and_come_back(system):
    scene = system.scene()
    if held := frictions(scene):
        with pytest.raises(InputError, match=f"load {held[0].name} is friction"):
            to_sympy(scene)
        scene = replace(scene, loads=tuple(load for load in scene.loads if load not in held))
    if too_large(check_scene(scene), "kane_sympy"):
        pytest.skip("SymPy would not finish it")
    model = to_sympy(scene)
    (found,) = compare_own(scene, model)
    assert found.shown
    if not scene.rotations:
        (again,) = compare_own(from_sympy(model), model)
        assert again.shown
