"""What a reduced model is beside equations: programs in the place of what these would give."""

from collections.abc import Mapping
from dataclasses import dataclass

from mechanics.program import Program

FILE = "reduction.json"
"""Of a folder of C, beside it."""
DOMAIN = "domain"
"""The function that tells how far inside of its box a state is."""
PREFIX = "reduced "
"""What the names of outputs of reduced functions begin with, in the program of what was derived."""


@dataclass(frozen=True)
class Reduced:
    """Functions that are reduced.

    Attributes
    ----------
    functions : mapping of str to Program
        By name; matrices row by row.
    inputs : mapping of str to tuple of str
        Every function of the model, and its inputs beside the state.
    record : str
        How it was done and what is proved of it: text of a file in JSON.
    """

    functions: Mapping[str, Program]
    inputs: Mapping[str, tuple[str, ...]]
    record: str


def output_name(function: str, output: str) -> str:
    """Name of an output of a reduced function in the program of what was derived."""
    return f"{PREFIX}{function} {output}"
