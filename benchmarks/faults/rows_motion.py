"""Faults in the constraints and in SymPy's derivatives."""

from benchmarks.faults.fault import faults_in

CONSTRAINTS = (
    *faults_in(
        "mechanics.routes.rows",
        (
            "(expression,) = tangent([expression], rates)",
            "(expression,) = tangent([expression * mechanism.q[0]], rates)",
            "closures are multiplied by the first coordinate",
        ),
        (
            "return tangent(forms, mechanism.rates) if forms else []",
            "return tangent(forms, mechanism.coordinate_rates) if forms else []",
            "accelerations on constraints lose what the speeds change by",
        ),
    ),
)

SYMPY = (
    *faults_in(
        "sympy.functions.elementary.trigonometric",
        (
            "        if argindex == 1:\n            return -sin(self.args[0])",
            "        if argindex == 1:\n            return sin(self.args[0])",
            "SymPy: d cos x / dx = sin x",
        ),
        (
            "        if argindex == 1:\n            return cos(self.args[0])",
            "        if argindex == 1:\n            return -cos(self.args[0])",
            "SymPy: d sin x / dx = -cos x",
        ),
    ),
    *faults_in(
        "sympy.core.power",
        (
            "dbase = self.base.diff(s)",
            "dbase = 2*self.base.diff(s)",
            "SymPy: d x^n / dx = 2 n x^(n-1)",
        ),
    ),
    *faults_in(
        "sympy.core.add",
        (
            "return self.func(*[a.diff(s) for a in self.args])",
            "return self.func(*[a.diff(s) for a in self.args[1:]])",
            "SymPy: the first term of a sum is constant",
        ),
    ),
)

ROWS = (*CONSTRAINTS, *SYMPY)
