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

from mechanics.claims.code.integrators import INTEGRATORS, STEP
from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.intermediate_form import Term
from mechanics.claims.code.interpreter import (
    TURNS,
    execute,
    find_vectors,
    forget,
    read_name,
    value_of,
)
from mechanics.claims.code.interpreter_values import (
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
from mechanics.claims.code.judged_arguments import (
    fits_word,
    is_another,
)
from mechanics.claims.code.run import (
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

MOST_TRIED = 60
"""Places that may hold what the function does not ask for."""


def is_step(run: Run, block: Term, env: dict[str, Any], counter: str = "",
    function: FileFunction | None = None,
) -> bool:  # fmt: skip
    """Whether a block advances a state as an integrator does, with the judged function.

    Parameters
    ----------
    block : Term
    env : dict of str to value
        What is known before.
    counter : str
        What the loop counts with.
    function : FileFunction, optional
        Whose body it is.
    """
    if not any(judged.gives for judged in run.judged.values()):
        return False
    sets = _sets(block)
    kept = [one for one in run.memory.before if root_of(one.parts[0]) in sets]
    return _is_advanced(run, block, env, counter, function, []) or bool(
        kept and _is_advanced(run, block, env, counter, function, kept)
    )


def _sets(block: Term) -> set[str]:
    return {root_of(t) for one in block.all() if one.kind == "set"
            for t in targets_of(one.parts[0])}  # fmt: skip


def _known_before(
    run: Run, block: Term, env: Mapping[str, Any], counter: str, function: FileFunction | None
) -> dict[str, Any]:
    """What is known before a block, without what it changes; the rest is random then."""
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
    for one in block.all():
        apart = {*run.own, *run.language.shows, *run.judged}
        if one.kind == "entry" or (
            one.kind == "call" and run.language.brackets and one.name not in apart
        ):
            for place in one.parts[1:] if one.kind == "entry" else one.parts:
                run.memory.places |= {n.name for n in place.all() if n.kind == "name"}
    return inside


def _copied(value: Any) -> Any:
    """An array of its own, which a step may change."""
    return replace(value, entries=dict(value.entries)) if isinstance(value, Table) else value


def _is_advanced(
    run: Run, block: Term, env: dict[str, Any], counter: str, function: FileFunction | None,
    kept: Sequence[Term],
) -> bool:  # fmt: skip
    """Whether a block is a step that leaves true what some lines before it say: a = f(y)."""
    inside = _known_before(run, block, env, counter, function)
    run.memory.stepping, run.memory.depth = True, int(function is not None)
    try:
        for one in kept:
            execute(run, one, inside)
        result = execute(run, block, inside)
        if any(value_of(run, one.parts[1], inside) != inside[one.parts[0].name] for one in kept):
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
    calls = [one for one in block.all() if one.kind == "call" and one.name in run.judged]
    if any(is_another(run, call, sets | {*STEPS}) for call in calls):
        return False
    for places in _located(run, inside):
        if _advances(run, places, inside, result):
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


def _advances(run: Run, places: Mapping[str, Place], env: dict[str, Any], result: Any) -> bool:
    begun = {place: value for value, place in run.memory.initial.items()}
    if not all(place in begun for place in places.values()):
        return False
    start = {word: begun[place] for word, place in places.items()}
    after: dict[str, Any] = {}
    for word, place in places.items():
        after[word] = _now(_later(place), env)
    if not _time_passes(run, env):
        return False
    lasting = [h for h in run.memory.scalars if _lasts(run, h, env)]
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


def _time_passes(run: Run, env: Mapping[str, Any]) -> bool:
    """Whether the time of a call goes on by the step, or by what nothing tells."""
    begun = run.memory.called[0].get(MOMENT)
    place = run.memory.initial.get(begun) if begun is not None else None
    after = _now(_later(place), env) if place is not None else None
    if begun is not None and is_driven(run):
        if place is None and is_fixed(begun):
            return False
        if place is not None and after is not None and not isinstance(after, Fraction):
            return False  # t % 1 may be any time; the next entry of a grid is None
    if begun is None or not isinstance(after, Fraction) or after == begun:
        return True
    shares = [(after - begun) / h for h in run.memory.scalars if h > 0 and h != begun]
    return 1 in shares or all(abs(s) > TURNS or s.denominator > TURNS for s in shares)


def is_fixed(time: Fraction) -> bool:
    """Whether a time is a number that was written: neither random nor made of a loop's counter."""
    return abs(time) <= TURNS and time.denominator <= TURNS


def _later(place: Place) -> Place:
    """The same place, a step of time later."""
    root, key = place
    return root, tuple(k + 1 if isinstance(k, int) and k >= FAR else k for k in key)
