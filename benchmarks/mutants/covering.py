"""Which tests cover a file: those that mirror it first, then those of what is built on it."""

KERNEL = tuple(
    f"tests/kernel/test_kernel_{name}.py"
    for name in (
        "finding", "normal", "signs", "balls", "angles", "determinism", "constraints", "decide",
        "field",
    )
)  # fmt: skip
PROGRAM = tuple(
    f"tests/program/test_program_{name}.py"
    for name in (
        "builder", "elimination", "derivatives", "casadi", "taylor", "running_errors", "json",
        "sympy", "c",
    )
)  # fmt: skip
ROUTES = (
    "tests/routes", "tests/checks/programs", "tests/recursions", "tests/laws/test_laws_arms.py",
    "tests/laws/test_laws_random_trees.py",
)  # fmt: skip

FIRST: dict[str, tuple[str, ...]] = {
    "kernel/definedness.py": ("tests/judge/test_judge_definedness.py",),
    "kernel/sizes.py": ("tests/kernel/test_kernel_field.py",),
}
"""What comes before the tests of the folder."""

FOLDERS: dict[str, tuple[str, ...]] = {
    "kernel": (*KERNEL, "tests/judge/test_judge_definedness.py"),
    "program": (*PROGRAM, *KERNEL),
    "checks": ("tests/checks",),
    "checks/programs": ROUTES,
    "kinematics": ("tests/laws/test_laws_spatial.py", "tests/checks"),
    "routes": ("tests/systems", "tests/checks"),
    "routes/programs": ROUTES,
}


def tests_of(path: str) -> tuple[str, ...]:
    """Test files of a file below ``mechanics/``, in the order in which they are run."""
    folder, _, file = path.rpartition("/")
    stem = file.removesuffix(".py")
    mirrored = f"tests/{folder}/test_{folder}_{stem}.py"
    every = FOLDERS[folder]
    first = (*([mirrored] if mirrored in every else []), *FIRST.get(path, ()))
    return tuple(dict.fromkeys((*first, *every)))
