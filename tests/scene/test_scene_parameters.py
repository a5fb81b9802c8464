"""Parameters: what is declared is checked, and typical values are exact."""

from fractions import Fraction

import pytest

from mechanics.errors import SceneError
from mechanics.scene import parameters
from systems import pendulum_chain


def test_typical_values_are_exact() -> None:
    a, b, c = parameters(
        "a b c", units="kg m 1", typical="0.1 1/3 -", meanings=("one", "two", "three")
    )
    assert [p.typical for p in (a, b, c)] == [Fraction(1, 10), Fraction(1, 3), None]
    assert [p.unit for p in (a, b, c)] == ["kg", "m", "1"]
    assert c.meaning == "three"
    assert a.is_positive


def test_a_parameter_may_have_any_sign() -> None:
    (a,) = parameters("a", positive=False)
    assert a.is_real
    assert a.is_positive is None


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (("",), "no name given"),
        (("a b", "kg"), "2 names but 1 units"),
        (("a b", "", "1 2 3"), "2 names but 3 typical values"),
        (("a", "", "", ("one", "two")), "1 names but 2 meanings"),
        (("a", "", "heavy"), "parameter a: the typical value 'heavy' is no number"),
    ],
)
def test_declarations_that_do_not_fit_are_refused(given: tuple, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        parameters(*given)


def test_parameters_are_in_the_order_of_their_names_and_numbers() -> None:
    names = [symbol.name for symbol in pendulum_chain.scene(11).parameters]
    assert names == ["g", *(f"l{i}" for i in range(11)), *(f"m{i}" for i in range(12))]
