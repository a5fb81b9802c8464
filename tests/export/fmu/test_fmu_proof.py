"""The C of a unit is its graph, and its graph is the model's: shown in exact arithmetic."""

import re
import zipfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from sympy import Matrix, Symbol

from mechanics.compiled import Model
from mechanics.compiled.c.names import identifier
from mechanics.compiled.custody.code import exact
from mechanics.compiled.custody.derived import Derived
from mechanics.compiled.custody.kernel import Kernel
from mechanics.compiled.custody.prove import Graph, prove_text
from mechanics.compiled.program import program
from mechanics.exact import Verdict, decide
from mechanics.exact.c_parse import parse
from mechanics.export.fmu.functions import Functions, functions
from mechanics.export.fmu.model_text import symbol
from systems import ALL

SYSTEMS = [system.name for system in ALL]


def texts(unit: Path) -> dict[str, str]:
    with zipfile.ZipFile(unit) as archive:
        return {n: archive.read(f"sources/{n}").decode() for n in ("model.c", "model.h")}


def names_of(known: Functions, model: Model) -> Derived:
    """The names of the arguments; there is nothing else that the text has to agree with."""
    quantities = model.quantities
    given = [Symbol("t"), *(e.symbol for e in (*quantities.q, *quantities.u, *known.inputs,
                                              *known.p)), Symbol("step_size")]  # fmt: skip
    seeds = max(f.numel_in(1) for f in known.graphs.values() if f.n_in() > 1)
    groups = {"given": tuple(given), "seed": tuple(Symbol(f"s{i}") for i in range(seeds))}
    none = Matrix(0, 0, [])
    return Derived(model.equations.scene.name, model.equations.route, groups, {}, None, (), none,
                   none, none, none, ())  # fmt: skip


def verdicts(found: dict[str, str], known: Functions, model: Model) -> Iterator[tuple[str, Any]]:
    source = parse(found["model.c"], "model.c", includes={"model.h": found["model.h"]})
    names = names_of(known, model)
    for name, function in known.graphs.items():
        code = program(function)
        if not code.outputs[0]:
            continue
        kernel = Kernel(name, symbol(identifier(model.equations.scene.name), name), "model.c",
                        "double")  # fmt: skip
        yield name, prove_text(kernel, source, {name: Graph(exact(code), code)}, names)[0]


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_text_of_a_unit_is_its_graph(
    unit_of: Callable[[str], Path], model_of: Callable[[str], Model], name: str
) -> None:
    model = model_of(name)
    found = dict(verdicts(texts(unit_of(name)), functions(model), model))
    assert {"rates", "tangent", "adjoint"} <= set(found)
    for finding in found.values():
        assert finding.verdict in (Verdict.PROVED, Verdict.CERTIFIED), finding


def test_a_changed_sign_is_refuted(
    unit_of: Callable[[str], Path], model_of: Callable[[str], Model]
) -> None:
    model, found = model_of("rocker"), texts(unit_of("rocker"))
    text = found["model.c"]
    places = [match.start() for match in re.finditer(r"(?<=\w) [+-] (?=\w)", text)]
    assert len(places) > 10
    for at in places[:: len(places) // 5]:
        changed = text[:at] + (" + " if text[at + 1] == "-" else " - ") + text[at + 3 :]
        function = re.findall(r"^int rocker_(\w+)", text[:at], re.MULTILINE)[-1]
        judged = dict(verdicts({**found, "model.c": changed}, functions(model), model))
        refuted = [name for name, finding in judged.items() if finding.verdict is Verdict.REFUTED]
        assert refuted == [function]


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_graph_of_a_unit_is_the_model_s(model_of: Callable[[str], Model], name: str) -> None:
    model = model_of(name)
    known = functions(model)
    given = names_of(known, model).symbols["given"]
    groups = [[e.symbol for e in getattr(model.quantities, g)] for g in ("q", "u", "inputs", "p")]

    def experiment(a: Any) -> list[tuple[Any, Any]]:
        walk = partial(a.graph)
        (rates,) = walk(known.graphs["rates"], symbols=[list(given)])
        (kinematic,) = walk(model.casadi["coordinate_rates"], symbols=groups)
        accelerations, _ = walk(model.casadi["forward_dynamics"], symbols=groups)
        return list(zip(rates, [*kinematic, *accelerations], strict=True))

    assert decide(f"rates of the unit of {name}", experiment).shown
