"""Equations that are too long for one formula: line by line, for people and for NumPy.

0 = rows(q, u, u', lambda)        M u' - f - B lambda
0 = A u' - b
"""

import keyword
import re
from collections.abc import Mapping

from sympy import Expr, Symbol
from sympy.printing.numpy import NumPyPrinter

from mechanics.compiled.bordered import bind
from mechanics.compiled.fixed import Fixed
from mechanics.compiled.quantities import quantities
from mechanics.equations import Equations
from mechanics.kinematics.printer import symbols
from mechanics.program import Program
from mechanics.program.listing import Listing, listing
from mechanics.report.notation import latex
from mechanics.routes.rows import acceleration_forms

GROUPS = ("q", "u", "ud", "multipliers", "inputs", "p")

MODULE = '''"""{title}

    residual(...) = 0        M u' - f - B lambda, then A u' - b

Arrays and their entries, in SI units:

{entries}
"""

import numpy


def residual({groups}):
    """What is zero along every motion, shape ({rows},)."""
{lines}
    return numpy.array([{outputs}], dtype=float)


def solution({state}):
    """The accelerations u', shape ({speeds},), then the multipliers."""
    rest = residual({at_rest})
    columns = [residual({at_unit}) - rest for unit in numpy.eye({rows})]
    return numpy.linalg.solve(numpy.array(columns).T, -rest)
'''


def program_text(equations: Equations, fixed: Fixed) -> str:
    """One assignment a line, then the equations."""
    found = _listing(equations, fixed)
    lines = [f"{equations.scene.name}, by {equations.route}"]
    lines += [f"{name} = {value}" for name, value in found.lines]
    lines += [f"0 = {row}" for row in found.outputs["rows"]]
    return "\n".join(lines)


def program_latex(equations: Equations, fixed: Fixed) -> str:
    """The same in LaTeX."""
    found = _listing(equations, fixed)
    rows = [f"{latex(_subscript(name))} &= {_typeset(value)}" for name, value in found.lines]
    rows += [f"0 &= {_typeset(row)}" for row in found.outputs["rows"]]
    return "\\begin{align}\n" + " \\\\\n".join(rows) + "\n\\end{align}"


def program_python(equations: Equations, fixed: Fixed) -> str:
    """A module of NumPy: the residual of the equations, and what solves them."""
    found, known = _listing(equations, fixed), quantities(equations, fixed, with_reactions=False)
    groups = {group: [entry.symbol for entry in getattr(known, group)] for group in GROUPS}
    every = [symbol for group in groups.values() for symbol in group]
    names = _names(every, {*GROUPS, "numpy", *(str(name) for name, _ in found.lines)})
    printer = NumPyPrinter({"fully_qualified_modules": True})

    def printed(value: Expr) -> str:
        return str(printer.doprint(value.xreplace({s: Symbol(n) for s, n in names.items()})))

    lines = [
        f"    {''.join(names[s] + ', ' for s in group)}= {name}"
        for name, group in groups.items() if group
    ]  # fmt: skip
    lines += [f"    {name} = {printed(value)}" for name, value in found.lines]
    rows, speeds = found.outputs["rows"], len(known.ud)
    # An array without entries is no argument.
    used = [group for group in GROUPS if groups[group]]

    def called(unknown: str) -> str:
        parts = {"ud": f"{unknown}[:{speeds}]", "multipliers": f"{unknown}[{speeds}:]"}
        return ", ".join(parts.get(group, group) for group in used)

    return MODULE.format(
        title=" ".join(f"Equations of motion of {equations.scene.name}, by"
                       f" {equations.route}.".split()),
        entries="\n".join(f"    {name}: {' '.join(map(str, groups[name]))}" for name in used),
        groups=", ".join(used), rows=len(rows), lines="\n".join(lines),
        outputs=", ".join(map(printed, rows)), speeds=speeds,
        state=", ".join(group for group in used if group not in ("ud", "multipliers")),
        at_rest=called(f"numpy.zeros({len(rows)})"), at_unit=called("unit"),
    )  # fmt: skip


def _listing(equations: Equations, fixed: Fixed) -> Listing:
    return listing(_program(equations, fixed), symbols(equations.scene))


def _program(equations: Equations, fixed: Fixed) -> Program:
    mechanism, rows = equations.program
    every = [*rows.values, *acceleration_forms(mechanism)]
    program = mechanism.builder.program({"rows": every})
    if not fixed:
        return program
    build, nodes = bind(program, {symbol.name: value for symbol, value in fixed.items()})
    return build.program(nodes)


def _subscript(name: Symbol) -> Symbol:
    """x12 as x_12."""
    return Symbol(re.sub(r"^([a-z])(\d+)$", r"\1_\2", name.name), real=True)


def _typeset(value: Expr) -> str:
    own = {s: _subscript(s) for s in value.free_symbols if re.fullmatch(r"[a-z]\d+", s.name)}
    return latex(value.xreplace(own))


def _names(wanted: list[Symbol], taken: set[str]) -> Mapping[Symbol, str]:
    """Python names: no keyword, nothing used twice."""
    found: dict[Symbol, str] = {}
    for symbol in wanted:
        name = re.sub(r"\W", "_", symbol.name)
        name = name if name.isidentifier() else f"_{name}"
        while keyword.iskeyword(name) or name in taken:
            name += "_"
        taken.add(name)
        found[symbol] = name
    return found
