"""Simulate compiled models: SciPy integrates; constraints are kept, energy is watched."""

from mechanics.simulate.batch import simulate
from mechanics.simulate.ensembles import (
    Ensemble,
    Status,
    Written,
    ensemble,
    write_ensemble,
)
from mechanics.simulate.feedback import Feedback
from mechanics.simulate.files import write_table
from mechanics.simulate.plot import write_plot
from mechanics.simulate.reactions import with_reactions
from mechanics.simulate.trajectory import Ending, Trajectory

__all__ = [
    "Ending",
    "Ensemble",
    "Feedback",
    "Status",
    "Trajectory",
    "Written",
    "ensemble",
    "simulate",
    "with_reactions",
    "write_ensemble",
    "write_plot",
    "write_table",
]
