"""Programs that a reduction may start from: an output of the equations, parameters as inputs."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from mechanics.compiled.graphs import Graphs
from mechanics.compiled.outputs import ROWS
from mechanics.compiled.quantities import STATE
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.program import Builder, Program
from mechanics.program.casadi_reader import read
from mechanics.program.elimination import expand_solves
from mechanics.program.sympy_reader import read as read_expressions

FORWARD, INVERSE = "forward_dynamics", "inverse_dynamics"
LEFT_OUT = ("jacobians", "step")
"""Functions that are made of others: reduce these."""
GROUPS = (*STATE, "ud", "multipliers")


@dataclass(frozen=True)
class Base:
    """A program of one output.

    Attributes
    ----------
    program : Program
        Without linear systems.
    couplings : tuple of (int, str)
        Nodes that are entries of the mass matrix beside its diagonal, and their names.
    inner : tuple of str
        Parameters whose numbers, no rationals, stand in the program.
    """

    program: Program
    couplings: tuple[tuple[int, str], ...] = ()
    inner: tuple[str, ...] = ()


def bases(graphs: Graphs, name: str) -> Iterator[Base]:
    """Programs of an output, all of them the same function.

    Parameters
    ----------
    graphs : Graphs
        Of the equations, no parameter fixed.

    Raises
    ------
    InputError
        If there is no such output, or it is one that is made of others.
    """
    if name in LEFT_OUT:
        raise InputError(f"{name} cannot be reduced: it is made of others: reduce {FORWARD}")
    yield Base(as_compiled(graphs, name))
    programs, equations = graphs.source.programs, graphs.derived
    if programs is None:
        return
    if name == INVERSE and not equations.scene.constraints:
        build = programs.mechanism.builder
        for way in ROWS:
            yield Base(build.program({"forces": way(programs.mechanism)}))
    if name == FORWARD:
        for solution in programs.ways("elimination"):
            yield _with_couplings(equations, programs.system.mass, solution)


def _with_couplings(equations: Equations, mass: Sequence, solution: Sequence) -> Base:
    n, names = len(equations.scene.ud), [s.name for s in equations.scene.u]
    places = [(i, j) for i in range(len(mass)) for j in range(i)]
    build = solution[0].builder
    whole = expand_solves(
        build.program({
            "ud": solution[:n], "multipliers": solution[n:],
            "couplings": [mass[i][j] for i, j in places],
        })
    )  # fmt: skip
    outputs = dict(whole.outputs)
    entries = outputs.pop("couplings")
    named = [f"M[{names[j]}, {names[i]}]" for i, j in places]
    return Base(replace(whole, outputs=outputs), tuple(zip(entries, named, strict=True)))


def as_compiled(graphs: Graphs, name: str) -> Program:
    """What `compile` makes of an output, its numbers exact."""
    builder, known = Builder(), graphs.quantities
    function, constants = graphs.exact(name)
    arguments = {
        group: [builder.input(entry.name) for entry in getattr(known, group)] for group in GROUPS
    }
    arguments["constants"] = [*read_expressions(builder, constants)]
    given = {group: arguments[group] for group in function.name_in()}
    return builder.program(read(builder, function, given))
