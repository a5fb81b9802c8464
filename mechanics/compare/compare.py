"""`compare`: another engine's answers beside ours, and why they differ."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from flint import arb
from numpy.typing import ArrayLike

from mechanics.compare.change import Array
from mechanics.compare.engines import Engine, engine
from mechanics.compare.ours import Ours, of_scene
from mechanics.compare.projection import admitted
from mechanics.compare.quantities import (
    UNITS,
    Answer,
    checked,
    kind_of,
    observed,
    predicted,
)
from mechanics.compare.search import Explanation, Seen, explain
from mechanics.compare.states import States, draw
from mechanics.errors import wanted
from mechanics.importers import as_scene
from mechanics.kernel import Finding, Verdict, refuted, supported
from mechanics.scene import Scene

STATES = 16


@dataclass(frozen=True, eq=False)
class Row:
    """One quantity.

    Attributes
    ----------
    quantity : str
    unit : str
    difference : float
        The largest, in the unit; accelerations by the forces that they are apart.
    allowed : float
        What is rounding.
    finding : Finding
    """

    quantity: str
    unit: str
    difference: float
    allowed: float
    finding: Finding

    @property
    def alike(self) -> bool:
        """Whether both are arrays of the same shape."""
        return bool(np.isfinite(self.difference))


@dataclass(frozen=True, eq=False)
class Cause:
    """Why numbers differ.

    Attributes
    ----------
    names : tuple of str
        In the table of causes.
    words : str
    quantities : tuple of str
        What it explains.
    finding : Finding
        The numbers are those of our changed scene: SUPPORTED at most.
    """

    names: tuple[str, ...]
    words: str
    quantities: tuple[str, ...]
    finding: Finding


@dataclass(frozen=True, eq=False)
class Comparison:
    """What came of a comparison.

    Attributes
    ----------
    scene, against : str
    states : int
    rows : tuple of Row
    causes : tuple of Cause
    others : tuple of Cause
        That would explain the same numbers: they cannot be told apart here.
    proof : Finding or None
        Two principles give the motion of the changed scene, whatever the amounts are.
    notes : tuple of str
        What the engine was asked to leave out.
    """

    scene: str
    against: str
    states: int
    rows: tuple[Row, ...]
    causes: tuple[Cause, ...] = ()
    others: tuple[Cause, ...] = ()
    proof: Finding | None = None
    notes: tuple[str, ...] = field(default=())

    @property
    def agree(self) -> bool:
        """Whether all numbers are ours, but for rounding."""
        return all(row.finding.verdict is Verdict.SUPPORTED for row in self.rows)

    @property
    def unexplained(self) -> tuple[str, ...]:
        """Quantities that differ for no cause of the table."""
        told = {quantity for cause in self.causes for quantity in cause.quantities}
        return tuple(
            row.quantity
            for row in self.rows
            if row.finding.verdict is not Verdict.SUPPORTED and row.quantity not in told
        )


def compare(
    scene: Scene,
    answers: Mapping[str, Answer] | Engine | str,
    *,
    values: Mapping[str, float] | None = None,
    states: Sequence[tuple[ArrayLike, ...]] | int = STATES,
    rounding: float = 0.0,
    name: str = "answers",
    file: Path | None = None,
) -> Comparison:
    """Compare another engine with a scene, and name the cause where they differ.

    Parameters
    ----------
    scene : Scene
    answers : mapping of str to callable, Engine, or str
        From a quantity to a function of q and v, and of what else it takes:
        ``{"inverse_dynamics": lambda q, v, a: ...}``; see `mechanics.compare.quantities`. Or the
        name of an engine, ``"pinocchio"``, whose model is made from the scene.
    values : mapping of str to float, optional
        Of parameters; the others have their typical values.
    states : int or sequence of (q, v[, a[, forces]])
        How many are drawn; or those at which the answers are known.
    rounding : float
        Half a unit of the last digit, where answers were printed.
    name : str
        Of the answers, for people.
    file : Path, optional
        Of the model that the scene was read from, for an engine that is named: it reads it, too.

    Raises
    ------
    SceneError
        When the scene cannot be right.
    InputError
        For a quantity, frame or engine that there is not, one that is not installed, and answers
        that are no numbers.

    Examples
    --------
    >>> from math import sin
    >>> from systems import rod_pendulum
    >>> answers = {"inverse_dynamics": lambda q, v, a: [a[0] / 3 + 5 * sin(q[0])]}
    >>> comparison = compare(rod_pendulum.scene(), answers)
    >>> comparison.agree, comparison.causes[0].names
    (False, ('gravity',))
    """
    scene = as_scene(scene)
    wanted(scene, Scene, "compare", "pass what scene() of a system gives")
    ours = of_scene(scene, values)
    if isinstance(answers, str):
        answers = engine(answers, ours, file)
    if isinstance(answers, Engine):
        name, notes, answers = answers.name, answers.notes, answers.answers
    else:
        notes = ()
    given = _given(ours, states)
    quantities = checked(ours, answers)
    seen = Seen(ours, given, {q: observed(q, answers[q], given) for q in quantities}, rounding)
    rows = tuple(_row(seen, quantity, name) for quantity in quantities)
    differing = [row.quantity for row in rows if row.finding.verdict is not Verdict.SUPPORTED]
    if not differing:
        return Comparison(scene.name, name, len(given), rows, notes=notes)
    causes, others = explain(seen, differing)
    return Comparison(
        scene.name,
        name,
        len(given),
        rows,
        tuple(_cause(seen, explanation, name) for explanation in causes),
        tuple(_cause(seen, explanation, name) for explanation in others),
        ours.proof() if causes else None,
        notes,
    )


def _given(ours: Ours, states: Sequence[tuple[ArrayLike, ...]] | int) -> States:
    if isinstance(states, int):
        return admitted(ours, draw(ours.scene, states, ours.values))
    size = len(ours.speeds)
    columns: list[list[Array]] = [[], [], [], []]
    for state in states:
        padded = [*state, *([np.zeros(size)] * (4 - len(state)))]
        for column, entry in zip(columns, padded, strict=True):
            column.append(np.asarray(entry, dtype=float))
    q, v, a, f = (np.stack(column) for column in columns)
    return States(q, v, a, f, draw(ours.scene, len(q), ours.values).wrench)


def _row(seen: Seen, quantity: str, name: str) -> Row:
    found = predicted(seen.ours, quantity, seen.states)
    apart, allowed = seen.between(quantity, found, seen.observed[quantity])
    return Row(
        quantity,
        UNITS[kind_of(quantity)],
        apart,
        allowed,
        _finding(seen, quantity, f"{name} = ours: {quantity}", found, allowed),
    )


def _alike(seen: Seen, quantity: str, found: Array) -> tuple[Array, Array]:
    """Our numbers and theirs, as they are compared."""
    return seen.comparable(quantity, found), seen.comparable(quantity, seen.observed[quantity])


def _finding(seen: Seen, quantity: str, subject: str, found: Array, allowed: float) -> Finding:
    """SUPPORTED where each number lies within the rounding of ours, else REFUTED at a state."""
    other = seen.observed[quantity]
    if found.shape != other.shape:
        words = "the shapes differ"
        return refuted(subject, words, str(found.shape[1:]), str(other.shape[1:]))
    one, two = _alike(seen, quantity, found)
    words = f"within {allowed:.1e} at {len(seen.states)} states"
    apart = np.abs(one - two)
    worst = np.unravel_index(int(apart.argmax()), apart.shape)
    if apart[worst] <= allowed:
        samples = [
            (arb(float(x), allowed), float(y)) for x, y in zip(one.flat, two.flat, strict=True)
        ]
        return supported(subject, samples, words)
    state = [
        (symbol.name, repr(float(value)))
        for symbols, values in (
            (seen.ours.scene.q, seen.states.q),
            (seen.ours.scene.u, seen.states.v),
        )
        for symbol, value in zip(symbols, values[worst[0]], strict=True)
    ]
    place = "".join(f"[{k}]" for k in worst[1:])
    return refuted(
        subject,
        f"they differ by {apart[worst]:.1e}, and {allowed:.1e} is rounding, in {quantity}{place}",
        arb(float(one[worst]), allowed),
        float(two[worst]),
        state,
    )


def _cause(seen: Seen, explanation: Explanation, name: str) -> Cause:
    findings = []
    for quantity in explanation.quantities:
        found = predicted(seen.ours, quantity, seen.states, explanation.reading)
        _, allowed = seen.between(quantity, found, seen.observed[quantity])
        one, two = _alike(seen, quantity, found)
        findings += [
            (arb(float(x), allowed), float(y)) for x, y in zip(one.flat, two.flat, strict=True)
        ]
    words = f"{len(findings)} numbers at {len(seen.states)} states are those of the changed scene"
    subject = f"{name} = ours, if {explanation.words}"
    finding = supported(subject, findings, words)
    return Cause(explanation.causes, explanation.words, explanation.quantities, finding)
