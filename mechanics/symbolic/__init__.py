"""SymPy's expressions and the kernel: statements about them, and their normal forms for people."""

from mechanics.symbolic.arithmetic import Arithmetic, Number
from mechanics.symbolic.canonical import canonical, collect_linear, tidy
from mechanics.symbolic.decide import decide, is_zero, prove_equal, prove_zero
from mechanics.symbolic.decimals import decimal_matches, enclose, roundings
from mechanics.symbolic.independence import generic_rank, independent_rows
from mechanics.symbolic.size import operations
from mechanics.symbolic.slope import slope

__all__ = [
    "Arithmetic",
    "Number",
    "canonical",
    "collect_linear",
    "decide",
    "decimal_matches",
    "enclose",
    "generic_rank",
    "independent_rows",
    "is_zero",
    "operations",
    "prove_equal",
    "prove_zero",
    "roundings",
    "slope",
    "tidy",
]
