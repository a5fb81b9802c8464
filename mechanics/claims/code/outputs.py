"""What the outputs of code claim.

as many as speeds            the accelerations               u'_k = output k
as many as entries of state  the rate of the state           q' = output, u' = output
... and a step among the arguments    the next state         by which integrator is found out
with u' among the arguments  what drives each speed           inverse dynamics
... and the inputs, too      residuals                       0 = output k
... with some of u', others by name    these                 u'_k = output k
a square matrix              the mass matrix                 with a vector beside it: M u' = f
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, product

from sympy import Expr, Matrix, S, Symbol
from sympy.matrices import MatrixBase

from mechanics.claims.about import QUANTITIES, named_quantity
from mechanics.claims.code.energy_names import MASSES, named_by_title
from mechanics.claims.code.function_names import TITLE, function_name
from mechanics.claims.code.integrators import INTEGRATORS, STEP, step_of
from mechanics.claims.code.output_names import coordinates_of, orders_by_names
from mechanics.claims.code.trace.assignments import written_of
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.claims.demands import Demands
from mechanics.claims.guess import is_short_for
from mechanics.claims.kind import kind_of
from mechanics.claims.names import Naming
from mechanics.claims.spelled_rates import bases
from mechanics.claims.statement import Letter, Statement
from mechanics.errors import InputError
from mechanics.scene import Scene
from mechanics.scene.loads import Force, Gravity, Torque
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.published import Published, Quantity, published
from mechanics.scene.quantities import EquationOfMotion, GeneralizedForce, Identity, MassMatrix
from mechanics.scene.rates import rate_table
from mechanics.scene.symbols import DOTS

Claim = tuple[str, Quantity, tuple[Expr | Matrix, ...]]

ACC = re.compile(r"_?[aA]cc$")
"""Ends the name of an acceleration; in a text such a name is one of the author's own."""

CAMEL = re.compile(r"D[dD]ot$")

BEFORE = re.compile(r"a_?(\w+)")
"""Begins one: atheta, a_x."""

LETTERS = frozenset("TVUKLHE")
"""Of energies, and of nothing that moves."""
MANIPULATOR = ("mhd", "cvh", "gn")
"""How the names of M, C and G begin, in small letters."""

MOST_ORDERED = 3
"""Outputs whose orders are tried."""


def claims(
    naming: Naming,
    outputs: Outputs,
    state: Sequence[Expr],
    about: str | None,
    title: str,
    passed: Collection[Expr] = (),
) -> list[Claim]:
    """Rows of the ledger for outputs.

    `state` are the entries of a state vector, if there is one; `passed` all that is an argument.

    Raises
    ------
    InputError
        When the number of outputs fits nothing, or one has the name of another thing.
    """
    if about is not None:
        return _asked(naming, outputs.values, about)
    found = _unasked(naming, outputs, state, title, passed)
    alone = sum(map(len, outputs.values)) == 1
    _agree(naming, outputs.names or ((title,) if alone else ()), found, title)
    return found


def _agree(naming: Naming, names: Sequence[str], found: Sequence[Claim], title: str) -> None:
    """Refuse what the code calls an acceleration, a rate, an energy or a reaction, and is taken for
    another.

    ``{"theta_ddot": a, "other": b}`` of a scene with x and theta, where a would be taken for x''.
    """
    scene = naming.vocabulary.scene
    of_rates = {rate: s for s, rate in rate_table(scene).items()}
    meant = {n: naming.symbol(*known) if (known := naming.lookup(n)) else None for n in names}
    pairs = [(n, sides[0]) for n, (_, _, sides) in zip(names, found, strict=False)]
    if len(names) != len(found) or any(rate not in [*of_rates] for _, rate in pairs):
        return
    _agree_in_order(scene, pairs, of_rates, title)
    own = [(meant[name], rate) for name, rate in pairs if meant[name] is not None]
    said = any(meant[name] is None and any(bases(name)) for name in names)  # wdot
    states = all(symbol == of_rates[rate] for symbol, rate in own)
    if len(names) > 1 and own and states and not said:
        return  # by what they are the rates of
    moving = {*scene.q, *of_rates, *scene.input_symbols}
    others = {*LETTERS, *(one.name for one in scene.reactions)}
    for name, rate in pairs:
        other = named_by_title(name, 1, 0) or name.removesuffix("_") in others
        if other or (meant[name] in moving and meant[name] != rate):
            calls = "" if name == title else f" calls an output {name} and"
            raise InputError(
                f"{title}{calls} would be taken to return {rate}: say what it is:"
                f" {_choices(naming)}"
            )


def _agree_in_order(
    scene: Scene, pairs: Sequence[tuple[str, Expr]], of_rates: Mapping[Expr, Symbol], title: str
) -> None:
    """Refuse outputs whose names say that they are of other coordinates: dv, dtheta for x', v'."""
    if scene.speeds or len(scene.q) != len(scene.u):
        return
    of = {**dict(zip(scene.u, scene.q, strict=True)), **{q: q for q in scene.q}}
    hints = coordinates_of(scene, [name for name, _ in pairs])
    for (name, rate), hint in zip(pairs, hints, strict=True):
        if of[of_rates[rate]] not in hint:
            raise InputError(
                f"{title} calls an output {name} and would be taken to return {rate} there: say"
                " what each output is, by its name or by --about (about=)"
            )


def _unasked(
    naming: Naming, outputs: Outputs, state: Sequence[Expr], title: str, passed: Collection[Expr]
) -> list[Claim]:
    """What outputs claim of which nobody says what they are."""
    scene, values = naming.vocabulary.scene, outputs.values
    size = len(scene.u)
    if len(values) == 2 and values[0].shape == (size, size) and len(values[1]) == size > 1:
        ud = Matrix(scene.ud)
        rows = zip(values[0] * ud, values[1], strict=True)
        return [
            (f"row {i}", EquationOfMotion(), (left, right))
            for i, (left, right) in enumerate(rows, 1)
        ]
    if parts := manipulator(scene, outputs):
        return [
            (f"drive of {u}", GeneralizedForce(u.name), (entry,))
            for u, entry in zip(scene.u, parts, strict=True)
        ]
    if len(values) == 1 and values[0].shape == (size, size) and size > 1:
        return [("mass matrix", MassMatrix(), (values[0],))]
    moved = {*scene.u, *scene.ud, *scene.input_symbols, *momentum_symbols(scene)}
    speedless = bool(passed) and not moved & {*passed}
    if len(values) == 1 and len(values[0]) == size**2 > 1 and speedless:
        # Without speeds it returns no rates of the state, however many numbers these are.
        if [name.lower() in MASSES for name in outputs.names] == [True]:
            return [("mass matrix", MassMatrix(), (values[0].reshape(size, size),))]
        raise InputError(
            f"{title} takes no speeds and returns {size**2} numbers: say what it is:"
            f" {_choices(naming)}"
        )
    entries = [entry for value in values for entry in value]
    held = set().union(*(entry.free_symbols for entry in entries))
    if {*passed, *held} & set(scene.ud):
        _refuse_rates(scene, entries, title)
        if some := _of_other_accelerations(naming, outputs, title, passed):
            return [_rate_of(scene, u, value) for u, value in zip(some, entries, strict=True)]
        driven = _driven(naming, outputs, title, passed)
        # Rates of coordinates are speeds by name: f(t, y, yp) says that again, in as many rows.
        kinematic = len(entries) == 2 * size == 2 * sum(bool(e.is_zero) for e in entries)
        drives = ("", "torque", "force") if driven else ("",)
        if nouns := [n for n in outputs.names if function_name(n).word not in drives]:
            raise InputError(
                f"{title} calls outputs {', '.join(nouns)} and would be taken to return"
                f" {'what drives it' if driven else 'residuals'}: say what they are:"
                f" {_choices(naming)}"
            )
        return (
            driven
            if driven
            else [
                (f"residual {i}", EquationOfMotion(), (entry, S.Zero))
                for i, entry in enumerate(entries, 1)
                if not (kinematic and entry.is_zero)
            ]
        )
    momenta = [p for p in momentum_symbols(scene) if p in passed]
    if momenta and len(entries) == len(scene.q) + len(momenta):
        return _canonical(scene, [*scene.q, *momenta], entries)
    if named := _named_accelerations(naming, outputs, title, len(entries)):
        return [_rate_of(scene, u, value) for u, value in zip(named, entries, strict=True)]
    moving = (*scene.q, *scene.u)
    part = len(state) == size > 1 and {*state} & {*scene.q} and {*state} & {*scene.u}
    if part and in_order(scene, [Matrix(entries)], state) and len(entries) == size:
        return [
            _rate_of(scene, symbol, value) for symbol, value in zip(state, entries, strict=True)
        ]
    if len(entries) == size:
        bare = next((entry for entry in entries if size > 1 and entry in moving), None)
        if bare is not None:
            raise InputError(
                f"{title} returns {bare} as it is, which is no acceleration: say what it is:"
                f" {_choices(naming)}"
            )
        order = next(_orders(naming, outputs.names, size), tuple(scene.u))
        return [_rate_of(scene, u, value) for u, value in zip(order, entries, strict=True)]
    state, entries = _without_held(scene, state, entries)
    both = _rates(naming, outputs.names) or tuple(state) or (*scene.q, *scene.u)
    if len(entries) == len(both) and STEP in passed:
        return _stepped(naming, both, entries, title, passed)
    if len(entries) == len(both):
        rates = _of_a_number(scene, both, entries, title) or entries
        return [_rate_of(scene, symbol, value) for symbol, value in zip(both, rates, strict=True)]
    raise InputError(
        f"{title} returns {len(entries)} numbers: {scene.name} has {size} accelerations and"
        f" {len(both)} rates of the state: say what it is: {_choices(naming)}"
    )


def in_order_of(outputs: Outputs, places: Sequence[int]) -> Outputs:
    """Outputs of code whose vectors hold the coordinates in another order, in the scene's.

    Columns, rates of a state, square matrices, and one number for each coordinate.

    Parameters
    ----------
    outputs : Outputs
    places : sequence of int
        Of each coordinate of a vector in the scene.
    """
    size = len(places)
    order = sorted(range(size), key=places.__getitem__)
    both = [*order, *(size + k for k in order)]
    if len(outputs.values) in (size, 2 * size) and all(len(v) == 1 for v in outputs.values):
        chosen = order if len(outputs.values) == size else both
        values = tuple(outputs.values[k] for k in chosen)
    else:
        values = tuple(_in_order(value, order, both) for value in outputs.values)
    names = {len(some): some for some in (order, both)}.get(len(outputs.names), [])
    named = tuple(outputs.names[k] for k in names) if names else outputs.names
    return replace(outputs, values=values, names=named)


def _in_order(value: Matrix, order: Sequence[int], both: Sequence[int]) -> Matrix:
    if value.shape == (len(order), len(order)):
        return value.extract(list(order), list(order))
    for chosen in (order, both):
        if value.shape == (len(chosen), 1):
            return value.extract(list(chosen), [0])
    return value


def _canonical(scene: Scene, state: Sequence[Expr], entries: Sequence[Expr]) -> list[Claim]:
    """The rates of coordinates and momenta, in this order."""
    found: list[Claim] = []
    for symbol, value in zip(state, entries, strict=True):
        rate = Symbol(f"{symbol}{DOTS[1]}", real=True)
        quantity, sides, _ = kind_of(scene, (rate, value))
        found.append((str(rate), quantity, sides))
    return found


def _without_held(
    scene: Scene, state: Sequence[Expr], entries: list[Expr]
) -> tuple[list[Expr], list[Expr]]:
    """The state and its rates without what is appended to it and held: an input, a parameter."""
    moving = [symbol in (*scene.q, *scene.u) for symbol in state]
    held = [e for e, moves in zip(entries, moving, strict=False) if not moves]
    if len(entries) == len(state) and not any(held):
        entries = [entry for entry, moves in zip(entries, moving, strict=True) if moves]
    return [symbol for symbol, moves in zip(state, moving, strict=True) if moves], entries


def _residuals(sides: Sequence[Expr]) -> list[Claim]:
    return [
        (f"residual {i}", EquationOfMotion(), (side, S.Zero)) for i, side in enumerate(sides, 1)
    ]


def taken_otherwise(
    naming: Naming, outputs: Outputs, found: Sequence[Claim], about: str | None, title: str
) -> list[tuple[str, list[Claim]]]:
    """Other things that outputs may be, in words, each with its claims in the order of the outputs.

    Accelerations without names in other orders; as residuals what is taken for the inputs by their
    number, and, of a scene without inputs, for what drives the speeds.
    """
    scene = naming.vocabulary.scene
    if about is None and [sides[0] for _, _, sides in found] == [*scene.input_symbols]:
        words = f"{title} returns a residual: say so, about 'equation of motion'"
        return [(words, _residuals([sides[1] for _, _, sides in found]))]
    if about is not None or not 0 < len(found) == len(scene.u) <= MOST_ORDERED:
        return []
    if manipulator(scene, outputs):
        return _otherwise_together(scene, outputs, title)
    if all(isinstance(quantity, GeneralizedForce) for _, quantity, _ in found):
        words = f"{title} returns residuals: say so, about 'equation of motion'"
        return [] if scene.inputs else [(words, _residuals([sides[0] for _, _, sides in found]))]
    if {tag for tag, _, _ in found} != {str(ud) for ud in scene.ud}:
        return []
    if _named_accelerations(naming, outputs, title, len(found)):
        return []
    every = []
    for order in islice(_orders(naming, outputs.names, len(found)), 1, None):
        pairs = zip(order, found, strict=True)
        claimed = [_rate_of(scene, u, sides[1]) for u, (_, _, sides) in pairs]
        names = " ".join(tag for tag, _, _ in claimed)
        every.append((f"{title} returns {names}: say so, about {names!r}", claimed))
    return every


def _orders(naming: Naming, names: Sequence[str], size: int) -> Iterator[tuple[Expr, ...]]:
    """The orders of speeds that the names of outputs leave; the scene's, where they say nothing."""
    scene = naming.vocabulary.scene
    if scene.speeds or len(scene.q) != size:
        yield tuple(scene.u)
        return
    rates = {rate: u for u, rate in rate_table(scene).items()}
    of = dict(zip(scene.u, scene.q, strict=True))
    own = [rates[naming.symbol(*found)] if (found := _second(naming, n)) else None for n in names]
    known = [None if u is None else of[u] for u in own]
    speeds = {q: u for u, q in of.items()}
    for order in orders_by_names(scene, names, known):
        yield tuple(speeds[q] for q in order)


def _stepped(
    naming: Naming, state: Sequence[Expr], entries: Sequence[Expr], title: str,
    passed: Collection[Expr],
) -> list[Claim]:  # fmt: skip
    """The rates with which code steps, and the integrator that it is."""
    scene = naming.vocabulary.scene
    step = step_of(scene, state, entries, passed)
    if step is None:
        raise InputError(
            f"{title} has {STEP} among its arguments and returns {len(entries)} numbers, but these"
            f" are no state after a step: at {STEP} = 0 they are not the state that it is given"
        )
    known = [_rate_of(scene, symbol, value) for symbol, value in step.rates.items()]
    if not step.integrator:
        raise InputError(
            f"{title} steps by none of {', '.join(INTEGRATORS)}: pass the function that it steps"
            " with, or a BlackBox"
        )
    words = f"a step of {step.integrator}"
    return [*known, (words, Identity(), (Matrix(entries), Matrix(step.composed)))]


def manipulator(scene: Scene, outputs: Outputs) -> list[Expr]:
    """M u' + C u + G, or M u' + c + G, of code that returns M, C and G; empty for other outputs.

    Nothing says that they are put together so: what fails is no mistake of theirs.
    """
    size, shapes = len(scene.u), [value.shape for value in outputs.values]
    square, column = (size, size), (size, 1)
    if size < 2 or shapes not in ([square, column, column], [square, square, column]):
        return []
    names = zip(MANIPULATOR, outputs.names, strict=False)
    if len(outputs.names) != 3 or not all(name.lower()[:1] in letters for letters, name in names):
        return []
    if "inv" in outputs.names[0].lower():
        return []  # an inverse is no mass matrix
    mass, turning, field = outputs.values
    turning = turning if turning.shape == column else turning * Matrix(scene.u)
    return list(mass * Matrix(scene.ud) + turning + field)


def is_settled(scene: Scene) -> bool:
    """Whether signs are all that is open of how M, C and G are put together.

    Beside gravity inputs alone drive: what the author adds elsewhere may be no friction. Of one
    input a column may be what it is multiplied with, G u.
    """
    return (
        len(scene.inputs) != 1
        and not scene.constraints
        and all(isinstance(load, Gravity) or _is_input(scene, load) for load in scene.loads)
    )


def _is_input(scene: Scene, load: object) -> bool:
    """Whether a load is a force or torque of inputs alone."""
    if not isinstance(load, Force | Torque):
        return False
    entries = [entry for column, _ in load.vector.args for entry in column]
    return all(
        entry.is_zero or any(entry in (one, -one) for one in scene.inputs) for entry in entries
    )


def _otherwise_together(
    scene: Scene, outputs: Outputs, title: str
) -> list[tuple[str, list[Claim]]]:
    """The other sums of M u', C and G, in words: with other signs, and C with all of G in it."""
    mass, turning, field = outputs.values
    column = turning.shape[1] == 1
    c, turning = ("C", turning) if column else ("C u", turning * Matrix(scene.u))
    every = []
    for one, other in product((1, -1), (1, -1, 0)):
        words = f"M u' {SIGN[one]} {c}" + (f" {SIGN[other]} G" if other else "")
        rows = mass * Matrix(scene.ud) + one * turning + other * field
        if not scene.inputs:  # the rows are 0, and may be divided or exchanged
            claimed = _residuals(rows)
        elif (one, other) == (1, 1):
            continue
        else:
            claimed = [
                (f"drive of {u}", GeneralizedForce(u.name), (entry,))
                for u, entry in zip(scene.u, rows, strict=True)
            ]
        every.append((f"the parts that {title} returns are put together as {words}", claimed))
    return every


SIGN = {1: "+", -1: "-"}


def _of_a_number(
    scene: Scene, state: Sequence[Expr], entries: Sequence[Expr], title: str
) -> list[Expr] | None:
    """The rates of a step of explicit Euler whose time is a number: x + 0.02 v, v + 0.02 a.

    The coordinates tell it: what is added to each is the same number times its speed.
    """
    table = rate_table(scene)
    ratios = {
        ((value - symbol) / table[symbol]).cancel()
        for symbol, value in zip(state, entries, strict=True)
        if symbol in scene.q and table[symbol] in scene.u
    }
    step = ratios.pop() if len(ratios) == 1 else S.Zero
    if step == 1:
        raise InputError(
            f"{title} adds the rates to the state: a step of time 1 says so, dt = 1, and rates are"
            " no sum"
        )
    if not (step.is_Rational and step.is_positive):
        return None
    return [(value - symbol) / step for symbol, value in zip(state, entries, strict=True)]


def _of_other_accelerations(
    naming: Naming, outputs: Outputs, title: str, passed: Collection[Expr]
) -> list[Expr]:
    """The speeds whose rates code returns by name that takes the rates of others; or none.

    Raises
    ------
    InputError
        Without a name, where it returns as many numbers as it takes no accelerations.
    """
    scene = naming.vocabulary.scene
    table = rate_table(scene)
    count = sum(len(value) for value in outputs.values)
    named = _named_accelerations(naming, outputs, title, count)
    if named and not {table[u] for u in named} & {*passed}:
        return named
    rest = [u for u in scene.u if table[u] not in passed]
    left = [table[u] for u in rest]
    words = " ".join((title, *outputs.names)).lower()
    said = "accel" in words or any(map(ACC.search, outputs.names))
    if said and 0 < len(left) < len(scene.u) and count == len(left):
        return rest
    driven = {*scene.input_symbols} & {*passed} and "resid" not in words
    if driven and 0 < len(left) < len(scene.u) and count == len(left):
        raise InputError(
            f"{title} may return {' '.join(map(str, left))}, or what is zero: say what it is:"
            f" {_choices(naming)}"
        )
    return []


def _refuse_rates(scene: Scene, entries: Sequence[Expr], title: str) -> None:
    """Refuse rates of a state with accelerations: what was taken for these may be the action.

    No residual is a coordinate or a speed by itself.

    Raises
    ------
    InputError
    """
    if {*entries} & {*scene.q, *scene.u, *scene.qd}:
        raise InputError(
            f"{title} returns rates of a state, and an argument of it is read as"
            f" {' '.join(map(str, scene.ud))}, as its name is usual for accelerations: say what it"
            " is: --name (names=)"
        )


def _driven(naming: Naming, outputs: Outputs, title: str, passed: Collection[Expr]) -> list[Claim]:
    """What drives the speeds, tau = f(q, q', q''); nothing for residuals, f(q, q', q'', tau).

    Raises
    ------
    InputError
        Where it is neither one number for each speed nor one for each input.
    """
    scene, entries = naming.vocabulary.scene, [e for value in outputs.values for e in value]
    inputs, words = scene.input_symbols, " ".join((title, *outputs.names)).lower()
    if set(inputs) & set(passed) or "resid" in words:
        return []
    if len(entries) == len(scene.u):
        order = next(_orders(naming, outputs.names, len(entries)), tuple(scene.u))
        return [
            (f"drive of {u}", GeneralizedForce(u.name), (entry,))
            for u, entry in zip(order, entries, strict=True)
        ]
    if len(entries) == len(inputs):
        pairs = zip(inputs, entries, strict=True)
        return [(str(symbol), EquationOfMotion(), (symbol, entry)) for symbol, entry in pairs]
    if inputs:
        choices = ", ".join(map(str, inputs))
        raise InputError(
            f"{title} takes accelerations and no input, and returns {len(entries)} numbers: say"
            f" what it is: --about (about=) can be equation of motion, {choices}"
        )
    return []


def _named_accelerations(naming: Naming, outputs: Outputs, title: str, count: int) -> list[Expr]:
    """By the names of outputs, else by that of the function: ``compute_q1dd``."""
    own = _accelerations(naming, outputs.names, count) if outputs.names else []
    return own or _accelerations(naming, (TITLE.sub("", title),), count)


def _accelerations(naming: Naming, names: Sequence[str], count: int) -> list[Expr]:
    """The speeds whose rates code says that it returns; nothing unless all have such a name.

    ``double theta_ddot(...)``, ``return xdd, thdd`` and ``*xdd = ...``: in this order, not ours.
    """
    table = {rate: u for u, rate in rate_table(naming.vocabulary.scene).items()}
    found = [table.get(naming.symbol(*known)) for n in names if (known := _second(naming, n))]
    speeds = [u for u in found if u in naming.vocabulary.scene.u]
    return speeds if len(set(speeds)) == len(names) == count else []


def _rates(naming: Naming, names: Sequence[str]) -> tuple[Expr, ...]:
    """The state in the order in which code names the rates that it returns; () for other names.

    ``{"theta_ddot": ..., "theta_dot": ...}``, or by what they are the rates of:
    ``{"theta_dot": ..., "theta": ...}``
    """
    scene = naming.vocabulary.scene
    rates = {rate: s for s, rate in rate_table(scene).items()}
    found = [naming.lookup(name) for name in names]
    moving = [known for known in found if known and known[0] in naming.vocabulary.functions]
    for table in (rates, {s: s for s in (*scene.q, *scene.u)}):
        state = [table[s] for known in moving if (s := naming.symbol(*known)) in table]
        if len(state) == len(names) and set(state) == {*scene.q, *scene.u}:
            return tuple(state)
    return ()


def _second(naming: Naming, name: str) -> tuple[str, int] | None:
    """The scene's name, and no more dots, of what a name is an acceleration of."""
    found = naming.lookup(CAMEL.sub("_ddot", ACC.sub("_ddot", name)))
    if found is None and (part := BEFORE.fullmatch(name)):
        found = naming.lookup(f"{part[1]}_ddot")
    for base, order in bases(name) if found is None else ():
        longer = [q for q in map(str, naming.vocabulary.scene.q) if is_short_for(base, q)]
        if order == 2 and len(longer) == 1 and len(base.rstrip("0123456789")) > 1:
            found = longer[0], order  # thdd of theta
    if found is None or found[0] not in naming.vocabulary.functions:
        return None
    symbol = naming.symbol(found[0], found[1])
    return (found[0], found[1]) if symbol in naming.vocabulary.scene.ud else None


def _choices(naming: Naming) -> str:
    rates = [str(ud) for ud in naming.vocabulary.scene.ud]
    return f"--about (about=) can be {', '.join([*QUANTITIES, *rates])}"


def _rate_of(scene: Scene, symbol: Expr, value: Expr) -> Claim:
    rate = rate_table(scene)[symbol]
    if symbol in scene.u:
        return str(rate), EquationOfMotion(), (rate, value)
    return f"{symbol}_dot", Identity(), (rate, value)


def _asked(naming: Naming, values: Sequence[Matrix], about: str) -> list[Claim]:
    count = sum(len(value) for value in values)
    if about not in QUANTITIES:
        named = _accelerations(naming, about.replace(",", " ").split(), count)
        if not named:
            raise InputError(f"about {about!r}, for {count} outputs of code: {_choices(naming)}")
        entries = [entry for value in values for entry in value]
        scene = naming.vocabulary.scene
        return [_rate_of(scene, u, value) for u, value in zip(named, entries, strict=True)]
    quantity = named_quantity(about)
    if isinstance(quantity, MassMatrix):
        size = len(naming.vocabulary.scene.u)
        flat = [
            value.reshape(size, size) if len(value) == size * size else value for value in values
        ]
        return [("mass matrix", quantity, (value,)) for value in flat]
    found: list[Claim] = []
    for value in values:
        for entry in value:
            sides = (entry, S.Zero) if isinstance(quantity, EquationOfMotion) else (entry,)
            found.append((f"output {len(found) + 1}", quantity, sides))
    return found


def in_order(scene: Scene, values: Sequence[Matrix], state: Sequence[Expr]) -> bool:
    """Whether the rates of the coordinates are where a state of this order has them."""
    entries = [entry for value in values for entry in value]
    if len(entries) != len(state):
        return True
    table = rate_table(scene)
    pairs = zip(state, entries, strict=True)
    return all(table[s] == entry for s, entry in pairs if s in scene.q)


def state_of_scalars(
    scene: Scene, values: Sequence[Matrix], arguments: Iterable[object]
) -> tuple[Expr, ...]:
    """The state whose rates code returns that takes its entries one by one; empty for no state.

    In the order of the arguments, or x, theta, ..., x_dot, theta_dot, ..., or x, x_dot, theta,
    theta_dot, ...: the first in which the rates of the coordinates are where they belong. Code
    need not take what nothing depends on.
    """
    both = (*scene.q, *scene.u)
    given = tuple(symbol for symbol in arguments if symbol in both)
    whole = set(given) == set(both)
    if sum(map(len, values)) != len(both) or not given:
        return given if whole else ()
    mixed = tuple(symbol for pair in zip(scene.q, scene.u, strict=False) for symbol in pair)
    orders = [*([given] if whole else []), both, *([mixed] if len(mixed) == len(both) else [])]
    fitting = (order for order in orders if in_order(scene, values, order))
    return next(fitting, given if whole else ())


def statement(
    claim: Claim, title: str, outputs: Outputs, naming: Naming,
    others: Sequence[tuple[str, Claim]] = (), unsure: tuple[str, ...] = (),
    anyhow: Claim | None = None, letter: Letter | None = None,
) -> Statement:  # fmt: skip
    """A claim as a statement, with what else it may be; constants stand in its notes."""
    tag, _, sides = claim
    source = f"{title}: {tag}"
    entries = [e for side in sides for e in (side if isinstance(side, MatrixBase) else [side])]
    known = [outputs.formulas[entry] for entry in entries if entry in outputs.formulas]
    ways = {} if known else {e: written_of([f], naming) for e, f in outputs.formulas.items()}
    return Statement(
        _row(claim, title), source, tag, notes=outputs.notes, doubt=outputs.doubt,
        written=written_of(known, naming) if known else None, ways=ways,
        taken=tuple((words, _row(other, title)) for words, other in others),
        demands=_demands(entries, outputs), unsure=unsure,
        under_any_guess=anyhow and _row(anyhow, title), letter=letter,
    )  # fmt: skip


def _row(claim: Claim, title: str) -> Published:
    tag, quantity, sides = claim
    return published(tag, quantity, *sides, label=f"{title}: {tag}")


def _demands(entries: Sequence[Expr], outputs: Outputs) -> Demands:
    """What the outputs that a claim is about ask for; all of them, where it is made of several."""
    known = [outputs.demands[entry] for entry in entries if entry in outputs.demands]
    every = known or list(outputs.demands.values())
    return Demands(tuple(dict.fromkeys(d for demands in every for d in demands)), code=True)
