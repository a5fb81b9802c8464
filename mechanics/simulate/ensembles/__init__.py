"""Ensembles: many motions of one model at once, in C over lanes, each with steps of its own."""

from mechanics.simulate.ensembles.ensemble import ensemble
from mechanics.simulate.ensembles.outcome import Ensemble, Status
from mechanics.simulate.ensembles.stream import Written, write_ensemble

__all__ = ["Ensemble", "Status", "Written", "ensemble", "write_ensemble"]
