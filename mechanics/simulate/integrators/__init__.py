"""Methods of integration from several libraries behind one interface; `INTEGRATORS` lists them."""

from mechanics.simulate.integrators import casadi, explicit, gauss, heyoka, scipy
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting

INTEGRATORS: tuple[Integrator, ...] = (
    *scipy.MEMBERS,
    *casadi.MEMBERS,
    *explicit.MEMBERS,
    *gauss.MEMBERS,
    *heyoka.MEMBERS,
)

__all__ = ["INTEGRATORS", "Integrator", "Outcome", "Problem", "Setting"]
