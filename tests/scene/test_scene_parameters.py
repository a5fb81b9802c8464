"""Parameters: what is declared is checked, and typical values are exact."""

import pickle
from dataclasses import replace
from fractions import Fraction

import pytest
from sympy import Rational, cos, pi, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.admissible import check_scene
from mechanics.errors import SceneError
from mechanics.scene import RigidBody, Scene, gravity, parameters, pin
from systems import pendulum_chain


def test_typical_values_are_exact() -> None:
    a, b, c = parameters(
        "a b c", units="kg m 1", typical="0.1 1/3 -", meanings=("one", "two", "three")
    )
    assert [p.typical for p in (a, b, c)] == [Fraction(1, 10), Fraction(1, 3), None]
    assert [p.unit for p in (a, b, c)] == ["kg", "m", "1"]
    assert c.meaning == "three"
    assert a.is_positive


def test_multiples_of_pi_are_exact() -> None:
    given = "pi pi/10 -3*pi/4 +0.5*pi"
    angles = parameters("a b c d", typical=given, positive=False)
    assert [p.exact for p in angles] == [pi, pi / 10, -3 * pi / 4, pi / 2]
    assert [float(p.typical) for p in angles] == [float(p.exact) for p in angles]
    assert pickle.loads(pickle.dumps(angles[1])).exact == pi / 10
    assert parameters("e f", typical="1/3 -")[0].exact == Rational(1, 3)
    assert parameters("e f", typical="1/3 -")[1].exact is None


def test_typical_values_may_be_numbers() -> None:
    assert parameters("a", typical=pi / 10)[0].exact == pi / 10
    a, b, c = parameters("a b c", typical=[0.1, -3 * pi / 4, Rational(1, 3)], positive=False)
    assert [p.exact for p in (a, b, c)] == [Rational(1, 10), -3 * pi / 4, Rational(1, 3)]
    with pytest.raises(
        SceneError, match=r"parameter b: the typical value 'sqrt\(2\)' is no number"
    ):
        parameters("a b", typical=[1, sqrt(2)])


def test_an_equilibrium_at_a_multiple_of_pi_is_proved() -> None:
    """A pendulum in a field that is turned: a rational next to pi/10 is no equilibrium."""
    q, (a, m, g, l, J) = (
        dynamicsymbols("q"),
        parameters("a m g l J", typical="pi/10 1 9.81 0.3 0.1"),
    )
    N, O = ReferenceFrame("N"), Point("O")
    hinge = pin("hinge", None, "bob", at=O, axis=N.z, angle=q)
    bob = RigidBody("bob", O.locatenew("P", l * hinge.frame.x), hinge.frame, m, J)
    field = gravity(g * (cos(a) * N.x + sin(a) * N.y))
    scene = Scene("tilted", N, O, bodies=(bob,), joints=(hinge,), plane=N.z, loads=(field,),
                  equilibria=({"q": pi / 10},))  # fmt: skip
    assert len(check_scene(scene).u) == 1
    near = Rational(Fraction(a.typical))
    with pytest.raises(SceneError, match="is not shown to be an equilibrium"):
        check_scene(replace(scene, equilibria=({"q": near},)))


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
        (("a", "", "pi/0"), "parameter a: the typical value 'pi/0' is no number"),
        (("a", "", "pi*2"), "a multiple of pi such as pi/10"),
        (("a", "", "heavy"), "parameter a: the typical value 'heavy' is no number"),
    ],
)
def test_declarations_that_do_not_fit_are_refused(given: tuple, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        parameters(*given)


def test_parameters_are_in_the_order_of_their_names_and_numbers() -> None:
    names = [symbol.name for symbol in pendulum_chain.scene(11).parameters]
    assert names == ["g", *(f"l{i}" for i in range(11)), *(f"m{i}" for i in range(12))]
