"""Sentences and items of a list that give parameters values, with blanks for their words.

We simulate with l = 1 and g = 9.81.        - l = 1 m

Only numbers that the scene allows are values; g = -9.81 is left, and read as what it says.
"""

import re
from fractions import Fraction

from mechanics.claims.lines import is_constant
from mechanics.claims.names import Naming

UNIT = r"[ ](?!and\b)[A-Za-z]{1,3}(?:[/^*\d]\w*)*"
GIVEN = rf"[^\W\d]\w*[ ]*=[ ]*\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?:{UNIT})?"
LINE = re.compile(
    rf"^[ \t]*(?:[-*\u2022+][ \t]+|(?:[^\W\d_]+[ ,:]+){{2,12}})(?:{GIVEN})"
    rf"(?:(?:,[ ]?and|,|[ ]and)[ ]{GIVEN})*[ \t]*[.;,]?[ \t]*$",
    re.MULTILINE,
)
VALUE = re.compile(r"(?P<name>[^\W\d]\w*)[ ]*=[ ]*(?P<number>\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)")


def without_values_in_words(text: str, naming: Naming) -> str:
    """The text with blanks around values that parameters can have.

    Parameters
    ----------
    text : str
    naming : Naming
    """

    def bare(line: re.Match[str]) -> str:
        given = [*VALUE.finditer(line[0])]
        if not all(_is_possible(one["name"], one["number"], naming) for one in given):
            return line[0]
        left = [" "] * len(line[0])
        for one in given:
            left[one.start() : one.end()] = one[0]
            if one is not given[-1]:
                left[one.end()] = ";"
        return "".join(left)

    return LINE.sub(bare, text)


def _is_possible(name: str, number: str, naming: Naming) -> bool:
    """Whether a name is a parameter that can have a value, which is not below zero."""
    found = naming.lookup(name)
    if found is None or not is_constant(name, naming):
        return False
    return Fraction(number) > 0 or not naming.vocabulary.constants[found[0]].is_positive
