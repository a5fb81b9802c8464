"""The grammar of equations in SymPy's or MATLAB's notation: a whitelist, nothing is evaluated.

Eq((M + m)*x.diff(t, 2) + 2*k*x, 0)        (M+m)*xdd + 2*k*x == 0;        x'' = -k/m*x
"""

from lark import Lark

PARSER = Lark.open(
    "text.lark", rel_to=__file__, parser="lalr", propagate_positions=True, maybe_placeholders=False
)
"""Linear in the length of the text."""
