"""The two generated files of a unit: model.h with sizes and tables, model.c with the functions."""

from collections.abc import Iterable, Sequence
from fractions import Fraction

from mechanics.compiled.c.source import function_source, literal
from mechanics.compiled.c.status import Codes
from mechanics.compiled.program import Program, program
from mechanics.compiled.step import Tableau
from mechanics.export.fmu.functions import Functions
from mechanics.export.fmu.variables import Variables
from mechanics.export.header import comment
from mechanics.scene.conditions import Condition

CODES = Codes("MODEL_OK", "MODEL_SINGULAR", "MODEL_OVERFLOW", "MODEL_BAD_INPUT")

HEADER = """\
/* {title} */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>

#define MODEL(name) {identifier}_##name
#define MODEL_TOKEN "{token}"

{sizes}

/* Status of the functions. */
enum {{ MODEL_OK, MODEL_SINGULAR, MODEL_OVERFLOW, MODEL_BAD_INPUT }};

/*
{table}
 */
extern const double MODEL(start)[MODEL_GIVEN];
extern const bool MODEL(positive)[MODEL_GIVEN];
extern const char *const MODEL(names)[MODEL_GIVEN + MODEL_WANTED];
{margins}
/* {method}: x(t + h) = x + h sum weight[i] k[i], with k[i] at t + share[i] h. */
extern const double MODEL(stage)[MODEL_STAGES][MODEL_STAGES];
extern const double MODEL(weight)[MODEL_STAGES], MODEL(share)[MODEL_STAGES];

/* Rates of the states, and what is wanted beside them, from all that is given. */
{rates};
{outputs};

/* Directional derivatives J seed, and adjoint ones seed^T J, of rates and outputs. */
{tangent};
{adjoint};

#endif /* MODEL_H */
"""
MARGINS = """\
extern const bool MODEL(edge_is_outside)[MODEL_MARGINS];
extern const char *const MODEL(otherwise)[MODEL_MARGINS];
"""


def model_header(
    title: str, identifier: str, token: str, variables: Variables, known: Functions,
    tableau: Tableau, beyond: bool,
) -> str:  # fmt: skip
    """Text of model.h."""
    sizes = {
        "GIVEN": len(variables.given),
        "STATES": len(variables.states),
        "INPUTS": len(variables.inputs),
        "WANTED": len(variables.wanted),
        "OUTPUTS": len(variables.outputs) + len(variables.margins),
        "MARGINS": len(variables.margins),
        "STAGES": len(tableau.b),
        "BEYOND": int(beyond),
    }
    heads = {name: _head(name, program(f), variables) for name, f in known.graphs.items()}
    rows = [
        f" * {v.reference:3}  {comment(v.name)}  {comment(v.unit) or '-'}".rstrip()
        for v in variables.every
    ]
    return HEADER.format(
        title=comment(title),
        identifier=identifier,
        token=token,
        sizes="\n".join(f"#define MODEL_{name} {size}" for name, size in sizes.items()),
        table="\n".join(rows),
        method=f"{tableau.name}, order {tableau.order}",
        margins=MARGINS if variables.margins else "",
        **heads,
    )


def model_source(
    title: str, variables: Variables, known: Functions, tableau: Tableau,
    conditions: Sequence[Condition],
) -> str:  # fmt: skip
    """Text of model.c."""
    stages = range(len(tableau.b))
    rows = [[_number(row[j]) if j < len(row) else "0.0" for j in stages] for row in tableau.a]
    parts = [
        f'/* {comment(title)} */\n#include "model.h"\n\n#include <math.h>\n',
        _array("double", "start", "MODEL_GIVEN", (literal(v.start or 0.0, "double")
                                                  for v in variables.given)),
        _array("bool", "positive", "MODEL_GIVEN", (str(v.positive).lower()
                                                   for v in variables.given)),
        _array("char *const", "names", "MODEL_GIVEN + MODEL_WANTED",
               (_string(v.name) for v in variables.every)),
        _array("double", "stage", "MODEL_STAGES][MODEL_STAGES",
               ("{" + ", ".join(row) + "}" for row in rows)),
        _array("double", "weight", "MODEL_STAGES", map(_number, tableau.b)),
        _array("double", "share", "MODEL_STAGES", (_number(sum(row)) for row in tableau.a)),
    ]  # fmt: skip
    if conditions:
        sentences = (f"it {c.otherwise} ({c.text} no longer holds)" for c in conditions)
        parts += [
            _array("bool", "edge_is_outside", "MODEL_MARGINS",
                   (str(c.strict).lower() for c in conditions)),
            _array("char *const", "otherwise", "MODEL_MARGINS", map(_string, sentences)),
        ]  # fmt: skip
    given = tuple(variable.name for variable in variables.given)
    for name, function in known.graphs.items():
        code = program(function)
        seeds = tuple(f"d {v.name}" for v in _seeds(name, variables))
        entries = {"given": given, "seed": seeds}
        parts.append(function_source(code, entries, head=_head(name, code, variables), codes=CODES))
    return "\n".join(parts)


def _seeds(name: str, variables: Variables) -> Sequence:
    return variables.wanted if name == "adjoint" else variables.given


def _head(name: str, code: Program, variables: Variables) -> str:
    """Prototype; the outputs of a unit without any are still an array of one, never touched."""
    arguments = [f"const double {group}[{size}]" for group, size in code.inputs]
    ((_, (rows, _)),) = code.shapes
    return f"int MODEL({name})({', '.join(arguments)},\n    double wanted[{max(rows, 1)}])"


def _array(kind: str, name: str, size: str, values: Iterable[str]) -> str:
    lines = "".join(f"    {value},\n" for value in values)
    return f"const {kind} MODEL({name})[{size}] = {{\n{lines}}};\n"


def _number(value: Fraction | float) -> str:
    return literal(float(value), "double")


def _string(text: str) -> str:
    """A C literal of UTF-8 text."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("?", "\\?")
    return f'"{escaped}"'
