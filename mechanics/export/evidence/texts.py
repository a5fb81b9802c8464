"""The C files of a folder, parsed: every way in which a compiler may read them."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import combinations
from typing import Any

from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.errors import ExpressionError
from mechanics.program.c.conditionals import asked_names
from mechanics.program.c.library import FAR, FUNCTIONS, FUSED, SINCOS
from mechanics.program.c.parse import Source, linked, parse, reached
from mechanics.program.c.text import preprocess

FMA = frozenset({"__FMA__", "__ARM_FEATURE_FMA", "FP_FAST_FMA", "FP_FAST_FMAF"})
ASKED = FMA | {"__GNUC__", "__clang__"}
"""Names of compilers that conditions in generated code ask for."""
CHOICE = "_INLINE_SINE"
"""Ends the name that whoever builds the folder may define."""
GUARD = "MECHANICS_"
"""Begins the names of guards of headers."""

STAND_IN = frozenset({*FAR, *FUNCTIONS, *FUSED, *SINCOS})
"""Functions that are known by name, whatever their text: it is checked on its own."""

KNOWN = STAND_IN | {"isfinite", "NAN", "INFINITY"}


def sources(
    kernels: Sequence[Kernel], texts: Mapping[str, str]
) -> dict[tuple[str, str], Source | ExpressionError]:
    """Sources by file and configuration; those that read the same as the first are left out.

    Parameters
    ----------
    texts : mapping of str to str
        Every ``.c`` and ``.h`` file of the folder.
    """
    kinds = {kernel.file: kernel.kind for kernel in kernels}
    files = list(kinds)
    headers = {name: text for name, text in texts.items() if name.endswith(".h")}
    found: dict[tuple[str, str], Source | ExpressionError] = {}
    for file in files:
        # Of a text that may be read in a way that is not looked at, no way is.
        for name in (file, *headers):
            if name in texts and (words := odd_conditions(texts[name], name)):
                found.setdefault((file, ""), ExpressionError(words))
    files = [file for file in files if (file, "") not in found]
    for title, defined in _readings(files, texts, headers):
        parsed = {file: _parsed(file, texts, headers, defined) for file in files}
        for file in files:
            same = [parsed[other] for other in files if kinds[other] == kinds[file]]
            one = _linked(parsed[file], same)
            if not title or not _same(one, found[file, ""]):
                found[file, title] = one
    return found


def is_read_both_ways(name: str) -> bool:
    """Whether a file is read with and without a macro."""
    return name in ASKED or name.endswith(CHOICE)


def odd_conditions(text: str, file: str, known: Callable[[str], bool] = is_read_both_ways) -> str:
    """Conditions on names that are not known, in words; empty if there are none."""
    try:
        asked = asked_names(text, file, GUARD)
    except ExpressionError as error:
        return str(error)
    odd = [f"{one.name} in line {one.line}" for one in asked if not known(one.name)]
    return f"{file}: what is compiled depends on {', '.join(odd)}" if odd else ""


def _readings(
    files: Sequence[str], texts: Mapping[str, str], headers: Mapping[str, str]
) -> list[tuple[str, Mapping[str, str]]]:
    """Every combination of the names that are asked for, once for each text that comes of it."""
    asked: dict[str, set[str]] = {file: set() for file in files if file in texts}
    seen: dict[tuple[str, frozenset[str]], str] = {}
    for file, names in asked.items():
        waiting = [frozenset[str]()]
        while waiting:
            given = waiting.pop()
            if (file, given) in seen:
                continue
            try:
                read = preprocess(texts[file], file, headers, dict.fromkeys(given, "1"))
            except ExpressionError as error:
                seen[file, given] = str(error)
                continue
            seen[file, given] = read.text
            names |= {name for name in read.asked if is_read_both_ways(name)}
            waiting += [frozenset(c) for n in range(len(names) + 1)
                        for c in combinations(sorted(names), n)]  # fmt: skip
    found: dict[tuple[str, ...], frozenset[str]] = {}
    every = sorted(set().union(*asked.values()))
    for count in range(len(every) + 1):
        for chosen in map(frozenset, combinations(every, count)):
            key = tuple(seen.get((f, chosen & names), "") for f, names in asked.items())
            found.setdefault(key, chosen)
    return [(" and ".join(sorted(c)), dict.fromkeys(c, "1")) for c in found.values()]


def _parsed(
    file: str, texts: Mapping[str, str], headers: Mapping[str, str], defined: Mapping[str, str]
) -> Source | ExpressionError:
    if file not in texts:
        return ExpressionError(f"{file}: there is no such file")
    try:
        source = parse(texts[file], file, headers, defined)
        _own_names(source)
        return source
    except ExpressionError as error:
        return error


def _own_names(source: Source) -> None:
    """Refuse what gives a known name another meaning."""
    for name in sorted(KNOWN & set(source.macros)):
        if source.macros[name] != f"mechanics_{name}" or source.macros[name] not in FUNCTIONS:
            raise ExpressionError(f"{source.file}: macro {name} gives a known name a new meaning")
    for name in sorted(KNOWN & set(source.prototypes)):
        for node in source.prototypes[name]:
            where = str(node.coord.file)
            if not name.startswith("mechanics_") or not where.endswith("_sine.h"):
                raise ExpressionError(f"{node.coord}: {name} is known, and declared anew")


def _linked(
    own: Source | ExpressionError, others: Sequence[Source | ExpressionError]
) -> Source | ExpressionError:
    """A file with the others that it calls; one that cannot be read spoils only itself."""
    if isinstance(own, ExpressionError):
        return own
    try:
        return linked(own, *(one for one in others if one is not own and isinstance(one, Source)))
    except ExpressionError as error:
        return error


def _same(one: Source | ExpressionError, other: Source | ExpressionError | None) -> bool:
    if isinstance(one, ExpressionError) or not isinstance(other, Source):
        return isinstance(one, ExpressionError) and str(one) == str(other)
    return one.functions.keys() == other.functions.keys() and all(
        _alike(node, other.functions[name])
        for name, node in one.functions.items()
        if name not in STAND_IN
    )


def _alike(one: Any, two: Any) -> bool:
    """Whether two syntax trees are the same; a sum of hundreds of terms is as deep."""
    waiting = [(one, two)]
    while waiting:
        left, right = waiting.pop()
        names, others = left.children(), right.children()
        if type(left) is not type(right) or len(names) != len(others):
            return False
        if any(getattr(left, name) != getattr(right, name) for name in left.attr_names):
            return False
        for (name, child), (other, twin) in zip(names, others, strict=True):
            if name != other:
                return False
            waiting.append((child, twin))
    return True


def not_named(kernels: Sequence[Kernel], texts: Mapping[str, Source]) -> Iterable[str]:
    """Functions that are no kernel: what other files can call, and what no function calls."""
    known = {kernel.symbol for kernel in kernels}
    for file, source in texts.items():
        called = reached(source, known)
        for name, node in source.functions.items():
            static = "static" in (node.decl.storage or ()) and name in called
            if str(node.coord.file) == file and not static and name not in known:
                yield f"{file}: {name}"
