"""A load counted wrongly: its sign, half of it, twice of it, or not at all.

gravity reversed        k x for 2 k x        + c x' for - c x'        -F for F
"""

from collections.abc import Iterator

from sympy import Rational

from mechanics.blame.mistakes.fault_model import Fault, Right, of_load
from mechanics.scene import Gravity, Spring, TorsionSpring
from mechanics.scene.loads import Damper, Load


def faults(right: Right) -> Iterator[Fault]:
    """Every load with every mistake that people make with its kind."""
    for load in right.scene.loads:
        name = "gravity" if isinstance(load, Gravity) else load.name
        for factor, words in _mistakes(load):
            yield from right.fault(words, of_load(name, factor))


def _mistakes(load: Load) -> list[tuple[Rational, str]]:
    half, twice, other, none = Rational(1, 2), Rational(2), Rational(-1), Rational(0)
    if isinstance(load, Gravity):
        return [(other, "gravity reversed"), (none, "gravity is missing")]
    if isinstance(load, Spring | TorsionSpring):
        title = f"spring {load.name}"
        return [
            (half, f"{title}: half of its stiffness"),
            (twice, f"{title}: twice its stiffness"),
            (other, f"{title}: its force has the wrong sign"),
            (none, f"{title} is missing"),
        ]
    if isinstance(load, Damper):
        title = f"damper {load.name}"
        return [(other, f"{title}: its force has the wrong sign"), (none, f"{title} is missing")]
    title = f"load {load.name}"
    return [(other, f"{title} has the wrong sign"), (none, f"{title} is missing")]
