"""C source without comments, directives and macros: what the parser reads.

    text  --tokens-->  directives resolved  --macros-->  text with the same lines

Nothing is compiled and nothing is guessed: of the preprocessor there is what generated code has,
object-like macros, includes, conditions on names. Everything else is refused by name. An ``#if`` of
which nothing depends but an ``#error`` is passed over: either a compiler refuses the file there, or
the text goes on the same.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from mechanics.errors import ExpressionError
from mechanics.program.c.tokens import Line, lines, tokens, touching

SYSTEM = frozenset({"math.h", "stddef.h", "stdint.h", "string.h", "stdio.h", "float.h", "stdlib.h"})
"""Headers of the C library; what is used of them is known to the reader of the program."""

PRAGMAS = ("omp simd", "GCC ivdep", "clang loop vectorize(assume_safety)", "STDC FP_CONTRACT OFF")
"""They promise what is proved (lanes are independent) or ask for what is assumed."""


KEYWORDS = frozenset({
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum",
    "extern", "float", "for", "goto", "if", "int", "long", "register", "return", "short", "signed",
    "sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void", "volatile",
    "while",
})  # fmt: skip
"""Words of C that no macro may change: headers of the library hold them, too."""

MOST_EXPANSIONS = 20_000
"""Macros that stand in macros: forty lines of them can ask for a trillion."""


@dataclass
class _Reader:
    """One pass over a file and what it includes."""

    includes: Mapping[str, str]
    macros: dict[str, Line]
    asked: set[str] = field(default_factory=set)
    out: list[str] = field(default_factory=list)
    open_files: tuple[str, ...] = ()
    expansions: int = 0

    def file(self, text: str, file: str) -> None:
        """Append the text of a file."""
        if file in self.open_files:
            raise ExpressionError(f"{file}: it includes itself")
        outer, self.open_files = self.open_files, (*self.open_files, file)
        self.out.append(f'\n# 1 "{file}"\n')
        # One entry a condition: whether its branch is taken, and whether one has been.
        branches: list[list[bool]] = []
        for number, line in enumerate(_lines(text, file), 1):
            solid = [token for token in line if token[0] != "space"]
            where = f"{file}:{number}"
            if solid and solid[0][1] == "#":
                self.directive(solid[1:], branches, where, touching(line))
                # An included file has moved the count of lines.
                self.out.append(f'\n# {number + 1} "{file}"\n')
            elif all(taken for taken, _ in branches):
                self.out.append("".join(self.expanded(line, where)) + "\n")
            else:
                self.out.append("\n")
        if branches:
            raise ExpressionError(f"{file}: an #if has no #endif")
        self.open_files = outer

    def directive(self, line: Line, branches: list[list[bool]], where: str, call: bool) -> None:
        """Follow one directive; `call` says whether it is a macro with arguments."""
        if not line:
            return
        word, rest = line[0][1], line[1:]
        active = all(taken for taken, _ in branches)
        if word in ("if", "ifdef", "ifndef"):
            taken = active and self.condition(word, rest, where)
            branches.append([taken, taken])
        elif word in ("elif", "else", "endif"):
            if not branches:
                raise ExpressionError(f"{where}: #{word} without #if")
            if word == "endif":
                branches.pop()
                return
            last, outside = branches[-1], all(taken for taken, _ in branches[:-1])
            wanted = word == "else" or (not last[1] and self.condition("if", rest, where))
            last[0] = outside and not last[1] and wanted
            last[1] = last[1] or last[0]
        elif active:
            self.command(word, rest, where, call)

    def command(self, word: str, rest: Line, where: str, call: bool) -> None:
        """Follow a directive that is no condition."""
        words = "".join(text for _, text in rest)
        if word == "define" and rest and rest[0][0] == "name":
            name, body = rest[0][1], rest[1:]
            if name in KEYWORDS or name == "defined":
                raise ExpressionError(f"{where}: macro {name} gives a word of C another meaning")
            if call:
                raise ExpressionError(f"{where}: macro {name} takes arguments: write a function")
            if name in self.macros and self.macros[name] != body:
                raise ExpressionError(f"{where}: macro {name} is defined twice")
            self.macros[name] = body
        elif word == "include" and words.startswith('"') and words[1:-1] in self.includes:
            self.file(self.includes[words[1:-1]], words[1:-1])
        elif not (word == "include" and words.startswith("<") and words[1:-1] in SYSTEM) and not (
            word == "pragma" and words in {p.replace(" ", "") for p in PRAGMAS}
        ):
            raise ExpressionError(f"{where}: #{word} {words} is not supported")

    def condition(self, word: str, rest: Line, where: str) -> bool:
        """Whether a branch is taken."""
        if word in ("ifdef", "ifndef"):
            if len(rest) != 1:
                raise ExpressionError(f"{where}: #{word} takes one name")
            return self.is_defined(rest[0][1]) == (word == "ifdef")
        parser = _Condition(rest, self, where)
        value = parser.either()
        if parser.at != len(rest):
            raise ExpressionError(f"{where}: this condition of #if is not supported")
        return value

    def is_defined(self, name: str) -> bool:
        """Whether a macro is defined; the name is remembered if the text does not define it."""
        if name not in self.macros:
            self.asked.add(name)
        return name in self.macros

    def expanded(self, line: Line, where: str, inside: tuple[str, ...] = ()) -> list[str]:
        """Texts of the tokens with macros replaced."""
        result: list[str] = []
        for kind, text in line:
            if text in ("#", "##"):
                raise ExpressionError(f"{where}: {text} is not supported")
            if kind == "name" and text in self.macros and text not in inside:
                self.expansions += 1
                if self.expansions > MOST_EXPANSIONS:
                    raise ExpressionError(
                        f"{where}: more than {MOST_EXPANSIONS} macros are used: write a function"
                    )
                body = self.expanded(self.macros[text], where, (*inside, text))
                result += [" ", " ".join(body), " "]
            else:
                result.append(text)
        return result


# By content: a header stands in every file that includes it, under every choice of macros.
@lru_cache(maxsize=64)
def _lines(text: str, file: str) -> Sequence[Line]:
    return tuple(_without_errors(lines(tokens(text, file))))


def _without_errors(text: Sequence[Line]) -> list[Line]:
    """The lines, with ``#if`` ``#error`` ``#endif`` left empty: they change no text."""
    found = list(text)
    starts = [
        (i, _directive(line)) for i, line in enumerate(text) if any(k != "space" for k, _ in line)
    ]
    for (i, first), (j, second), (k, third) in zip(starts, starts[1:], starts[2:], strict=False):
        if first in ("if", "ifdef", "ifndef") and second == "error" and third == "endif":
            found[i], found[j], found[k] = [], [], []
    return found


def _directive(line: Line) -> str:
    """The word after #, if the line is a directive."""
    solid = [text for kind, text in line if kind != "space"]
    return solid[1] if len(solid) > 1 and solid[0] == "#" else ""


@dataclass
class _Condition:
    """``!defined(A) && (defined B || 0)``."""

    line: Line
    reader: _Reader
    where: str
    at: int = 0

    def next(self, expected: str = "") -> str:
        """The next token, which may have to be a certain one."""
        text = self.line[self.at][1] if self.at < len(self.line) else "the end"
        if expected and text != expected:
            raise ExpressionError(f"{self.where}: {expected} expected in #if, {text} found")
        self.at += 1
        return text

    def peek(self) -> str:
        """The next token, left where it is."""
        return self.line[self.at][1] if self.at < len(self.line) else ""

    def either(self) -> bool:
        """One term or several joined by ||."""
        value = self.both()
        while self.peek() == "||":
            self.next()
            value = self.both() or value
        return value

    def both(self) -> bool:
        """One factor or several joined by &&."""
        value = self.single()
        while self.peek() == "&&":
            self.next()
            value = self.single() and value
        return value

    def single(self) -> bool:
        """A negation, a bracket, a name that is defined or not, or 0 or 1."""
        text = self.next()
        if text == "!":
            return not self.single()
        if text == "(":
            value = self.either()
            self.next(")")
            return value
        if text == "defined":
            bracket = self.peek() == "("
            if bracket:
                self.next("(")
            name = self.next()
            if bracket:
                self.next(")")
            return self.reader.is_defined(name)
        if text in ("0", "1"):
            return text == "1"
        raise ExpressionError(f"{self.where}: {text} in #if is not supported")


@dataclass(frozen=True)
class Preprocessed:
    """Text for the parser.

    Attributes
    ----------
    macros : mapping of str to str
        What the text defines.
    asked : tuple of str
        Names that a condition asked for and nothing defines: those of compilers, for instance.
    """

    text: str
    macros: Mapping[str, str]
    asked: tuple[str, ...]


def preprocess(
    text: str,
    file: str = "code.c",
    includes: Mapping[str, str] | None = None,
    defined: Mapping[str, str] | None = None,
) -> Preprocessed:
    """Resolve comments, directives and macros.

    Parameters
    ----------
    file : str
        Name for messages.
    includes : mapping of str to str
        Text of each file that ``#include "..."`` may name.
    defined : mapping of str to str
        Macros that the compiler would define; all others are undefined.

    Raises
    ------
    ExpressionError
        For any directive that is not supported, by file and line.
    """
    return _preprocessed(text, file, _entries(includes), _entries(defined))


def _entries(mapping: Mapping[str, str] | None) -> tuple[tuple[str, str], ...]:
    return tuple((mapping or {}).items())


# By content: a chain of evidence reads each file of a folder a hundred times.
@lru_cache(maxsize=256)
def _preprocessed(
    text: str,
    file: str,
    includes: tuple[tuple[str, str], ...],
    defined: tuple[tuple[str, str], ...],
) -> Preprocessed:
    known = {name: tokens(body, name) for name, body in defined}
    reader = _Reader(dict(includes), known)
    reader.file(text, file)
    macros = {name: " ".join(t for _, t in body) for name, body in reader.macros.items()}
    return Preprocessed("".join(reader.out), macros, tuple(sorted(reader.asked)))
