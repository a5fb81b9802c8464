"""Statements with a definition that gives a standard name a multiple of what it means.

With I = m l^2/2: T = I theta'^2        right as defined, but the bob has I = m l^2: UNDECIDED

    omega    the rate of an angle        v    the speed of a particle
    I, J     the inertia of a particle about its pivot, or of all of them

A multiple by a number only is a mistake that another one makes good; any other definition is a
person's own. Speeds and inertias of bodies that are no particles may be those of any point.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from sympy import Add, Expr, Integer, Matrix, Rational, S, pi, prime

from mechanics.claims.assemble import used_names
from mechanics.claims.kinds import angular
from mechanics.claims.spelled_rates import key
from mechanics.equations import Equations
from mechanics.judge.at_values import Values
from mechanics.kernel import undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene.bodies import RigidBody, inertia_entries
from mechanics.symbolic import is_zero

ANGULAR = re.compile(r"omega|w")
SPEED = re.compile(r"v")
INERTIA = re.compile(r"[IJ](?:_\w+)?")
MOST = 2
"""Coordinates up to which this is looked at."""


def with_standard_names(
    truth: Equations, judged: Sequence[Judged], values: Values
) -> tuple[Judged, ...]:
    """The entries; one that rests on a multiple of what a standard name means is not shown.

    Parameters
    ----------
    values : mapping of Symbol to Expr
        Of parameters, where these are given: nothing is compared then.
    """
    if values or len(truth.scene.q) > MOST or truth.scene.speeds:
        return tuple(judged)
    return tuple(_told(truth, entry) for entry in judged)


def _told(truth: Equations, entry: Judged) -> Judged:
    written = entry.statement.written
    if written is None or written.notation not in ("latex", "text") or not entry.finding.shown:
        return entry
    names = [n for n, _ in written.definitions if any(row.fullmatch(n) for row in ROWS)]
    used = used_names(written) if names else set()
    defined = written.builder().defined if names else {}
    for name in names:
        value = defined.get(name)
        plain = isinstance(value, Expr) and key(name) in used
        if words := _multiple(truth, name, truth.scene.plain(value)) if plain else "":
            told = f"it is right as the text defines {name}, but that is {words}"
            return replace(entry, finding=undecided(entry.finding.subject, told))
    return entry


def _multiple(truth: Equations, name: str, value: Expr) -> str:
    """Which multiple of what a name means its value is, in words; empty for none, and for once."""
    meanings = next(find for row, find in ROWS.items() if row.fullmatch(name))
    some = [(one, n, words) for one, n, words in meanings(truth) if one != 0]
    ratios = [(_ratio(truth, value**n, one), n, words) for one, n, words in some]
    if any(ratio == 1 for ratio, _, _ in ratios):
        return ""
    for ratio, n, words in ratios:
        if ratio is not None:
            return f"{ratio ** Rational(1, n)} times {words}"
    return ""


def _ratio(truth: Equations, value: Expr, one: Expr) -> Expr | None:
    """The number that one expression is times another; None where there is none."""
    symbols = sorted(value.free_symbols | one.free_symbols, key=str)
    for angle in (S.Zero, pi / 2):
        point = {
            s: angle if s in truth.scene.q else Integer(prime(k + 1)) for k, s in enumerate(symbols)
        }
        above, below = value.xreplace(point), one.xreplace(point)
        if below.is_zero is False and (ratio := above / below).is_Rational and ratio:
            return ratio if is_zero(value - ratio * one) else None
    return None


Meanings = Iterator[tuple[Expr, int, str]]
"""What a power of a name may be, the power, and words."""


def _rates(truth: Equations) -> Meanings:
    for q, rate in zip(truth.scene.q, truth.scene.qd, strict=True):
        if q in angular(truth.scene):
            yield rate, 1, rate.name
            yield -rate, 1, rate.name


def _speeds(truth: Equations) -> Meanings:
    scene = truth.scene
    for body in scene.bodies if _of_particles(truth) else ():
        velocity = Matrix(scene.position(body.centre)).jacobian(scene.q) * Matrix(scene.qd)
        yield velocity.dot(velocity), 2, f"the speed of {body.name}"


def _inertias(truth: Equations) -> Meanings:
    scene = truth.scene
    for q in scene.q if _of_particles(truth) else ():
        if q in angular(scene):
            arms = [Matrix(scene.position(body.centre)).diff(q) for body in scene.bodies]
            masses = [scene.plain(body.mass) for body in scene.bodies]
            each = [m * arm.dot(arm) for m, arm in zip(masses, arms, strict=True)]
            for one in (*each, Add(*each)):
                yield one, 1, f"the inertia of the motion along {q.name}"


def _of_particles(truth: Equations) -> bool:
    """Whether no body has an inertia of its own."""
    bodies = [body for body in truth.scene.bodies if isinstance(body, RigidBody)]
    return not any(any(inertia_entries(body)) for body in bodies)


ROWS = {ANGULAR: _rates, SPEED: _speeds, INERTIA: _inertias}
"""Standard names, and what they mean."""
