"""One precision of the functions in a folder.

    double    NAME.h, NAME.c, ...                NAME_forward_dynamics(const double q[2], ...)
    single    NAME_single.h, NAME_single.c, ...  NAME_single_forward_dynamics(const float q[2], ...)

The two know nothing of each other: a program takes the one that it needs, or both.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.compiled.c.status import Codes
from mechanics.errors import InputError

PRECISIONS = {"double": ("double",), "single": ("single",), "both": ("double", "single")}
"""What may be asked for, and what is then written."""

CAREFUL = """\
#if !defined({macro}_ALLOW_FAST_MATH) && (defined(__FAST_MATH__) || defined(_M_FP_FAST) || \\
    defined(__ASSOCIATIVE_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__))
#error "fast-math takes the statuses and the inline sine away: {macro}_ALLOW_FAST_MATH allows it"
#endif
"""
"""With -ffinite-math-only, isfinite(x) is 1; associative sums round no angle to its quadrant."""


@dataclass(frozen=True)
class Part:
    """What is written in one precision.

    Attributes
    ----------
    precision : str
        ``"double"`` or ``"single"``.
    prefix : str
        Of files, functions and (upper case) macros.
    kind : str
        The type of a number in C.
    digits : int
        Binary digits of a number.
    printed : str
        Conversion that prints every digit of it.
    """

    precision: str
    prefix: str
    kind: str
    digits: int
    printed: str

    @property
    def suffix(self) -> str:
        """End of the names of the C library's functions."""
        return "f" if self.kind == "float" else ""

    @property
    def macro(self) -> str:
        """Prefix of macros."""
        return self.prefix.upper()

    @property
    def guard(self) -> str:
        """Macro that a header defines when it is read; names that differ by case differ here."""
        return f"MECHANICS_{self.prefix}_H"

    @property
    def codes(self) -> Codes:
        """Names of the statuses."""
        names = ("OK", "SINGULAR", "OVERFLOW", "BAD_INPUT")
        return Codes(*(f"{self.macro}_{name}" for name in names))


def careful(macro: str) -> str:
    """Lines of a C file that refuse compilers which take infinities for impossible.

    Parameters
    ----------
    macro : str
        What the name of the macro that allows them begins with.
    """
    return CAREFUL.format(macro=macro)


def named_parts(name: str, precision: str) -> tuple[Part, ...]:
    """The parts of a folder.

    Parameters
    ----------
    name : str
        Of the folder's library.
    precision : str
        ``"double"``, ``"single"`` or ``"both"``.

    Raises
    ------
    InputError
        If there is no such precision.
    """
    if precision not in PRECISIONS:
        raise InputError(f"precision {precision!r}: there are {', '.join(PRECISIONS)}")
    made = {
        "double": Part("double", name, "double", 53, "%.17g"),
        "single": Part("single", f"{name}_single", "float", 24, "%.9g"),
    }
    return tuple(made[one] for one in PRECISIONS[precision])


def choices(parts: Sequence[Part]) -> tuple[str, ...]:
    """What a user of the folder may ask for: all of it comes last."""
    written = {part.precision for part in parts}
    return tuple(word for word, needed in PRECISIONS.items() if written.issuperset(needed))
