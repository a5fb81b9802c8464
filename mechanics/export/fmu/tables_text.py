"""tables.h and tables.c of a unit: start values, names, conditions, the integrator's numbers."""

from collections.abc import Iterable, Sequence
from fractions import Fraction

from mechanics.compiled.c.source import literal
from mechanics.compiled.step import Tableau
from mechanics.export.fmu.variables import Variables
from mechanics.export.header import comment
from mechanics.scene.conditions import Condition

HEADER = """\
/* {title}: what belongs to the variables of the unit, by value reference. */
#ifndef TABLES_H
#define TABLES_H

#include "model.h"

#include <stdbool.h>

#define MODEL(name) {identifier}_##name
#define MODEL_TOKEN "{token}"
#define MODEL_BEYOND {beyond}

extern const double MODEL(start)[MODEL_GIVEN];
extern const bool MODEL(positive)[MODEL_GIVEN];
extern const char *const MODEL(names)[MODEL_GIVEN + MODEL_WANTED];
{margins}
/* {method}: x(t + h) = x + h sum weight[i] k[i], with k[i] at t + share[i] h. */
#define MODEL_STAGES {stages}
extern const double MODEL(stage)[MODEL_STAGES][MODEL_STAGES];
extern const double MODEL(weight)[MODEL_STAGES], MODEL(share)[MODEL_STAGES];

#endif /* TABLES_H */
"""
MARGINS = """\
extern const bool MODEL(edge_is_outside)[MODEL_MARGINS];
extern const char *const MODEL(otherwise)[MODEL_MARGINS];
"""


def tables_header(
    title: str, identifier: str, token: str, beyond: bool, conditions: bool, tableau: Tableau
) -> str:
    """Text of tables.h."""
    return HEADER.format(
        title=comment(title),
        identifier=identifier,
        token=token,
        beyond=int(beyond),
        margins=MARGINS if conditions else "",
        method=f"{tableau.name}, order {tableau.order}",
        stages=len(tableau.b),
    )


def tables_source(variables: Variables, conditions: Sequence[Condition], tableau: Tableau) -> str:
    """Text of tables.c."""
    stages = len(tableau.b)
    rows = (", ".join(map(_number, [*row, *[0.0] * (stages - len(row))])) for row in tableau.a)
    parts = [
        '#include "tables.h"\n',
        _table("double", "start[MODEL_GIVEN]", (_number(v.start or 0.0) for v in variables.given)),
        _table("bool", "positive[MODEL_GIVEN]", (_truth(v.positive) for v in variables.given)),
        _table(
            "char *const",
            "names[MODEL_GIVEN + MODEL_WANTED]",
            (_string(v.name) for v in variables.every),
        ),
        _table("double", "stage[MODEL_STAGES][MODEL_STAGES]", (f"{{{row}}}" for row in rows)),
        _table("double", "weight[MODEL_STAGES]", map(_number, tableau.b)),
        _table("double", "share[MODEL_STAGES]", (_number(sum(row)) for row in tableau.a)),
    ]
    if conditions:
        sentences = (f"it {c.otherwise} ({c.text} no longer holds)" for c in conditions)
        parts += [
            _table(
                "bool", "edge_is_outside[MODEL_MARGINS]", (_truth(c.strict) for c in conditions)
            ),
            _table("char *const", "otherwise[MODEL_MARGINS]", map(_string, sentences)),
        ]
    return "\n".join(parts)


def _table(kind: str, declarator: str, values: Iterable[str]) -> str:
    name, bracket, sizes = declarator.partition("[")
    lines = "".join(f"    {value},\n" for value in values)
    return f"const {kind} MODEL({name}){bracket}{sizes} = {{\n{lines}}};\n"


def _number(value: Fraction | float) -> str:
    return literal(float(value), "double")


def _truth(value: bool) -> str:
    return str(value).lower()


def _string(text: str) -> str:
    """A C literal of UTF-8 text."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("?", "\\?")
    return f'"{escaped}"'
