"""What laws choose their scenes by, known before one is built: collecting tests builds none.

`tests/laws/test_laws_same_kinds.py` holds it against the scenes.
"""

CONSTRAINED = frozenset(
    ("rolling_disc", "four_bar", "cylinder_in_cylinder", "atwood", "slider_crank",
     "four_bar_chain", "andrews", "bicycle")
)  # fmt: skip
"""Systems with constraints; every linkage has some."""

WITH_FRICTION = frozenset(("cartpole_friction",))
"""Of `systems.ALL` and `systems.VARIANTS`: reactions press where something slides."""

CONSERVATIVE = frozenset(("elastic_pendulum", "two_mass_chain", "double_pendulum"))
"""Of `systems.ALL`, without constraints and with no loads but weights and springs."""

MANY_COORDINATES = frozenset(
    ("rolling_disc", "four_bar_chain", "andrews", "arm_puma560", "arm_seven_joints", "humanoid",
     "quadrotor", "bicycle")
)  # fmt: skip
"""Systems with more than four coordinates."""
