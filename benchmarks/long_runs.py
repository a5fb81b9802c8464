"""Energy, momentum and phase over 1e5 natural periods, for every integrator.

    python -m benchmarks.long_runs [SYSTEM] [--set NAME=VALUE] [--periods 100000] [--seconds 10]
    python -m benchmarks.long_runs --set k=0 --set x_dot=0.1        P_x is conserved without springs
    python -m benchmarks.long_runs --only "SciPy RK45" --tolerance 1e-6 --seconds 600

prints a table. What would take longer than the seconds is run for a tenth, a hundredth ... of the
periods, and the table says for how many.
"""

import argparse
from collections.abc import Mapping, Sequence

from benchmarks.problems import pose
from benchmarks.secular_drift import LongRun, long_runs, natural_period
from mechanics.compiled import compile
from mechanics.routes.derivation import by_route
from mechanics.simulate.integrators import INTEGRATORS, Problem, Setting
from systems import ALL

# Moderate swings: regular motions, in which errors grow with powers of time.
STARTS = {"elastic_pendulum": {"x": 0.1, "theta": 0.5}}
TOLERANCE, STEPS = 1e-9, 60
NAMES = tuple(member.name for member in INTEGRATORS)
COLUMNS = ("integrator", "setting", "periods", "energy", "momentum", "phase in periods", "s")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("system", nargs="?", default="elastic_pendulum")
    parser.add_argument("--periods", type=int, default=100_000)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--only", action="append", choices=NAMES, help="an integrator, repeatable")
    parser.add_argument("--tolerance", type=float, default=TOLERANCE, help="of adaptive methods")
    asked = parser.parse_args()
    problem = posed(asked.system, dict(word.split("=", 1) for word in asked.set))
    period = natural_period(problem)
    print(f"{asked.system}: natural period {period:.4g} s, {asked.periods} periods\n")
    print(f"| {' | '.join(COLUMNS)} |\n|{'---|' * len(COLUMNS)}")
    wanted = settings(problem, period, asked.only or NAMES, asked.tolerance)
    for run in long_runs(problem, wanted, periods=asked.periods, seconds=asked.seconds):
        print(f"| {' | '.join(row(run))} |", flush=True)


def posed(name: str, values: Mapping[str, str]) -> Problem:
    """Values are initial ones where the scene has such a coordinate or speed, else parameters."""
    model = compile(by_route("free_body", {system.name: system.scene for system in ALL}[name]()))
    states = {*model.entries["q"], *model.entries["u"]}
    numbers = {key: float(value) for key, value in values.items()}
    initial = STARTS.get(name, {}) | {key: x for key, x in numbers.items() if key in states}
    given = {key: x for key, x in numbers.items() if key not in states}
    return pose(model, [0.0, 1.0], initial=initial, parameters=given)


def settings(
    problem: Problem,
    period: float,
    names: Sequence[str] = NAMES,
    tolerance: float = TOLERANCE,
) -> list[Setting]:
    """A tolerance for adaptive methods, a whole number of steps a period for the others."""
    found = []
    for member in INTEGRATORS:
        if member.name not in names:
            continue
        setting = (
            Setting(member.name, tolerance=tolerance)
            if member.adaptive
            else Setting(member.name, step=period / STEPS)
        )
        if not member.available():
            found.append(setting)
    return found


def row(run: LongRun) -> list[str]:
    setting = run.setting
    steps = f"h = {setting.step:.3g} s" if setting.step else f"tolerance {setting.tolerance:g}"
    momenta = ", ".join(f"{name} {drift.words}" for name, drift in run.momenta) or "none conserved"
    told, seconds = run.note or str(run.periods), f"{run.seconds:.2g}"
    return [
        setting.integrator,
        steps,
        told,
        run.energy.words,
        momenta,
        run.phase_words,
        seconds,
    ]


if __name__ == "__main__":
    main()
