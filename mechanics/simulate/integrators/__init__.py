"""Methods of integration from several libraries behind one interface; `INTEGRATORS` lists them."""

from dataclasses import replace

from mechanics.simulate.integrators import casadi, explicit, gauss, heyoka, scipy
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.rate import unsound


def _for_sound_starts(member: Integrator) -> Integrator:
    """The member, which no start that is not finite ever reaches."""

    def suits(problem: Problem, setting: Setting) -> str:
        return unsound(problem) or member.suits(problem, setting)

    return replace(member, suits=suits)


INTEGRATORS: tuple[Integrator, ...] = tuple(
    _for_sound_starts(member)
    for member in (
        *scipy.MEMBERS,
        *casadi.MEMBERS,
        *explicit.MEMBERS,
        *gauss.MEMBERS,
        *heyoka.MEMBERS,
    )
)

__all__ = ["INTEGRATORS", "Integrator", "Outcome", "Problem", "Setting"]
