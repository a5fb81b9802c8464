"""Wrong models: a scene with mistakes in its masses, places and loads, as SymPy's own objects.

    scene  ->  m for m/2, k x for 2 k x, L for L/2  ->  KanesMethod, LagrangesMethod, System

A person who works with these types no equation: a mistake is made in what the method is given, and
every equation that it forms may be wrong.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from random import Random
from typing import Any

from sympy import Expr
from sympy.physics.mechanics import KanesMethod, LagrangesMethod, System
from sympy.physics.vector import Vector

from benchmarks.detection.mutate import KINDS, Mutation, draw, made
from benchmarks.detection.rows import Row, Subject, holds
from benchmarks.detection.tree import Tree, read, symbols, written
from benchmarks.detection.vocabulary import vocabulary
from mechanics.crosscheck.routes import derive
from mechanics.errors import MechanicsError
from mechanics.routes.kane_sympy import kanes_method
from mechanics.routes.lagrange_sympy import lagranges_method
from mechanics.scene import RigidBody, Scene
from mechanics.scene.bodies import Body
from mechanics.scene.geometry import components, point_path, step_vector
from mechanics.scene.loads import Load
from mechanics.scene.symbols import plain_table, to_plain

Put = Callable[[Expr], Scene]
"""A scene with another expression in one place."""


@dataclass(frozen=True)
class Model:
    """A wrong model.

    Attributes
    ----------
    scene : Scene
        As the person has it.
    mutations : tuple of Mutation
    where : str
        What of the scene they are in.
    """

    scene: Scene
    mutations: tuple[Mutation, ...]
    where: str


def wrong_model(about: Subject, source: Random) -> Model | None:
    """A scene with one mistake whose equations are wrong; None where none was drawn."""
    scene = about.scene
    where, expression, put = source.choice(list(_places(scene)))
    kind = source.choice([kind for kind, _ in KINDS])
    functions = (*scene.coordinates, *scene.inputs)
    tree = read(to_plain(expression, plain_table(functions), where))
    mutations = draw(source, (kind,), (tree,), _constants(about))
    if mutations is None:
        return None
    (changed,) = made((tree,), mutations)
    back = {plain: dynamic for dynamic, plain in plain_table(functions).items()}
    try:
        other = put(written(changed).xreplace(back))
        wrong = any(holds(about, row, row.trees) is False for row in _equations(other, about))
    except MechanicsError:
        return None  # a negative mass, a unit that cannot be: the scene says so itself
    return Model(other, mutations, where) if wrong else None


def _constants(about: Subject) -> tuple[tuple, ...]:
    """Parameters and coordinates: places and masses hold no speeds."""
    scene = about.scene
    moving = {*scene.u, *scene.ud, *(reaction.symbol for reaction in scene.reactions)}
    groups = (tuple(s for s in group if s not in moving) for group in vocabulary(scene))
    return tuple(group for group in groups if group)


def _equations(scene: Scene, about: Subject) -> Iterator[Row]:
    """Equations of a scene in symbols that the right one has numbers for."""
    equations = derive(scene, "free_body")
    for i, residual in enumerate(equations.residual, 1):
        trees: tuple[Tree, ...] = (read(residual), read(residual * 0))
        if set().union(*map(symbols, trees)) <= about.states.all[0].keys():
            yield Row(f"row {i}", "motion", trees)


def _places(scene: Scene) -> Iterator[tuple[str, Expr, Put]]:
    """Expressions of a scene in which people make mistakes."""
    for i, body in enumerate(scene.bodies):
        with_body = partial(_with, scene, "bodies", i)

        yield f"mass of {body.name}", body.mass, _field(body, "mass", with_body)
        if isinstance(body, RigidBody) and isinstance(body.inertia, Expr):
            yield f"inertia of {body.name}", body.inertia, _field(body, "inertia", with_body)
        yield from _steps(scene, body, with_body)
    for i, load in enumerate(scene.loads):
        with_load = partial(_with, scene, "loads", i)
        for name in ("stiffness", "coefficient", "field", "vector"):
            value = getattr(load, name, None)
            if isinstance(value, Vector):
                yield from _vectors(f"load {load.name}", value, _field(load, name, with_load))
            elif value is not None:
                yield f"{name} of {load.name}", value, _field(load, name, with_load)


def _with(scene: Scene, name: str, place: int, thing: Body | Load) -> Scene:
    """A scene with another body or load in one place."""
    things = getattr(scene, name)
    changed: dict[str, Any] = {name: (*things[:place], thing, *things[place + 1 :])}
    return replace(scene, **changed)


def _field(thing: Any, name: str, put: Callable[[Any], Scene]) -> Callable[[Any], Scene]:
    return lambda value: put(replace(thing, **{name: value}))


def _steps(scene: Scene, body: Body, put: Callable[[Body], Scene]) -> Iterator[tuple]:
    """The last step to a mass centre."""
    path = point_path(scene.origin, body.centre)
    if len(path) < 2:
        return

    def moved(vector: Vector) -> Scene:
        return put(replace(body, centre=path[-2].locatenew(f"{path[-1].name} as meant", vector)))

    yield from _vectors(f"centre of {body.name}", step_vector(path[-2], path[-1]), moved)


def _vectors(where: str, vector: Vector, put: Callable[[Vector], Scene]) -> Iterator[tuple]:
    """Components of a vector in the frames in which it was given."""
    for frame, column in components(vector):
        for entry, axis in zip(column, (frame.x, frame.y, frame.z), strict=True):
            if entry != 0:
                yield (
                    where,
                    entry,
                    lambda value, entry=entry, axis=axis: put(vector + (value - entry) * axis),
                )


def _system(scene: Scene) -> System:
    """SymPy's newer way to the same equations."""
    method = kanes_method(scene)
    system = System(method._inertial)
    system.add_bodies(*method.bodies)
    system.add_loads(*method.loads)
    system.q_ind, system.u_ind = method.q, method.u
    known = method.kindiffdict()
    system.kdes = [rate - known[rate] for rate in known]
    return system


OBJECTS: tuple[tuple[str, Callable[[Scene], KanesMethod | LagrangesMethod | System]], ...] = (
    ("KanesMethod", kanes_method),
    ("LagrangesMethod", lagranges_method),
    ("System", _system),
)
"""Of scenes without constraints and without friction."""
