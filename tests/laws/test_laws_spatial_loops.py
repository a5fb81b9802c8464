"""Loops in space by all routes: they agree everywhere, so that no point on the loops is needed."""

from collections.abc import Callable

import pytest

from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs, linear_system
from mechanics.errors import SceneError
from mechanics.routes.derivation import ROUTES
from mechanics.routes.redundant import without_redundant
from mechanics.scene import Scene
from tests.spatial_loops import bricard, four_bar, stewart


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("scene", "left"),
    [(four_bar, 3), (bricard, 4), (stewart, 18)],
    ids=["four-bar", "bricard", "stewart"],
)
def test_routes_agree_on_loops_in_space(scene: Callable[[], Scene], left: int) -> None:
    whole = without_redundant(scene())
    assert len(whole.constraints) == left
    mechanism = check_scene(whole)
    _, closed = mechanism.filters
    rows = [route.rows(mechanism) for route in ROUTES]
    pairs = compare_pairs({one.route: linear_system(mechanism, one, closed) for one in rows})
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())


def test_a_mechanism_that_moves_for_its_angles_alone_is_not_called_rigid() -> None:
    with pytest.raises(SceneError, match="redundant constraints: close_mz_closes follow") as caught:
        check_scene(bricard())
    assert 'redundant="drop"' in str(caught.value)
