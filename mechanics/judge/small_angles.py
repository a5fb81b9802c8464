"""Whether refuted equations are right to first order in angles: people write theta for sin(theta).

r(e theta, e theta', a(e))  =  r0 + e r1 + ...    r0 = 0 and r1 = 0 at all states
M0 a0 = f0,    M0 a1 = f1 - M1 a0                 with M(e), f(e) expanded in the same way

An equation counts as linearized only where an angle stands by itself, or no angle stands in a sine
or cosine, and where no two of angles, rates, sines and cosines are multiplied: else a wrong term of
higher order would be called right. It is right where the text says that it is meant so; elsewhere
it is wrong, and that is told beside.
"""

import re
from collections.abc import Sequence
from dataclasses import replace

from sympy import Abs, Dummy, Expr, Matrix, Max, Min, Mod, Piecewise, S, Symbol, sign
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from mechanics.claims.claim import Written
from mechanics.claims.kinds import angular
from mechanics.claims.prose import ENDS
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.kernel import Finding, Verdict
from mechanics.scene import Scene
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.symbols import plain_symbol
from mechanics.symbolic.decide import prove_zero

MOST = 4
"""Speeds up to which this is looked at."""

ANGLE = r"\\?(?:(?:var)?theta|(?:var)?phi|alpha|beta|psi|q)"
SAID = re.compile(
    rf"small[ -]+(?:angle|oscillation|amplitude|displacement|motion|pitch|roll|\$?{ANGLE})"
    rf"|{ANGLE}(?:_\{{?\w+\}}?)?\$?\s+(?:(?:is|are|stays?|remains?)\s+)?small\b"
    r"|lineari[sz]|to first order|linear (?:model|equation|approximation)"
    r"|\\sin\s*\{?\\?\w+\}?\s*\\(?:approx|simeq)",
    re.IGNORECASE,
)
"""What says that equations are meant to first order."""
DENIED = re.compile(r"\b(?:not?|nor|never|without|before|cannot)\b|n't\b", re.IGNORECASE)
"""What says that they are not, in the same sentence."""

STEPS = (Piecewise, Abs, Max, Min, Mod, sign)

E = Dummy("e")


def right_for_small_angles(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding]
) -> tuple[str, ...]:
    """What has to be so for all statements to be right: small angles; nothing where that is not.

    Parameters
    ----------
    truth : Equations
    statements : sequence of Statement
    findings : sequence of Finding
        Their verdicts as written.
    """
    wrong = [s for s, f in zip(statements, findings, strict=True) if not f.shown]
    shown = to_first_order(truth, wrong)
    if not wrong or not all(f is not None and f.shown for f in shown):
        return ()
    return (f"linearized about {_zero(truth.scene)} (to first order, for small angles)",)


def as_said(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding]
) -> tuple[list[Statement], list[Finding]]:
    """What a text gives for small angles, judged to first order, and said.

    Parameters
    ----------
    truth : Equations
    statements : sequence of Statement
    findings : sequence of Finding
        Their verdicts as written.
    """
    judged, shown = list(statements), list(findings)
    said = [
        k for k, (s, f) in enumerate(zip(statements, findings, strict=True))
        if f.verdict is Verdict.REFUTED and s.written is not None and _said(s.written)
    ]  # fmt: skip
    for k, found in zip(said, to_first_order(truth, [judged[k] for k in said]), strict=True):
        if found is not None and found.shown:
            note = f"it holds to first order about {_zero(truth.scene)}, as the text says"
            judged[k] = replace(judged[k], notes=(*judged[k].notes, note))
            shown[k] = found
    return judged, shown


def _said(written: Written) -> bool:
    """Whether a sentence up to the statement says so, and does not deny it."""
    starts = [0, *(match.end() for match in ENDS.finditer(written.text))]
    sentences = zip(starts, [*starts[1:], len(written.text)], strict=True)
    said = (written.text[a:b] for a, b in sentences if a <= written.start)
    return any(SAID.search(one) and not DENIED.search(one) for one in said)


def _angles(scene: Scene) -> list[Expr]:
    return [q for q in scene.coordinates if plain_symbol(q) in angular(scene)]


def _zero(scene: Scene) -> str:
    return ", ".join(f"{plain_symbol(q).name} = 0" for q in _angles(scene))


def to_first_order(truth: Equations, statements: Sequence[Statement]) -> list[Finding | None]:
    """Verdicts on equations to first order in the angles; None for what is not linearized."""
    scene = truth.scene
    angles = _angles(scene)
    unfit = scene.constraints or scene.speeds or truth.multipliers
    if unfit or not statements or not angles or len(scene.u) > MOST:
        return [None] * len(statements)
    orders = [{plain_symbol(q, k) for q in angles} for k in range(3)]
    small = orders[0] | orders[1]
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


def _motion(truth: Equations, small: set[Symbol]) -> tuple[Matrix, Matrix]:
    """Accelerations at angles of zero, and how they grow with the angles."""
    mass, forcing = (_scaled(m, small) for m in (truth.mass, truth.forcing))
    at, force = mass.subs(E, 0), forcing.subs(E, 0)
    inverse = at.adjugate() / at.det()
    resting = inverse * force
    growing = inverse * (forcing.diff(E).subs(E, 0) - mass.diff(E).subs(E, 0) * resting)
    return resting, growing


def _first_order(
    scene: Scene, residual: Expr, small: set[Symbol], motion: tuple[Matrix, Matrix]
) -> Finding:
    resting, growing = motion
    scaled = _scaled(Matrix([residual]), small)[0]
    there = dict(zip(scene.ud, resting, strict=True))
    total = scaled.diff(E) + sum(
        (scaled.diff(a) * b for a, b in zip(scene.ud, growing, strict=True)), S.Zero
    )
    orders = [scaled.subs(E, 0).xreplace(there), total.subs(E, 0).xreplace(there)]
    return prove_zero("to first order", orders, try_normal=False)


def _scaled(entries: Matrix, small: set[Symbol]) -> Matrix:
    return entries.xreplace({symbol: E * symbol for symbol in small})
