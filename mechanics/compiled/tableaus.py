"""Explicit Runge-Kutta formulas of fixed step, from the shortest to the most accurate.

Those of orders 5 and 8 are SciPy's, which takes longer to import than all that is compiled: who
needs that of order 4 alone takes it from `mechanics.compiled.step`.
"""

from scipy.integrate import DOP853, RK45

from mechanics.compiled.step import RK4, Tableau


def _embedded(name: str, order: int, pair: type[RK45] | type[DOP853]) -> Tableau:
    """The higher-order formula of a pair of SciPy, without its error estimate."""
    rows = tuple(tuple(row[:i]) for i, row in enumerate(pair.A.tolist()))
    return Tableau(name, order, rows, tuple(pair.B.tolist()))


TABLEAUX = (RK4, _embedded("RK5", 5, RK45), _embedded("RK8", 8, DOP853))
