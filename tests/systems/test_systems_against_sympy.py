"""Our systems against published values and SymPy's own model of the same system."""

import numpy as np
import pytest
import sympy
from sympy import Matrix
from sympy.physics.mechanics.models import n_link_pendulum_on_cart

from mechanics.compiled.model import compile
from mechanics.errors import SceneError
from mechanics.routes.derivation import by_route
from mechanics.scene.symbols import plain_table
from mechanics.symbolic import prove_equal
from systems import four_bar, pendulum_chain, rolling_disc


@pytest.mark.campaign
@pytest.mark.parametrize("links", [1, 2, pytest.param(3, marks=pytest.mark.campaign)])
def test_chain_is_sympys_chain_term_by_term(links: int) -> None:
    scene = pendulum_chain.scene(links)
    ours, theirs = by_route("kane", scene), n_link_pendulum_on_cart(links)
    names = {symbol.name: symbol for symbol in scene.parameters}
    table = {
        **plain_table((*scene.coordinates, *scene.inputs)),
        **dict(zip(theirs.u, scene.u, strict=True)),
        **{s: names[s.name] for s in theirs.mass_matrix.free_symbols if s.name in names},
        **{s: names[s.name] for s in theirs.forcing.free_symbols if s.name in names},
    }
    for ours_part, theirs_part in ((ours.mass, theirs.mass_matrix), (ours.forcing, theirs.forcing)):
        for left, right in zip(ours_part, Matrix(theirs_part).xreplace(table), strict=True):
            assert prove_equal("entry", left, right).shown


def test_chain_without_links_is_refused() -> None:
    with pytest.raises(SceneError, match="0 links: it needs one or more"):
        pendulum_chain.scene(0)


def test_disc_accelerates_as_published() -> None:
    # Yaw, lean and spin; SymPy's issue 27631 has the values that its tutorial got wrong.
    yaw, lean, spin = 0.4, 0.3, 1.1
    rates = np.array([0.5, -0.2, 1.5])
    right = (0.6280509609228515, 4.243586837784844, -0.02637900157817294)
    R = 0.7
    scene = rolling_disc.scene()
    q = [0.0, 0.0, yaw, lean, spin]
    u = [
        rates[1],
        rates[2] + rates[0] * np.sin(lean),
        rates[0] * np.cos(lean),
        R * rates[2] * np.cos(yaw),
        R * rates[2] * np.sin(yaw),
    ]
    model = compile(by_route("kane", scene), compiler=None)
    ud = model.forward_dynamics(q, u, p={"m": 1.3, "R": R, "g": 9.81})
    yaw_ddot = (ud[2] + rates[0] * np.sin(lean) * rates[1]) / np.cos(lean)
    spin_ddot = ud[1] - yaw_ddot * np.sin(lean) - rates[0] * np.cos(lean) * rates[1]
    assert np.allclose((yaw_ddot, ud[0], spin_ddot), right, rtol=1e-12)


def test_typical_linkage_turns_fully() -> None:
    # Grashof: shortest and longest together are shorter than the other two, the crank shortest.
    values = {symbol.name: symbol.typical for symbol in four_bar.scene().parameters}
    lengths = sorted(values[name] for name in ("l1", "l2", "l3", "d"))
    assert lengths[0] == values["l1"]
    assert lengths[0] + lengths[3] < lengths[1] + lengths[2]


def test_closure_is_linear_in_every_length() -> None:
    scene = four_bar.scene()
    closures = Matrix([scene.plain(constraint.expression) for constraint in scene.constraints])
    l2, l3 = (next(s for s in scene.parameters if s.name == name) for name in ("l2", "l3"))
    jacobian = closures.jacobian([l2, l3])
    q2, q3 = scene.q[1:]
    assert not jacobian.free_symbols & {l2, l3}
    assert prove_equal("determinant", jacobian.det(), sympy.sin(q3 - q2)).shown
