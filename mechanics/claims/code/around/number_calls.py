"""Calls that make a number of numbers, as far as their values are known: abs(-0.5), sum([1, -2]).

An exact result is exact, another one is that of floats.
"""

import math
from collections.abc import Callable, Sequence
from fractions import Fraction

EXACT: dict[str, Callable[..., Fraction]] = {
    "abs": abs, "absolute": abs, "fabs": abs,
    "copysign": lambda a, b: abs(a) if b >= 0 else -abs(a),
    "neg": lambda a: -a, "negative": lambda a: -a, "positive": lambda a: a,
    "int": lambda a: Fraction(int(a)), "trunc": lambda a: Fraction(int(a)),
    "fix": lambda a: Fraction(int(a)), "div": lambda a, b: Fraction(int(a / b)),
    "fld": lambda a, b: Fraction(a // b), "cld": lambda a, b: Fraction(-(-a // b)),
    "floor": lambda a: Fraction(math.floor(a)), "ceil": lambda a: Fraction(math.ceil(a)),
    "round": lambda a, n=0: round(Fraction(a), int(n)),
    "sign": lambda a: Fraction((a > 0) - (a < 0)),
    "max": max, "min": min, "maximum": max, "minimum": min, "fmax": max, "fmin": min,
    "add": lambda a, b: a + b, "subtract": lambda a, b: a - b, "multiply": lambda a, b: a * b,
    "divide": lambda a, b: a / b, "Fraction": lambda a, b=1: Fraction(a) / b,
    "Decimal": lambda a: a,
    "pow": lambda a, b=1: _power(a, b),
    "float32": lambda a: a, "float16": lambda a: a, "longdouble": lambda a: a,
}  # fmt: skip
OF_LISTS: dict[str, Callable[[Sequence[Fraction]], Fraction]] = {
    "sum": lambda a: sum(a, Fraction(0)), "fsum": lambda a: sum(a, Fraction(0)),
    "prod": lambda a: math.prod(a, start=Fraction(1)),
    "max": lambda a: max(a), "min": lambda a: min(a),
    "mean": lambda a: sum(a, Fraction(0)) / len(a),
}  # fmt: skip
FLOATS: dict[str, Callable[..., float]] = {
    "sqrt": math.sqrt, "sin": math.sin, "cos": math.cos, "tan": math.tan, "exp": math.exp,
    "log": math.log, "radians": math.radians, "deg2rad": math.radians, "degrees": math.degrees,
    "rad2deg": math.degrees, "hypot": math.hypot, "sinh": math.sinh, "cosh": math.cosh,
    "tanh": math.tanh, "atan": math.atan, "arctan": math.atan, "atan2": math.atan2,
    "arctan2": math.atan2,
}  # fmt: skip
MOST_POWER = 64
"""Of a number that is written out; the exact result of a larger one is too long."""
KNOWN = EXACT.keys() | OF_LISTS.keys() | FLOATS.keys()


def computed(name: str, values: Sequence[Fraction], *, in_list: bool = False) -> Fraction | None:
    """What a call of numbers gives; None where it is not known, or there is no such number.

    Parameters
    ----------
    name : str
    values : sequence of Fraction
    in_list : bool
        Whether they are given as one list.
    """
    plain = [Fraction(v) for v in values]
    try:
        if in_list:
            return OF_LISTS[name](plain) if name in OF_LISTS and plain else None
        if name in EXACT:
            return Fraction(EXACT[name](*plain))
        return Fraction(FLOATS[name](*map(float, plain))) if name in FLOATS else None
    except (ArithmeticError, TypeError, ValueError):
        return None


def _power(base: Fraction, power: Fraction) -> Fraction:
    if power.denominator == 1 and abs(power) <= MOST_POWER:
        return Fraction(base ** int(power))
    return Fraction(float(base) ** float(power))  # of a number below zero it is complex: no number
