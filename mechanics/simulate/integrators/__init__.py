"""Methods of integration from several libraries behind one interface; `INTEGRATORS` lists them."""

from mechanics.simulate.integrators import scipy
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting

INTEGRATORS: tuple[Integrator, ...] = (*scipy.MEMBERS,)

__all__ = ["INTEGRATORS", "Integrator", "Outcome", "Problem", "Setting"]
