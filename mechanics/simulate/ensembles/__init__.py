"""Ensembles: many motions of one model at once, in C over lanes, each with steps of its own."""

from mechanics.simulate.ensembles.ensemble import ensemble
from mechanics.simulate.ensembles.outcome import Ensemble, Status

__all__ = ["Ensemble", "Status", "ensemble"]
