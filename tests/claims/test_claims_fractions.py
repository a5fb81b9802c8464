"""Short fractions take one letter or digit each, as TeX prints them; a power may be defined."""

import pytest

from mechanics.errors import InputError
from tests.notation_scenes import judged, verdicts

ROOT = r"\ddot\theta + \omega_0^2\sin\theta = 0"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"\ddot\theta = -\frac gl\sin\theta", r"\ddot\theta = -\frac lg\sin\theta"),
        (r"\ddot\theta + \tfrac{g}l \sin\theta = 0", r"\ddot\theta + \tfrac{l}g \sin\theta = 0"),
        (r"\ddot\theta = -\frac g\ell\sin\theta", r"\ddot\theta = -\frac\ell g\sin\theta"),
        (r"\frac1g\ddot\theta + \frac 1l\sin\theta=0", r"\frac1l\ddot\theta+\frac 1g\sin\theta=0"),
        (r"\frac1gl\ddot\theta + \sin\theta = 0", r"\frac1lg\ddot\theta + \sin\theta = 0"),
        (r"\frac{1}gl\ddot\theta + \sin\theta = 0", r"\frac{1}lg\ddot\theta + \sin\theta = 0"),
        (r"T = \frac{1}2ml^2\dot\theta^2", r"T = \frac{1}2m^2l\dot\theta^2"),
        (r"T = \frac m2l^2\dot\theta^2", r"T = \frac m3l^2\dot\theta^2"),
        (r"T = \frac12mv^2, v^2 = l^2\dot\theta^2", r"T = \frac12mv^2, v^2 = l^2\dot\theta^3"),
        (rf"{ROOT},\quad \omega_0^2 = g/l", rf"{ROOT},\quad \omega_0^2 = l/g"),
        (rf"{ROOT},\quad \omega_0^2 \equiv \frac gl", rf"{ROOT},\quad \omega_0^2 \equiv 2\frac gl"),
        (rf"\[{ROOT}\] where $\omega_0^2 = g/l$.", rf"\[{ROOT}\] where $\omega_0^2 = 2g/l$."),
        ("theta'' + w0^2*sin(theta) = 0\nw0^2 = g/l", "theta'' + w0^2*sin(theta) = 0\nw0^2 = l/g"),
        ("w0^2 = g/l\ntheta'' = -w0^2*sin(theta)", "w0^2 = g/l\ntheta'' = -w0*sin(theta)"),
    ],
)  # fmt: skip
def test_fractions_and_powers(right: str, wrong: str) -> None:
    assert verdicts("pendulum", right) == ["PROVED"]
    assert verdicts("pendulum", wrong) == ["REFUTED"]


@pytest.mark.parametrize(
    "number",
    [r"1\tfrac12", r"1\frac{1}{2}", r"1\,\frac 12", r"1{\frac12}",
     r"1{1 \over 2}", r"1 \dfrac{1}2"],
)  # fmt: skip
def test_a_mixed_number_is_neither_a_sum_nor_a_product(number: str) -> None:
    for formula in (rf"T = {number}\,m l^2\dot\theta^2", rf"T = \frac{{{number} m l^2}}1"):
        with pytest.raises(InputError, match=r"may be a sum or a product: write \\frac\{3\}\{2\}"):
            judged("pendulum", formula)


@pytest.mark.parametrize(
    "number",
    [r"1\cdot\tfrac12", r"\frac12\frac22", r"(1)\tfrac12", r"\frac{1}{2}", "0.5", r"\frac24"],
)
def test_products_of_numbers_are_read(number: str) -> None:
    assert verdicts("pendulum", rf"T = {number} m l^2\dot\theta^2") == ["PROVED"]


@pytest.mark.parametrize("number", ["1 1/2", "1\u00bd", "1 \u00bd"])
def test_nor_is_one_in_text(number: str) -> None:
    with pytest.raises(InputError):
        judged("pendulum", f"T = {number}*m*l^2*theta_dot^2")


NORMAL = (
    r"With $\omega_n^2 = k/m$, $2\zeta\omega_n = c/m$ and $f_0 = F_0/m$,"
    r" \[ \ddot x + 2\zeta\omega_n\dot x + \omega_n^2 x = f_0\cos\omega t \]"
)


def test_a_product_defines_the_name_that_is_new() -> None:
    assert verdicts("oscillator", NORMAL) == ["PROVED"]
    assert verdicts("oscillator", NORMAL.replace("= c/m", "= 2c/m")) == ["REFUTED"]


def test_a_root_that_is_squared_again_asks_for_no_sign() -> None:
    both = r"\ddot\theta + w^2\theta\sin\theta/\theta = 0,\quad w^2 = g\theta/(l\theta)"
    (entry,) = judged("pendulum", both).judged
    assert all("1/2" not in str(demand) for demand in entry.statement.demands.of)
