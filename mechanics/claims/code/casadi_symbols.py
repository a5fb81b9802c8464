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
from types import FunctionType
from typing import Any

import casadi

from mechanics.claims.code.python.objects import names_in
from mechanics.claims.code.unpacking import Apart
from mechanics.errors import InputError

KINDS = ("MX", "SX")
CASADI = (casadi, casadi.MX, casadi.SX)
TOGETHER = "state"
"""Names what is put together of several symbols."""
DRAWS, CLOSE = 4, 1e-9
"""States at which the function is called with numbers, and how near its formulas have to be."""


@dataclass(frozen=True)
class SymbolFunction:
    """The CasADi function that a Python function makes.

    Attributes
    ----------
    function : casadi.Function
    apart : dict of str to Apart
        Symbols that are returned put together: they tell the order of a state.
    """

    function: casadi.Function
    apart: dict[str, Apart]


def function_of(function: Callable[..., Any]) -> SymbolFunction | None:
    """The CasADi function that a Python function makes; None where it makes no symbols.

    Raises
    ------
    InputError
        Where its formulas hold symbols that it does not return, and where it makes other ones of
        numbers than of symbols.
    """
    if not isinstance(function, FunctionType):
        return None
    words = {*names_in(function.__code__)}
    kinds = [kind for kind in KINDS if kind in words]
    if len(kinds) != 1 or "sym" not in words or not _of_casadi(function):
        return None
    parameters = [*inspect.signature(function).parameters.values()]
    if any(p.kind is not p.POSITIONAL_OR_KEYWORD for p in parameters):
        return None
    kind, title = getattr(casadi, kinds[0]), function.__name__
    symbols = {p.name: kind.sym(p.name) for p in parameters}
    symbolic = _of_call(function, title, symbols, [*symbols.values()], [*symbols])
    if symbolic is None:
        return None
    random = Random(1)
    for _ in range(DRAWS):
        numbers = {name: random.uniform(0.5, 2) for name in symbols}
        plain = _of_call(function, title, numbers, [], [])
        values = [*numbers.values()]
        if plain is None or not _same(symbolic.function, plain.function, values, random):
            raise InputError(f"{title} makes another formula of numbers than of CasADi's symbols")
    return symbolic


def _of_casadi(function: FunctionType) -> bool:
    """Whether a name of it, or an import inside, is CasADi or its symbols."""
    words = {*names_in(function.__code__)}
    values = [function.__globals__.get(name) for name in words]
    return "casadi" in words or any(v is kind for v in values for kind in CASADI)


def _of_call(
    function: FunctionType, title: str, arguments: dict[str, Any], more: list[Any], names: list[str]
) -> SymbolFunction | None:
    """The function of what a call returns, of symbols that it returns and these."""
    try:
        result = [*_parts(function(**arguments))]
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
        takes = [*(symbol for _, symbol in symbols), *more]
        outputs = [f"output_{k}" for k in range(len(formulas))]
        made = casadi.Function(title, takes, formulas, [*own, *names], outputs)
        return SymbolFunction(made, apart)
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
    symbolic: casadi.Function, plain: casadi.Function, numbers: list[float], random: Random
) -> bool:
    """Whether two functions return the same, the first with these numbers besides."""
    if plain.n_in() + len(numbers) != symbolic.n_in() or plain.n_out() != symbolic.n_out():
        return False
    state = [
        casadi.DM([random.uniform(-2, 2) for _ in range(plain.numel_in(k))]).reshape(
            plain.size_in(k)
        )
        for k in range(plain.n_in())
    ]
    some, others = symbolic.call([*state, *numbers]), plain.call(state)
    return all(
        one.shape == other.shape and float(casadi.norm_inf(casadi.vec(one - other))) <= CLOSE
        for one, other in zip(some, others, strict=True)
    )
