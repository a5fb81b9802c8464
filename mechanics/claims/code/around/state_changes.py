"""Lines that change what a judged function is asked about, beside the steps of an integrator.

double *p = &w;  *p -= 0.1;             by another name: a pointer, a reference, a view
y[0] = -y[0], between two loops         after the function has been asked
kick(&w);  y.assign(2, 0);  KICK(w)     by a call of which the file does not say what it does
int theta = 1;  a = (int)accel(...)     a state of whole numbers

What stands before the first use is a start, and so is a line that gives the whole state anew.
"""

import re
from collections.abc import Collection, Iterator, Sequence

from mechanics.claims.code.around.handed_parameters import other_parameters
from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter_values import targets_of
from mechanics.claims.code.around.names_around import READS, UNFOLLOWED, Around, base_of, head_of
from mechanics.claims.code.around.run import Run, meaning_of
from mechanics.claims.code.around.solver_starts import is_solver

SINGLE = re.compile(r"\b(float|float32_t|half)\b")
WHOLE = re.compile(r"\b(u?int\w*|long|short|char|unsigned|signed|bool|byte|word|size_t)\b")
ASSEMBLY = ("asm", "__asm")
NARROW = re.compile(r"u?int(8|16|32|64)|single|logical")
"""Calls of MATLAB that round what they are given."""


def state_changes(run: Run, body: Term, again: bool = False) -> list[str]:
    """Lines of a block that change the state, or what stands for it, and that nothing explains.

    Parameters
    ----------
    run : Run
        Which has looked at the block: its memory says where steps of integrators are.
    body : Term
    again : bool
        Whether others call it, and it goes on from where its state was left.
    """
    around = Around(run, body, again)
    if not around.all_names:
        return []
    steps = id(body) in run.memory.steps
    back = any(one.kind == "jump" and one.name == "goto" for one in body.all())
    return [*_types(around), *other_parameters(around), *_walk(around, body, (back, back), steps)]


def changes_elsewhere(run: Run, users: Collection[str], apart: Collection[str]) -> Iterator[str]:
    """Lines of functions that nobody calls here, an interrupt's say, which change the state.

    Parameters
    ----------
    run : Run
    users : collection of str
        Functions that use the judged one.
    apart : collection of str
        The others.
    """
    shared: set[str] = set()
    for name in users:
        around = Around(run, run.own[name].body)
        shared |= around.state - around.types.keys() - {*run.own[name].takes}
    for name in apart:
        one = run.own[name]
        around = Around(run, one.body)
        mine = around.types.keys() | {*one.takes}
        sets = [t for t in _flat(one.body) if t.kind == "set"]
        whole = {base_of(t.parts[0]) for t in sets if _is_fresh(around, t)} & shared
        if len(whole) < len(run.words.state):
            yield from (f"{name}: {t.text}" for t in one.body.all()
                        if t.kind == "set" and base_of(t.parts[0]) in shared - mine)  # fmt: skip


def _flat(block: Term) -> Iterator[Term]:
    for one in block.parts if block.kind == "block" else (block,):
        if one.kind == "block":
            yield from _flat(one)
        else:
            yield one


def _walk(
    around: Around, block: Term, uses: tuple[bool, bool], steps: bool
) -> Iterator[str]:  # fmt: skip
    """Lines of a block; `uses` is whether the function is asked before it, and after."""
    lines = [*_flat(block)]
    asked = [around.is_use(one) for one in lines]
    for k, one in enumerate(lines):
        before, after = uses[0] or any(asked[:k]), uses[1] or any(asked[k + 1 :])
        if one.kind == "loop":
            step = steps or id(one) in around.run.memory.steps
            turns = asked[k] and not _only_samples(around, one)
            yield from _walk(around, one.parts[1], (before or turns, after or turns), step)
        elif one.kind == "case":
            for part in one.parts:
                yield from _walk(around, part, (before, after), steps)
                yield from (t.text for t in part.all() if t.kind == "set" and steps
                            and base_of(t.parts[0]) in around.parameters)  # fmt: skip
        elif one.kind != "type" and _changes_state(around, lines, k, before and after, steps):
            yield one.text
            yield from _sources(around, one)


def _changes_state(
    around: Around, lines: Sequence[Term], k: int, between: bool, steps: bool
) -> bool:  # fmt: skip
    """Whether a line changes the state between two uses of the function."""
    one = lines[k]
    declares = k > 0 and lines[k - 1].kind == "type" and lines[k - 1].name
    fresh = one.kind == "set" and (
        _is_anew(around, lines, k) or (declares == base_of(one.parts[0]) and _is_fresh(around, one))
    )
    held = {id(t) for h in one.all() if h.kind == "handle" for t in h.all()}
    return any(
        _is_change(around, part, one, between or id(part) in held, steps, fresh)
        for part in one.all()
    )


def _sources(around: Around, line: Term) -> Iterator[str]:
    """Lines that compute what another one is made of."""
    done: set[str] = {*around.state, *around.results, ""}
    todo = {head_of(n) for one in line.all() if one.kind == "set" for n in one.parts[1].names()}
    while todo := todo - done:
        done |= todo
        sets = [one for one in around.body.all() if one.kind == "set"
                and not todo.isdisjoint(map(base_of, targets_of(one.parts[0])))]  # fmt: skip
        for one in sets:
            part = one.parts[0].kind != "name" or one.name
            made = {*map(head_of, one.parts[1].names())}
            if base_of(one.parts[0]) in made or (
                around.moving & made
                and (part or any(t.kind in ("minus", "binary", "list") for t in one.all()))
            ):
                yield one.text
        todo = {head_of(n) for one in sets for n in one.parts[1].names()}


def _is_change(
    around: Around, part: Term, line: Term, used: bool, steps: bool, fresh: bool
) -> bool:  # fmt: skip
    if part.kind == "call":
        asks = part.name in UNFOLLOWED or around.again or around.holds_function(part)
        return (used or steps or asks) and around.is_changing_call(part, part is line, steps)
    if part.kind == "other" and part is line and part.text.startswith(ASSEMBLY):
        return used and not around.all_names.isdisjoint(part.names())
    if part.kind == "other" and part is line and part.parts and part.parts[0].kind == "field":
        called = part.parts[0]  # q->kick()
        mine = base_of(called) in around.state | around.aliases
        return used and mine and called.name not in READS and called.name not in around.run.judged
    if part.kind != "set":
        return False
    return any(
        _is_written(around, part, target, line, used, steps, fresh)
        for target in targets_of(part.parts[0])
    )


def _is_written(
    around: Around, one: Term, target: Term, line: Term, used: bool, steps: bool, fresh: bool
) -> bool:  # fmt: skip
    name, value = base_of(target), one.parts[1]
    if not name:
        return not around.all_names.isdisjoint(map(head_of, target.names()))
    made = not around.all_names.isdisjoint(map(head_of, value.names())) or bool(one.name)
    if name in around.aliases and _reaches(around, target, one):
        return used or steps or made
    last = meaning_of(around.run, target.name) if target.kind == "field" else ""
    if last in around.run.words.parameters and name in around.state and value.text.startswith("-"):
        return True
    if name not in around.state:
        return name in around.parameters and bool(one.name)
    if any(t.kind == "call" and NARROW.fullmatch(t.name) for t in value.all()):
        return True
    lasting = around.again and around.run.language.pointers and name not in around.types
    if not (used or steps or lasting):
        return False
    if around.run.language.pointers and any(t.kind == "call" for t in _way(target)):
        return True
    inside = one is not line and any(
        one in t.all() for t in line.all() if t.kind == "handle"
    )  # fmt: skip
    if steps and not inside:
        places = target.parts[1:] if target.kind == "entry" else ()
        return any(place.text == "end" for place in places)
    word = last if around.run.language.pointers else ""
    if fresh or word in around.run.words.inputs or _is_advanced_by(around, one):
        return False
    return not (_is_bare(target) and _shares_name(around, name, value))


def _is_advanced_by(around: Around, one: Term) -> bool:
    """Whether a line gives the state what a function that uses the judged one returns."""
    value = one.parts[1]
    return not one.name and value.kind == "call" and (
        value.name in around.run.users or is_solver(value.name)
    )  # fmt: skip


def _is_bare(target: Term) -> bool:
    return target.kind == "name" and not target.text.startswith("*")


def _shares_name(around: Around, name: str, value: Term) -> bool:
    """Whether a pointer is given another array: y = next."""
    return "*" in around.types.get(name, "") and value.kind == "name"


def _way(target: Term) -> Iterator[Term]:
    """A target, and what it is a part of."""
    yield target
    if target.kind in ("entry", "field"):
        yield from _way(target.parts[0])


def _reaches(around: Around, target: Term, one: Term) -> bool:
    """Whether an assignment to another name changes what that stands for."""
    if not _is_bare(target):
        return True
    if around.run.language.pointers:
        declares = one.text.partition("=")[0].strip() != target.text and not one.name
        return "&" in around.types.get(target.name, "") and not declares
    return bool(one.name) and "." in one.text.partition("=")[0]


def _is_fresh(around: Around, line: Term) -> bool:
    """Whether a line gives something a value that is made of no state."""
    return not line.name and around.moving.isdisjoint(map(head_of, line.parts[1].names()))


def _is_anew(around: Around, lines: Sequence[Term], k: int) -> bool:
    """Whether a line and those around it give the whole state anew."""
    if not _is_fresh(around, lines[k]):
        return False
    first = last = k
    while first > 0 and _is_start(around, lines[first - 1]):
        first -= 1
    while last + 1 < len(lines) and _is_start(around, lines[last + 1]):
        last += 1
    group = [one for one in lines[first : last + 1] if one.kind == "set"]
    targets = [t for one in group for t in targets_of(one.parts[0]) if base_of(t) in around.state]
    size = len(around.run.words.state)
    whole = any(t.kind == "name" and one.parts[1].kind in ("list", "call", "name")
                for one in group for t in targets_of(one.parts[0]) if base_of(t) in around.state
                and size > 1 and not _is_scalar(around, t.name))  # fmt: skip
    return whole or len({t.text for t in targets}) >= size


def _is_scalar(around: Around, name: str) -> bool:
    kind = around.types.get(name, "double" if around.run.language.pointers else "")
    known = meaning_of(around.run, name) in around.run.words.state
    return known or kind in ("double", "float", "int")


def _is_start(around: Around, line: Term) -> bool:
    if line.kind == "type":
        return True
    if line.kind == "call":
        return around.shows(line)
    return line.kind == "set" and _is_fresh(around, line)


def _only_samples(around: Around, loop: Term) -> bool:
    """Whether a loop asks the function about states that it makes anew at each turn."""
    if around.advances(loop):
        return False
    return all(
        _is_fresh(around, one)
        for one in loop.all() if one.kind == "set"
        if any(base_of(t) in around.state for t in targets_of(one.parts[0]))
    )  # fmt: skip


def _types(around: Around) -> Iterator[str]:
    """Declarations of a state, of a result or of a step that does not hold its numbers."""
    if not around.run.language.pointers:
        return
    sets = [t for t in around.body.all() if t.kind == "set"]
    moving = around.state | around.results
    beside = {n for one in sets if base_of(one.parts[0]) in moving for n in one.parts[1].names()}
    kept = beside & around.moving
    beside |= around.others
    wide = not all(judged.single for judged in around.run.judged.values())
    for name, text in around.types.items():
        shape = text.replace("long double", "double")
        whole, single = WHOLE.search(shape), SINGLE.search(shape)
        values = [one.parts[1] for one in sets if base_of(one.parts[0]) == name]
        rounds = whole and name in beside and any(map(_is_fraction, values))
        narrow = single and wide
        if rounds or (name in moving and (whole or narrow)) or (name in kept and narrow):
            yield f"{text.rstrip('[]*&')} {name}"


def _is_fraction(value: Term) -> bool:
    return any(one.kind == "number" and re.search(r"[.eE]", one.name) and "x" not in one.name
               for one in value.all())  # fmt: skip
