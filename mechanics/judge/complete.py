"""How much of a motion a person's equations determine.

rank of d(lhs - rhs)/du' beside the constraints  -  rank of the constraints    of    their freedoms
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from random import Random

import numpy as np
from sympy import Expr, Matrix, Mul, S, factor_terms

from mechanics.checks.ledger_motion import closing, gradient
from mechanics.checks.manifold import project
from mechanics.claims.demands import Demand, Demands
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.errors import ZeroDivisorError
from mechanics.judge.common_factor import demands_of_factors
from mechanics.judge.definedness import where_defined
from mechanics.kernel import undecided
from mechanics.kernel.field import Inadmissible
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.kinematics.printer import symbols
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient as gradient_of
from mechanics.program.interpret import include, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene
from mechanics.scene.quantities import (
    EquationOfMotion,
    Hamiltonian,
    Lagrangian,
    ReactionValue,
)
from mechanics.symbolic import Arithmetic, slope

MOST_TOGETHER = 3
"""Equations whose determinant is written out; of more it is looked at at states."""
STATES = 24
SPECIAL = (0.0, 1.5707963267948966, -1.5707963267948966)
"""Where factors of one coordinate or speed vanish."""
SINGULAR = 1e10
"""Condition of a mass matrix where the coordinates are singular."""
NOTHING = 1e-9
"""Of a determinant of rows of length 1."""


def determines(truth: Equations, statements: Sequence[Statement]) -> bool:
    """Whether statements are as many as a motion needs: equations, or the function it has."""
    quantities = [s.row.quantity for s in statements if s.row is not None]
    count = sum(isinstance(one, EquationOfMotion) for one in quantities)
    whole = any(isinstance(one, Lagrangian | Hamiltonian) for one in quantities)
    return whole or count >= len(truth.scene.u) - len(truth.scene.constraints)


def redundancy(truth: Equations, judged: Sequence[Judged]) -> str:
    """A remark where equations of motion that are shown say the same twice; empty otherwise.

    Fewer equations than freedoms are partial input, which is fine.
    """
    rows, rank, freedoms = determined(truth, judged)
    if rank == rows or rows < 2:
        return ""  # one alone, with a reaction that nothing gives, follows from no other
    return f"independent equations of motion: {rank} of these {rows}; the motion needs {freedoms}"


def complete_residuals(truth: Equations, judged: Sequence[Judged]) -> tuple[Judged, ...]:
    """The entries; residuals of one function that say the same twice determine no motion."""
    found = list(judged)
    titles: dict[str, list[int]] = {}
    for k, entry in enumerate(judged):
        title, colon, tag = entry.statement.source.rpartition(": ")
        if colon and tag.startswith("residual ") and entry.statement.demands.code:
            titles.setdefault(title, []).append(k)
    for places in titles.values():
        group = [judged[k] for k in places]
        if len(group) < 2 or not all(entry.finding.shown for entry in group):
            continue
        rows, rank, freedoms = determined(truth, group)
        if rank < rows:
            words = (
                f"it is right, but of these {rows} residuals only {rank} are independent; the"
                f" motion needs {freedoms}"
            )
            for k in places:
                subject = judged[k].finding.subject
                found[k] = replace(found[k], finding=undecided(subject, words))
    return tuple(found)


def determined(truth: Equations, judged: Sequence[Judged]) -> tuple[int, int, int]:
    """How many equations of motion are shown, how many of them say something new, and freedoms.

    What says only what a reaction is, that nothing else gives, says nothing of the motion; nor does
    ``theta (theta'' - ...) = 0`` of a motion that stays at theta = 0. As many equations as freedoms
    count as one less where they say the same at some state.
    """
    return _counted(truth, judged)[:3]


def independent(truth: Equations, judged: Sequence[Judged]) -> int:
    """How many equations of motion that are shown follow from no others."""
    count, _, _, new = _counted(truth, judged)
    return min(count, new)


def _counted(truth: Equations, judged: Sequence[Judged]) -> tuple[int, int, int, int]:
    """What `determined` tells, and how many equations follow from no others."""
    scene = truth.scene
    entries = [e for e in judged if e.finding.shown and e.statement.row is not None]
    shown = [e.statement.row for e in entries if e.statement.row is not None]
    count = sum(isinstance(row.quantity, EquationOfMotion) for row in shown)
    lost = [e.statement.row for e in entries if _loses_motions(truth, e)]
    rows = [r for r in shown if isinstance(r.quantity, EquationOfMotion) and r not in lost]
    given = {row.quantity.name for row in shown if isinstance(row.quantity, ReactionValue)}
    forces = [r.symbol for r in scene.reactions if r.name not in given]
    written = partial(momenta_written_out, truth.kinematics)
    sides = [[scene.plain(written(s), r.tag) for s in r.sides[:2]] for r in rows]
    closure = truth.kinematics.mechanism.closure
    constraints = closing(truth).tolist()
    if closure and not closure.values:
        return count, len(rows), len(scene.ud) - len(constraints), count  # no exact state is known
    a = Arithmetic()
    for symbol in scene.input_symbols:
        a.assign(symbol, 0)  # u (theta'' - ...) = 0 says nothing of what moves by itself
    try:
        project(a, truth.kinematics)
        unknowns = [a.value(symbol) for symbol in (*scene.ud, *forces)]
        both = [_slopes(a, scene, pair, unknowns, forces) for pair in sides]
        speeds = len(scene.ud)
        slopes, unknown = [row[:speeds] for row in both], [row[speeds:] for row in both]
        closed = [[a.value(e) for e in row] for row in constraints]
        held = a.rank(closed)
        both += [[*row, *(a.rational(0) for _ in forces)] for row in closed]
        new = a.rank(both) - held
        rank = new - a.rank(unknown)
    except (Inadmissible, ZeroDivisorError):
        return count, len(rows), len(scene.ud) - len(constraints), count  # no state to look at
    if rank == len(rows) == len(scene.ud):
        few = rank <= MOST_TOGETHER and truth.textbook is not None
        meet = _meet_somewhere(truth, entries, sides) if few else _meet_at_a_state(truth, a, slopes)
        rank -= int(meet)
    return count, rank, len(scene.ud) - held, new


def _slopes(
    a: Arithmetic, scene: Scene, pair: list[Expr], unknowns: list[Node], forces: list[Expr]
) -> list[Node]:
    """Derivatives of left - right by the accelerations and reactions, where inputs are 0.

    Raises
    ------
    ZeroDivisorError
        Where these have no value there.
    """
    left, right = pair
    try:
        return gradient_of([a.value(left) - a.value(right)], [1], unknowns)
    except ZeroDivisorError:  # an input below a line: the derivatives alone may have a value
        idle = dict.fromkeys(scene.input_symbols, S.Zero)
        slopes = [*gradient(scene, pair), *(slope(left - right, force) for force in forces)]
        return [a.value(entry.xreplace(idle)) for entry in slopes]


def _meet_at_a_state(truth: Equations, a: Arithmetic, slopes: list[list[Node]]) -> bool:
    """Whether slopes are combinations of the mass matrix that meet where one quantity is special.

    slopes = T M, and det T vanishes there, or changes its sign between states.
    """
    scene, source, named = truth.scene, Random(0), symbols(truth.scene)
    own = truth.kinematics.mechanism.builder.program(
        {"mass": [entry for row in truth.kinematics.mass_nodes for entry in row]}
    )
    given = {name: a.value(named[name]) for name in own.inputs}
    mass = include(a.builder, own, given)["mass"]
    program = a.builder.program({"rows": [e for row in slopes for e in row], "mass": mass})
    moving = [str(symbol) for symbol in (*scene.q, *scene.u)]
    known = {name: symbol for symbol, name in a.inputs.items()}
    typical = {n: float(getattr(known.get(n), "typical", None) or 1) for n in program.inputs}
    states = [{name: source.uniform(-3, 3) for name in moving} for _ in range(STATES)]
    states += [dict.fromkeys(moving, 0.0)]
    states += [{**states[0], name: value} for name in moving for value in SPECIAL]
    signs = set()
    for state in states:
        with np.errstate(all="ignore"):
            found = interpret(program, Arrays(), {**typical, **state})
        rows, metric = (np.array(found[key], dtype=float).reshape(len(slopes), -1)
                        for key in ("rows", "mass"))  # fmt: skip
        if not (np.isfinite(rows).all() and np.isfinite(metric).all()):
            continue  # it has no value there
        if np.linalg.cond(metric) > SINGULAR:
            continue
        combined = np.linalg.solve(metric.T, rows.T).T
        lengths = np.linalg.norm(combined, axis=1)
        if not all(lengths):
            return True
        signs.add(_sign(float(np.linalg.det(combined / lengths[:, None]))))
    return len(signs) > 1 or signs == {0}


def _sign(value: float) -> int:
    return 0 if abs(value) < NOTHING else 1 if value > 0 else -1


def _meet_somewhere(truth: Equations, entries: Sequence[Judged], sides: list[list[Expr]]) -> bool:
    """Whether as many equations as freedoms say less at some state.

    e1 = 0 and x e2 + e1 = 0, where x = 0: their determinant by accelerations vanishes.
    """
    idle = dict.fromkeys(truth.scene.input_symbols, S.Zero)
    slopes = [[e.xreplace(idle) for e in gradient(truth.scene, pair)] for pair in sides]
    determinant = Matrix(slopes).det(method="berkowitz")
    factors = Mul.make_args(factor_terms(determinant))
    divisors = [f.as_base_exp()[0] for f in factors if f.free_symbols]
    demands = Demands(tuple(Demand("divide", (S.One, divisor)) for divisor in divisors))
    alone = replace(entries[0].statement, demands=demands)
    finding = where_defined(truth, alone, replace(entries[0].finding, domain=""))
    return bool(divisors) and (bool(finding.domain) or not finding.shown)


def _loses_motions(truth: Equations, entry: Judged) -> bool:
    """Whether an equation has a factor that is zero at some state."""
    alone = replace(entry.statement, demands=Demands(demands_of_factors(truth, entry.statement)))
    finding = where_defined(truth, alone, replace(entry.finding, domain=""))
    return bool(alone.demands.of) and (bool(finding.domain) or not finding.shown)
