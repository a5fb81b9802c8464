"""Parameters: the constants of a scene, with unit, meaning and a typical value."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, Self

from sympy import Expr, Rational, Symbol, pi

from mechanics.errors import RangeError, SceneError
from mechanics.program.constants import with_pi
from mechanics.scene.unit_names import dimension_of_unit

NEAR_PI = Fraction("3.14159265358979323846264338327950288419716939937510582")


class Parameter(Symbol):
    """A SymPy symbol that knows its unit, its meaning and a typical value.

    `typical` is a fraction: of a multiple of pi one that agrees to 50 digits. `exact` is what was
    typed.

    Two parameters are equal when all that is equal. SymPy caches expressions by equality, so that
    with less the `l1` of one scene would come back in another that has an `l1` of its own.
    """

    __slots__ = ("half_turns", "meaning", "typical", "unit")

    unit: str
    meaning: str
    typical: Fraction | None
    half_turns: Fraction | None

    def __new__(  # noqa: D102 (the class says it)
        cls,
        name: str,
        unit: str = "",
        meaning: str = "",
        typical: Fraction | None = None,
        half_turns: Fraction | None = None,
        **assumptions: Any,
    ) -> Self:
        # __xnew__ is SymPy's uncached constructor: a cached one would share the attributes.
        parameter: Self = Symbol.__xnew__(cls, name, **assumptions)
        parameter.unit, parameter.meaning, parameter.half_turns = unit, meaning, half_turns
        parameter.typical = typical if half_turns is None else half_turns * NEAR_PI
        return parameter

    @property
    def exact(self) -> Expr | None:
        """The typical value as it was typed, a rational or a rational multiple of pi."""
        if self.half_turns is not None:
            return Rational(self.half_turns) * pi
        return None if self.typical is None else Rational(self.typical)

    def _hashable_content(self) -> tuple[Any, ...]:
        own = (self.unit, self.meaning, str(self.typical))
        return (*super()._hashable_content(), *own)

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        own = (self.name, self.unit, self.meaning, self.typical, self.half_turns)
        return own, self._assumptions_orig


def parameters(
    names: str,
    units: str = "",
    typical: str | Expr | float | Sequence[Any] = "",
    meanings: Sequence[str] = (),
    positive: bool = True,
) -> tuple[Parameter, ...]:
    """Declare parameters, names, units and typical values separated by blanks.

    Parameters
    ----------
    names : str
        ``"M m L"``.
    units : str
        One SI unit a name, ``"kg kg m"``; ``1`` for a pure number. Empty: not stated.
    typical : str, number, or sequence of these
        One decimal number, fraction or multiple of pi a name (``"0.1 1/3 pi/10"``), read exactly,
        or ``-`` for one that has none, which is an error only where a number is needed. Empty: none
        has one. Numbers may stand for their text: ``[0.1, Rational(1, 3), pi/10]``.
    meanings : sequence of str
        One phrase a name, for reports and C headers.
    positive : bool
        False for parameters that may be zero or negative. Proofs hold for the declared sign.

    Raises
    ------
    SceneError
        When the numbers of names, units, typical values or meanings differ, a unit is not known,
        or a value is no number.

    Examples
    --------
    >>> m, l = parameters("m l", "kg m", "2 1/3", ("mass of the rod", "its length"))
    >>> m.unit, l.typical
    ('kg', Fraction(1, 3))
    """
    split = names.split()
    if not split:
        raise SceneError("parameters: no name given: write the names separated by blanks")

    if isinstance(typical, Expr | int | float):
        typical = (typical,)
    values = typical.split() if isinstance(typical, str) else list(map(str, typical))

    def column(title: str, entries: Sequence[str]) -> Sequence[str]:
        if entries and len(entries) != len(split):
            raise SceneError(
                f"parameters {names!r}: {len(split)} names but {len(entries)} {title}:"
                " give one for each name or none"
            )
        return entries or [""] * len(split)

    rows = zip(
        split,
        column("units", units.split()),
        column("typical values", values),
        column("meanings", list(meanings)),
        strict=True,
    )
    sign: dict[str, Any] = {"positive": True} if positive else {"real": True}
    for name, unit in zip(split, units.split(), strict=False):
        dimension_of_unit(unit, f"parameter {name}")
    return tuple(
        Parameter(name, unit, meaning, *typical_value(name, value), **sign)
        for name, unit, value, meaning in rows
    )


def typical_value(name: str, text: str) -> tuple[Fraction | None, Fraction | None]:
    """A typical value, or in its place how many times pi it is."""
    if text in ("", "-"):
        return None, None
    try:
        value, half_turns = with_pi(text)
        return (None, value) if half_turns else (value, None)
    except (ValueError, RangeError, ZeroDivisionError):
        raise SceneError(
            f"parameter {name}: the typical value {text!r} is no number:"
            " write a decimal number, a fraction such as 1/3, a multiple of pi such as pi/10, or"
            " '-' for none"
        ) from None
