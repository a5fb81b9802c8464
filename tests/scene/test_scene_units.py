"""Units are read, and what is declared has the dimension that it must have."""

import pytest
from sympy import Symbol
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene import Particle, Scene, damper, gravity, parameters, reaction, spring
from mechanics.scene.unit_names import UNITS, dimension_of_unit, words
from systems import ALL

x = dynamicsymbols("x")
RIGHT = "kg m N/m N*s/m m/s^2"


def block(units: str) -> Scene:
    m, a, k, c, g = parameters("m a k c g", units=units, typical="1 1 1 1 9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    centre = origin.locatenew("C", (x + a) * ground.x)
    return Scene(
        "block",
        ground,
        origin,
        coordinates=(x,),
        bodies=(Particle("block", centre, m),),
        loads=(
            gravity(-g * ground.y),
            spring("k", origin, centre, k, along=ground.x, length=a),
            damper("c", origin, centre, c, along=ground.x),
        ),
        reactions=(reaction("N", at=centre, on="block", by=None, along=ground.y),),
    )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("kg*m^2/s^2", "N*m"),
        ("N*m*s/rad", "J*s"),
        ("W", "J/s"),
        ("Pa", "N/m^2"),
        ("kg*m**2", "kg*m^2"),
        ("V*A", "W"),
        ("1", "rad"),
        ("m^-1", "1/m"),
    ],
)
def test_units_that_are_the_same(text: str, expected: str) -> None:
    assert dimension_of_unit(text, "a") == dimension_of_unit(expected, "b")


@pytest.mark.parametrize("unit", UNITS)
def test_words_are_read_back(unit: str) -> None:
    found = dimension_of_unit(unit, "a")
    assert found is not None and dimension_of_unit(words(found), "b") == found


@pytest.mark.parametrize("unit", ["furlong", "m/", "kgm", "m^^2", "m^x", "kg_m"])
def test_a_unit_that_is_not_known_is_refused_by_name(unit: str) -> None:
    with pytest.raises(SceneError, match=r"parameter g: the unit .* is not known"):
        parameters("g", units=unit)


@pytest.mark.parametrize(
    ("place", "unit", "message"),
    [
        (0, "m", "body block, mass: m has the unit m, not kg"),
        (1, "s", "point C: .* has the unit s, not m"),
        (2, "N", "load k, stiffness: k has the unit .*, not N/m"),
        (3, "N/m", r"load c, coefficient: c has the unit .*, not N\*s/m"),
        (4, "m", r"load gravity: -g has the unit m, not m/s\^2"),
    ],
)
def test_a_wrong_dimension_is_refused(place: int, unit: str, message: str) -> None:
    assert block(RIGHT).parameters
    units = RIGHT.split()
    units[place] = unit
    with pytest.raises(SceneError, match=message):
        block(" ".join(units))


def test_what_is_not_known_is_not_judged() -> None:
    assert block("").parameters
    assert all(isinstance(symbol, Symbol) for s in ALL for symbol in s.scene().parameters)


def test_a_sum_of_different_dimensions_is_refused() -> None:
    m, n = parameters("m n", units="kg m")
    ground, origin = ReferenceFrame("N"), Point("O")
    centre = origin.locatenew("C", x * ground.x)
    with pytest.raises(SceneError, match=r"body b, mass: m \+ n adds (kg and m|m and kg)"):
        Scene("s", ground, origin, coordinates=(x,), bodies=(Particle("b", centre, m + n),))
