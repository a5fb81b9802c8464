"""The usual orders of a state, and which of them a function's rates and sines show.

y = (x, theta, x_dot, theta_dot)        y = (x, x_dot, theta, theta_dot)
"""

from collections.abc import Iterator, Sequence
from itertools import permutations

from sympy import Expr, Matrix, cos, sin

from mechanics.claims.code.arguments import Arguments, contradicted, entries_of, state_is_stated
from mechanics.claims.code.code_function import CodeFunction
from mechanics.claims.code.integrators import STEP
from mechanics.claims.code.outputs import MOST_ORDERED, in_order
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.claims.kinds import angular
from mechanics.errors import InputError
from mechanics.scene import Scene


def arguments_and_outputs(code: CodeFunction) -> tuple[Arguments, Outputs]:
    """What arguments are, and what code returns for them.

    Where nobody says the order of a state, and what it returns does not fit the usual one, the one
    other order that fits.

    Raises
    ------
    InputError
        When an argument is unexplained, or the code cannot be read.
    """
    arguments: Arguments | None = None
    try:
        arguments = code.arguments()
        outputs = code.run(arguments)
    except InputError as error:
        if arguments is not None and state_is_stated(arguments):
            raise
        if (fitting := _of_the_order_that_fits(code)) is None:
            raise error from None
        return fitting
    guessed = arguments.state and not state_is_stated(arguments)
    if guessed and not _fits(code.scene, outputs, arguments.state):
        return _of_the_order_that_fits(code, arguments) or (arguments, outputs)
    return arguments, outputs


def in_other_orders(
    code: CodeFunction, guess: Arguments
) -> Iterator[tuple[str, tuple[Arguments, Outputs]]]:
    """What code returns where its state has another usual order than the one that was guessed."""
    name = next(n for n in code.names if entries_of(guess.values[n]) == tuple(guess.state))
    for order in _orders(code.scene):
        meaning = " ".join(map(str, order))
        if {*order} != {*guess.state} or order == tuple(guess.state):
            continue
        if contradicted(code.naming, code.parts, name, order):
            continue
        try:
            meant = code.arguments({name: meaning})
            outputs = code.run(meant)
        except InputError:
            continue
        yield f"{name} is {meaning}: --name '{name}={meaning}' gives it", (meant, outputs)


def _fits(scene: Scene, outputs: Outputs, state: Sequence[Expr]) -> bool:
    """Whether rates of coordinates are where the state has them, and sines those of angles."""
    entries = outputs.entries
    if any(entry.has(STEP) for entry in entries):
        entries = [entry.diff(STEP).subs(STEP, 0) for entry in entries]
    pairs = zip(state, entries, strict=False)
    if any(rate and symbol in scene.input_symbols for symbol, rate in pairs):
        return False
    waves = set().union(*(entry.atoms(cos, sin) for entry in entries))
    used = set().union(*(wave.free_symbols for wave in waves)) & set(scene.q)
    return in_order(scene, [Matrix(entries)], state) and (not used or used <= angular(scene))


def _of_the_order_that_fits(
    code: CodeFunction, guess: Arguments | None = None
) -> tuple[Arguments, Outputs] | None:
    """The arguments where a vector is a state of the one order that its rates and sines show.

    None where several fit, but for the one that has the coordinates as the scene has them.
    """
    shown: list[tuple[Arguments, Outputs]] = []
    for name in code.names:
        if name in code.meanings or not _may_be_state(code, name, guess):
            continue
        for order in _orders(code.scene):
            if code.sizes[name] not in (None, len(order)):
                continue
            if contradicted(code.naming, code.parts, name, order):
                continue
            try:
                arguments = code.arguments({name: " ".join(map(str, order))})
                outputs = code.run(arguments)
            except InputError:
                continue
            if len(outputs.entries) == len(order) and _fits(code.scene, outputs, order):
                shown.append((arguments, outputs))
                if [s for s in order if s in code.scene.q] == [*code.scene.q]:
                    return shown[-1]
    return shown[0] if len(shown) == 1 else None


def _may_be_state(code: CodeFunction, name: str, guess: Arguments | None) -> bool:
    if guess is not None:
        value = guess.values[name]
        return not isinstance(value, Expr) and tuple(value) == guess.state
    known = code.parts.get(name)
    return known is not None and (known.vector or (known.size or 0) > 1)


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
