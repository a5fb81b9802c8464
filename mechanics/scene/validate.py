"""What can be seen to be wrong from the declaration alone.

Whether reactions do work, are complete, or constraints are redundant needs velocities, and is
checked in `mechanics.checks.admissible` before any route runs.
"""

from collections.abc import Sequence

from sympy import Symbol
from sympy.core.function import AppliedUndef
from sympy.physics.vector import Point, ReferenceFrame

from mechanics.errors import SceneError
from mechanics.nearest import instead
from mechanics.scene.bodies import RigidBody
from mechanics.scene.contacts import check_contacts
from mechanics.scene.declaration import Declaration
from mechanics.scene.declared import scalar
from mechanics.scene.geometry import Movers, frame_path, point_path
from mechanics.scene.joints.placement import check_joints
from mechanics.scene.loads import Force, Load
from mechanics.scene.namespace import check_outputs
from mechanics.scene.outputs import Velocity
from mechanics.scene.physical import check_bodies, check_loads, unit_vector
from mechanics.scene.reactions import Reaction
from mechanics.scene.symbols import name_of, plain_symbol
from mechanics.scene.units import check_units
from mechanics.scene.validity import check_conditions
from mechanics.scene.wellformed import check_names, check_symbols
from mechanics.symbolic import independent_rows


def validate(scene: Declaration) -> None:
    """Refuse a scene that cannot be right; its fields have the right types.

    Raises
    ------
    SceneError
        Names the object, what was found, and what to do.
    """
    if not scene.coordinates:
        raise SceneError(f"{scene.name}: there are no coordinates, so nothing can move")
    if not scene.bodies:
        raise SceneError(f"{scene.name}: there are no bodies, so there is nothing to move")
    check_names(scene)
    _bodies(scene)
    check_joints(scene)
    _coordinates(scene)
    _attachments(scene)
    _constraints(scene)
    _outputs(scene)
    check_symbols(scene)
    _speeds(scene)
    check_bodies(scene)
    check_loads(scene)
    _given(scene)
    check_conditions(scene)
    check_contacts(scene)
    check_units(scene)
    check_outputs(scene)
    _outlines(scene)


def _outlines(scene: Declaration) -> None:
    """What is drawn of a body moves with it."""
    for body in (body for body in scene.bodies if isinstance(body, RigidBody)):
        for outline in body.outlines:
            for vector in (outline.first, outline.second, outline.at):
                for column, frame in vector.args:
                    if frame != body.frame:
                        raise SceneError(
                            f"body {body.name}: an outline is along {frame}: write it along"
                            f" {body.frame}, the frame of the body"
                        )
                    if unknown := column.free_symbols - {*scene.parameters}:
                        raise SceneError(
                            f"body {body.name}: an outline depends on {min(unknown, key=str)}:"
                            " write it in numbers and in parameters of the scene"
                        )


def _bodies(scene: Declaration) -> None:
    for body in scene.bodies:
        try:
            point_path(scene.origin, body.centre)
            if isinstance(body, RigidBody):
                frame_path(scene.frame, body.frame)
        except SceneError as error:
            raise SceneError(f"body {body.name} is placed by nothing: {error}") from None


def _coordinates(scene: Declaration) -> None:
    """Every coordinate moves a body, and every body is moved by a coordinate or an input."""
    movers = {*scene.coordinates, *scene.inputs}
    used: set = set()
    on_way = Movers(scene.frame, scene.origin)
    for body in scene.bodies:
        # The whole path of each body: what moves the one that carries it moves it too.
        functions = on_way.point(body.centre)
        if isinstance(body, RigidBody):
            functions |= on_way.frame(body.frame)
        moved = movers & functions
        if not moved:
            raise SceneError(
                f"body {body.name}: no coordinate moves it: let its position or orientation"
                " depend on a coordinate, or leave it out"
            )
        used |= moved
    for coordinate in scene.coordinates:
        if coordinate not in used:
            raise SceneError(
                f"coordinate {name_of(coordinate)}: no body uses it: remove it or let a position"
                " or orientation depend on it"
            )


def _speeds(scene: Declaration) -> None:
    """Speeds determine the rates of the coordinates, linearly."""
    if not scene.speeds:
        return
    turning = {u for rotation in scene.rotations for u in rotation.speeds}
    wanted = len(scene.coordinates) - len(scene.rotations)
    if len(scene.speeds) != wanted:
        raise SceneError(
            f"{scene.name}: {len(scene.speeds)} speeds for {len(scene.coordinates)} coordinates:"
            f" declare as many speeds as coordinates{', less one a quaternion' if turning else ''}"
            " (constraints make some of them dependent)"
        )
    rows = []
    for speed, definition in scene.speeds:
        if speed in turning:
            continue  # A rotation has its own rates.
        what = f"speed {name_of(speed)}"
        plain = scene.rates(definition)
        row = [plain.diff(rate) for rate in scene.qd]
        second = {plain_symbol(q, 2) for q in scene.coordinates}
        if plain.free_symbols & second or any(e.free_symbols & set(scene.qd) for e in row):
            raise SceneError(f"{what}: {definition} is not linear in the rates of the coordinates")
        rows.append(row)
    kept = independent_rows(rows)
    if len(kept) < len(rows):
        lost = [name_of(u) for i, (u, _) in enumerate(scene.speeds) if i not in kept]
        raise SceneError(
            f"{scene.name}: the definitions of the speeds do not determine the rates of the"
            f" coordinates: {', '.join(lost)} follows from the others"
        )


def _given(scene: Declaration) -> None:
    """Initial values are for what there is, definitions end in parameters, the rest is known."""
    for where, expression in scene.typed:
        scene.plain(expression, where)
    names = {symbol.name for symbol in (*scene.q, *scene.u)}
    for name, value in scene.example.items():
        if name not in names:
            raise SceneError(
                f"{scene.name}: the example gives {name!r}: {instead(name, sorted(names), 'names')}"
            )
        scalar(value, f"{scene.name}: the example's {name}")
    known = names | {symbol.name for symbol in scene.input_symbols}
    for name, value in ((n, v) for rest in scene.equilibria for n, v in rest.items()):
        if name not in known:
            raise SceneError(
                f"{scene.name}: an equilibrium gives {name!r}: the names are"
                f" {', '.join(sorted(known))}"
            )
        if not scalar(value, f"{scene.name}: the equilibrium's {name}").is_number:
            raise SceneError(f"{scene.name}: the equilibrium's {name} is {value}: give a number")
    for symbol, expression in scene.definitions.items():
        if not isinstance(symbol, Symbol):
            raise SceneError(f"{scene.name}: definition of {symbol!r}: define a parameter")
        value = scalar(expression, f"{scene.name}: the definition of {symbol}")
        for _ in scene.definitions:
            value = value.xreplace(dict(scene.definitions))
        if value.free_symbols & set(scene.definitions) or value.atoms(AppliedUndef):
            raise SceneError(
                f"{scene.name}: the definition {symbol} = {expression} does not end in parameters:"
                " is it circular, or does it hold coordinates?"
            )


def _attachments(scene: Declaration) -> None:
    """Loads and reactions name bodies that exist and points that are placed."""
    bodies = {body.name for body in scene.bodies}
    groups: tuple[tuple[str, Sequence[Load | Reaction]], ...]
    acting = [action for reaction in scene.reactions for action in reaction.actions]
    groups = (("load", scene.loads), ("reaction", acting))
    for kind, parts in groups:
        for part in parts:
            for role in ("on", "by", "first_on", "second_on"):
                name = getattr(part, role, None)
                if name is not None and name not in bodies:
                    raise SceneError(
                        f"{kind} {part.name}: there is no body {name!r}:"
                        f" {instead(name, sorted(bodies), 'bodies')}"
                    )
            if isinstance(part, Force) and part.on is None and part.by is not None:
                raise SceneError(f"load {part.name}: it names by= without on=: name both")
            if isinstance(part, Reaction) and part.on == part.by:
                raise SceneError(f"reaction {part.name}: body {part.on!r} acts on itself")
            for value in vars(part).values():
                if isinstance(value, Point):
                    try:
                        point_path(scene.origin, value)
                    except SceneError as error:
                        raise SceneError(
                            f"{kind} {part.name} acts on a point that is not in the scene: {error}"
                        ) from None


def _outputs(scene: Declaration) -> None:
    """What is computed is placed, and of bodies that exist."""
    for name, output in scene.outputs.items():
        try:
            for value in vars(output).values():
                if isinstance(value, Point):
                    point_path(scene.origin, value)
                elif isinstance(value, ReferenceFrame):
                    frame_path(scene.frame, value)
            if isinstance(output, Velocity) and output.on is not None:
                scene.body(output.on)
        except SceneError as error:
            raise SceneError(f"output {name}: {error}") from None
        if isinstance(output, Velocity) and output.along is not None:
            unit_vector(scene, f"output {name}", output.along)


def _constraints(scene: Declaration) -> None:
    names = {reaction.name for reaction in scene.reactions}
    owner: dict[str, str] = {}
    for constraint in scene.constraints:
        if not constraint.reactions:
            raise SceneError(
                f"constraint {constraint.name}: it names no reaction that maintains it:"
                " declare the reaction and name it"
            )
        if len(constraint.reactions) > 1:
            raise SceneError(
                f"constraint {constraint.name}: one condition is maintained by one reaction, but"
                f" {', '.join(constraint.reactions)} are named: declare one along the gradient"
            )
        for name in constraint.reactions:
            if name not in names:
                raise SceneError(
                    f"constraint {constraint.name}: there is no reaction {name!r}: the reactions"
                    f" are {', '.join(sorted(names)) or 'none'}"
                )
            if name in owner:
                raise SceneError(
                    f"reaction {name} is named by the constraints {owner[name]} and"
                    f" {constraint.name}: each reaction maintains one"
                )
            owner[name] = constraint.name
