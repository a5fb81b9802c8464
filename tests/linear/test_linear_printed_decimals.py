"""MATLAB's printed digits: proved by enclosures, refuted by one unit of the last digit."""

from dataclasses import replace
from functools import cache

import pytest
from sympy import Float, ImmutableMatrix

from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.kernel import Finding, Verdict
from mechanics.linear.ledger import check_linear_row
from mechanics.routes.derivation import by_route
from mechanics.scene.typed import rounded
from systems import two_mass_chain
from systems.two_mass_chain_ledger import PUBLISHED

ROWS = {row.tag: row for row in PUBLISHED}


@cache
def equations() -> Equations:
    return by_route("lagrange", two_mass_chain.scene())


def check(tag: str, *columns: tuple) -> Finding:
    row = replace(ROWS[tag], sides=(ImmutableMatrix(columns).T,))
    return check_linear_row(equations().scene, row, equations())


def decimals(*texts: str) -> tuple[Float, ...]:
    return tuple(rounded(text) for text in texts)


FIRST, SECOND = ("0.7071", "-0.7071"), ("0.5547", "0.8321")


def negative(texts: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(text[1:] if text.startswith("-") else f"-{text}" for text in texts)


@pytest.mark.parametrize("first", [FIRST, negative(FIRST)])
@pytest.mark.parametrize("second", [SECOND, negative(SECOND)])
def test_sign_of_a_column_is_free(first: tuple, second: tuple) -> None:
    finding = check("V", decimals(*first), decimals(*second))
    assert finding.verdict is Verdict.PROVED
    assert "sign" in finding.evidence


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (("0.7071", "0.7071"), SECOND),
        (("0.7072", "-0.7071"), SECOND),
        (FIRST, ("0.5547", "0.8320")),
        (SECOND, FIRST),
        (FIRST, ("0.6667", "1.0000")),
    ],
    ids=["sign", "last digit", "other last digit", "order", "scaling"],
)
def test_wrong_vectors_are_refuted(first: tuple, second: tuple) -> None:
    finding = check("V", decimals(*first), decimals(*second))
    assert finding.verdict is Verdict.REFUTED
    assert "does not round to" in finding.evidence
    assert finding.witness is not None


def test_more_digits_are_held_to_their_own_rounding() -> None:
    more = decimals("0.7071067812", "-0.7071067812"), decimals("0.5547001962", "0.8320502943")
    assert check("V", *more).verdict is Verdict.PROVED
    less = decimals("0.71", "-0.71"), decimals("0.55", "0.83")
    assert check("V", *less).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("columns", "verdict"),
    [
        (((rounded("1.0000"), 0), (0, rounded("0.1667"))), Verdict.PROVED),
        (((1, 0), (0, rounded("0.16666667"))), Verdict.PROVED),
        (((rounded("0.1667"), 0), (0, rounded("1.0000"))), Verdict.REFUTED),
        (((rounded("1.0000"), 0), (0, rounded("0.1666"))), Verdict.REFUTED),
        (((rounded("1.0000"), 1), (0, rounded("0.1667"))), Verdict.REFUTED),
        (((2, 0), (0, rounded("0.1667"))), Verdict.REFUTED),
    ],
)
def test_eigenvalues(columns: tuple, verdict: Verdict) -> None:
    assert check("D", *columns).verdict is verdict


def test_shape_and_kind_of_entries_are_checked() -> None:
    with pytest.raises(InputError, match="another shape"):
        check("V", decimals(*FIRST))
    with pytest.raises(InputError, match="neither a printed decimal nor a rational number"):
        check("D", (two_mass_chain.k, 0), (0, 1))
