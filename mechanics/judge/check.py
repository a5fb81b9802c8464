"""A person's own equations, checked against what the engine derives from the scene.

statements  --ledger-->  PROVED, CERTIFIED, REFUTED with a witness, UNDECIDED
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from mechanics.blame.reference import Reference
from mechanics.claims.code.around.callers import callers
from mechanics.claims.declared_conventions import Declared
from mechanics.claims.statement import Reading
from mechanics.compiled.fixed import fix
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.errors import wanted
from mechanics.importers import as_scene
from mechanics.judge.at_values import Values, as_identity
from mechanics.judge.black_box import check_box
from mechanics.judge.blame_at_values import with_values
from mechanics.judge.bounded_blame import blamed, declared_only
from mechanics.judge.complete import redundancy
from mechanics.judge.converted_rows import moves_more
from mechanics.judge.declared_convention import only_change
from mechanics.judge.definedness import at_the_bound
from mechanics.judge.judgement import judgement_on
from mechanics.judge.left_potentials import left_potentials
from mechanics.judge.linearized_blame import linearized
from mechanics.judge.other_names import doubtful
from mechanics.judge.polar_radius import with_positive_radii
from mechanics.judge.question import question_of
from mechanics.judge.rounded_code import NOTES
from mechanics.judge.scene_laws import verify
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.sentences import located
from mechanics.scene import Scene
from mechanics.scene.system import System


def derived(scene: Scene) -> Equations:
    """What statements about a scene are compared with: the route that has the reactions."""
    return derive(with_positive_radii(scene)[0], "free_body")


def check(
    scene: Any,
    equations: Any,
    *,
    names: Mapping[str, str] | None = None,
    notation: str | None = None,
    about: str | None = None,
    convention: Sequence[str] | str = (),
    function: str | None = None,
    values: Mapping[str, Any] | None = None,
    where: Sequence[str] | str = (),
    only: Sequence[str] | str = (),
    blame: bool = True,
) -> Check:
    r"""Check a person's equations of motion, energies, reactions or mass matrix.

    Parameters
    ----------
    scene : Scene, System, Equations or Reference, or a model of SymPy's
        What they are about. The laws of a scene are verified before anything is judged; equations
        that were derived already are taken as they are, which saves the time of both, a
        `mechanics.blame.reference.Reference` to them what blame makes of them, too. Where they stay
        a program, statements are judged as they stand: nothing is said of what would mend them.
    equations : str, Path, SymPy object, function, or a sequence of them
        LaTeX, or text in SymPy's or MATLAB's notation, or the path of a file with such a text, or
        with C (``.c``); an expression, equation, matrix, `KanesMethod`, `LagrangesMethod` or
        `System` of SymPy's, or what `sympy.solve` returns; a CasADi `Function`; a Python function
        on numbers and NumPy arrays, which is traced; a `BlackBox`, which is only called.
    names : mapping of str to str, optional
        The person's names and the scene's: ``{"phi": "theta", "w": "theta_dot"}``; for an argument
        of code that is a vector, several: ``{"state": "x x_dot theta theta_dot"}``. What is not
        given is the same name, or the best guess, which the result tells. The generalized momentum
        of a coordinate theta is ``"p_theta"``: ``{"pi_1": "p_theta"}``.
    notation : str, optional
        ``"latex"``, ``"text"`` or ``"c"``, where that is not plain.
    about : str, optional
        What they are, where that is not plain: ``"kinetic energy"``, ``"mass matrix"``, ...
    function : str, optional
        Which function of a C file; its last one when not given.
    convention : str or sequence of str
        How the person counts otherwise than the scene: ``"other vertical"``,
        ``"half-length of L"``, ``"right horizontal, counterclockwise"``, ... One choice for all
        equations; what is left open (``"from the horizontal"``) is shown only where equations hold
        in every sense. Without it, equations that would be right under such a change are REFUTED,
        and the result says under which change.
    values : mapping of str to number, optional
        Values of parameters, ``{"g": 9.81}``: the statements are judged where the scene has these.
    where : str or sequence of str
        What holds of coordinates and parameters, ``"cos(phi) > 0"``: equations are judged there
        only, and the result says so. One branch of a loop, for example.
    only : str or sequence of str
        Which statements of a page the verdict is on: a number (``"(6)"``), lines (``"line 12"``,
        ``"lines 5-8"``), or what stands on the left (``"theta_ddot"``). All of the page is read
        for what letters mean; what is not chosen is named in the result. Sentences that deny or
        limit count where they stand beside what is chosen; ``"formulas"`` sets them aside, but for
        labels of the formulas.
    blame : bool
        Whether to look for what is wrong with what is refuted, and for the edit that mends it.

    Returns
    -------
    Check

    Raises
    ------
    InputError
        When nothing can be read, by line and column.
    SceneError
        When the scene cannot be right, or what was derived is not what it declares.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> answer = check(rod_pendulum.scene(), r"m l^2/3 \ddot\theta = m g l/2 \sin\theta + u")
    >>> answer.verdict.name
    'PROVED'
    >>> check(rod_pendulum.scene(), "theta'' = g/l*sin(theta)", blame=False).verdict.name
    'REFUTED'
    """
    reference, untried = _reference(as_scene(scene))
    truth = reference.truth
    question = question_of(
        truth, equations, names=names, notation=notation, about=about, convention=convention,
        function=function, values=values, where=where, only=only,
    )  # fmt: skip
    boxed = [check_box(truth, box, names) for box in question.boxes]
    found = judgement_on(question)
    judged = found.judged
    searched = question.written_out or _operations(truth) <= LARGEST_SEARCHED
    if blame and searched:
        judged = _blamed(reference, judged, question.counted, question.values)
    judged = (*judged, *(Judged(s, f) for entries, _ in boxed for s, f in entries))
    matched = (*question.names_taken, *(match for _, some in boxed for match in some))
    matches = {match.name: match for match in matched}
    remarks = (
        *dict.fromkeys(r for reading in question.readings for r in reading.remarks),
        *(f"the text says how it counts: {said.told}" for said in question.by_prose),
        *_remarks_on_refuted(question.readings, judged, searched),
        *(NOTES[name] for name in question.of_code),
        *found.remarks,
        *dict.fromkeys(left_potentials(truth.scene, judged)),
        *_remarks_on_motion(truth, judged),
        *untried,
        *(words for one in question.files for words in callers(one.code, ".py", one.judged)),
    )
    beside = question.beside
    unjudged = (*question.prose.unjudged, *_definitions(question.readings), *beside)
    shown = truth if question.written_out else None
    return Check(
        truth.scene, judged, tuple(matches.values()), remarks, shown, unjudged, beside,
        (*map(located, found.others), *found.limits), found.hints, found.others,
    )  # fmt: skip


def _remarks_on_refuted(
    readings: Sequence[Reading], judged: Sequence[Judged], searched: bool
) -> tuple[str, ...]:
    """What a person needs to know of how a refuted statement was read and searched."""
    if all(entry.finding.verdict is not Verdict.REFUTED for entry in judged):
        return ()
    return (*doubtful(readings), *(() if searched else (TOO_LARGE,)))


def _remarks_on_motion(truth: Equations, judged: Sequence[Judged]) -> tuple[str, ...]:
    """Whether rows say the same twice, and where roundings of code may leave a root's domain."""
    twice = redundancy(truth, judged)
    bounds = (r for e in judged for r in at_the_bound(truth, e.statement, e.finding))
    return (*((twice,) if twice else ()), *dict.fromkeys(bounds))


def _reference(
    scene: Scene | System | Equations | Reference,
) -> tuple[Reference, tuple[str, ...]]:
    """What statements are compared with, and what is to be said of its scene."""
    if isinstance(scene, Reference):
        return scene, ()
    kinds = (Scene, System, Equations)
    wanted(scene, kinds, "check", "pass a scene, or one of systems.ALL")
    if isinstance(scene, Equations):
        return Reference(scene), ()
    plain, told = with_positive_radii(
        as_scene(scene.scene()) if isinstance(scene, System) else scene
    )
    truth = derived(plain)
    return Reference(truth), (*told, *verify(truth))


def _definitions(readings: Sequence[Reading]) -> dict[str, None]:
    """Definitions of texts that nothing uses."""
    return dict.fromkeys(words for reading in readings for words in reading.unjudged)


LARGEST_SEARCHED = 800
"""Operations of a scene's rows up to which mistakes are looked for where these stay a program; a
quadrotor takes 658, a bicycle 2667."""
TOO_LARGE = "no term-by-term search is made for a scene of this size: its equations stay a program"


def _operations(truth: Equations) -> int:
    """How many operations the rows of a scene take; more than any limit where they are unknown."""
    if truth.mechanism is None or truth.rows is None:
        return LARGEST_SEARCHED + 1
    return truth.mechanism.builder.program({"rows": truth.rows.values}).count


def _blamed(
    reference: Reference, judged: tuple[Judged, ...], counted: Sequence[Declared], values: Values
) -> tuple[Judged, ...]:
    """What is wrong, in the person's symbols: as they are counted, or with their values.

    Edits are those that make a statement right everywhere, on one branch too.
    """
    truth, statements = reference.truth, [entry.statement for entry in judged]
    if not (counted or values):
        found = with_values(reference, blamed(reference, judged))
        return tuple(linearized(reference, entry) for entry in found)
    if any(e.statement.derived and e.finding.verdict is Verdict.REFUTED for e in judged):
        return declared_only(judged, "statements under a declared convention")
    if any(s.row is not None and moves_more(truth.scene, s.row) for s in statements):
        return declared_only(judged, "statements about momenta, a mass matrix or declared speeds")
    if values:
        rows = (s.row and as_identity(truth, s.row) for s in statements)
        plain = [replace(e, statement=replace(e.statement, row=row))
                 for e, row in zip(judged, rows, strict=True)]  # fmt: skip
        found = blamed(Reference(fix(truth, values)), plain, values)
        return tuple(replace(e, blame=f.blame) for e, f in zip(judged, found, strict=True))
    change = only_change(truth, statements, counted)
    if change is None:
        return declared_only(judged, "several conventions are possible")
    return blamed(Reference(change[1]), judged, change[0])
