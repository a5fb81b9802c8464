"""Functions of the C library, and those that stand in for them, as operations.

``sin(x)`` takes and gives doubles, ``sinf(x)`` floats; C converts silently, which is refused here.
"""

import re
from typing import NamedTuple

from mechanics.program.composed import COMPOSED
from mechanics.program.operations import OPERATIONS


class Known(NamedTuple):
    """Operation, number of arguments and type."""

    operation: str
    arity: int
    kind: str


_TABLE = {
    match[1]: (row.name, row.arity)
    for row in OPERATIONS
    if (match := re.fullmatch(r"(\w+)\(\{\}(?:, \{\})*\)", row.c))
}
_COMPOSED = ("expm1", "log1p", "ceil", "hypot", "copysign", "fmod", "fmax", "fmin")
_NAMES = {
    **_TABLE,
    **{name: (name, COMPOSED[name].arity) for name in _COMPOSED},
    "mechanics_sin": ("sin", 1),
    "mechanics_cos": ("cos", 1),
}
_KINDS = (("", "double"), ("f", "float"))

FUNCTIONS = {
    f"{name}{suffix}": Known(operation, arity, kind)
    for name, (operation, arity) in _NAMES.items()
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

ARITHMETIC = {"+": "add", "-": "subtract", "*": "multiply", "/": "divide"}
