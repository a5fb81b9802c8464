"""Code: Python functions on NumPy, C functions, CasADi functions.

def residual(theta, theta_dot, ...):       double acc(const double *q, ...)       Function(acc, ...)
    return M*x_ddot + ... - f              { return ...; }

A function returns a residual, all accelerations, an energy or the mass matrix; its arguments are
numbers, or vectors of coordinates, speeds, accelerations, inputs and parameters.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from random import Random

import casadi
import numpy as np
from sympy import Symbol

from benchmarks.detection.forms.plain import Notation, Plain
from benchmarks.detection.forms.spelling import Labels, Written, labels, plain_name, quotient
from benchmarks.detection.rows import Row, Subject
from benchmarks.detection.tree import Tree, negative, places, symbol, symbols, total

IMPORTS = (
    ("np.", "import numpy as np"),
    ("math.", "import math"),
    ("", "from numpy import sin, cos, tan, sqrt, pi, array"),
)

Groups = tuple[tuple[str, tuple[Symbol, ...]], ...]


@dataclass(frozen=True)
class Program:
    """What a function returns, and what it is given.

    Attributes
    ----------
    outputs : tuple of Tree
    place : int
        Of the statement among those that are read.
    about : str or None
    groups : tuple of (str, symbols)
        Arguments that are vectors; empty where every argument is a number.
    scalars : tuple of Symbol
    columns : int
        Of the matrix that is returned; 0 for numbers side by side.
    labels : dict
        What the person calls the symbols.
    names : mapping of str to str
        What is called otherwise: names of the scene to the person's.
    """

    outputs: tuple[Tree, ...]
    place: int
    about: str | None
    groups: Groups
    scalars: tuple[Symbol, ...]
    columns: int
    labels: Labels
    names: Mapping[str, str]

    @property
    def options(self) -> dict[str, object]:
        """For `mechanics.check`."""
        names = {name: " ".join(s.name for s in group) for name, group in self.groups}
        # An argument that is renamed is told with its rates, each of which is an argument too.
        names |= {self.called(s): s.name for s in self.scalars if self.called(s) != s.name}
        return {"about": self.about} | ({"names": names} if names else {})

    def called(self, symbol: Symbol) -> str:
        """What the person calls an argument."""
        return plain_name(self.labels.get(symbol, (symbol.name, 0)))

    @property
    def spelled(self) -> dict[Symbol, str]:
        """How every symbol is typed."""
        entries = {s: f"{name}[{i}]" for name, group in self.groups for i, s in enumerate(group)}
        return {s: self.called(s) for s in self.scalars} | entries

    @property
    def arguments(self) -> list[str]:
        """Names of all arguments."""
        return [*(name for name, _ in self.groups), *map(self.called, self.scalars)]


def program(
    about: Subject, row: Row, trees: tuple[Tree, ...], names: Mapping[str, str], source: Random
) -> Program | None:
    """A function for a statement; None for one that functions do not claim."""
    scene = about.scene
    moving = set(scene.ud) & set().union(*map(symbols, row.trees))
    if row.equation and not moving:
        return None
    outputs, place, words, columns = trees, 0, str(row.about), 0
    if row.about == "mass matrix":
        columns = len(scene.u)
    elif (
        row.about == "acceleration"
        and trees[0] == row.trees[0]
        and _explicit(about)
        # With accelerations among its arguments a function returns residuals.
        and not symbols(trees[1]) & set(scene.ud)
    ):
        place = scene.ud.index(trees[0].value)
        outputs = tuple(trees[1] if i == place else t for i, t in enumerate(_explicit(about)))
        words = ""
    elif row.equation:
        outputs, words = (total(trees[0], negative(trees[1])),), "equation of motion"
    order = (*scene.q, *scene.u, *scene.ud, *scene.input_symbols, *scene.parameters)
    used = set().union(*map(symbols, outputs))
    rest = tuple(sorted(used - set(order), key=str))
    scalars = (*(s for s in order if s in used), *rest)
    groups: Groups = ()
    if source.random() < 0.4:
        named = (("q", scene.q), ("v", scene.u), ("a", scene.ud), ("w", scene.input_symbols),
                 ("par", scene.parameters))  # fmt: skip
        groups = tuple((name, group) for name, group in named if len(group) > 1
                       and used & set(group) and not _taken(name, scalars, group))  # fmt: skip
        grouped = {s for _, group in groups for s in group}
        scalars = tuple(s for s in scalars if s not in grouped)
    called = labels(scene, names)
    return Program(outputs, place, words or None, groups, scalars, columns, called, names)


def _taken(name: str, scalars: Sequence[Symbol], group: Sequence[Symbol]) -> bool:
    return any(s.name == name for s in scalars if s not in group)


def _explicit(about: Subject) -> tuple[Tree, ...]:
    """Right accelerations, all of them or none."""
    found = {row.trees[0].value: row.trees[1] for row in about.rows if row.about == "acceleration"}
    return tuple(found[s] for s in about.scene.ud) if set(about.scene.ud) <= found.keys() else ()


def _shared(outputs: Sequence[Tree]) -> tuple[list[tuple[str, Tree]], list[Tree]]:
    """Sines and cosines of single symbols as local variables."""
    table: dict[Tree, str] = {}

    def changed(tree: Tree) -> Tree:
        if tree.kind in ("sin", "cos", "tan") and tree.parts[0].kind == "symbol":
            table.setdefault(tree, f"{tree.kind[0]}_{tree.parts[0].value}")
            return symbol(Symbol(table[tree]))
        return Tree(tree.kind, tree.value, tuple(map(changed, tree.parts)))

    found = [changed(tree) for tree in outputs]
    return [(name, tree) for tree, name in table.items()], found


def _signs(made: Program) -> bool:
    """Whether a function holds the sign function, which C does not have."""
    return any(node.kind == "sign" for tree in made.outputs for _, node in places(tree))


def python(
    about: Subject, row: Row, trees: tuple[Tree, ...], names: Mapping[str, str], source: Random
) -> Written | None:
    """A Python function, from its source."""
    made = program(about, row, trees, names, source)
    if made is None:
        return None
    prefix, head = source.choice(IMPORTS)
    if _signs(made):
        prefix, head = IMPORTS[0]  # math has no sign()
    matrix = f"{'np.' if prefix == 'np.' else ''}array" if prefix != "math." else ""
    point = source.random() < 0.3
    write = Plain(
        Notation("*", "/", "**", made.spelled, point=point, prefix=prefix, pi=f"{prefix}pi")
    )
    lines, outputs = [], list(made.outputs)
    if source.random() < 0.5:
        shared, outputs = _shared(outputs)
        lines = [f"    {name} = {write(tree)}" for name, tree in shared]
    words = [write(tree) for tree in outputs]
    if made.columns:
        n = made.columns
        rows = [f"[{', '.join(words[i : i + n])}]" for i in range(0, n * n, n)]
        returned = f"{matrix}([{', '.join(rows)}])"
    else:
        returned = ", ".join(words)
    opening = f"def model({', '.join(made.arguments)}):"
    text = "\n".join([head, "", "", opening, *lines, f"    return {returned}"])
    space: dict[str, object] = {}
    exec(compile(text, "<a person's code>", "exec"), space)
    return Written(space["model"], made.options, text, made.place)


def c_source(
    about: Subject, row: Row, trees: tuple[Tree, ...], names: Mapping[str, str], source: Random
) -> Written | None:
    """A C function."""
    made = program(about, row, trees, names, source)
    if made is None or made.columns or _signs(made):
        return None
    point = source.random() < 0.3
    write = Plain(
        Notation(
            " * ",
            " / ",
            "",
            made.spelled,
            point=point,
            decimal=True,
            call="pow",
            modulus="fabs",
            pi="M_PI",
        )
    )
    lines, outputs = [], list(made.outputs)
    if source.random() < 0.5:
        shared, outputs = _shared(outputs)
        lines = [f"    const double {name} = {write(tree)};" for name, tree in shared]
    heads = [f"const double {name}[{len(group)}]" for name, group in made.groups]
    heads += [f"double {made.called(s)}" for s in made.scalars]
    if len(outputs) == 1:
        kind, body = "double", [f"    return {write(outputs[0])};"]
    else:
        kind, heads = "void", [*heads, f"double out[{len(outputs)}]"]
        body = [f"    out[{i}] = {write(tree)};" for i, tree in enumerate(outputs)]
    text = "\n".join(["#include <math.h>", "", f"{kind} model({', '.join(heads)})", "{",
                      *lines, *body, "}", ""])  # fmt: skip
    return Written(text, {"notation": "c"} | made.options, text, made.place)


def casadi_function(
    about: Subject, row: Row, trees: tuple[Tree, ...], names: Mapping[str, str], source: Random
) -> Written | None:
    """A CasADi function."""
    made = program(about, row, trees, names, source)
    if made is None:
        return None
    table: dict[Symbol, casadi.SX] = {s: casadi.SX.sym(made.called(s)) for s in made.scalars}
    inputs = []
    for name, group in made.groups:
        vector = casadi.SX.sym(name, len(group))
        table |= {s: vector[i] for i, s in enumerate(group)}
        inputs.append(vector)
    inputs += [table[s] for s in made.scalars]
    entries = [_casadi(tree, table) for tree in made.outputs]
    n = made.columns
    value = casadi.vertcat(*entries) if not n else casadi.vertcat(
        *(casadi.horzcat(*entries[i : i + n]) for i in range(0, n * n, n))
    )  # fmt: skip
    function = casadi.Function("model", inputs, [value], made.arguments, ["out"])
    words = f"model({', '.join(made.arguments)}) -> {value}"
    return Written(function, made.options, words, made.place)


def _casadi(tree: Tree, table: dict[Symbol, casadi.SX]) -> casadi.SX:
    functions: dict[str, Callable[[casadi.SX], casadi.SX]] = {
        "sin": casadi.sin, "cos": casadi.cos, "tan": casadi.tan, "sign": casadi.sign,
        "Abs": casadi.fabs,
    }  # fmt: skip
    match tree.kind:
        case "symbol":
            return table[tree.value]
        case "pi":
            return casadi.SX(np.pi)
        case "number":
            return casadi.SX(int(tree.value.numerator)) / int(tree.value.denominator)
        case "sum":
            terms = [_casadi(part, table) for part in tree.parts]
            return sum(terms[1:], terms[0])
        case "power" if tree.parts[1].value > 0:
            exponent = tree.parts[1].value
            if exponent.denominator > 1:
                return _casadi(tree.parts[0], table) ** float(exponent)
            return prod([_casadi(tree.parts[0], table)] * int(exponent), start=casadi.SX(1))
        case "product" | "power":
            parts = quotient(tree)
            result = prod((_casadi(f, table) for f in parts.above), start=casadi.SX(1))
            for factor in parts.below:
                result = result / _casadi(factor, table)
            return -result if parts.negative else result
    return functions[tree.kind](_casadi(tree.parts[0], table))
