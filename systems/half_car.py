"""Half car: a body on two wheels with springs and dampers, over a road; bounce and pitch.

    x       of the body's mass centre, upwards from rest
    theta   pitch of the body
    x1, x2  of the front and the rear wheel
    y1, y2  of the road beneath them

The linear equations are those of R. N. Jazar, "Vehicle Dynamics: Theory and Application" (2008),
in its chapter on vehicle vibrations; tyres do not damp, as there. The scene holds for any pitch:
springs and dampers act along the vertical, and coordinates count from rest, where the springs carry
the weight.
"""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, RigidBody, Scene, damper, parameters, reaction, spring
from mechanics.scene.bodies import Body
from mechanics.scene.linear_quantities import LinearizedEquation, operating_point
from mechanics.scene.loads import Load
from mechanics.scene.published import published

x, theta, x1, x2, y1, y2 = dynamicsymbols("x theta x1 x2 y1 y2")
t = dynamicsymbols._t
m, m1, m2, I, a1, a2, k1, k2, c1, c2, kt1, kt2 = parameters(
    "m m1 m2 I a1 a2 k1 k2 c1 c2 kt1 kt2",
    units="kg kg kg kg*m^2 m m N/m N/m N*s/m N*s/m N/m N/m",
    typical="420 53 76 1100 1.4 1.47 10000 13000 1000 1000 200000 200000",
    meanings=(
        "mass of the body",
        "mass of the front wheel",
        "mass of the rear wheel",
        "inertia of the body about its mass centre",
        "distance of the front axle from the mass centre",
        "distance of the rear axle from the mass centre",
        "stiffness of the front suspension",
        "stiffness of the rear suspension",
        "damping of the front suspension",
        "damping of the rear suspension",
        "stiffness of the front tyre",
        "stiffness of the rear tyre",
    ),
)


def scene() -> Scene:
    """The body moves up and down and pitches; the road is given as y1 and y2."""
    ground, origin = ReferenceFrame("N"), Point("O")
    car = ground.orientnew("B", "Axis", (-theta, ground.z))
    centre = origin.locatenew("C", x * ground.y)
    bodies: list[Body] = [RigidBody("body", centre, car, m, I)]
    loads: list[Load] = []
    for name, reach, wheel, road, k, c, kt in (
        ("front", a1, x1, y1, k1, c1, kt1),
        ("rear", -a2, x2, y2, k2, c2, kt2),
    ):
        end = centre.locatenew(f"{name} end", reach * car.x)
        hub = origin.locatenew(f"{name} hub", reach * ground.x + wheel * ground.y)
        patch = origin.locatenew(f"{name} road", reach * ground.x + road * ground.y)
        bodies.append(Particle(name, hub, m1 if name == "front" else m2))
        ends = {"along": ground.y, "first_on": name, "second_on": "body"}
        loads += [
            spring(f"{name} spring", hub, end, k, **ends),
            damper(f"{name} damper", hub, end, c, **ends),
            spring(f"{name} tyre", patch, hub, kt, along=ground.y, second_on=name),
        ]
    return Scene(
        "half car",
        ground,
        origin,
        coordinates=(x, theta, x1, x2),
        bodies=tuple(bodies),
        loads=tuple(loads),
        reactions=tuple(
            reaction(f"{body.name} guide", at=body.centre, on=body.name, by=None, along=ground.x)
            for body in bodies
        ),
        inputs=(y1, y2),
        example={"x": 0.05},
    )


REST = operating_point(dict.fromkeys(("x", "theta", "x1", "x2"), 0), {"y1": 0, "y2": 0})
front, rear = x - x1 - a1 * theta, x - x2 + a2 * theta

PUBLISHED = (
    published(
        "bounce",
        LinearizedEquation(REST),
        m * x.diff().diff() + c1 * front.diff(t) + c2 * rear.diff(t) + k1 * front + k2 * rear,
        0,
        label="bounce of the body",
    ),
    published(
        "pitch",
        LinearizedEquation(REST),
        I * theta.diff().diff()
        - a1 * c1 * front.diff(t)
        + a2 * c2 * rear.diff(t)
        - a1 * k1 * front
        + a2 * k2 * rear,
        0,
        label="pitch of the body",
    ),
    published(
        "front",
        LinearizedEquation(REST),
        m1 * x1.diff().diff() - c1 * front.diff(t) + kt1 * (x1 - y1) - k1 * front,
        0,
        label="front wheel",
    ),
    published(
        "rear",
        LinearizedEquation(REST),
        m2 * x2.diff().diff() - c2 * rear.diff(t) + kt2 * (x2 - y2) - k2 * rear,
        0,
        label="rear wheel",
    ),
)
