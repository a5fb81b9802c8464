"""Functions of the C library, and those that stand in for them, as operations.

``sin(x)`` takes and gives doubles, ``sinf(x)`` floats; C converts silently, which is refused here.
"""

from __future__ import annotations

from typing import NamedTuple

import casadi


class Known(NamedTuple):
    """Operation, number of arguments and type."""

    op: int
    arity: int
    kind: str


_ONE = {
    "sin": casadi.OP_SIN, "cos": casadi.OP_COS, "tan": casadi.OP_TAN, "sqrt": casadi.OP_SQRT,
    "fabs": casadi.OP_FABS, "asin": casadi.OP_ASIN, "acos": casadi.OP_ACOS, "atan": casadi.OP_ATAN,
    "sinh": casadi.OP_SINH, "cosh": casadi.OP_COSH, "tanh": casadi.OP_TANH,
    "asinh": casadi.OP_ASINH, "acosh": casadi.OP_ACOSH, "atanh": casadi.OP_ATANH,
    "exp": casadi.OP_EXP, "expm1": casadi.OP_EXPM1, "log": casadi.OP_LOG,
    "log1p": casadi.OP_LOG1P, "erf": casadi.OP_ERF, "floor": casadi.OP_FLOOR,
    "ceil": casadi.OP_CEIL, "mechanics_sin": casadi.OP_SIN, "mechanics_cos": casadi.OP_COS,
}  # fmt: skip
_TWO = {
    "pow": casadi.OP_POW, "atan2": casadi.OP_ATAN2, "hypot": casadi.OP_HYPOT,
    "copysign": casadi.OP_COPYSIGN,
    "fmod": casadi.OP_FMOD, "fmax": casadi.OP_FMAX, "fmin": casadi.OP_FMIN,
}  # fmt: skip

_KINDS = (("", "double"), ("f", "float"))

FUNCTIONS = {
    f"{name}{suffix}": Known(op, arity, kind)
    for arity, table in ((1, _ONE), (2, _TWO))
    for name, op in table.items()
    for suffix, kind in _KINDS
}
SINCOS = {
    f"{name}{suffix}": kind for name in ("sincos", "mechanics_sincos") for suffix, kind in _KINDS
}
"""``name(x, &sine, &cosine)``."""

FAR = {f"mechanics_far{suffix}": kind for suffix, kind in _KINDS}
"""Whether an angle is beyond what the inline sine and cosine can do."""

FUSED = {f"{name}{suffix}": kind for name in ("fma", "mechanics_fma") for suffix, kind in _KINDS}
"""x y + z, rounded once or twice."""

TRUTHS = frozenset({
    casadi.OP_LT, casadi.OP_LE, casadi.OP_EQ, casadi.OP_NE, casadi.OP_AND, casadi.OP_OR,
    casadi.OP_NOT,
})  # fmt: skip
"""Operations whose value is 0 or 1."""

ARITHMETIC = {
    "+": casadi.OP_ADD, "-": casadi.OP_SUB, "*": casadi.OP_MUL, "/": casadi.OP_DIV,
}  # fmt: skip
RELATIONS = {"<": casadi.OP_LT, "<=": casadi.OP_LE, "==": casadi.OP_EQ}
