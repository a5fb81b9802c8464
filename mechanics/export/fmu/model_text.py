"""model.h and model.c of a unit: its functions of everything that is given.

    int NAME_rates(const double given[9], double wanted[4])

They hold functions and nothing else, so that the reader of C texts can prove them.
"""

from collections.abc import Sequence

from mechanics.compiled.c.source import function_source
from mechanics.compiled.c.status import Codes
from mechanics.export.fmu.functions import Functions
from mechanics.export.fmu.variables import Variable, Variables
from mechanics.export.header import comment
from mechanics.export.precision import careful
from mechanics.program.casadi_reader import read_routine
from mechanics.program.routine import Routine

CODES = Codes("MODEL_OK", "MODEL_SINGULAR", "MODEL_OVERFLOW", "MODEL_BAD_INPUT")

HEADER = """\
/*
 * {title}.
 *
{table}
 */
#ifndef MODEL_H
#define MODEL_H

{sizes}

/* Status: fine, a divisor is zero, a value is too large, a given value is no number. */
{codes}

/* Rates of the states, and what is wanted beside them, from all that is given. */
{rates};
{outputs};

/* Directional derivatives J seed, and adjoint ones seed^T J, of rates and outputs. */
{tangent};
{adjoint};

#endif /* MODEL_H */
"""


def symbol(identifier: str, function: str) -> str:
    """Name of a function in C."""
    return f"{identifier}_{function}"


def model_header(title: str, identifier: str, variables: Variables, known: Functions) -> str:
    """Text of model.h."""
    sizes = {
        "GIVEN": len(variables.given),
        "STATES": len(variables.states),
        "INPUTS": len(variables.inputs),
        "WANTED": len(variables.wanted),
        "OUTPUTS": len(variables.outputs) + len(variables.margins),
        "MARGINS": len(variables.margins),
    }
    codes = (CODES.ok, CODES.singular, CODES.overflow, CODES.bad_input)
    return HEADER.format(
        title=comment(title),
        table="\n".join(_rows("given", variables.given) + _rows("wanted", variables.wanted)),
        sizes="\n".join(f"#define MODEL_{name} {size}" for name, size in sizes.items()),
        codes="\n".join(f"#define {name} {number}" for number, name in enumerate(codes)),
        **{name: _head(identifier, name, read_routine(f)) for name, f in known.graphs.items()},
    )


def _rows(array: str, variables: Sequence[Variable]) -> list[str]:
    return [
        f" *   {array}[{i}]  {comment(v.name)}  {comment(v.unit)}".rstrip()
        for i, v in enumerate(variables)
    ]


def model_source(title: str, identifier: str, variables: Variables, known: Functions) -> str:
    """Text of model.c."""
    parts = [
        f'/* {comment(title)}. */\n#include "model.h"\n\n#include <math.h>\n',
        careful("MODEL"),
    ]
    given = tuple(variable.name for variable in variables.given)
    for name, function in known.graphs.items():
        code = read_routine(function)
        seeds = variables.wanted if name == "adjoint" else variables.given
        entries = {"given": given, "seed": tuple(f"d_{variable.name}" for variable in seeds)}
        head = _head(identifier, name, code)
        parts.append(function_source(code, entries, head=head, codes=CODES))
    return "\n".join(parts)


def _head(identifier: str, name: str, code: Routine) -> str:
    """Prototype; the outputs of a unit without any are still an array of one, never touched."""
    arguments = [f"const double {group}[{size}]" for group, size in code.inputs]
    ((wanted, (rows, _)),) = code.shapes
    arguments.append(f"double {wanted}[{max(rows, 1)}]")
    return f"int {symbol(identifier, name)}({', '.join(arguments)})"
