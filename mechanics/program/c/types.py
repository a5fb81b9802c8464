"""Types of C that generated code uses: real numbers, integers, arrays and pointers of these."""

from dataclasses import dataclass
from typing import Any

from pycparser import c_ast

from mechanics.errors import ExpressionError

REALS = ("double", "float")
WHOLES = frozenset({
    "int", "unsigned int", "unsigned", "long", "long int", "long long", "long long int", "size_t",
    "unsigned long", "int32_t", "uint32_t", "int64_t", "uint64_t", "ptrdiff_t",
})  # fmt: skip
QUALIFIERS = {"const", "restrict"}
STORAGE = {"static", "extern"}
SPECIFIERS = {"inline"}


@dataclass(frozen=True)
class Type:
    """A type.

    Attributes
    ----------
    kind : str
        ``"double"``, ``"float"``, ``"int"`` for every integer, ``"void"``, ``"struct NAME"``.
    constant : bool
        Whether what it holds, or points to, must not be changed.
    depth : int
        0 for a number, 1 for an array or a pointer.
    size : int or None
        Entries of an array, where they are given.
    words : str
        As it is written, for comparisons.
    """

    kind: str
    constant: bool
    depth: int
    size: int | None
    words: str


def declared(node: Any) -> Type:
    """Type of a declaration, cast or parameter.

    Raises
    ------
    ExpressionError
        For a type, qualifier or storage class that is not supported.
    """
    odd = set(getattr(node, "storage", None) or ()) - STORAGE
    odd |= set(getattr(node, "funcspec", None) or ()) - SPECIFIERS
    odd |= {type(entry).__name__ for entry in getattr(node, "align", None) or ()}
    if odd:
        raise ExpressionError(f"{node.coord}: {', '.join(sorted(odd))} is not supported")
    return _type(node.type, node.coord)


def _type(node: Any, coord: Any) -> Type:
    if isinstance(node, c_ast.TypeDecl):
        return _plain(node, coord)
    if isinstance(node, c_ast.PtrDecl | c_ast.ArrayDecl):
        inner = _type(node.type, coord)
        if inner.depth:
            raise ExpressionError(f"{coord}: a pointer to pointers is not supported")
        size, odd = None, set(getattr(node, "quals", None) or ())
        if isinstance(node, c_ast.ArrayDecl):
            odd = set(node.dim_quals or ())
            size = _size(node.dim, coord)
        if odd - QUALIFIERS:
            raise ExpressionError(f"{coord}: {', '.join(sorted(map(str, odd)))} is not supported")
        words = f"{inner.words} {' '.join(sorted(map(str, odd)))}*"
        return Type(inner.kind, inner.constant, 1, size, words)
    raise ExpressionError(f"{coord}: {type(node).__name__} is a type that is not supported")


def _size(node: Any, coord: Any) -> int | None:
    if node is None:
        return None
    if isinstance(node, c_ast.Constant) and node.value.isdecimal():
        return int(node.value)
    raise ExpressionError(f"{coord}: the size of an array is no plain number")


def _plain(node: Any, coord: Any) -> Type:
    # Only a pointer can be restrict.
    if odd := set(node.quals or ()) - {"const"}:
        raise ExpressionError(f"{coord}: {', '.join(sorted(odd))} is not supported")
    constant = "const" in (node.quals or ())
    if isinstance(node.type, c_ast.Struct):
        name = f"struct {node.type.name}"
    elif isinstance(node.type, c_ast.IdentifierType):
        name = " ".join(node.type.names)
    else:
        raise ExpressionError(f"{coord}: {type(node.type).__name__} is no type that is known here")
    kind = "int" if name in WHOLES else name
    if kind not in (*REALS, "int", "void") and not kind.startswith("struct "):
        raise ExpressionError(f"{coord}: the type {name} is not supported")
    return Type(kind, constant, 0, None, f"{'const ' if constant else ''}{name}")


def signature(function: Any) -> str:
    """Return type and types of the arguments, to compare declarations of one function."""
    arguments = [declared(p).words for p in parameters(function)]
    return f"{_type(function.type, function.coord).words}({', '.join(arguments)})"


def parameters(function: Any) -> list[Any]:
    """Declarations of the arguments of a `FuncDecl`."""
    given = function.args.params if function.args else []
    odd = [p for p in given if isinstance(p, c_ast.EllipsisParam | c_ast.ID)]
    if odd:
        raise ExpressionError(f"{odd[0].coord}: this list of arguments is not supported")
    if len(given) == 1 and isinstance(given[0], c_ast.Typename):
        return []  # f(void)
    return list(given)
