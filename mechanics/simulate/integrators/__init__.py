"""Methods of integration from several libraries behind one interface; `INTEGRATORS` lists them."""

from mechanics.simulate.integrators import explicit, gauss, scipy
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting

INTEGRATORS: tuple[Integrator, ...] = (*scipy.MEMBERS, *explicit.MEMBERS, *gauss.MEMBERS)

__all__ = ["INTEGRATORS", "Integrator", "Outcome", "Problem", "Setting"]
