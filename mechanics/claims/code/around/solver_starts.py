"""Where a solver starts: anywhere, or where another one ended, entry by entry.

y0 = sol.y[:, -1];  y0 = [sol.y[0, -1], sol.y[1, -1]]   of Python,

y0 = y(end, :)';  y0 = [y(end, 1); y(end, 2)]           goes on with the same motion
y0 = -y(end, :)';  y0 = fliplr(y(end, :));  y0(2) = 0   changes the state on the way
"""

import re
from collections.abc import Iterator, Set

from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter_values import root_of, targets_of
from mechanics.claims.code.around.run import Run
from mechanics.claims.code.around.solver_options import MADE_BY_NAME, RUNS

SOLVERS = re.compile(r"ode|solve|problem|integrat|jacobian|do_step", re.IGNORECASE)
"""In the names of what takes a function by its name."""
STATE_FIRST = frozenset(("lsode", "lsoda", "dassl"))
MADE_AGAIN = frozenset(("remake", "reinit")) | RUNS
PYTHON_SOLVERS = frozenset(
    ("solve_ivp", "RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA", "ode", "odeint", "integrate")
)
KEEPS = frozenset(
    (
        "array",
        "asarray",
        "sol",
        "last",
        "transpose",
        "vec",
        "reshape",
        "Vector",
        "Array",
        "squeeze",
        "deval",
    )
)
"""Calls that leave entries as they are, in their order."""


def is_solver(name: str) -> bool:
    """Whether a call of this name solves something, or makes what is solved."""
    return (bool(SOLVERS.search(name)) and name not in MADE_BY_NAME) or name in MADE_AGAIN


def solves(call: Term, run: Run | None = None) -> bool:
    """Whether a call returns a solution."""
    if run is not None and run.language.name == "Python":
        return call.kind == "call" and call.name in PYTHON_SOLVERS | {*run.users}
    told = call.name.lower()
    makes = "problem" in told or "function" in told or call.name == "remake"
    return call.kind == "call" and is_solver(call.name) and not makes


def changes_start(run: Run, line: Term) -> bool:
    """Whether a line makes a start of a solver of a solution by more than taking its entries.

    Parameters
    ----------
    line : Term
    """
    if run.language.name not in ("MATLAB", "Julia", "Python"):
        return False
    starts = [part for one in line.all() if one.kind == "call" for part in _starts(run, one)]
    target, value = line.parts if line.kind == "set" else (line, line)
    gives = line.kind == "set" and not solves(value, run) and root_of(target) in start_names(run)
    solutions = _solutions(run) if starts or gives else set()
    changed = not all(_keeps(run, part, solutions) for part in starts)
    if changed or not gives:
        return changed
    if line.name and _uses(run, target, solutions):
        return True
    ones, others = _numbers(run, target), _numbers(run, value)
    moved = target.kind != "name" and bool(ones and others) and ones[-1] not in others
    part = target.kind != "name" and value.kind == "number"
    again = any(_uses(run, one.parts[1], solutions) for one in run.definitions[root_of(target)])
    return moved or (part and again) or not _keeps(run, value, solutions)


def _solutions(run: Run) -> set[str]:
    """Names that hold what a solver returns, or are made of such."""
    found: set[str] = set()
    pairs = [(name, one) for name, lines in run.definitions.items() for one in lines]
    while new := {n for n, one in pairs
                  if _uses(run, one.parts[1], found)} - found:  # fmt: skip
        found |= new
    return found


def _starts(run: Run, call: Term) -> Iterator[Term]:
    """Arguments of a call that are where a solver starts."""
    if run.language.name == "MATLAB":
        if call.name in STATE_FIRST:
            yield from call.parts[1:2]
        elif call.name.startswith("ode") and call.name not in MADE_BY_NAME:
            yield from call.parts[2:3]
    elif run.language.name == "Python":
        yield from _python_starts(run, call)
    elif run.language.name == "Julia" and is_solver(call.name):
        if call.name.endswith("Problem") or call.name == "reinit":
            yield from (p for p in call.parts[1:2] if p.kind != "set")
        yield from (p.parts[1] for p in call.all() if p.kind == "set" and p.parts[0].name == "u0")


def _python_starts(run: Run, call: Term) -> Iterator[Term]:
    if call.name in run.users:
        pairs = zip(run.own[call.name].takes, call.parts, strict=False)
        yield from (part for name, part in pairs if name in _handed_on(run, call.name))
    elif call.name in PYTHON_SOLVERS:
        place = 1 if call.name == "odeint" else 2
        yield from (p for p in call.parts[place : place + 1] if p.kind != "set")
        yield from (p.parts[1] for p in call.parts if p.kind == "set" and p.parts[0].name == "y0")
    elif call.name == "set_initial_value":
        yield from call.parts[1:2]


def _handed_on(run: Run, name: str) -> set[str]:
    """Arguments of a function of the file at which a solver in it starts."""
    body = run.own[name].body
    calls = [one for one in body.all() if one.kind == "call" and one.name in PYTHON_SOLVERS]
    return {n for one in calls for part in _python_starts(run, one) for n in part.names()}


def start_names(run: Run) -> set[str]:
    """Names of which starts of solvers are made."""
    calls = [one for one in run.block.all() if one.kind == "call"]
    found = {n for one in calls for part in _starts(run, one) for n in _bases(run, part)}
    while new := {
        n for name in found for line in run.definitions.get(name, ())
        if not solves(line.parts[1], run) for n in _bases(run, line.parts[1])
    } - found:  # fmt: skip
        found |= new
    return found


def _bases(run: Run, value: Term) -> Iterator[str]:
    """Names of which a value is made, without those that count its places."""
    if value.kind == "name" or value.name in run.definitions:
        yield value.name
    elif value.kind in ("entry", "field"):
        yield root_of(value)
    else:
        for part in value.parts:
            yield from _bases(run, part)


def _uses(run: Run, value: Term, names: Set[str]) -> bool:
    """Whether a value has one of some names in it, or what a solver returns."""
    used = {base for name in value.names() for base in _owners(name)}
    return not names.isdisjoint(used) or any(solves(one, run) for one in value.all())


def _owners(name: str) -> Iterator[str]:
    """A name and the objects of which it is an attribute: sol.y, sol."""
    while name:
        yield name
        name = name.rpartition(".")[0]


def _keeps(run: Run, value: Term, solutions: Set[str]) -> bool:
    """Whether a value is no solution, or some entries of one in their order."""
    if (
        not _uses(run, value, solutions)
        or value.kind in ("name", "field", "whole")
        or solves(value, run)
    ):
        return True
    if value.kind == "call" and value.name in KEEPS:
        return all(_keeps(run, part, solutions) for part in value.parts)
    root = root_of(value)
    known = not solutions.isdisjoint(_owners(root))
    if value.kind in ("entry", "call") and (known or is_solver(root)):
        places = value.parts[1:] if value.kind == "entry" else value.parts
        return all(map(_is_in_order, places))
    if value.kind != "list":
        return False
    numbers = [n for part in value.parts if (n := _numbers(run, part))]
    return numbers == sorted(numbers) and all(
        _uses(run, part, solutions) and _keeps(run, part, solutions) for part in value.parts
    )


def _is_in_order(place: Term) -> bool:
    if place.kind == "list":
        numbers = [part.name for part in place.parts]
        return numbers == sorted(numbers)
    return place.kind != "other" or place.text in ("end", "begin")


def _numbers(run: Run, value: Term) -> list[int]:
    """Numbers among the places of an entry, also of one that a name stands for."""
    if value.kind not in ("name", "entry", "call"):
        return []
    root = root_of(value)
    lines = run.definitions.get(root, ())
    base = _given(lines[0], root) if len(lines) == 1 else None
    before = _numbers(run, base) if base is not None and root not in base.names() else []
    if len(lines) == 1 and run.language.name == "Python" and value.kind == "name":
        names = [root_of(t) for t in targets_of(lines[0].parts[0])]
        if base is None and lines[0].parts[0].kind == "list" and names.count(root) == 1:
            return [names.index(root)]  # theta, w = sol.y[:, -1]
    places = value.parts[1:] if value.kind == "entry" else value.parts
    return [*before, *(int(p.name) for p in places if p.kind == "number" and p.name.isdigit())]


def _given(line: Term, name: str) -> Term | None:
    """What a line gives a name; none where a solver, or more than one name, is in it."""
    targets, value = [*targets_of(line.parts[0])], line.parts[1]
    values = value.parts if line.parts[0].kind == "list" and value.kind == "list" else (value,)
    pairs = {t.name: v for t, v in zip(targets, values, strict=False) if t.kind == "name"}
    return None if len(targets) != len(values) or solves(value) else pairs.get(name)
