"""Cells of a notebook, and parts of a page in Markdown: which ones claim something.

import numpy as np        m = 1.0        print(m)        "what it is about"        claim nothing
acc = lambda theta: ...        eq = Eq(...)        display(Math(...))        %%latex        may

A whitelist: what is not in it is judged, or named as not read.
"""

import ast
import re
from dataclasses import dataclass

MAGIC = re.compile(
    r"^[ \t]*(?:%(?:matplotlib|config|load_ext|autoreload|pip)|!pip)\b[^\n]*", re.MULTILINE
)
"""Lines of a notebook's own language that change no name."""
SHOWS = ("print", "display", "init_printing", "init_vprinting")
FORMULA = re.compile(r"=|\\[A-Za-z]|'{2}")
"""What a string has that may be an equation."""
NUMBERS = (
    ast.Constant, ast.UnaryOp, ast.BinOp, ast.operator, ast.unaryop, ast.List, ast.Tuple, ast.Load,
)  # fmt: skip


@dataclass(frozen=True)
class Cell:
    """A part of what is handed in.

    Attributes
    ----------
    kind : str
        ``"markdown"``, ``"code"``, ``"raw"`` or another one.
    text : str
    name : str
        What messages call it.
    shown : tuple of str
        What it shows, where it is code of a notebook that was run.
    """

    kind: str
    text: str
    name: str
    shown: tuple[str, ...] = ()


def runnable(text: str) -> str:
    """Code of a cell; lines that only set the notebook up are left out."""
    return MAGIC.sub("pass", text)


def is_inert(code: str) -> bool:
    """Whether a cell of code only imports, gives numbers to names, and prints these."""
    try:
        body = ast.parse(runnable(code)).body
    except (SyntaxError, ValueError, RecursionError):
        return False
    return all(map(_is_inert, body))


def _is_inert(line: ast.stmt) -> bool:
    match line:
        case ast.Import() | ast.ImportFrom() | ast.Pass():
            return True
        case ast.Assign(targets=targets, value=value):
            names = (part for target in targets for part in ast.walk(target))
            plain = (ast.Name, ast.Tuple, ast.Store)
            return all(isinstance(n, plain) for n in names) and _is_number(value)
        case ast.Expr(value=ast.Constant(value=value)):
            return not (isinstance(value, str) and FORMULA.search(value))
        case ast.Expr(value=ast.Name()):
            return True
        case ast.Expr(value=ast.Call(func=ast.Name(id=name), args=args)) if name in SHOWS:
            return all(isinstance(part, ast.Name) or _is_word(part) for part in args)
    return False


def _is_number(value: ast.expr) -> bool:
    parts = [*ast.walk(value)]
    strings = (isinstance(p, ast.Constant) and isinstance(p.value, str) for p in parts)
    return all(isinstance(part, NUMBERS) for part in parts) and not any(strings)


def _is_word(value: ast.expr) -> bool:
    known = value.value if isinstance(value, ast.Constant) else None
    return isinstance(value, ast.Constant) and not (
        isinstance(known, str) and FORMULA.search(known) is not None
    )
