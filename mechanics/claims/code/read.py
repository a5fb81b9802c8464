"""Code that computes equations: Python functions, CasADi functions, C source.

    arguments -> symbols of the scene,   code -> formulas,   outputs -> rows of the ledger

The code itself is read, so that its own formulas are judged, for all values of its arguments.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import permutations
from pathlib import Path
from typing import Any

import casadi
from sympy import Expr, Matrix, S, cos, sin

from mechanics.claims.about import QUANTITIES, WORDS
from mechanics.claims.assemble import Reading
from mechanics.claims.code.angle_wrapping import with_unwrapped_angles
from mechanics.claims.code.arguments import (
    SAID,
    Arguments,
    arguments_of,
    contradicted,
    named_entries,
    places_of_vectors,
    vectors_of_motion,
)
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
from mechanics.claims.code.column_arguments import with_column_arguments
from mechanics.claims.code.determinism import doubt_when_repeated
from mechanics.claims.code.doubles import doubt_as_doubles
from mechanics.claims.code.energy_names import named_by_title, refuse_energy_of_a_part
from mechanics.claims.code.function_names import spoken
from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.integrators import STEP
from mechanics.claims.code.named_numbers import named_numbers
from mechanics.claims.code.out_arguments import returning
from mechanics.claims.code.output_names import listed_otherwise, unknown_words
from mechanics.claims.code.outputs import (
    MOST_ORDERED,
    Claim,
    claims,
    in_order,
    in_order_of,
    is_settled,
    manipulator,
    state_of_scalars,
    statement,
    taken_otherwise,
)
from mechanics.claims.code.python.file_names import refuse_unsettled
from mechanics.claims.code.python.kept_values import refuse_stale
from mechanics.claims.code.python.local_numbers import with_local_numbers
from mechanics.claims.code.python.python_call import beside, signature_of
from mechanics.claims.code.python.wrappers import unwrapped
from mechanics.claims.code.qualified_names import another_quantity_word, unknown_qualifiers
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
from mechanics.claims.guess import at_one_step, guess
from mechanics.claims.kinds import angular
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.claims.place import bounded
from mechanics.claims.state_order import comments_of, state_order
from mechanics.claims.tree import Name
from mechanics.errors import ExpressionError, InputError
from mechanics.program.c.function import Parameter
from mechanics.program.c.parse import parse
from mechanics.program.c.reader import read_function as read_c_function
from mechanics.program.c.select import latest
from mechanics.program.casadi_reader import Instruction as Node
from mechanics.program.casadi_reader import single_assignment
from mechanics.scene import Scene
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.quantities import MassMatrix

LARGEST_C = 30_000
"""Characters of a C file."""

LARGEST_FORMULA = 300_000
"""Operations of one output, written out without sharing."""

PART = re.compile(r"grav|coriol|centri|friction|damping", re.IGNORECASE)
"""In the name of a function that returns a part of what drives."""

Run = Callable[[Arguments], Outputs]


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
        passed = [symbol for value in given.values.values() for symbol in _entries(value)]
        standing, remarks = beside(function, called.standing, passed)
        outputs = trace(function, given.values, standing)
        _bounded_outputs(outputs, title)
        if called.steps and len(_all(outputs)) == size:
            stepping = trace(function, given.values, {**standing, **called.steps})
            if {entry.subs(STEP, 0) for entry in _all(stepping)} == {*scene.q, *scene.u}:
                outputs, standing = stepping, {**standing, **called.steps}
        doubt = doubt_when_repeated(function, given.values, outputs, standing)
        doubt = doubt or doubt_when_called(function, given.values, outputs, standing)
        notes = (*outputs.notes, *remarks)
        # A list of rates has the order of its state, whatever its entries are called.
        placed = _is_said(given) and 0 < len(given.state) == len(_all(outputs))
        names_of = outputs.names or (() if placed else called.returned)
        outputs = replace(outputs, notes=notes, doubt=doubt, names=names_of)
        return with_unwrapped_angles(scene, outputs)

    sizes = dict.fromkeys(called.wanted)
    found = _read(
        scene, title, called.wanted, sizes, run, names, about, called.apart, text or called.text,
        called.standing.values(),
    )  # fmt: skip
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
            for k, group in enumerate(_entries(given.values[name]) for name in wanted)
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
    return _read(scene, function.name(), wanted, sizes, run, names, about, apart, text)


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
            sizes = {name: len(_entries(given.values[name])) for name in wanted}
            outputs = _c_outputs(call.source(sizes), origin, wanted, given, call.size)
            notes = (*outputs.notes, *written.notes, *taken, *passed.notes)
            return replace(outputs, names=call.outputs, notes=notes)

        apart = {**in_c(without_comments(text)), **written.apart}
        found = _read(scene, call.name, wanted, call.inputs, run, names, about, apart, whole)
        return found.rounded(written.rounded)
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
    entries = [_entries(given.values[name]) for name in wanted]
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


def _read(
    scene: Scene, title: str, wanted: Sequence[str], sizes: Mapping[str, int | None], run: Run,
    names: Mapping[str, str] | None, about: str | None,
    apart: Mapping[str, Apart] | None = None, text: str = "", standing: Iterable[Expr] = (),
) -> Reading:  # fmt: skip
    apart = {n: a for n, a in (apart or {}).items() if n in wanted}
    given = {n: m for n, m in (names or {}).items() if m not in WORDS}
    naming = Naming(Vocabulary(scene))
    for name, known in apart.items():
        if known.vector and not named_entries(naming, name, known):
            for place, entry in enumerate(state_order(text, name, naming)):
                known.places[place] = {entry}
    for name in wanted:  # a vector that the code uses as a whole
        if not (name in given or name in apart or naming.knows(name) or sizes.get(name) == 1):
            given |= {name: " ".join(order)} if (order := state_order(text, name, naming)) else {}
    sizes = {n: sizes.get(n) or (apart[n].size if n in apart else None) for n in wanted}
    parted = {n for n, known in apart.items() if known.vector}
    parted |= vectors_of_motion(naming, [n for n in wanted if sizes[n] is None])
    scalars = [n for n in wanted if n not in given and sizes[n] in (None, 1) and n not in parted]
    open_names = [Name(0, n) for n in scalars if n not in STEPS]
    # A number of the code that stands for a parameter leaves it to no other name.
    open_names += [Name(0, str(s)) for e in standing for s in sorted(e.free_symbols, key=str)]
    stepped = at_one_step(naming, scalars)
    naming = replace(naming, guessed=stepped)
    naming = replace(naming, guessed=(*stepped, *guess(naming, open_names, ())))
    first: Arguments | None = None
    try:
        arguments = first = arguments_of(naming, wanted, sizes, given, apart=apart)
        outputs = run(arguments)
    except InputError as error:
        said = first is not None and _is_said(first)
        arranged = None if said else _arranged(naming, wanted, sizes, given, apart, run)
        if arranged is None:
            raise error from None
        arguments, outputs = arranged
    else:
        holds = arguments.state and not _is_said(arguments)
        if holds and not _fits(scene, outputs, arguments.state):
            arranged = _arranged(naming, wanted, sizes, given, apart, run, arguments)
            arguments, outputs = arranged or (arguments, outputs)
    state = arguments.state or state_of_scalars(scene, outputs.values, arguments.values.values())
    passed = [entry for value in arguments.values.values() for entry in _entries(value)]
    if about is None and len(_all(outputs)) == 1:
        refuse_energy_of_a_part(scene, title)
    otherwise = another_quantity_word(scene, title) if about is None else ""
    unknown = unknown_qualifiers(scene, title) if about is None else ()
    about = about or named_by_title(title, len(_all(outputs)), len(scene.u))
    passed += [STEP] if any(entry.has(STEP) for entry in _all(outputs)) else []
    by_order = about is None or about in QUANTITIES  # else it names them in the code's order
    places = places_of_vectors(scene, arguments) if by_order and not state else ()
    outputs = in_order_of(outputs, places) if places else outputs
    named, letter = named_numbers(naming, outputs, about, title, passed)
    found = named or claims(naming, outputs, state, about, title, passed)
    naming = replace(naming, guessed=(*naming.guessed, *_renamed(naming, arguments.matches)))
    others = [] if places or named else taken_otherwise(naming, outputs, found, about, title)
    if (
        letter is None
        and arguments.state
        and not _is_said(arguments)
        and len(_all(outputs)) < len(arguments.state)
    ):
        for words, ordered in _in_other_orders(naming, wanted, sizes, given, apart, run, arguments):
            try:
                other, _ = named_numbers(naming, ordered[1], about, title, passed)
                other = other or claims(naming, ordered[1], ordered[0].state, about, title, passed)
            except InputError:
                continue
            others += [(words, other)] if len(other) == len(found) else []
    unsure = _unsure(scene, outputs, passed, about, title, found)
    if others and unknown_words(scene, outputs.names):
        others = []
        unsure += (f"{', '.join(outputs.names)} are in another order: say what {title} returns",)
    parts = about is None and bool(manipulator(scene, outputs))
    mass = ("mass matrix", MassMatrix(), (outputs.values[0],)) if parts else None
    statements = tuple(
        statement(
            claim,
            title,
            outputs,
            naming,
            [(words, other[k]) for words, other in others],
            unsure,
            mass,
            letter,
        )
        for k, claim in enumerate(found)
    )
    comments = comments_of(text)
    meanings = [sides[0] for _, _, sides in found]
    doubt = _doubt_of_words(naming, outputs.names, meanings, title, comments) or (
        f"the name {title} says {otherwise!r}: say what it returns, --about (about=)"
        if otherwise else ""
    )  # fmt: skip
    statements = tuple(replace(s, doubt=s.doubt or doubt, comments=comments) for s in statements)
    quoted = tuple(f"the word {word} in the name {title}" for word in unknown)
    return Reading(statements, arguments.matches, (), quoted)


def _doubt_of_words(
    naming: Naming, names: Sequence[str], meanings: Sequence[object], title: str, comments: str
) -> str:
    """How the name of a function, or a comment, lists its outputs otherwise; empty if neither."""
    taken = ", ".join(map(str, meanings))
    ways = ((title.replace("_", ", "), f"the name {title}"), (comments, "a comment"))
    for text, what in ways:
        if listed := listed_otherwise(naming, names, meanings, text):
            said = "" if what.endswith(title) else f" {listed!r}"
            return (
                f"{what} says{said} another order than that in which {title} returns {taken}:"
                " say which, --about (about=)"
            )
    return ""


def _in_other_orders(
    naming: Naming, wanted: Sequence[str], sizes: Mapping[str, int | None],
    given: Mapping[str, str], apart: Mapping[str, Apart], run: Run, guess: Arguments,
) -> Iterator[tuple[str, tuple[Arguments, Outputs]]]:  # fmt: skip
    """What code returns where its state has another usual order than the one that was guessed."""
    name = next(n for n in wanted if tuple(_entries(guess.values[n])) == tuple(guess.state))
    for order in _orders(naming.vocabulary.scene):
        meaning = " ".join(map(str, order))
        if {*order} != {*guess.state} or order == tuple(guess.state):
            continue
        if contradicted(naming, apart, name, order):
            continue
        try:
            meant = arguments_of(naming, wanted, sizes, {**given, name: meaning}, apart=apart)
            yield f"{name} is {meaning}: --name '{name}={meaning}' gives it", (meant, run(meant))
        except InputError:
            continue


def _unsure(
    scene: Scene, outputs: Outputs, passed: Sequence[Expr], about: str | None, title: str,
    found: Sequence[Claim],
) -> tuple[str, ...]:  # fmt: skip
    """Under what else outputs may be right that are taken for accelerations."""
    if about is None and manipulator(scene, outputs):
        if is_settled(scene):
            return ()
        return (f"the parts that {title} returns are put together otherwise than M u' + C + G",)
    moving = {*scene.u, *scene.ud, *scene.input_symbols, *momentum_symbols(scene)}
    if about or [sides[0] for _, _, sides in found] != [*scene.ud]:
        return ()
    if len(scene.u) > 1 and not {*passed} & moving:
        return (f"{title}, which takes neither speeds nor inputs, returns no accelerations",)
    name = title if len(scene.u) > 1 else spoken(title).rpartition(" ")[2]
    return (f"{title} returns a part of the forces",) if PART.search(name) else ()


def _is_said(arguments: Arguments) -> bool:
    """Whether somebody says what the entries of the state are."""
    words = " ".join(map(str, arguments.state))
    return any(m.meaning == words and m.why in SAID for m in arguments.matches)


def _fits(scene: Scene, outputs: Outputs, state: Sequence[Expr]) -> bool:
    """Whether rates of coordinates are where the state has them, and sines those of angles."""
    entries = _all(outputs)
    if any(entry.has(STEP) for entry in entries):
        entries = [entry.diff(STEP).subs(STEP, 0) for entry in entries]
    pairs = zip(state, entries, strict=False)
    if any(rate and symbol in scene.input_symbols for symbol, rate in pairs):
        return False
    waves = set().union(*(entry.atoms(cos, sin) for entry in entries))
    used = set().union(*(wave.free_symbols for wave in waves)) & set(scene.q)
    return in_order(scene, [Matrix(entries)], state) and (not used or used <= angular(scene))


def _arranged(
    naming: Naming, wanted: Sequence[str], sizes: Mapping[str, int | None],
    given: Mapping[str, str], apart: Mapping[str, Apart], run: Run,
    guess: Arguments | None = None,
) -> tuple[Arguments, Outputs] | None:  # fmt: skip
    """The arguments where a vector is a state of the one order that its rates and sines show.

    Raises
    ------
    InputError
        For several that they show.
    """
    scene = naming.vocabulary.scene
    shown: list[tuple[Arguments, Outputs]] = []
    for name in wanted:
        known = apart.get(name)
        is_state = known is not None and (known.vector or (known.size or 0) > 1)
        if guess is not None:
            is_state = not isinstance(guess.values[name], Expr) and (
                tuple(guess.values[name]) == guess.state
            )
        if not is_state or name in given:
            continue
        for order in _orders(scene):
            meant = {**given, name: " ".join(map(str, order))}
            if sizes[name] not in (None, len(order)) or contradicted(naming, apart, name, order):
                continue
            try:
                arguments = arguments_of(naming, wanted, sizes, meant, apart=apart)
                outputs = run(arguments)
            except InputError:
                continue
            count = sum(len(value) for value in outputs.values)
            if count == len(order) and _fits(scene, outputs, order):
                shown.append((arguments, outputs))
                if [s for s in order if s in scene.q] == [*scene.q]:
                    return shown[-1]
    return shown[0] if len(shown) == 1 else None


def _orders(scene: Scene) -> Iterator[tuple[Expr, ...]]:
    """Usual orders of a state: in blocks, in pairs, speeds first, of angles elsewhere.

    Then without a coordinate that nothing may depend upon, and with inputs that are held; of one
    coordinate alone.
    """
    turning = angular(scene)
    if len(scene.q) != len(scene.u):
        yield (*scene.q, *scene.u)
        return
    speeds = dict(zip(scene.q, scene.u, strict=True))
    kinds = [tuple(q in turning for q in scene.q)]
    if len(scene.q) <= MOST_ORDERED:
        kinds += sorted({*permutations(kinds[0])} - {*kinds})
    whole: dict[tuple[Expr, ...], None] = {}
    for kind in kinds:
        of_kind = {one: iter([q for q in scene.q if (q in turning) is one]) for one in kind}
        q = [next(of_kind[one]) for one in kind]
        u = [speeds[one] for one in q]
        pairs = tuple(symbol for pair in zip(q, u, strict=True) for symbol in pair)
        whole |= dict.fromkeys(((*q, *u), pairs, (*u, *q)))
    yield from whole
    for gone in scene.q if len(scene.q) > 1 else ():
        kept = [q for q in scene.q if q != gone]
        yield (*kept, *(speeds[q] for q in (*kept, gone)))
        if scene.input_symbols:
            yield (*kept, *(speeds[q] for q in kept), *scene.input_symbols)
    if scene.input_symbols:
        yield from ((*order, *scene.input_symbols) for order in whole)
    if len(scene.q) > 1:
        yield from speeds.items()


def _renamed(naming: Naming, matches: Iterable[Match]) -> list[Match]:
    """Arguments that are one thing of the scene, under another name: formulas are told with it."""
    return [m for m in matches if m.name != m.meaning and naming.vocabulary.target(m.meaning)]


def _bounded_outputs(outputs: Outputs, title: str) -> None:
    """Refuse formulas that, written out, are larger than can be looked at.

    Raises
    ------
    InputError
    """
    sizes: dict[Expr, int] = {}
    todo = _all(outputs)
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


def _all(outputs: Outputs) -> list[Expr]:
    return [entry for value in outputs.values for entry in value]


def _entries(value: Any) -> list[Expr]:
    return [value] if isinstance(value, Expr) else list(value)
