"""A class of which an excerpt does not say where its parameters come from."""

from pathlib import Path

import pytest
from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, pendulum
from mechanics import check
from mechanics.errors import MechanicsError
from mechanics.grading.submission import things_in

SWING = """
import numpy as np

class Swing:
    def prepare(self) -> None:
        p = self.given
        self._J: float = p.mass*p.reach**2
        self._pull = p.mass*p.g*{other}.reach

    def rates(self, x):
        return np.array([x[1], -self._pull/self._J*{sine}(x[0])])
"""


@pytest.mark.parametrize(
    ("other", "sine", "verdict"),
    [
        ("p", "np.sin", "PROVED"),
        ("p", "2*np.sin", "REFUTED"),
        ("self.elsewhere", "np.sin", "not read"),
    ],
)
def test_a_record_that_nothing_sets_has_the_parameters(
    tmp_path: Path, other: str, sine: str, verdict: str
) -> None:
    mass, reach, g = P("mass:kg reach:m g:m/s^2")
    scene = pendulum(dynamicsymbols("theta"), mass, 0, reach, g)
    path = tmp_path / "swing.py"
    path.write_text(SWING.format(other=other, sine=sine))
    try:
        found = check(scene, things_in(path, run_python=True), blame=False).verdict.name
    except MechanicsError:
        found = "not read"
    assert found == verdict
