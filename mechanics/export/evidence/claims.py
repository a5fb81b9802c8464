"""What manifest and evidence claim: printed again from what was found, and compared.

    JSON of a file  =  the same made again

entry by entry, and an entry that differs is refuted: an operation count, a unit, an order, a
verdict, a bound of error. One that is missing, or that nothing makes again, is named.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from mechanics.kernel import Finding, refuted, same, undecided

LONGEST = 60
"""Characters of a value that are repeated."""
ABSENT = object()
"""What stands where nothing does."""

Difference = tuple[str, Any, Any]


def prove_claims(
    file: str, stored: Mapping[str, Any], again: Mapping[str, Any], source: str
) -> Iterator[Finding]:
    """Decide about what a file of JSON claims.

    Parameters
    ----------
    stored, again : mapping
        What it says, and what it should say.
    source : str
        What that is made of, in words.
    """
    agree = True
    for path, left, wanted in _different("", stored, again):
        agree = False
        subject = f"{file}: {path}"
        if left is ABSENT or wanted is ABSENT:
            words = "it is missing" if left is ABSENT else f"{source} do not have it"
            yield undecided(subject, f"refused: {words}")
        else:
            words = f"{str(left)[:LONGEST]} stands there, {source} give {str(wanted)[:LONGEST]}"
            yield refuted(subject, words, repr(left), repr(wanted))
    if agree:
        yield same(file, stored, again, f"every entry is what {source} give")


def _different(path: str, left: Any, right: Any) -> Iterator[Difference]:
    """Paths at which two values differ, and the values."""
    if isinstance(left, dict) and isinstance(right, dict):
        for key in dict.fromkeys((*left, *right)):
            name = f"{path}.{key[:LONGEST]}" if path else key[:LONGEST]
            yield from _different(name, left.get(key, ABSENT), right.get(key, ABSENT))
        if list(left) != list(right) and left.keys() == right.keys():
            yield f"{path}: order".lstrip(": "), ", ".join(left), ", ".join(right)
    elif isinstance(left, list) and isinstance(right, list):
        for place in range(max(len(left), len(right))):
            ends = (each[place] if place < len(each) else ABSENT for each in (left, right))
            yield from _different(f"{path}[{place}]", *ends)
    elif left != right or type(left) is not type(right):
        yield path, left, right
