"""Loops and functions that advance a state by themselves, with the judged function.

    y = y + h*rate(t, y, p)         after = integrator(rates, before, h)

The block is run once, on random numbers: what it makes of a state is compared, exactly, with what
each integrator makes of it, for each number in the block that may be its step.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import islice, product
from typing import Any

from sympy import S

from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter import (
    TURNS,
    execute,
    find_vectors,
    forget,
    read_name,
    value_of,
)
from mechanics.claims.code.around.interpreter_values import (
    ROUNDED,
    FileFunction,
    Handle,
    NotFollowedError,
    Table,
    Unknown,
    rational,
    root_of,
    targets_of,
)
from mechanics.claims.code.around.judged_arguments import (
    fits_word,
    is_another,
)
from mechanics.claims.code.around.run import (
    FAR,
    MOMENT,
    TIME,
    Place,
    Run,
    begin,
    entries_of,
    is_driven,
    meaning_of,
    orders,
    rate_of,
    row_of,
)
from mechanics.claims.code.integrators import INTEGRATORS, STEP
from mechanics.claims.code.integrators import NAMES as STEPS

Elapsed = Fraction | str | None
"""Of time; `ANY` where nothing tells it, None where the time does not go on."""
ANY = "any"

MOST_TRIED = 60
"""Places that may hold what the function does not ask for."""


def is_step(run: Run, one: Term, env: dict[str, Any], function: FileFunction | None = None) -> bool:
    """Whether a loop or a function advances a state as an integrator does, by the judged one.

    Parameters
    ----------
    one : Term
        A loop, or the body of a function.
    env : dict of str to value
        What is known before.
    function : FileFunction, optional
        Whose body it is.
    """
    if not any(judged.gives for judged in run.judged.values()):
        return False
    sets = _sets(_body(one))
    kept = [line for line in run.memory.before if root_of(line.parts[0]) in sets]
    return _is_advanced(run, one, env, function, []) or bool(
        kept and _is_advanced(run, one, env, function, kept)
    )


def _body(one: Term) -> Term:
    return one.parts[1] if one.kind == "loop" else one


def _sets(block: Term) -> set[str]:
    return {root_of(t) for one in block.all() if one.kind == "set"
            for t in targets_of(one.parts[0])}  # fmt: skip


def _known_before(
    run: Run, one: Term, env: Mapping[str, Any], function: FileFunction | None
) -> dict[str, Any]:
    """What is known before a block, without what it changes; the rest is random then."""
    block, counter = _body(one), one.name if one.kind == "loop" else ""
    begin(run)
    run.memory.count += 1
    copied: dict[int, Any] = {}
    inside = {n: copied.setdefault(id(v), _copied(v)) for n, v in env.items()
              if not isinstance(v, Unknown) or v is ROUNDED}  # fmt: skip
    forget(run, block, inside)
    for name in function.takes if function is not None else ():
        if not isinstance(inside.get(name), Handle):
            inside.pop(name, None)
    run.memory.called_in = block.names()
    find_vectors(run, block, inside)
    for name in run.memory.vectors:
        if isinstance(inside.get(name), Fraction):
            del inside[name]  # another thing of the same name
    if counter:
        inside[counter] = Fraction(FAR + 7)
    for part in block.all():
        apart = {*run.own, *run.language.shows, *run.judged}
        if part.kind == "entry" or (
            part.kind == "call" and run.language.brackets and part.name not in apart
        ):
            for place in part.parts[1:] if part.kind == "entry" else part.parts:
                run.memory.places |= {n.name for n in place.all() if n.kind == "name"}
    return inside


def _copied(value: Any) -> Any:
    """An array of its own, which a step may change."""
    return replace(value, entries=dict(value.entries)) if isinstance(value, Table) else value


def _is_advanced(
    run: Run, one: Term, env: dict[str, Any], function: FileFunction | None, kept: Sequence[Term]
) -> bool:
    """Whether a block is a step that leaves true what some lines before it say: a = f(y)."""
    block, inside = _body(one), _known_before(run, one, env, function)
    run.memory.stepping, run.memory.depth = True, int(function is not None)
    try:
        for line in kept:
            execute(run, line, inside)
        result = execute(run, block, inside)
        if any(value_of(run, k.parts[1], inside) != inside[k.parts[0].name] for k in kept):
            return False
        if result is None and function is not None and function.gives:
            given = [read_name(run, n, (), inside) for n in function.gives]
            result = given[0] if len(given) == 1 else row_of(run, given)
    except (NotFollowedError, RecursionError, ZeroDivisionError):
        return False
    finally:
        run.memory.stepping, run.memory.depth = False, 0
    if run.memory.misused or not run.memory.called or _parameters_change(run, block, inside):
        return False
    sets = _sets(block)
    calls = [part for part in block.all() if part.kind == "call" and part.name in run.judged]
    if any(is_another(run, call, sets | {*STEPS}) for call in calls):
        return False
    elapsed = _elapsed(run, one, inside, function)
    for places in _located(run, inside):
        if _advances(run, places, inside, result, elapsed):
            run.memory.advanced = tuple(places.values())
            return True
    return False


def _parameters_change(run: Run, block: Term, env: Mapping[str, Any]) -> bool:
    """Whether a block leaves a parameter with another value."""
    sets = _sets(block)
    apart = {"", *run.words.state, *run.words.inputs}
    words = {root: meaning_of(run, root) for root in sets & env.keys()}
    made = {root for root in words if isinstance(env[root], Unknown)} & _made_of_state(run, block)
    return any(
        root in made or not fits_word(run, word, env[root]) for root, word in words.items()
        if word not in apart and word in run.words.parameters
    )  # fmt: skip


def _made_of_state(run: Run, block: Term) -> set[str]:
    """Names that a block makes of the state, or of what it sets."""
    asked = {value for at in run.memory.called for value in at.values()}
    moving = {root for value, (root, _) in run.memory.initial.items() if value in asked}
    moving |= _sets(block)
    lines = (
        t for t in block.all() if t.kind == "set" and not moving.isdisjoint(t.parts[1].names())
    )
    return {root_of(target) for line in lines for target in targets_of(line.parts[0])}


def _located(run: Run, env: Mapping[str, Any]) -> Iterator[dict[str, Place]]:
    """Where the entries of the state are before the block."""
    found: dict[str, Place] = {}
    missing = []
    for word in run.words.state:
        value = run.memory.called[0].get(word)
        place = run.memory.initial.get(value) if value is not None else None
        if place is None and value is not None:
            here = (p for p in run.memory.initial.values() if _now(p, env) == value)
            place = next(here, None)
        if place is None:
            missing.append(word)
        else:
            found[word] = place
    if len(missing) > 2:
        return
    begun = {place: value for value, place in run.memory.initial.items()}
    left = [p for p in begun if p not in found.values() and _now(_later(p), env) != begun[p]]
    for chosen in islice(product(left, repeat=len(missing)), MOST_TRIED):
        if len({*chosen}) == len(missing):
            yield {**found, **dict(zip(missing, chosen, strict=True))}


def _now(place: Place, env: Mapping[str, Any]) -> Any:
    """What stands at a place, by now."""
    root, key = place
    value = env.get(root)
    return value.entries.get(key) if isinstance(value, Table) and key else value


def _advances(
    run: Run, places: Mapping[str, Place], env: dict[str, Any], result: Any, elapsed: Elapsed
) -> bool:
    begun = {place: value for value, place in run.memory.initial.items()}
    if not all(place in begun for place in places.values()):
        return False
    start = {word: begun[place] for word, place in places.items()}
    after: dict[str, Any] = {}
    for word, place in places.items():
        after[word] = _now(_later(place), env)
    lasting = [h for h in run.memory.scalars if _lasts(run, h, env)]
    if elapsed is not ANY:
        lasting = [h for h in lasting if h == elapsed]
    choices = [after]
    returned = entries_of(run, result)
    if returned is not None and len(returned) == len(run.words.state):
        choices += [dict(zip(order, returned, strict=True)) for order in orders(run)]
    return any(_is_step(run, start, one, lasting) for one in choices)


def _lasts(run: Run, span: Fraction, env: Mapping[str, Any]) -> bool:
    """Whether what is a step of time is one the next time: the same, or another above zero."""
    place = run.memory.initial.get(span)
    later = _now(place, env) if place is not None else span
    return span > 0 and isinstance(later, Fraction) and later > 0


def _is_step(
    run: Run, start: Mapping[str, Fraction], after: Mapping[str, Any], lasting: Sequence[Fraction]
) -> bool:
    angles = [values[w] for values in (start, after) for w in run.words.angles]
    if not all(isinstance(v, Fraction) for v in after.values()):
        return False
    if not all(value in angles for value in run.memory.turned):
        return False
    symbols = run.words.symbols
    rates = {symbols[w]: rate_of(run, w) for w in run.words.state}
    begun = {symbols[w]: rational(start[w]) for w in run.words.state}
    rates[TIME] = S.One
    begun[TIME] = rational(run.memory.called[0].get(MOMENT, Fraction(0)))
    wanted = {symbols[w]: rational(after[w]) for w in run.words.state}
    times = {*start.values(), *(at[MOMENT] for at in run.memory.called if MOMENT in at)}
    spans = [rational(h) for h in lasting if h not in times]
    for advance in INTEGRATORS.values():
        made = advance(run.words, rates, begun)
        values = [(made[s].expand() if hasattr(made[s], "expand") else made[s], wanted[s])
                  for s in wanted]  # fmt: skip
        if any(all(one.subs(STEP, h) == other for one, other in values) for h in spans):
            return True
    return False


def _elapsed(run: Run, one: Term, env: Mapping[str, Any], function: FileFunction | None) -> Elapsed:
    """The time from a turn of a loop to the next one, by which the judged function is called.

    The block is run twice more from where it ended: what is before a loop need not be its time.
    """
    begun = run.memory.called[0].get(MOMENT)
    if begun is None or not is_driven(run):
        return ANY
    if function is not None:  # who calls it passes the time
        return None if begun not in run.memory.initial and is_fixed(begun) else ANY
    if one.kind == "loop" and _goes_through_times(run, one):
        return ANY
    inside = {name: _copied(value) for name, value in env.items()}
    times, counted = [], Fraction(FAR + 7)
    for _ in range(2):
        if one.kind == "loop" and inside.get(one.name) == counted:
            inside[one.name] = counted = counted + _stride(run, one, inside)
        times.append(_time_of_turn(run, one, inside))
    first, second = times
    if first is None or second is None:
        return None  # t % 1 may be any time
    place, later = (run.memory.initial.get(time) for time in (first, second))
    if later is not None and later[1] and later != place:  # a grid of times
        return ANY if place is None or place[0] != later[0] or _later(place) == later else None
    return second - first


def _goes_through_times(run: Run, loop: Term) -> bool:
    """Whether a loop takes the time out of a grid: for t = ts."""
    calls = (
        part for part in loop.parts[1].all() if part.kind == "call" and part.name in run.judged
    )
    given = (part for call in calls for part in call.parts)
    whole = len(loop.parts[0].parts) == 1 and run.language.name != "Python"
    return whole and any(part.kind == "name" and part.name == loop.name for part in given)


def _stride(run: Run, loop: Term, env: Mapping[str, Any]) -> Fraction:
    """By what a loop counts: for t = 0:h:9."""
    limits = loop.parts[0].parts
    stride = value_of(run, limits[1], dict(env)) if len(limits) == 3 else Fraction(1)
    if not isinstance(stride, Fraction):
        raise NotFollowedError
    return stride


def _time_of_turn(run: Run, one: Term, env: dict[str, Any]) -> Fraction | None:
    """The time at the first call of a turn, which is run in `env`."""
    before = run.memory.called, run.memory.misused, run.memory.turned, run.memory.scalars
    run.memory.called, run.memory.turned, run.memory.scalars = [], [], {*run.memory.scalars}
    try:
        execute(run, _body(one), env)
        return run.memory.called[0].get(MOMENT) if run.memory.called else None
    except (NotFollowedError, RecursionError, ZeroDivisionError):
        return None
    finally:
        run.memory.called, run.memory.misused, run.memory.turned, run.memory.scalars = before


def is_fixed(time: Fraction) -> bool:
    """Whether a time is a number that was written: neither random nor made of a loop's counter."""
    return abs(time) <= TURNS and time.denominator <= TURNS


def _later(place: Place) -> Place:
    """The same place, a step of time later."""
    root, key = place
    return root, tuple(k + 1 if isinstance(k, int) and k >= FAR else k for k in key)
