"""A reduced output as a model, which compiles, simulates, exports and verifies as any other.

    margins(state) = (x - lowest, highest - x) for everything that has a range       > 0 in the box

The box is a condition of its scene, so that a motion which leaves it is told, and a function of its
own, for C.
"""

from dataclasses import replace
from fractions import Fraction
from math import inf

from sympy import Rational

from mechanics.compiled.graphs import Graphs, function_inputs
from mechanics.compiled.machine.native import find_compiler
from mechanics.compiled.model import Model
from mechanics.compiled.programs.of_model import Programs
from mechanics.compiled.reduced import DOMAIN, Reduced
from mechanics.errors import InputError
from mechanics.program import Builder, Program
from mechanics.reduce.base import FORWARD
from mechanics.reduce.record import record_text
from mechanics.reduce.reduce import Reduction
from mechanics.scene import Scene, condition

ANYWHERE = -inf, inf

OTHERWISE = "leaves the domain of the reduced model"


def reduced_model(reduction: Reduction, compiler: str | None = "auto") -> Model:
    """The model of a reduction, its parameters fixed but for those that have a range.

    Its functions are the reduced one, ``domain``, and for forward dynamics the rates of the
    coordinates and the energy, which are those of the whole model.

    Parameters
    ----------
    reduction : Reduction
    compiler : str or None
        As for `mechanics.compile`.

    Raises
    ------
    InputError
        If its bound is not proved.
    """
    graphs = reduced_graphs(reduction)
    found = find_compiler() if compiler == "auto" else compiler
    return Model(graphs.derived, graphs, found, Programs(graphs))


def reduced_graphs(reduction: Reduction) -> Graphs:
    """The same as graphs.

    Raises
    ------
    InputError
        If its bound is not proved.
    """
    finding, equations, of = reduction.finding, reduction.equations, reduction.of
    if not finding.shown:
        raise InputError(f"{finding.subject} is {finding.verdict.name}: {finding.evidence}")
    functions = {of: reduction.program, DOMAIN: _domain(reduction)}
    every = function_inputs(equations)
    beside = ("coordinate_rates", "energy") if of == FORWARD else ()
    inputs = {name: every[name] for name in (of, *beside)}
    own = {entry.name for entry in Graphs(equations).quantities.ud}
    inputs[DOMAIN] = ("ud",) if own & reduction.box.keys() else ()
    scene = _with_conditions(reduction)
    reduced = Reduced(functions, inputs, record_text(reduction))
    return Graphs(replace(equations, scene=scene), fixed=reduction.fixed, reduced=reduced)


def _domain(reduction: Reduction) -> Program:
    builder = Builder()
    margins = []
    for name, (low, high) in reduction.box.items():
        margins += [builder.input(name) - low, high - builder.input(name)]
    return builder.program({"margins": margins})


def _with_conditions(reduction: Reduction) -> Scene:
    """The scene, which is left where coordinates, speeds and inputs are out of their ranges."""
    scene = reduction.equations.scene
    moving = {symbol.name: symbol for symbol in (*scene.q, *scene.u, *scene.input_symbols)}
    rows = []
    for name, (low, high) in reduction.box.items():
        if name in moving:
            ends = [Rational(end.numerator, end.denominator) for end in (low, high)]
            rows.append(
                condition(f"{name} not below its range", moving[name] >= ends[0], OTHERWISE)
            )
            rows.append(
                condition(f"{name} not above its range", moving[name] <= ends[1], OTHERWISE)
            )
    # A motion that starts by default has to start inside.
    example = dict(scene.example)
    for symbol in (*scene.q, *scene.u):
        name, (least, most) = symbol.name, reduction.box.get(symbol.name, ANYWHERE)
        if not least < example.get(name, 0) < most:
            example[name] = float((Fraction(least) + Fraction(most)) / 2)
    conditions = (*scene.conditions, *rows)
    return replace(
        scene, name=f"{scene.name}, reduced", conditions=conditions, example=example
    )  # fmt: skip
