"""A slider-crank: two descriptions of its last pin that are one only where the loop is closed."""

import pytest
from linkages import slider_crank

from mechanics import crosscheck, derive
from mechanics.crosscheck import CrossCheck
from mechanics.kernel import Verdict

pytestmark = pytest.mark.campaign


@pytest.mark.parametrize("pin", ["end of the rod", "slider"])
def test_all_routes_agree(pin: str) -> None:
    result = crosscheck(slider_crank(pin), CrossCheck(states=10))
    assert result.ok
    assert {finding.verdict for finding in result.pairs.values()} == {Verdict.PROVED}


@pytest.mark.parametrize("pin", ["end of the rod", "slider"])
def test_a_principle_that_reads_zero_on_the_closed_loop_is_dropped(pin: str) -> None:
    # About its own pin the slider has neither momentum nor moment, once the loop is closed.
    chosen = derive(slider_crank(pin), "moving_point").chosen
    assert not any(words.startswith("slider: moment") for words in chosen)
