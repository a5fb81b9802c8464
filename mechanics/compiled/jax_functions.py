"""Compiled functions as functions of JAX: the program that C is printed from, on its arrays."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from mechanics.compiled.graphs import MATRICES, Graphs
from mechanics.compiled.programs.of_model import Programs
from mechanics.errors import InputError
from mechanics.program.interpret import interpret
from mechanics.program.jax_domain import jax_arrays
from mechanics.program.routine import Routine, entries_of

JaxFunction = Callable[..., dict[str, Any]]


class JaxFunctions(Mapping[str, JaxFunction]):
    """Functions by name: those of `Model.casadi`.

    Each takes the arrays of one state by position or name, in the order of the CasADi function, and
    gives a dict of its outputs; ``jax.vmap`` makes it one of many states. Doubles need
    ``jax.config.update("jax_enable_x64", True)``.
    """

    def __init__(self, graphs: Graphs, programs: Programs) -> None:
        self._graphs, self._programs = graphs, programs

    def __iter__(self) -> Iterator[str]:
        return iter(self._graphs)

    def __len__(self) -> int:
        return len(self._graphs)

    def __getitem__(self, name: str) -> JaxFunction:
        if name not in tuple(self._graphs):
            raise KeyError(name)
        return _function(self._programs[name])


def _function(routine: Routine) -> JaxFunction:
    domain, entries = jax_arrays(), entries_of(routine.inputs)
    numpy, names = domain.numpy, [name for name, _ in routine.inputs]

    def call(*arrays: Any, **named: Any) -> dict[str, Any]:
        together = dict(zip(names, arrays, strict=False)) | named
        if len(arrays) + len(named) != len(names) or set(together) != set(names):
            raise InputError(f"{routine.name}: it takes {', '.join(names)}: give each once")
        values = []
        for name, size in routine.inputs:
            array = numpy.atleast_1d(numpy.asarray(together[name]))
            if array.shape != (size,):
                raise InputError(
                    f"{routine.name}: {name} has the shape {array.shape}, ({size},) expected: use"
                    " jax.vmap for many states"
                )
            values += [array[k] for k in range(size)]
        found = interpret(
            routine.program, domain, dict(zip(entries, values, strict=True)), release=False
        )
        kind = numpy.result_type(float, *values) if values else float
        return {
            name: _shaped(numpy, found[name], name in MATRICES, *shape, kind)
            for name, shape in routine.shapes
        }

    call.__name__ = routine.name
    call.__doc__ = f"{', '.join(names)} -> {', '.join(name for name, _ in routine.shapes)}"
    return call


def _shaped(numpy: Any, column: Any, matrix: bool, rows: int, cols: int, kind: Any) -> Any:
    """Entries stand column by column."""
    flat = numpy.stack([numpy.asarray(e, kind) for e in column]) if column else numpy.zeros(0, kind)
    return flat.reshape(cols, rows).T if matrix else flat
