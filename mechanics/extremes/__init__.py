"""How accelerations hold at the extremes: errors against enclosed values, and what breaks where."""

from mechanics.extremes.cause import CAUSES, Cause
from mechanics.extremes.record import point, reproduce, to_record
from mechanics.extremes.result import Extremes, Figures, Reach, Visited
from mechanics.extremes.run import extremes

__all__ = [
    "CAUSES",
    "Cause",
    "Extremes",
    "Figures",
    "Reach",
    "Visited",
    "extremes",
    "point",
    "reproduce",
    "to_record",
]
