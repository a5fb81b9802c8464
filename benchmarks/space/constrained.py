"""What forward dynamics of loops and of rolling costs, in operations, as `compile` gives it."""

from collections.abc import Callable

from mechanics import compile, derive
from mechanics.scene import Scene
from systems import andrews, bicycle, four_bar_chain, rolling_disc

SCENES: tuple[tuple[str, Callable[[], Scene], int | None], ...] = (
    ("rolling disc", rolling_disc.scene, None),
    ("bicycle", bicycle.scene, 1200),
    ("Andrews' mechanism", andrews.scene, None),
    ("10 four-bars", lambda: four_bar_chain.scene(10), None),
)
"""Name, scene, and how many operations it may take."""


def constrained() -> list[dict]:
    """Every row of the table: accelerations and multipliers by default."""
    return [
        {"scene": name, "goal": goal,
         "operations": compile(derive(make())).program("forward_dynamics").operations}
        for name, make, goal in SCENES
    ]  # fmt: skip
