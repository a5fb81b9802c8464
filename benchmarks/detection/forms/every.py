"""The forms, and which of them a statement can be written in."""

from collections.abc import Callable
from random import Random

import sympy
from sympy.physics.vector import dynamicsymbols

from benchmarks.detection.forms import latex, plain
from benchmarks.detection.forms.code import c_source, casadi_function, python
from benchmarks.detection.forms.spelling import Written, orders
from benchmarks.detection.rows import Row, Subject
from benchmarks.detection.tree import Tree, written
from mechanics.reading.names import Vocabulary

HEADS = {
    "kinetic energy": ("T", "E_k", "E_kin"),
    "potential energy": ("V", "U", "E_p", "E_pot"),
    "energy": ("E", "E_tot"),
    "Lagrangian": ("L", "Lag"),
}

Form = Callable[[Subject, Row, tuple[Tree, ...], Random], Written | None]


def _head(about: Subject, row: Row, source: Random) -> str:
    """A name for an energy that the scene does not use."""
    known = Vocabulary(about.scene)
    free = [name for name in HEADS.get(row.about, ("",)) if known.lookup(name) is None]
    return source.choice(free)


def latex_form(about: Subject, row: Row, trees: tuple[Tree, ...], source: Random) -> Written:
    """LaTeX."""
    head = _head(about, row, source)
    letter, _, below = head.partition("_")
    if below:
        head = rf"{letter}_{{\mathrm{{{below}}}}}"
    elif len(head) > 1:
        head = rf"\mathrm{{{head}}}"
    text = latex.statement(about.scene, row, trees, source, head)
    return Written(text, {"notation": "latex"}, text)


def sympy_form(about: Subject, row: Row, trees: tuple[Tree, ...], source: Random) -> Written:
    """Text in SymPy's notation."""
    text = plain.sympy_text(about.scene, row, trees, source, _head(about, row, source))
    return Written(text, {"notation": "text"}, text)


def matlab_form(about: Subject, row: Row, trees: tuple[Tree, ...], source: Random) -> Written:
    """Text in MATLAB's notation."""
    text = plain.matlab_text(about.scene, row, trees, source, _head(about, row, source))
    return Written(text, {"notation": "text"}, text)


def object_form(about: Subject, row: Row, trees: tuple[Tree, ...], source: Random) -> Written:
    """SymPy's own objects, in functions of time or plain symbols."""
    table: dict = {}
    if source.random() < 0.6:
        t = dynamicsymbols._t
        for symbol, (base, order) in orders(about.scene).items():
            function = dynamicsymbols(base)
            table[symbol] = function.diff(t, order) if order else function
    sides = [written(tree).xreplace(table) for tree in trees]
    if row.about == "mass matrix":
        size = len(about.scene.u)
        matrix = sympy.Matrix(size, size, sides)
        return Written(matrix, {}, str(matrix))
    if not row.equation:
        return Written(sides[0], {"about": row.about}, str(sides[0]))
    equation = sympy.Eq(*sides, evaluate=False)
    return Written(equation, {}, str(equation))


FORMS: tuple[tuple[str, Form], ...] = (
    ("LaTeX", latex_form),
    ("SymPy text", sympy_form),
    ("MATLAB text", matlab_form),
    ("SymPy object", object_form),
    ("Python function", python),
    ("CasADi function", casadi_function),
    ("C source", c_source),
)
