"""Instructions of code, which are taken apart once however often they are asked for."""

import types
from dis import Instruction, get_instructions
from functools import lru_cache

MOST = 1024
"""Code that is remembered: what stands for a library of MATLAB or C is the same for every file."""


@lru_cache(maxsize=MOST)
def instructions(code: types.CodeType) -> tuple[Instruction, ...]:
    """Instructions of code, without those of functions inside it."""
    return tuple(get_instructions(code))
