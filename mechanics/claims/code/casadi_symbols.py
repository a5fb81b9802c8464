"""Functions that make CasADi's symbols themselves, and return formulas in these.

    def model(m=1.0, l=2.0):                          Function model(x, u, m, l) of the rates
        x, u = ca.MX.sym("x", 2), ca.MX.sym("u")
        return x, u, ca.vertcat(x[1], ...)

Arguments become symbols, too: a number that one has by default is no more than that.
"""

import inspect
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from random import Random
from types import CodeType, FunctionType
from typing import Any

import casadi

from mechanics.claims.code.unpacking import Apart
from mechanics.errors import InputError

KINDS = ("MX", "SX")
TOGETHER = "state"
"""Names what is put together of several symbols."""
DRAWS, CLOSE = 4, 1e-9
"""States at which the function is called with numbers, and how near its formulas have to be."""


@dataclass(frozen=True)
class Made:
    """The CasADi function that a Python function makes.

    Attributes
    ----------
    function : casadi.Function
    apart : dict of str to Apart
        Symbols that are returned put together: they tell the order of a state.
    """

    function: casadi.Function
    apart: dict[str, Apart]


def function_of(function: Callable[..., Any]) -> Made | None:
    """The CasADi function that a Python function makes; None where it makes no symbols.

    Raises
    ------
    InputError
        For what is made of other symbols than it returns, and what it makes otherwise of numbers.
    """
    if not isinstance(function, FunctionType):
        return None
    words = _names(function.__code__)
    kinds = [kind for kind in KINDS if kind in words]
    if len(kinds) != 1 or "sym" not in words or not _of_casadi(function):
        return None
    parameters = [*inspect.signature(function).parameters.values()]
    if any(p.kind is not p.POSITIONAL_OR_KEYWORD for p in parameters):
        return None
    kind, title = getattr(casadi, kinds[0]), function.__name__
    given = {p.name: kind.sym(p.name) for p in parameters}
    made = _made(function, title, given, [*given.values()], [*given])
    if made is None:
        return None
    drawn = Random(1)
    for _ in range(DRAWS):
        numbers = {name: drawn.uniform(0.5, 2) for name in given}
        plain = _made(function, title, numbers, [], [])
        if plain is None or not _same(made.function, plain.function, [*numbers.values()], drawn):
            raise InputError(f"{title} makes another formula of numbers than of CasADi's symbols")
    return made


def _of_casadi(function: FunctionType) -> bool:
    """Whether a name of it, or an import inside, is CasADi or its symbols."""
    words = _names(function.__code__)
    own = [function.__globals__.get(name) for name in words]
    return "casadi" in words or any(
        one is casadi or one is casadi.MX or one is casadi.SX for one in own
    )


def _names(code: CodeType) -> set[str]:
    """Names in a function, and in those that are defined in it."""
    inner = [_names(part) for part in code.co_consts if isinstance(part, CodeType)]
    return {*code.co_names}.union(*inner)


def _made(
    function: FunctionType, title: str, given: dict[str, Any], more: list[Any], names: list[str]
) -> Made | None:
    """The function of what a call returns, of symbols that it returns and these."""
    try:
        result = [*_parts(function(**given))]
        every: list[Any] = [one for one in result if isinstance(one, casadi.MX | casadi.SX)]
        inputs = [one for one in every if one.is_valid_input()]
        parts = {TOGETHER + str(k or ""): _parts_of(one) for k, one in enumerate(inputs)}
        symbols = [
            (name if len(own) > 1 else own[0], one)
            for (name, own), one in zip(parts.items(), inputs, strict=True)
        ]
        apart = {
            name: Apart({k: {part} for k, part in enumerate(own)}, size=len(own), fields=True)
            for name, own in parts.items() if len(own) > 1
        }  # fmt: skip
        formulas = [one for one in every if not one.is_valid_input()]
        if len(every) < len(result) or not formulas or not symbols:
            return None
        own = [name for name, _ in symbols]
        inner = [name for one in parts.values() for name in one]
        if len({*inner, *names}) < len(inner) + len(names):
            raise InputError(f"{title}: two of its symbols have one name: rename one")
        held = [*(symbol for _, symbol in symbols), *more]
        told = [f"output_{k}" for k in range(len(formulas))]
        return Made(casadi.Function(title, held, formulas, [*own, *names], told), apart)
    except InputError:
        raise
    except Exception as error:
        words = " ".join(str(error).split())[:200]
        raise InputError(f"function {title} makes no CasADi function: {words}") from None


def _parts_of(one: Any) -> list[str]:
    """The name of a symbol; those of several that are put together, in their order."""
    parts = one.primitives() if isinstance(one, casadi.MX) else [*casadi.vertsplit(casadi.vec(one))]
    names = [part.name() for part in parts]
    head = names[0].removesuffix("_0")
    if len(names) > 1 and names == [f"{head}_{k}" for k in range(len(names))]:
        return [head]
    if len(names) > 1 and any(part.numel() > 1 for part in parts):
        raise InputError(f"{' '.join(names)}: arrays that are put together are not read")
    return names


def _parts(result: Any) -> Iterator[Any]:
    """What is returned, one by one."""
    if isinstance(result, tuple | list):
        for one in result:
            yield from _parts(one)
    elif isinstance(result, dict):
        yield from _parts([*result.values()])
    else:
        yield result


def _same(
    made: casadi.Function, plain: casadi.Function, numbers: list[float], drawn: Random
) -> bool:
    """Whether two functions return the same, the first with these numbers besides."""
    if plain.n_in() + len(numbers) != made.n_in() or plain.n_out() != made.n_out():
        return False
    state = [
        casadi.DM([drawn.uniform(-2, 2) for _ in range(plain.numel_in(k))]).reshape(
            plain.size_in(k)
        )
        for k in range(plain.n_in())
    ]
    some, others = made.call([*state, *numbers]), plain.call(state)
    return all(
        one.shape == other.shape and float(casadi.norm_inf(casadi.vec(one - other))) <= CLOSE
        for one, other in zip(some, others, strict=True)
    )
