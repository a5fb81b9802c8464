"""Mechanical systems with the equations that their sources publish."""

from mechanics.scene.system import System
from systems import (
    acrobot,
    andrews,
    arm_puma560,
    arm_seven_joints,
    atwood,
    bead_on_hoop,
    bicycle,
    bicycle_ledger,
    cartpole,
    cartpole_friction,
    cylinder_in_cylinder,
    double_inverted_pendulum,
    double_pendulum,
    elastic_pendulum,
    elastic_pendulum_ledger,
    four_bar,
    four_bar_chain,
    four_bar_ledger,
    furuta_pendulum,
    gyroscope,
    half_car,
    humanoid,
    pendulum_chain,
    quadrotor,
    rocker,
    rocker_control_ledger,
    rocker_ledger,
    rocker_shapes_ledger,
    rod_pendulum,
    rolling_disc,
    slider_crank,
    spinning_top,
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
TEXTBOOKS: tuple[System, ...] = (
    System("spinning_top", spinning_top.scene, spinning_top.PUBLISHED),
    System("gyroscope", gyroscope.scene, gyroscope.PUBLISHED),
    System("furuta_pendulum", furuta_pendulum.scene, furuta_pendulum.PUBLISHED),
    System("bead_on_hoop", bead_on_hoop.scene, bead_on_hoop.PUBLISHED),
    System("cylinder_in_cylinder", cylinder_in_cylinder.scene, cylinder_in_cylinder.PUBLISHED),
)
MECHANISMS: tuple[System, ...] = (
    System("atwood", atwood.scene, atwood.PUBLISHED),
    System("slider_crank", slider_crank.scene, slider_crank.PUBLISHED),
    System("four_bar_chain", four_bar_chain.scene),
    System("andrews", andrews.scene, andrews.PUBLISHED),
)
ROBOTS_AND_VEHICLES: tuple[System, ...] = (
    System("arm_puma560", arm_puma560.scene),
    System("arm_seven_joints", arm_seven_joints.scene),
    System("humanoid", humanoid.scene),
    System("quadrotor", quadrotor.scene, quadrotor.PUBLISHED),
    System("bicycle", bicycle.scene, bicycle_ledger.PUBLISHED),
    System("half_car", half_car.scene, half_car.PUBLISHED),
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


GROUPS: tuple[tuple[str, tuple[System, ...]], ...] = (
    ("checked by default", SEED),
    ("first examples", ALL[len(SEED) :]),
    ("textbooks", TEXTBOOKS),
    ("mechanisms", MECHANISMS),
    ("robots and vehicles", ROBOTS_AND_VEHICLES),
    ("variants of the first three", VARIANTS),
)
"""Every system that is built in, under what it is."""

EVERY: tuple[System, ...] = tuple(system for _, group in GROUPS for system in group)

__all__ = ["ALL", "EVERY", "GROUPS", "SEED", "VARIANTS"]
