"""Whether a second call of a function with the same arguments gives the same result.

    call 1:  self.n = 0 -> 1        call 2 begins where self.n is anything: a symbol of its own

Where formulas hold that symbol, or a decision does, they depend on earlier calls.
"""

from collections.abc import Callable, Mapping
from typing import Any

from sympy import Dummy, Expr

from mechanics.claims.code.python.closure_numbers import held
from mechanics.claims.code.trace.tracing import Given, Outputs, trace
from mechanics.errors import InputError


def doubt_when_repeated(
    function: Callable[..., Any], given: Given, outputs: Outputs, standing: Mapping[str, Expr]
) -> str:
    """Why what a function returns depends on more than its arguments; empty where it does not.

    Parameters
    ----------
    function : callable
    given : mapping of str to Expr or sequence of Expr
    outputs : Outputs
        As it was traced.
    standing : mapping of str to Expr
        What numbers that it holds stand for.
    """
    own = {name: name.removeprefix("self.") for name in outputs.changed}
    numbers = held(function, own.values()).numbers
    for name, short in own.items():
        if short not in numbers:
            return _words(name)
    if not own:
        return ""
    anything: dict[str, Expr] = {short: Dummy(short, real=True) for short in own.values()}
    try:
        again = trace(function, given, {**standing, **anything})
    except InputError:
        return _words(next(iter(own)))
    parts = [*again.conditions, *again.values]
    for name, short in own.items():
        if any(anything[short] in part.free_symbols for part in parts):
            return _words(name)
    return "" if again.values == outputs.values else _words(next(iter(own)))


def _words(name: str) -> str:
    if name.startswith("its argument"):
        return f"a call changes {name}, which the caller keeps: change a copy of it"
    return (
        f"a call changes {name}, which later calls read, so a result may depend on more than its"
        " arguments: leave that out, or use a local name"
    )
