"""Faults one at a time, each in a process of its own: does it change a number, who notices?

Reads a request as JSON from standard input, ``{"asked": [[{...} or null, [scene, ...]], ...],
"clean": {scene: {quantity: digits}} or null}``, and prints one line of JSON for each fault and
scene; what became of it goes to standard error in words. The package is imported once; each process
is forked from there, and gets its fault.
The steps of `crosscheck` that are quick come first, so that most faults need no more; `crosscheck`
itself has the last word.
"""

import json
import os
import signal
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from cProfile import Profile
from random import Random
from types import CodeType
from typing import Any

from sympy import Abs, cos, sin, sqrt, symbols
from sympy.core.cache import clear_cache

from benchmarks.faults.fault import Fault, place_of, plant
from benchmarks.faults.operating_points import linear_outcome
from benchmarks.faults.scenes import OWN, SCENES
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.checks.energy import kinetic
from mechanics.checks.jets import precision
from mechanics.checks.joints import check_joints
from mechanics.checks.route_canaries import known_findings
from mechanics.checks.states import State, name_of
from mechanics.checks.virtual_power import (
    BITS,
    check_virtual_power,
    drawn_states,
    plain_values,
    solved,
)
from mechanics.crosscheck import CrossCheck, crosscheck
from mechanics.crosscheck.by_sympy import METHODS
from mechanics.crosscheck.programs import Programs, check_laws, derive_rows
from mechanics.crosscheck.programs import solved as solved_program
from mechanics.crosscheck.sympy_table import too_large
from mechanics.equations import Equations
from mechanics.kernel import Finding, Verdict
from mechanics.kinematics.motion import poses
from mechanics.mechanism import Mechanism
from mechanics.mechanism import name_of as node_name
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.routes.derivation import ROUTES, is_written_out
from mechanics.routes.loads import potential as potential_of
from mechanics.scene import Scene
from mechanics.scene.potential import potential
from mechanics.symbolic import prove_equal

PATIENCE = 600
"""Seconds of processor time for one fault in one scene."""

Numbers = dict[str, str]


def outcome(name: str, probes: Numbers, clean: Mapping[str, str] | None) -> dict[str, Any]:
    """What became of one scene: ``numbers`` without a fault, else ``changed`` and ``noticed``."""
    try:
        numbers = dict(probes)
        scene = SCENES[name]()
        mechanism = check_scene(scene)
        states, support = drawn_states(scene), None
        joints = unsupported(check_joints(scene, states))
        if clean is not None and joints:
            return {"changed": True, "noticed": joints}
        numbers |= potential_numbers(scene, states)
        written = is_written_out(mechanism)
        ways = [route.derive for route in ROUTES] if written else []
        if not too_large(mechanism):
            ways += [derive for _, derive in METHODS.values()]
        for derive in ways:
            equations = derive(scene)
            support = support or equations
            numbers |= motion_numbers(equations, support, states)
            if clean is None or not differ(numbers, clean):
                continue
            finding = check_virtual_power(equations, states, support)
            if finding.verdict is not Verdict.SUPPORTED:
                return {"changed": True, "noticed": f"{finding.subject}: {finding.verdict.name}"}
        programs = derive_rows(mechanism, [route.name for route in ROUTES])
        if not scene.constraints:
            # Drawn states do not meet constraints, off which routes may differ.
            numbers |= program_numbers(programs, reactions=not written)
        findings = [*compare_pairs(programs.routes).values(), *check_laws(programs)]
        numbers |= {f"programs: {f.subject}": "" if f.shown else "not" for f in findings}
        wrong = [finding for finding in findings if not finding.shown]
        if clean is not None and wrong:
            words = f"programs: {wrong[0].subject}: {wrong[0].verdict.name}"
            return {"changed": True, "noticed": words}
        linear, findings = linear_outcome(name, scene, programs)
        numbers, deviating = numbers | linear, unsupported(findings)
        if clean is None:
            if wrong or joints or deviating:
                raise RuntimeError(f"{name}, without a fault: {wrong} {joints} {deviating}")
            return {"numbers": numbers}
        if deviating:
            return {"changed": True, "noticed": deviating}
        changed = differ(numbers, clean)
        result = crosscheck(scene, CrossCheck(states=0)) if changed else None
    except Exception as error:
        # Whatever is raised is no answer that somebody could take for a right one.
        if clean is None:
            raise
        return {"changed": True, "noticed": words_of(error)}
    if result is None or result.ok:
        return {"changed": changed, "noticed": ""}
    first = result.open[0]
    return {"changed": True, "noticed": f"{first.subject}: {first.verdict.name}"}


def words_of(error: Exception) -> str:
    """Its kind and how its message begins."""
    return f"{type(error).__name__}: {str(error)[:120]}"


def unsupported(findings: Iterable[Finding]) -> str:
    """The first finding that numbers do not support; empty where they support all."""
    wrong = (f for f in findings if f.verdict is not Verdict.SUPPORTED)
    return next((f"{f.subject}: {f.verdict.name}" for f in wrong), "")


def differ(numbers: Mapping[str, str], clean: Mapping[str, str]) -> bool:
    """Whether one of the numbers is another one than without the fault."""
    return any(clean.get(key) != value for key, value in numbers.items())


def motion_numbers(equations: Equations, support: Equations, states: Sequence[State]) -> Numbers:
    """Accelerations, multipliers and reactions of a route at the drawn states."""
    found = {}
    with precision(BITS):
        for state in states[:2]:
            changes, values = solved(equations, support, state)
            values |= {f"change {i}": change for i, change in enumerate(changes)}
            found |= {
                f"{equations.route} {state.index} {name}": value.str(25, radius=False)
                for name, value in values.items()
            }
    return found


def program_numbers(programs: Programs, *, reactions: bool) -> Numbers:
    """What the routes as programs say, and both energies, at two states.

    Where the equations are written out, programs say the accelerations only.
    """
    found = energy_numbers(programs.mechanism)
    for route in programs.routes:
        program = solved_program(programs, route)
        for seed in range(2):
            for name, values in interpret(program, Arrays(), drawn(program.inputs, seed)).items():
                if reactions or name == "ud":
                    found[f"program {route} {seed} {name}"] = digits(values)
    return found


def energy_numbers(mechanism: Mechanism) -> Numbers:
    """Kinetic energy, and potential energy gained on the way to another configuration."""
    energies = {"T": [kinetic(mechanism)], "V": [potential_of(mechanism, poses(mechanism))]}
    program, found = mechanism.builder.program(energies), {}
    for seed in range(2):
        here, there = (drawn(program.inputs, each) for each in (seed, seed + 2))
        moved = here | {name: there[name] for name in map(node_name, mechanism.q) if name in here}
        first, second = (interpret(program, Arrays(), state) for state in (here, moved))
        found[f"program kinetic {seed}"] = digits(first["T"])
        found[f"program potential {seed}"] = digits([second["V"][0] - first["V"][0]])
    return found


def drawn(names: Sequence[str], seed: int) -> dict[str, float]:
    """Numbers from 0.5 to 1.5, by name."""
    return {name: 0.5 + Random(f"{seed} {name}").random() for name in names}


def digits(values: Sequence[float]) -> str:
    """Numbers to nine digits."""
    return " ".join(f"{value:.9g}" for value in values)


def potential_numbers(scene: Scene, states: Sequence[State]) -> Numbers:
    """Potential energy gained between two drawn states; no motion shows a constant of it."""
    energy, found = potential(scene), {}
    names = [name_of(q) for q in scene.coordinates]
    with precision(BITS):
        for state in states[:2]:
            values = [
                plain_values(state.plain() | dict(zip(names, other.q, strict=True)), state)(energy)
                for other in states[:2]
            ]
            found[f"potential {state.index}"] = (values[1] - values[0]).str(25, radius=False)
    return found


def verdicts_of_probes() -> Numbers:
    """Whether statements are shown that are known to be true, and to be false."""
    x, y = symbols("x y", real=True)
    p = symbols("p", positive=True)
    probes = (
        (sin(x) ** 2 + cos(x) ** 2, 1), (sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)),
        (sin(2 * x), 2 * sin(x) * cos(x)), (sqrt(p**2), p), (sqrt(x**2), Abs(x)),
        ((x**2 - y**2) / (x - y), x + y), (sqrt(2) ** 2, 2),
        (sin(x), cos(x)), (sin(x) ** 2, 1), (sin(x / 2), sin(x) / 2), (sqrt(x**2), x),
        (sqrt(2), 1 + x), (Abs(x), x), (x / (1 + y**2), x), (x * y, x + y), (x, -x),
        ([x, y], [x, x]), ([x, x * (x + y)], [x, x**2 + x * y]), (1 / x + 1 / y, (x + y) / (x * y)),
        (sin(-x), sin(x)), (x / y, x * y),
    )  # fmt: skip
    return {
        f"{left} = {right}": prove_equal("probe", left, right).verdict.name
        for left, right in probes
    } | {words: finding.verdict.name for words, _, finding in known_findings()}


def calls(name: str, probes: Numbers) -> dict[str, Any]:
    """What becomes of a scene without a fault, the functions that it calls, and how often."""
    profile = Profile(builtins=False)
    clean = profile.runcall(outcome, name, probes, None)
    if name in OWN:
        # What is not shown without a fault either has noticed none; laws show the shipped systems.
        still_open = crosscheck(SCENES[name](), CrossCheck(states=0)).open
        if still_open:
            raise RuntimeError(f"{name}, without a fault: {still_open}")
    called = [entry for entry in profile.getstats() if isinstance(entry.code, CodeType)]
    places = {place_of(entry.code) for entry in called}
    return {**clean, "calls": sorted(places), "count": sum(entry.callcount for entry in called)}


def answer(fault: Fault | None, scenes: Sequence[str], clean: Mapping[str, Any] | None) -> None:
    """Plant a fault and say what became of each scene; without one, what was called, too."""
    if fault is not None:
        plant(fault)
    clear_cache()
    try:
        probes = verdicts_of_probes()
    except Exception as error:
        if fault is None:
            raise
        for name in scenes:
            say(fault, name, {"changed": True, "noticed": words_of(error)})
        return
    for name in scenes:
        # Each scene has a process of its own: what one keeps, another calls.
        if in_child(lambda name=name: answer_of(fault, name, probes, clean)):
            continue
        if fault is not None:
            say(fault, name, {"changed": True, "noticed": "no end"})


def answer_of(
    fault: Fault | None, name: str, probes: Numbers, clean: Mapping[str, Any] | None
) -> None:
    """Say what became of one scene."""
    say(fault, name, calls(name, probes) if clean is None else outcome(name, probes, clean[name]))


def say(fault: Fault | None, name: str, found: Mapping[str, Any]) -> None:
    """One line of JSON; and for who waits, in words."""
    print(json.dumps({"fault": fault.what if fault else "", "scene": name, **found}), flush=True)
    if fault is not None:
        state = found["noticed"] or ("UNNOTICED" if found["changed"] else "no number changes")
        print(f"{name}: {fault.what}: {state}", file=sys.stderr, flush=True)


def in_child(work: Callable[[], None]) -> bool:
    """Whether work that is done in a process of its own comes to an end."""
    child = os.fork()
    if child == 0:
        # What has no end is stopped, and has shown nothing.
        signal.setitimer(signal.ITIMER_PROF, PATIENCE)
        work()
        os._exit(0)
    return os.waitpid(child, 0)[1] == 0


def main() -> None:
    """Answer one request."""
    request = json.load(sys.stdin)
    for row, scenes in request["asked"]:
        fault = row and Fault(**row)
        in_child(lambda fault=fault, scenes=scenes: answer(fault, scenes, request["clean"]))


if __name__ == "__main__":
    main()
