"""Integers of a C text that stand for parameters, where C does not compute with them as with reals.

    #define l 4         l/2          an integer, 2 for 5/2 where l is 5: refused by name
                        0.5*l        a double, as the formula is: read

A parameter is any real number of the scene, so a quotient of integers is another formula. The same
is said of a remainder, of sums and products that no int holds, and of unsigned ones.
"""

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from pycparser import c_ast, c_generator

from mechanics.errors import ExpressionError
from mechanics.program.c.index_polynomials import LARGEST
from mechanics.program.c.literal import literal
from mechanics.program.c.parse import UNSIGNED, Source, reached
from mechanics.program.c.types import WHOLES

LESS = (*WHOLES, "char", "signed char", "unsigned char", "short", "unsigned short", "bool", "_Bool")
"""Kinds of integers, those that become an int in each operation, too."""
COMPARED = ("==", "!=", "<", "<=", ">", ">=", "&&", "||")


class Integer(NamedTuple):
    """An expression that is an integer in C; its value where it is known."""

    names: frozenset[str] = frozenset()
    value: Fraction | None = None
    unsigned: bool = False


def refuse_integer_quotients(source: Source, wanted: str | None, names: Mapping[str, int]) -> None:
    """Refuse what a function does with integers that stand for parameters, and reals do not.

    Parameters
    ----------
    source : Source
    wanted : str or None
        The function that is read; the last one of the file when not given.
    names : mapping of str to int
        Names that are integers in the text, and read as arguments, with their values there.

    Raises
    ------
    ExpressionError
        By line and column, with the name and what is to be written.
    """
    chosen = wanted or next(iter([*source.functions][::-1]), "")
    for name in source.functions if names else ():
        if name not in reached(source, [chosen]):
            continue
        function = source.functions[name]
        known = {n: Integer(frozenset({n}), Fraction(v)) for n, v in names.items()}
        _Reader(source, known).walk(function.decl)
        _Reader(source, known).walk(function.body)


class _Reader:
    """One function, with what its names are; a name that it declares is of that type."""

    def __init__(self, source: Source, known: dict[str, Integer]) -> None:
        self.source, self.known = source, known

    def walk(self, node: Any) -> None:
        """Look at each expression of a statement."""
        if isinstance(node, c_ast.Decl) and (kind := _kind(node.type)) is not None:
            if node.init is not None:
                self.walk(node.init)
            own = node.name not in self.known or kind in LESS
            if own and kind in LESS:
                self.known[node.name] = Integer(unsigned=bool(UNSIGNED & {*kind.split()}))
            return
        if isinstance(node, c_ast.BinaryOp | c_ast.UnaryOp | c_ast.TernaryOp | c_ast.Cast):
            self.integer(node)
            return
        if isinstance(node, c_ast.Assignment) and node.op in ("/=", "%="):
            left, right = self.integer(node.lvalue), self.integer(node.rvalue)
            if left and right:
                self._joined(node, node.op[0], left, right)
            return
        for _, child in node.children():
            self.walk(child)

    def integer(self, node: Any) -> Integer | None:
        """What an expression is in C, if it is an integer."""
        match node:
            case c_ast.Constant():
                return _constant(node)
            case c_ast.ID(name=name):
                return self.known.get(name)
            case c_ast.UnaryOp(op="-" | "+" | "~" as op):
                one = self.integer(node.expr)
                value = None if one is None or one.value is None else one.value
                if one and one.names and one.unsigned:
                    raise _refused(node, one, "is of an unsigned integer")
                return one and one._replace(value=-value if value and op == "-" else value)
            case c_ast.Cast():
                one, kind = self.integer(node.expr), _kind(node.to_type.type)
                unsigned = bool(UNSIGNED & {*(kind or "").split()})
                return (one or Integer())._replace(unsigned=unsigned) if kind in LESS else None
            case c_ast.TernaryOp():
                self.walk(node.cond)
                yes, no = self.integer(node.iftrue), self.integer(node.iffalse)
                return Integer(yes.names | no.names) if yes and no else None
            case c_ast.BinaryOp(op=op):
                left, right = self.integer(node.left), self.integer(node.right)
                if op in COMPARED:
                    return Integer()
                return self._joined(node, op, left, right) if left and right else None
            case c_ast.FuncCall(name=c_ast.ID(name=name)) if name in self.source.functions:
                self._arguments(node)
                kind = _kind(self.source.functions[name].decl.type.type)
                return Integer() if kind in LESS else None
        self._arguments(node)
        return None

    def _arguments(self, node: Any) -> None:
        for _, child in node.children():
            self.walk(child)

    def _joined(self, node: Any, op: str, left: Integer, right: Integer) -> Integer:
        names = left.names | right.names
        value = _computed(op, left.value, right.value)
        both = Integer(names, value, left.unsigned or right.unsigned)
        if not names:
            return both
        if op in ("/", "%"):
            exact = op == "/" and None not in (left.value, right.value) and right.value
            cut = f" ({int(left.value / right.value)} here)" if exact else ""  # type: ignore[operator]
            what = "is cut to an integer" if op == "/" else "is a remainder of integers"
            raise _refused(node, both, f"{what} in C{cut}")
        if both.unsigned:
            raise _refused(node, both, "is an unsigned integer")
        if both.value is not None and abs(both.value) > LARGEST:
            raise _refused(node, both, "is more than an int holds")
        return both


def _computed(op: str, left: Fraction | None, right: Fraction | None) -> Fraction | None:
    if left is None or right is None:
        return None
    return {"+": left + right, "-": left - right, "*": left * right}.get(op)


def _constant(node: Any) -> Integer | None:
    if node.type in ("char", "string"):
        return Integer()
    kind, value = literal(node.value)
    return Integer(value=value, unsigned="unsigned" in node.type) if kind == "int" else None


def _kind(node: Any) -> str | None:
    names = getattr(getattr(node, "type", None), "names", None)
    return " ".join(names) if names else None


def _refused(node: Any, what: Integer, why: str) -> ExpressionError:
    names = sorted(what.names)
    words = c_generator.CGenerator().visit(node)
    verb = "is an integer" if len(names) == 1 else "are integers"
    remedy = f"write {names[0]} with a point, as 4.0"
    return ExpressionError(f"{node.coord}: {', '.join(names)} {verb} and {words} {why}: {remedy}")
