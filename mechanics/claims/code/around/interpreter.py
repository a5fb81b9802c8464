"""Statements of code, run on random numbers, with a random map for the judged function.

    y = y + h*rate(t, y, p)         every name that nothing gives a value has a random one,
                                    rate is a random affine map of the state

What is not followed is unknown, and what is made of it. An argument that is not what the function
takes at its place is a misuse.
"""

import re
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

from mechanics.claims.code.around.intermediate_form import EITHER, Term
from mechanics.claims.code.around.interpreter_values import (
    MOVING,
    OUTSIDE,
    ROUNDED,
    UNKNOWN,
    Handle,
    JudgedFunction,
    Literal,
    NotFollowedError,
    SeenEntries,
    Table,
    Unknown,
    number,
    root_of,
    targets_of,
)
from mechanics.claims.code.around.judged_arguments import (
    accepted,
    in_usual_order,
    is_another,
    is_possible,
    speed_of,
)
from mechanics.claims.code.around.number_calls import KNOWN, computed
from mechanics.claims.code.around.run import (
    FAR,
    MOMENT,
    Run,
    all_rates,
    entries_of,
    entry_of,
    functions_in,
    meaning_of,
    row_of,
)
from mechanics.claims.code.integrators import NAMES as STEPS

IMPURE = frozenset(
    ("next", "pop", "popleft", "popitem", "readline")
)  # fmt: skip
"""Calls that give another value of the file each time."""
DRAWN = frozenset(
    ("rand", "randn", "random", "randint", "integers", "uniform", "normal", "lognormal", "choice",
     "standard_normal", "triangular", "gauss", "input")
)  # fmt: skip
"""Calls that give a number from outside of the file each time."""
PI = Literal(355, 113)
TURNS = 12
"""Of a loop over entries."""
DEPTH = 6
"""Of calls."""
ROUNDS = {
    "Julia": frozenset(("div", "fld", "cld")),
    "MATLAB": frozenset(
        ("int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "idivide")
    ),
}
"""Calls that give integers, by languages; those of MATLAB round what is made of them, too."""
WHOLE = frozenset(("div", "xor", "&", "|", "<<", ">>"))
"""Operations of integers."""
MADE = frozenset(
    ("zeros", "ones", "empty", "linspace", "arange", "full", "eye", "repmat", "fill", "similar")
)
"""Calls that make an array."""


def _only_turns(run: Run, term: Term, env: dict[str, Any]) -> bool:
    """Whether a block only brings an angle back into one turn: th -= 2*pi."""
    sets = [one for one in term.all() if one.kind == "set"]
    stays = not any(one.kind in ("jump", "return") for one in term.all())
    return stays and bool(sets) and all(_takes_a_turn(run, one, env) for one in sets)


def _takes_a_turn(run: Run, line: Term, env: dict[str, Any]) -> bool:
    target, value = line.parts
    if not line.name and value.kind == "binary" and value.parts[0].text == target.text:
        line, value = Term("set", value.name), value.parts[1]
    return line.name in ("+", "-") and _is_turn(run, value, env)


def _is_turn(run: Run, term: Term, env: dict[str, Any]) -> bool:
    """Whether a formula is 2*pi, or Python's tau where that is nothing of the file or the scene."""
    if term.kind == "name" and term.name in ("tau", "math.tau"):
        taken = term.name in env or any(term.name in one.takes for one in run.own.values())
        return run.language.name == "Python" and not taken and not meaning_of(run, term.name)
    parts = sorted(term.parts, key=lambda one: one.kind, reverse=True)
    if (term.kind, term.name, [one.kind for one in parts]) != ("binary", "*", ["number", "name"]):
        return False
    return [known_value(run, part, env) for part in parts] == [2, PI]


def _keep_turned(run: Run, value: Any) -> None:
    run.memory.turned += entries_of(run, value) or [UNKNOWN]


def handle_of(run: Run, term: Term, env: dict[str, Any]) -> Any:
    """A function without a name, with what is known around it, or what a name stands for."""
    if term.kind == "handle":
        return Handle(tuple(term.name.split()), term.parts[0], dict(env))
    return value_of(run, term, env)


def _returned(run: Run, judged: JudgedFunction, at: Mapping[str, Any]) -> Any:
    """What the judged function gives at a state."""
    if not judged.gives or not all(isinstance(v, Fraction) for v in at.values()):
        run.memory.misused |= run.memory.stepping
        return UNKNOWN
    run.memory.called.append({w: Fraction(v) for w, v in at.items()})
    needed = {w: at.get(w, number("missing", w)) for w in run.words.state}
    rates = all_rates(run, needed | ({MOMENT: at[MOMENT]} if MOMENT in at else {}))
    turned = [w for w in judged.gives if w in run.words.coordinates]
    unasked = any(speed_of(run, w) not in at for w in turned)
    values = [UNKNOWN if w in turned and (unasked or w not in at) else rates[w]
              for w in judged.gives]  # fmt: skip
    return values[0] if len(values) == 1 else row_of(run, values)


def call_judged(run: Run, call: Term, env: dict[str, Any]) -> Any:
    """A call of the judged function."""
    judged = run.judged[call.name]
    takes = judged.takes
    if len(call.parts) > len(takes):
        run.memory.misused = True
        return UNKNOWN
    if _writes_over(run, judged, call, env):
        run.memory.misused = True
    at: dict[str, Any] = {}
    entries: dict[str, list[tuple[int, Any]]] = {}
    out: list[Term] = []
    for name, part in zip(takes, call.parts, strict=False):
        if part.kind == "absent":
            continue
        if part.kind == "set":  # by its name: accel(x; l=1)
            run.memory.misused = True
            continue
        if name in judged.fills:
            out.append(part)
            continue
        value = value_of(run, part, env)
        words = judged.meanings.get(name, ())
        if not accepted(run, judged, name, part, value):
            run.memory.misused = True
        if len(words) == 1 and part.kind in ("entry", "call") and isinstance(value, Fraction):
            places = part.parts[1:] if part.kind == "entry" else part.parts
            if words[0] in run.words.state or part.kind == "entry":
                keys = [value_of(run, p, env) for p in places]
                entries.setdefault(root_of(part), []).append((takes.index(name), (words[0], keys)))
        if name == judged.time and isinstance(value, Fraction):
            at[MOMENT] = Fraction(value)
        if len(words) > 1 and {*words} & {*run.words.state}:
            dense = entries_of(run, value)
            if dense is None:
                at |= dict.fromkeys(words, UNKNOWN)
            else:
                at |= dict(zip(words, dense, strict=False))
        elif len(words) == 1 and words[0] in run.words.state:
            at[words[0]] = value
    if is_another(run, call, ()):
        run.memory.misused = True
    if not run.memory.stepping and any(not in_usual_order(run, one) for one in entries.values()):
        run.memory.misused = True
    result = _returned(run, judged, at)
    for k, part in enumerate(out):
        value = result
        if len(out) > 1 and isinstance(result, Table):
            value = result.entries.get((k + run.language.first,), UNKNOWN)
        _store(run, part, value, env)
    return result


def _writes_over(run: Run, judged: JudgedFunction, call: Term, env: dict[str, Any]) -> bool:
    """Whether a call fills an array that it reads, or one twice: rate(y, y), rate(y, y + 1)."""
    pairs = [*zip(judged.takes, call.parts, strict=False)]
    filled = [(k, part) for k, (name, part) in enumerate(pairs) if name in judged.fills]
    for k, part in filled:
        for other, (name, given) in enumerate(pairs):
            value = known_value(run, given, env)
            array = isinstance(value, Table) or name in {*judged.places, *judged.fills}
            same = isinstance(value, Table) and value is known_value(run, part, env)
            if other != k and array and (same or _share(run, part, given)):
                return True
    return False


def _share(run: Run, part: Term, given: Term) -> bool:
    """Whether two arguments are the same array, or parts of one that nothing here keeps apart."""
    rows = part.kind == given.kind == "entry" and "&" not in part.text + given.text
    if rows and part.parts[0] == given.parts[0] and part.parts[1] != given.parts[1]:
        return False  # z[0] and z[1]
    return not {*_arrays(run, part)}.isdisjoint(_arrays(run, given))


def _arrays(run: Run, part: Term, seen: frozenset[str] = frozenset()) -> Iterator[str]:
    """Arrays and fields that an argument is or is a part of: y of &y[1], y + 1 and double *p = y.

    What a call gives is another array: ``copy(y)``.
    """
    if part.kind == "field":
        yield part.text
    elif part.kind == "name" and re.match(rf"[&*(\s]*{re.escape(part.name)}\b", part.text):
        yield part.name
        for one in run.pointers.get(part.name, ()) if part.name not in seen else ():
            yield from _arrays(run, one, seen | {part.name})
    elif part.kind == "entry":
        yield from _arrays(run, part.parts[0], seen)
    elif part.kind in ("binary", "block", "other"):
        for one in part.parts:
            yield from _arrays(run, one, seen)


def find_vectors(
    run: Run, block: Term, env: Mapping[str, Any], done: Set[str] = frozenset()
) -> None:
    """Names that are arrays: those with entries, and those that are passed for one."""
    inner = {one.name for one in block.all() if one.kind == "call"} - done
    for name in sorted(inner & run.own.keys()):
        find_vectors(run, run.own[name].body, env, done | inner)
    for one in block.all():
        handle = env.get(one.name) if one.kind == "call" else None
        if isinstance(handle, Handle) and handle.body is not None and one.name in inner:
            find_vectors(run, handle.body, env, done | inner)
            run.memory.called_in |= handle.body.names()
            for name, part in zip(handle.takes, one.parts, strict=False):
                if name in run.memory.vectors:
                    _holds_vector(run, part, run.memory.sizes.get(name))
    for one in block.all():
        if one.kind in ("entry", "field"):
            run.memory.vectors.add(root_of(one))
        if one.kind == "call" and (known := run.judged.get(one.name)) is not None:
            for name, part in zip(known.takes, one.parts, strict=False):
                if (size := len(known.meanings.get(name, ()))) > 1:
                    _holds_vector(run, part, size)
        if one.kind == "call" and one.name in run.own:
            for name, part in zip(run.own[one.name].takes, one.parts, strict=False):
                if name in run.memory.vectors:
                    _holds_vector(run, part, run.memory.sizes.get(name))
        if one.kind == "call" and run.language.brackets and one.name not in run.own:
            run.memory.vectors.add(one.name)
    for one in block.all():
        if one.kind == "set" and (
            one.parts[0].name in run.memory.vectors or one.parts[0].kind == "list"
        ):
            _holds_vector(run, one.parts[1], run.memory.sizes.get(one.parts[0].name))


def _holds_vector(run: Run, part: Term, size: int | None) -> None:
    """Take what a part names for an array, or for an array of such."""
    if part.kind == "name":
        run.memory.vectors.add(part.name)
        if size is not None and size != len(run.words.state):
            run.memory.sizes[part.name] = size
    elif part.kind == "entry" and [p.kind in ("whole", "range") for p in part.parts[1:]] == [False]:
        run.memory.rows.add(root_of(part))


def forget(run: Run, block: Term, env: dict[str, Any], value: Any = None) -> None:
    """Take away what a block changes."""
    for one in block.all():
        roots: set[str] = set()
        if one.kind == "set":
            roots = {root_of(t) for t in targets_of(one.parts[0])}
        if one.kind == "call" and one.name == "append" and one.parts:
            roots = {root_of(one.parts[0])}
        if one.kind == "call" and (known := run.judged.get(one.name)) is not None:
            roots = {root_of(p) for n, p in zip(known.takes, one.parts, strict=False)
                     if n in known.fills}  # fmt: skip
        if one.kind == "call" and one.name in run.own:
            other = run.own[one.name]
            if not other.gives:
                roots = {root_of(p) for n, p in zip(other.takes, one.parts, strict=False)
                         if n in other.shared}  # fmt: skip
                roots |= other.fills & env.keys()
        for root in roots:
            if isinstance(env.get(root), Table):
                run.memory.vectors.add(root)
            if value is not None:
                env[root] = value
            else:
                env.pop(root, None)


def read_name(run: Run, root: str, key: tuple[Any, ...], env: dict[str, Any]) -> Any:
    """What a name is, or an entry of it; a random number where nobody has set it."""
    if root not in env:
        base, _, last = root.rpartition(".")
        if isinstance(inner := env.get(base), Table) and (last,) in inner.entries:
            return read_name(run, base, (last, *key), env)  # p["g"] of a table
        word = meaning_of(run, root)
        if not key and (root in run.judged or root in run.own):
            return Handle((), None, {"": root})
        if (made := run.lists.get(root)) is not None and not word:
            env[root] = value_of(run, made, {})
        elif key or root in run.memory.vectors:
            env[root] = Table(root, size=run.memory.sizes.get(root))
        elif root.rpartition(".")[2] in ("pi", "M_PI"):
            env[root] = PI
        elif word and word not in run.words.state:
            env[root] = number("word", word)
        else:
            new = Fraction(FAR + 7) if root in run.memory.places else number(run.memory.count, root)
            env[root] = new
            run.memory.initial[new] = (root, ())
    value = env[root]
    if not key:
        return value
    if not isinstance(value, Table):
        return UNKNOWN
    if any(isinstance(place, Unknown) for place in key):
        return UNKNOWN
    keys = _keys(run, root, value, key)
    if keys is None:
        return entry_of(run, value, _from_end(run, value, key))
    if key == (None,):
        return value
    return row_of(run, [entry_of(run, value, one) for one in keys])


def _keys(run: Run, root: str, table: Table, key: tuple[Any, ...]) -> list[tuple[Any, ...]] | None:
    """Places of a row or a part of an array; None for a single one."""
    key = _from_end(run, table, key)
    whole = [k for k, place in enumerate(key) if place is None or isinstance(place, range)]
    inner = (k for k in table.entries if len(k) == len(key) + 1 and k[:-1] == key)
    if not whole and (root in run.memory.rows or any(isinstance(k[-1], int) for k in inner)):
        key, whole = (*key, None), [len(key)]
    if not whole:
        return None
    if len(whole) > 1:
        raise NotFollowedError
    size = table.size if table.size and len(key) == 1 else len(run.words.state)
    axis, places = whole[0], key[whole[0]]
    if places is None:
        places = range(run.language.first, run.language.first + size)
    elif places.stop == FAR:
        places = range(places.start, run.language.first + size)
    return [(*key[:axis], k, *key[axis + 1 :]) for k in places]


def _from_end(run: Run, table: Table, key: tuple[Any, ...]) -> tuple[Any, ...]:
    """A place that counts from the end: of a list of times, that is the present one."""
    if run.language.first or not any(isinstance(k, int) and k < 0 for k in key):
        return key
    end = table.size or FAR + 8 + table.added
    return tuple(k + end if isinstance(k, int) and k < 0 else k for k in key)


def _path(run: Run, term: Term, env: dict[str, Any]) -> tuple[str, tuple[Any, ...]]:
    if term.kind == "name":
        return term.name, ()
    if term.kind == "call":
        return term.name, tuple(_place(run, p, env) for p in term.parts)
    if term.kind == "field":
        root, key = _path(run, term.parts[0], env)
        return root, (*key, term.name)
    if term.kind in ("entry", "item"):
        root, key = _path(run, term.parts[0], env)
        return root, (*key, *(_place(run, p, env) for p in term.parts[1:]))
    raise NotFollowedError


def _place(run: Run, term: Term, env: dict[str, Any]) -> Any:
    if term.kind == "whole":
        return None
    if term.kind == "range":
        ends = [_place(run, part, env) for part in term.parts]
        if not isinstance(ends[0], int) or not isinstance(ends[1], int | None):
            return UNKNOWN
        return range(ends[0], FAR if ends[1] is None else ends[1] + 1)
    value = value_of(run, term, env)
    if isinstance(value, Fraction) and value.denominator == 1:
        return int(value)
    return UNKNOWN


def _as_word(run: Run, name: str, value: Any) -> Any:
    """The number of a word of the scene for one that is written out, and that it can have."""
    word = meaning_of(run, name)
    if not word or run.memory.stepping:
        return value
    if word in run.words.parameters and _is_argument(run, word, value):
        return number("word", word)
    if not isinstance(value, Literal):
        return value
    known = word in run.words.state or not is_possible(run, word, value)
    return Literal(value) if known else number("word", word)


def _is_argument(run: Run, word: str, value: Any) -> bool:
    """Whether a parameter has an entry of an array, and nothing but its name says what that is.

    m, l = x of a function that fits parameters; no y[1] of an array that a judged function takes.
    """
    if run.language.name != "Python" or not isinstance(value, Fraction):
        return False
    root, key = run.memory.initial.get(value, ("", ()))
    calls = [one for one in run.block.all() if one.kind == "call"]
    handed = {root_of(part) for call in calls if call.name in run.judged for part in call.parts}
    handed |= {n for name in handed for line in run.definitions.get(name, ())
               for n in line.parts[1].names()}  # fmt: skip
    said = {meaning_of(run, name) for name in root.split(".")} - {"", word}
    return bool(key) and not said and root not in handed | {call.name for call in calls}


def _store(run: Run, target: Term, value: Any, env: dict[str, Any]) -> None:
    root, key = _path(run, target, env)
    if not key:
        if isinstance(value, Table):
            entries_of(run, value) if value.name and not value.entries else None
            value = Table("" if value.name != "parameters" else value.name,
                          dict(value.entries), value.size)  # fmt: skip
        env[root] = _as_word(run, root, value)
        return
    table = env.get(root)
    if not isinstance(table, Table):
        table = env[root] = Table(root)
    if any(isinstance(place, Unknown) for place in key):
        env[root] = UNKNOWN
        return
    keys = _keys(run, root, table, key)
    dense = entries_of(run, value) if isinstance(value, Table) else None
    if keys is None and dense is not None:
        key = _from_end(run, table, key)
        keys = [(*key, k + run.language.first) for k in range(len(dense))]
    if keys is None:
        table.entries[_from_end(run, table, key)] = value
        return
    if dense is None or len(dense) != len(keys):
        env[root] = UNKNOWN
        return
    table.entries.update(zip(keys, dense, strict=True))


def attempt(run: Run, line: Term, env: dict[str, Any]) -> bool:
    """Run a line; whether it uses the function as it is."""
    run.memory.misused = False
    try:
        execute(run, line, env)
    except (NotFollowedError, RecursionError, ZeroDivisionError):
        forget(run, line, env, UNKNOWN)
    return not run.memory.misused


def execute(run: Run, term: Term, env: dict[str, Any]) -> Any:
    """Run statements; what they return."""
    if term.kind in ("loop", "case") and _only_turns(run, term, env):
        for one in (one for one in term.all() if one.kind == "set"):
            _keep_turned(run, value_of(run, one.parts[0], env))
        return None
    match term.kind:
        case "block":
            for part in term.parts:
                result = execute(run, part, env)
                if result is not None and part.kind in ("return", "block", "loop"):
                    return result
            return None
        case "return":
            return value_of(run, term.parts[0], env) if term.parts else UNKNOWN
        case "set":
            _assign(run, term, env)
            return None
        case "loop":
            _turns(run, term, env)
            return None
        case "case":
            if run.memory.stepping and any(
                t.kind == "call" and t.name in functions_in(run, env) for t in term.all()
            ):
                raise NotFollowedError
            _stay(run, term)
            forget(run, term, env, UNKNOWN)
            return None
        case "jump":
            _stay(run, term, always=True)
            return None
        case "other":
            forget(run, term, env, UNKNOWN)
            if term.names() and run.memory.stepping:
                _poison(term, env)
            return None
        case _:
            value_of(run, term, env)
            return None


def _stay(run: Run, term: Term, *, always: bool = False) -> None:
    """Follow no line behind which others may be left out, but for one that ends the whole loop."""
    inside = run.memory.depth > 0
    if not run.memory.stepping and not inside:
        return
    for one in term.all():
        ends = one.name == "break" or (one.kind == "return" and all(map(_is_kept, one.parts)))
        if one.kind in ("jump", "return") and (inside or always or not ends):
            raise NotFollowedError


def _is_kept(term: Term) -> bool:
    """Whether something is a name, a part of one or some of these: y, no -y."""
    if term.kind in ("entry", "field"):
        return _is_kept(term.parts[0])
    return term.kind in ("name", "list", "number") and all(map(_is_kept, term.parts))


def _poison(term: Term, env: dict[str, Any]) -> None:
    """Take what a call may change as unknown."""
    for name in term.names() & env.keys():
        if isinstance(env[name], Table):
            env[name] = UNKNOWN
    for part in (p for p in term.parts if p.text.startswith("&")):
        env[root_of(part)] = UNKNOWN


def _assign(run: Run, term: Term, env: dict[str, Any]) -> None:
    target, value = term.parts
    if target.kind == "list":
        _several(run, target.parts, value, env)
        return
    if value.kind == "handle":
        env[root_of(target)] = handle_of(run, value, env)
        return
    made = value_of(run, value, env)
    if term.name:
        before = value_of(run, target, env)
        made = _operation(run, term.name, before, made)
        if isinstance(before, Table) and target.kind == "name" and run.language.fills:
            _fill(run, before, made)
            return
    _give(run, target, value, made, env)


def _give(run: Run, target: Term, part: Term, value: Any, env: dict[str, Any]) -> None:
    """Give a target the value of a formula: z = y is the same array, z = y.copy() another."""
    same = not run.language.copies and part.kind == "name" and part.text == part.name
    if same and target.kind == "name" and isinstance(value, Table):
        env[target.name] = value
        return
    seen = _part_of(run, part, value, env) if target.kind == "name" else None
    if seen is not None:
        env[target.name] = seen
        return
    _store(run, target, _moving(run, part, value, env), env)


def _part_of(run: Run, part: Term, value: Any, env: Mapping[str, Any]) -> Table | None:
    """A part of an array of NumPy, which sees what the array becomes: v = y[2:]."""
    whole = env.get(root_of(part)) if part.kind == "entry" and run.language.fills else None
    if not isinstance(whole, Table) or not isinstance(value, Table) or len(part.parts) != 2:
        return None
    if part.parts[0].kind != "name" or part.parts[1].kind != "range" or not value.size:
        return None
    start = part.parts[1].parts[0]
    if start.kind != "number" or not start.name.isdigit():
        return None
    seen = SeenEntries(whole.entries, int(start.name), value.size)
    return (
        Table(value.name, seen, value.size) if all(key in seen for key in value.entries) else None
    )


def _fill(run: Run, table: Table, value: Any) -> None:
    """Give an array other entries, wherever it is seen: y += x."""
    dense = entries_of(run, value) or [UNKNOWN] * (table.size or len(run.words.state))
    table.entries.update({(k + run.language.first,): one for k, one in enumerate(dense)})


def _moving(run: Run, term: Term, value: Any, env: Mapping[str, Any]) -> Any:
    """What a formula gives, where nothing follows it: whether it is made of what moves."""
    if not isinstance(value, Unknown):
        return value
    names = term.names()
    moves = any(env.get(n) is MOVING or _is_state(run, n, env.get(n)) for n in names)
    return MOVING if moves else value


def _is_state(run: Run, name: str, value: Any) -> bool:
    """Whether a name is the state, or an entry of it."""
    whole = isinstance(value, Table) and value.size == len(run.words.state) and bool(value.name)
    return meaning_of(run, name) in run.words.state or (whole and value.name != "parameters")


def _several(run: Run, targets: Sequence[Term], value: Term, env: dict[str, Any]) -> None:
    if value.kind == "list" and len(value.parts) == len(targets):  # a, b = b, a
        each = [value_of(run, part, env) for part in value.parts]
        for one, part, other in zip(targets, value.parts, each, strict=True):
            _give(run, one, part, other, env)
        return
    made = value_of(run, value, env)
    entries = entries_of(run, made) if isinstance(made, Table) else None
    for k, one in enumerate(targets):
        known = entries is not None and k < len(entries)
        _store(run, one, entries[k] if known and entries is not None else UNKNOWN, env)


def _turns(run: Run, term: Term, env: dict[str, Any]) -> None:
    limits, body = term.parts
    ends = [value_of(run, one, env) for one in limits.parts]
    known = all(isinstance(e, Fraction) and e.denominator == 1 for e in ends)
    if len(ends) != 2 or not known or not term.name:
        raise NotFollowedError  # a random number is no count of turns
    first, last = (int(e) for e in ends)
    if last - first > TURNS:
        raise NotFollowedError
    run.memory.depth += 1
    try:
        _stay(run, body)
        for turn in range(first, last + 1):
            env[term.name] = Fraction(turn)
            execute(run, body, env)
    finally:
        run.memory.depth -= 1


def value_of(run: Run, term: Term, env: dict[str, Any]) -> Any:
    """The value of a formula; numbers that may be the step of an integrator are kept."""
    value = _evaluated(run, term, env)
    if isinstance(value, Fraction) and _may_be_a_step(run, term, value):
        run.memory.scalars.add(Fraction(value))
    return value


def known_value(run: Run, term: Term, env: dict[str, Any]) -> Any:
    """The value of a formula, unknown where it is not followed."""
    try:
        return value_of(run, term, env)
    except (NotFollowedError, RecursionError, ZeroDivisionError):
        return UNKNOWN


def _may_be_a_step(run: Run, term: Term, value: Fraction) -> bool:
    match term.kind:
        case "name" | "field":
            counts = value.denominator == 1 and not isinstance(value, Literal)
            small = not isinstance(value, Literal) or value < 1 or term.name in STEPS
            return small and not counts and not meaning_of(run, term.name)
        case "number":
            return value < 1
        case "binary":
            return term.name == "-" and not isinstance(value, Literal)
    return False


def _evaluated(run: Run, term: Term, env: dict[str, Any]) -> Any:
    match term.kind:
        case "number":
            try:
                return Literal(term.name)
            except ValueError:
                return UNKNOWN
        case "name":
            return read_name(run, term.name, (), env)
        case "entry" | "field" | "item":
            try:
                return read_name(run, *_path(run, term, env), env)
            except NotFollowedError:
                return UNKNOWN
        case "minus":
            return _operation(run, "*", Literal(-1), value_of(run, term.parts[0], env))
        case "binary":
            left, right = (value_of(run, part, env) for part in term.parts)
            return _operation(run, term.name, left, right)
        case "integer":
            return _held(term, value_of(run, term.parts[0], env))
        case "list":
            return _list(run, term, env)
        case "handle":
            return handle_of(run, term, env)
        case "block":
            return _run_last(run, term, env)
        case "call":
            return _call(run, term, env)
        case "turn":
            return _turned(run, term, env)
        case "choice":
            _stay(run, term)
            values = [
                UNKNOWN if one.kind == "jump" else value_of(run, one, env) for one in term.parts
            ]
            forget(run, term, env, UNKNOWN)
            if term.name == EITHER:
                return _either([v for v, part in zip(values, term.parts, strict=True)
                                if part.kind != "choice"])  # fmt: skip
        case "set" | "case" | "loop" | "other" | "jump":
            execute(run, term, env)
    return UNKNOWN


def _either(values: Sequence[Any]) -> Any:
    """One of several numbers, first one that a parameter may not have; unknown for others."""
    written = [v for v in values if isinstance(v, Literal)]
    below = next((v for v in written if v <= 0), None)
    if below is not None:
        return below
    return written[0] if written and len(written) == len(values) else UNKNOWN


def _turned(run: Run, term: Term, env: dict[str, Any]) -> Any:
    """An angle brought back into one turn is the angle itself."""
    angle, *turns = term.parts
    value = value_of(run, angle, env)
    results = any(one.kind == "call" and one.name in run.judged for one in angle.all())
    run.memory.misused |= results and not run.memory.stepping
    _keep_turned(run, value)
    return value if all(_is_turn(run, one, env) for one in turns) else UNKNOWN


def _held(term: Term, value: Any) -> Any:
    """What a type of integers holds of a number: 0 of 0.01; nothing is said of one too large."""
    least, largest = map(int, term.name.split())
    if not isinstance(value, Literal):
        part = term.parts[0]
        counts = isinstance(value, Fraction) and value.denominator == 1
        return value if counts or isinstance(value, Unknown) or part.name == "*" else ROUNDED
    return Literal(int(value)) if least <= int(value) <= largest else ROUNDED


def _run_last(run: Run, term: Term, env: dict[str, Any]) -> Any:
    """The value of a block is what it returns, or that of its last line."""
    for part in term.parts[:-1]:
        execute(run, part, env)
    last = term.parts[-1] if term.parts else Term("other")
    if last.kind == "return":
        return execute(run, last, env)
    if last.kind == "set":
        execute(run, last, env)
        return value_of(run, last.parts[0], env)
    return value_of(run, last, env)


def _list(run: Run, term: Term, env: dict[str, Any]) -> Any:
    if any(part.kind == "set" for part in term.parts):
        record = Table()
        for part in term.parts:
            inner = part.parts[0] if part.kind == "set" else part
            value = value_of(run, part.parts[1] if part.kind == "set" else part, env)
            record.entries[(inner.name,)] = _as_word(run, inner.name, value)
        return record
    values: list[Any] = []
    for part in term.parts:
        value = value_of(run, part, env)
        values += (entries_of(run, value) or [UNKNOWN]) if isinstance(value, Table) else [value]
    return Table("", {(k + run.language.first,): v for k, v in enumerate(values)}, len(values))


def _operation(run: Run, sign: str, left: Any, right: Any) -> Any:
    if isinstance(left, Fraction) and isinstance(right, Fraction):
        literal = isinstance(left, Literal) and isinstance(right, Literal)
        kind = Literal if literal else Fraction
        match sign:
            case "+":
                return kind(Fraction(left) + Fraction(right))
            case "-":
                return kind(Fraction(left) - Fraction(right))
            case "*":
                return kind(Fraction(left) * Fraction(right))
            case "/" if right:
                return kind(Fraction(left) / Fraction(right))
            case "^" if literal:
                raised = computed("pow", [left, right])
                return UNKNOWN if raised is None else kind(raised)
            case "div" if literal and right:
                return kind(int(Fraction(left) / Fraction(right)))
            case "%" if literal and right:
                return kind(Fraction(left) % Fraction(right))
            case "^" if right in (1, 2, 3):
                return kind(Fraction(left) ** int(right))
        return ROUNDED if sign in WHOLE else UNKNOWN
    if (
        sign in WHOLE
        or left is ROUNDED
        or (right is ROUNDED and not (sign == "/" and run.language.integers))
    ):
        return ROUNDED
    if OUTSIDE in (left, right):
        return _with_outside(sign, left, right)
    a, b = entries_of(run, left), entries_of(run, right)
    if a is None or b is None:
        return UNKNOWN
    if isinstance(left, Table) and isinstance(right, Table):
        if len(a) != len(b) or sign not in "+-":
            return UNKNOWN
        pairs = zip(a, b, strict=True)
    elif isinstance(left, Table) and sign in "*/":
        pairs = ((one, right) for one in a)  # type: ignore[assignment]
    elif isinstance(right, Table) and sign == "*":
        pairs = ((left, one) for one in b)  # type: ignore[assignment]
    else:
        return UNKNOWN
    made = [_operation(run, sign, one, other) for one, other in pairs]
    return row_of(run, made)


def _with_outside(sign: str, left: Any, right: Any) -> Any:
    """What is made of a number from outside: any, but where its sign is turned."""
    others = [one for one in (left, right) if one is not OUTSIDE]
    if not all(isinstance(one, Literal) for one in others):
        return UNKNOWN
    turned = any(one < 0 for one in others) or (sign == "-" and right is OUTSIDE)
    return MOVING if turned and sign != "+" else OUTSIDE


def _spread(run: Run, term: Term, env: dict[str, Any]) -> Term:
    """A call with its arguments one by one: rate(t, y, *p)."""
    if not any(map(_is_spread, term.parts)):
        return term
    parts: list[Term] = []
    for part in term.parts:
        if not _is_spread(part):
            parts.append(part)
            continue
        inner = part.parts[0] if part.kind == "star" else Term("name", part.name)
        value = value_of(run, inner, env)
        if inner.kind == "list":
            parts += inner.parts
        elif isinstance(value, Table) and value.size:
            places = (Term("number", str(k + run.language.first)) for k in range(value.size))
            parts += (Term("item", "", (inner, place), inner.text) for place in places)
        else:
            # Nothing says the order of what a call gives: f(*p.values()).
            uses = term.name in run.judged or term.name in run.users
            run.memory.misused |= uses and _whole_call(run, inner).kind in ("call", "other")
            break
    return replace(term, parts=tuple(parts))


def _whole_call(run: Run, term: Term) -> Term:
    """What functions that keep the order of its entries are given."""
    keeps = run.language.keeps or ()
    while term.kind == "call" and term.name in keeps and len(term.parts) == 1:
        (term,) = term.parts
    return term


def _is_spread(part: Term) -> bool:
    """Whether it stands for several arguments: ``*p``, ``p{:}``."""
    return part.kind == "star" or (part.kind == "call" and part.text == f"{part.name}{{:}}")


def _append(run: Run, term: Term, env: dict[str, Any]) -> Any:
    """A value at the end of a list of times."""
    target, part = term.parts
    value, root = value_of(run, part, env), root_of(target)
    if target.kind == "name" and not isinstance(env.get(root), Table):
        env[root] = Table(root)
    if isinstance(table := env.get(root), Table) and target.kind == "name":
        table.size, table.added = None, table.added + 1
        place = Term("number", str(FAR + 7 + table.added))
        _store(run, Term("entry", "", (target, place)), value, env)
    return UNKNOWN


def _call(run: Run, term: Term, env: dict[str, Any]) -> Any:
    term = _spread(run, term, env)
    known = env.get(term.name)
    if isinstance(known, Handle):
        return _of_handle(run, known, term, env)
    if term.name in run.judged:
        return call_judged(run, term, env)
    functions = {*run.own, *KNOWN, *ROUNDS.get(run.language.name, ())}
    array = run.language.brackets and term.name in run.memory.vectors - functions
    if term.parts and (isinstance(known, Table) or (array and known is None)):
        return read_name(run, *_path(run, term, env), env)
    if term.name in run.own:
        return _inlined(run, term, env)
    if term.name == "memcpy" and len(term.parts) == 3:
        _store(run, term.parts[0], value_of(run, term.parts[1], env), env)
        return UNKNOWN
    if term.name == "append" and len(term.parts) == 2 and not run.language.first:
        return _append(run, term, env)
    values = [value_of(run, part, env) for part in map(partial(_given, run), term.parts)]
    if term.name == "len" and isinstance(values[0], Table):
        return Fraction(values[0].size or len(run.words.state))
    if term.name in ("pow", "powf") and len(values) == 2:
        return _operation(run, "^", *values)
    if term.name == "float" and run.language.pointers and len(values) == 1:  # it rounds
        single = all(judged.single for judged in run.judged.values())
        return values[0] if single or isinstance(values[0], Literal) else UNKNOWN
    if run.language.pointers and term.name.rpartition(".")[2] not in run.language.shows:
        _poison(term, env)
    if term.name in ROUNDS.get(run.language.name, ()):
        known_number = _computed(run, term.name, values)
        return ROUNDED if known_number is None else known_number
    if term.name in IMPURE:
        return MOVING
    if term.name in DRAWN:
        return _drawn(run, values)
    if (known_number := _computed(run, term.name, values)) is not None:
        return known_number
    if values and all(isinstance(v, Literal) for v in values) and term.name not in MADE:
        return Literal(number("call", term.name, *values))
    if not values and run.memory.stepping:  # micros()
        return 2 + number(run.memory.count, term.name)
    return UNKNOWN


def _drawn(run: Run, values: Sequence[Any]) -> Any:
    """Any number, but one below zero where a bound of it is, and another one in each step."""
    numbers = [v for one in values for v in (entries_of(run, one) or ()) if isinstance(v, Literal)]
    if run.memory.stepping or run.language.name != "Python":
        return MOVING
    return next((v for v in numbers if v < 0), OUTSIDE)


def _computed(run: Run, name: str, values: Sequence[Any]) -> Literal | None:
    """The number that a call makes of numbers, or of a list of them, that are written out."""
    listed = len(values) == 1 and isinstance(values[0], Table)
    entries = (values[0].entries.values() if values[0].size else ()) if listed else values
    if not entries or not all(isinstance(v, Literal) for v in entries):
        return None
    made = computed(name, [*entries], in_list=listed)
    return None if made is None else Literal(made)


def _given(run: Run, part: Term) -> Term:
    """What a call is given: an argument by its name sets nothing, but for C, which has none."""
    return part.parts[1] if part.kind == "set" and not run.language.pointers else part


def _of_handle(run: Run, handle: Handle, term: Term, env: dict[str, Any]) -> Any:
    if handle.body is None:
        return _named(run, handle.inside[""], term, env)
    inside = dict(handle.inside)
    inside |= {n: value_of(run, p, env) for n, p in zip(handle.takes, term.parts, strict=False)}
    return value_of(run, handle.body, inside)


def _named(run: Run, name: str, term: Term, env: dict[str, Any]) -> Any:
    other = replace(term, name=name)
    return call_judged(run, other, env) if name in run.judged else _inlined(run, other, env)


def _inlined(run: Run, term: Term, env: dict[str, Any]) -> Any:
    if run.memory.depth > DEPTH:
        raise NotFollowedError
    one = run.own[term.name]
    inside: dict[str, Any] = {}
    for name, part in zip(one.takes, term.parts, strict=False):
        if part.kind == "absent":
            continue
        value = value_of(run, part, env)
        if isinstance(value, Table) and run.language.first and one.gives:
            entries_of(run, value) if value.name and not value.entries else None
            value = Table("", dict(value.entries), value.size)
        inside[name] = value
    own = {*inside, *one.local}
    shared = {} if one.gives else {n: v for n, v in env.items() if n not in own}
    inside = {**shared, **inside}
    called = {n: root_of(p) for n, p in zip(one.takes, term.parts, strict=False) if root_of(p)}
    for name, other in called.items():  # state.w, where the caller says s.w
        inside |= {f"{name}.{n.removeprefix(f'{other}.')}": v for n, v in env.items()
                   if n.startswith(f"{other}.")}  # fmt: skip
    run.memory.vectors |= {n for n, v in inside.items() if isinstance(v, Table)}
    run.memory.depth += 1
    try:
        result = execute(run, one.body, inside)
    finally:
        run.memory.depth -= 1
    for name in one.fills & shared.keys():
        env[name] = inside.get(name, UNKNOWN)
    for name, (base, dot, last) in ((n, n.partition(".")) for n in one.fills):
        if dot and name in inside:
            env[f"{called.get(base, base)}.{last}"] = inside[name]
    for name, part in zip(one.takes, term.parts, strict=False):
        if name in one.shared and not isinstance(inside.get(name), Table):
            _store(run, part, inside[name], env)
    run.memory.explained.add(term.name)
    if one.gives:
        given = [read_name(run, n, (), inside) for n in one.gives]
        return given[0] if len(given) == 1 else Table(
            "", {(k + run.language.first,): v for k, v in enumerate(given)}, len(given)
        )  # fmt: skip
    return UNKNOWN if result is None else result
