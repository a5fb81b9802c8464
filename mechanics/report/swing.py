"""Mode shapes that swing: the scene along each shape, in one period after the other.

q = q0 + A exp(growth t) Re(a exp(i omega t)), of a size that can be seen: what moves farthest moves
`FARTHEST` on paper. Periods are drawn equally long, whatever omega is, which the words beside a
picture tell; of a mode that is damped, or grows, a few of them. Coordinates without an amplitude
of their own close the loops.
"""

import math

import numpy as np

from mechanics.report.animation import moving_picture
from mechanics.report.drawing import paper_for
from mechanics.report.projection import View, attached, closed
from mechanics.report.result import Swing
from mechanics.scene import Scene

PERIODS = 3
"""Of a mode that is damped or grows."""
STEADY = 1e-12
"""Growth in a radian that is rounding."""
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
    size = math.hypot(mode.growth, mode.omega)
    damping = f", damping ratio {-mode.growth / size:.3g}" if _changes(mode) else ""
    return f"Mode {mode.number}: {frequency:.4g} Hz{damping}, a period drawn in {PERIOD:g} s"


def _changes(mode: Swing) -> bool:
    return abs(mode.growth) > STEADY * mode.omega


def _picture(scene: Scene, mode: Swing) -> str:
    size = _size(scene, mode)
    periods = PERIODS if _changes(mode) else 1
    times = np.linspace(0, periods * PERIOD, 24 * periods + 1)
    phase = 2 * math.pi * times / PERIOD
    growth = mode.growth / mode.omega * phase if _changes(mode) else 0 * phase
    # A quarter of a period later, so that it begins at rest where all phases are one.
    wave = size * np.exp(growth - growth.max()) * np.exp(1j * (phase - math.pi / 2))
    columns = {name: value + 0 * times for name, value in mode.about.items()}
    columns |= {
        name: mode.about.get(name, 0.0) + (amplitude * wave).real
        for name, amplitude in mode.shape.items()
    }
    if any(c.holonomic for c in scene.constraints):
        own = [name for name in columns if name in mode.shape]
        states = [
            closed(scene, {name: float(columns[name][k]) for name in own}, mode.about)
            for k in range(len(times))
        ]
        columns = {q.name: np.array([s.get(q.name, 0.0) for s in states]) for q in scene.q}
    still = 0.0 * times
    every = {s.name: columns.get(s.name, still) for s in (*scene.q, *scene.input_symbols)}
    return moving_picture(scene, times, every, title=f"{scene.name}: mode {mode.number}")


def _size(scene: Scene, mode: Swing) -> float:
    """A, with which the point that moves farthest does so by `FARTHEST`, to first order."""
    rest, shape = View(scene, mode.about), mode.shape
    paths = [
        sum(shape.get(q.name, 0.0) * rest.shift(point, q) for q in scene.q)
        for body in scene.bodies
        for point in attached(scene, body)
    ]
    farthest = max(float(np.linalg.norm(path)) for path in paths) * paper_for([rest]).scale
    # Where no point moves, bodies turn about their centres.
    return FARTHEST / farthest if farthest > 1e-9 else TURN / max(map(abs, shape.values()))
