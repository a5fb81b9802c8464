"""A person's own equations, checked against what the engine derives from the scene.

statements  --ledger-->  PROVED, CERTIFIED, REFUTED with a witness, UNDECIDED
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain
from typing import Any

from mechanics.blame.reference import Reference
from mechanics.claims.code.black_box import BlackBox
from mechanics.claims.code.callers import callers
from mechanics.claims.code.python_lines import lines_around
from mechanics.claims.declared_conventions import Declared, read_declared
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.claims.statement import Reading, Statement
from mechanics.compiled.fixed import fix
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.errors import InputError, wanted
from mechanics.importers import as_scene
from mechanics.judge.at_rest import at_rest
from mechanics.judge.at_values import Values, as_identity, read_values, right_at, small_angles_at
from mechanics.judge.at_values import words as in_words
from mechanics.judge.black_box import check_box
from mechanics.judge.blame_at_values import with_values
from mechanics.judge.bounded_blame import blamed, declared_only
from mechanics.judge.choice import chosen, judged_only, read_choice
from mechanics.judge.complete import complete_residuals, determines, redundancy
from mechanics.judge.converted_rows import moves_more
from mechanics.judge.declared_convention import Answer, judge_under, only_change
from mechanics.judge.defined_meanings import as_meant
from mechanics.judge.definedness import at_the_bound
from mechanics.judge.described_guesses import described_guesses
from mechanics.judge.energy_letters import with_energy_letters
from mechanics.judge.energy_parts import of_a_part
from mechanics.judge.frequencies import one_root_each
from mechanics.judge.guesses import other_guesses
from mechanics.judge.left_potentials import left_potentials
from mechanics.judge.letters import Settled, settle
from mechanics.judge.linearized_blame import linearized
from mechanics.judge.one_document import of_one_document
from mechanics.judge.options import refuse_unused
from mechanics.judge.other_conventions import helpful_changes
from mechanics.judge.other_names import best_names, doubtful
from mechanics.judge.other_reading import left_open, of_one_dimension, other_readings
from mechanics.judge.polar_radius import with_positive_radii
from mechanics.judge.prose import Prose, as_told, limits_on, prose_of, seen_from_one_side
from mechanics.judge.readers import read, spread
from mechanics.judge.rounded_code import NOTES, as_rounded, code_conventions
from mechanics.judge.scene_laws import verify
from mechanics.judge.single import judge
from mechanics.judge.small_angles import as_said, right_for_small_angles
from mechanics.judge.sources import Around, file_of, source_of
from mechanics.judge.special_case import in_special_case
from mechanics.judge.standard_names import with_standard_names
from mechanics.judge.suggested_choice import suggested
from mechanics.judge.unused_values import unused_values
from mechanics.judge.where import Where, judge_where, read_where, right_where
from mechanics.kernel import Finding, Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.judged import Judged, differs
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
    truth, things = reference.truth, spread(equations)
    written_out = truth.textbook is not None
    if not written_out:
        _plain(things, convention=convention, values=values, where=where)
    choice = read_choice(only)
    if (convention or where or choice) and any(isinstance(thing, BlackBox) for thing in things):
        raise InputError("check: a black box is only called: leave out convention, where and only")
    of_code, convention = code_conventions(convention)
    asked = {"function": function, "notation": notation, "about": about, "values": values}
    refuse_unused(things, notation, [*(name for name, value in asked.items() if value), *of_code])
    boxed = [check_box(truth, thing, names) for thing in things if isinstance(thing, BlackBox)]
    parts = [thing for thing in things if not isinstance(thing, BlackBox)]
    readings = of_one_document(
        parts, [_read(truth, part, names, notation, about, function) for part in parts]
    )
    every = [s for reading in readings for s in reading.statements]
    statements = with_energy_letters(truth, of_one_dimension(truth, every))
    is_chosen = chosen(choice, statements)
    if sum(map(bool, (values, convention, where))) > 1:
        raise InputError(
            "--value (values=), --convention (convention=) and --where (where=) exclude each other:"
            " give one"
        )
    known = [match for reading in readings for match in reading.names]
    declared = read_declared(convention, known)
    sources = [source for part in parts for source in source_of(part)]
    prose = prose_of(truth.scene, statements, known, sources)
    explicit = declared or values or where or not written_out
    in_prose = () if explicit else prose.conventions
    counted = (*declared, *in_prose)
    numbers = read_values(truth.scene, values or {})
    texts = [where] if isinstance(where, str) else where
    region = read_where(truth, texts, known, names or {})
    verdicts = partial(_verdicts, truth, counted=counted, values=numbers, where=region)
    judged, remarks_of_verdicts = verdicts(statements, helps=written_out)
    if in_prose:
        pairs = zip(judged, statements, strict=True)
        judged = tuple(seen_from_one_side(truth.scene, e, s, known) for e, s in pairs)
    judged = complete_residuals(truth, one_root_each(truth, judged, statements))
    limits = [limits_on(prose, s, alone=bool(choice), formulas=choice.formulas) for s in statements]
    against = () if convention else _against(prose, written_out)
    files = [part for part in parts if isinstance(part, Around)]
    whole = [*sources, *(one for part in parts for one in file_of(part))]
    against += tuple(dict.fromkeys(described_guesses(truth.scene, known, whole)))
    without_limits = tuple(of_a_part(truth.scene, as_told(entry, against)) for entry in judged)
    judged = tuple(
        of_a_part(truth.scene, as_told(entry, (*against, *some)))
        for entry, some in zip(judged, limits, strict=True)
    )
    tries = written_out and not (counted or region)
    readings_beside = chain(
        other_guesses(truth, judged, readings, statements, numbers, tries),
        other_readings(truth, statements, not numbers),
    )
    judged = left_open(judged, readings_beside, lambda some: verdicts(some, helps=False)[0])
    judged = as_meant(as_rounded(judged, of_code))
    judged = with_standard_names(truth, judged, numbers) if tries else judged
    if tries and not numbers:
        judged = in_special_case(truth, judged)
    hints = () if choice else suggested(prose, without_limits, judged)
    judged, others = judged_only(judged, is_chosen)
    effective = {words for some in limits for words in some}
    aside = tuple(limit.sentence for limit in prose.limits if limit.words not in effective)
    searched = written_out or _operations(truth) <= LARGEST_SEARCHED
    if blame and searched:
        judged = _blamed(reference, judged, counted, numbers)
    judged = (*judged, *(Judged(s, f) for entries, _ in boxed for s, f in entries))
    matched = chain(*(reading.names for reading in readings), *(some for _, some in boxed))
    matches = {match.name: match for match in matched}
    remarks = (
        *dict.fromkeys(r for reading in readings for r in reading.remarks),
        *(f"the text says how it counts: {said.told}" for said in in_prose),
        *_remarks_on_refuted(readings, judged, searched),
        *(NOTES[name] for name in of_code),
        *remarks_of_verdicts,
        *dict.fromkeys(left_potentials(truth.scene, judged)),
        *_remarks_on_motion(truth, judged),
        *untried,
        *(words for one in files for words in callers(one.code, ".py", one.judged)),
    )
    around = [_around(part, truth.scene, names or {}, known) for part in files]
    beside = tuple(dict.fromkeys(chain(*(reading.beside for reading in readings), *around)))
    unjudged = (*prose.unjudged, *_definitions(readings), *beside)
    shown = truth if written_out else None
    return Check(
        truth.scene, judged, tuple(matches.values()), remarks, shown, unjudged, beside,
        (*map(located, others), *aside), hints, others,
    )  # fmt: skip


def _against(prose: Prose, written_out: bool) -> tuple[str, ...]:
    """What texts say otherwise than the scene has it, in words."""
    conventions = () if written_out else prose.conventions
    return (*(f"the text counts otherwise: {one.told}" for one in conventions), *prose.against)


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


def _plain(things: Sequence[Any], **asked: Any) -> None:
    """Refuse what needs equations that are written out."""
    if any(isinstance(thing, BlackBox) for thing in things):
        raise InputError(
            "check: equations that stay a program are not compared with a black box: pass its"
            " formulas, or functions that can be traced"
        )
    for name, value in asked.items():
        if value:
            raise InputError(
                f"check: equations that stay a program are judged as they stand: leave out {name}"
            )


def _around(
    thing: Around, scene: Scene, names: Mapping[str, str], known: Sequence[Match]
) -> tuple[str, ...]:
    """What of a file of Python says something and is not judged."""
    words = Vocabulary(scene)
    single = {n: m for n, m in names.items() if m == "t" or words.target(m) is not None}
    columns = (Match(n, m, "as given") for n, m in names.items() if " " in m)
    naming = Naming(words, single, (*columns, *known))
    return (*thing.others, *lines_around(thing.code, thing.judged, naming))


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


def _read(truth: Equations, part: Any, names: Mapping[str, str] | None, *how: Any) -> Reading:
    """A reading under the best choice of the names that are guessed."""
    found = read(truth.scene, part, names, *how)
    return best_names(
        truth, found, lambda chosen: read(truth.scene, part, {**(names or {}), **chosen}, *how)
    )


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


def _right(truth: Equations, values: Values, apart: bool, statement: Statement) -> bool:
    """Whether a statement is right; where more is declared than values, that is not asked."""
    return not apart and judge(truth, statement, values).shown


def _by_letter(entry: Judged, settled: Settled) -> Judged:
    """The entry; refuted where the meaning of its letter has another dimension."""
    if settled.finding is None:
        return entry
    return replace(entry, finding=settled.finding, right_if=(), open=False)


def _helping(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding]
) -> tuple[tuple[str, ...], bool]:
    """Under which conditions all statements are right, and whether these may be what is meant.

    A convention may be where the statements determine the motion: any one equation can be mended.
    Lengths that are half of the scene's, and bodies without inertia, need a word of the person's.
    """
    changes = helpful_changes(truth, statements)
    if changes:
        plain = all(c.kind not in ("size", "masses") for change in changes[:1] for c in change)
        words = tuple(" and ".join(c.words for c in change) for change in changes)
        return words, plain and len(changes[0]) <= 2 and determines(truth, statements)
    if words := right_at(truth, statements):
        return words, True
    # What is linearized needs a word of the person's.
    words = right_for_small_angles(truth, statements, findings)
    return words or right_where(truth, statements, findings), False


def _verdicts(
    truth: Equations, statements: Sequence[Statement], *, counted: Sequence[Declared],
    values: Values, where: Sequence[Where], helps: bool = True,
) -> Answer:  # fmt: skip
    """Verdicts and remarks; beside a refutation the convention that helps, if that is asked."""
    if counted:
        return judge_under(truth, statements, counted)
    plain = [at_rest(truth, statement) for statement in statements]
    settled = settle(
        truth, plain, partial(_right, truth, values, bool(where)), dimensions=not values
    )
    judged, told = _judged(truth, [s.statement for s in settled], values, where, helps)
    return tuple(map(_by_letter, judged, settled)), told


def _judged(
    truth: Equations, statements: Sequence[Statement], values: Values, where: Sequence[Where],
    helps: bool,
) -> Answer:  # fmt: skip
    if where:
        found = (Judged(s, judge_where(truth, s, where)) for s in statements)
        return tuple(found), (f"judged where {' and '.join(w.words for w in where)}",)
    findings = [judge(truth, statement, values) for statement in statements]
    if values:
        idle = unused_values(truth, statements, findings, values)
        statements, findings = small_angles_at(truth, statements, findings, values)
        told = (f"judged where {in_words(values)}", *idle)
        return tuple(map(Judged, statements, findings)), told
    statements, findings = as_said(truth, statements, findings)
    if not helps or not any(map(differs, findings)):
        return tuple(map(Judged, statements, findings)), ()
    claimed = [
        k for k, s in enumerate(statements)
        if s.row is not None and not s.doubt and (findings[k].shown or differs(findings[k]))
    ]  # fmt: skip
    some = [statements[k] for k in claimed]
    helping, may_be = _helping(truth, some, [findings[k] for k in claimed])
    entries = []
    for statement, finding in zip(statements, findings, strict=True):
        wrong = differs(finding)
        entries.append(Judged(statement, finding, helping if wrong else (), open=wrong and may_be))
    return tuple(entries), ()
