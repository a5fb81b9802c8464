"""Which equations stand beside a person's: Lagrange's, in short, where a scene has them."""

import sympy
from sympy import Add

from mechanics.judge.check import derived
from mechanics.report.answer.follows import lines_of
from mechanics.symbolic.decide import prove_zero
from systems import elastic_pendulum, four_bar


def test_they_are_lagrange_s_and_vanish_along_the_motion() -> None:
    found = derived(elastic_pendulum.scene())
    route, lines = lines_of(found)
    assert route == "lagrange"
    accelerations = found.mass.LUsolve(found.forcing)
    motion = dict(zip(found.scene.ud, accelerations, strict=True))
    for line in lines:
        residual = (Add(line.left, -line.right)).xreplace(motion)
        assert prove_zero("row", residual).shown
    assert sympy.count_ops([line.right for line in lines]) < 20


def test_a_scene_with_constraints_shows_what_was_compared_with() -> None:
    found = derived(four_bar.scene())
    assert lines_of(found) == (found.route, found.result.lines)
