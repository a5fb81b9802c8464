"""Results as one self-contained HTML page: derivations, verdicts, published equations, motion.

Nothing is fetched from a network and no script runs; the page follows light and dark, wraps on a
phone, and prints.
"""

from collections.abc import Sequence

from markupsafe import Markup

from mechanics.report import words
from mechanics.report.coordinate_drawings import coordinate_drawings
from mechanics.report.drawing import drawing
from mechanics.report.environment import environment
from mechanics.report.motion import motion_charts, moving_figure, way
from mechanics.report.result import SystemResult
from mechanics.report.sections import (
    Section,
    derivations,
    matrix,
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
        tally=words.tally(f.verdict for r in results for f in words.all_findings(r)),
        ok=bool(results) and all(result.ok for result in results),
        checks=sum(len(result.claims) for result in results),
    )


def _section(number: int, result: SystemResult) -> Section:
    state, others, motion = shown_state(result), other_findings(result), result.motion
    steps, classes = derivations(result, state)
    return Section(
        number=number,
        result=result,
        tally=words.tally(f.verdict for f in words.all_findings(result)),
        drawing=Markup(
            drawing(result.scene, state, way(result.scene, motion.columns) if motion else None)
        ),
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
        moving=moving_figure(result.scene, motion.columns) if motion else None,
        swings=[
            [(caption, Markup(svg)) for caption, svg in swings(result.scene, modes.swings)]
            for modes in result.modes
        ],
        charts=motion_charts(result.scene, motion.columns, motion.units) if motion else [],
    )
