"""Code that statements were read from, with what it says in words.

f, and functions of its file that it calls    a.cpp, a.m    words of other cells of a notebook
"""

import inspect
import re
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from keyword import iskeyword
from pathlib import Path
from types import FunctionType, MethodType
from typing import Any

from mechanics.claims.code.comments import comments, without_comments
from mechanics.claims.code.python.closure_numbers import held
from mechanics.claims.code.python.containers import library
from mechanics.claims.code.python.objects import methods_used, names_in
from mechanics.claims.code.python.wrappers import unwrapped
from mechanics.claims.read import file_text
from mechanics.errors import InputError
from mechanics.judge.types_of_numbers import units_of_types

PAGES = (".tex", ".md", ".mo")
"""Of files whose words are read with their formulas."""
ASSIGNED = re.compile(
    r"^(?P<code>[ \t]*(?:self\.)?[\"']?(?P<name>[A-Za-z]\w*)[\"']?[ \t]*"
    r"(?::|=(?!=)|,[ \t]*(?=#))[^#\n]*)"
    r"#[ \t]*(?P<words>[^\n]+)", re.MULTILINE,
)  # fmt: skip
"""A line that gives a value or a type to one name, with a comment behind it."""
MOST = 64
"""Functions that one calls."""


COMPUTED = "its formula was computed to numbers"


@dataclass(frozen=True)
class Beside:
    """Words beside a function, as in the other cells of a notebook: they are its comments."""

    words: str


@dataclass(frozen=True)
class Numbers:
    """Names of numbers that a file computes, which are compared with nothing."""

    names: tuple[str, ...]


@dataclass(frozen=True)
class Aside:
    """A formula beside what is handed in, as in a comment: right, it is a statement.

    Attributes
    ----------
    text : str
    where : str
    """

    text: str
    where: str


@dataclass(frozen=True)
class NotRead:
    """A part of what is handed in that is not read: it may say anything, so nothing is shown of it.

    Attributes
    ----------
    part : str
    why : str
    """

    part: str
    why: str


@dataclass(frozen=True)
class Another:
    """A function beside the one that is judged, which is no part of it and does not use it.

    Right, it is a statement; else it may be about something else.

    Attributes
    ----------
    function : callable
    name : str
        That the file has for it.
    """

    function: Any
    name: str


@dataclass(frozen=True)
class Around:
    """A file of Python around functions that are judged.

    Attributes
    ----------
    code : str
    judged : frozenset of str
        Names of these.
    others : tuple of str
        What else of the file is not judged.
    """

    code: str
    judged: frozenset[str]
    others: tuple[str, ...] = ()


@dataclass(frozen=True)
class WholeFile:
    """A file of Python in which nothing is left to be judged, but that may say what names are.

    Attributes
    ----------
    code : str
    """

    code: str


@dataclass(frozen=True)
class Source:
    """Code, or the words beside it.

    Attributes
    ----------
    text : str
    suffix : str
        Of a file in its language; empty for words.
    """

    text: str
    suffix: str

    def words(self) -> tuple[str, ...]:
        """Its comments, documentation and strings."""
        return tuple(comments(self.text, self.suffix)) if self.suffix else (self.text,)

    def code(self) -> str:
        """What is none of them."""
        return without_comments(self.text, self.suffix) if self.suffix else ""


def source_of(thing: Any) -> tuple[Source, ...]:
    """The source of code, where there is one, with that of functions that it calls."""
    if isinstance(thing, Path):
        return () if thing.suffix in PAGES else (Source(file_text(thing), thing.suffix),)
    if isinstance(thing, Beside):
        return (Source(thing.words, ""),)
    if isinstance(thing, NotRead | Aside | Another | Numbers | Around | WholeFile):
        return ()
    return tuple(dict.fromkeys(map(_source, _functions(unwrapped(thing)))))


def file_of(thing: Any) -> tuple[Source, ...]:
    """The whole file around what is judged, whose words are read with its formulas or elsewhere."""
    if isinstance(thing, Around | WholeFile):
        return (Source(thing.code, ".py"),)
    return (Source(file_text(thing), ".mo"),) if _is_model(thing) else ()


def _is_model(thing: Any) -> bool:
    return isinstance(thing, Path) and thing.suffix == ".mo"


def values_of(thing: Any, names: Iterable[str]) -> str:
    """The text of a function and of those that it calls, with the numbers of names that it holds.

    Parameters
    ----------
    thing : callable
    names : iterable of str
        Of numbers of its file, its object and what is around it.
    """
    lines = [source.text for source in source_of(thing)]
    with suppress(InputError):  # of one name with two values none is the value
        lines += [f"{name} = {value}" for name, value in held(thing, names).numbers.items()]
    return "\n".join(lines)


def _functions(thing: Any) -> list[FunctionType]:
    """A function or method, and what it calls of its own file."""
    call = thing if isinstance(thing, FunctionType | MethodType) else type(thing).__call__
    found: list[FunctionType] = []
    todo: list[Any] = [call]
    while todo and len(found) < MOST:
        one: Any = todo.pop()
        one = getattr(one, "__func__", one)
        if not isinstance(one, FunctionType) or one in found or library(one.__module__ or ""):
            continue
        found.append(one)
        todo += [one.__globals__.get(str(name)) for name in names_in(one.__code__)]
        if isinstance(call, MethodType) and one is call.__func__:
            todo += methods_used(call.__self__, [call.__func__]).values()
    return found


def _source(function: FunctionType) -> Source:
    try:
        return Source(inspect.getsource(function), ".py")
    except (OSError, TypeError):
        return Source(f'"""{function.__doc__ or ""}"""', ".py")


def on_the_file(code: str) -> list[Beside]:
    """What a file in Python says, with the name before a comment behind what it is given to."""
    words = list(comments(ASSIGNED.sub(_with_its_name, code), ".py"))
    words += [f"{name} is a number in {unit}" for name, unit in units_of_types(code)]
    return [Beside("\n\n".join(words))] if words else []


def _with_its_name(line: re.Match[str]) -> str:
    """``self.l = 0.5  # half the pole`` says that of l."""
    quotes = line["code"].count('"') + line["code"].count("'")
    if ":" in line["words"] or iskeyword(line["name"]) or quotes % 2:
        return line[0]
    return f"{line['code']}# {line['name']}: {line['words']}"
