"""A scene as a `System` of SymPy's, for people who go on there.

Frames, points, bodies and loads are made anew, and all velocities follow from positions.
"""

import sympy.physics.mechanics as me

from mechanics.errors import InputError, wanted
from mechanics.routes.kane_sympy import arguments
from mechanics.routes.redundant import without_redundant
from mechanics.routes.sympy_model import SympyModel
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.scene.declaration import DROP


def to_sympy(scene: Scene) -> me.System:
    """A scene as a `System` of `sympy.physics.mechanics`.

    Parameters
    ----------
    scene : Scene

    Returns
    -------
    System
        With the bodies, the loads as forces and couples, coordinates, speeds and constraints of the
        scene; where constraints make speeds dependent, form its equations with
        ``form_eoms(constraint_solver="CRAMER")``. Where u = q', the speed of x(t) is x_dot(t).
        Reactions are not loads, and stay behind.

    Raises
    ------
    InputError
        For friction, which depends on a reaction.

    Examples
    --------
    >>> from systems import elastic_pendulum
    >>> system = to_sympy(elastic_pendulum.scene())
    >>> system.form_eoms().shape
    (2, 1)
    """
    wanted(scene, Scene, "to_sympy", "pass what scene() of a system gives")
    if scene.redundant == DROP:
        scene = without_redundant(scene)
    if held := frictions(scene):
        raise InputError(
            f"{scene.name}: load {held[0].name} is friction, which depends on a reaction: SymPy's"
            " classes have none; leave it out, as in dataclasses.replace(scene, loads=...)"
        )
    model = SympyModel(scene)
    given = arguments(model)
    for body in scene.bodies:
        model.bodies[body.name].masscenter.set_pos(model.point(body.centre), 0)
    for reaction in scene.reactions:
        if reaction.at is not None:
            # Joints and contacts stand in the model as points.
            model.point(reaction.at)
    system = me.System(model.frame, model.point(scene.origin))
    system.add_bodies(*model.bodies.values())
    system.add_loads(*model.loads(scene.loads))
    system.add_coordinates(*given["q_ind"])
    system.add_coordinates(*given.get("q_dependent", ()), independent=False)
    system.add_speeds(*given["u_ind"])
    system.add_speeds(*given.get("u_dependent", ()), independent=False)
    system.add_kdes(*given["kd_eqs"])
    system.add_holonomic_constraints(*given.get("configuration_constraints", ()))
    if "velocity_constraints" in given:
        system.velocity_constraints = given["velocity_constraints"]
    return system
