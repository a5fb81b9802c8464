"""Free-body diagrams: bodies cut free, with every load and reaction that acts on them as an arrow.

A reaction points as it is declared, and the other way on the body that it reacts on; a load points
as it acts at the state that is drawn, and one that is zero there as it acts where all coordinates,
speeds and inputs are a little larger. What is equal and opposite inside of the free body is left
out.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape

import numpy as np
from sympy import Expr, Mul, factor_terms

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

SMALL, LARGE, MARGIN = (310.0, 300.0), (400.0, 380.0), 80.0
MANY = 9
"""Arrows beyond which a drawing is large."""
COLOURS = 7
"""Of reactions; loads have one of their own."""
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
    near = _beside(view)
    groups = [(name, group, "load") for name, group in loads.items()]
    groups += [
        (mechanism.reactions[k].name, group, f"r{k % COLOURS}") for k, group in enumerate(units)
    ]
    every = [wrench for _, group, _ in groups for wrench in group]
    table = zip(_numbers(mechanism, view, every), _numbers(mechanism, near, every), strict=True)
    numbers = iter([(view, here) if _drawable(here) else (near, there) for here, there in table])

    def arrow(name: str, wrench: Wrench, kind: str) -> Arrow:
        at, row = next(numbers)
        words = svg_name(name) if kind != "load" else _size_of(printer, at, wrench, name)
        return Arrow(name, words, wrench.body, row[0], row[1], row[2], kind)

    return tuple(tuple(arrow(name, w, kind) for w in group) for name, group, kind in groups)


def _drawable(row: np.ndarray) -> bool:
    """Whether a force or couple has a size there: that of a spring of no length has none."""
    return bool(np.isfinite(row).all() and row[1:].any())


def _beside(view: View) -> View:
    """A state where what is zero by chance is not: all that moves is a little larger."""
    moving = (*view.scene.q, *view.scene.qd, *view.scene.u, *view.scene.input_symbols)
    larger = {s.name: view.values[s] + 0.02 * (k + 1) for k, s in enumerate(moving)}
    return view.at({**view.state, **larger})


def _numbers(mechanism: Mechanism, view: View, wrenches: Sequence[Wrench]) -> np.ndarray:
    """Position, force and couple of each, shape (N, 3, 3)."""
    nodes = [entry for w in wrenches for part in (w.at, w.force, w.couple) for entry in part]
    program = mechanism.builder.program({"entries": nodes})
    known = {symbol.name: value for symbol, value in view.values.items()}
    with np.errstate(all="ignore"):
        values = interpret(program, Arrays(), known, release=False)["entries"] if nodes else []
    return np.array([float(value) for value in values]).reshape(-1, 3, 3)


def _size_of(printer: Printer, view: View, wrench: Wrench, name: str) -> str:
    """The size of a load where that is a product of letters and of one sum, else its name."""
    entries = [e for e in printer.expanded((*wrench.force, *wrench.couple)) if e != 0]
    sizes = {_positive(factor_terms(entry), view) for entry in entries}
    return label(sizes.pop(), name) if len(sizes) == 1 else svg_name(name)


def _positive(entry: Expr, view: View) -> Expr:
    """An entry or its negative, whichever is positive at a state; a sign goes into the sum."""
    number, rest = entry.as_coeff_Mul()
    sums = [factor for factor in Mul.make_args(rest) if factor.is_Add]
    if len(sums) != 1:
        return Mul(abs(number), rest)
    if view.number(rest) < 0:
        rest = Mul(*(f for f in Mul.make_args(rest) if f is not sums[0]), -sums[0])
    return Mul(abs(number), rest, evaluate=False) if abs(number) != 1 else rest


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
    points += [view.point(body.centre) for body in bodies]
    points += [] if centre is None else [centre]
    size = LARGE if len(acting) > MANY else SMALL
    paper = paper_of(points, MARGIN, size)
    parts = [body_shape(view, paper, b, s) for b, s in zip(bodies, shapes, strict=True)]
    used: list[tuple[np.ndarray, np.ndarray]] = []
    parts += [_arrow(view, paper, arrow, _middle(view, paper, arrow), used) for arrow in acting]
    if centre is not None:
        parts.append(_mark(paper.place(centre), diagram.centre))
    names = ", ".join(dict.fromkeys(arrow.source for arrow in acting))
    title = f"Free-body diagram: {diagram.title}, with {names or 'nothing acting'}"
    title += f"; moments about {diagram.centre}" if diagram.centre else ""
    return (
        f'<svg class="drawing free" viewBox="0 0 {size[0]:.0f} {size[1]:.0f}" role="img"'
        f' aria-label="{escape(title)}">{"".join(apart(parts, [], size))}</svg>'
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
    """A force with its tip at the point where it pushes, its tail where it pulls; a couple.

    A couple is an arc in the plane; in space it is an arrow with two heads along its axis.
    """
    force = paper.turn(view.project(arrow.force))
    axis = np.zeros(2) if view.planar else paper.turn(view.project(arrow.couple))
    if np.hypot(*force) > 1e-9:
        at, along = paper.place(_acts(view, arrow)), unit(force)
        pushes = bool(along @ (middle - at) > 1e-6)
        start, end, outer = _shaft(at, along, pushes, used)
        drawn = strokes.arrow(start, end, "own")
    elif np.hypot(*axis) > 1e-9:
        start, end, outer = _shaft(middle, unit(axis), False, used)
        drawn = strokes.arrow(start, end, "own") + strokes.head(end - 7 * unit(axis), axis, "own")
    elif np.any(arrow.couple):
        taken = sum(np.allclose(middle, a) and not d.any() for a, d in used)
        used.append((middle, np.zeros(2)))
        sign = 1.0 if (arrow.couple if view.planar else -arrow.couple)[2] >= 0 else -1.0
        first, radius = (0.4 if sign > 0 else np.pi - 0.4), 30 + ASIDE * taken
        drawn, outer = strokes.arc(middle, radius, first, sign * 2.3, "own"), middle.copy()
        outer[1] -= radius + 14
    else:
        return ""
    drawn += strokes.text(outer, arrow.label, "own-name")
    return f'<g class="{slug(arrow.source)} arrow {arrow.colour}">{drawn}</g>'


def _shaft(
    at: np.ndarray, along: np.ndarray, pushes: bool, used: list[tuple[np.ndarray, np.ndarray]]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Start and end of a straight arrow beside those that are there, and where its name goes."""
    away = -along if pushes else along
    taken = sum(np.allclose(at, a) and away @ d > 0.99 for a, d in used)
    used.append((at, away))
    at = at + (taken + 1) // 2 * ASIDE * (-1) ** taken * normal(along)
    length = LENGTH + 0.6 * ASIDE * taken
    start, end = (at - length * along, at) if pushes else (at, at + length * along)
    return start, end, (start if pushes else end) + 14 * away


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
