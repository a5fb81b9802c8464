"""|e| = 0 is e = 0; any other kink that holds accelerations is named, with what to write."""

import pytest
from rod_statements import ROD

import mechanics
from mechanics.kernel import Verdict

RIGHT = "theta'' - 3*g/(2*l)*sin(theta) - 3*u/(m*l^2)"


@pytest.mark.parametrize(
    "text",
    [
        f"abs({RIGHT}) = 0",
        f"0 = -2*l*abs({RIGHT})",
        r"\left|\ddot\theta - \frac{3g}{2l}\sin\theta - \frac{3u}{m l^2}\right| = 0",
    ],
)
def test_a_magnitude_that_is_zero_is_an_equation_of_motion(text: str) -> None:
    assert mechanics.check(ROD, text).verdict in (Verdict.PROVED, Verdict.CERTIFIED)


def test_a_magnitude_that_is_not_zero_is_refuted_with_its_value() -> None:
    found = mechanics.check(ROD, f"abs({RIGHT.replace('- 3*u', '+ 3*u')}) = 0", blame=False)
    (entry,) = found.judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert float(entry.finding.witness.left.strip("[").split()[0]) > 0


@pytest.mark.parametrize(
    ("text", "named"),
    [
        (f"abs({RIGHT}) + {RIGHT} = 0", "abs"),
        (f"max({RIGHT}, 0) = 0", "max"),
        (f"sign({RIGHT}) = 0", "sign"),
        ("abs(theta'') = abs(3*g/(2*l)*sin(theta) + 3*u/(m*l^2))", "abs"),
    ],
)
def test_a_kink_that_other_motions_satisfy_is_named(text: str, named: str) -> None:
    (entry,) = mechanics.check(ROD, text).judged
    assert entry.finding.verdict is Verdict.UNDECIDED
    assert entry.finding.evidence.startswith(f"{named} holds accelerations")
    assert "without it" in entry.finding.evidence
