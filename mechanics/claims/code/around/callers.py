"""What uses judged functions in their file: of it nothing is said, however right they are.

    only rate is judged: main (lines 6 to 15) uses it

Lines that are known to be wrong are quoted beside that.
"""

import ast
import re
from collections.abc import Collection, Iterator, Mapping

from mechanics.claims.code.around.unjudged_code import spans_of_functions
from mechanics.claims.code.comments import without_comments

Spans = Mapping[str, tuple[int, int]]


def callers(text: str, suffix: str, judged: Collection[str]) -> tuple[str, ...]:
    """One sentence, where something in a file uses what is judged.

    Parameters
    ----------
    text : str
        The file.
    suffix : str
        Of its name.
    judged : collection of str
        Names of functions and methods.
    """
    if not judged:
        return ()
    spans = _python_spans(text) if suffix == ".py" else spans_of_functions(text, suffix)
    mentions = [*(_python_mentions if suffix == ".py" else _mentions)(text, suffix, judged)]
    around = {line: _function_around(line, spans) for line in mentions}
    users = {name for name in around.values() if name and name not in judged}
    alone = [line for line, name in around.items() if not name]
    parts = [f"{name} ({_lines(*spans[name])})" for name in sorted(users, key=lambda n: spans[n])]
    if alone and suffix not in (".c", ".cpp", ".ino"):  # there it is a declaration
        parts.append(f"the script ({_lines(min(alone), max(alone))})")
    if not parts:
        return ()
    names = sorted(judged)
    is_, it = ("is", "it") if len(names) == 1 else ("are", "them")
    use = "uses" if len(parts) == 1 else "use"
    return (f"only {_listed(names)} {is_} judged: {_listed(parts)} {use} {it}",)


def _function_around(line: int, spans: Spans) -> str:
    """The innermost function that a line stands in."""
    inside = [
        (last - first, name) for name, (first, last) in spans.items() if first <= line <= last
    ]
    return min(inside)[1] if inside else ""


def _python_spans(text: str) -> Spans:
    defined = (ast.FunctionDef, ast.AsyncFunctionDef)
    return {
        node.name: (node.lineno, node.end_lineno or node.lineno)
        for node in ast.walk(ast.parse(text)) if isinstance(node, defined)
    }  # fmt: skip


def _python_mentions(text: str, suffix: str, judged: Collection[str]) -> Iterator[int]:
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Name | ast.Attribute):
            name = node.id if isinstance(node, ast.Name) else node.attr
            if name in judged:
                yield node.lineno


def _mentions(text: str, suffix: str, judged: Collection[str]) -> Iterator[int]:
    words = re.compile(rf"(?<!\w)(?:{'|'.join(map(re.escape, judged))})(?!\w)")
    for number, line in enumerate(without_comments(text, suffix).split("\n"), start=1):
        if words.search(line):
            yield number


def _lines(first: int, last: int) -> str:
    return f"line {first}" if first == last else f"lines {first} to {last}"


def _listed(words: list[str]) -> str:
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))
