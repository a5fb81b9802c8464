"""The C files of a folder, parsed: every way in which a compiler may read them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from pycparser import c_generator

from mechanics.compiled.custody.kernel import Kernel
from mechanics.errors import ExpressionError
from mechanics.exact.c_library import FAR, FUNCTIONS, FUSED, SINCOS
from mechanics.exact.c_parse import Source, linked, parse

COMPILERS: tuple[tuple[str, Mapping[str, str]], ...] = (
    ("gcc", {"__GNUC__": "12", "__FMA__": "1"}),
    ("clang", {"__GNUC__": "4", "__clang__": "1", "__FMA__": "1"}),
    ("gcc for ARM", {"__GNUC__": "12", "__ARM_FEATURE_FMA": "1"}),
    ("a fast fma", {"FP_FAST_FMA": "1", "FP_FAST_FMAF": "1"}),
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
    kinds = {kernel.file: kernel.kind for kernel in kernels}
    files = list(kinds)
    headers = {name: text for name, text in texts.items() if name.endswith(".h")}
    found: dict[tuple[str, str], Source | ExpressionError] = {}
    choices: list[tuple[str, Mapping[str, str]]] = [("", {})]
    for title, defined in choices:
        parsed = {file: _parsed(file, texts, headers, defined) for file in files}
        for file in files:
            same = [parsed[other] for other in files if kinds[other] == kinds[file]]
            one = _linked(parsed[file], same)
            if not title or not _same(one, found[file, ""]):
                found[file, title] = one
        if not title:
            choices += _configurations([one for one in parsed.values() if isinstance(one, Source)])
    return found


def _configurations(parsed: Sequence[Source]) -> list[tuple[str, Mapping[str, str]]]:
    """What may be defined, of the names that conditions ask for and the text does not define."""
    asked = {name for one in parsed for name in set(one.asked) - set(one.macros)} - {"__cplusplus"}
    compilers = {name for _, names in COMPILERS for name in names}
    found = [(title, names) for title, names in COMPILERS if asked & set(names)]
    # A choice of whoever builds the folder.
    return found + [(name, {name: "1"}) for name in sorted(asked - compilers)]


def _parsed(
    file: str, texts: Mapping[str, str], headers: Mapping[str, str], defined: Mapping[str, str]
) -> Source | ExpressionError:
    if file not in texts:
        return ExpressionError(f"{file}: there is no such file")
    try:
        return parse(texts[file], file, headers, defined)
    except ExpressionError as error:
        return error


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
