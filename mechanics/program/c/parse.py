"""C source as a syntax tree: functions by name, after `c_text`, by pycparser."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any

from pycparser import CParser, c_ast

from mechanics.errors import ExpressionError
from mechanics.program.c.text import preprocess

LIBRARY = """\
typedef unsigned long size_t; typedef int int32_t; typedef unsigned int uint32_t;
typedef long int64_t; typedef unsigned long uint64_t; typedef long ptrdiff_t;
"""
"""Types of the C library that generated code uses."""

UNSIGNED = frozenset({"unsigned", "size_t", "uint32_t", "uint64_t"})


@dataclass(frozen=True)
class Source:
    """A translation unit.

    Attributes
    ----------
    functions : mapping of str to pycparser.c_ast.FuncDef
    prototypes : mapping of str to tuple of pycparser.c_ast.FuncDecl
        Every declaration of a function, that of its definition included.
    structs : mapping of str to pycparser.c_ast.Struct
        By tag.
    asked : tuple of str
        Names that a condition asked for and nothing defines.
    """

    file: str
    functions: Mapping[str, Any]
    prototypes: Mapping[str, tuple[Any, ...]]
    structs: Mapping[str, Any]
    macros: Mapping[str, str]
    asked: tuple[str, ...]

    @cached_property
    def has_unsigned(self) -> bool:
        """Whether there are unsigned integers in its functions."""
        return any(map(_has_unsigned, self.functions.values()))


def _has_unsigned(node: Any) -> bool:
    waiting = [node]
    while waiting:
        at = waiting.pop()
        if isinstance(at, c_ast.IdentifierType) and UNSIGNED & set(at.names):
            return True
        if isinstance(at, c_ast.Constant) and "unsigned" in at.type:
            return True
        waiting += [child for _, child in at.children()]
    return False


def reached(source: Source, names: Iterable[str]) -> frozenset[str]:
    """Functions whose names occur in some, and in what these reach: no other is ever called."""
    found: set[str] = set()
    waiting: list[Any] = [source.functions[name] for name in names if name in source.functions]
    found |= {node.decl.name for node in waiting}
    while waiting:
        at = waiting.pop()
        if isinstance(at, c_ast.ID) and at.name in source.functions and at.name not in found:
            found.add(at.name)
            waiting.append(source.functions[at.name])
        waiting += [child for _, child in at.children()]
    return frozenset(found)


def linked(first: Source, *others: Source) -> Source:
    """A file with the functions of others that it calls; static ones are its own.

    Raises
    ------
    ExpressionError
        If a function is defined in two of the files.
    """
    functions = dict(first.functions)
    prototypes = dict(first.prototypes)
    for other in others:
        for name, node in other.functions.items():
            if "static" in (node.decl.storage or ()):
                continue
            if name in functions:
                raise ExpressionError(f"function {name} is defined in two files")
            functions[name] = node
            prototypes[name] = (*prototypes.get(name, ()), *other.prototypes[name])
    return replace(first, functions=functions, prototypes=prototypes)


def parse(
    text: str,
    file: str = "code.c",
    includes: Mapping[str, str] | None = None,
    defined: Mapping[str, str] | None = None,
) -> Source:
    """Parse a C file; arguments as for `preprocess`.

    Raises
    ------
    ExpressionError
        If it is no C, or holds a declaration outside functions that is none of a function.
    """
    done = preprocess(text, file, includes, defined)
    tree = _tree(done.text, file)
    functions: dict[str, Any] = {}
    prototypes: dict[str, list[Any]] = {}
    structs: dict[str, Any] = {}
    for node in tree.ext:
        declaration = node.decl if isinstance(node, c_ast.FuncDef) else node
        if isinstance(node, c_ast.FuncDef):
            if node.decl.name in functions:
                raise ExpressionError(f"{node.coord}: function {node.decl.name} is defined twice")
            if node.param_decls:
                raise ExpressionError(f"{node.coord}: parameters are declared outside of brackets")
            functions[node.decl.name] = node
        if isinstance(declaration, c_ast.Decl) and isinstance(declaration.type, c_ast.FuncDecl):
            prototypes.setdefault(declaration.name, []).append(declaration)
        elif struct := _struct(node):
            structs[struct.name] = struct
        elif not _is_library(node):
            raise ExpressionError(
                f"{node.coord}: {type(node).__name__} {getattr(node, 'name', '')} outside of"
                " functions is not supported"
            )
    found = {name: tuple(known) for name, known in prototypes.items()}
    return Source(file, functions, found, structs, done.macros, done.asked)


@lru_cache(maxsize=64)
def _tree(text: str, file: str) -> Any:
    try:
        return CParser().parse(LIBRARY + text, file)
    except RecursionError:
        raise ExpressionError(f"{file}: brackets are nested too deeply") from None
    except Exception as error:
        # Parsers of different versions raise errors of different classes, all with the place.
        words = " ".join(str(error).split())
        raise ExpressionError(f"{file}: no C: {words or type(error).__name__}") from None


def _struct(node: Any) -> Any:
    """The struct that a typedef or declaration at file scope defines, if it is one."""
    kind = node.type if isinstance(node, c_ast.Decl) else None
    if isinstance(node, c_ast.Typedef) and isinstance(node.type, c_ast.TypeDecl):
        kind = node.type.type
    return kind if isinstance(kind, c_ast.Struct) and kind.decls else None


def _is_library(node: Any) -> bool:
    return isinstance(node, c_ast.Typedef) and f"{node.name};" in LIBRARY.split()
