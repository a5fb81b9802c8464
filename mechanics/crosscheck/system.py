"""One system from scene to result: derive, compare, prove, compile, measure.

scene --> routes --> pairs, laws, ledger --> compiled graphs --> residuals --> small motions
  `--------------------> virtual power
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from sympy import Symbol

from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.checks.canaries import check_canaries
from mechanics.checks.dimensions import check_dimensions
from mechanics.checks.joints import check_joints
from mechanics.checks.ledger import QUANTITIES, check_row
from mechanics.checks.ledger_motion import check_complete, gives
from mechanics.checks.solution import proof_pays
from mechanics.checks.states import State
from mechanics.checks.virtual_power import (
    check_powers,
    check_program,
    check_virtual_power,
    drawn_states,
)
from mechanics.clock import timed
from mechanics.compiled import Model, compile, prove_compiled
from mechanics.compiled.finite import not_finite
from mechanics.crosscheck.by_sympy import by_sympy, matrix_operations
from mechanics.crosscheck.measured import NOT_CLOSED, ON_MANIFOLD, holds_others, measured
from mechanics.crosscheck.motion import example_motion
from mechanics.crosscheck.own_equations import compare_own
from mechanics.crosscheck.programs import (
    Programs,
    check_laws,
    check_textbook,
    derive_rows,
    solved,
)
from mechanics.crosscheck.routes import named_routes
from mechanics.crosscheck.small_motions import small_motions
from mechanics.crosscheck.sympy_table import too_large
from mechanics.equations import Equations
from mechanics.errors import wanted
from mechanics.importers import as_scene
from mechanics.importers.sympy_model import is_formed
from mechanics.kernel import Finding, Verdict
from mechanics.linear.ledger import OF_PROGRAMS, check_linear_row, linear_equations
from mechanics.report.result import LedgerResult, RouteResult, SystemResult
from mechanics.routes.derivation import as_program, by_route, goal_of, steps_of
from mechanics.routes.steps.one_joint import large_steps
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.scene.joints.fixed import absolute_coordinates
from mechanics.scene.potential import potential
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, ReactionValue
from mechanics.scene.system import System
from mechanics.scene.units import units_missing

DEFAULT_STATES = 100_000


def silent(stage: str) -> None:
    """Report no progress."""


@dataclass(frozen=True)
class CrossCheck:
    """What a cross-check does.

    Attributes
    ----------
    routes : tuple of str
        Names; all for none.
    states : int
        Random states at which compiled functions are put into published equations of motion.
    motion : bool
        Whether to simulate an example motion (for the report).
    progress : callable
        Called with the name of each stage.
    """

    routes: tuple[str, ...] = ()
    states: int = DEFAULT_STATES
    motion: bool = False
    progress: Callable[[str], None] = silent


def crosscheck(system: Any, options: CrossCheck | None = None) -> SystemResult:
    """Derive a system by every route and check everything that can be checked.

    Parameters
    ----------
    system : System or Scene, or a System, KanesMethod or LagrangesMethod of SymPy's
        SymPy's own equations of its model are compared with those of the scene, too; they are
        formed now if nobody did.
    options : CrossCheck, optional

    Returns
    -------
    SystemResult

    Raises
    ------
    SceneError
        When the scene cannot be right.
    SingularError
        When a route does not determine the accelerations.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, z, (m, g) = ReferenceFrame("N"), Point("O"), dynamicsymbols("z"), (
    ...     parameters("m g", "kg m/s^2", "2 9.81"))
    >>> P = O.locatenew("P", z * N.z)
    >>> stone = Scene("stone", N, O, (z,), (Particle("stone", P, m),),
    ...     loads=(gravity(-g * N.z),))
    >>> result = crosscheck(stone, CrossCheck(("kane", "lagrange"), states=0))
    >>> result.ok, list(result.routes), result.findings[0].subject
    (True, ['kane', 'lagrange'], 'kane = lagrange: accelerations')
    """
    options = options or CrossCheck()
    if isinstance(system, System):
        made = (system.model or system.scene)()
        scene = as_scene(made, system.name)
    else:
        made, scene = system, as_scene(system)
        wanted(scene, (System, Scene), "crosscheck", "pass a scene, or one of systems.ALL")
        system = System(scene.name, lambda: scene)

    def stage(words: str) -> None:
        options.progress(f"{system.name}: {words}")

    stage("checking the scene")
    mechanism = check_scene(scene)
    names = [route.name for route in named_routes(options.routes)]
    programs = derive_rows(mechanism, names, stage)
    derived, seconds = _equations(scene, programs, stage)
    own, told = _own(scene, made, programs, stage)
    notes = [f"Note: {note}." for note in scene.notes]
    told = (*notes, *told, *absolute_coordinates(scene))
    if any(equations.textbook is None for equations in derived.values()):
        return _without_textbook(system, derived, programs, own, told, stage, options.motion)
    stage("comparing routes")
    pairs = compare_pairs(programs.routes)
    sympy = by_sympy(scene, programs, pairs, stage)
    pairs |= sympy.pairs
    findings = [*own, *pairs.values(), *check_textbook(programs, derived), *check_laws(programs)]
    stage("the scene as declared")
    witnesses = tuple(_witnesses(scene, derived))
    stage("published equations")
    rows, skipped = _answerable(scene, system.published, derived)
    published = tuple(_ledger(scene, rows, derived))
    motions = [row for row in system.published if isinstance(row.quantity, EquationOfMotion)]
    if motions:
        findings.append(check_complete(scene, motions, next(iter(derived.values()))))
    stage("compiling")
    models = {name: compile(equations) for name, equations in derived.items()}
    findings += _graphs(models)
    findings += check_dimensions(scene, system.published, _units(models))
    stage("residuals of compiled functions")
    shown = (Verdict.PROVED, Verdict.CERTIFIED)
    right = [entry.row for entry in published if entry.finding.verdict in shown]
    holding = [row for row in motions if row in right and not holds_others(scene, row)]
    left = measured(scene, models, holding, options.states)
    if left and not scene.constraints:
        lost = not_finite(tuple(models.values()), states=options.states)
        findings += [entry.finding for entry in lost]
    stage("small motions")
    modes, remarks = small_motions(derived)
    remarks = (*told, *skipped, *remarks)
    if holding and options.states and scene.constraints:
        remarks += (ON_MANIFOLD if left else NOT_CLOSED,)
    if any(row in right and holds_others(scene, row) for row in motions):
        remarks += ("Residuals of equations that hold a reaction or a momentum are not measured.",)
    remarks += (
        *units_missing(scene),
        _written(models),
        f"Compiled functions are evaluated by {_preferred(models).backend}.",
    )
    motion = None
    if options.motion:
        stage("simulating")
        motion, remark = example_motion(_preferred(models))
        remarks += remark
    form = goal_of(list(derived.values()))
    return SystemResult(
        name=system.name,
        scene=scene,
        form=form,
        routes={
            name: RouteResult(
                equations,
                seconds[name],
                matrix_operations(models[name]),
                models[name].form,
                models[name].program("forward_dynamics").operations,
                steps=steps_of(equations, form),
            )
            for name, equations in derived.items()
        },
        findings=tuple(findings),
        published=published,
        compiled=left,
        modes=modes,
        motion=motion,
        remarks=remarks,
        pairs=pairs,
        witnesses=witnesses,
        sympy=sympy.columns,
        causes=tuple(own[1:]),
    )


def _own(
    scene: Scene, made: Any, programs: Programs, stage: Callable[[str], None]
) -> tuple[list[Finding], tuple[str, ...]]:
    """SymPy's own equations of the model that a scene is made from, and why there are none."""
    if isinstance(made, Scene):
        return [], ()
    why_not = "" if is_formed(made) else too_large(programs.mechanism, "kane_sympy")
    if why_not:
        return [], (
            f"SymPy's own equations are not compared: {why_not}; have the model form them.",
        )
    stage("SymPy's own equations")
    return compare_own(scene, made, programs), ()


def _without_textbook(
    system: System,
    derived: Mapping[str, Equations],
    programs: Programs,
    own: Sequence[Finding],
    told: Sequence[str],
    stage: Callable[[str], None],
    moves: bool,
) -> SystemResult:
    """Of a scene that is too large to be written out by SymPy: the routes are programs alone."""
    first = next(iter(derived.values()))
    scene = first.scene
    stage("comparing routes")
    pairs = compare_pairs(programs.routes)
    sympy = by_sympy(scene, programs, pairs, stage)
    pairs |= sympy.pairs
    findings = [*own, *pairs.values(), *check_laws(programs)]
    remarks = [*told, "The equations are too long to be written out, and stay programs."]
    remarks += units_missing(scene)
    stage("compiling")
    model = compile(first)
    # Without constraints and friction programs come from the mechanism, whatever the route.
    tree = not (scene.constraints or frictions(scene))
    models = {
        name: model if tree or equations is first else compile(equations)
        for name, equations in derived.items()
    }
    findings += prove_compiled(model, [name for name in model.casadi if name != "step"])
    stage("the scene as declared")
    states = drawn_states(scene)
    witnesses = [
        *_declared(scene, states),
        *(check_program(scene, name, solved(programs, name), states) for name in programs.routes),
    ]
    stage("published equations")
    kinds = (*QUANTITIES, *OF_PROGRAMS)
    known = tuple(row for row in system.published if isinstance(row.quantity, kinds))
    if len(known) < len(system.published):
        remarks.append(
            "Published rows about linear equations are not checked: they need formulas of these."
        )
    support = programs.route("free_body").rows
    equations = as_program(scene, programs.mechanism, support)
    linear = next((e for e in derived.values() if e.conjugate), first)
    linears = linear_equations(known, linear)
    published = tuple(
        LedgerResult(
            row,
            check_linear_row(scene, row, linear, linears)
            if isinstance(row.quantity, OF_PROGRAMS)
            else check_row(scene, row, equations),
        )
        for row in known
    )
    motions = [row for row in known if isinstance(row.quantity, EquationOfMotion)]
    if motions:
        findings.append(check_complete(scene, motions, equations))
    steps = large_steps(scene, programs.mechanism)
    motion = None
    if moves:
        stage("simulating")
        motion, remark = example_motion(model)
        remarks += remark
    return SystemResult(
        name=system.name,
        scene=scene,
        routes={
            name: RouteResult(
                None,
                programs.seconds[name],
                programs.operations(name),
                models[name].form,
                models[name].program("forward_dynamics").operations,
                steps=steps.get(name, ()),
            )
            for name in programs.routes
        },
        findings=tuple(findings),
        published=published,
        motion=motion,
        remarks=tuple(remarks),
        pairs=pairs,
        witnesses=tuple(witnesses),
        sympy=sympy.columns,
        causes=tuple(own[1:]),
    )


def _equations(
    scene: Scene, programs: Programs, stage: Callable[[str], None]
) -> tuple[dict[str, Equations], dict[str, float]]:
    derived, seconds = {}, {}
    for route in named_routes(tuple(programs.routes)):
        stage(f"writing out {route.name}")
        rows = programs.routes[route.name].rows
        derived[route.name], own = timed(partial(route.equations, scene, programs.mechanism, rows))
        seconds[route.name] = programs.seconds[route.name] + own
    return derived, seconds


def _declared(scene: Scene, states: Sequence[State]) -> Iterator[Finding]:
    """This program, and the joints, loads and reactions of a scene, whatever the routes say."""
    yield from check_canaries()
    yield from check_joints(scene, states)
    yield from check_powers(scene, states, potential(scene))


def _witnesses(scene: Scene, derived: Mapping[str, Equations]) -> Iterator[Finding]:
    states, support = drawn_states(scene), derived.get("free_body")
    if support is None and frictions(scene):
        support = by_route("free_body", scene)
    yield from _declared(scene, states)
    for equations in derived.values():
        yield check_virtual_power(equations, states, support)


def _answerable(
    scene: Scene, rows: Sequence[Published], derived: Mapping[str, Equations]
) -> tuple[tuple[Published, ...], tuple[str, ...]]:
    """Rows that the routes can answer, and remarks about the others.

    A reaction that does not exist is answerable: by a refusal.
    """
    declared = {reaction.name for reaction in scene.reactions}
    kept, remarks = [], []
    for row in rows:
        name = row.quantity.name if isinstance(row.quantity, ReactionValue) else ""
        if name not in declared or any(gives(e, name) for e in derived.values()):
            kept.append(row)
        else:
            remarks.append(
                f"Row {row.tag} is not checked: no route that was asked for gives the reaction"
                f" {name}; free_body does."
            )
    return tuple(kept), tuple(remarks)


def _ledger(
    scene: Scene, rows: Sequence[Published], derived: Mapping[str, Equations]
) -> Iterator[LedgerResult]:
    """Each row with the route that has what the row needs: reactions, or conjugate rows."""
    first = next(iter(derived.values()))
    mechanical = derived.get("free_body", first)
    linear = next((e for e in derived.values() if e.conjugate), first)
    linears = linear_equations(rows, linear)
    for row in rows:
        if isinstance(row.quantity, ReactionValue):
            name = row.quantity.name
            source = next((e for e in derived.values() if gives(e, name)), first)
            yield LedgerResult(row, check_row(scene, row, source))
        elif isinstance(row.quantity, QUANTITIES):
            yield LedgerResult(row, check_row(scene, row, mechanical))
        else:
            yield LedgerResult(row, check_linear_row(scene, row, linear, linears))


def _graphs(models: Mapping[str, Model]) -> Iterator[Finding]:
    """Forward dynamics of every route; everything else that a model has, once."""
    for model in models.values():
        chosen: tuple[str, ...] | None = ("forward_dynamics",)
        if model is _preferred(models):
            chosen = None
        elif model.equations.reactions:
            chosen = ("forward_dynamics", "reactions")
        pays = proof_pays(model.equations.scene)
        yield from prove_compiled(model, chosen, try_normal=pays)


def _preferred(models: Mapping[str, Model]) -> Model:
    """The model that is simulated: Kane's has the fewest operations."""
    return models.get("kane", next(iter(models.values())))


def _written(models: Mapping[str, Model]) -> str:
    """In which form forward dynamics was compiled, route by route."""
    routes: dict[tuple[int, str], list[str]] = {}
    for name, model in models.items():
        count = model.program("forward_dynamics").operations
        routes.setdefault((count, model.form), []).append(name)
    parts = [
        f"{count} operations by {', '.join(names)} (form {form})"
        for (count, form), names in routes.items()
    ]
    choice = ": --route chooses" if len(parts) > 1 else ""
    return f"An evaluation of forward dynamics takes {'; '.join(parts)}{choice}."


def _units(models: Mapping[str, Model]) -> dict[Symbol, str]:
    """Of everything that a row may hold: what one route does not solve for, another does."""
    known = [model.quantities for model in models.values()]
    groups = [(k.q, k.u, k.ud, k.inputs, k.p, k.multipliers, k.reactions) for k in known]
    return {e.symbol: e.unit for of_one in groups for group in of_one for e in group if e.unit}
