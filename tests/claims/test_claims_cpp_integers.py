"""Integers of C++ keep their kind: what one does not hold is not read as another number."""

import pytest

from mechanics.claims.code.translation.cpp_functions import in_python
from mechanics.claims.code.translation.python_page import Unread


def value(before: str, inside: str, formula: str, origin: str = "page.cpp") -> float:
    """What a function returns for x = 1."""
    text = f"{before}\ndouble f(double x) {{ {inside} return x*({formula}); }}"
    (one,) = in_python(text, origin, "f").functions
    return float(one(x=1.0))


@pytest.mark.parametrize(
    ("before", "inside", "formula", "words"),
    [
        ("const uint8_t n = 259;", "", "n - 256", "n is uint8_t: 259 does not fit"),
        ("const bool n = 3;", "", "n", "n is bool: 3"),
        ("const uint8_t n = 256 + 2;", "", "n", "n is uint8_t: 258"),
        ("const unsigned n = 3;", "", "n - 6 < 0 ? 3 : 1", "unsigned"),
        ("", "const int8_t n = 200;", "n/200.0", "n is int8_t: 200"),
        ("", "char n = 200;", "n/200.0", "n is char: 200"),
        ("", "short n = 32767; n += 1;", "n", "n is short: 32768"),
        ("", "unsigned char n = 255; ++n;", "n", "n is unsigned char: 256"),
        ("", "std::array<uint8_t, 2> w{}; w[0] = 259;", "w[0]", r"w\[0\] is uint8_t: 259"),
        ("", "std::array<int8_t, 2> w = {131, 2};", "w[0]", "w is int8_t: 131"),
        ("", "std::array<double, 2> w = {1.0, 2.0};", "w[2]", "entry 3 of an array of 2"),
        ("double k(uint8_t n) { return n; }", "", "k(259)", "n is uint8_t: 259"),
        ("uint8_t k() { return 259; }", "", "k()", "what is returned is uint8_t: 259"),
        ("", "int n = 2000000000;", "n*2", "32 bits: 4000000000"),
        ("", "const auto n = uint8_t{259};", "n", "made an integer"),
        ("", "double n = 9007199254740993;", "n", "more than a double holds"),
    ],
)
def test_what_an_integer_does_not_hold_is_refused(
    before: str, inside: str, formula: str, words: str
) -> None:
    with pytest.raises((ValueError, Unread), match=words):
        value(before, inside, formula)


@pytest.mark.parametrize(
    ("before", "inside"),
    [("const int n = 40000;", ""), ("#define N 40000", "int n = N;")],
)
def test_an_int_of_a_small_processor_has_16_bits(before: str, inside: str) -> None:
    assert value(before, inside, "n/20000.0") == 2.0
    with pytest.raises((ValueError, Unread), match="n is int: 40000"):
        value(before, inside, "n/20000.0", "sketch.ino")


@pytest.mark.parametrize(
    ("before", "inside", "formula", "found"),
    [
        ("const byte DT = 50;", "", "DT/1000.0", 0.05),
        ("const uint8_t n = 3;", "", "n - 6", -3.0),  # a byte is an int in arithmetic
        ("const int N = 2*3;", "", "N/4", 1.0),
        ("", "int n = 3; n *= 2; n--;", "n", 5.0),
        ("", "std::array<double, 2> w{{1.0, 3.0}};", "w[1]", 3.0),
        ("", "int8_t n = -128;", "n", -128.0),
    ],
)
def test_what_it_holds_is_read(before: str, inside: str, formula: str, found: float) -> None:
    assert value(before, inside, formula) == found
