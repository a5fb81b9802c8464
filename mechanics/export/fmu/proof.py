"""The C functions in a unit are what was derived.

    derived equations  =  graph                  for each function of the model that is in it
    model.c  --parsed-->  nodes  =  graph        for rates, outputs, tangent and adjoint

The text is read back from the archive. Its graphs are put together from those of the model.
"""

import zipfile
from pathlib import Path

from sympy import Symbol

from mechanics.compiled import Model
from mechanics.compiled.c.names import identifier
from mechanics.compiled.proof import prove_compiled, prove_graph
from mechanics.compiled.translation_validation.code import exact
from mechanics.compiled.translation_validation.derived import Derived
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.compiled.translation_validation.prove import Graph, outputs_of, prove_text
from mechanics.compiled.translation_validation.text import read_text
from mechanics.errors import ExpressionError
from mechanics.export.fmu.functions import (
    CLOCK,
    STEP_SIZE,
    Functions,
    conditional_graphs,
    functions,
)
from mechanics.export.fmu.model_text import symbol
from mechanics.kernel import Finding, undecided
from mechanics.program import Builder
from mechanics.program.c.parse import Source, parse
from mechanics.program.casadi_reader import read_routine

SOURCE, HEADER = "model.c", "model.h"
PARTS = ("forward_dynamics", "coordinate_rates", "reactions", "energy")
"""Functions of a model that units are put together from."""
TOLD = ("forward_dynamics", "reactions")
"""Those of another route, where conditions hold reactions that the model does not tell."""


def prove_unit(model: Model, path: str | Path) -> tuple[Finding, ...]:
    """Decide for each function in a unit whether it is the model's, and the model what was derived.

    Parameters
    ----------
    model : Model
        That the unit was written from.
    path : str or Path
        ``NAME.fmu``.
    """
    with zipfile.ZipFile(path) as archive:
        texts = {name: archive.read(f"sources/{name}").decode() for name in (SOURCE, HEADER)}
    source = parse(texts[SOURCE], SOURCE, includes={HEADER: texts[HEADER]})
    return (*prove_parts(model), *prove_functions(model, functions(model), source))


def prove_parts(model: Model) -> tuple[Finding, ...]:
    """Decide for the graphs that a unit is put together from whether they are what was derived."""
    parts = {*PARTS, *model.equations.scene.outputs}
    found = prove_compiled(model, [name for name in model.casadi if name in parts])
    others = conditional_graphs(model)
    if others is model.casadi:
        return found
    names = [name for name in others if name in TOLD]
    return (*found, *(prove_graph(name, others) for name in names))


def prove_functions(model: Model, known: Functions, source: Source) -> tuple[Finding, ...]:
    """The same for a text that has been parsed."""
    names = _names(model, known)
    found = []
    for name, function in known.graphs.items():
        code = read_routine(function)
        if not code.outputs[0]:
            continue
        kernel = Kernel(
            name, symbol(identifier(model.equations.scene.name), name), SOURCE, "double"
        )
        graph = Graph(exact(code), code)
        try:
            text = read_text(kernel, source, code.inputs, outputs_of(graph))
        except ExpressionError as error:
            found.append(undecided(f"{SOURCE}: {kernel.symbol} = graph", f"refused: {error}"))
            continue
        found.append(prove_text(text, source, {name: graph}, names))
    return tuple(found)


def _names(model: Model, known: Functions) -> Derived:
    """Symbols for the arguments: there is nothing else that text and graph have to agree about."""
    quantities = model.quantities
    given = (CLOCK, *quantities.q, *quantities.u, *known.inputs, *known.p, STEP_SIZE)
    size = max(f.numel_in(i) for f in known.graphs.values() for i in range(f.n_in()))
    groups = {
        "given": tuple(entry.symbol for entry in given),
        "seed": tuple(Symbol(f"seed_{i}") for i in range(size)),
    }
    scene, route = model.equations.scene.name, model.equations.route
    return Derived(scene, route, groups, {}, None, Builder().program({}))
