"""Equations as fast functions, proved to be still the same equations."""

from mechanics.compiled.forms import FORMS, Form
from mechanics.compiled.machine.buffer import Buffer
from mechanics.compiled.model import Model, compile
from mechanics.compiled.proof import prove_compiled, prove_graph
from mechanics.compiled.residuals import Residual, residuals

__all__ = [
    "FORMS",
    "Buffer",
    "Form",
    "Model",
    "Residual",
    "compile",
    "prove_compiled",
    "prove_graph",
    "residuals",
]
