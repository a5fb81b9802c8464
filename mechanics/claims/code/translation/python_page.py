"""Code of another language as a Python function whose lines are those of its author.

A grammar's tree is printed as Python, statement by statement, each in the line where it stands; the
page is compiled under the name of the author's file, so that what is said of a line is true of his.
"""

import ast
import keyword
import linecache
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np

from mechanics.errors import InputError

Result = TypeVar("Result")
WIDTH = 4
LONGEST = 64
"""Turns of a loop."""
EXACT = 2**53
"""Integers up to it are doubles."""


class Unread(InputError):
    """What a grammar knows and its printer does not."""


class NamesTaken(Unread):
    """Names of a person that the page has functions of its own for.

    Attributes
    ----------
    names : tuple of str
    """

    def __init__(self, names: Sequence[str]) -> None:
        self.names = tuple(names)
        super().__init__(f"the name {names[0]} is not read here: rename it")


def renamed(
    translate: Callable[[str, str | None], Result], text: str, function: str | None
) -> Result:
    """What a text is in Python; a name that a page has itself gets an underscore.

    Parameters
    ----------
    translate : callable
        Takes the text and the name of the function that is asked for.
    text : str
    function : str, optional

    Raises
    ------
    Unread
    """
    tokens = {*re.findall(r"[^\W\d]\w*", text)}
    if both := [word for word in keyword.kwlist if {word, f"{word}_"} <= tokens]:
        raise Unread(f"the names {both[0]} and {both[0]}_ are one here: rename one")
    try:
        return translate(text, function)
    except NamesTaken as error:
        if both := [name for name in error.names if f"{name}_" in tokens]:
            raise Unread(f"the names {both[0]} and {both[0]}_ are one here: rename one") from None
        taken = re.compile(rf"(?<![\w@\\])({'|'.join(error.names)})\b")
        asked = None if function is None else taken.sub(r"\1_", function)
        return translate(taken.sub(r"\1_", text), asked)


def counted(*parts: int) -> range:
    """`range`, where it is short.

    Raises
    ------
    ValueError
    """
    found = range(*parts)
    if len(found) > LONGEST:
        raise ValueError(f"a loop of {len(found)} turns: {LONGEST} at most")
    return found


PASSED_OVER = ("comment", "line_comment", "block_comment", "line_continuation")
BUILTINS = {"range": counted, "tuple": tuple, "ValueError": ValueError}


@dataclass
class Page:
    """Lines of Python, filled from the top.

    Attributes
    ----------
    lines : list of str
    """

    lines: list[str] = field(default_factory=list)
    compound: bool = False

    def put(self, line: int, depth: int, code: str, *, opens: bool = False) -> None:
        """Write a statement in a line, or behind what stands there, or below it.

        Parameters
        ----------
        line : int
            From 1.
        depth : int
            Of the block that it stands in.
        code : str
        opens : bool
            Whether a block follows.
        """
        here = " " * (WIDTH * depth)
        last = self.lines[-1] if self.lines else ""
        same = last.strip() and last[: len(here) + 1] == here + last.strip()[:1]
        if len(self.lines) >= line and same and not opens and not self.compound:
            self.lines[-1] = f"{last}; {code}"
            return
        self.lines += [""] * (line - 1 - len(self.lines))
        self.lines.append(here + code)
        self.compound = opens

    def constants(self, of_functions: dict[str, dict[str, str]]) -> None:
        """Numbers of functions, as those of the file.

        Raises
        ------
        Unread
            Where one name has two values.
        """
        values: dict[str, str] = {}
        for name, value in (pair for own in of_functions.values() for pair in own.items()):
            if values.setdefault(name, value) != value:
                raise Unread(f"{name} is {values[name]} and {value}: rename one")
        for name, value in values.items():
            self.put(0, 0, f"{name} = {value}")

    def module(self, origin: str, names: dict[str, Any]) -> dict[str, Any]:
        """What the page defines.

        It is printed from nodes of a tree that are known one by one, so that nothing of a person's
        text but names and numbers is in it, and it has no builtin but these.
        """
        text = "\n".join(self.lines) + "\n"
        linecache.cache[origin] = (len(text), None, text.splitlines(keepends=True), origin)
        # By their names, too: a copy that is traced has all builtins.
        space = {"np": np, "__name__": "code", "__builtins__": BUILTINS, **BUILTINS, **names}
        try:
            parsed = ast.parse(text, origin)
        except SyntaxError as error:
            what = (error.text or "").strip()
            raise Unread(f"line {error.lineno}: {what!r} is not read") from None
        if taken := sorted(_given_names(parsed) & {*BUILTINS, "np", *names}):
            raise NamesTaken(taken)
        for one in ast.walk(parsed):
            number = one.value if isinstance(one, ast.Constant) else None
            if isinstance(number, int) and number > EXACT:
                raise Unread(f"{number} is more than a double holds exactly: write it with a point")
        try:
            exec(compile(parsed, origin, "exec"), space)
        except ValueError as error:
            raise Unread(str(error)) from None
        return space


def _given_names(page: ast.AST) -> set[str]:
    """Names of functions, arguments and values that a page has of a person."""
    nodes = [*ast.walk(page)]
    found = {n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
    found |= {n.name for n in nodes if isinstance(n, ast.FunctionDef)}
    return found | {n.arg for n in nodes if isinstance(n, ast.arg)}


def tree(language: Callable[[], object], text: str, package: str) -> Any:
    """The root of a text's syntax tree.

    Parameters
    ----------
    language : callable
        Imports a grammar of tree-sitter.
    text, package : str

    Raises
    ------
    Unread
        Where it is not installed.
    """
    try:
        from tree_sitter import Language, Parser

        grammar = language()
    except ImportError:
        raise Unread(f"{package} is not installed: pip install tree-sitter {package}") from None
    return Parser(Language(grammar)).parse(text.encode()).root_node


def first_error(root: Any) -> Any:
    """The first node that the grammar does not know; None where there is none."""
    if not root.has_error:
        return None
    todo: list[Any] = [root]
    while todo:
        node = todo.pop()
        if node.is_error or node.is_missing:
            return node
        todo += reversed([child for child in node.children if child.has_error])
    return root


def words(node: Any) -> str:
    """The text of a node."""
    return str(node.text.decode())


def line_of(node: Any) -> int:
    """The line where it begins, from 1."""
    return int(node.start_point[0]) + 1


def named(node: Any) -> list[Any]:
    """Its parts without punctuation and comments."""
    return [c for c in node.named_children if c.type not in PASSED_OVER]


def within(node: Any, *kinds: str) -> list[Any]:
    """All nodes of some kinds in a tree, in the order of the text."""
    found, todo = [], [node]
    while todo:
        one = todo.pop()
        if one.type in kinds:
            found.append(one)
        todo += reversed(one.children)
    return found


def safe(name: str) -> str:
    """A name that Python takes, and that is none of its own.

    Raises
    ------
    Unread
    """
    if name.startswith("__"):
        raise Unread(f"the name {name} is not read: it begins with two underscores")
    return f"{name}_" if keyword.iskeyword(name) else name


def refuse_absent(chosen: str, functions: Iterable[str]) -> None:
    """Refuse a function that a file has not.

    Raises
    ------
    Unread
    """
    if safe(chosen) not in functions:
        told = ", ".join(functions) or "none"
        raise Unread(f"there is no function {chosen}: there are {told}")


def refuse(node: Any, what: str = "") -> Unread:
    """What is said of a node that is not read."""
    text = " ".join(words(node).split())
    where = f"line {line_of(node)}, column {node.start_point[1] + 1}"
    return Unread(f"{where}: {what or f'{text[:60]!r} is not read'}")


def refuse_call(node: Any, name: str, given: Sequence[Any] = ()) -> Unread:
    """What is said of a statement that calls a function of another file.

    Parameters
    ----------
    node
        The statement.
    name : str
        Of the function.
    given : sequence of node
        Arguments that it may change.
    """
    names = (words(i) for part in given for i in (part, *within(part, "identifier")))
    changed = joined([*dict.fromkeys(n for n in names if n.isidentifier())])
    return refuse(
        node,
        f"{name}() is not in this file, and may change {changed or 'what it reaches'}: put it into"
        " the file, or leave the call out if it changes nothing",
    )


def joined(parts: Sequence[str]) -> str:
    """Arguments of a call."""
    return ", ".join(parts)
