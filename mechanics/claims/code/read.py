"""Code that computes equations: Python functions, CasADi functions, C source.

    arguments -> symbols of the scene,   code -> formulas,   outputs -> rows of the ledger

The code itself is read, so that its own formulas are judged, for all values of its arguments.
"""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import casadi
from sympy import Expr, Matrix, S

from mechanics.claims.assemble import Reading
from mechanics.claims.code.angle_wrapping import with_unwrapped_angles
from mechanics.claims.code.arguments import Arguments, entries_of, state_is_stated
from mechanics.claims.code.c.constants import with_constants
from mechanics.claims.code.c.flat import flat
from mechanics.claims.code.c.globals import with_globals
from mechanics.claims.code.c.integers import refuse_integer_quotients
from mechanics.claims.code.c.library import with_library
from mechanics.claims.code.c.macros import without_macros
from mechanics.claims.code.c.parameters import with_parameters
from mechanics.claims.code.c.person import defaults, known_meaning, of_the_header, without_comments
from mechanics.claims.code.c.place import placed
from mechanics.claims.code.c.plain import plain
from mechanics.claims.code.c.target import Instructions
from mechanics.claims.code.c.untyped import with_types
from mechanics.claims.code.c.wrapper import WRAPPER, wrapped
from mechanics.claims.code.casadi_symbols import function_of
from mechanics.claims.code.code_function import code_function
from mechanics.claims.code.column_arguments import with_column_arguments
from mechanics.claims.code.determinism import doubt_when_repeated
from mechanics.claims.code.doubles import doubt_as_doubles
from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.integrators import STEP
from mechanics.claims.code.out_arguments import returning
from mechanics.claims.code.python.file_names import refuse_unsettled
from mechanics.claims.code.python.kept_values import refuse_stale
from mechanics.claims.code.python.local_numbers import with_local_numbers
from mechanics.claims.code.python.python_call import beside, signature_of
from mechanics.claims.code.python.wrappers import unwrapped
from mechanics.claims.code.read_outputs import read_outputs
from mechanics.claims.code.trace.execution_paths import ways_of
from mechanics.claims.code.trace.formulas import (
    Assignment,
    Assignments,
    Authored,
    Formula,
    Formulas,
    of_graph,
)
from mechanics.claims.code.trace.liveness import demands_of
from mechanics.claims.code.trace.numerical_check import doubt_when_called
from mechanics.claims.code.trace.sympy_expressions import Constants, expressions
from mechanics.claims.code.trace.tracing import Outputs, trace
from mechanics.claims.code.unpacking import Apart, in_c, in_python
from mechanics.claims.demands import Demand
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.place import bounded
from mechanics.errors import ExpressionError, InputError
from mechanics.program.c.function import Parameter
from mechanics.program.c.parse import parse
from mechanics.program.c.reader import read_function as read_c_function
from mechanics.program.c.select import latest
from mechanics.program.casadi_reader import Instruction as Node
from mechanics.program.casadi_reader import single_assignment
from mechanics.scene import Scene

LARGEST_C = 30_000
"""Characters of a C file."""

LARGEST_FORMULA = 300_000
"""Operations of one output, written out without sharing."""


def read_function(
    scene: Scene,
    function: Callable[..., Any],
    names: Mapping[str, str] | None = None,
    about: str | None = None,
    text: str = "",
) -> Reading:
    """Statements of a Python function on numbers and NumPy arrays, by tracing it.

    It is then called with numbers: where it returns others than its formulas, they have a doubt.

    Parameters
    ----------
    scene : Scene
    function : callable
    names : mapping of str to str, optional
        What arguments are: ``{"state": "x x_dot theta theta_dot", "force": "F"}``.
    about : str, optional
        What it returns, where that is not plain.
    text : str
        Of its author's file, where that is in another language.

    Raises
    ------
    InputError
        When an argument is unexplained, or the code hides a formula.
    """
    if (symbolic := function_of(function)) is not None:
        return read_casadi(scene, symbolic.function, names, about, function, symbolic.apart)
    refuse_stale(function)
    size = len(scene.q) + len(scene.u)
    vocabulary = Vocabulary(scene)
    constants = {one for n in vocabulary.constants for one in (n, n.upper(), n.lower())}
    function = with_local_numbers(unwrapped(function), {*constants, *(names or {}), *STEPS})
    function = returning(with_column_arguments(function), size, names or {})
    title = getattr(function, "__name__", type(function).__name__)
    called = signature_of(function, Naming(vocabulary), names or {}, title)
    refuse_unsettled(function, {n for n, symbol in called.standing.items() if symbol.is_Symbol})

    def run(given: Arguments) -> Outputs:
        passed = [symbol for value in given.values.values() for symbol in entries_of(value)]
        standing, remarks = beside(function, called.standing, passed)
        outputs = trace(function, given.values, standing)
        _bounded_outputs(outputs, title)
        if called.steps and len(outputs.entries) == size:
            stepping = trace(function, given.values, {**standing, **called.steps})
            if {entry.subs(STEP, 0) for entry in stepping.entries} == {*scene.q, *scene.u}:
                outputs, standing = stepping, {**standing, **called.steps}
        doubt = doubt_when_repeated(function, given.values, outputs, standing)
        doubt = doubt or doubt_when_called(function, given.values, outputs, standing)
        notes = (*outputs.notes, *remarks)
        # A list of rates has the order of its state, whatever its entries are called.
        placed = state_is_stated(given) and 0 < len(given.state) == len(outputs.entries)
        names_of = outputs.names or (() if placed else called.returned)
        outputs = replace(outputs, notes=notes, doubt=doubt, names=names_of)
        return with_unwrapped_angles(scene, outputs)

    sizes = dict.fromkeys(called.wanted)
    text = text or called.text
    code = code_function(
        scene, title, called.wanted, sizes, run, names, called.apart, text,
        called.standing.values(),
    )  # fmt: skip
    found = read_outputs(code, about)
    code_values = tuple(called.own.items())
    statements = tuple(replace(s, code_values=code_values) for s in found.statements)
    return replace(found, statements=statements, remarks=(*found.remarks, *called.remarks))


def _expanded(function: casadi.Function) -> casadi.Function:
    """The function in scalar operations."""
    try:
        return function.expand()
    except RuntimeError as error:
        name = function.name()
        words = f"function {name}: it cannot be expanded into scalars: write it with SX"
        raise InputError(words) from error


def read_casadi(
    scene: Scene,
    function: casadi.Function,
    names: Mapping[str, str] | None = None,
    about: str | None = None,
    maker: Callable[..., Any] | None = None,
    together: Mapping[str, Apart] | None = None,
) -> Reading:
    """Statements of a CasADi function; arguments as for `read_function`, by their names.

    Parameters
    ----------
    maker : callable, optional
        That makes it, and takes its arguments apart.
    together : mapping of str to Apart, optional
        Arguments of several entries with names.
    """
    function = function if function.is_a("SXFunction") else _expanded(function)
    wanted = [function.name_in(i) for i in range(function.n_in())]
    sizes = {name: function.numel_in(i) for i, name in enumerate(wanted)}

    def run(given: Arguments) -> Outputs:
        nodes, stores = single_assignment(function)
        held = [
            [group[i] for i in function.sparsity_in(k).find()]
            for k, group in enumerate(entries_of(given.values[name]) for name in wanted)
        ]
        constants = Constants()
        made = expressions(nodes, held, constants)
        numbers = [[S.Zero] * function.numel_out(i) for i in range(function.n_out())]
        for out, entry, node in stores:
            numbers[out][function.sparsity_out(out).find()[entry]] = made[node]
        shapes = [function.size_out(i) for i in range(function.n_out())]
        # CasADi counts entries column by column.
        values = [Matrix(c, r, n).T for (r, c), n in zip(shapes, numbers, strict=True)]
        formulas = of_graph(nodes, held, constants)
        known = {made[node]: formulas[node] for _, _, node in stores}
        demands = _demanded((made[node], demands_of(nodes, made, node)) for _, _, node in stores)
        scalar = all(len(value) == 1 for value in values)
        outputs = Outputs(
            tuple(values), tuple(constants.notes), formulas=_known(known), demands=demands,
            names=tuple(map(function.name_out, range(function.n_out()))) if scalar else (),
        )  # fmt: skip
        last = _in_rows(function, stores, len(nodes))
        own = [*nodes, Node(casadi.OP_CONST, (), Fraction(0))]
        return replace(outputs, doubt=doubt_as_doubles(own, last, held, outputs))

    apart, _, text = in_python(maker) if maker else ({}, (), "")
    apart = {**apart, **(together or {})}
    code = code_function(scene, function.name(), wanted, sizes, run, names, apart, text)
    return read_outputs(code, about)


def _in_rows(
    function: casadi.Function, stores: Iterable[tuple[int, int, int]], zero: int
) -> list[int]:
    """The nodes of a CasADi function's results, row by row; `zero` where there is none."""
    found: list[int] = []
    kept = [function.sparsity_out(out).find() for out in range(function.n_out())]
    places = {(out, kept[out][entry]): node for out, entry, node in stores}
    for out in range(function.n_out()):
        rows, columns = function.size_out(out)
        found += [
            places.get((out, column * rows + row), zero)
            for row in range(rows)
            for column in range(columns)
        ]
    return found


def read_c(
    scene: Scene,
    text: str,
    function: str | None = None,
    names: Mapping[str, str] | None = None,
    about: str | None = None,
    origin: str = "code.c",
) -> Reading:
    """Statements of a C function: numbers and arrays as arguments, what it writes as outputs.

    Parameters
    ----------
    text : str
    function : str, optional
        Its name; the last function of the file when not given.

    Raises
    ------
    InputError
        For C that is not supported, by line and column.
    """
    bounded(text, origin)
    if len(text) > LARGEST_C:
        raise InputError(f"{origin}, line 1, column 1: {len(text)} characters: {LARGEST_C} at most")
    coord, whole = "", text
    try:
        passed = with_parameters(without_comments(text), Vocabulary(scene))
        text = passed.text if passed.notes else text
        if re.search(r"\bvoid\b", text):
            text = with_types(without_comments(text).replace("GSL_SUCCESS", "0"), origin)
        text = of_the_header(without_macros(text, origin))
        text = with_globals(with_constants(text, origin, passed.integers), function)
        source = known_meaning(parse(text, origin), text)
        refuse_integer_quotients(source, function, passed.integers)
        taken = defaults(source, text)
        written = plain(text, origin, whole)
        text = written.text
        call = wrapped(flat(parse(text, origin)), text, function)
        coord, wanted = call.coord, list(call.inputs)

        def run(given: Arguments) -> Outputs:
            sizes = {name: len(entries_of(given.values[name])) for name in wanted}
            outputs = _c_outputs(call.source(sizes), origin, wanted, given, call.size)
            notes = (*outputs.notes, *written.notes, *taken, *passed.notes)
            return replace(outputs, names=call.outputs, notes=notes)

        apart = {**in_c(without_comments(text)), **written.apart}
        code = code_function(scene, call.name, wanted, call.inputs, run, names, apart, whole)
        return read_outputs(code, about).rounded(written.rounded)
    except (ExpressionError, InputError) as error:
        raise InputError(placed(text, str(error), origin, coord)) from None
    except RecursionError:
        words = "its expressions are nested too deeply"
        raise InputError(placed(text, words, origin, coord)) from None


def _c_outputs(
    text: str, origin: str, wanted: Sequence[str], given: Arguments, size: int
) -> Outputs:
    exact, unread = with_library(parse(text, origin), WRAPPER)
    source = flat(exact)
    entries = [entries_of(given.values[name]) for name in wanted]
    parameters = [
        *(
            Parameter(name, "double", len(group))
            for name, group in zip(wanted, entries, strict=True)
        ),
        Parameter("outputs", "double", size, output=True),
    ]
    target = Instructions()
    program, nodes = read_c_function(source, WRAPPER, parameters, target), target.nodes
    if program.beyond:
        raise InputError(f"{program.beyond[0]} is read beyond the end of the array")
    last: list[int] = []
    place = len(wanted)
    for entry in range(size):
        if (place, entry) not in program.outputs:
            raise InputError(f"{origin}: output {entry} is not written")
        node = latest(target, program.outputs[place, entry], True, "double", origin)
        if node is None:
            raise InputError(f"{origin}: output {entry} is written under a condition only")
        last.append(node)
    bounded_code(nodes, origin)
    constants = Constants()
    numbers = expressions(nodes, entries, constants)
    places = {node: (name, _line(where, origin)) for node, (name, where) in program.named.items()}
    assigned: dict[str, Assignment] = {}
    formulas = of_graph(nodes, entries, constants, places, assigned)
    found = [numbers[node] for node in last]
    known = {numbers[node]: formulas[node] for node in last}
    ways = ways_of(nodes, last, entries, places)
    asked = [(numbers[node], demands_of(nodes, numbers, node)) for node in last]
    outputs = Outputs(
        (Matrix(found),),
        (*constants.notes, *unread),
        formulas={**ways, **_known(known, assigned)},
        demands=_demanded(asked),
    )
    return replace(outputs, doubt=doubt_as_doubles(nodes, last, entries, outputs))


def _demanded(asked: Iterable[tuple[Expr, tuple[Demand, ...]]]) -> dict[Expr, tuple[Demand, ...]]:
    """Demands by the values that ask for them."""
    found: dict[Expr, tuple[Demand, ...]] = {}
    for value, demands in asked:
        found[value] = tuple(dict.fromkeys((*found.get(value, ()), *demands)))
    return found


def _line(where: str, origin: str) -> str:
    """``file:12:5`` as ``file, line 12``."""
    line = re.search(r":(\d+):\d+$", where)
    return f"{Path(origin).name}, line {line[1]}" if line else Path(origin).name


def _known(formulas: Mapping[Expr, Formula], assigned: Assignments | None = None) -> Formulas:
    """Those that are known, with the assignments that they are made with."""
    own = assigned or {}
    return {e: Authored(known.node, own) for e, known in formulas.items() if known is not None}


def _bounded_outputs(outputs: Outputs, title: str) -> None:
    """Refuse formulas that, written out, are larger than can be looked at.

    Raises
    ------
    InputError
    """
    sizes: dict[Expr, int] = {}
    todo = outputs.entries
    while todo:
        one = todo[-1]
        if missing := [part for part in one.args if part not in sizes]:
            todo += missing
            continue
        todo.pop()
        sizes[one] = min(1 + sum(sizes[part] for part in one.args), LARGEST_FORMULA + 1)
    if max(sizes.values(), default=0) > LARGEST_FORMULA:
        raise InputError(f"{title}: its formulas have more than {LARGEST_FORMULA} operations")


def bounded_code(nodes: Sequence[Node], origin: str) -> None:
    """Refuse code whose formulas, written out, are larger than can be looked at.

    Raises
    ------
    InputError
    """
    sizes: list[int] = []
    for node in nodes:
        inner = () if node.op == casadi.OP_INPUT else node.operands
        sizes.append(min(1 + sum(sizes[i] for i in inner), LARGEST_FORMULA + 1))
    if max(sizes, default=0) > LARGEST_FORMULA:
        raise InputError(f"{origin}: its formulas have more than {LARGEST_FORMULA} operations")
