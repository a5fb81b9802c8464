"""Fast functions of equations, or of whatever equations can be derived from."""

from typing import Any

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_equations
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.errors import wanted
from mechanics.importers import as_scene
from mechanics.scene import Scene


def compile(equations: Any, **options: Any) -> Model:
    """Compile equations of motion, or those of a scene or a model of SymPy's.

    Parameters
    ----------
    equations : Equations, Scene, or a System, KanesMethod or LagrangesMethod of SymPy's
        Equations of a scene are those of `derive`.
    **options
        As for `mechanics.compiled.compile`: ``compiler``, ``flags``, ``form``, ``fixed``,
        ``outputs``, ``reciprocals``.

    Raises
    ------
    SceneError
        When the scene cannot be right.
    InputError
        If there is no such form, parameter or output, the equations have no such form, or a value
        is no number, negative where it must not be, or a divisor that is zero.
    SingularError
        If the equations do not determine the accelerations at the fixed values.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> model = compile(rod_pendulum.scene(), outputs=["energy"], fixed={"g": 9.81})
    >>> list(model.casadi)
    ['energy']
    """
    scene = as_scene(equations)
    wanted(scene, (Equations, Scene), "compile", "pass derive(scene, route), or a scene")
    return compile_equations(derive(scene) if isinstance(scene, Scene) else scene, **options)
