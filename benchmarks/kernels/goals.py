"""What the generated kernels are held against, and how the ratio should come out.

A goal says: the time of ours is at most ``most`` times that of the peer. "At least 4 times faster"
is ``most = 1 / 4``.
"""

from dataclasses import dataclass

from benchmarks.kernels import c_loops, lanes, robots
from benchmarks.kernels.race import Contender

ARTICULATED = "CasADi's C, articulated"


@dataclass(frozen=True)
class Goal:
    """One comparison.

    Attributes
    ----------
    what : str
        What is compared, for people.
    ours, peer : str
        Names of contenders of the heat.
    most : float
        Largest wanted ratio of the times, ours over the peer's.
    """

    what: str
    ours: str
    peer: str
    most: float


@dataclass(frozen=True)
class Heat:
    """Contenders that run in turn on one case."""

    links: int
    states: int
    contenders: tuple[Contender, ...]
    goals: tuple[Goal, ...]


GENERATED, LANES = c_loops.generated(), lanes.generated()
HAND, CASADI = c_loops.by_hand(), c_loops.casadi()
HAND_LANES, HEYOKA, HEYOKA_OURS = lanes.by_hand(), lanes.heyoka(), lanes.heyoka("auto")
HEYOKA_CONSTANT = lanes.heyoka("auto", constant=True)
RECURSIVE = c_loops.casadi("recursive", ARTICULATED)
PINOCCHIO, MUJOCO = robots.pinocchio(), robots.mujoco()

HEATS: tuple[Heat, ...] = (
    Heat(
        1, 2048,
        (GENERATED, HAND, CASADI, LANES, HAND_LANES, HEYOKA, HEYOKA_OURS, HEYOKA_CONSTANT,
         PINOCCHIO, MUJOCO),
        (
            Goal("one state in C, one link", GENERATED.name, HAND.name, 1.0),
            Goal("2048 states, one link", LANES.name, HAND_LANES.name, 1.1),
            Goal("2048 states, one link", LANES.name, HEYOKA.name, 1 / 3.5),
            Goal("2048 states, one link", LANES.name, CASADI.name, 1 / 13),
        ),
    ),
    Heat(
        5, 2048,
        (GENERATED, CASADI, LANES, HAND_LANES, HEYOKA, HEYOKA_OURS, HEYOKA_CONSTANT,
         PINOCCHIO, MUJOCO),
        (
            Goal("2048 states, five links", LANES.name, HAND_LANES.name, 1.1),
            Goal("2048 states, five links", LANES.name, HEYOKA.name, 1 / 2),
            Goal("2048 states, five links", LANES.name, HEYOKA_OURS.name, 1 / 2),
            Goal("2048 states, five links", LANES.name, CASADI.name, 1 / 10),
        ),
    ),
    Heat(
        1, 1_000_000,
        (LANES, HAND_LANES, HEYOKA, HEYOKA_OURS, HEYOKA_CONSTANT),
        (Goal("1e6 states from memory, one link", LANES.name, HEYOKA.name, 1 / 2.5),),
    ),
    *(
        Heat(
            links, 256, (GENERATED, RECURSIVE, PINOCCHIO, MUJOCO),
            (
                Goal(f"one state in C, {links} links", GENERATED.name, RECURSIVE.name, 1.0),
                Goal(f"one state in C, {links} links", GENERATED.name, PINOCCHIO.name, 1 / 5),
                Goal(f"one state in C, {links} links", GENERATED.name, MUJOCO.name, 1 / 5),
            ),
        )
        for links in (10, 20)
    ),
)  # fmt: skip
"""Every comparison of kernels with kernels."""

GROWTH = (10, 50, 5.5)
"""From so many links to so many the time of one state grows so many times at most."""
