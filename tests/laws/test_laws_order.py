"""No result depends on what was asked before: the same questions forwards and backwards."""

from collections.abc import Sequence

import pytest
from sympy import Add, Eq, Expr, expand

import mechanics
from mechanics.blame.derivation import Derivation
from mechanics.compiled import compile
from mechanics.equations import Equations
from mechanics.judge.check import derived
from systems import elastic_pendulum, rod_pendulum

SYSTEMS = [elastic_pendulum, rod_pendulum]


def statements(truth: Equations) -> list[tuple[Expr, str | None]]:
    """A right row, rows with a wrong sign, energies and mass matrices, with what they are."""
    pieces = Derivation(truth)
    rows = [expand(truth.scene.plain(row.value)) for row in pieces.generalized_rows]
    wrong = [row - 2 * Add.make_args(row)[0] for row in rows]
    motion = [(Eq(row, 0, evaluate=False), None) for row in (rows[0], *wrong)]
    kinematics = truth.kinematics
    return [
        *motion,
        (2 * kinematics.kinetic_energy, "kinetic energy"),
        (kinematics.mass_matrix, "mass matrix"),
    ]


def answers(truth: Equations, said: Sequence[tuple[Expr, str | None]]) -> list[str]:
    """Verdicts, witnesses, remarks and repairs, in words."""
    checks = [mechanics.check(truth, one, about=about) for one, about in said]
    return [repr((check.judged, check.remarks)) for check in checks]


@pytest.mark.campaign
@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.__name__)
def test_verdicts_and_repairs_do_not_depend_on_those_before(system) -> None:
    one, two = derived(system.scene()), derived(system.scene())
    backwards = answers(two, statements(two)[::-1])
    assert answers(one, statements(one)) == backwards[::-1]


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.__name__)
def test_compiled_functions_do_not_depend_on_those_before(system) -> None:
    one, two = (compile(derived(system.scene())) for _ in range(2))
    names = [*one.casadi]
    forwards = {name: one.casadi[name].serialize() for name in names}
    # Who reads the equations first changes nothing either.
    assert two.equations.kinematics.mass_matrix.rows == len(two.equations.system[1])
    assert {name: two.casadi[name].serialize() for name in names[::-1]} == forwards
