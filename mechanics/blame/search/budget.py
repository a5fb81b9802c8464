"""How long a search may go on, counted in steps and not on a clock: the same on every machine."""

from dataclasses import dataclass


@dataclass
class Budget:
    """Steps that are left.

    A step is one node of a statement, looked at by one stage of the search or by one proof: about
    a millisecond.
    """

    left: int

    @property
    def spent(self) -> bool:
        """Whether nothing is left."""
        return self.left <= 0

    def spend(self, steps: int) -> None:
        """Count steps that were taken; what has begun is finished."""
        self.left -= steps
