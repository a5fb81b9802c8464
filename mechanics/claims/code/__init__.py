"""Code and objects of other programs, as statements: Python, CasADi, C, SymPy."""
