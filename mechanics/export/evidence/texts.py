"""The C files of a folder, parsed: every way in which a compiler may read them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from pycparser import c_generator

from mechanics.compiled.custody.kernel import Kernel
from mechanics.errors import ExpressionError
from mechanics.exact.c_library import FAR, FUNCTIONS, FUSED, SINCOS
from mechanics.exact.c_parse import Source, linked, parse

CONFIGURATIONS: tuple[tuple[str, Mapping[str, str]], ...] = (
    ("", {}),
    ("gcc", {"__GNUC__": "12", "__FMA__": "1"}),
    ("clang", {"__GNUC__": "4", "__clang__": "1", "__FMA__": "1"}),
    ("ARM", {"__GNUC__": "12", "__ARM_FEATURE_FMA": "1"}),
)
"""What compilers define, of the names that conditions in a text ask for."""

STAND_IN = frozenset({*FAR, *FUNCTIONS, *FUSED, *SINCOS})
"""Functions that are known by name, whatever their text: it is checked on its own."""


def sources(
    kernels: Sequence[Kernel], texts: Mapping[str, str]
) -> dict[tuple[str, str], Source | ExpressionError]:
    """Sources by file and configuration; those that read the same as the first are left out.

    Parameters
    ----------
    kernels : sequence of Kernel
    texts : mapping of str to str
        Every ``.c`` and ``.h`` file of the folder.
    """
    files = list(dict.fromkeys(kernel.file for kernel in kernels))
    headers = {name: text for name, text in texts.items() if name.endswith(".h")}
    found: dict[tuple[str, str], Source | ExpressionError] = {}
    for title, defined in CONFIGURATIONS:
        parsed = {file: _parsed(file, texts, headers, defined) for file in files}
        for file in files:
            one = _linked(file, parsed)
            first = found.get((file, ""))
            if not title or not _same(one, first):
                found[file, title] = one
        asked = {name for one in parsed.values() if isinstance(one, Source) for name in one.asked}
        if not any(asked.intersection(names) for _, names in CONFIGURATIONS):
            break
    return found


def _parsed(
    file: str, texts: Mapping[str, str], headers: Mapping[str, str], defined: Mapping[str, str]
) -> Source | ExpressionError:
    if file not in texts:
        return ExpressionError(f"{file}: there is no such file")
    try:
        return parse(texts[file], file, headers, defined)
    except ExpressionError as error:
        return error


def _linked(file: str, parsed: Mapping[str, Source | ExpressionError]) -> Source | ExpressionError:
    """A file with the others that it calls; one that cannot be read spoils only itself."""
    own = parsed[file]
    if isinstance(own, ExpressionError):
        return own
    others = [one for name, one in parsed.items() if name != file and isinstance(one, Source)]
    try:
        return linked(own, *others)
    except ExpressionError as error:
        return error


def _same(one: Source | ExpressionError, other: Source | ExpressionError | None) -> bool:
    if isinstance(one, ExpressionError) or not isinstance(other, Source):
        return isinstance(one, ExpressionError) and str(one) == str(other)
    return one.functions.keys() == other.functions.keys() and all(
        _text(node) == _text(other.functions[name])
        for name, node in one.functions.items()
        if name not in STAND_IN
    )


def _text(function: Any) -> str:
    return str(c_generator.CGenerator().visit(function))


def not_named(kernels: Sequence[Kernel], texts: Mapping[str, Source]) -> Iterable[str]:
    """Functions that other files can call and that are no kernel."""
    known = {kernel.symbol for kernel in kernels}
    for file, source in texts.items():
        for name, node in source.functions.items():
            own = str(node.coord.file) == file and "static" not in (node.decl.storage or ())
            if own and name not in known:
                yield f"{file}: {name}"
