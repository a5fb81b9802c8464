"""Cart on a rail with a chain of links, a point mass at the end of each.

The system of SymPy's `n_link_pendulum_on_cart` (sympy.physics.mechanics.models), with its names:
absolute angles from the upward vertical, positive counterclockwise; link i has the length l(i-1).
With mu_i = m_i + ... + m_n and L_i = l(i-1) the equations of motion are, and textbooks print them
for n = 1 (inverted pendulum on a cart) and n = 2:

    (m0 + mu_1) q0'' - sum_i mu_i L_i (q_i'' cos q_i - q_i'^2 sin q_i) = F
    sum_j mu_max(i,j) L_j (q_j'' cos(q_i - q_j) + q_j'^2 sin(q_i - q_j))
        = mu_i (q0'' cos q_i + g sin q_i)
"""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene import (
    Particle,
    Reaction,
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    reaction,
)
from mechanics.scene.published import Published, published
from mechanics.scene.quantities import EquationOfMotion

F = dynamicsymbols("F")
(g,) = parameters("g", units="m/s^2", typical="9.81", meanings=("acceleration of gravity",))


def masses(links: int) -> tuple:
    """m0 of the cart, then that at the end of each link."""
    return parameters(
        " ".join(f"m{i}" for i in range(links + 1)),
        units=" ".join(["kg"] * (links + 1)),
        typical=" ".join(["2"] + ["1"] * links),
        meanings=("mass of the cart", *(f"mass at the end of link {i + 1}" for i in range(links))),
    )


def lengths(links: int) -> tuple:
    """l0 of the first link, and so on: SymPy's model counts lengths from zero."""
    return parameters(
        " ".join(f"l{i}" for i in range(links)),
        units=" ".join(["m"] * links),
        typical=" ".join(["1"] * links),
        meanings=tuple(f"length of link {i + 1}" for i in range(links)),
    )


def scene(links: int = 3) -> Scene:
    """A cart that the force F pushes along a rail, and a chain of massless links on it.

    A link is a massless rod with a point mass at its far end: a rigid body whose inertia about its
    mass centre is zero. So each pivot has a force in both directions, and the moment equation of a
    link says that the force acts along it.

    Parameters
    ----------
    links : int
        Number of links, one or more.

    Raises
    ------
    SceneError
        When there is no link.
    """
    if links < 1:
        raise SceneError(f"pendulum chain: {links} links: it needs one or more")
    m, l = masses(links), lengths(links)
    q = dynamicsymbols(f"q:{links + 1}")
    ground = ReferenceFrame("N")
    origin = Point("O")
    tip = origin.locatenew("P0", q[0] * ground.x)
    bodies: list[Particle | RigidBody] = [Particle("cart", tip, m[0])]
    reactions: list[Reaction] = [reaction("N", at=tip, on="cart", by=None, along=ground.y)]
    for i in range(1, links + 1):
        link, inner, pivot = f"link{i}", bodies[-1].name, tip
        frame = ground.orientnew(f"B{i}", "Axis", (q[i], ground.z))
        tip = pivot.locatenew(f"P{i}", l[i - 1] * frame.y)
        bodies.append(RigidBody(link, tip, frame, m[i], 0))
        reactions += [
            reaction(f"Tx{i}", at=pivot, on=link, by=inner, along=ground.x),
            reaction(f"Ty{i}", at=pivot, on=link, by=inner, along=ground.y),
        ]
    return Scene(
        "pendulum chain" if links == 3 else f"pendulum chain of {links}",
        ground,
        origin,
        coordinates=tuple(q),
        bodies=tuple(bodies),
        loads=(
            gravity(-g * ground.y),
            force("F", bodies[0].centre, F * ground.x, on="cart"),
        ),
        reactions=tuple(reactions),
        inputs=(F,),
        example={f"q{i}": 2.0 + 0.3 * i for i in range(1, links + 1)},
    )


def equations_of_motion(links: int = 3) -> tuple[Published, ...]:
    """The closed form above, one row for the cart and one for each link."""
    m, q = masses(links), dynamicsymbols(f"q:{links + 1}")
    L = (0, *lengths(links))
    mu = [sum(m[i:]) for i in range(links + 1)]
    numbers = range(1, links + 1)
    pulls = [
        mu[j] * L[j] * (q[j].diff().diff() * cos(q[j]) - q[j].diff() ** 2 * sin(q[j]))
        for j in numbers
    ]
    cart = published(
        "cart",
        EquationOfMotion(),
        mu[0] * q[0].diff().diff() - sum(pulls),
        F,
        label="momentum along the rail",
    )

    def swing(i: int) -> Published:
        parts = [
            mu[max(i, j)] * L[j] * (q[j].diff().diff() * cos(q[i] - q[j]))
            + mu[max(i, j)] * L[j] * q[j].diff() ** 2 * sin(q[i] - q[j])
            for j in numbers
        ]
        weight = mu[i] * (q[0].diff().diff() * cos(q[i]) + g * sin(q[i]))
        label = f"moments about the pivot of link {i}, divided by its length"
        return published(f"link {i}", EquationOfMotion(), sum(parts), weight, label=label)

    return (cart, *(swing(i) for i in numbers))


PUBLISHED = equations_of_motion()
