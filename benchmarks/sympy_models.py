"""Models that SymPy, PyDy and SymBRiM ship or document: which come in, and which equations agree.

    python -m benchmarks.sympy_models
    python -m benchmarks.sympy_models --documentation sympy/doc/src --only disc

Examples in docstrings of the installed SymPy, models of its library and of its tests are run, and
every System, KanesMethod and LagrangesMethod that they make is taken; with `--documentation` those
of a folder of pages, too. PyDy's and SymBRiM's models are made where these are installed. Each is
read by `from_sympy`, and its own equations are compared with what its bodies and loads imply. A
method whose equations were never formed is left out; rows that say the same stand once. Prints
Markdown; times are processor seconds.
"""

import argparse
import contextlib
import doctest
import importlib
import importlib.util
import io
import signal
import sys
import warnings
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass
from pathlib import Path
from time import process_time
from types import FrameType
from typing import Any

import sympy.physics.mechanics as me
from sympy import symbols
from sympy.physics.mechanics import models

from mechanics.crosscheck.own_equations import compare_own
from mechanics.errors import MechanicsError
from mechanics.importers.sympy_model import KINDS
from mechanics.importers.sympy_scene import from_sympy
from mechanics.kernel import Verdict

LONGEST = 120
"""Seconds of processor time for one model, or for a test that makes some."""

DOCUMENTED = (
    "kane", "lagrange", "system", "models", "joint", "jointsmethod", "actuator", "pathway",
    "functions", "linearize", "method",
)  # fmt: skip
TESTED = (
    "test_kane", "test_kane2", "test_kane3", "test_kane4", "test_kane5", "test_lagrange",
    "test_lagrange2", "test_linearity_of_velocity_constraints", "test_jointsmethod",
    "test_system_class",
)  # fmt: skip
PAGES = ("tutorials/physics", "explanation/modules/physics")


@dataclass(frozen=True)
class Example:
    """A model, where it is from, and bodies that stand beside it."""

    name: str
    model: Any
    bodies: tuple[Any, ...] = ()


class TooLong(Exception):
    """A model or a test takes longer than it may."""


@contextlib.contextmanager
def limited() -> Iterator[None]:
    """Interrupt what takes too long."""

    def stop(number: int, frame: FrameType | None) -> None:
        raise TooLong

    signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, LONGEST)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def made(name: str, scope: Mapping[str, Any]) -> dict[int, Example]:
    """The models among variables, by identity."""
    values = list(scope.values())
    bodies = [v for v in values if isinstance(v, me.RigidBody | me.Particle)]
    found = {}
    for own in values:
        model = own.method if isinstance(own, me.JointsMethod) else own
        if isinstance(model, KINDS):
            found[id(model)] = Example(name, model, tuple(dict.fromkeys(bodies)))
    return found


def run(name: str, examples: list[doctest.Example], scope: dict[str, Any]) -> Iterator[Example]:
    """The models that examples leave behind; one that fails is skipped, as its reader would."""
    found: dict[int, Example] = {}
    for example in examples:
        silent = io.StringIO()
        with (
            contextlib.redirect_stdout(silent),
            contextlib.redirect_stderr(silent),
            contextlib.suppress(Exception),
        ):
            exec(compile(example.source, name, "single"), scope)
        found |= made(name, scope)
    yield from found.values()


def docstrings() -> Iterator[Example]:
    for module in DOCUMENTED:
        loaded = importlib.import_module(f"sympy.physics.mechanics.{module}")
        for test in doctest.DocTestFinder(exclude_empty=True).find(loaded):
            title = test.name.removeprefix("sympy.physics.mechanics.")
            yield from run(title, test.examples, dict(test.globs))


def pages(folder: Path, only: str) -> Iterator[Example]:
    for part in PAGES:
        for page in sorted(p for p in (folder / part).rglob("*.rst") if only in p.name):
            examples = doctest.DocTestParser().get_examples(page.read_text(encoding="utf-8"))
            yield from run(page.stem, examples, {})


def library() -> Iterator[Example]:
    for n in (1, 2, 3):
        yield Example(f"multi_mass_spring_damper({n})", models.multi_mass_spring_damper(n))
        yield Example(f"n_link_pendulum_on_cart({n})", models.n_link_pendulum_on_cart(n))
    masses = models.multi_mass_spring_damper(3, True, True)
    links = models.n_link_pendulum_on_cart(3, True, True)
    yield Example("multi_mass_spring_damper(3, gravity, forces)", masses)
    yield Example("n_link_pendulum_on_cart(3, force, torques)", links)


def tests() -> Iterator[Example]:
    """What the tests of the installed SymPy have in their variables when they return."""
    for module in TESTED:
        loaded = importlib.import_module(f"sympy.physics.mechanics.tests.{module}")
        for name, function in sorted(vars(loaded).items()):
            if not name.startswith("test_"):
                continue
            found: dict[int, Example] = {}

            def look(frame: FrameType, event: str, _: Any, name=name, found=found) -> None:
                if event == "return" and frame.f_code.co_name == name:
                    found |= made(name, frame.f_locals)

            sys.setprofile(look)
            try:
                with limited(), contextlib.suppress(Exception):
                    getattr(function, "__wrapped__", function)()
            finally:
                sys.setprofile(None)
            yield from (Example(f"{module}.{name}", e.model, e.bodies) for e in found.values())


def of_others() -> Iterator[Example]:
    """PyDy's and SymBRiM's models."""
    if importlib.util.find_spec("pydy"):
        pydy = importlib.import_module("pydy.models")
        masses = pydy.multi_mass_spring_damper(3, True, True)
        links = pydy.n_link_pendulum_on_cart(3, True, True)
        yield Example("PyDy: multi_mass_spring_damper(3)", masses.eom_method)
        yield Example("PyDy: n_link_pendulum_on_cart(3)", links.eom_method)
    if importlib.util.find_spec("symbrim"):
        disc = importlib.import_module("symbrim.other.rolling_disc")
        yield Example("SymBRiM: rolling_disc_manual", disc.rolling_disc_manual())
        yield Example("SymBRiM: WhippleBicycle", whipple())


def whipple() -> me.System:
    """As in SymBRiM's documentation."""
    brim = importlib.import_module("symbrim")
    bicycle = brim.WhippleBicycle("bike")
    bicycle.ground = brim.FlatGround("ground")
    for end in ("rear", "front"):
        setattr(bicycle, f"{end}_frame", getattr(brim, f"Rigid{end.title()}Frame")(f"{end}_frame"))
        setattr(bicycle, f"{end}_wheel", brim.KnifeEdgeWheel(f"{end}_wheel"))
        setattr(bicycle, f"{end}_tire", brim.NonHolonomicTire(f"{end}_tire"))
    bicycle.define_all()
    system = bicycle.to_system()
    normal = bicycle.ground.get_normal(bicycle.ground.origin)
    system.apply_uniform_gravity(-symbols("g") * normal)
    q, u = bicycle.q, bicycle.u
    system.q_ind, system.q_dep = [*q[:4], *q[5:]], [q[4]]
    system.u_ind, system.u_dep = [u[3], *u[5:7]], [*u[:3], u[4], u[7]]
    return system


def row(example: Example) -> tuple[str, ...] | None:
    """Cells of the table; None for a method whose equations nobody has formed."""
    model = example.model
    if isinstance(model, me.KanesMethod) and not model.bodies:
        return None
    if isinstance(model, me.LagrangesMethod) and model.eom is None:
        return None
    lagrange = isinstance(model, me.LagrangesMethod) and not model.bodies
    start, comes, agrees, why = process_time(), "no", "", ""
    try:
        with limited():
            scene = from_sympy(model, bodies=example.bodies if lagrange else ())
            comes = f"{len(scene.bodies)} / {len(scene.coordinates)} / {len(scene.constraints)}"
            first, *causes = compare_own(scene, model)
            agrees = first.verdict.name
            if first.verdict is Verdict.UNDECIDED:
                why = first.evidence
            told = (f"{cause.subject}: {cause.verdict.name}" for cause in causes)
            why = "; ".join([why, *told]).strip("; ")
    except MechanicsError as error:
        why = str(error)
    except TooLong:
        why = f"more than {LONGEST} s"
    seconds = process_time() - start
    kind = type(model).__name__.removesuffix("sMethod")
    return example.name, kind, comes, agrees, f"{seconds:.1f}", why


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--documentation", type=Path, help="SymPy's doc/src")
    parser.add_argument("--only", default="", help="models whose name holds this")
    parser.add_argument("--no-tests", action="store_true", help="leave out SymPy's tests")
    asked = parser.parse_args(arguments)
    warnings.simplefilter("ignore")
    sources = [library(), docstrings()]
    sources += [pages(asked.documentation, asked.only)] if asked.documentation else []
    sources += [of_others()]
    sources += [] if asked.no_tests else [tests()]
    print(
        "| example | class | bodies / coordinates / constraints | its equations | s"
        " | what is wrong, or missing |"
    )
    print("| --- | --- | --- | --- | --- | --- |")
    known: set[tuple[str, ...]] = set()
    for source in sources:
        for example in source:
            if asked.only not in example.name or (cells := row(example)) is None:
                continue
            if (told := (*cells[:4], cells[-1])) not in known:
                known.add(told)
                print("|", " | ".join(cells), "|", flush=True)
    print(f"\n{summary(known)}")
    return 0


def summary(rows: Set[tuple[str, ...]]) -> str:
    """How many come in, and agree."""
    inside = [cells for cells in rows if cells[2] != "no"]
    compared = [cells for cells in inside if cells[3]]
    agree = [cells for cells in compared if cells[3] in ("PROVED", "CERTIFIED")]
    return (
        f"Of {len(rows)} models {len(inside)} come in; of {len(compared)} whose comparison ends"
        f" {len(agree)} agree."
    )


if __name__ == "__main__":
    sys.exit(main())
