"""A motion as figures, the scene as it moves beside its curves, and as a file of its own.

write_motion(scene, columns, units, note, path)  -->  .svg, .gif, or .html, a page
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from markupsafe import Markup

from mechanics.export.atomic import replaced_file
from mechanics.report import charts
from mechanics.report.animation import animation, moving_picture, watchable
from mechanics.report.charts import Chart
from mechanics.report.drawing import outline
from mechanics.report.environment import environment
from mechanics.report.gif import renderer, write_gif
from mechanics.report.projection import View
from mechanics.report.sections import angles, unit_of
from mechanics.scene import Scene
from mechanics.simulate.file_names import writable

ENERGY = "_energy"
REAL_TIME = "The scene in real time"
FAR = 6.0
"""Times the size of a scene that its bodies are followed."""
SUFFIXES = (".svg", ".html", ".gif")
Columns = Mapping[str, Any]
"""Arrays of shape (N,) by plain name: ``t`` in s, coordinates, inputs, energies."""


def way(scene: Scene, columns: Columns) -> dict[str, Any]:
    """Coordinates and inputs along a motion."""
    moving = (s.name for s in (*scene.q, *scene.input_symbols))
    return {name: np.asarray(columns[name]) for name in moving if name in columns}


def moving_figure(scene: Scene, columns: Columns) -> tuple[str, Markup]:
    """The scene as it moves, and how fast."""
    words, times, coordinates = _shown(scene, columns)
    return words, Markup(moving_picture(scene, times, coordinates))


def motion_charts(scene: Scene, columns: Columns, units: Mapping[str, str]) -> list[Chart]:
    """Coordinates by unit, then energies."""
    turning = angles(scene)
    groups: dict[tuple[str, str], list[str]] = {}
    for q in scene.q:
        if q.name in columns:
            unit = units.get(q.name) or unit_of(scene, turning, q)
            kind = "Angles" if unit == "rad" else "Coordinates"
            groups.setdefault((kind, unit), []).append(q.name)
    energies = [name for name in columns if name.endswith(ENERGY)]
    groups |= {("Energy", "J"): energies} if energies else {}
    return [_chart(columns, kind, unit, names) for (kind, unit), names in groups.items()]


def motion_html(scene: Scene, columns: Columns, units: Mapping[str, str], note: str) -> str:
    """One page that fetches nothing and runs no script."""
    return (
        environment()
        .get_template("motion.html")
        .render(
            name=scene.name,
            note=note,
            moving=moving_figure(scene, columns),
            charts=motion_charts(scene, columns, units),
        )
    )


def supported(path: str | Path) -> Path:
    """The path of a moving picture, if a file of this kind can be written there.

    Raises
    ------
    InputError
        For another suffix, a folder that does not exist, or GIF without resvg-py.
    """
    target = writable(path, SUFFIXES)
    if target.suffix.lower() == ".gif":
        renderer(f"file {target.name}")
    return target


def write_motion(
    scene: Scene, columns: Columns, units: Mapping[str, str], note: str, path: str | Path
) -> str:
    """Write a moving picture, and say what is slower than the motion; the suffix says how."""
    target = supported(path)
    words, times, coordinates = _shown(scene, columns)
    with replaced_file(target) as fresh:
        if target.suffix.lower() == ".gif":
            write_gif(scene, times, coordinates, fresh)
        elif target.suffix.lower() == ".html":
            fresh.write_text(motion_html(scene, columns, units, note), encoding="utf-8")
        else:
            fresh.write_text(animation(scene, times, coordinates), encoding="utf-8")
    return words if words != REAL_TIME else ""


def _shown(scene: Scene, columns: Columns) -> tuple[str, Any, dict[str, Any]]:
    """How fast a motion is shown, in words; its times on the page; its coordinates then."""
    coordinates, times = way(scene, columns), np.asarray(columns["t"])
    near = _near(scene, coordinates, len(times))
    times, coordinates = times[:near], {name: x[:near] for name, x in coordinates.items()}
    shown, slower = watchable(times, [coordinates[q.name] for q in angles(scene)])
    part = f"The first {times[shown - 1]:.2g} s" if shown < len(columns["t"]) else ""
    if slower >= 1.05:
        words = f"{part or 'The scene'}, {slower:.2g} times slower"
    else:
        words = f"{part} in real time" if part else REAL_TIME
    return words, slower * times[:shown], {n: x[:shown] for n, x in coordinates.items()}


def _near(scene: Scene, coordinates: Mapping[str, Any], count: int) -> int:
    """How many samples are shown of a motion that leads far away, where bodies would be dots."""
    view = View(scene, {name: float(x[0]) for name, x in coordinates.items()})
    corners = [corner for body in scene.bodies for corner in outline(view, body)]
    corners += [view.point(point) for point in view.loaded]
    size = float(np.max(np.ptp(np.array(corners), axis=0)))
    moving = View(scene, view.state, motion=coordinates)
    paths = np.concatenate([moving.way(body.centre) for body in scene.bodies], axis=1)
    away = np.abs(paths - paths[0]).max(axis=1)
    if size == 0 or away.max() <= FAR * size:
        return count
    return max(int(np.argmax(away > FAR * size)) * count // len(away), 2)


def _chart(columns: Columns, title: str, unit: str, names: Sequence[str]) -> Chart:
    curves: Mapping[str, Sequence[float]] = {name: columns[name] for name in names}
    label = f"{title} over time: {', '.join(name.replace('_', ' ') for name in names)}"
    svg = charts.line_chart(label, columns["t"], curves, unit)
    legend = tuple((Markup(charts.key(n)), name) for n, name in enumerate(names))
    return Chart(title, Markup(svg), legend)
