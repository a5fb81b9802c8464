"""What a sentence calls conserved has the rate zero; that is judged beside what it is."""

import pytest

from mechanics import check
from mechanics.kernel import Verdict
from systems import bead_on_hoop, cartpole, two_mass_chain

ENERGY = r"E=\frac12mR^2(\dot\theta^2+\omega^2\sin^2\theta)-mgR\cos\theta"
JACOBI = r"h=\frac12mR^2(\dot\theta^2-\omega^2\sin^2\theta)-mgR\cos\theta"
SPRINGS = r"E=\frac32m\dot x_1^2+m\dot x_2^2+\frac12kx_1^2+\frac12k(x_2-x_1)^2"
MOMENTUM = r"p=(m_c+m_p)\dot x+m_pl\dot\theta\cos\theta"


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("system", "text", "verdicts"),
    [
        (bead_on_hoop, f"The energy ${ENERGY}$ is conserved.", ["PROVED", "REFUTED"]),
        (bead_on_hoop, f"The energy ${ENERGY}$ is not conserved.", ["PROVED"]),
        (bead_on_hoop, rf"The energy \[{ENERGY}\] is conserved.", ["PROVED", "REFUTED"]),
        (bead_on_hoop, f"The energy\n$${ENERGY},$$\nis conserved.", ["PROVED", "REFUTED"]),
        (
            bead_on_hoop,
            rf"Here \begin{{equation}}{JACOBI}\end{{equation}} is conserved.",
            ["PROVED", "PROVED"],
        ),
        (bead_on_hoop, rf"The energy \[{ENERGY}\] is not conserved.", ["PROVED"]),
        (bead_on_hoop, f"But ${JACOBI}$ is conserved.", ["PROVED", "PROVED"]),
        (two_mass_chain, f"The energy ${SPRINGS}$ is thus constant.", ["PROVED", "PROVED"]),
        (cartpole, f"The momentum ${MOMENTUM}$ is conserved.", ["PROVED", "REFUTED"]),
        (cartpole, f"The momentum ${MOMENTUM}$ is conserved if $F=0$.", ["PROVED", "UNDECIDED"]),
    ],
)
def test_what_is_called_conserved(system, text, verdicts):  # type: ignore[no-untyped-def]
    answer = check(system.scene(), text, blame=False)
    assert [entry.verdict.name for entry in answer.judged] == verdicts


def test_a_parameter_that_is_constant_says_nothing() -> None:
    text = r"$\Omega^2=k/m$ is constant. $3m\ddot x_1 + 2kx_1 - kx_2 = 0$"
    answer = check(two_mass_chain.scene(), text, blame=False)
    assert answer.judged[-1].verdict is Verdict.PROVED
    assert not any("rate zero" in note for e in answer.judged for note in e.statement.notes)
