"""Exact arithmetic: statements are proved, certified, refuted or undecided, without tolerance."""

from mechanics.exact.arithmetic import Arithmetic, Number, as_fraction
from mechanics.exact.canonical import canonical, collect_linear, linear_equation, tidy
from mechanics.exact.decide import decide, is_zero, prove_equal, prove_zero
from mechanics.exact.decimals import decimal_matches, enclose, roundings
from mechanics.exact.finding import Finding, Verdict, Witness
from mechanics.exact.independence import generic_rank, independent_rows
from mechanics.exact.signals import Inadmissible, SingularHere, TooLarge
from mechanics.exact.slope import slope

__all__ = [
    "Arithmetic",
    "Finding",
    "Inadmissible",
    "Number",
    "SingularHere",
    "TooLarge",
    "Verdict",
    "Witness",
    "as_fraction",
    "canonical",
    "collect_linear",
    "decide",
    "decimal_matches",
    "enclose",
    "generic_rank",
    "independent_rows",
    "is_zero",
    "linear_equation",
    "prove_equal",
    "prove_zero",
    "roundings",
    "slope",
    "tidy",
]
