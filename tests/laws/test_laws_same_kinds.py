"""The scenes that laws choose by name are of the kind that their list says."""

import pytest
from linkages import LINKAGES
from shared_scenes import CONSERVATIVE, CONSTRAINED, MANY_COORDINATES, WITH_FRICTION

from mechanics.scene import loads
from mechanics.scene.actions import frictions
from systems import ALL, EVERY, VARIANTS

pytestmark = pytest.mark.campaign


def test_kinds_of_scenes_are_what_they_are_listed_as() -> None:
    assert {s.name for s in EVERY if s.scene().constraints} == CONSTRAINED
    assert all(make().constraints for make in LINKAGES.values())
    assert {s.name for s in (*ALL, *VARIANTS) if frictions(s.scene())} == WITH_FRICTION
    assert {s.name for s in EVERY if len(s.scene().q) > 4} == MANY_COORDINATES
    free = [system for system in ALL if not system.scene().constraints]
    kinds = loads.CONSERVATIVE
    kept = {s.name for s in free if all(isinstance(x, kinds) for x in s.scene().loads)}
    assert kept == CONSERVATIVE
