"""Units of parameters, and whether what is declared with them has the dimension that it must have.

    mass kg,   inertia kg m^2,   place m,   field m/s^2,   force N,   torque N m,
    spring N/m,   torsion spring N m/rad,   damper N s/m,   friction 1

Angles have no dimension. Where a unit is not stated, or a coordinate enters, nothing is known and
nothing is said; published equations are checked by `mechanics.checks.dimensions`.
"""

from collections.abc import Iterator
from itertools import pairwise

from sympy import Add, Expr, Mul, Pow, S, Symbol, cos, exp, sin, sympify, tan
from sympy.core.function import AppliedUndef
from sympy.physics.vector import Vector

from mechanics.errors import SceneError
from mechanics.scene.bodies import RigidBody, inertia_entries
from mechanics.scene.declaration import Declaration
from mechanics.scene.geometry import (
    components,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.loads import Coulomb, Damper, Force, Gravity, Spring, Torque, TorsionSpring
from mechanics.scene.outputs import Orientation
from mechanics.scene.symbols import plain_symbol
from mechanics.scene.unit_names import Dimension, dimension_of_unit, words

NONE = dimension_of_unit("1", "")
PLAIN = (sin, cos, tan, exp)
"""Functions whose values are numbers: beside a factor with a unit they have none."""


def check_units(scene: Declaration) -> None:
    """Refuse declarations whose dimension is known and wrong.

    Raises
    ------
    SceneError
        Names what is declared, its expression, and the unit that it must have.
    """
    for where, expression, unit in declared(scene):
        found = dimension(scene, expression, where)
        if found is not None and found != dimension_of_unit(unit, where):
            raise SceneError(
                f"{where}: {expression} has the unit {words(found)}, not {unit}: correct the"
                " expression, or the units of its parameters"
            )
    for constraint in scene.constraints:
        dimension(scene, constraint.expression, f"constraint {constraint.name}")


def inferred(scene: Declaration) -> dict[Symbol, Dimension]:
    """Dimensions of parameters: as declared, else as masses, places and loads need them.

    Of a product with one parameter whose unit is not stated, that one's follows.
    """
    texts = {p: getattr(p, "unit", "") for p in scene.parameters}
    known = {p: d for p, t in texts.items() if (d := dimension_of_unit(t, str(p))) is not None}
    needs = [
        (term, dimension_of_unit(unit, where))
        for where, expression, unit in declared(scene)
        for term in Add.make_args(sympify(scene.definitions.get(expression, expression)))
    ]
    size = -1
    while size < len(known) < len(texts):
        size = len(known)
        for term, need in needs:
            powers = term.as_powers_dict()
            unknown = [s for s in powers if s in texts and s not in known]
            others = [b for b in powers if not (b in texts or b.is_number or isinstance(b, PLAIN))]
            if need is None or others or len(unknown) != 1 or not powers[unknown[0]].is_Rational:
                continue
            (one,) = unknown
            rest = list(need)
            for base, power in powers.items():
                if base in known:
                    rest = [r - power * e for r, e in zip(rest, known[base], strict=True)]
            known[one] = tuple(r / powers[one] for r in rest)
    return known


def units_missing(scene: Declaration) -> tuple[str, ...]:
    """What is not checked because no unit is declared."""
    names = ", ".join(p.name for p in scene.parameters if not getattr(p, "unit", ""))
    words = f"No unit is declared for {names}: what is added to them may have any dimension."
    return (words,) if names else ()


def dimension(scene: Declaration, expression: Expr, where: str) -> Dimension | None:
    """Dimension of an expression in parameters; None where it is not known.

    Raises
    ------
    SceneError
        For a sum of terms of different dimensions.
    """
    if expression in scene.definitions and not getattr(expression, "unit", ""):
        return dimension(scene, sympify(scene.definitions[expression]), where)
    if expression.is_Symbol:
        return dimension_of_unit(getattr(expression, "unit", ""), where)
    if isinstance(expression, Pow) and expression.exp.is_Rational:
        base = dimension(scene, expression.base, where)
        return None if base is None else tuple(expression.exp * entry for entry in base)
    if isinstance(expression, Mul):
        factors = [
            dimension(scene, factor, where)
            for factor in expression.args
            if not (factor.is_number or isinstance(factor, PLAIN))
        ]
        if not factors or any(factor is None for factor in factors):
            return None
        return tuple(Add(*column) for column in zip(*(f for f in factors if f), strict=True))
    if isinstance(expression, Add):
        return _sum(scene, expression, where)
    return None


def _sum(scene: Declaration, expression: Add, where: str) -> Dimension | None:
    known: Dimension | None = None
    for term in expression.args:
        found = dimension(scene, term, where)
        if found is not None and known is not None and found != known:
            raise SceneError(
                f"{where}: {expression} adds {words(known)} and {words(found)}: correct it, or the"
                " units of its parameters"
            )
        known = found or known
    return known


def rolled(scene: Declaration) -> set[Symbol]:
    """Lengths that turn something: a wheel turned by x/R, where the unit of R is declared."""
    found: set[Symbol] = set()
    for body in scene.bodies:
        steps = [column for parent, child in pairwise(point_path(scene.origin, body.centre))
                 for _, column in components(step_vector(parent, child))]  # fmt: skip
        if isinstance(body, RigidBody):
            frames = pairwise(frame_path(scene.frame, body.frame))
            steps += [relative_rotation(parent, child) for parent, child in frames]
        for function in set().union(*(step.atoms(sin, cos) for step in steps)):
            for q in function.atoms(AppliedUndef) & {*scene.coordinates}:
                unit = dimension(scene, function.args[0].diff(q), body.name)
                found |= {plain_symbol(q)} if unit not in (None, NONE) else set()
    return found


def ratios(scene: Declaration) -> set[Symbol]:
    """Coordinates that have no unit: of a place at l (1 + nu), where the unit of l is declared."""
    metre = dimension_of_unit("m", "")
    return {q for q, slope in _slopes(scene) if dimension(scene, slope, str(q)) == metre}


def lengths(scene: Declaration) -> set[Symbol]:
    """Coordinates that are lengths for sure: x of a place at x or x cos(theta)."""
    return {
        q for q, slope in _slopes(scene)
        if not slope.replace(lambda e: isinstance(e, PLAIN), lambda _: S.One).free_symbols
        & {*scene.parameters}
    }  # fmt: skip


def _slopes(scene: Declaration) -> Iterator[tuple[Symbol, Expr]]:
    """Coordinates, and how places grow with them."""
    for _, place, unit in declared(scene):
        for q in place.atoms(AppliedUndef) & {*scene.coordinates} if unit == "m" else ():
            yield plain_symbol(q), place.diff(q)


def declared(scene: Declaration) -> Iterator[tuple[str, Expr, str]]:
    """What is declared, its expression, and the unit that it must have."""
    for body in scene.bodies:
        where = f"body {body.name}"
        yield f"{where}, mass", sympify(body.mass), "kg"
        if isinstance(body, RigidBody):
            for entry in inertia_entries(body):
                yield f"{where}, inertia", sympify(entry), "kg*m^2"
    outputs = (o for o in scene.outputs.values() if not isinstance(o, Orientation))
    for end in dict.fromkeys((*(b.centre for b in scene.bodies), *(o.point for o in outputs))):
        for parent, child in pairwise(point_path(scene.origin, end)):
            yield from _entries(f"point {child.name}", step_vector(parent, child), "m")
    for load in scene.loads:
        where = f"load {load.name}"
        if isinstance(load, Gravity):
            yield from _entries(where, load.field, "m/s^2")
        elif isinstance(load, Spring):
            yield f"{where}, stiffness", sympify(load.stiffness), "N/m"
            yield f"{where}, length", sympify(load.length), "m"
        elif isinstance(load, Damper):
            yield f"{where}, coefficient", sympify(load.coefficient), "N*s/m"
        elif isinstance(load, Coulomb):
            yield f"{where}, coefficient", sympify(load.coefficient), "1"
            yield f"{where}, sliding velocity", sympify(load.sliding), "m/s"
        elif isinstance(load, TorsionSpring):
            yield f"{where}, stiffness", sympify(load.stiffness), "N*m/rad"
        elif isinstance(load, Force):
            yield from _entries(where, load.vector, "N")
        elif isinstance(load, Torque):
            yield from _entries(where, load.vector, "N*m")


def _entries(where: str, vector: Vector, unit: str) -> Iterator[tuple[str, Expr, str]]:
    for _, column in components(vector):
        yield from ((where, entry, unit) for entry in column if entry != 0)
