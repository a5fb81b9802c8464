"""Operation counts are exact: they have a baseline, and none may grow unseen.

Rewrite the baseline with ``MECHANICS_UPDATE_BASELINE=1 pytest tests/benchmarks``.
"""

import json
import os
from pathlib import Path

import pytest

from mechanics.compiled import compile
from mechanics.routes.derivation import ROUTES
from systems import ALL

pytestmark = pytest.mark.campaign

BASELINE = Path(__file__).parents[2] / "benchmarks" / "operations.json"
FUNCTIONS = ("mass_matrix", "forcing", "forward_dynamics")


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", ALL, ids=lambda system: system.name)
def test_operations_do_not_grow(system) -> None:
    scene = system.scene()
    counts = {}
    for route in ROUTES:
        graphs = compile(route.derive(scene)).casadi
        counts[route.name] = {name: graphs[name].n_instructions() for name in FUNCTIONS}
    baseline = json.loads(BASELINE.read_text()) if BASELINE.exists() else {}
    if os.environ.get("MECHANICS_UPDATE_BASELINE"):
        baseline[system.name] = counts
        BASELINE.write_text(json.dumps(dict(sorted(baseline.items())), indent=2) + "\n")
    grown = {
        (route, name): (baseline[system.name][route][name], count)
        for route, functions in counts.items()
        for name, count in functions.items()
        if count > baseline[system.name][route][name]
    }
    assert not grown, f"{system.name}: (baseline, now) {grown}"
