"""Which tests cover a file: those that mirror its folder, and those of what is built on it."""

ROUTES = (
    "tests/routes", "tests/checks",
    "tests/recursions", "tests/laws/test_laws_arms.py", "tests/laws/test_laws_random_trees.py",
)  # fmt: skip

FOLDERS: dict[str, tuple[str, ...]] = {
    "kernel": ("tests/kernel",),
    "program": ("tests/program", "tests/kernel", "tests/routes"),
    "checks": (
        "tests/scene/test_scene_refusals.py", "tests/scene/test_scene_refusals_loads.py", *ROUTES,
    ),
    "kinematics": ("tests/kinematics", "tests/laws/test_laws_spatial.py", *ROUTES),
    "routes": ("tests/systems", *ROUTES),
}  # fmt: skip


def tests_of(path: str) -> tuple[str, ...]:
    """Test files of a file below ``mechanics/``, by its folder."""
    return FOLDERS[path.rpartition("/")[0]]
