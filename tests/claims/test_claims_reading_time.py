"""Reading takes time in proportion to what is read: 4,096 bytes stay within the fuzzers' limit."""

import pytest

from benchmarks.fuzz import law
from mechanics.judge.check import derived
from systems import elastic_pendulum

TRUTH = derived(elastic_pendulum.scene())
ENTRIES = "&".join(f"x+{k}" for k in range(8))
MATRIX = r"\begin{matrix}" + r"\\".join([ENTRIES] * 8) + r"\end{matrix}"
FRACTION = r"\frac{\frac{L}{2}\cos\theta + 3}"
LONG = {
    "products of matrices": ("latex", rf"\ddot x = {' '.join([MATRIX] * 9)}"),
    "definitions of products": ("latex", "\n\n".join(f"{n} = {MATRIX * 3}" for n in "ABC")),
    "fractions of fractions": ("latex", f"V = {FRACTION * 60}{{2}}"),
    "factors above an equals sign": ("text", f"{'x*' * 1000}\n{'x*' * 1000}= 1"),
    "values that are set anew": ("text", "x=1;" * 1000),
    "values between commas": ("text", "x," * 2000),
    "a product without end": ("text", f"(M + m)*x'' + Rational(1, 2)*{'M*' * 2000}M"),
    "a chain of equalities": ("latex", "x=" * 2000),
    "letters that are given nothing": ("text", f"x'' = 1/ {'a' * 4000}"),
}


@pytest.mark.sample(3)
@pytest.mark.parametrize(("notation", "text"), LONG.values(), ids=LONG)
def test_the_time_of_reading_is_limited(notation: str, text: str) -> None:
    found = law.outcome(TRUTH, notation, text.encode()[:4096], blame=False)
    assert found.reading < law.LONGEST_READING
