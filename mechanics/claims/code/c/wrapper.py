"""A C function called by one whose arguments are arrays only.

    double f(double x, const double *p)   ->   void wrapper(const double *x, const double *p,
                                                            double *outputs)
                                               { outputs[0] = f(x[0], p); }

Pointers to what is constant or only read are inputs, other pointers outputs, which are inputs, too,
where their entries are read first; a number that is returned is the first output.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from pycparser import c_ast

from mechanics.claims.code.c.pointers import refuse_vain, use_of
from mechanics.errors import ExpressionError, InputError
from mechanics.program.c.parse import Source
from mechanics.program.c.types import declared, parameters

WRAPPER = "mechanics_wrapper_of_a_function"
LARGEST_ARRAY = 64


@dataclass(frozen=True)
class Call:
    """How a function is called.

    Attributes
    ----------
    name : str
    text : str
        The file.
    inputs : dict of str to int or None
        Entries of each input; 1 for a number, None where the text does not tell.
    arguments : tuple of str
        What stands in the call, in order; outputs at their place among `outputs`.
    size : int
        Number of outputs.
    result : bool
        Whether it returns a number.
    outputs : tuple of str
        What the text calls the outputs, where each is a number of its own, or all are one
        array; its name for a result.
    coord : str
        Where it begins: file, line and column.
    begins : tuple of str
        Statements that give outputs what they are before the call, where it reads them.
    """

    name: str
    text: str
    inputs: dict[str, int | None]
    arguments: tuple[str, ...]
    size: int
    result: bool
    coord: str
    outputs: tuple[str, ...] = ()
    begins: tuple[str, ...] = ()

    def source(self, sizes: Mapping[str, int]) -> str:
        """The file with the wrapper below."""
        heads = [f"const double {name}[{sizes[name]}]" for name in self.inputs]
        head = ", ".join([*heads, f"double outputs[{self.size}]"])
        call = f"{self.name}({', '.join(self.arguments)})"
        body = f"outputs[0] = {call};" if self.result else f"{call};"
        body = " ".join((*self.begins, body))
        return f"{self.text}\nvoid {WRAPPER}({head})\n{{\n{body}\n}}\n"


def wrapped(source: Source, text: str, name: str | None) -> Call:
    """How a function of a file is called.

    Raises
    ------
    InputError
        When there is no such function, or an argument is neither number nor array.
    """
    if WRAPPER in text:
        raise InputError(f"{source.file}: the name {WRAPPER} is taken")
    known = list(source.functions)
    if not known:
        raise InputError(f"{source.file}, line 1, column 1: there is no function in it")
    chosen = name or known[-1]
    if chosen not in source.functions:
        raise InputError(
            f"{source.file}: there is no function {chosen}: there are {', '.join(known)}"
        )
    function = source.functions[chosen]
    result = re.search(r"\bdouble\b", _returned(function)) is not None
    inputs: dict[str, int | None] = {}
    arguments: list[str] = []
    begins: list[str] = []
    size = 1 if result else 0
    outputs = [chosen] if result else []
    for declaration in parameters(function.decl.type):
        kind = declared(declaration)
        if kind.kind != "double" or kind.depth > 1:
            raise InputError(
                f"{declaration.coord}: argument {declaration.name} is {kind.words}: numbers and"
                " arrays of double are known"
            )
        if kind.depth == 0:
            inputs[declaration.name] = 1
            arguments.append(f"{declaration.name}[0]")
        elif kind.constant:
            inputs[declaration.name] = kind.size
            arguments.append(declaration.name)
        else:
            entries = kind.size or _written(text, declaration.name)
            refuse_vain(function.body, declaration.name)
            entries = max(entries, *_passed(source, function.body, declaration.name), 1)
            if use_of(function.body, declaration.name).read_first:
                inputs[declaration.name] = entries
                begins += [
                    f"outputs[{size + i}] = {declaration.name}[{i}];" for i in range(entries)
                ]
            arguments.append(f"outputs + {size}")
            size += entries
            outputs.append(declaration.name)
    if not 0 < size <= LARGEST_ARRAY:
        raise InputError(f"{source.file}: {chosen} has {size} outputs")
    coord, named = str(function.decl.coord), tuple(outputs) if len(outputs) in (1, size) else ()
    return Call(chosen, text, inputs, tuple(arguments), size, result, coord, named, tuple(begins))


def _returned(function: object) -> str:
    kind = function.decl.type.type  # type: ignore[attr-defined]
    names = getattr(getattr(kind, "type", None), "names", None)
    if names is None:
        raise ExpressionError("a function that returns a pointer or struct is not supported")
    return " ".join(names)


def _passed(source: Source, node: Any, name: str) -> list[int]:
    """Sizes that other functions of the file say that an argument has, to which it is passed."""
    found: list[int] = [0]
    if isinstance(node, c_ast.FuncCall) and node.args is not None:
        called = source.functions.get(getattr(node.name, "name", ""))
        known = parameters(called.decl.type) if called is not None else []
        for declaration, argument in zip(known, node.args.exprs, strict=False):
            if getattr(argument, "name", None) == name:
                found.append(declared(declaration).size or 0)
    for _, child in node.children():
        found += _passed(source, child, name)
    return found


def _written(text: str, name: str) -> int:
    """Entries of an output whose size the text does not declare: the largest index it has."""
    indices = [int(i) for i in re.findall(rf"\b{re.escape(name)}\s*\[\s*(\d{{1,3}})\s*\]", text)]
    return max(indices, default=0) + 1
