"""A motion as a moving picture: one SVG file, without scripts and network.

The parts of the drawing are drawn at samples of the motion, on one sheet of paper. What differs
from one sample to the next becomes a list of values that the browser goes through in the time that
the motion takes (SMIL). Who prefers less motion, or prints, sees a few poses on one sheet.
"""

from collections.abc import Mapping, Sequence
from html import escape
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from mechanics.report.coordinates import aside_of
from mechanics.report.drawing import (
    HEIGHT,
    WIDTH,
    directions,
    few_of,
    paper_for,
    picture,
    plain_picture,
)
from mechanics.report.projection import View
from mechanics.report.style import colours, drawing_rules
from mechanics.scene import Scene

SMOOTH, COARSE = 24, 10
"""Samples a second of a file, and of a page with much else on it."""
FEWEST, MOST = 24, 240
"""Samples of a motion that are drawn."""
LARGEST_TURN = 1.0
"""From one picture to the next, in rad."""
SLOW = 12.0
"""Seconds that a motion takes on the page which is too fast to be watched."""
POSES = 5
"""Poses in the strip of a motion that does not move."""
Element = ElementTree.Element


def animation(
    scene: Scene, times: NDArray[np.float64], coordinates: Mapping[str, NDArray[np.float64]]
) -> str:
    """A motion as an SVG document that repeats it for ever.

    Parameters
    ----------
    scene : Scene
    times : array, shape (N,)
        In s, from 0.
    coordinates : mapping of str to array, shape (N,)
        By plain name.
    """
    sheet = f'<rect class="sheet" width="{WIDTH:.0f}" height="{HEIGHT:.0f}" rx="6"/>'
    inner = f"<style>{_style()}</style>{sheet}"
    return moving_picture(scene, times, coordinates, SMOOTH, inner, XMLNS) + "\n"


XMLNS = ' xmlns="http://www.w3.org/2000/svg"'


def moving_picture(
    scene: Scene,
    times: NDArray[np.float64],
    coordinates: Mapping[str, NDArray[np.float64]],
    rate: float = COARSE,
    before: str = "",
    attributes: str = "",
    title: str = "",
) -> str:
    """A motion as an SVG element of a page that has the colours of drawings.

    `rate` is how many samples a second are drawn; `before` stands under the picture.
    `title` says what moves; by default the scene and how long.
    """
    duration = float(times[-1])
    corner, parts = frames(scene, times, coordinates, rate)
    moving = "".join(_moving(part, duration) for part in zip(*parts, strict=True))
    title = escape(title or f"{scene.name} in motion, {duration:.3g} s")
    return (
        f'<svg{attributes} class="drawing" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img"'
        f' aria-label="{title}"><title>{title}</title>{before}'
        f'{corner}<g class="moving">{moving}</g><g class="still">{_strip(parts)}</g></svg>'
    )


def frames(
    scene: Scene,
    times: NDArray[np.float64],
    coordinates: Mapping[str, NDArray[np.float64]],
    rate: float,
) -> tuple[str, list[list[str]]]:
    """What is drawn on one sheet of paper: directions, which rest, and the parts at each sample."""
    count = int(np.clip(rate * float(times[-1]), FEWEST, MOST)) + 1
    # The view of the farthest places says how long springs are drawn that the scene leaves out.
    farthest = {name: float(np.abs(x).max()) for name, x in coordinates.items()}
    first = View(scene, farthest, motion=coordinates)
    views = [
        first.at({name: float(np.interp(t, times, x)) for name, x in coordinates.items()})
        for t in np.linspace(0, float(times[-1]), count)
    ]
    paper = paper_for(views)
    large, small = plain_picture(views[0], paper, moving=True)
    asides = [aside_of(views[0], paper, q, [*large, *small]) for q in few_of(scene)]
    parts = [picture(view, paper, asides) for view in views]
    return directions(views[0], paper, [p for part in parts for p in part]), parts


def watchable(
    times: NDArray[np.float64], angles: Sequence[NDArray[np.float64]]
) -> tuple[int, float]:
    """How many samples of a motion are shown, and how many times slower.

    Turns of more than `LARGEST_TURN` from one picture to the next look like others, or backwards.
    """
    if not angles:
        return len(times), 1.0
    turned = np.cumsum(np.abs(np.diff(angles, axis=1)), axis=1)
    pictures = np.concatenate([[0.0], turned.max(axis=0)]) / LARGEST_TURN
    if pictures[-1] <= max(COARSE * times[-1], FEWEST):
        return len(times), 1.0
    shown = max(int(np.searchsorted(pictures, SLOW * COARSE, side="right")), 2)
    slower = pictures[shown - 1] / COARSE / times[shown - 1]
    return shown, float(max(slower, 1.0))


def _strip(frames: Sequence[Sequence[str]]) -> str:
    """A few poses on one sheet, the later ones stronger."""
    places = np.linspace(0, len(frames) - 1, POSES, endpoint=False).round().astype(int)
    shares = np.linspace(0.25, 1, POSES)
    return "".join(
        f'<g opacity="{share:.2g}">{"".join(frames[place])}</g>'
        for place, share in zip(places, shares, strict=True)
    )


def _moving(part: Sequence[str], duration: float) -> str:
    """One part of the drawing at all samples, as elements whose attributes are animated."""
    samples = [list(ElementTree.fromstring(f"<g>{text}</g>")) for text in part]
    if len({_structure(elements) for elements in samples}) == 1:
        together = [_merged(same, duration) for same in zip(*samples, strict=True)]
        return "".join(ElementTree.tostring(e, encoding="unicode") for e in together)
    return "".join(_shown(text, k, len(part), duration) for k, text in enumerate(part))


def _structure(elements: Sequence[Element]) -> str:
    """What has to be the same for attributes to be animated: tags, styles, words, corners."""
    return " ".join(
        f"{e.tag}.{e.get('class')}.{''.join(e.itertext())}.{e.get('points', '').count(',')}"
        for e in elements
    )


def _merged(same: Sequence[Element], duration: float) -> Element:
    first = same[0]
    for name in list(first.attrib):
        values = [element.get(name, "") for element in same]
        if len(set(values)) > 1:
            ElementTree.SubElement(
                first,
                "animate",
                attributeName=name,
                values=";".join(values),
                dur=f"{duration:.4g}s",
                repeatCount="indefinite",
            )
    return first


def _shown(text: str, place: int, count: int, duration: float) -> str:
    """One sample of a part whose elements change, seen while it is its turn."""
    begin, end = place / count, (place + 1) / count
    times = f"0;{begin:.5f};{end:.5f}" if place else f"0;{end:.5f};1"
    values = "none;inline;none" if place else "inline;none;none"
    return (
        f'<g display="none">{text}<animate attributeName="display" values="{values}"'
        f' keyTimes="{times}" dur="{duration:.4g}s" calcMode="discrete"'
        ' repeatCount="indefinite"/></g>'
    )


def _style() -> str:
    """The rules of the pages that a drawing needs, under light and dark colours."""
    light, dark = colours()
    return (
        f":root {{{light}}} @media (prefers-color-scheme: dark) {{ :root {{{dark}}} }}"
        f" {drawing_rules()} .sheet {{ fill: var(--sheet); }}"
        " @media (prefers-reduced-motion: reduce), print"
        " { .moving { display: none; } .drawing .still { display: inline; } }"
    )
