"""What C does with a pointer among its arguments, of which the type says little.

void f(double *y, double *dy) { dy[0] = y[1]; }   y is only read, dy is written before it is read
void step(double *x, double *v) { *x += *v; }      x is read and then written
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pycparser import c_ast

from mechanics.claims.code.c.library import below
from mechanics.errors import ExpressionError


@dataclass
class Use:
    """What a function does with a pointer.

    Attributes
    ----------
    written : bool
        Whether it writes there, or hands the pointer on.
    read_first : bool
        Whether it reads an entry that it has not set before.
    """

    written: bool = False
    read_first: bool = False


def use_of(body: Any, name: str) -> Use:
    """Whether a function writes what a pointer points to, and reads it before."""
    use, places = Use(), set[str]()

    def place(node: Any) -> str | None:
        if isinstance(node, c_ast.ArrayRef) and getattr(node.name, "name", None) == name:
            return getattr(node.subscript, "value", "")
        pointer = isinstance(node, c_ast.UnaryOp) and node.op == "*"
        return "0" if pointer and getattr(node.expr, "name", None) == name else None

    def visit(node: Any) -> None:
        if isinstance(node, c_ast.Assignment) and (at := place(node.lvalue)) is not None:
            visit(node.rvalue)
            use.read_first |= node.op != "=" and at not in places
            use.written = True
            places.add(at)
            return
        if (at := place(node)) is not None:
            use.read_first |= at not in places
        elif isinstance(node, c_ast.ID) and node.name == name:
            use.written = True  # another function has it
        else:
            for _, child in node.children():
                visit(child)

    visit(body)
    return use


def refuse_vain(body: Any, name: str) -> None:
    """Refuse an entry of an output that is set twice in one block, the first time in vain.

    Raises
    ------
    ExpressionError
    """
    others = {
        node.name for node in below(body)
        if isinstance(node, c_ast.Decl) and getattr(node.init, "name", None) == name
    }  # fmt: skip
    for block in (node for node in below(body) if isinstance(node, c_ast.Compound)):
        done: set[str] = set()
        for line in block.block_items or ():
            plain = isinstance(line, c_ast.Assignment) and line.op == "="
            at = next(_places(line.lvalue, {name, *others}), "") if plain else ""
            read = line.rvalue if plain else line
            if any(
                isinstance(n, c_ast.Return)
                or (isinstance(n, c_ast.ID) and n.name in {name, *others})
                for n in below(read)
            ):
                done = set()
            if at and at in done:
                raise ExpressionError(f"{line.coord}: {name}[{at}] is set twice: leave one")
            done |= {at} - {""}


def _places(node: Any, names: set[str]) -> Iterator[str]:
    """The number of the entry that is written."""
    if isinstance(node, c_ast.ArrayRef) and getattr(node.name, "name", None) in names:
        yield getattr(node.subscript, "value", "")
    pointer = isinstance(node, c_ast.UnaryOp) and node.op == "*"
    if pointer and getattr(node.expr, "name", None) in names:
        yield "0"
