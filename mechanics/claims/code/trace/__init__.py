"""Python functions as formulas: called with symbols, on every path."""
