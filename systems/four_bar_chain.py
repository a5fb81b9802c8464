"""Row of four-bar linkages: the rocker of each loop is the crank of the next.

    q0, q2, q4, ...   cranks and rockers, q1, q3, ... couplers, counted from the ground's x

With bars of length 1 and of equal mass it is benchmark A02 of the IFToMM Technical Committee for
Multibody Dynamics, "N-four-bar mechanism" (M. Gonzalez, F. Gonzalez, A. Luaces and J. Cuadrado), a
test of many closed loops: all loops meet singular poses together, where bars are in line.
"""

from collections.abc import Callable

from sympy import Expr, S, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene import Constraint, RigidBody, Scene, gravity, holonomic, parameters, reaction

# Lengths are numbers, so nothing here has a dimension.
m, g = parameters(
    "m g", typical="1 9.81", meanings=("mass of a bar", "acceleration of gravity over its length")
)


def _equal(_kind: str, _number: int) -> Expr:
    return S.One


def scene(loops: int = 2, length: Callable[[str, int], Expr] = _equal) -> Scene:
    """Uniform bars in a vertical plane.

    Parameters
    ----------
    loops : int
        Number of loops, one or more.
    length : callable
        Of a ``"crank"``, ``"coupler"`` or ``"ground"``, and its number; a rocker is the next crank.

    Raises
    ------
    SceneError
        When there is no loop.
    """
    if loops < 1:
        raise SceneError(f"four-bar chain: {loops} loops: it needs one or more")
    ground, origin = ReferenceFrame("N"), Point("A")

    def rod(name: str, frame: ReferenceFrame, start: Point, size: Expr) -> RigidBody:
        centre = start.locatenew(f"centre of {name}", size / 2 * frame.x)
        return RigidBody(name, centre, frame, m, m * size**2 / 12)

    def pin(name: str, at: Point, on: str, by: str | None) -> list:
        axes = (("x", ground.x), ("y", ground.y))
        return [reaction(f"{name}{k}", at=at, on=on, by=by, along=along) for k, along in axes]

    q = dynamicsymbols(f"q0:{2 * loops + 1}")
    frames = [ground.orientnew(f"F{k}", "Axis", (angle, ground.z)) for k, angle in enumerate(q)]
    bodies = [rod("rod 0", frames[0], origin, length("crank", 0))]
    reactions, constraints = pin("O", origin, "rod 0", None), list[Constraint]()
    at, crank, example = origin, 0, {"q0": 1.0}
    for k in range(loops):
        a, b, c, d = (
            length(*of) for of in (("crank", k), ("coupler", k), ("crank", k + 1), ("ground", k))
        )
        i, j = 2 * k + 1, 2 * k + 2
        joint = at.locatenew(f"B{k}", a * frames[crank].x)
        foot = at.locatenew(f"D{k}", d * ground.x)
        bodies += [rod(f"rod {i}", frames[i], joint, b), rod(f"rod {j}", frames[j], foot, c)]
        end = joint.locatenew(f"C{k}", b * frames[i].x)
        reactions += [
            *pin(f"B{k}", joint, f"rod {i}", f"rod {crank}"),
            *pin(f"D{k}", foot, f"rod {j}", None),
            *pin(f"C{k}", end, f"rod {i}", f"rod {j}"),
        ]
        constraints += [
            holonomic(f"x{k}", a * cos(q[crank]) + b * cos(q[i]) - d - c * cos(q[j]), f"C{k}x"),
            holonomic(f"y{k}", a * sin(q[crank]) + b * sin(q[i]) - c * sin(q[j]), f"C{k}y"),
        ]
        example |= {f"q{i}": 0.0, f"q{j}": 1.0}
        at, crank = foot, j
    return Scene(
        f"{loops} four-bars",
        ground,
        origin,
        coordinates=tuple(q),
        bodies=tuple(bodies),
        loads=(gravity(-g * ground.y),),
        reactions=tuple(reactions),
        constraints=tuple(constraints),
        example=example,
    )
