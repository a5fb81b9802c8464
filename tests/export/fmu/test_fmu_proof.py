"""The C of a unit is its graph, and its graph is the model's: shown in exact arithmetic."""

import re
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from sympy import Symbol

from mechanics.compiled import Model
from mechanics.export.fmu.functions import functions
from mechanics.export.fmu.proof import prove_functions, prove_unit
from mechanics.kernel import Verdict
from mechanics.program.c.parse import parse
from mechanics.symbolic import decide
from systems import ALL

pytestmark = pytest.mark.campaign

SYSTEMS = [system.name for system in ALL]
Models, Units = Callable[[str], Model], Callable[[str], Path]


@pytest.mark.sample(1)
@pytest.mark.parametrize("name", SYSTEMS)
def test_the_text_of_a_unit_is_its_graph(unit_of: Units, model_of: Models, name: str) -> None:
    found = prove_unit(model_of(name), unit_of(name))
    subjects = [finding.subject for finding in found]
    # The functions of the model first: forward dynamics and rates of coordinates at least.
    assert len([s for s in subjects if " = derived, " in s]) >= 2
    parts = [s.split("_")[-1] for s in subjects if s.endswith(" = graph")]
    assert parts == [f"{part} = graph" for part in ("rates", "outputs", "tangent", "adjoint")]
    for finding in found:
        assert finding.verdict in (Verdict.PROVED, Verdict.CERTIFIED), finding


def test_a_changed_sign_is_refuted(unit_of: Units, model_of: Models) -> None:
    model = model_of("rocker")
    known = functions(model)
    with zipfile.ZipFile(unit_of("rocker")) as archive:
        text, header = (archive.read(f"sources/model.{kind}").decode() for kind in "ch")
    places = [match.start() for match in re.finditer(r"(?<=\w) [+-] (?=\w)", text)]
    assert len(places) > 10
    for at in places[:: len(places) // 5]:
        changed = text[:at] + (" + " if text[at + 1] == "-" else " - ") + text[at + 3 :]
        function = re.findall(r"^int (rocker_\w+)", text[:at], re.MULTILINE)[-1]
        source = parse(changed, "model.c", includes={"model.h": header})
        found = prove_functions(model, known, source)
        refuted = [finding.subject for finding in found if finding.verdict is Verdict.REFUTED]
        assert refuted == [f"model.c: {function} = graph"]


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_graph_of_a_unit_is_the_model_s(model_of: Models, name: str) -> None:
    model = model_of(name)
    known, quantities = functions(model), model.quantities
    groups = [[e.symbol for e in getattr(quantities, g)] for g in ("q", "u", "inputs", "p")]
    others = [e.symbol for e in (*quantities.q, *quantities.u, *known.inputs, *known.p)]
    given = [Symbol("t"), *others, Symbol("step_size")]

    def experiment(a: Any) -> list[tuple[Any, Any]]:
        (rates,) = a.graph(known.graphs["rates"], symbols=[given])
        (kinematic,) = a.graph(model.casadi["coordinate_rates"], symbols=groups)
        accelerations, _ = a.graph(model.casadi["forward_dynamics"], symbols=groups)
        return list(zip(rates, [*kinematic, *accelerations], strict=True))

    assert decide(f"rates of the unit of {name}", experiment).shown
