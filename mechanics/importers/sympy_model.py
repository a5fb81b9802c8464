"""What one of SymPy's models says, read from it and put side by side: nothing is interpreted.

System, KanesMethod, LagrangesMethod --> bodies, loads, q, u, q' = N u + n, constraints
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy.physics.mechanics as me
from sympy import Expr, Matrix, S
from sympy.physics.biomechanics.curve import CharacteristicCurveFunction
from sympy.physics.vector import Point, ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import InputError, SceneError, WrongKindError

KINDS = (me.System, me.KanesMethod, me.LagrangesMethod)


@dataclass(frozen=True)
class Acting:
    """A force at a point or a couple on a frame, as somebody declared it.

    `potential` is the body whose potential energy it comes from, None for a load.
    """

    name: str
    where: Point | ReferenceFrame
    vector: Vector
    potential: str | None = None


@dataclass(frozen=True)
class Parts:
    """One model, in SymPy's own objects.

    Attributes
    ----------
    kind : str
        Of SymPy's class, for people.
    frame : ReferenceFrame
        Inertial.
    origin : Point or None
        Where the model names one.
    bodies : tuple of RigidBody and Particle
    loads : tuple of Acting
    q, u, auxiliary : tuples of dynamic symbols
        u are the rates themselves where the model has no speeds of its own.
    rates : mapping of Expr to Expr
        q' in q, u and t, by the symbol of the rate; empty where u = q'.
    holonomic, motion : tuples of Expr
        ``expression = 0`` for positions, and for velocities.
    joints : tuple of Joint
    energy : Expr or None
        The Lagrangian, where the model has one.
    """

    kind: str
    frame: ReferenceFrame
    origin: Point | None
    bodies: tuple[Any, ...]
    loads: tuple[Acting, ...]
    q: tuple[Expr, ...]
    u: tuple[Expr, ...]
    auxiliary: tuple[Expr, ...]
    rates: Mapping[Expr, Expr]
    holonomic: tuple[Expr, ...]
    motion: tuple[Expr, ...]
    joints: tuple[Any, ...] = ()
    energy: Expr | None = None


def is_model(thing: Any) -> bool:
    """Whether it is one of SymPy's models."""
    return isinstance(thing, KINDS)


def parts_replaced(model: Any) -> str:
    """What a model has in place of SymPy's own; empty where it has nothing.

    A class derived from SymPy's with methods of its own, an attribute that hides a method; of a
    System its method, too.
    """
    kind = next(kind for kind in KINDS if isinstance(model, kind))
    for derived in type(model).__mro__:
        if derived is kind:
            break
        own = [n for n in vars(derived) if hasattr(kind, n) and n.strip("_") not in OF_CLASSES]
        if own:
            return f"{derived.__name__}.{own[0]}"
    if hidden := [name for name in vars(model) if hasattr(kind, name)]:
        return f"{hidden[0]} of the {kind.__name__}"
    inner = model.eom_method if kind is me.System else None
    return parts_replaced(inner) if inner is not None else ""


OF_CLASSES = ("module", "doc", "init", "dict", "weakref", "qualname", "abstractmethods", "abc_impl")
"""What every class has of its own, and how an object is made."""


def is_rigid(body: Any) -> bool:
    """Whether it turns: a RigidBody, and of the old class Body what has an inertia."""
    return bool(getattr(body, "is_rigidbody", isinstance(body, me.RigidBody)))


def read_model(model: Any, bodies: Sequence[Any] = ()) -> Parts:
    """What a model says.

    Parameters
    ----------
    model : System, KanesMethod or LagrangesMethod
    bodies : sequence of RigidBody and Particle
        Of a `LagrangesMethod` that was made without.

    Raises
    ------
    WrongKindError
        For another kind of object.
    SceneError
        Where the model leaves out what a scene needs.
    """
    if isinstance(model, me.System):
        return _system(model)
    if isinstance(model, me.KanesMethod):
        return _kane(model)
    if isinstance(model, me.LagrangesMethod):
        return _lagrange(model, bodies)
    raise WrongKindError(
        f"from_sympy: {type(model).__name__} found: pass a System, a KanesMethod or a"
        " LagrangesMethod of sympy.physics.mechanics"
    )


def form_equations(model: Any) -> Any:
    """SymPy's method with its equations formed; formed now if nobody did.

    Raises
    ------
    InputError
        Where nobody did, and the model does not hold what they are formed of.
    """
    if not is_formed(model):
        bodies = getattr(model, "bodies", True)
        if isinstance(model, me.KanesMethod) and not bodies:
            raise InputError(
                "KanesMethod: its equations are not formed: call kanes_equations(bodies, loads)"
            )
        if isinstance(model, me.System):
            model.form_eoms(constraint_solver="CRAMER")
        elif isinstance(model, me.KanesMethod):
            model.kanes_equations()
        else:
            model.form_lagranges_equations()
    return model.eom_method if isinstance(model, me.System) else model


def is_formed(model: Any) -> bool:
    """Whether somebody had SymPy form the equations."""
    if isinstance(model, me.System):
        return model.eom_method is not None
    if isinstance(model, me.KanesMethod):
        return bool(model._fr) and bool(model._frstar)
    return model.eom is not None


def written(expression: Any) -> Any:
    """An expression or matrix with the curves of muscles as the formulas that they stand for."""
    if expression.has(CharacteristicCurveFunction):
        return expression.doit()
    return expression


def _system(model: Any) -> Parts:
    named = [(f"load{k}", load) for k, load in enumerate(model.loads, 1)]
    for actuator in model.actuators:
        named += [(actuator.__class__.__name__.lower(), load) for load in actuator.to_loads()]
    lagrange = isinstance(model.eom_method, me.LagrangesMethod)
    given = getattr(model, "_vel_constrs", None)
    # Velocity constraints that are given stand in place of the derivatives of the others.
    motion = model.nonholonomic_constraints if given is None else model.velocity_constraints
    return Parts(
        f"System by {'Lagrange' if lagrange else 'Kane'}",
        model.frame,
        model.fixed_point,
        _bodies("System", model.bodies),
        _loads(named),
        tuple(model.q),
        tuple(model.u),
        tuple(model.u_aux),
        _solved("System", model.q, model.u, model.kdes),
        tuple(model.holonomic_constraints),
        tuple(motion),
        tuple(model.joints),
        model.eom_method._L[0] if lagrange else None,
    )


def _kane(model: Any) -> Parts:
    if not model.bodies:
        raise SceneError(
            "KanesMethod: it names no bodies: call its kanes_equations(bodies, loads) first"
        )
    motion: tuple[Expr, ...] = ()
    if model._k_nh:
        motion = tuple(model._k_nh * model.u + model._f_nh)
    return Parts(
        "KanesMethod",
        model._inertial,
        None,
        tuple(model.bodies),
        _loads([(f"load{k}", load) for k, load in enumerate(model.forcelist or (), 1)]),
        tuple(model.q),
        tuple(model.u),
        tuple(model._uaux),
        dict(model.kindiffdict()),
        tuple(model._f_h),
        motion,
    )


def _lagrange(model: Any, bodies: Sequence[Any]) -> Parts:
    given = model.bodies if model.bodies is not None else bodies
    given = given if isinstance(given, list | tuple) else [given]
    own = _bodies("LagrangesMethod", given)
    rates = [q.diff(dynamicsymbols._t) for q in model.q]
    # coneqs are the rates of the holonomic constraints, and then the others.
    motion = tuple(model.coneqs)[len(model._hol_coneqs) :]
    return Parts(
        "LagrangesMethod",
        model.inertial or _inertial(own),
        None,
        own,
        _loads([(f"load{k}", load) for k, load in enumerate(model.forcelist or (), 1)]),
        tuple(model.q),
        tuple(rates),
        (),
        {},
        tuple(model._hol_coneqs),
        motion,
        energy=model._L[0],
    )


def _bodies(kind: str, bodies: Any) -> tuple[Any, ...]:
    if not bodies:
        raise SceneError(
            f"{kind}: it names no bodies: pass from_sympy(model, bodies=(...)), or give them to"
            f" the {kind}"
        )
    return tuple(bodies)


def _inertial(bodies: Sequence[Any]) -> ReferenceFrame:
    """The frame in which all bodies have a velocity."""
    known = [list(body.masscenter._vel_dict) for body in bodies]
    common = [frame for frame in known[0] if all(frame in other for other in known)]
    if len(common) != 1:
        raise SceneError(
            "LagrangesMethod: it names no inertial frame: give it frame=, as in"
            " LagrangesMethod(L, q, frame=N)"
        )
    return common[0]


def _loads(named: Sequence[tuple[str, Any]]) -> tuple[Acting, ...]:
    found = []
    for name, (where, vector) in named:
        place = getattr(where, "masscenter", where)
        if vector != 0 and vector != Vector(0):
            found.append(Acting(name, place, vector))
    return tuple(found)


def _solved(
    kind: str, q: Sequence[Expr], u: Sequence[Expr], equations: Sequence[Expr]
) -> dict[Expr, Expr]:
    """q' from kinematical equations that are linear in it; empty where u = q'."""
    rates = [one.diff(dynamicsymbols._t) for one in q]
    if set(rates) >= set(u):
        return {}
    if len(equations) != len(rates):
        raise SceneError(
            f"{kind}: {len(equations)} kinematical equations for {len(rates)} coordinates: give one"
            " for each"
        )
    rows = Matrix(list(equations))
    slopes = rows.jacobian(rates)
    rest = rows.xreplace(dict.fromkeys(rates, S.Zero))
    return dict(zip(rates, slopes.LUsolve(-rest), strict=True))
