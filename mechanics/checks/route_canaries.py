"""Routes and laws of a pendulum on a cart that are known to be right, and to be wrong.

The same rows in another order, with other signs, are the same motion; rows with one more term, of
twice the mass, or of another damper are not.
"""

from collections.abc import Iterator
from dataclasses import replace

from sympy import symbols
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.agreement import compare, linear_system
from mechanics.checks.laws import check_energy, check_mass_matrix
from mechanics.kernel import Finding
from mechanics.mechanism import Mechanism, lower
from mechanics.program.builder import Builder
from mechanics.program.residues import Residues
from mechanics.routes import kane
from mechanics.scene import Particle, Scene, gravity, reaction, spring
from mechanics.scene.loads import damper


def known_findings() -> Iterator[tuple[str, bool, Finding]]:
    """What is stated, whether it is true, and what was found of it."""
    mechanism = _pendulum_on_cart()
    filter_ = Residues(mechanism.builder)
    rows = kane.derive(mechanism)
    first, second = rows.values
    right = linear_system(mechanism, rows, filter_)
    turned = replace(rows, values=(-second, first))
    mixed = replace(rows, values=(first + second, first - second))
    wrong = replace(rows, values=(first, second + mechanism.q[1].sin()))
    twice = replace(rows, values=(2 * first, 2 * second))
    damped = replace(rows, values=(first + mechanism.u[0], second))
    for words, other, true in (
        ("rows in another order", turned, True),
        ("rows that are mixed", mixed, True),
        ("rows with one term more", wrong, False),
    ):
        there = linear_system(mechanism, other, filter_)
        yield words, true, compare(right, there, filter_)
        yield f"{words}, the other way", true, compare(there, right, filter_)
    yield "the mass matrix", True, check_mass_matrix(mechanism, rows)
    yield "twice the mass matrix", False, check_mass_matrix(mechanism, twice)
    yield "energy", True, check_energy(mechanism, rows)
    yield "energy, with another damper", False, check_energy(mechanism, damped)


def _pendulum_on_cart() -> Mechanism:
    m, L, k, c, g = symbols("m L k c g", positive=True)
    x, theta = dynamicsymbols("x theta")
    N, O = ReferenceFrame("N"), Point("O")
    rod = N.orientnew("B", "Axis", (theta, N.z))
    cart = O.locatenew("C", x * N.x)
    bob = cart.locatenew("P", -L * rod.y)
    scene = Scene(
        "pendulum on a cart", N, O, coordinates=(x, theta),
        bodies=(Particle("cart", cart, 2 * m), Particle("bob", bob, m)),
        loads=(
            gravity(-g * N.y),
            spring("k", O, cart, k, length=L, along=N.x),
            damper("c", O, cart, c, along=N.x),
        ),
        reactions=(
            reaction("R", at=cart, on="cart", by=None, along=N.y),
            reaction("T", at=bob, on="bob", by="cart", along=rod.y),
        ),
    )  # fmt: skip
    return lower(scene, Builder())
