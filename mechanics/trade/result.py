"""What a trade found, with everything that its figures were made from."""

from collections.abc import Mapping
from dataclasses import dataclass

from mechanics.trade.choice import Choice
from mechanics.trade.cost import Cost
from mechanics.trade.family import Family
from mechanics.trade.least import LeastModel
from mechanics.trade.measure import Measurement
from mechanics.trade.pareto import pareto
from mechanics.trade.recommend import Recommendation
from mechanics.trade.train import Trained
from mechanics.trade.yardstick import Yardstick

NOTHING = 1.0
"""An error of the size of the motion, which tells nothing about it."""
ALIKE = 0.01
"""Share of an error by which a row of the front has to be below the one before."""


@dataclass(frozen=True, eq=False)
class Trade:
    """The trade of speed for accuracy, measured on one system and motion.

    Attributes
    ----------
    title : str
    horizon, asked : float
        Length of the motion that was measured and that was asked for, in s.
    start : mapping of str to float
        Where the motion starts.
    parameters : mapping of str to float
    backend : str
        What evaluates the right-hand side.
    yardstick : Yardstick
    measurements : tuple of Measurement
    family : Family
    trained : tuple of Trained
    recommendations : tuple of Recommendation
        One for each target: the least time, called from Python.
    embedded : tuple of Recommendation
        One for each target: the fewest operations on a target without Python.
    costs : mapping of Choice to Cost
        Of what is recommended.
    least : LeastModel or None
    notes : tuple of str
        What a reader has to know, in sentences.
    left_out : mapping of str to str
        What was not measured, and why.
    """

    title: str
    horizon: float
    asked: float
    start: dict[str, float]
    parameters: dict[str, float]
    backend: str
    yardstick: Yardstick
    measurements: tuple[Measurement, ...]
    family: Family
    trained: tuple[Trained, ...]
    recommendations: tuple[Recommendation, ...]
    embedded: tuple[Recommendation, ...]
    costs: Mapping[Choice, Cost]
    least: LeastModel | None
    notes: tuple[str, ...]
    left_out: dict[str, str]

    @property
    def front(self) -> tuple[Measurement, ...]:
        """Measurements that no other beats in both time and error, the fastest first.

        Those whose error is as large as the motion are left out, and -ffast-math with them; of
        those with the same error but for rounding, as one method in several forms, all but one.
        """
        usable = [
            m for m in self.measurements if m.choice.variant.careful and m.error_largest <= NOTHING
        ]
        return tuple(usable[i] for i in pareto(usable, ALIKE))

    def bound(self, choice: Choice) -> float | None:
        """What the errors of a choice stay below over the family; None where it was not tried."""
        return next((t.bound for t in self.trained if t.choice == choice), None)
