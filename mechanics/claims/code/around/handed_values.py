"""Parameters and states that a solver or the judged function is handed, changed on the way.

reverse!(prob.p);  replace!(p, 0.5 => -0.5)     calls of Julia that change what they take
p = fliplr(p)                                   parameters that are made of themselves
y = flipud(y), between two loops                a state that is
"""

from collections.abc import Iterator, Sequence

from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter_values import root_of, targets_of
from mechanics.claims.code.around.run import Run
from mechanics.claims.code.around.solver_starts import is_solver, solves, start_names

HARMLESS = frozenset(
    ("step!", "solve!", "init!", "push!", "append!", "reinit!", "terminate!", "add_tstop!",
     "savevalues!", "display!")
)  # fmt: skip
"""Calls with ! that do not change what they are given, or as the solver does."""


METHODS = frozenset(
    ("sort", "fill", "reverse", "resize", "partition", "itemset", "byteswap", "clear", "pop",
     "insert", "put")
)  # fmt: skip
"""Methods of Python that change their object."""
IN_PLACE = frozenset(("shuffle", "fill_diagonal", "place", "putmask"))
"""Functions of Python that change what they are given first."""


def changes_handed(run: Run, line: Term) -> bool:
    """Whether a line changes parameters or a state that are handed on.

    Parameters
    ----------
    line : Term
    """
    if run.language.name not in ("MATLAB", "Julia", "Python"):
        return False
    handed = _handed(run)
    if any(_mutates(run, one, handed | run.memory.problems) for one in line.all()):
        return True
    if line.kind != "set" or solves(line.parts[1], run):
        return False
    target, value = line.parts
    made = {
        root_of(t): t.kind for t in targets_of(target) if line.name or root_of(t) in value.names()
    }
    whole = {root for root, kind in made.items() if kind == "name" and root_of(value) != root}
    parts = {root for root, kind in made.items() if kind != "name"}
    moved = whole | parts if run.language.name == "Python" else whole
    return bool((whole | parts) & _parameters(run) or moved & _between(run, line))


def changed_by_other_names(run: Run, block: Term) -> Iterator[str]:
    """Lines that change a state in place by a name that some line before gave it: v = y.

    Parameters
    ----------
    block : Term
        Lines of a file of Python, or of a function.
    """
    states = _asked(run, [Term("loop", "", (block,))])
    handed = states | start_names(run)
    for call in (one for one in block.all() if one.kind == "call"):
        roots = [root_of(part) for part in call.parts[:2]]
        owned = bool(roots) and call.name in METHODS and call.text.startswith(f"{roots[0]}.")
        changed = roots[:1] if owned else roots if call.name in IN_PLACE else []
        if not handed.isdisjoint(changed):
            yield call.text
    loops = [one for one in block.all() if one.kind == "loop"]
    lines = [one for one in block.all() if one.kind == "set"]
    for given in lines:
        target, value = given.parts
        place = next(k for k, line in enumerate(lines) if line is given)
        if target.kind == "name" and value.kind == "list":
            yield from _changed_in_a_list(lines[place:], states)
            continue
        pair = {target.name, root_of(value)}
        whole = value.kind == "name" and value.text == value.name
        part = value.kind == "entry" and value.parts[1].kind == "range"
        if target.kind != "name" or not (whole or part) or given.name:
            continue
        if not pair & states or len(pair) == 1:
            continue
        around = [one for one in loops if any(line is given for line in one.all())]
        here = {id(line) for one in around for line in one.all()}
        later = {id(line) for one in loops for line in one.all()} - here
        later |= {id(line) for line in lines[place + 1 :]} - here
        (other,) = pair - states or (target.name,)
        yield from (
            line.text for line in lines
            if root_of(line.parts[0]) == other and (line.name or line.parts[0].kind != "name")
            and id(line) in later
        )  # fmt: skip


def _changed_in_a_list(lines: Sequence[Term], states: set[str]) -> Iterator[str]:
    """Lines that change a state in a list that holds it: z = [y]; z[0][1] = 0."""
    target, value = lines[0].parts
    held = {one.parts[1] if one.kind == "set" else one for one in value.parts}
    owned = any(p.kind == "name" and p.text == p.name and p.name in states for p in held)
    if not owned or value.text[:1] not in ("[", "(", "{"):
        return
    for line in lines[1:]:
        place = line.parts[0]
        if place.kind == "name" and place.name == target.name:
            return  # another list
        root, _, part = root_of(place).partition(".")
        deep = place.kind == "entry" and len(place.parts) > 2 - bool(part)
        if root == target.name and (deep or line.name):
            yield line.text


def _mutates(run: Run, call: Term, handed: set[str]) -> bool:
    """Whether a call of Julia changes something that is handed on."""
    head = call.text.partition("(")[0].strip()
    own = call.name in run.own or call.name in run.judged
    if call.kind != "call" or not head.endswith("!") or own or run.language.name != "Julia":
        return False
    last = head.rpartition(".")[2]
    if last in HARMLESS or last in run.language.shows:
        return False
    return any(not handed.isdisjoint(_same(run, root_of(part))) for part in call.parts)


def _same(run: Run, name: str) -> set[str]:
    """Names of the same array: q = p."""
    found: set[str] = {name} - {""}
    while new := {
        root_of(line.parts[1]) for n in found for line in run.definitions.get(n, ())
        if line.parts[1].kind in ("name", "field")
    } - found - {""}:  # fmt: skip
        found |= new
    return found


def _handed(run: Run) -> set[str]:
    """Names of what solvers and judged functions are handed, but what these fill."""
    found: set[str] = set()
    for call in (t for t in run.block.all() if t.kind == "call"):
        if (judged := run.judged.get(call.name)) is not None:
            pairs = zip(judged.takes, call.parts, strict=False)
            found |= {root_of(part) for name, part in pairs if name not in judged.fills}
        elif is_solver(call.name):
            given = (p.parts[1] if p.kind == "set" else p for p in call.parts)
            found |= {root_of(part) for part in given if part.kind in ("name", "field")}
    return {other for name in found for other in _same(run, name)} - run.judged.keys()


def _parameters(run: Run) -> set[str]:
    """Names of arrays of parameters that solvers and judged functions are handed."""
    found: set[str] = set()
    for call in (t for t in run.block.all() if t.kind == "call"):
        if (judged := run.judged.get(call.name)) is not None:
            found |= {
                part.name for name, part in zip(judged.takes, call.parts, strict=False)
                if len(m := judged.meanings.get(name, ())) > 1 and part.kind == "name"
                and {*m}.isdisjoint(run.words.state)
            }  # fmt: skip
        elif call.name.endswith("Problem"):
            found |= {part.name for part in call.parts[3:4] if part.kind == "name"}
    return found


def _between(run: Run, line: Term) -> set[str]:
    """Names of states that loops advance before a line, and after it."""
    lines = [*statements(run.block)]
    place = next((k for k, one in enumerate(lines) if one is line), None)
    return set() if place is None else _asked(run, lines[:place]) & _asked(run, lines[place:])


def statements(block: Term) -> Iterator[Term]:
    """Lines of a block, and those of its cases, but not of loops."""
    for one in block.parts:
        yield from statements(one) if one.kind in ("block", "case") else (one,)


def _asked(run: Run, lines: Sequence[Term]) -> set[str]:
    """Names of states about which loops among some lines ask the judged function."""
    calls = [one for line in lines if line.kind == "loop" for one in line.all()
             if one.kind == "call" and one.name in run.judged]  # fmt: skip
    found = set()
    for call in calls:
        judged = run.judged[call.name]
        for name, part in zip(judged.takes, call.parts, strict=False):
            if {*judged.meanings.get(name, ())} & {*run.words.state}:
                found |= {root_of(part), *(root_of(t) for t in targets_of(part))}
    return found - {""}
