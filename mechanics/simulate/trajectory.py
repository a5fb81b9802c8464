"""What a simulation gives back: samples of the motion, how good they are, and why they end."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError
from mechanics.scene import Scene


class Ending(Enum):
    """Why a simulation ended; the value says it."""

    COMPLETE = "the whole duration was integrated"
    SINGULAR = "the configuration is singular, so the motion is not determined there"
    NOT_FINITE = "the accelerations are not finite"
    STALLED = "the integrator found no step that meets the tolerance"
    APART = "the state could not be brought back onto the constraints"
    TOO_LONG = "the integrator needed more steps than allowed"
    LEFT_DOMAIN = "the motion left the domain in which the model is valid"


@dataclass(frozen=True)
class Crossing:
    """Where a condition of validity begins or ceases to hold.

    Attributes
    ----------
    condition : str
        Its name.
    time : float
        In s.
    leaving : bool
        Whether it ceases to hold.
    """

    condition: str
    time: float
    leaving: bool
    sentence: str


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory:
    """A simulated motion: N samples of n coordinates, m speeds and k inputs.

    Attributes
    ----------
    title : str
        Name of the scene.
    times : array, shape (N,)
        In s.
    coordinates, speeds, inputs : mapping of str to array, shape (N,)
        By plain name, in the order of the scene.
    units : mapping of str to str
        Of every column; empty where the scene does not tell.
    kinetic, potential : array, shape (N,)
        In J. The potential is that of the conservative loads.
    conservative : bool
        Whether the total energy has to stay as it is: no load but conservative ones acts, no
        input moves anything.
    parameters : mapping of str to float
        The numbers that were used.
    drift : mapping of str to float
        For each constraint, and for the rate of each holonomic one, the largest residual that a
        step of the integrator left before the state was projected back. Empty without constraints.
    branch : str
        Which of the configurations that satisfy the constraints was taken, or empty.
    ending : Ending
    reason : str
        One sentence: the ending with its particulars.
    crossings : tuple of Crossing
        Where the motion leaves the domain of the model, or comes back, in the order of time.
    solved_by : str
        The method, where it was chosen for an accuracy; empty otherwise.
    error_estimate : float or None
        Largest error along the way that is likely, of coordinates and speeds relative to the
        largest magnitude of each; from a second run with another tolerance or step. None where it
        was not asked for, or the second run gave up.
    tenfold : float or None
        Seconds in which errors grow tenfold, where the second run was lost by exponential growth.
    horizon : float or None
        Time in s beyond which no digit of the motion is right, where it ends later.
    reactions : mapping of str to array, shape (N,)
        By name; empty where they were not asked for.
    outputs : mapping of str to array, shape (N,)
        What the scene wants computed, entry by entry: ``tool_x``.
    scene : Scene or None
        What moved; None where only its samples are known.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, z = ReferenceFrame("N"), Point("O"), dynamicsymbols("z")
    >>> m, g = parameters("m g", units="kg m/s^2", typical="2 9.81")
    >>> P = O.locatenew("P", z * N.z)
    >>> stone = Scene("stone", N, O, (z,), (Particle("stone", P, m),), loads=(gravity(-g * N.z),))
    >>> motion = simulate(compile(derive(stone, "kane")), 1.0, samples=3)
    >>> print(motion.times, motion.coordinates["z"].round(3), motion.ending.name)
    [0.  0.5 1. ] [ 0.    -1.226 -4.905] COMPLETE
    """

    title: str
    times: NDArray[np.float64]
    coordinates: Mapping[str, NDArray[np.float64]]
    speeds: Mapping[str, NDArray[np.float64]]
    inputs: Mapping[str, NDArray[np.float64]]
    units: Mapping[str, str]
    kinetic: NDArray[np.float64]
    potential: NDArray[np.float64]
    conservative: bool
    parameters: Mapping[str, float]
    drift: Mapping[str, float]
    branch: str
    ending: Ending
    reason: str
    crossings: tuple[Crossing, ...] = ()
    solved_by: str = ""
    error_estimate: float | None = None
    tenfold: float | None = None
    horizon: float | None = None
    reactions: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    outputs: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    scene: Scene | None = None

    def __repr__(self) -> str:
        names = ", ".join((*self.coordinates, *self.speeds))
        end = f"{len(self.times)} samples of {names} up to t = {self.times[-1]:g} s"
        return f"<Trajectory of {self.title}: {end}; {self.reason}>"

    def animate(self, path: str | Path) -> str:
        """Write the scene as it moves: a picture, or a page with its curves.

        Nothing that is written fetches anything or runs a script. SVG and pages show a few poses
        to readers who prefer less motion, and on paper.

        Parameters
        ----------
        path : str or Path
            A name that ends in ``.svg``, ``.html`` or ``.gif``.

        Returns
        -------
        str
            Which part is shown, and how many times slower, where the motion turns too fast to be
            watched; empty where all of it is shown in real time.

        Raises
        ------
        InputError
            For another suffix, a folder that does not exist, a motion whose scene is not known, or
            GIF without resvg-py, which ``pip install 'mechanics[gif]'`` brings.

        Examples
        --------
        >>> from tempfile import mkdtemp
        >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
        >>> N, O, z, (m, g) = ReferenceFrame("N"), Point("O"), dynamicsymbols("z"), (
        ...     parameters("m g", "kg m/s^2", "2 9.81"))
        >>> P = O.locatenew("P", z * N.z)
        >>> stone = Scene("stone", N, O, (z,), (Particle("stone", P, m),),
        ...     loads=(gravity(-g * N.z),))
        >>> motion = simulate(compile(derive(stone, "kane")), 1.0)
        >>> motion.animate(Path(mkdtemp()) / "stone.svg")
        ''
        """
        # What moves can be drawn is known far above; who integrates alone does not import it.
        from mechanics.report.motion import write_motion

        if self.scene is None:
            raise InputError(
                f"trajectory {self.title}: only its samples are known, no scene that could be drawn"
            )
        return write_motion(self.scene, self.columns, self.units, self.note, path)

    @property
    def total(self) -> NDArray[np.float64]:
        """Kinetic and potential energy, shape (N,), in J."""
        return self.kinetic + self.potential

    @property
    def energy_drift(self) -> float:
        """Largest |E - E(0)|, relative to the range that kinetic energy and potential run through.

        What a conservative motion gained by integration error. Meaningless, though defined, when
        `conservative` is false.
        """
        scale = max(float(np.max(self.kinetic)), float(np.ptp(self.potential)))
        change = float(np.max(np.abs(self.total - self.total[0])))
        return change / scale if scale > 0 else change

    @property
    def accuracy(self) -> str:
        """How far the samples can be relied upon, in words; empty where it is not known."""
        if self.error_estimate is None:
            return ""
        by = f" by {self.solved_by}" if self.solved_by else ""
        words = f"error estimate {self.error_estimate:.1e}{by}"
        if self.tenfold is not None:
            words += f", errors grow tenfold in {self.tenfold:.2g} s"
        if self.horizon is not None:
            words += f": beyond t = {self.horizon:.3g} s no digit is right"
        return words

    @property
    def outside(self) -> tuple[tuple[float, float], ...]:
        """Intervals of time, in s, in which a condition of validity does not hold."""
        broken: set[str] = set()
        found: list[tuple[float, float]] = []
        begin = 0.0
        for crossing in self.crossings:
            before = bool(broken)
            (broken.add if crossing.leaving else broken.discard)(crossing.condition)
            if broken and not before:
                begin = crossing.time
            elif before and not broken:
                found.append((begin, crossing.time))
        last = float(self.times[-1])
        return (*found, (begin, last)) if broken and last > begin else tuple(found)

    @property
    def columns(self) -> dict[str, NDArray[np.float64]]:
        """Every sampled quantity by name: t, state, inputs, energies, outputs, reactions."""
        return {
            "t": self.times,
            **self.coordinates,
            **self.speeds,
            **self.inputs,
            "kinetic_energy": self.kinetic,
            "potential_energy": self.potential,
            "total_energy": self.total,
            **self.outputs,
            **self.reactions,
        }

    @property
    def note(self) -> str:
        """What a reader has to know about the quality of the samples, in a line."""
        parts = [self.reason]
        if self.error_estimate is not None:
            parts.append(self.accuracy)
        if self.conservative:
            parts.append(f"energy drift {self.energy_drift:.1e}")
        else:
            parts.append("energy is not conserved: loads or inputs do work")
        if self.drift:
            parts.append(f"largest constraint drift {max(self.drift.values()):.1e}")
        if self.ending is not Ending.LEFT_DOMAIN:
            parts += [f"at t = {one.time:.6g} s {one.sentence}" for one in self.crossings]
        if self.branch:
            parts.append(self.branch)
        return "; ".join(parts)
