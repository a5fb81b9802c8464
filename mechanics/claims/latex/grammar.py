r"""The grammar of LaTeX as people write it: brackets, commands with arguments, scripts.

    M \frac{L}{2} \ddot{x} \cos \theta + ...  =  0

The grammar nests; what stands side by side (signs, implied products, functions and their arguments)
stays a flat list, which `latex_fold` puts together.
"""

from lark import Lark

PARSER = Lark.open(
    "latex.lark", rel_to=__file__, parser="lalr", propagate_positions=True, maybe_placeholders=False
)
"""Linear in the length of the text."""
