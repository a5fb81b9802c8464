"""Symbols and values of a file: what is known of a name, and numbers such as sqrt(3) as a program.

[["L", "positive"], ...]     {"format": "straight-line program 1", "outputs": {"values": [2]}, ...}
"""

import json
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from sympy import Expr, Symbol

from mechanics.errors import ExpressionError, InputError
from mechanics.program import Builder, Program, json_format, sympy_printer, sympy_reader
from mechanics.program.operations import CONSTANT, POWER

NUMBER = re.compile(r"-?\d{1,4000}(/[1-9]\d{0,3999})?\Z")
SIGNS = ("positive", "negative", "nonnegative", "nonpositive", "real")
"""What is known about a symbol; the first that holds."""
VALUES = "values"
LARGEST_EXPONENT = 64
"""Another power of a number may fill the memory."""


@contextmanager
def reading(failure: str) -> Iterator[None]:
    """Whatever a file holds that it should not is an `ExpressionError`."""
    try:
        yield
    except ExpressionError:
        raise
    except InputError as error:
        raise ExpressionError(str(error)) from None
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        raise ExpressionError(f"{failure}: {type(error).__name__} {error}") from None


def symbol_record(symbol: Symbol) -> list[str]:
    """Name and sign of a symbol."""
    return [symbol.name, next((s for s in SIGNS if getattr(symbol, f"is_{s}")), "complex")]


def values_record(values: Sequence[Expr]) -> Any:
    """Numbers as a program, in the format of `mechanics.program.json_format`.

    Raises
    ------
    ExpressionError
        If one holds something that has no place in a program; it is named.
    """
    # As it comes back: the golden ratio is a sum then.
    again = sympy_printer.expressions(_program(values))[VALUES]
    return json.loads(json_format.write(_program(again)))


def _program(values: Sequence[Expr]) -> Program:
    builder = Builder()
    return builder.program({VALUES: sympy_reader.read(builder, values)})


def read_values(record: Any) -> tuple[Expr, ...]:
    """The numbers of a file.

    Raises
    ------
    InputError
        If they are no program.
    ExpressionError
        If it is no program of numbers.
    """
    program = json_format.read(json.dumps(record))
    if program.inputs or set(program.outputs) != {VALUES}:
        raise ExpressionError("a program of numbers is expected")
    if not all(_is_small(program, number) for number in range(len(program))):
        raise ExpressionError(f"values: an exponent is no number below {LARGEST_EXPONENT}")
    return sympy_printer.expressions(program)[VALUES]


def _is_small(program: Program, number: int) -> bool:
    if program.operations[number] != POWER:
        return True
    _, exponent = program.operands_of(number)
    return (
        program.operations[exponent] == CONSTANT
        and abs(program.constants[program.operands[0][exponent]]) <= LARGEST_EXPONENT
    )


def read_symbols(records: Any) -> list[Symbol]:
    """Symbols of a file.

    Raises
    ------
    ExpressionError
        If they are not names and signs.
    """
    found = []
    for record in _list(records, "symbols"):
        if (
            not isinstance(record, list)
            or len(record) != 2
            or not all(isinstance(part, str) for part in record)
            or record[1] not in (*SIGNS, "complex")
        ):
            raise ExpressionError(f"symbol {str(record)[:60]}: a name and a sign are expected")
        name, sign = record
        found.append(Symbol(name) if sign == "complex" else Symbol(name, **{sign: True}))
    return found


def index(value: Any, size: int) -> int:
    """A place in a list.

    Raises
    ------
    ExpressionError
        If it is none.
    """
    if type(value) is not int or not 0 <= value < size:
        raise ExpressionError(f"{str(value)[:40]} is no place among {size}")
    return value


def _list(value: Any, name: str) -> list[Any]:
    if not isinstance(value, list):
        raise ExpressionError(f"{name}: a list is expected")
    return value
