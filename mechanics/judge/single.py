"""The verdict of one statement.

statement  --ledger, by cases where it has some-->  PROVED, CERTIFIED, REFUTED, UNDECIDED
"""

from functools import partial

from sympy.matrices import MatrixBase

from mechanics.checks.force_potentials import right_with_potentials
from mechanics.checks.ledger import check_row
from mechanics.claims.demands import Demand
from mechanics.claims.statement import Statement
from mechanics.compiled.dimensions import check_energy
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError, SingularError
from mechanics.judge.at_values import Values, judged_at
from mechanics.judge.cases import check_cases, has_guard, with_case
from mechanics.judge.definedness import where_defined
from mechanics.judge.limits import limited
from mechanics.judge.principal import on_principal_range
from mechanics.judge.vacuous import as_step, with_content
from mechanics.kernel import Finding, Verdict, refuted, undecided
from mechanics.scene import Scene
from mechanics.scene.dimensions import BY_DIMENSION, MixedDimensions
from mechanics.scene.published import Published
from mechanics.scene.symbols import plain_symbol, symbols_of

FAILURES = (InputError, SceneError, ExpressionError, SingularError)


def judge(truth: Equations, statement: Statement, values: Values) -> Finding:
    """The finding of a statement; where parameters have values, if some are given."""
    found = where_defined(truth, statement, identity(truth, statement, values), values=values)
    row, written = statement.row, statement.written
    if values or row is None or not found.shown or (written and written.notation == "code"):
        return found
    mixed = check_energy(truth, row)
    return found if mixed is None else by_dimension(found.subject, mixed)


def by_dimension(subject: str, mixed: MixedDimensions) -> Finding:
    """The finding on what its dimension alone refutes."""
    return refuted(subject, f"{BY_DIMENSION}{mixed}", *mixed.units)


def identity(truth: Equations, statement: Statement, values: Values) -> Finding:
    """The finding of a statement as far as what was written has values."""
    statement = as_step(truth, statement)
    subject = subject_of(statement)
    if statement.doubt or statement.row is None:
        return undecided(subject, statement.doubt)
    if thirds := _third_rates(truth.scene, statement):
        doubt = f"{thirds}: nothing determines a third derivative: write the equation itself"
        return undecided(subject, doubt)
    try:
        if values and isinstance(truth, Equations):
            return with_content(statement, judged_at(truth, statement.row, values))
        return with_content(statement, _of_row(truth, statement.demands.of, statement.row))
    except FAILURES as error:
        return undecided(subject, str(error))
    except RecursionError:
        return undecided(subject, "its expressions are nested too deeply")


def _of_row(truth: Equations, demands: tuple[Demand, ...], row: Published) -> Finding:
    """The finding of a row: by cases, of limited inputs, or where its own wraps are principal."""
    found = with_case(truth, row, check_row(truth.scene, row, truth))
    guarded = found.verdict is Verdict.REFUTED and has_guard(row, demands)
    if found.verdict is Verdict.UNDECIDED or guarded:
        by_cases = _first(check_cases(truth, row, demands), found)
        found = found if guarded and by_cases.verdict is Verdict.UNDECIDED else by_cases
    if not found.shown:
        found = _first(limited(truth, row), found)
    if found.verdict is Verdict.REFUTED:
        counted = right_with_potentials(truth.scene, row, partial(_plain, truth))
        found = _first(counted, found)
    if found.verdict is Verdict.REFUTED:
        found = _first(on_principal_range(row, found, partial(_of_row, truth, demands)), found)
    return found


def _plain(truth: Equations, row: Published) -> Finding:
    return check_row(truth.scene, row, truth)


def _first(one: Finding | None, other: Finding) -> Finding:
    return other if one is None else one


def subject_of(statement: Statement) -> str:
    """What a finding about a statement is about, in words."""
    return f"{statement.tag}: {statement.source}"


def _third_rates(scene: Scene, statement: Statement) -> str:
    """Names the third derivatives of coordinates that a statement holds."""
    sides = statement.row.sides if statement.row is not None else ()
    entries = [e for s in sides for e in (s.flat() if isinstance(s, MatrixBase) else [s])]
    held = {symbol.name for symbol in symbols_of(entries)}
    return ", ".join(sorted(held & {plain_symbol(q, 3).name for q in scene.coordinates}))
