"""Lines around a judged function that use it: what is known to be innocent, and what is not.

    ode45(@(t, y) rate(t, y, p), ...)           the function itself, handed to a solver
    k = rate(t, y, p)                           a plain call, its result as it is
    y = y + h*rate(t, y, p), in a loop          a step of an integrator that is known

All else is quoted.
"""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

from mechanics.claims.code.around.handed_values import changes_handed, statements
from mechanics.claims.code.around.integrator_steps import is_fixed, is_step
from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter import (
    attempt,
    find_vectors,
    forget,
    handle_of,
    known_value,
)
from mechanics.claims.code.around.interpreter_values import (
    UNKNOWN,
    FileFunction,
    Handle,
    Literal,
    NotFollowedError,
    Table,
    Unknown,
    number,
    root_of,
    targets_of,
)
from mechanics.claims.code.around.judged_arguments import (
    accepted,
    is_possible,
)
from mechanics.claims.code.around.number_calls import KNOWN
from mechanics.claims.code.around.run import (
    FAR,
    MOMENT,
    Memory,
    Run,
    all_rates,
    begin,
    entries_of,
    functions_in,
    is_driven,
    meaning_of,
    orders,
)
from mechanics.claims.code.around.solver_options import MADE_BY_NAME, is_solver_told_more
from mechanics.claims.code.around.solver_starts import (
    SOLVERS,
    STATE_FIRST,
    changes_start,
    is_solver,
)
from mechanics.claims.code.integrators import NAMES as STEPS

TIMES = frozenset(("t", "time", "tt", "~", "_"))
UNFOLLOWED = frozenset(
    ("setfield", "assignin", "evalin", "eval", "DiscreteProblem", "inline", "str2func")
)
OTHER_VALUES = frozenset(
    ("abs", "fabs", "round", "int", "trunc", "floor", "ceil", "max", "min", "fmax", "fmin",
     "maximum", "minimum", "clip", "sign", "degrees", "radians", "deg2rad", "rad2deg", "norm",
     "flip", "flipud", "fliplr", "reverse", "sort", "reversed", "sorted")
)  # fmt: skip
"""Calls that make other values of what they are given, or another order."""
TESTS = frozenset(("assert", "assert_", "test"))
"""Calls that compare."""


def lines_of(run: Run, block: Term, env: dict[str, Any]) -> list[str]:
    """Lines of a block that are not innocent; it is run in `env`.

    Parameters
    ----------
    block : Term
    env : dict of str to value
    """
    return _lines(run, block, env, run.memory.made)


def concerns(run: Run, line: Term, env: Mapping[str, Any]) -> bool:
    """Whether a line uses the judged function, or what it returned."""
    return bool(_concerned(run, line, env, run.memory.made))


def _lines(
    run: Run, block: Term, env: dict[str, Any], made: set[str], moving: frozenset[str] = frozenset()
) -> list[str]:
    """`made` are names that hold what the function returned, `moving` those of states."""
    found: list[str] = []
    for one in block.parts if block.kind == "block" else (block,):
        if one.kind in ("block", "case"):
            for part in one.parts if one.kind == "case" else (one,):
                found += _lines(run, part, env, made, moving)
            continue
        own = one.parts[0].name if one.kind == "set" else ""
        if own in run.judged and own not in run.own:
            continue  # the function without a name that is judged
        concerned = bool(_concerned(run, one, env, made))
        if one.kind == "loop" and concerned:
            if is_step(run, one, env):
                _keep_step(run, one)
            else:
                forget(run, one, env)
                find_vectors(run, one, env)
                if one.name:
                    env[one.name] = Fraction(FAR + 7)
                body = one.parts[1]
                found += _lines(run, body, env, made, moving | _moving(run, body, env))
            forget(run, one, env, UNKNOWN)
            continue
        wrong = _resets(run, one, env) or _changes(run, one, moving)
        wrong = wrong or (one.kind == "set" and _at_one_time(run, one, env, moving))
        if concerned:
            wrong = wrong or not _innocent(run, one, env, made)
        else:
            attempt(run, one, env)
        if wrong or _is_another_number(run, one, env):
            found.append(one.text)
        if concerned:
            run.memory.before += [one] if is_result(run, one) else []
            made |= _filled(run, one)
            if one.kind == "set" and one.parts[0].kind == "list":
                run.memory.unpacked.append([root_of(t) for t in targets_of(one.parts[0])])
            if one.kind == "set" and _holds(run, one, env):
                made |= {root_of(t) for t in targets_of(one.parts[0])}
    return found


def _keep_step(run: Run, block: Term) -> None:
    run.memory.steps[id(block)] = frozenset(root for root, _ in run.memory.advanced)


def is_result(run: Run, line: Term) -> bool:
    """Whether a line gives a name what the function returns: a = accel(theta, w)."""
    return (
        line.kind == "set"
        and not line.name
        and line.parts[0].kind == "name"
        and (line.parts[1].kind == "call" and line.parts[1].name in run.judged)
    )


def function_lines(run: Run, one: FileFunction, around: Mapping[str, Any]) -> list[str]:
    """Lines of one of the other functions that are not innocent."""
    if is_step(run, one.body, dict(around), one):
        _keep_step(run, one.body)
        return []
    begin(run)
    find_vectors(run, one.body, around)
    run = _with_body(run, one)
    env = {n: v for n, v in around.items() if n not in one.takes and n not in one.local}
    found = _lines(run, one.body, env, set(), _states_around(run, one))
    return found + [line.text for line in _kept_changes(run, one)]


def _kept_changes(run: Run, one: FileFunction) -> list[Term]:
    """Lines of a function of Python that change a state in place that it is given and hands on."""
    if run.language.name != "Python":
        return []
    given = _moving(run, one.body, {}) & {*one.takes}
    lines = [line for line in statements(one.body) if line.kind == "set"]
    return [line for line in lines if root_of(line.parts[0]) in given
            and (line.name or line.parts[0].kind != "name")]  # fmt: skip


def _with_body(run: Run, one: FileFunction) -> Run:
    """What is looked at, with the lines of a function."""
    return replace(run, block=Term("block", "", (*run.block.parts, one.body)))


def _states_around(run: Run, function: FileFunction) -> frozenset[str]:
    """Names of the file that hold the state, and that a function has no own ones for."""
    declared = {root_of(t.parts[0]) for t in function.body.all()
                if t.kind == "set" and not t.text.startswith(root_of(t.parts[0]))}  # fmt: skip
    states = {n for judged in run.judged.values() for n, word in judged.around.items()
              if word in run.words.state}  # fmt: skip
    return frozenset(states - declared - {*function.takes})


def changed_numbers(
    run: Run, function: FileFunction, free: Collection[str], *, during: bool = False
) -> list[str]:
    """Lines of a function that change a number of the file which the judged one uses.

    Parameters
    ----------
    function : FileFunction
    free : collection of str
        Names that the judged function uses, and that are none of its own.
    during : bool
        Whether a solver calls it while it runs.
    """
    found = []
    for one in function.body.all():
        if one.kind == "call" and during and one.name in ("assignin", "evalin", "eval"):
            found.append(one.text)
        if one.kind != "set":
            continue
        roots = {root_of(target) for target in targets_of(one.parts[0])} & {*free}
        found += [
            one.text for word in {meaning_of(run, root) for root in roots}
            if word in run.words.parameters
            and (during or one.name or not _is_number_for(run, word, one.parts[1]))
        ]  # fmt: skip
    return found


def _is_number_for(run: Run, word: str, value: Term) -> bool:
    """Whether a value is a number that a parameter may be."""
    made = known_value(run, value, {})
    return isinstance(made, Literal) and is_possible(run, word, made)


def _moving(run: Run, body: Term, env: dict[str, Any]) -> frozenset[str]:
    """Names of states that a loop, or what it calls, advances or asks the function about."""
    found: set[str] = set()
    for one in body.all():
        if one.kind == "call" and (judged := run.judged.get(one.name)) is not None:
            state = {n for n, m in judged.meanings.items() if {*m} & {*run.words.state}}
            pairs = zip(judged.takes, one.parts, strict=False)
            found |= {root_of(part) for name, part in pairs if name in state}
        if one.kind == "call" and one.name in run.users:
            pairs = zip(run.own[one.name].takes, one.parts, strict=False)
            found |= {root_of(p) for name, p in pairs if name in run.own[one.name].shared}
        if one.kind == "set" and one.parts[1].name in run.users:
            found |= {root_of(target) for target in targets_of(one.parts[0])}
        if one.kind == "loop" and is_step(run, one, env):
            found |= {root for root, _ in run.memory.advanced}
    return frozenset(found - {""})


def _changes(run: Run, line: Term, moving: frozenset[str]) -> bool:
    """Whether a line makes a state, or a number that the function uses, into another."""
    if line.kind != "set":
        return False
    target, value = line.parts
    root = root_of(target)
    if value.kind == "call" and value.name in run.users:
        return False
    return root in moving and bool(line.name or root in value.names())


def _at_one_time(run: Run, line: Term, env: Mapping[str, Any], moving: frozenset[str]) -> bool:
    """Whether a line in a loop advances a driven system always at the same time."""
    if root_of(line.parts[0]) not in moving or not is_driven(run):
        return False
    saved = run.memory.called, run.memory.misused
    run.memory.called = []
    attempt(run, line, dict(env))
    times = [at[MOMENT] for at in run.memory.called if MOMENT in at]
    run.memory.called, run.memory.misused = saved
    return any(map(is_fixed, times))


def _resets(run: Run, line: Term, env: dict[str, Any]) -> bool:
    """Whether a line gives a solver another law, another state, or impossible numbers."""
    if line.kind == "set":
        target, value = line.parts
        if value.kind == "call" and is_solver(value.name):
            run.memory.problems |= {root_of(t) for t in targets_of(target)}
        fields = [t.name.lower() for t in target.all() if t.kind == "field"]
        if fields and (root_of(target) in run.memory.problems or "mass" in fields):
            return True
        targets = [t.name for t in targets_of(target)]
        two = value.kind == "call" and value.name.startswith("ode") and len(targets) > 1
        if two and targets[1] in TIMES - {"~", "_"} and targets[0] not in TIMES:
            return True
    if changes_start(run, line) or changes_handed(run, line):
        return True
    if any(_kicks(run, one) for one in line.all() if one.kind == "set"):
        return True
    methods = [(one, n) for one in line.all() if one.kind == "call" and run.language.pointers
               for n in run.judged if one.name.endswith(f".{n}")]  # fmt: skip
    if any(misuses(run, replace(one, name=name), env) for one, name in methods):
        return True
    return any(
        _alters(run, one, env) if one.kind == "call" else _is_impossible(run, one, env)
        for part in ([line] if line.kind == "call" else line.parts)
        for one in part.all()
    )


SOURCES = re.compile(r"read|load|input|open|get|rand|rng|uniform|normal|choice|parse|slider")
"""In names of calls whose numbers come from outside of the file."""


def _is_unread_number(run: Run, line: Term, env: dict[str, Any]) -> bool:
    """Whether a line of Python makes a parameter of numbers alone, in a way not followed here."""
    target, value = line.parts
    if run.language.name != "Python" or not _word(run, target):
        return False
    names = {one.name for one in value.all() if one.kind in ("name", "field")}
    calls = {one.name for one in value.all() if one.kind == "call"}
    if {name.rpartition(".")[2] for name in names} - {"inf", "nan", "NINF"}:
        return False
    if any(map(SOURCES.search, calls)):
        return False
    made = known_value(run, value, env)
    return bool(names) or isinstance(made, Unknown) or not calls <= KNOWN | run.own.keys()


def _is_another_number(run: Run, line: Term, env: dict[str, Any]) -> bool:
    """Whether a line makes a parameter another one, or another number than it was: g = -g."""
    if line.kind == "set" and _is_unread_number(run, line, env):
        return True
    if line.kind != "set" or (line.parts[1].kind == "call" and line.parts[1].name in run.own):
        return False
    words = {number("word", w): w for w in run.words.parameters.keys() | run.words.inputs}
    for target in targets_of(line.parts[0]):
        word, value = _word(run, target), known_value(run, target, env)
        if not word or isinstance(value, Table | Literal):
            continue
        own = line.name or word in map(partial(meaning_of, run), line.parts[1].names())
        if words.get(value, word) != word or (own and value not in words):
            return True
    return False


def _word(run: Run, one: Term) -> str:
    """Which parameter of the scene a name or a field is called."""
    word = meaning_of(run, one.name) if one.kind in ("name", "field") else ""
    return word if word in run.words.parameters else ""


def _is_another_word(run: Run, target: Term, value: Term) -> bool:
    word, other = _word(run, target), _word(run, value)
    return bool(word) and bool(other) and word != other


def _kicks(run: Run, line: Term) -> bool:
    """Whether it makes a field of an object, which holds the state, into another: a.w *= 2."""
    target, value = line.parts
    around = {judged.around.get(target.name, "") for judged in run.judged.values()}
    state = target.kind == "field" and not around.isdisjoint(run.words.state)
    return state and bool(line.name or target.name in value.names())


def misuses(run: Run, call: Term, env: dict[str, Any]) -> bool:
    """Whether a call of the judged function has other arguments than it takes.

    Parameters
    ----------
    call : Term
    env : dict of str to value
    """
    saved, run.memory.misused = run.memory.misused, False
    found = not attempt(run, call, env)
    run.memory.misused = saved
    return found


def _alters(run: Run, call: Term, env: dict[str, Any]) -> bool:
    """Whether a call sets options of a solver that are not known, or changes what it solves."""
    if call.name in UNFOLLOWED:
        return True
    if call.name in run.own:
        takes = run.own[call.name].takes
        pairs = zip(takes, call.parts, strict=False)
        if any(_excludes(run, name, known_value(run, part, env)) for name, part in pairs):
            return True
    if call.name == "struct":
        names = [p.text.strip("'\"") for p in call.parts[::2]]
        values = [known_value(run, part, env) for part in call.parts[1::2]]
        words = [Term("name", name) for name in names]
        return any(map(partial(_excludes, run), names, values)) or any(
            map(partial(_is_another_word, run), words, call.parts[1::2])
        )
    if call.name in run.own or not (is_solver(call.name) or call.name in MADE_BY_NAME):
        return False
    return is_solver_told_more(run, call) or (run.language.name == "Julia" and any(
        one.parts[0].name == "p" and not _is_parameter_list(run, one.parts[1], env)
        for one in call.all() if one.kind == "set"
    ))  # fmt: skip


def _is_parameter_list(run: Run, part: Term, env: dict[str, Any]) -> bool:
    for judged in run.judged.values():
        takes = judged.takes
        name = takes[-2] if takes[-1:] == ("t",) and len(takes) > 2 else ""
        if not accepted(run, judged, name, part, known_value(run, part, env)):
            return False
    return True


def _is_impossible(run: Run, one: Term, env: dict[str, Any]) -> bool:
    """Whether a field or an option is a number that its parameter cannot have."""
    if one.kind != "set" or one.parts[0].kind != "name":
        return False
    excluded = _excludes(run, one.parts[0].name, known_value(run, one.parts[1], env))
    return excluded or _is_another_word(run, *one.parts)


def _excludes(run: Run, name: str, value: Any) -> bool:
    word = meaning_of(run, name) if name.isidentifier() else ""
    return bool(word) and isinstance(value, Literal) and not is_possible(run, word, value)


def _holds(run: Run, line: Term, env: Mapping[str, Any]) -> bool:
    """Whether the value is what the function returns, no function and no solution."""
    value = line.parts[1]
    if value.kind == "call" and value.name in _silent(run):
        return False
    return value.kind in ("call", "entry", "name") and not any(
        one.kind == "call" and _by_name(run, one, env) for one in value.all()
    )


def _filled(run: Run, line: Term) -> set[str]:
    """What calls of the function in a line set."""
    return {
        root_of(part)
        for call in line.all() if call.kind == "call" and call.name in run.judged
        for name, part in zip(run.judged[call.name].takes, call.parts, strict=False)
        if name in run.judged[call.name].fills
    }  # fmt: skip


def _concerned(run: Run, line: Term, env: Mapping[str, Any], made: set[str]) -> set[str]:
    names = functions_in(run, env) | made - {""}
    names |= {t.name for t in line.all() if t.kind == "call" and _by_name(run, t, env)}
    return line.names() & names


def _by_name(run: Run, call: Term, env: Mapping[str, Any]) -> list[int]:
    """Places of a call at which it takes the function itself."""
    functions = functions_in(run, env)
    return [
        k for k, part in enumerate(call.parts)
        if (part.kind == "handle" and part.names() & functions)
        or (part.kind == "name" and part.name in functions)
    ]  # fmt: skip


def _innocent(run: Run, line: Term, env: dict[str, Any], made: set[str]) -> bool:
    functions = functions_in(run, env)
    if any(not _plain_handle(run, h, env) for h in line.all() if h.kind == "handle"):
        return False
    if _computes(run, line, functions, made) or _unseen(run, line, functions):
        return False
    for call in line.all():
        if call.kind != "call":
            continue
        handed = _by_name(run, call, env)
        if handed and call.name in run.own and not _taken(run, call, handed, env):
            return False
        solver = run.language.name != "Python" or is_solver(call.name)
        if handed and call.name not in run.own and solver and not _solved(run, call, env):
            return False
        if call.name in run.users and not _called_plainly(run, call, env):
            return False
    return attempt(run, line, env)


def _unseen(run: Run, line: Term, functions: set[str]) -> bool:
    """Whether the function is used where nothing is followed."""
    if line.kind == "other":
        return bool(line.names() & functions)
    return any(_unseen(run, part, functions) for part in line.parts)


def _called_plainly(run: Run, call: Term, env: dict[str, Any]) -> bool:
    """Whether another function, which uses the judged one, is called with what it takes."""
    for name, part in zip(run.own[call.name].takes, call.parts, strict=False):
        if part.kind == "name" and part.name in run.own[call.name].takes:
            if part.name != name:
                return False
        elif part.kind in ("minus", "binary"):
            value = known_value(run, part, env)
            if not isinstance(value, Literal) or (value <= 0 and name in STEPS):
                return False
        elif part.kind == "other" and part.names():
            return False
    return True


def _solved(run: Run, call: Term, env: dict[str, Any]) -> bool:
    """Whether it hands the function to a solver, and parameters in their order."""
    if not SOLVERS.search(call.name) or not _in_order(run, call, env):
        return False
    return all(
        accepted(run, judged, name, part, known_value(run, part, env))
        for judged in run.judged.values()
        for name, part in _beside(judged.takes, call)
    )


def _in_order(run: Run, call: Term, env: dict[str, Any]) -> bool:
    """Whether a solver calls what it is handed with time and state in their order."""
    late = call.name in STATE_FIRST
    ordered = run.language.brackets and (call.name.startswith("ode") or late)
    if not ordered and run.language.name != "Python":
        return True
    texts = [";" in part.text for part in call.parts[1:3] if part.kind == "list"]
    if not late and texts == [True, False]:
        return False  # the state for the span of time
    for part in (call.parts[k] for k in _by_name(run, call, env)):
        handle = handle_of(run, part, env)
        if part.kind == "name" and (judged := run.judged.get(part.name)) is not None:
            moving = {n for n, m in judged.meanings.items() if {*m} & {*run.words.state}}
            if moving and moving.isdisjoint(judged.takes[not late : 2 - late]):
                return False
        elif isinstance(handle, Handle) and handle.body is not None:
            one = Term("handle", " ".join(handle.takes), (handle.body,))
            if not _plain_handle(run, one, {**env, **handle.inside}, late=late):
                return False
    return True


def _computes(run: Run, line: Term, functions: set[str], made: set[str]) -> bool:
    """Whether something is made of what the function returned."""
    if line.kind == "handle" or (line.kind == "call" and line.name in TESTS):
        return False
    inner = line.parts
    keeps = run.language.keeps
    if line.kind == "call" and line.name not in functions and _results(run, line, functions, made):
        own = run.own.get(line.name)
        if _alters_values(own) if own is not None else keeps is not None and line.name not in keeps:
            return True
    if line.kind in ("set", "return") and any(
        one.kind == "call" and one.name in OTHER_VALUES and _results(run, one, functions, made)
        for one in line.all()
    ):
        return True
    if line.kind in ("binary", "minus") and _results(run, line, functions, made):
        return True
    if _reorders(run, line, functions, made):
        return True
    if line.kind == "set":
        target, value = line.parts
        if line.name and (_results(run, value, functions, made) or root_of(target) in made):
            return True
        if value.kind == "list" and keeps is None and _results(run, value, functions, made):
            return True
        if value.kind == "call" and value.name in run.judged:
            given = {root_of(p) for p in value.parts}
            if {root_of(t) for t in targets_of(target)} & given - {""}:
                return True
        if _results(run, value, functions, made) and _moved(run, target, value):
            return True
    return any(_computes(run, part, functions, made) for part in inner)


def _alters_values(function: FileFunction) -> bool:
    """Whether a function returns something that it computes."""
    returned = [t for t in function.body.all() if t.kind == "return"]
    names = {*function.gives}.union(*(t.names() for t in returned))
    sets = [t.parts[1] for t in function.body.all()
            if t.kind == "set" and (t.name or root_of(t.parts[0]) in names)]  # fmt: skip
    return any(one.kind in ("binary", "minus") or one.name in OTHER_VALUES
               for t in (*returned, *sets) for one in t.all())  # fmt: skip


def _reorders(run: Run, line: Term, functions: set[str], made: set[str]) -> bool:
    """Whether it has entries of a result in another order: [d[1], d[0]], d[[1, 0]], d[::-1]."""
    if line.kind == "other":
        return any(_results(run, part, functions, made) for part in line.parts)
    if line.kind == "entry" and line.parts[1].kind == "list":
        numbers = [p.name for p in line.parts[1].parts if p.kind == "number"]
        return numbers != sorted(numbers) and _results(run, line.parts[0], functions, made)
    if line.kind != "list":
        return False
    entries = [p for p in line.parts if p.kind == "entry" and p.parts[1].kind == "number"
               and _results(run, p.parts[0], functions, made)]  # fmt: skip
    places = [p.parts[1].name for p in entries]
    if places != sorted(places) and len({p.parts[0].text for p in entries}) == 1:
        return True
    names = [p.name for p in line.parts if p.kind == "name"]
    return any([n for n in one if n in names] != [n for n in names if n in one]
               for one in run.memory.unpacked)  # fmt: skip


def _moved(run: Run, target: Term, value: Term) -> bool:
    """Whether an entry becomes another one: y(1) = d(2)."""
    ones, others = (
        [p.name for p in (t.parts[1:] if t.kind == "entry" else t.parts) if p.kind == "number"]
        if t.kind == "entry" or (t.kind == "call" and run.language.brackets) else []
        for t in (target, value)
    )  # fmt: skip
    return bool(ones and others) and ones != others


def _silent(run: Run) -> set[str]:
    """Functions that use the judged one and return nothing of what it returned."""
    if run.memory.silent is None:
        found = {n for n in run.users if not run.own[n].shared and not run.own[n].gives}
        while new := {
            n for n in found if _returns(run, run.own[n], {*run.judged, *run.users} - found)
        }:
            found -= new
        run.memory.silent = found
    return run.memory.silent


def _returns(run: Run, one: FileFunction, functions: set[str]) -> bool:
    """Whether a function returns what some functions returned, and no state advanced by it."""
    other = replace(run, memory=Memory())
    blocks = [
        (one.body, one),
        *((t, None) for t in one.body.all() if t.kind == "loop"),
    ]
    advanced = {root for block, whole in blocks if is_step(other, block, {}, whole)
                for root, _ in other.memory.advanced}  # fmt: skip
    if advanced and is_step(other, one.body, {}, one):
        return False
    made: set[str] = set()
    lines = [t for t in one.body.all() if t.kind == "set"]
    while new := {root_of(t) for line in lines if _holding(run, line.parts[1], functions, made)
                  for t in targets_of(line.parts[0])} - made - advanced:  # fmt: skip
        made |= new
    return any(_holding(run, t, functions, made) for t in one.body.all() if t.kind == "return")


def _results(run: Run, value: Term, functions: set[str], made: set[str]) -> bool:
    return _holding(run, value, functions - _silent(run), made)


def _holding(run: Run, value: Term, functions: set[str], made: set[str]) -> bool:
    if value.kind == "handle":
        return False
    own = value.kind == "call" and value.name in functions
    return own or (value.kind in ("name", "call") and value.name in made) or any(
        _holding(run, part, functions, made) for part in value.parts
    )  # fmt: skip


def _taken(run: Run, call: Term, handed: Sequence[int], env: dict[str, Any]) -> bool:
    """Whether a function of the file uses the one that it is handed innocently."""
    one = run.own[call.name]
    given = {
        name: handle_of(run, part, env)
        for k, (name, part) in enumerate(zip(one.takes, call.parts, strict=False))
        if k in handed
    }
    if call.name in run.memory.taken:
        return True
    taken = Memory(taken=run.memory.taken | {call.name})
    other = replace(_with_body(run, one), memory=taken)
    if not is_step(other, one.body, dict(given), one):
        begin(other)
        find_vectors(other, one.body, given)
        if _lines(other, one.body, dict(given), set()):
            return False
    run.memory.explained |= {call.name} | other.memory.explained
    return True


def _plain_handle(run: Run, handle: Term, env: dict[str, Any], *, late: bool | None = None) -> bool:
    """Whether a function without a name is the judged one, or gives the rates made of it.

    Parameters
    ----------
    late : bool, optional
        Whether it is called with the time after the state; by its names where nothing says it.
    """
    takes = tuple(handle.name.split())
    inside = dict(env)
    places: dict[str, str] = {}
    if len(takes) == 1:
        places = {"state": takes[0]}
    elif len(takes) == 2 and run.language.name in ("MATLAB", "Python"):
        after = takes[1] in TIMES if late is None else late
        order = ("state", "time") if after else ("time", "state")
        places = dict(zip(order, takes, strict=True))
    elif len(takes) == 3 and run.language.name != "Python":
        places = dict(zip(("state", "parameters", "time"), takes, strict=True))
    elif len(takes) == 4 and run.language.name != "Python":
        places = dict(zip(("out", "state", "parameters", "time"), takes, strict=True))
    if "state" not in places:
        return _renamed(run, handle, takes, env)
    saved = run.memory.misused, run.memory.initial, run.memory.called, run.memory.vectors
    run.memory.misused, run.memory.initial, run.memory.called = False, {}, []
    size = len(run.words.state)
    state = Table(places["state"], size=size)
    for place, name in places.items():
        inside[name] = {"state": state, "time": Literal(number("time")), "out": Table(name),
                        "parameters": Table("parameters")}[place]  # fmt: skip
    try:
        result = known_value(run, handle.parts[0], inside)
        filled = inside.get(places.get("out", ""))
        fits = not run.memory.misused and (
            _rates_at(run, state, result, filled, "time" in places)
            if any(judged.gives for judged in run.judged.values())
            else handle.parts[0].kind == "call" and handle.parts[0].name in run.judged
        )  # fmt: skip
    except NotFollowedError:
        fits = False
    run.memory.misused, run.memory.initial, run.memory.called, run.memory.vectors = saved
    return fits


def _renamed(run: Run, handle: Term, takes: Sequence[str], env: dict[str, Any]) -> bool:
    """Whether a function without a name calls the judged one, with its own arguments."""
    body = handle.parts[0]
    while body.kind in ("block", "return") and len(body.parts) == 1:
        (body,) = body.parts
    if body.kind != "call" or body.name not in run.judged:
        return False
    return attempt(run, body, {n: v for n, v in env.items() if n not in takes})


def _rates_at(run: Run, state: Table, result: Any, filled: Any, timed: bool) -> bool:
    """Whether some values are the rates of a state, or what the function gives at it."""
    values = entries_of(run, filled if filled is not None else result)
    if values is None:
        return False
    entries = entries_of(run, state) or []
    asked = run.memory.called[-1] if run.memory.called else {}
    moment = {MOMENT: asked[MOMENT]} if MOMENT in asked else {}
    if timed and moment.get(MOMENT, number("time")) != number("time"):
        return False
    for order in orders(run):
        at = dict(zip(order, entries, strict=False)) | moment
        rates = all_rates(run, at)
        if [*values] == [rates[w] for w in order]:
            return True
        if any(judged.gives and [*values] == [rates[w] for w in judged.gives]
               for judged in run.judged.values()):  # fmt: skip
            return True
    return False


def _beside(takes: Sequence[str], call: Term) -> Iterator[tuple[str, Term]]:
    """What a solver is handed for the function, beside time and state."""
    if takes[-1:] == ("t",) and len(takes) > 2:
        still = call.name in ("NonlinearProblem", "SteadyStateProblem")  # these have no span
        yield from zip(takes[-2:-1], call.parts[3 - still : 4 - still], strict=False)
    else:
        yield from zip(takes[2:], call.parts[4:], strict=False)  # ode45(@f, span, start, o, m, l)
