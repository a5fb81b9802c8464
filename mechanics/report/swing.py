"""Mode shapes that swing: the scene along each shape, in one period after the other.

q = A a sin(omega t), of a size that can be seen: what moves farthest moves `FARTHEST` on paper.
Periods are drawn equally long, whatever omega is, which the words beside a picture tell.
"""

import math
from collections.abc import Mapping

import numpy as np

from mechanics.report.animation import moving_picture
from mechanics.report.drawing import attached, paper_for
from mechanics.report.projection import View
from mechanics.report.result import Swing
from mechanics.scene import Scene

PERIOD = 2.0
"""Seconds that a period takes on the page."""
FARTHEST = 36.0
"""Pixels."""
TURN = 0.3
"""Radians."""


def swings(scene: Scene, modes: tuple[Swing, ...]) -> list[tuple[str, str]]:
    """Words and a picture for each mode."""
    return [(_words(mode), _picture(scene, mode)) for mode in modes]


def _words(mode: Swing) -> str:
    frequency = mode.omega / (2 * math.pi)
    return f"Mode {mode.number}: {frequency:.4g} Hz, a period drawn in {PERIOD:g} s"


def _picture(scene: Scene, mode: Swing) -> str:
    size = _size(scene, mode.shape)
    times = np.linspace(0, PERIOD, 25)
    phase = size * np.sin(2 * math.pi * times / PERIOD)
    columns = {q.name: mode.shape.get(q.name, 0.0) * phase for q in scene.q}
    return moving_picture(scene, times, columns, title=f"{scene.name}: mode {mode.number}")


def _size(scene: Scene, shape: Mapping[str, float]) -> float:
    """A, with which the point that moves farthest does so by `FARTHEST`, to first order."""
    rest = View(scene, {})
    paths = [
        sum(shape.get(q.name, 0.0) * rest.shift(point, q) for q in scene.q)
        for body in scene.bodies
        for point in attached(scene, body)
    ]
    farthest = max(float(np.linalg.norm(path)) for path in paths) * paper_for([rest]).scale
    # Where no point moves, bodies turn about their centres.
    return FARTHEST / farthest if farthest > 1e-9 else TURN / max(map(abs, shape.values()))
