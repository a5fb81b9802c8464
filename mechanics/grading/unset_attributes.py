"""Attributes that a class uses and its excerpt does not set: a record of parameters, computed ones.

    class Swing:
        def prepare(self): self.J = self.params.m*self.params.l**2
        def rates(self, x): return -self.params.m*...*sin(x)/self.J

`params` becomes a record of numbers that nobody said, then what computes nothing else is run.
"""

from collections.abc import Callable, Iterator
from dis import get_instructions
from itertools import pairwise
from types import FunctionType
from typing import Any

Number = Callable[[str, int], float]


class Record:
    """What has a number for each name."""


def with_unset(made: Any, number: Number) -> None:
    """Give an object the attributes that its methods use and none of them sets.

    Parameters
    ----------
    made : object
        Changed.
    number : callable
        What stands for a parameter, by its name and a count.
    """
    methods = [m for m in vars(type(made)).values() if isinstance(m, FunctionType)]
    used = {name for m in methods for name in _of_self(m, "LOAD_ATTR")}
    stored = {m: {*_of_self(m, "STORE_ATTR")} for m in methods}
    every = set().union(*stored.values())
    missing = [name for name in used - every if not hasattr(made, name)]
    if len(missing) == 1:  # the same name in two records may be two parameters
        setattr(made, missing[0], _record(methods, number))
    for method, names in stored.items():
        if names & used and not any(hasattr(made, name) for name in names) and _only_sets(method):
            try:
                method(made)
            except (
                AttributeError,
                TypeError,
                ValueError,
                ArithmeticError,
            ):  # what it needs is not there: a formula that uses it says so
                return


def _record(methods: list[FunctionType], number: Number) -> Record:
    """A record with a number for each name that methods look up in anything."""
    pairs = [pair for m in methods for pair in pairwise(get_instructions(m))]
    held = {two.argval for one, two in pairs
            if two.opname == "LOAD_ATTR" and not one.opname.startswith("LOAD_GLOBAL")}  # fmt: skip
    names = sorted(held - {name for m in methods for name in _of_self(m, "LOAD_ATTR")})
    record = Record()
    vars(record).update({name: number(name, k) for k, name in enumerate(names)})
    return record


def _of_self(method: FunctionType, operation: str) -> Iterator[str]:
    """Attributes of the object itself that a method looks up or sets."""
    code = list(get_instructions(method))
    own = method.__code__.co_varnames[:1]
    for before, one in pairwise(code):
        if one.opname == operation and before.opname == "LOAD_FAST" and before.argval in own:
            yield one.argval


def _only_sets(method: FunctionType) -> bool:
    """Whether a method has no arguments, calls nothing, and has neither branches nor loops."""
    names = [one.opname for one in get_instructions(method)]
    return method.__code__.co_argcount == 1 and not any(
        name.startswith(("CALL", "PRECALL")) or "JUMP" in name or "IMPORT" in name for name in names
    )
