"""Inverse dynamics of a robot in URDF: the C that we write against Pinocchio's rnea.

    python -m benchmarks.arm.robot tests/models/panda.urdf --rounds 50

Ours is the folder that `codegen` writes, with the numbers of the robot in it. Pinocchio reads the
same file; its headers are compiled with the same flags, -O3 -march=native. Both have to agree to
1e-12 at 1,000 states before they are timed in turn in one process. Joints turn about z.
"""

import argparse
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from benchmarks.arm.kernels import Run, by_pinocchio, looping, timed
from benchmarks.kernels.robots import no_pinocchio
from mechanics import compile, derive, from_urdf, write_c

STATES = 1000
AGREEMENT = 1e-12
GRAVITY = 9.81


def ours(path: Path, folder: Path) -> Run:
    """The C of the folder."""
    scene = from_urdf(path, symbolic=())
    model = compile(derive(scene), outputs=["inverse_dynamics"], fixed={"g": str(GRAVITY)})
    write_c(model, folder, name="robot")
    n = len(scene.q)
    text = f'#include "robot.c"\nstatic const double none[{n}];\n'
    at = f" + {n} * i"
    call = f"robot_inverse_dynamics(q{at}, u{at}, none, given{at}, found{at});"
    return looping(text, call, folder)


def rows(path: Path) -> np.ndarray:
    """What Pinocchio has read, a row a joint."""
    import pinocchio

    model, found = pinocchio.buildModelFromUrdf(str(path)), []
    for place, body in list(zip(model.jointPlacements, model.inertias, strict=True))[1:]:
        I = body.inertia
        moments = (I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[1, 2], I[2, 0])
        found.append(
            [*place.rotation.ravel(), *place.translation, body.mass, *body.lever, *moments]
        )
    return np.array(found)


def main() -> None:
    """Print agreement and times."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("path", type=Path)
    parser.add_argument("--rounds", type=int, default=50)
    settings = parser.parse_args()
    if why := no_pinocchio():
        raise SystemExit(why)
    table = rows(settings.path)
    q, u, ud = np.random.default_rng(3).uniform(-2, 2, (3, STATES, len(table)))
    with TemporaryDirectory(prefix="mechanics-") as folder:
        runs = {"ours": ours(settings.path, Path(folder) / "robot"),
                "Pinocchio": by_pinocchio("rnea", table, GRAVITY)}  # fmt: skip
    found, times = timed(runs, q, u, ud, settings.rounds)
    apart = (
        np.abs(found["ours"] - found["Pinocchio"]) / np.abs(found["Pinocchio"]).max(axis=1)[:, None]
    )
    if not apart.max() < AGREEMENT:
        raise SystemExit(f"they compute something else: {apart.max():.1g} apart")
    own, other = times["ours"], times["Pinocchio"]
    print(f"{settings.path.name}, {STATES} states: {apart.max():.1g} apart;"
          f" ours {own:.0f} ns, rnea {other:.0f} ns: {other / own:.1f} times")  # fmt: skip


if __name__ == "__main__":
    main()
