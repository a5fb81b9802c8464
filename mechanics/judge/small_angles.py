"""Whether refuted equations are right to first order in angles: people write theta for sin(theta).

r(e theta, e theta', a(e))  =  r0 + e r1 + ...    r0 = 0 and r1 = 0 at all states
M0 a0 = f0,    M0 a1 = f1 - M1 a0                 with M(e), f(e) expanded in the same way

An equation counts as linearized only where an angle stands by itself, or no angle stands in a sine
or cosine, and where no two of angles, rates, sines and cosines are multiplied: else a wrong term of
higher order would be called right. It is right where the text says that it is meant so; elsewhere
it is wrong, and that is told beside.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from sympy import Abs, Dummy, Expr, Matrix, Max, Min, Mod, Piecewise, S, Symbol, sign
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from mechanics.claims.convention import Table
from mechanics.claims.kinds import angular
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.judge.converted_rows import slopes_of
from mechanics.judge.meanings import NO_TABLE
from mechanics.judge.operating_point import OperatingPoint, called_linear, operating_point
from mechanics.judge.words_beside import written_or_comments
from mechanics.kernel import Finding, Verdict, undecided
from mechanics.scene import Scene
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.symbols import plain_symbol
from mechanics.symbolic.decide import prove_zero

MOST = 4
"""Speeds up to which this is looked at."""

STEPS = (Piecewise, Abs, Max, Min, Mod, sign)

E = Dummy("e")


def right_for_small_angles(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding]
) -> tuple[str, ...]:
    """What has to be so for all statements to be right: small angles; nothing where that is not.

    Parameters
    ----------
    findings : sequence of Finding
        Their verdicts as written.
    """
    wrong = [s for s, f in zip(statements, findings, strict=True) if not f.shown]
    shown = to_first_order(truth, wrong)
    if not wrong or not all(f is not None and f.shown for f in shown):
        return ()
    return (f"linearized about {_zero(truth.scene)} (to first order, for small angles)",)


def as_said(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding],
    table: Table = NO_TABLE,
) -> tuple[list[Statement], list[Finding]]:  # fmt: skip
    """What a text gives for small angles, judged to first order, and said.

    Parameters
    ----------
    findings : sequence of Finding
        Their verdicts as written.
    table : mapping of Symbol to Expr
        The person's coordinates in the scene's, where they count otherwise; rows are the scene's.
    """
    judged, shown = list(statements), list(findings)
    for k, (statement, finding) in enumerate(zip(statements, findings, strict=True)):
        if finding.shown and (words := _called_linear(truth.scene, statement)):
            shown[k] = undecided(finding.subject, words)
        if finding.verdict is Verdict.REFUTED and (
            written := written_or_comments(truth.scene, statement)
        ):
            meant = operating_point(truth.scene, written)
            if meant is not None:
                judged[k], shown[k] = _about(truth, statement, finding, meant, table)
    return judged, shown


def _called_linear(scene: Scene, statement: Statement) -> str:
    """What is to be said of an equation that its text calls linear, and that is not."""
    written = statement.written
    words = called_linear(written) if written is not None else ""
    if not words or (residual := _residual(scene, statement)) is None:
        return ""
    angles = {plain_symbol(q) for q in _angles(scene)}
    if not any(f.free_symbols & angles for f in residual.atoms(TrigonometricFunction)):
        return ""
    return f"it is right as it stands, but the text says {words!r}, and it is not linear"


def _about(
    truth: Equations, statement: Statement, finding: Finding, meant: OperatingPoint, table: Table
) -> tuple[Statement, Finding]:
    """A refuted statement and its finding about the place that the text tells."""
    place = _in_scene(truth.scene, meant, table)
    (found,) = to_first_order(truth, [statement], place)
    if found is None and _is_beyond(truth) and _is_linear(truth.scene, statement, place):
        doubt = "the text says that it is linearized, which is not compared where constraints hold"
        return statement, undecided(finding.subject, doubt)
    if found is None:
        return statement, finding
    if meant.place is None:
        doubt = (
            f"the text says that it is linearized {meant.words!r}, which was not understood: say"
        )
        return statement, undecided(finding.subject, f"{doubt} about which angles, as theta = 0")
    where = ", ".join(f"{q.name} = {value}" for q, value in meant.place.items())
    if found.shown and meant.hedge:
        doubt = f"it holds to first order about {where}, but the text also says {meant.hedge!r}"
        return statement, undecided(finding.subject, f"{doubt}: say whether it is meant so")
    if found.shown:
        note = f"it holds to first order about {where}, as the text says"
        return replace(statement, notes=(*statement.notes, note)), found
    row = statement.row
    if row is not None and any(meant.place.values()):
        back = {q: q - value for q, value in meant.place.items()}
        moved = replace(row, sides=tuple(truth.scene.plain(s).xreplace(back) for s in row.sides))
        (apart,) = to_first_order(truth, [replace(statement, row=moved)], place)
        if apart is not None and apart.shown:
            doubt = f"right to first order if angles are measured from {where} here: say so"
            return statement, undecided(finding.subject, doubt)
    return statement, finding


def _in_scene(scene: Scene, meant: OperatingPoint, table: Table) -> dict[Symbol, Expr]:
    """An operating point as the scene counts: q_p = T q + c."""
    told = meant.place or {}
    origin = dict.fromkeys(scene.q, S.Zero)
    moved = Matrix([told.get(q, S.Zero) - table.get(q, q).xreplace(origin) for q in scene.q])
    place = dict(zip(scene.q, slopes_of(scene, table).inv() * moved, strict=True))
    return {q: value for q, value in place.items() if q in told or q in angular(scene)}


def _angles(scene: Scene) -> list[Expr]:
    return [q for q in scene.coordinates if plain_symbol(q) in angular(scene)]


def _zero(scene: Scene) -> str:
    return ", ".join(f"{plain_symbol(q).name} = 0" for q in _angles(scene))


def to_first_order(
    truth: Equations, statements: Sequence[Statement], place: Mapping[Symbol, Expr] = NO_TABLE
) -> list[Finding | None]:
    """Verdicts on equations to first order in the angles; None for what is not linearized.

    Parameters
    ----------
    place : mapping of Symbol to Expr
        About which angles, and other coordinates; zero for angles that it does not hold.
    """
    scene = truth.scene
    orders = _orders(scene, place)
    if _is_beyond(truth) or not statements or not orders[0] or len(scene.u) > MOST:
        return [None] * len(statements)
    small = {s: _near(s, place.get(s, S.Zero)) for s in orders[0] | orders[1]}
    found: list[Finding | None] = []
    try:
        motion = _motion(truth, small)
    except (MechanicsError, ValueError):
        return [None] * len(statements)  # nothing to expand at angles of zero
    for statement in statements:
        try:
            residual = _residual(scene, statement)
            fits = residual is not None and _linearized(residual, *orders)
            found.append(_first_order(scene, residual, small, motion) if fits else None)
        except (MechanicsError, ValueError):
            found.append(None)
    return found


def _is_beyond(truth: Equations) -> bool:
    """Whether it is not known how the accelerations of a scene grow with its angles."""
    return bool(truth.scene.constraints or truth.scene.speeds or truth.multipliers)


def _orders(scene: Scene, place: Mapping[Symbol, Expr]) -> list[set[Symbol]]:
    """What is small, its rates, and their rates."""
    small_ones = [q for q in scene.coordinates if plain_symbol(q) in {*angular(scene), *place}]
    return [{plain_symbol(q, k) for q in small_ones} for k in range(3)]


def _is_linear(scene: Scene, statement: Statement, place: Mapping[Symbol, Expr]) -> bool:
    """Whether a statement is an equation of first order in what is small."""
    residual = _residual(scene, statement)
    return residual is not None and _linearized(residual, *_orders(scene, place))


def _residual(scene: Scene, statement: Statement) -> Expr | None:
    """Left less right in plain symbols; None for what is no equation of motion alone."""
    row = statement.row
    if row is None or not isinstance(row.quantity, EquationOfMotion) or len(row.sides) != 2:
        return None
    left, right = map(scene.plain, row.sides)
    known = {*scene.q, *scene.u, *scene.qd, *scene.ud, *scene.input_symbols, *scene.parameters}
    residual = left - right
    return residual if residual.free_symbols <= known else None


def _linearized(residual: Expr, q: set[Symbol], qd: set[Symbol], qdd: set[Symbol]) -> bool:
    """Whether an angle stands by itself, and no product of two that vanish with the angles."""
    small = q | qd | qdd
    if any(f.free_symbols & small for f in residual.atoms(*STEPS)):
        return False  # what has cases is no linear equation
    circular = {f for f in residual.atoms(TrigonometricFunction) if f.free_symbols & small}
    hidden = {function: Dummy() for function in circular}
    bare = residual.xreplace(hidden)
    moving = sorted({*small, *hidden.values()}, key=str)
    if not bare.free_symbols & (q if hidden else small):
        return False
    return all(bare.diff(a, b) == S.Zero for a in moving for b in moving)


def _motion(truth: Equations, small: Table) -> tuple[Matrix, Matrix]:
    """Accelerations at angles of zero, and how they grow with the angles."""
    mass, forcing = (_scaled(m, small) for m in (truth.mass, truth.forcing))
    at, force = mass.subs(E, 0), forcing.subs(E, 0)
    inverse = at.adjugate() / at.det()
    resting = inverse * force
    growing = inverse * (forcing.diff(E).subs(E, 0) - mass.diff(E).subs(E, 0) * resting)
    return resting, growing


def _first_order(
    scene: Scene, residual: Expr, small: Table, motion: tuple[Matrix, Matrix]
) -> Finding:
    resting, growing = motion
    scaled = _scaled(Matrix([residual]), small)[0]
    there = dict(zip(scene.ud, resting, strict=True))
    total = scaled.diff(E) + sum(
        (scaled.diff(a) * b for a, b in zip(scene.ud, growing, strict=True)), S.Zero
    )
    orders = [scaled.subs(E, 0).xreplace(there), total.subs(E, 0).xreplace(there)]
    return prove_zero("to first order", orders, try_normal=False)


def _near(symbol: Symbol, place: Expr) -> Expr:
    return place + E * (symbol - place)


def _scaled(entries: Matrix, small: Table) -> Matrix:
    return entries.xreplace({**small})
