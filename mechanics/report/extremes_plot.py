"""The pair of quantities that tells most, as an SVG file of its own.

Two maps: the default form of forward dynamics, and the form that fares most differently.
"""

import re
from html import escape

from mechanics.errors import InputError
from mechanics.extremes import Extremes
from mechanics.extremes.result import Figures, Visited
from mechanics.report.extremes import other_form, telling
from mechanics.report.extremes_map import CELL, LEGEND, heat_map, shade
from mechanics.report.style import plot_colours, template

GAP, HEAD, LINE, MARGIN = 40.0, 56.0, 19.0, 12.0
# Room for the longest line of the key.
LEAST = 660.0

SHEET = """
.sheet { background: var(--paper); }
.sheet .heat { max-width: none; height: revert-layer; }
.title { font: 600 15px var(--sans); fill: var(--ink); }
.form { font: 600 12.5px var(--sans); fill: var(--ink); }
.key-text { font: 11.5px var(--sans); fill: var(--muted); }
"""


def heat_plot(found: Extremes) -> str:
    """The SVG file.

    Raises
    ------
    InputError
        If no pair of quantities was walked.
    """
    chosen = telling(found, 1)
    if not chosen:
        raise InputError(f"{found.system}: it has no pair of quantities to draw")
    visited = chosen[0]
    forms = list(dict.fromkeys((found.default, other_form(found, visited))))
    maps = [_map(found, visited, form) for form in forms]
    size = [tuple(map(float, _viewbox(picture))) for picture in maps]
    width = max(LEAST, sum(w for w, _ in size) + GAP * (len(maps) - 1) + 2 * MARGIN)
    tall = max(h for _, h in size)
    parts = [_text("title", MARGIN, 22.0, _title(found, visited))]
    x = MARGIN
    for form, picture, (w, h) in zip(forms, maps, size, strict=True):
        said = " (default)" if form == found.default else ""
        parts.append(_text("form", x, 46.0, f"form {form}{said}"))
        place = f'<svg x="{x:g}" y="{HEAD:g}" height="{h:g}" '
        parts.append(picture.replace("<svg ", place, 1))
        x += w + GAP
    key, height = _key(found, visited, forms, HEAD + tall + 24.0)
    style = plot_colours() + SHEET + template("extremes")
    return (
        f'<svg class="sheet" xmlns="http://www.w3.org/2000/svg" width="{width:g}"'
        f' viewBox="0 0 {width:g} {height:g}" role="img" aria-label="Errors over'
        f' {escape(" and ".join(visited.walk.names))}"><style>{style}</style>'
        f"{''.join(parts)}{key}</svg>\n"
    )


def _title(found: Extremes, visited: Visited) -> str:
    return f"{found.system}: error over {' and '.join(visited.walk.names)}, double precision"


def _map(found: Extremes, visited: Visited, form: str) -> str:
    names = visited.walk.names
    units = [next(axis.unit for axis in found.axes if axis.name == name) for name in names]
    title = f"{' and '.join(names)}, form {form}"
    return heat_map(title, names, units, visited.walk.values, visited.figure(form, "double"))


def _viewbox(picture: str) -> tuple[str, str]:
    found = re.search(r'viewBox="0 0 (\S+) (\S+)"', picture)
    if found is None:
        raise ValueError("a map without a viewBox")
    return found.group(1), found.group(2)


def _key(found: Extremes, visited: Visited, forms: list[str], y: float) -> tuple[str, float]:
    """What the colours that occur mean, and where the sheet ends."""
    drawn: list[Figures] = [visited.figure(form, "double") for form in forms]
    count = len(drawn[0].causes)
    used = {shade(figures, i) for figures in drawn for i in range(count)}
    parts = []
    for name, letter, words in LEGEND:
        if name not in used:
            continue
        parts.append(
            f'<rect class="{name}" x="{MARGIN:g}" y="{y - CELL + 3:g}" width="{CELL:g}"'
            f' height="{CELL:g}" stroke="var(--line)"/>'
        )
        said = f"{letter}: {words}" if letter else words
        parts.append(_text("key-text", MARGIN + 22.0, y, said))
        y += LINE
    return "".join(parts), y


def _text(kind: str, x: float, y: float, words: str) -> str:
    return f'<text class="{kind}" x="{x:g}" y="{y:g}">{escape(words)}</text>'
