"""Mechanical systems with the equations that their sources publish."""

from mechanics.scene.system import System
from systems import (
    acrobot,
    cartpole,
    cartpole_friction,
    double_inverted_pendulum,
    double_pendulum,
    elastic_pendulum,
    elastic_pendulum_ledger,
    four_bar,
    four_bar_ledger,
    pendulum_chain,
    rocker,
    rocker_control_ledger,
    rocker_ledger,
    rocker_shapes_ledger,
    rod_pendulum,
    rolling_disc,
    two_mass_chain,
    two_mass_chain_ledger,
)

SEED: tuple[System, ...] = (
    System("elastic_pendulum", elastic_pendulum.scene, elastic_pendulum_ledger.PUBLISHED),
    System(
        "rocker",
        rocker.scene,
        (
            *rocker_shapes_ledger.PUBLISHED,
            *rocker_ledger.PUBLISHED,
            *rocker_control_ledger.PUBLISHED,
        ),
        (rocker.AT_THE_ENDS,),
    ),
    System("two_mass_chain", two_mass_chain.scene, two_mass_chain_ledger.PUBLISHED),
)
ALL: tuple[System, ...] = (
    *SEED,
    System("pendulum_chain", pendulum_chain.scene, pendulum_chain.PUBLISHED),
    System("rolling_disc", rolling_disc.scene, rolling_disc.PUBLISHED),
    System("four_bar", four_bar.scene, four_bar_ledger.PUBLISHED),
    System("cartpole", cartpole.scene, cartpole.PUBLISHED),
    System("cartpole_friction", cartpole_friction.scene, cartpole_friction.PUBLISHED),
    System("acrobot", acrobot.scene, acrobot.PUBLISHED),
    System(
        "double_inverted_pendulum",
        double_inverted_pendulum.scene,
        double_inverted_pendulum.PUBLISHED,
    ),
    System("rod_pendulum", rod_pendulum.scene, rod_pendulum.PUBLISHED),
    System("double_pendulum", double_pendulum.scene, double_pendulum.PUBLISHED),
)
VARIANTS: tuple[System, ...] = (
    System("massless_carriage", elastic_pendulum.massless),
    System(
        "controlled_rocker", rocker.controlled, (), (rocker.AT_CRITICAL_GAIN, rocker.AT_THE_ENDS)
    ),
    System(
        "unequal_chain", two_mass_chain.unequal, (), (two_mass_chain.TOWARDS_EQUAL_FREQUENCIES,)
    ),
)
"""The seed's systems with a term more or less; their sources print no equations for them."""

__all__ = ["ALL", "SEED", "VARIANTS"]
