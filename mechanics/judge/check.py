"""A person's own equations, checked against what the engine derives from the scene.

statements  --ledger-->  PROVED, CERTIFIED, REFUTED with a witness, UNDECIDED
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

from mechanics.checks.ledger import check_row
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError, SingularError, wanted
from mechanics.exact import Finding, Verdict
from mechanics.judge.at_values import Values, judged_at, read_values, right_at
from mechanics.judge.at_values import words as in_words
from mechanics.judge.black_box import check_box
from mechanics.judge.blamed import blamed
from mechanics.judge.cases import check_cases
from mechanics.judge.complete import redundancy
from mechanics.judge.other_meaning import energy_instead
from mechanics.judge.other_names import best_names, doubtful
from mechanics.judge.readers import read, spread
from mechanics.judge.right_if import declared, judged_under, right_if
from mechanics.judge.small_angles import right_for_small_angles
from mechanics.judge.vacuous import with_content
from mechanics.reading.code.black_box import BlackBox
from mechanics.reading.statement import Reading, Statement
from mechanics.report.answer.check import Check
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene
from mechanics.scene.symbols import plain_symbol
from mechanics.scene.system import System


@lru_cache(maxsize=32)
def derived(scene: Scene) -> Equations:
    """What statements about a scene are compared with: the route that has the reactions."""
    return derive(scene, "free_body")


def check(
    scene: Scene | System | Equations,
    equations: Any,
    *,
    names: Mapping[str, str] | None = None,
    notation: str | None = None,
    about: str | None = None,
    convention: Sequence[str] | str = (),
    function: str | None = None,
    values: Mapping[str, Any] | None = None,
    blame: bool = True,
) -> Check:
    """Check a person's equations of motion, energies, reactions or mass matrix.

    Parameters
    ----------
    scene : Scene, System or Equations
        What they are about; equations that were derived already save that time.
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
        How the person counts otherwise than the scene: ``"other vertical"``, ``"half-length"``, ...
        Without it, equations that would be right under such a change are REFUTED, and the result
        says under which change.
    values : mapping of str to number, optional
        Values of parameters, ``{"g": 9.81}``: the statements are judged where the scene has these.
    blame : bool
        Whether to look for what is wrong with what is refuted, and for the edit that mends it.

    Returns
    -------
    Check

    Raises
    ------
    InputError
        When nothing can be read, by line and column.
    """
    wanted(scene, (Scene, System, Equations), "check", "pass a scene, or one of systems.ALL")
    if isinstance(scene, Equations):
        truth = scene
    else:
        truth = derived(scene.scene() if isinstance(scene, System) else scene)
    things = spread(equations)
    boxed = [check_box(truth, thing, names) for thing in things if isinstance(thing, BlackBox)]
    parts = [thing for thing in things if not isinstance(thing, BlackBox)]
    readings = [_read(truth, part, names, notation, about, function) for part in parts]
    statements = [statement for reading in readings for statement in reading.statements]
    if values and convention:
        raise InputError("check: values and a convention are given: give one of them")
    names_of = declared([convention] if isinstance(convention, str) else convention)
    held = read_values(truth.scene, values or {})
    judged, told = _judged(truth, statements, names_of, held)
    # Edits are searched in equations as they stand, not as they would stand without a convention.
    if blame and not names_of and not held:
        judged = blamed(truth, judged)
    judged = tuple(energy_instead(truth, entry) for entry in judged)
    judged = (*judged, *(Judged(s, f) for entries, _ in boxed for s, f in entries))
    told_of = (*(reading.names for reading in readings), *(known for _, known in boxed))
    matches = {match.name: match for known in told_of for match in known}
    remarks = tuple(dict.fromkeys(r for reading in readings for r in reading.remarks))
    if any(entry.finding.verdict is Verdict.REFUTED for entry in judged):
        remarks += doubtful(readings)
    twice = redundancy(truth, judged)
    remarks = (*remarks, *told, *([twice] if twice else []))
    return Check(truth.scene, judged, tuple(matches.values()), remarks, truth)


def _read(truth: Equations, part: Any, names: Mapping[str, str] | None, *how: Any) -> Reading:
    """A reading under the best choice of the names that are guessed."""
    found = read(truth.scene, part, names, *how)
    return best_names(
        truth, found, lambda chosen: read(truth.scene, part, {**(names or {}), **chosen}, *how)
    )


def _judged(
    truth: Equations, statements: Sequence[Statement], names: Sequence[str], values: Values
) -> tuple[tuple[Judged, ...], tuple[str, ...]]:
    """Verdicts; under a declared convention, or beside a refutation the one that would help."""
    findings = [_judge(truth, statement, values) for statement in statements]
    if values:
        return tuple(map(Judged, statements, findings)), (f"judged where {in_words(values)}",)
    refuted = any(finding.verdict is Verdict.REFUTED for finding in findings)
    if not refuted and not names:
        return tuple(map(Judged, statements, findings)), ()
    claimed = [k for k, s in enumerate(statements) if s.row is not None and not s.doubt]
    found = right_if(truth, [statements[k] for k in claimed], names)
    if not found and names:
        return _not_right_under(truth, statements, names, findings, claimed)
    helping = tuple(" and ".join(c.words for c in change) for change, _ in found)
    if not found:
        some = [statements[k] for k in claimed]
        helping = right_at(truth, some) or right_for_small_angles(
            truth, some, [findings[k] for k in claimed]
        )
    if names:
        words = helping[0]
        for k, finding in zip(claimed, found[0][1], strict=True):
            findings[k] = replace(finding, evidence=f"{finding.evidence}, where {words}")
        return tuple(map(Judged, statements, findings)), (f"convention: {words}",)
    entries = [
        Judged(s, f, helping if f.verdict is Verdict.REFUTED else ())
        for s, f in zip(statements, findings, strict=True)
    ]
    return tuple(entries), ()


def _not_right_under(
    truth: Equations, statements: Sequence[Statement], names: Sequence[str],
    findings: list[Finding], claimed: Sequence[int],
) -> tuple[tuple[Judged, ...], tuple[str, ...]]:  # fmt: skip
    """Verdicts under conventions that are declared, but do not make the statements right."""
    told = ", ".join(names)
    found = judged_under(truth, [statements[k] for k in claimed], names)
    if found is None:
        doubt = f"the convention {told} has no meaning for these statements"
        findings = [Finding(f.subject, Verdict.UNDECIDED, doubt) for f in findings]
        return tuple(map(Judged, statements, findings)), (doubt,)
    change, others = found
    words = " and ".join(convention.words for convention in change)
    for k, finding in zip(claimed, others, strict=True):
        findings[k] = replace(finding, evidence=f"{finding.evidence}, where {words}")
    remark = (
        f"convention: {words}: the statements are not all right under it; what is wrong is looked"
        " for without a convention only"
    )
    return tuple(map(Judged, statements, findings)), (remark,)


def _judge(truth: Equations, statement: Statement, values: Values) -> Finding:
    subject = f"{statement.tag}: {statement.source}"
    if statement.doubt or statement.row is None:
        return Finding(subject, Verdict.UNDECIDED, statement.doubt)
    if thirds := _third_rates(truth.scene, statement):
        doubt = f"{thirds}: nothing determines a third derivative: write the equation itself"
        return Finding(subject, Verdict.UNDECIDED, doubt)
    try:
        if values:
            return with_content(statement, judged_at(truth, statement.row, values))
        found = check_row(truth.scene, statement.row, truth)
        if found.verdict is Verdict.UNDECIDED:
            by_cases = check_cases(truth, statement.row)
            found = found if by_cases is None else by_cases
        return with_content(statement, found)
    except (InputError, SceneError, ExpressionError, SingularError) as error:
        return Finding(subject, Verdict.UNDECIDED, str(error))
    except RecursionError:
        return Finding(subject, Verdict.UNDECIDED, "its expressions are nested too deeply")


def _third_rates(scene: Scene, statement: Statement) -> str:
    """Names the third derivatives of coordinates that a statement holds."""
    sides = statement.row.sides if statement.row is not None else ()
    held = {symbol.name for side in sides for symbol in side.free_symbols}
    return ", ".join(sorted(held & {plain_symbol(q, 3).name for q in scene.coordinates}))
