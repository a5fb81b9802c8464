"""Damped modes: of proportional damping by formula, of any damping by the pencil itself.

C = a M + b K:   zeta_i = (a / omega_i + b omega_i) / 2,   shapes as without damping
"""

import numpy as np
import pytest
from sympy import Matrix
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import crosscheck, damped_modes, derive, linearize
from mechanics.crosscheck import CrossCheck
from mechanics.errors import InputError
from mechanics.linear import DampedModes, Linear, damped, numeric_modes, numeric_poles
from mechanics.scene import Particle, Scene, damper, parameters, reaction, spring

x1, x2 = dynamicsymbols("x1 x2")
m, k, c = parameters("m k c", units="kg N/m N*s/m", typical="2 8 0.4")


def chain(first: object = c, second: object = c) -> Linear:
    ground, origin = ReferenceFrame("N"), Point("O")
    one = origin.locatenew("P1", x1 * ground.x)
    two = origin.locatenew("P2", x2 * ground.x)
    scene = Scene(
        "damped chain",
        ground,
        origin,
        coordinates=(x1, x2),
        bodies=(Particle("one", one, m), Particle("two", two, m)),
        loads=(
            spring("k1", origin, one, k, along=ground.x),
            spring("k2", one, two, k, along=ground.x),
            damper("c1", origin, one, first, along=ground.x),
            damper("c2", one, two, second, along=ground.x),
        ),
        reactions=tuple(
            reaction(f"N{i}", at=at, on=on, by=None, along=ground.y)
            for i, at, on in ((1, one, "one"), (2, two, "two"))
        ),
    )
    return linearize(derive(scene, "lagrange"), {"x1": 0, "x2": 0})


def test_proportional_damping_by_formula() -> None:
    linear = chain()
    found = damped_modes(linear)
    # C = (c / k) K, so that zeta = (c / k) omega / 2.
    free = [np.sqrt(8 / 2 * (3 - s * np.sqrt(5)) / 2) for s in (1, -1)]
    np.testing.assert_allclose(found.frequencies, free, rtol=1e-12)
    np.testing.assert_allclose(found.ratios, 0.4 / 8 * np.array(free) / 2, rtol=1e-10)
    golden = (np.sqrt(5) - 1) / 2
    np.testing.assert_allclose(found.shapes, [[golden, 1], [1, -golden]], atol=1e-12)


@pytest.mark.parametrize("values", [{"c": 0.4}, {"c": 40.0}, {"c": 0.4, "m": 5.0}])
def test_shapes_and_poles_satisfy_the_pencil(values: dict[str, float]) -> None:
    linear = chain(c, c / 10)
    found = damped_modes(linear, values)
    numbers = {s: values.get(s.name, float(s.typical)) for s in (m, k, c)}
    matrices = [
        np.array(Matrix(part).subs(numbers).tolist(), dtype=float)
        for part in (linear.mass, linear.damping, linear.stiffness)
    ]
    for s, shape in zip(found.poles, found.shapes.T, strict=True):
        parts = [
            matrix @ shape * s**power for matrix, power in zip(matrices, (2, 1, 0), strict=True)
        ]
        assert np.abs(sum(parts)).max() < 1e-9 * max(np.abs(part).max() for part in parts)
    # Every pole is there, one of each pair.
    both = [*found.poles, *(s.conjugate() for s in found.poles if s.imag > 0)]
    np.testing.assert_allclose(
        np.sort_complex(both), np.sort_complex(numeric_poles(linear, values)), rtol=1e-9
    )
    assert (np.diff(found.frequencies) >= 0).all()


def test_without_damping_at_the_values_modes_are_natural() -> None:
    linear = chain()
    assert damped(linear) and not damped(linear, {"c": 0})
    natural = numeric_modes(linear, {"c": 0})
    found = damped_modes(linear, {"c": 0})
    np.testing.assert_allclose(found.frequencies**2, natural.eigenvalues, rtol=1e-12)
    with pytest.raises(InputError, match="use damped_modes"):
        numeric_modes(linear)
    with pytest.raises(TypeError, match="pass linearize"):
        damped_modes(linear.scene)


def test_words_say_frequency_damping_ratio_and_shape() -> None:
    words = damped_modes(chain(c, 0)).words
    assert len(words) == 2
    for text in words:
        assert "rad/s" in text and "Hz" in text and "damping ratio" in text and "°" in text
    slow = DampedModes(np.array([-2 + 0j, 0j]), np.array([[1 + 0j, 1]]))
    assert "no oscillation" in slow.words[0]
    assert slow.ratios.tolist() == [1, 0]


@pytest.mark.campaign
def test_the_cross_check_lists_damped_modes_and_names_no_other_function() -> None:
    found = crosscheck(chain().scene, CrossCheck(states=0))
    (modes,) = found.modes
    assert modes.title.startswith("Damped modes") and len(modes.rows) == 2
    assert not any("numeric_poles" in remark or "No modes" in remark for remark in found.remarks)
