"""Parameters: the constants of a scene, with unit, meaning and a typical value."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, Self

from sympy import Symbol

from mechanics.errors import RangeError, SceneError
from mechanics.program.constants import rational
from mechanics.scene.unit_names import dimension_of_unit


class Parameter(Symbol):
    """A SymPy symbol that knows its unit, its meaning and a typical value.

    Two parameters are equal when all that is equal. SymPy caches expressions by equality, so that
    with less the `l1` of one scene would come back in another that has an `l1` of its own.
    """

    __slots__ = ("meaning", "typical", "unit")

    unit: str
    meaning: str
    typical: Fraction | None

    def __new__(  # noqa: D102 (the class says it)
        cls,
        name: str,
        unit: str = "",
        meaning: str = "",
        typical: Fraction | None = None,
        **assumptions: Any,
    ) -> Self:
        # __xnew__ is SymPy's uncached constructor: a cached one would share the attributes.
        parameter: Self = Symbol.__xnew__(cls, name, **assumptions)
        parameter.unit, parameter.meaning, parameter.typical = unit, meaning, typical
        return parameter

    def _hashable_content(self) -> tuple[Any, ...]:
        own = (self.unit, self.meaning, str(self.typical))
        return (*super()._hashable_content(), *own)

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        own = (self.name, self.unit, self.meaning, self.typical)
        return own, self._assumptions_orig


def parameters(
    names: str,
    units: str = "",
    typical: str = "",
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
    typical : str
        One decimal number or fraction a name, read exactly, or ``-`` for one that has none, which
        is an error only where a number is needed. Empty: none has one.
    meanings : sequence of str
        One phrase a name, for reports and C headers.
    positive : bool
        False for parameters that may be zero or negative. Proofs hold for the declared sign.

    Raises
    ------
    SceneError
        When the numbers of names, units, typical values or meanings differ, a unit is not known,
        or a value is no number.
    """
    split = names.split()
    if not split:
        raise SceneError("parameters: no name given: write the names separated by blanks")

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
        column("typical values", typical.split()),
        column("meanings", list(meanings)),
        strict=True,
    )
    sign = {"positive": True} if positive else {"real": True}
    for name, unit in zip(split, units.split(), strict=False):
        dimension_of_unit(unit, f"parameter {name}")
    return tuple(
        Parameter(name, unit, meaning, _number(name, value), **sign)
        for name, unit, value, meaning in rows
    )


def _number(name: str, text: str) -> Fraction | None:
    if text in ("", "-"):
        return None
    try:
        return rational(text)
    except (ValueError, RangeError):
        raise SceneError(
            f"parameter {name}: the typical value {text!r} is no number:"
            " write a decimal number, a fraction such as 1/3, or '-' for none"
        ) from None
