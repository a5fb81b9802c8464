"""Reduced models: what may be left out of an output over a box, with a proved bound."""

from mechanics.reduce.model import reduced_model
from mechanics.reduce.reduce import Reduction, reduce

__all__ = ["Reduction", "reduce", "reduced_model"]
