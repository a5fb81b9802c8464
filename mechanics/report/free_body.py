"""Free-body diagrams: bodies cut free, with every load and reaction that acts on them as an arrow.

A reaction points as it is declared, and the other way on the body that it reacts on; a load points
as it acts at the state that is drawn. What is equal and opposite inside of the free body is left
out.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape

import numpy as np
from sympy import Expr, Mul

from mechanics.equations import Diagram, Equations
from mechanics.kinematics import chain
from mechanics.kinematics.printer import Printer
from mechanics.mechanism import Mechanism
from mechanics.program import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.report import strokes
from mechanics.report.drawing import body_shape, outline, paper_of
from mechanics.report.label_places import apart
from mechanics.report.notation import svg_name
from mechanics.report.projection import Paper, View, normal, unit
from mechanics.report.supports import label
from mechanics.report.typeset import slug
from mechanics.routes.loads import Wrench, acting_reactions, applied
from mechanics.scene import Particle

WIDTH, HEIGHT, MARGIN = 300.0, 290.0, 72.0
LENGTH = 46.0
"""Of an arrow, in pixels."""
ASIDE = 13.0
"""Between arrows that would lie on each other."""


@dataclass(frozen=True)
class Arrow:
    """A force or couple at the state that is drawn, in inertial components."""

    source: str
    label: str
    body: int
    at: np.ndarray
    force: np.ndarray
    couple: np.ndarray
    colour: str


def arrows(equations: Equations, view: View) -> tuple[tuple[Arrow, ...], ...]:
    """For each load and reaction its arrows on the bodies; those of a pair have one colour."""
    mechanism, _ = equations.program
    motions = chain.motions(mechanism)
    units = acting_reactions(mechanism, motions.poses)
    loads: dict[str, list[Wrench]] = {}
    for load in applied(mechanism, motions):
        loads.setdefault(load.name, []).append(load)
    printer = Printer(equations.scene, mechanism)
    groups = [(name, group, "load") for name, group in loads.items()]
    groups += [(mechanism.reactions[k].name, group, f"r{k % 8}") for k, group in enumerate(units)]
    every = [wrench for _, group, _ in groups for wrench in group]
    numbers = iter(_numbers(mechanism, view, every))
    return tuple(
        tuple(
            Arrow(name, _name(printer, name, wrench, kind), wrench.body, *next(numbers), kind)
            for wrench in group
        )
        for name, group, kind in groups
    )


def _numbers(
    mechanism: Mechanism, view: View, wrenches: Sequence[Wrench]
) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Position, force and couple of each."""
    nodes = [entry for w in wrenches for part in (w.at, w.force, w.couple) for entry in part]
    program = mechanism.builder.program({"entries": nodes})
    known = {symbol.name: value for symbol, value in view.values.items()}
    values = interpret(program, Arrays(), known, release=False)["entries"] if nodes else []
    table = np.array([float(value) for value in values]).reshape(-1, 3, 3)
    return [(row[0], row[1], row[2]) for row in table]


def _name(printer: Printer, name: str, wrench: Wrench, kind: str) -> str:
    """The symbol of a reaction; of a load its size where that is a product of letters."""
    if kind != "load":
        return svg_name(name)
    sizes = {_size(entry) for entry in printer.expanded((*wrench.force, *wrench.couple)) if entry}
    return label(sizes.pop(), name) if len(sizes) == 1 else svg_name(name)


def _size(entry: Expr) -> Expr:
    number, rest = entry.as_coeff_Mul()
    return Mul(abs(number), rest)


def free_body_diagram(
    equations: Equations, view: View, found: Sequence[Sequence[Arrow]], diagram: Diagram
) -> str:
    """One free body as an SVG element.

    Parameters
    ----------
    equations : Equations
    view : View
    found : sequence of sequence of Arrow
        As `arrows` gives them.
    diagram : Diagram
    """
    mechanism, _ = equations.program
    bodies = [view.scene.bodies[index] for index in diagram.bodies]
    shapes = [outline(view, body) for body in bodies]
    acting = [arrow for group in found for arrow in _crossing(group, diagram.bodies)]
    centre = _place(mechanism, view, diagram)
    points = [corner for shape in shapes for corner in shape]
    points += [_acts(view, arrow) for arrow in acting if np.any(arrow.force)]
    points += [] if centre is None else [centre]
    paper = paper_of(points, MARGIN, (WIDTH, HEIGHT))
    parts = [body_shape(view, paper, b, s) for b, s in zip(bodies, shapes, strict=True)]
    used: list[tuple[np.ndarray, np.ndarray]] = []
    parts += [_arrow(view, paper, arrow, _middle(view, paper, arrow), used) for arrow in acting]
    if centre is not None:
        parts.append(_mark(paper.place(centre), diagram.centre))
    names = ", ".join(dict.fromkeys(arrow.source for arrow in acting))
    title = f"Free-body diagram: {diagram.title}, with {names or 'nothing acting'}"
    title += f"; moments about {diagram.centre}" if diagram.centre else ""
    return (
        f'<svg class="drawing free" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img"'
        f' aria-label="{escape(title)}">{"".join(apart(parts, [], (WIDTH, HEIGHT)))}</svg>'
    )


def _crossing(group: Sequence[Arrow], inside: Sequence[int]) -> list[Arrow]:
    """Arrows on these bodies, but those that balance each other there."""
    own = [arrow for arrow in group if arrow.body in inside]
    pair = len(own) == len(group) == 2
    if (
        pair
        and np.allclose(own[0].force, -own[1].force)
        and np.allclose(own[0].couple, -own[1].couple)
    ):
        return []
    return own


def _place(mechanism: Mechanism, view: View, diagram: Diagram) -> np.ndarray | None:
    if not diagram.place:
        return None
    program = mechanism.builder.program({"entries": list(diagram.place)})
    known = {symbol.name: value for symbol, value in view.values.items()}
    values = interpret(program, Arrays(), known, release=False)["entries"]
    return view.project(np.array([float(value) for value in values]))


def _acts(view: View, arrow: Arrow) -> np.ndarray:
    """Where a force acts, on paper: with the body, which may be drawn aside.

    The pull of a rope is declared where the rope turns; a particle feels it where it is.
    """
    body = view.scene.bodies[arrow.body]
    if isinstance(body, Particle):
        return view.point(body.centre)
    place: np.ndarray = view.project(arrow.at) + view.slack.get(body.centre, 0.0)
    return place


def _middle(view: View, paper: Paper, arrow: Arrow) -> np.ndarray:
    return paper.place(view.point(view.scene.bodies[arrow.body].centre))


def _arrow(
    view: View,
    paper: Paper,
    arrow: Arrow,
    middle: np.ndarray,
    used: list[tuple[np.ndarray, np.ndarray]],
) -> str:
    """A force with its tip at the point where it pushes, its tail where it pulls; a couple."""
    force = paper.turn(view.project(arrow.force))
    drawn = []
    if np.hypot(*force) > 1e-9:
        at, along = paper.place(_acts(view, arrow)), unit(force)
        pushes = along @ (middle - at) > 1e-6
        away = -along if pushes else along
        taken = sum(np.allclose(at, a) and away @ d > 0.99 for a, d in used)
        used.append((at, away))
        at = at + (taken + 1) // 2 * ASIDE * (-1) ** taken * normal(along)
        length = LENGTH + 1.6 * ASIDE * taken
        start, end = (at - length * along, at) if pushes else (at, at + length * along)
        outer = start - 14 * along if pushes else end + 14 * along
        drawn += [strokes.arrow(start, end, "own"), strokes.text(outer, arrow.label, "own-name")]
    elif np.any(arrow.couple):
        sign = 1.0 if (arrow.couple if view.planar else -arrow.couple)[2] >= 0 else -1.0
        start = 0.4 if sign > 0 else np.pi - 0.4
        drawn.append(strokes.arc(middle, 30, start, sign * 2.3, "own"))
        drawn.append(strokes.text(middle + np.array([0.0, -44.0]), arrow.label, "own-name"))
    if not drawn:
        return ""
    return f'<g class="{slug(arrow.source)} arrow {arrow.colour}">{"".join(drawn)}</g>'


def _mark(at: np.ndarray, name: str) -> str:
    """The moment centre: a ring with a point."""
    return (
        strokes.dot(at, 6, "centre")
        + strokes.dot(at, 1.8, "ink")
        + strokes.text(at + np.array([16.0, 14.0]), svg_name(name), "name")
    )


def marks(found: Sequence[Sequence[Arrow]]) -> Mapping[str, None]:
    """Classes of what is drawn, for the rules that light an arrow."""
    return dict.fromkeys(slug(arrow.source) for group in found for arrow in group)
