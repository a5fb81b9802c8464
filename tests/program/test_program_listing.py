"""A program line by line: names for what is used again or grows long, and the same values."""

import pytest
import sympy

from mechanics.program import Builder
from mechanics.program.listing import LONGEST, Listing, listing

q, a = sympy.symbols("q a")


def written_out(found: Listing, name: str) -> tuple[sympy.Expr, ...]:
    values = dict[sympy.Symbol, sympy.Expr]()
    for symbol, line in found.lines:
        values[symbol] = line.subs(values)
    return tuple(entry.subs(values) for entry in found.outputs[name])


def test_what_is_used_twice_has_a_line() -> None:
    b = Builder()
    s = b.input("q").sin() + b.input("a")
    found = listing(b.program({"f": [s * s / 3, s.cos()]}))
    ((name, line),) = found.lines
    assert line == a + sympy.sin(q)
    assert found.outputs["f"] == (name**2 / 3, sympy.cos(name))


@pytest.mark.parametrize(("count", "lines"), [(LONGEST, 0), (LONGEST + 1, 1), (3 * LONGEST, 2)])
def test_a_line_has_so_many_operations_at_most(count: int, lines: int) -> None:
    b = Builder()
    node, wanted = b.input("q"), q
    for _ in range(count):
        node, wanted = node.sin(), sympy.sin(wanted)
    found = listing(b.program({"f": [node]}))
    assert len(found.lines) == lines
    assert all(line.count_ops() <= LONGEST + 1 for _, line in found.lines)
    assert written_out(found, "f") == (wanted,)


def test_a_name_is_no_input() -> None:
    b = Builder()
    s = (b.input("x1") + 1).sin()
    ((name, _),) = listing(b.program({"f": [s * s]})).lines
    assert str(name) == "z1"
