"""Equilibria: what a text says of theta_0, where the scene has theta, or of theta at equilibrium.

    cos(theta_0) = g / (Omega^2 R)    ->    g = Omega^2 R cos(theta_0): then nothing accelerates

What is written counts factor by factor, and where a factor is zero nothing may accelerate. A factor
is solved for a parameter that it holds in the first degree, or for the coordinate; that is put into
what is left of the equation of motion at rest, which has to vanish.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace

from sympy import Expr, Mul, S, Symbol, factor, solve

from mechanics.claims.claim import Written
from mechanics.claims.convention import Table
from mechanics.claims.guess import equilibrium_of
from mechanics.claims.prose import denies_equilibrium, of_equilibrium, sentence_around
from mechanics.claims.statement import NO_DEMANDS, Statement
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.judge.meanings import NO_TABLE
from mechanics.linear.small_oscillations import equilibria
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import Identity
from mechanics.symbolic import is_zero


def at_rest(truth: Equations, statement: Statement, table: Table = NO_TABLE) -> Statement:
    """The statement; one about an equilibrium as what it says of the equation of motion.

    Parameters
    ----------
    table : mapping of Symbol to Expr
        The person's symbols in the scene's, where they count otherwise.
    """
    row, written, scene = statement.row, statement.written, truth.scene
    if row is None or written is None or scene.speeds:
        return statement
    if not isinstance(row.quantity, Identity) or len(row.sides) != 2:
        return statement
    if len(scene.q) != 1:
        return _of_several(truth, statement, row, written)
    sides = [scene.plain(side) for side in row.sides]
    held = set().union(*(side.free_symbols for side in sides))
    (q,) = scene.q
    unknown = held - {*scene.parameters, *scene.definitions}
    if len(unknown) != 1:
        return statement
    (value,) = unknown
    named = statement.doubt and equilibrium_of(written.naming, value.name) == q.name
    if not named and not (value == q and of_equilibrium(written.text, written.start)):
        return statement
    if words := denies_equilibrium(written.text, written.start):
        doubt = f"it is read as an equilibrium, but the text says {words!r}: say what it is"
        return replace(statement, doubt=doubt)
    difference = (sides[0] - sides[1]).xreplace({value: q}).xreplace({**table})
    for vanishing in _left_over(truth, difference):
        note = f"{value} is read as {q} at an equilibrium"
        found = replace(row, sides=(scene.pressed(vanishing), S.Zero))
        return _said(statement, found, note)
    return statement


def _of_several(
    truth: Equations, statement: Statement, row: Published, written: Written
) -> Statement:
    """A place among several coordinates: it is that of all equilibria that the sentence leaves."""
    scene = truth.scene
    name, *others = (scene.plain(side) for side in row.sides)
    held = set().union(*(side.free_symbols for side in others))
    if held - {*scene.parameters, *scene.definitions}:
        return statement
    if statement.doubt and name.is_Symbol:
        return _beside_others(truth, statement, row, written)
    if statement.doubt or name not in scene.q:
        return statement
    if not of_equilibrium(written.text, written.start):
        return statement
    words = f"it is read as {name} at an equilibrium"
    sentence = sentence_around(written.text, written.start)
    places = [place for place in equilibria(truth) if _said_so(sentence, place, name)]
    if places and all(_vanishes(place[name.name] - others[0]) for place in places):
        found = replace(row, sides=(scene.pressed(places[0][name.name]), *row.sides[1:]))
        return _said(statement, found, words)
    doubt = f"{words}, of which it is one coordinate of several"
    return replace(statement, doubt=f"{doubt}: leave it out, or give the equations of motion")


def _beside_others(
    truth: Equations, statement: Statement, row: Published, written: Written
) -> Statement:
    """``theta_0 = 0`` beside ``x_0 = l + m g/k``: a coordinate of the equilibrium that has both."""
    scene = truth.scene
    name, value = (scene.plain(side) for side in row.sides)
    own = {n: equilibrium_of(written.naming, n) for n, _ in written.definitions}
    own[name.name] = equilibrium_of(written.naming, name.name)
    if own[name.name] is None or denies_equilibrium(written.text, written.start):
        return statement
    built = written.builder().defined
    said = {q: scene.plain(built[n]) for n, q in own.items() if q is not None and n in built}
    if {*said} != {q.name for q in scene.q} or len([q for q in own.values() if q]) != len(said):
        return statement
    note = f"{name} is read as {own[name.name]} at an equilibrium"
    for place in equilibria(truth):
        others = [place[q] - said[q] for q in said if q != own[name.name]]
        if all(map(_vanishes, others)):
            found = replace(row, sides=(scene.pressed(place[str(own[name.name])]), value))
            return _said(statement, found, note)
    return statement


def _said_so(sentence: str, place: Mapping[str, Expr], name: Symbol) -> bool:
    """Whether a sentence gives the other coordinates the values that they have at a place."""
    values = {
        q: re.search(rf"(?<!\w){re.escape(q)}\s*=\s*(0|\\?pi)\b", sentence)
        for q in place if q != name.name
    }  # fmt: skip
    return all(m is not None and str(place[q]) == m[1].lstrip("\\") for q, m in values.items())


def _said(statement: Statement, row: Published, note: str) -> Statement:
    notes = (*statement.notes, note)
    return replace(
        statement,
        row=row,
        doubt="",
        notes=notes,
        written=None,
        derived=True,
        demands=NO_DEMANDS,
    )  # where it has no value, there is no such equilibrium


def _left_over(truth: Equations, difference: Expr) -> Iterator[Expr]:
    """What accelerates at rest where a difference vanishes: of the factor that is worst."""
    scene = truth.scene
    still = dict.fromkeys((*scene.qd, *scene.u, *scene.ud, *scene.input_symbols), S.Zero)
    (force,) = (row.xreplace(still) for row in truth.residual)
    if is_zero(force):
        return  # it rests everywhere, so what is said of one place says nothing
    powers = (one.as_base_exp() for one in Mul.make_args(factor(difference)))
    parts = [base for base, exponent in powers if exponent.is_positive and base.free_symbols]
    found = [list(_where(scene, force, part)) for part in parts]
    held = [bool(part.free_symbols & {*scene.q}) for part in parts]
    if not all(some for some, of_place in zip(found, held, strict=True) if of_place):
        return
    every = [one for some in found for one in some]
    yield from [one for one in every if not _vanishes(one)][:1] or every[:1]


def _vanishes(expression: Expr) -> bool:
    try:
        return bool(is_zero(expression))
    except ExpressionError:
        return False


def _where(scene: Scene, force: Expr, part: Expr) -> Iterator[Expr]:
    """What a force is where a factor is zero; nothing where that is not found."""
    (q,) = scene.q
    for parameter in sorted(part.free_symbols & {*scene.parameters}, key=str):
        slope = part.diff(parameter)
        if slope != 0 and not slope.has(parameter):
            solved = (parameter - part / slope).cancel()
            if not solved.is_zero:  # m theta_0 = 0 says nothing of theta_0 where m vanishes
                yield force.xreplace({parameter: solved})
                return
    slope = part.diff(q)
    if slope != 0 and not slope.has(q):
        yield force.xreplace({q: q - part / slope})
    elif part.free_symbols == {q}:
        try:
            yield from (force.xreplace({q: root}) for root in solve(part, q))
        except NotImplementedError:
            return
