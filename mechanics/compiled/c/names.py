"""C identifiers from the names of a scene.

Names such as ``lambda``, ``N1``, ``I`` or ``y1`` are fine in physics. In C some of them are
keywords, macros or functions of the library, and one function must not use a name twice.
"""

import re
from collections.abc import Iterable

# Keywords of C and C++ (headers are read by both), macros, and one-letter or likely names of
# <math.h>, <complex.h>, <stdio.h> and compilers that a physicist might use.
_WORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline
    int long register restrict return short signed sizeof static struct switch typedef union
    unsigned void volatile while bool true false nullptr constexpr alignas alignof static_assert
    thread_local typeof asm and and_eq bitand bitor catch class compl concept const_cast
    delete dynamic_cast explicit export friend mutable namespace new noexcept not not_eq
    operator or or_eq private protected public reinterpret_cast requires static_cast template
    this throw try typeid typename using virtual wchar_t xor xor_eq main errno stdin stdout stderr
    I NAN INFINITY HUGE_VAL NULL EOF M_PI M_E linux unix i386
    acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp exp2 expm1 fabs
    fdim floor fma fmax fmin fmod frexp gamma hypot ilogb j0 j1 jn ldexp lgamma log log10 log1p log2
    logb modf nan nearbyint pow remainder rint round scalb scalbn signgam significand sin sincos
    sinh sqrt tan tanh tgamma trunc y0 y1 yn div abs labs rand index
"""
RESERVED = frozenset(_WORDS.split())

VALUE = re.compile(r"v\d+\Z")
"""Reserved for values without a name of their own."""


def identifier(name: str) -> str:
    """A valid C identifier that resembles the name."""
    text = re.sub(r"[\W_]+", "_", name, flags=re.ASCII).strip("_") or "value"
    if text[0].isdigit():
        text = f"n{text}"
    return f"{text}_" if text in RESERVED or VALUE.match(text) else text


class Namer:
    """Gives out identifiers that differ from each other, within one C function.

    Parameters
    ----------
    taken : names that stand already: the arguments
    """

    def __init__(self, taken: Iterable[str]) -> None:
        self._taken = set(taken)
        self._count = 0

    def local(self, name: str) -> str:
        """An identifier for a named quantity."""
        text = identifier(name)
        while text in self._taken:
            text += "_"
        self._taken.add(text)
        return text

    def value(self) -> str:
        """An identifier for an intermediate value."""
        self._count += 1
        return f"v{self._count}"
