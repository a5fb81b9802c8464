"""Terms at a witness: their values add up to the values of the sides, in the person's notation."""

from fractions import Fraction

import pytest

import mechanics
from mechanics.report.answer.term_values import Values, term_values
from systems import rod_pendulum

SCENE = rod_pendulum.scene()


def terms_of(text: str) -> tuple[Values, Fraction]:
    """Terms of a wrong equation, and the sum of both sides at its witness."""
    (entry,) = mechanics.check(SCENE, text, blame=False).judged
    witness = entry.finding.witness
    assert witness is not None
    left, right = (Fraction(side.strip("[").split()[0]) for side in (witness.left, witness.right))
    return term_values(entry.statement, witness), left + right


@pytest.mark.parametrize(
    "text",
    [
        "m*l**2*theta_ddot/12 + m*g*l*sin(theta)/2 - u",
        "m*l**2*theta_ddot/3 = u + m*g*l*sin(theta)/2 + m*l*theta_dot**2",
        r"\frac{m l^2}{3} \ddot\theta + m g l \cos\theta - u = 0",
    ],
)
def test_terms_add_up_to_their_sides(text: str) -> None:
    terms, sides = terms_of(text)
    assert len(terms) > 2
    assert float(sum(Fraction(value) for _, value in terms)) == pytest.approx(
        float(sides), rel=1e-4
    )


def test_terms_are_spelled_as_the_person_writes() -> None:
    terms, _ = terms_of(r"\frac{m l^2}{3} \ddot\theta + m g l \cos\theta - u = 0")
    assert any(r"\cos" in term for term, _ in terms)


def test_sides_of_one_term_say_nothing_twice() -> None:
    assert terms_of("theta_ddot = u")[0] == []
