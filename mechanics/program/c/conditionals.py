"""Conditional text of C: which names decide what a compiler reads.

    #ifndef NAME_H           #ifdef __cplusplus        #if defined(A) && ...
    #define NAME_H           extern "C" {              #error "..."
    the rest of the file     #endif                    #endif
    #endif

These three are harmless: a guard against being included twice, the guard of linkage in exactly
these words (or with the bracket that closes it), and what stops a compiler or changes nothing. The
names of all other conditions are told, those too that stand in text which one reading leaves out.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from mechanics.errors import ExpressionError
from mechanics.program.c.tokens import lines, tokens

OPENS = ("if", "ifdef", "ifndef")
LINKAGE = (["extern", '"C"', "{"], ["}"])


@dataclass(frozen=True)
class Asked:
    """A name that a condition asks for.

    Attributes
    ----------
    line : int
        Of the directive.
    """

    name: str
    line: int


@dataclass
class _Group:
    """From an #if to its #endif: directives with their lines, and what stands between them."""

    directives: list[tuple[int, list[str]]]
    content: list[list[str]] = field(default_factory=list)
    end: int = 0


def asked_names(text: str, file: str, guard: str = "") -> tuple[Asked, ...]:
    """Names that decide what is read, in their order; harmless conditions are left out.

    Parameters
    ----------
    file : str
        Name for messages.
    guard : str
        What the name of a guard against being included twice begins with.

    Raises
    ------
    ExpressionError
        If conditions are not closed, or the text has characters that C has not.
    """
    every = enumerate(lines(tokens(text, file)), 1)
    numbered = [(n, [text for kind, text in line if kind != "space"]) for n, line in every]
    solid = [(n, words) for n, words in numbered if words]
    groups = _groups(solid, file)
    found = []
    for group in groups:
        if _is_linkage(group) or _is_error(group) or _is_guard(group, solid, guard):
            continue
        for line, words in group.directives:
            found += [Asked(name, line) for name in _names(words)]
    return tuple(sorted(set(found), key=lambda one: (one.line, one.name)))


def _groups(solid: Sequence[tuple[int, list[str]]], file: str) -> list[_Group]:
    """Every #if with its #elif, #else and #endif."""
    found: list[_Group] = []
    open_ones: list[_Group] = []
    for line, words in solid:
        word = words[1] if words[0] == "#" and len(words) > 1 else ""
        if word == "endif":
            if not open_ones:
                raise ExpressionError(f"{file}:{line}: #endif without #if")
            open_ones.pop().end = line
            continue
        if word in ("elif", "else"):
            if not open_ones:
                raise ExpressionError(f"{file}:{line}: #{word} without #if")
            open_ones[-1].directives.append((line, words[1:]))
            continue
        for group in open_ones:
            group.content.append(words)
        if word in OPENS:
            open_ones.append(_Group([(line, words[1:])]))
            found.append(open_ones[-1])
    if open_ones:
        raise ExpressionError(f"{file}: an #if has no #endif")
    return found


def _is_linkage(group: _Group) -> bool:
    asked = [words for _, words in group.directives]
    return asked == [["ifdef", "__cplusplus"]] and [w for c in group.content for w in c] in LINKAGE


def _is_error(group: _Group) -> bool:
    return (
        len(group.directives) == 1
        and len(group.content) == 1
        and group.content[0][:2] == ["#", "error"]
    )


def _is_guard(group: _Group, solid: Sequence[tuple[int, list[str]]], guard: str) -> bool:
    """Whether it is around the whole file, and defines what it asks for, as nothing, first."""
    line, words = group.directives[0]
    return (
        len(group.directives) == 1
        and len(words) == 2
        and words[0] == "ifndef"
        and words[1].startswith(guard)
        and group.content[:1] == [["#", "define", words[1]]]
        and (solid[0][0], solid[-1][0]) == (line, group.end)
    )


def _names(words: Sequence[str]) -> list[str]:
    """The names in a condition."""
    return [w for w in words[1:] if (w[0].isalpha() or w[0] == "_") and w != "defined"]
