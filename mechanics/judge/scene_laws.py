"""Whether what statements are compared with is what the scene declares.

    sum over bodies of (m a - F) . v + (H' - T) . w = 0        every admissible (v, w)
    F . v + T . w = -dV/dt of loads with a potential,  R . v = 0 of reactions

`mechanics.checks.virtual_power` reads SymPy's objects as the user made them, and none of the
functions by which the equations were derived.
"""

from collections.abc import Iterator

from mechanics.checks.virtual_power import (
    check_powers,
    check_program,
    check_virtual_power,
    drawn_states,
)
from mechanics.crosscheck.programs import derive_rows, solved
from mechanics.equations import Equations
from mechanics.errors import SceneError
from mechanics.kernel import Finding, Verdict
from mechanics.scene.potential import potential


def verify(truth: Equations) -> tuple[str, ...]:
    """Remarks about laws of the scene that could not be tried; none where all hold.

    Parameters
    ----------
    truth : Equations
        Derived by a route that has the reactions.

    Raises
    ------
    SceneError
        When a law is refuted at a real state: nothing may be judged by such equations.
    """
    name, remarks = truth.scene.name, []
    for finding in _laws(truth):
        if finding.verdict is Verdict.REFUTED:
            raise SceneError(
                f"scene {name}: what was derived is not what it declares: {finding.subject}:"
                f" {finding.evidence}: no statement is judged; run crosscheck and report it"
            )
        if finding.verdict is Verdict.UNDECIDED:
            remarks.append(
                f"the scene was not tried as declared: {finding.subject}: {finding.evidence}"
            )
    return tuple(remarks)


def _laws(truth: Equations) -> Iterator[Finding]:
    scene = truth.scene
    states = drawn_states(scene)
    yield from check_powers(scene, states, potential(scene))
    if truth.textbook is not None:
        yield check_virtual_power(truth, states)
    else:
        programs = derive_rows(truth.program[0], [truth.route])
        yield check_program(scene, truth.route, solved(programs, truth.route), states)
