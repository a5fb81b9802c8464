"""Why a figure is what it is: an outcome whose value is a sentence."""

from enum import Enum


class Cause(Enum):
    """What broke at a point, in one form and precision."""

    ACCURATE = "accurate"
    CONDITION = (
        "condition: every equation holds to a few roundings, and the accelerations are that"
        " sensitive to its terms"
    )
    CANCELLATION = "cancellation: the form subtracts nearly equal numbers and loses digits"
    UNDERFLOW = "underflow: a product is smaller than the smallest normal number and loses digits"
    OVERFLOW = "overflow: an intermediate value is larger than the largest number"
    RANGE = "range: the acceleration itself is larger than the largest number"
    SINGULAR = "singular: the matrix of the equations is, so there is no acceleration"
    INPUT = "input: a value of the point is no normal number of the precision"


CAUSES: tuple[Cause, ...] = tuple(Cause)
