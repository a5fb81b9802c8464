"""What C does with a pointer among its arguments, of which the type says little.

void f(double *y, double *dy) { dy[0] = y[1]; }   y is only read, dy is written before it is read
void step(double *x, double *v) { *x += *v; }      x is read and then written
"""

from dataclasses import dataclass
from typing import Any

from pycparser import c_ast


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
