"""Reading a person's equations: LaTeX, text, SymPy's objects, code."""
