"""What may be left out of a few models, and what is proved of the rest: python -m benchmarks.reduce

    pendulum on elastic support     small angles
    rocker                          near upright
    PUMA 560                        inverse dynamics, all angles of its joints

For the PUMA, operations are counted as `benchmarks.space` counts them, multiplications and
additions; Armstrong, Khatib and Burdick's model of 1986 takes 305 calculations, where terms are
left out that are below one percent of the entry they stand in. Where our bound ends is measured:
the same order of edits, cut where the largest deviation at states that were searched reaches the
error. Prints Markdown; no figure depends on time.
"""

import argparse
from collections.abc import Mapping
from fractions import Fraction

from benchmarks.largest_deviation import largest_deviations
from benchmarks.space.counting import Counts, count
from mechanics.crosscheck import derive
from mechanics.reduce import Reduction, reduce
from mechanics.scene import Scene
from systems import arm_puma560, elastic_pendulum, rocker

CALCULATIONS = 305
"""Armstrong, Khatib and Burdick, The explicit dynamic model and inertial parameters of the PUMA 560
arm, IEEE International Conference on Robotics and Automation 1986, 510-518: abstract."""

LIMITS = ((-160, 160), (-45, 225), (-225, 45), (-110, 170), (-100, 100), (-266, 266))
"""Of the joints of a PUMA 560 in degrees, as Corke's Robotics Toolbox has them."""
SPEED, ACCELERATION = 2, 10
"""Largest speed in rad/s and acceleration in rad/s^2 of every joint."""
SHARES = ("0.005", "0.01", "0.02", "0.05")

PENDULUM = {"theta": ("-0.2", "0.2"), "theta_dot": (-1, 1), "x": ("-0.1", "0.1")}
ROCKER = {"theta": ("-0.1", "0.1"), "theta_dot": (-1, 1), "f": (-5, 5)}


def arm() -> dict[str, tuple[str, str] | tuple[int, int]]:
    """The box of the arm."""
    box: dict[str, tuple[str, str] | tuple[int, int]] = {}
    for i, (low, high) in enumerate(LIMITS, 1):
        box[f"q{i}"] = f"{Fraction(low, 180)}pi", f"{Fraction(high, 180)}pi"
        box[f"q{i}_dot"] = -SPEED, SPEED
        box[f"q{i}_ddot"] = -ACCELERATION, ACCELERATION
    return box


def row(scene: Scene, error: str, of: str, over: Mapping) -> Reduction:
    return reduce(derive(scene, "kane"), error, of=of, over=over)


def costs(found: Reduction) -> tuple[Counts, Counts]:
    """Of the whole output and of the reduced one."""
    return count(found.start.reduced({})), count(found.program)


def small() -> list[str]:
    lines = [
        "| model, forward dynamics | error | operations | left out | verdict |",
        "|---|---|---|---|---|",
    ]
    for make, over in ((elastic_pendulum.scene, PENDULUM), (rocker.scene, ROCKER)):
        for error in SHARES:
            found = row(make(), error, "forward_dynamics", over)
            lines.append(
                f"| {found.equations.scene.name} | {float(error):.1%} | {found.after} instead of"
                f" {found.before} | {len(found.edits)} | {found.finding.verdict.name} |"
            )
    return lines


def large(shares: tuple[str, ...]) -> list[str]:
    lines = [
        "| PUMA 560, inverse dynamics: error proved | multiplications + additions | sines, cosines "
        "| largest error found | verdict |",
        "|---|---|---|---|---|",
    ]
    for error in shares:
        found = row(arm_puma560.scene(), error, "inverse_dynamics", arm())
        whole, less = costs(found)
        if error == shares[0]:
            lines.append(f"| 0, the whole model | {_sum(whole)} | {whole.functions} | 0 | - |")
        worst = max(
            float(d / s) for d, s in zip(largest_deviations(found), found.sizes, strict=True)
        )
        lines.append(
            f"| {float(error):.1%} | {_sum(less)} | {less.functions} | {worst:.2%}"
            f" | {found.finding.verdict.name} |"
        )
    lines.append(f"| rule of thumb of 1986, one percent | {CALCULATIONS} calculations | | | - |")
    return lines


def _sum(counts: Counts) -> str:
    both = counts.multiplications + counts.additions
    return f"{counts.multiplications} + {counts.additions} = {both}"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.reduce", description=__doc__)
    parser.add_argument("--small", action="store_true", help="without the arm")
    given = parser.parse_args()
    print("\n".join(small()))
    if not given.small:
        print()
        print("\n".join(large(SHARES)))


if __name__ == "__main__":
    main()
