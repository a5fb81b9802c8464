"""Results as one self-contained HTML page: derivations, verdicts, published equations, motion.

Nothing is fetched from a network and no script runs; the page follows light and dark, wraps on a
phone, and prints.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from markupsafe import Markup

from mechanics.report import words
from mechanics.report.animation import moving_picture, watchable
from mechanics.report.coordinate_drawings import coordinate_drawings
from mechanics.report.drawing import drawing
from mechanics.report.environment import environment
from mechanics.report.result import SystemResult
from mechanics.report.sections import (
    Section,
    angles,
    derivations,
    matrix,
    motion_charts,
    motion_rows,
    open_rows,
    other_findings,
    published_rows,
    reactions,
    residual_rows,
    shown_state,
    speeds,
    symbol_rows,
)
from mechanics.report.swing import swings


def to_html(results: Sequence[SystemResult]) -> str:
    """The report of a cross-check.

    Parameters
    ----------
    results : sequence of SystemResult

    Returns
    -------
    str
        A whole page.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, z, (m, g) = ReferenceFrame("N"), Point("O"), dynamicsymbols("z"), (
    ...     parameters("m g", "kg m/s^2", "2 9.81"))
    >>> P = O.locatenew("P", z * N.z)
    >>> stone = Scene("stone", N, O, (z,), (Particle("stone", P, m),),
    ...     loads=(gravity(-g * N.z),))
    >>> result = crosscheck(stone, CrossCheck(("kane", "lagrange"), states=0))
    >>> to_html([result])[:15]
    '<!DOCTYPE html>'
    """
    page = environment().get_template("page.html")
    return page.render(
        sections=[_section(n, result) for n, result in enumerate(results, start=1)],
        tally=words.tally(f for result in results for f in words.all_findings(result)),
        ok=bool(results) and all(result.ok for result in results),
        checks=sum(len(result.claims) for result in results),
    )


def _section(number: int, result: SystemResult) -> Section:
    state, others = shown_state(result), other_findings(result)
    steps, classes = derivations(result, state)
    return Section(
        number=number,
        result=result,
        tally=words.tally(words.all_findings(result)),
        drawing=Markup(drawing(result.scene, state, _way(result))),
        coordinates=[
            (names, Markup(svg)) for names, svg in coordinate_drawings(result.scene, state)
        ],
        derivations=steps,
        marks=classes,
        motions=motion_rows(result),
        symbols=symbol_rows(result.scene, state),
        matrix=matrix(result),
        speeds=speeds(result),
        reactions=reactions(result),
        published=published_rows(result, number),
        open=open_rows(result, number),
        doubtful=[
            finding
            for finding in (*others, *result.witnesses)
            if finding in result.open or finding in result.causes
        ],
        others=[f for f in others if f.shown and f not in result.causes],
        witnesses=[finding for finding in result.witnesses if finding not in result.open],
        residuals=residual_rows(result),
        moving=_moving(result),
        swings=[
            [(caption, Markup(svg)) for caption, svg in swings(result.scene, modes.swings)]
            for modes in result.modes
        ],
        charts=motion_charts(result),
    )


def _moving(result: SystemResult) -> tuple[str, Markup] | None:
    """The scene as it moves, where there is a motion, and how fast."""
    coordinates = _way(result)
    if result.motion is None or coordinates is None:
        return None
    turning = [coordinates[q.name] for q in angles(result.scene)]
    times = np.asarray(result.motion.columns["t"])
    shown, slower = watchable(times, turning)
    words = "The scene in real time"
    if slower > 1:
        words = f"The first {times[shown - 1]:.2g} s, {slower:.2g} times slower"
        coordinates = {name: values[:shown] for name, values in coordinates.items()}
    return words, Markup(moving_picture(result.scene, slower * times[:shown], coordinates))


def _way(result: SystemResult) -> dict[str, Any] | None:
    """Coordinates and inputs along the motion, where there is one."""
    if result.motion is None:
        return None
    columns, scene = result.motion.columns, result.scene
    moving = (s.name for s in (*scene.q, *scene.input_symbols))
    return {name: np.asarray(columns[name]) for name in moving if name in columns}
