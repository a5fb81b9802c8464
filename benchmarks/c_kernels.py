"""C kernels read by pycparser: what they compute, and how many operations that takes.

The rule of counting, the same for code by hand and generated code: every +, -, * and / of floating
numbers is one operation, a sign in front of anything but a number is one, a call is one. What holds
numbers only is worked out by the compiler and counts nothing; array subscripts count nothing.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import sympy
from pycparser import c_ast
from sympy import Expr, Symbol

from mechanics.errors import ExpressionError
from mechanics.program.c.literal import literal
from mechanics.program.c.parse import parse

FOLDER = Path(__file__).parent / "kernels"
FUNCTIONS = {"sin": sympy.sin, "cos": sympy.cos, "sqrt": sympy.sqrt}
NAMES = {"+": "add", "-": "add", "*": "multiply", "/": "divide"}


@dataclass(frozen=True)
class CKernel:
    """One C function: straight-line code that writes arrays.

    Attributes
    ----------
    outputs : mapping of (array, entry) to Expr
        In the symbols that stand for the entries of the input arrays.
    counts : mapping of str to int
        Number of ``add``, ``multiply``, ``divide``, ``sign`` and ``call``.
    """

    name: str
    outputs: Mapping[tuple[str, int], Expr]
    counts: Mapping[str, int]

    @property
    def operations(self) -> int:
        """All operations."""
        return sum(self.counts.values())


def read(source: str, symbols: Mapping[str, Sequence[Symbol]]) -> dict[str, CKernel]:
    """Every function of a C source by name.

    Parameters
    ----------
    source : str
        Comments and directives are skipped.
    symbols : mapping of str to sequence of Symbol
        What the entries of each input array stand for.

    Raises
    ------
    ExpressionError
        For anything but declarations of constants and assignments.
    """
    functions = parse(source).functions
    return {name: _Reading(node, symbols).kernel for name, node in functions.items()}


class _Reading:
    """One pass over the statements of a function."""

    def __init__(self, function: c_ast.FuncDef, symbols: Mapping[str, Sequence[Symbol]]) -> None:
        self._symbols = symbols
        self._values: dict[str, Expr] = {}
        self._counts: Counter[str] = Counter()
        self._outputs: dict[tuple[str, int], Expr] = {}
        for statement in function.body.block_items:
            self._statement(statement)
        self.kernel = CKernel(function.decl.name, self._outputs, dict(self._counts))

    def _statement(self, node: c_ast.Node) -> None:
        if isinstance(node, c_ast.Decl):
            self._values[node.name] = self._value(node.init)
        elif isinstance(node, c_ast.Assignment) and isinstance(node.lvalue, c_ast.ArrayRef):
            at = node.lvalue.name.name, int(node.lvalue.subscript.value)
            self._outputs[at] = self._value(node.rvalue)
        elif not isinstance(node, c_ast.Cast):
            raise ExpressionError(f"{node.coord}: {type(node).__name__} is no straight-line code")

    def _value(self, node: c_ast.Node) -> Expr:
        if isinstance(node, c_ast.Constant):
            # What is typed in decimals is meant to be exact: 9.81 is 981/100.
            number = literal(node.value).value if "x" in node.value else Fraction(node.value)
            return sympy.Rational(number.numerator, number.denominator)
        if isinstance(node, c_ast.ID):
            return self._values[node.name]
        if isinstance(node, c_ast.ArrayRef):
            return self._symbols[node.name.name][int(node.subscript.value)]
        if isinstance(node, c_ast.UnaryOp) and node.op == "-":
            return -self._counted("sign", node.expr)[0]
        if isinstance(node, c_ast.BinaryOp) and node.op in NAMES:
            return self._combined(node)
        if isinstance(node, c_ast.FuncCall) and node.name.name in FUNCTIONS:
            return FUNCTIONS[node.name.name](*self._counted("call", *node.args.exprs))
        raise ExpressionError(f"{node.coord}: {type(node).__name__} is not supported")

    def _combined(self, node: c_ast.BinaryOp) -> Expr:
        left, right = self._counted(NAMES[node.op], node.left, node.right)
        if node.op in "+-":
            return left + right if node.op == "+" else left - right
        return left * right if node.op == "*" else left / right

    def _counted(self, name: str, *nodes: c_ast.Node) -> list[Expr]:
        values = [self._value(node) for node in nodes]
        if not all(_constant(node) for node in nodes):
            self._counts[name] += 1
        return values


def _constant(node: c_ast.Node) -> bool:
    """Whether an expression holds numbers only."""
    return isinstance(node, c_ast.Constant) or (
        isinstance(node, c_ast.BinaryOp | c_ast.UnaryOp)
        and all(_constant(child) for _, child in node.children())
    )
