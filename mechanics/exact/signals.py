"""What an evaluation can say instead of a number.

They travel from an arithmetic to `decide`, which redraws the point, restarts the run, or tries the
next arithmetic; none of them reaches a caller of `decide`.
"""

from mechanics.errors import MechanicsError


class Inadmissible(MechanicsError, ArithmeticError):
    """This point is no admissible state: draw another one. Experiments may raise it themselves."""


class SingularHere(Inadmissible):
    """A matrix that has to be regular is singular at this point, or everywhere."""


class DivisionHere(Inadmissible):
    """A divisor is zero at this point, or everywhere."""


class TooLarge(MechanicsError, OverflowError):
    """The normal form outgrew its limit of terms: fall through to the field."""


class Restart(MechanicsError):
    """The run has learnt something (a finer base angle, more generators) and must begin again."""
