"""SymPy's methods run on SymPy's kinematics, so that they notice an error of ours."""

from collections.abc import Callable

import pytest

from mechanics.crosscheck.by_sympy import METHODS, by_sympy
from mechanics.crosscheck.programs import derive_rows
from mechanics.kernel import Verdict
from mechanics.kinematics import chain, motion
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.program.vectors import product, transpose
from systems import elastic_pendulum


def composed_backwards(build, frame, table, right=chain._relative):
    """Angular velocities of the steps, with the wrong sign: an error of Kane's route alone."""
    return tuple(tuple(-entry for entry in vector) for vector in right(build, frame, table))


def turned_backwards(outer, step):
    """Rotations of the steps, transposed: an error of all routes."""
    return product(outer, transpose(step))


@pytest.mark.parametrize(
    ("module", "name", "wrong", "differ"),
    [
        (chain, "_relative", composed_backwards, {"kane"}),
        (motion, "product", turned_backwards, {"kane", "lagrange"}),
    ],
)
def test_wrong_kinematics_of_ours_do_not_reach_sympys_methods(
    monkeypatch: pytest.MonkeyPatch, module: object, name: str, wrong: Callable, differ: set[str]
) -> None:
    right = [derive(elastic_pendulum.scene()).matrices for _, derive in METHODS.values()]
    monkeypatch.setattr(module, name, wrong)
    scene = elastic_pendulum.scene()
    assert [derive(scene).matrices for _, derive in METHODS.values()] == right
    programs = derive_rows(lower(scene, Builder()), [*METHODS])
    found = by_sympy(scene, programs, {}, lambda words: None).pairs
    refuted = {pair for pair, finding in found.items() if finding.verdict is Verdict.REFUTED}
    assert refuted == {(route, f"{route}_sympy") for route in differ}
