"""What is told of loops, and conditions beside code whose arguments are vectors."""

from dataclasses import replace

import numpy as np
import pytest
from rod_statements import ROD
from sympy import cos

import mechanics
from mechanics.errors import InputError, SceneError
from mechanics.kernel import Verdict
from mechanics.scene import holonomic
from systems import four_bar
from systems.four_bar import d, l1, l2, l3, q1, q2, q3


def code(x, p, u):
    theta, theta_dot = x
    m, l, g = p
    return np.array([theta_dot, 3 * g / (2 * l) * abs(np.sin(theta)) + 3 * u / (m * l**2)])


def test_a_condition_stands_beside_code_whose_argument_is_a_vector() -> None:
    assert mechanics.check(ROD, code, where="sin(theta) > 0").ok
    assert mechanics.check(ROD, code, where="sin(theta) < 0").verdict is Verdict.REFUTED


def test_a_condition_on_a_vector_names_it() -> None:
    with pytest.raises(InputError, match=r"\(where=\) 'sin\(x\) > 0': x: the scene has no"):
        mechanics.check(ROD, code, where="sin(x) > 0")


def test_the_witness_of_a_loop_tells_all_that_places_it() -> None:
    found = mechanics.check(four_bar.scene(), "cos(q1)*q1'' = 0", blame=False)
    told = str(found)
    after = told.partition("\n    with ")[2]
    assert all(f"{name}=" in told for name in ("q1", "q2", "q3", "l1", "l2", "l3", "d"))
    assert all(f"{name}=" in after for name in ("q2_dot", "q3_dot", "q1_ddot"))
    assert "Dx=" not in after and "q2_ddot=" not in after


@pytest.mark.parametrize("forgotten", ["Ax", "Bx", "Cy"])
def test_what_a_forgotten_reaction_of_a_loop_leaves_free_is_named(forgotten: str) -> None:
    scene = four_bar.scene()
    kept = tuple(r for r in scene.reactions if r.name != forgotten)
    with pytest.raises(SceneError, match="nothing holds body crank in translation along"):
        mechanics.derive(replace(scene, reactions=kept))


def test_a_wrong_dimension_in_a_constraint_is_told_as_that() -> None:
    scene = four_bar.scene()
    closing = l1**2 * cos(q1) + l2 * cos(q2) + l3 * cos(q3) - d
    with pytest.raises(SceneError, match=r"constraint closure along x: .* adds m and m\^2"):
        replace(scene, constraints=(holonomic("closure along x", closing, "Dx"),
                                    scene.constraints[1]))  # fmt: skip
