"""Linear equations about an equilibrium: modes, transfer functions, closed loops, stability."""

from mechanics.linear.damped import DampedModes, damped_modes
from mechanics.linear.dimensionless import Dimensionless, dimensionless
from mechanics.linear.form import Linear
from mechanics.linear.linearize import linearize
from mechanics.linear.modes import (
    Convention,
    Modes,
    characteristic,
    characteristic_factors,
    modes,
)
from mechanics.linear.numeric import NumericModes, damped, numeric_modes, numeric_poles, state_space
from mechanics.linear.speed_form import SpeedForm, speed_form
from mechanics.linear.stability import (
    Region,
    Stability,
    conditions,
    stability,
    stability_region,
    verdict,
)
from mechanics.linear.sweep import Sweep, sweep
from mechanics.linear.transfer import (
    characteristic_polynomial,
    close_loop,
    transfer_function,
)
from mechanics.linear.trim import trim

__all__ = [
    "Convention", "DampedModes", "Dimensionless", "Linear", "Modes", "NumericModes", "Region",
    "SpeedForm", "Stability", "Sweep", "characteristic", "characteristic_factors",
    "characteristic_polynomial", "close_loop", "conditions", "damped", "damped_modes",
    "dimensionless", "linearize", "modes", "numeric_modes", "numeric_poles", "speed_form",
    "stability", "stability_region", "state_space", "sweep", "transfer_function",
    "trim", "verdict",
]  # fmt: skip
