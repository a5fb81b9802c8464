"""A scene in which one load, or the inertia of one body, is multiplied by a parameter `share`.

    share = 1: as declared        share = 0: left out

So what is left out needs no scene of its own, and how small it has to be is found between the two.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from sympy import Expr, S, sympify
from sympy.physics.vector import Dyadic, Vector

from mechanics.scene import (
    Coulomb,
    Damper,
    Force,
    Gravity,
    Load,
    RigidBody,
    Scene,
    Spring,
    Torque,
    TorsionSpring,
    parameters,
)
from mechanics.scene.bodies import Body

SHARE = "share"


@dataclass(frozen=True, eq=False)
class Part:
    """Something that a model may do without.

    Attributes
    ----------
    name : str
        ``"damper c"``, ``"inertia of pendulum"``.
    value : Expr or None
        Its size, where that is one expression.
    scene : Scene
        With the part multiplied by `share`.
    """

    name: str
    value: Expr | None
    unit: str
    scene: Scene


def parts(scene: Scene) -> Iterator[Part]:
    """Every load that is not identically zero, and the inertia of every rigid body.

    A force that is nothing but an input is left to the inputs.
    """
    (share,) = parameters(SHARE, units="1", typical="1", meanings=("share of what is kept",))
    for i, load in enumerate(scene.loads):
        for name, value, unit, scaled in _load(scene, load, share):
            loads = (*scene.loads[:i], scaled, *scene.loads[i + 1 :])
            yield Part(name, value, unit, replace(scene, loads=loads))
    for i, body in enumerate(scene.bodies):
        if isinstance(body, RigidBody) and body.inertia != 0:
            bodies: tuple[Body, ...] = (
                *scene.bodies[:i],
                replace(body, inertia=_times(share, body.inertia)),
                *scene.bodies[i + 1 :],
            )
            value = None if isinstance(body.inertia, Dyadic) else body.inertia
            name = f"inertia of {body.name}"
            yield Part(name, value, "kg m^2", replace(scene, bodies=bodies))


def _load(scene: Scene, load: Load, share: Expr) -> Iterator[tuple[str, Expr | None, str, Load]]:
    match load:
        case Gravity():
            size = sympify(load.field.magnitude()) if load.field != 0 else S.Zero
            yield load.name, size, "m/s^2", replace(load, field=share * load.field)
        case Spring():
            scaled: Load = replace(load, stiffness=share * load.stiffness)
            yield f"spring {load.name}", load.stiffness, "N/m", scaled
        case TorsionSpring():
            scaled = replace(load, stiffness=share * load.stiffness)
            yield f"torsion spring {load.name}", load.stiffness, "N m/rad", scaled
        case Damper():
            scaled = replace(load, coefficient=share * load.coefficient)
            yield f"damper {load.name}", load.coefficient, "N s/m", scaled
        case Coulomb():
            scaled = replace(load, coefficient=share * load.coefficient)
            yield f"friction {load.name}", load.coefficient, "1", scaled
        case Force() | Torque():
            if not _only_inputs(scene, load.vector):
                kind = "force" if isinstance(load, Force) else "torque"
                yield f"{kind} {load.name}", None, "", replace(load, vector=share * load.vector)


def _only_inputs(scene: Scene, vector: Vector) -> bool:
    """Whether a load vanishes with the inputs."""
    zeros = dict.fromkeys(scene.inputs, S.Zero)
    return bool(vector.subs(zeros) == 0)


def _times(share: Expr, inertia: Expr | Dyadic) -> Expr | Dyadic:
    return share * inertia
