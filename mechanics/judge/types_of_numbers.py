"""Types of numbers that are called by a unit which no scene has.

using Millimetre = double;            def f(x: "mm")            RPM = Annotated[float, "1/min"]
"""

import re
from collections.abc import Collection, Iterator

from mechanics.claims.scaled_names import unit_in

NUMBERS = r"(?:double|float|Float64)\b(?!\s*\()"
OWN_TYPE = re.compile(
    rf"\btypedef\s+{NUMBERS}\s+(?P<typedef>\w+)|\b(?P<set>[A-Za-z_]\w*)\s*=\s*"
    rf"(?:{NUMBERS}|(?:\w+\.)?(?:NewType\s*\(|Annotated\s*\[)[^\n]*)"
)
"""A name of the file for numbers: using Length = double, RPM = Annotated[float, "1/min"]."""
TYPED = re.compile(
    r"\b(?P<name>[A-Za-z_]\w*)\s*::?\s*(?P<type>[\"']?[A-Za-z][\w./^]*[\"']?(?:\[[^\]\n]*\])?)"
    r"(?=\s*[,)=\n])"
)
"""An argument and its type, in Python and Julia."""


def units_of_types(text: str, names: Collection[str] = ()) -> Iterator[tuple[str, str]]:
    """Names of types, and of what has one, each with the unit that is no coherent one of the SI.

    Parameters
    ----------
    text : str
        Code.
    names : collection of str
        What may have a type.
    """
    said = [(m["typedef"] or m["set"], m[0]) for m in OWN_TYPE.finditer(text)]
    said += [(m["name"], m["type"]) for m in TYPED.finditer(text) if m["name"] in names]
    yield from ((name, unit) for name, words in said if (unit := unit_in(words)))
