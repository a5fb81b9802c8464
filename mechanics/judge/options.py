"""Refuse options that apply to none of the inputs of a check.

--function rates with a.tex    ->    error: it names a function of code, and a.tex is a text
"""

from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from typing import Any

import casadi

from mechanics.claims.code.black_box import BlackBox
from mechanics.claims.code.sympy_objects import is_sympy
from mechanics.claims.code.translation.cpp_functions import SUFFIXES
from mechanics.claims.code.translation.read_arrays import LANGUAGES, has_function, may_be_code
from mechanics.claims.declared_conventions import EXACT, HARMLESS
from mechanics.claims.read import file_text
from mechanics.errors import InputError
from mechanics.judge.sources import Another, Around, Beside, NotRead, Numbers, WholeFile

BESIDE = (Around, Beside, NotRead, Numbers, WholeFile)
"""What is no statement."""
C = "C or C++"
FILES = (C, "C as a text", "MATLAB", "Julia")
READ = ("text", *FILES, "SymPy", "CasADi", "Python")
RULES = {
    "function": ("it names a function of C, C++, MATLAB or Julia (of Python: file.py:NAME)", FILES),
    "notation": ("it is for texts", ("text", "C as a text")),
    "about": ("it is for what is read, not called", READ),
    "values": ("it is for what is read, not called", READ),
    EXACT: ("it is for code that rounds", (*FILES, "CasADi", "Python")),
    HARMLESS: (
        "it is for C, C++ and MATLAB of which a part is not here",
        (C, "C as a text", "MATLAB"),
    ),
}
"""What options are for: in words, and the kinds of things."""
SPELLED = {
    "function": "--function (function=)", "notation": "--notation (notation=)",
    "about": "--about (about=)", "values": "--value (values=)",
    EXACT: f"--convention '{EXACT}'", HARMLESS: f"--convention '{HARMLESS}'",
}  # fmt: skip


def refuse_unused(things: Sequence[Any], notation: str | None, asked: Collection[str]) -> None:
    """Refuse what is for another kind of thing than any that is checked.

    Parameters
    ----------
    things : sequence
        As for `mechanics.check`.
    notation : str, optional
        As for `mechanics.check`.
    asked : collection of str
        Of `RULES`, what a person gives.

    Raises
    ------
    InputError
        It names the option, what it is for, and what there is instead.
    """
    kinds = dict(_kinds(things, notation))
    for option in asked:
        words, taken = RULES[option]
        if kinds and not {*kinds.values()} & {*taken}:
            raise InputError(
                f"{SPELLED[option]}: {words}, and there is only {', '.join(kinds)}: leave it out"
            )


def takes_function(path: Path) -> bool:
    """Whether a file has functions that are read, not run, and of which one can be chosen."""
    return _file_kind(path) in FILES


def _file_kind(path: Path) -> str:
    suffix = path.suffix.lower()
    if suffix in (".c", ".h", *SUFFIXES):
        return C
    if suffix in LANGUAGES:
        text = file_text(path)
        if has_function(text) or may_be_code(text, suffix):
            return "MATLAB" if suffix == ".m" else "Julia"
    return "text"


def _kinds(things: Sequence[Any], notation: str | None) -> Iterator[tuple[str, str]]:
    """What each thing is called, and its kind."""
    for thing in things:
        if isinstance(thing, Path):
            kind = _file_kind(thing)
            yield f"{thing.name}, {'a text' if kind == 'text' else f'code in {kind}'}", kind
        elif isinstance(thing, str | bytes):
            yield "a text", "C as a text" if notation == "c" else "text"
        elif isinstance(thing, BlackBox):
            yield "a black box", "black box"
        elif isinstance(thing, casadi.Function):
            yield "a function of CasADi", "CasADi"
        elif is_sympy(thing) or isinstance(thing, tuple):
            yield "objects of SymPy", "SymPy"
        elif isinstance(thing, Another) or callable(thing):
            yield f"{getattr(thing, '__name__', 'a function')}, a function of Python", "Python"
        elif not isinstance(thing, BESIDE):
            yield "something else", "text"
