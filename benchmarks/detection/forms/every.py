"""The forms, and which of them a statement can be written in."""

from collections.abc import Callable, Mapping
from random import Random

import sympy
from sympy.physics.vector import dynamicsymbols

from benchmarks.detection.forms import latex, plain
from benchmarks.detection.forms.code import c_source, casadi_function, python
from benchmarks.detection.forms.spelling import Written, labels, plain_name
from benchmarks.detection.rows import Row, Subject
from benchmarks.detection.tree import Tree, written
from mechanics.claims.names import Vocabulary
from mechanics.scene.symbols import DOTS

HEADS = {
    "kinetic energy": ("T", "E_k", "E_kin"),
    "potential energy": ("V", "U", "E_p", "E_pot"),
    "energy": ("E", "E_tot"),
    "Lagrangian": ("L", "Lag"),
}

Form = Callable[[Subject, Row, tuple[Tree, ...], Mapping[str, str], Random], Written | None]


def _head(about: Subject, row: Row, source: Random) -> str:
    """A name for an energy that the scene does not use."""
    known = Vocabulary(about.scene)
    free = [name for name in HEADS.get(row.about, ("",)) if known.lookup(name) is None]
    return source.choice(free)


def _told(names: Mapping[str, str]) -> dict[str, object]:
    """The option that says what the person's names mean."""
    return {"names": {own: name for name, own in names.items()}} if names else {}


def latex_form(
    about: Subject, row: Row, trees: tuple[Tree, ...], names: Mapping[str, str], source: Random
) -> Written:
    """LaTeX."""
    head = _head(about, row, source)
    letter, _, below = head.partition("_")
    if below:
        head = rf"{letter}_{{\mathrm{{{below}}}}}"
    elif len(head) > 1:
        head = rf"\mathrm{{{head}}}"
    called = labels(about.scene, names)
    text = latex.statement(about.scene, row, trees, called, source, head)
    return Written(text, {"notation": "latex"} | _told(names), text)


def sympy_form(
    about: Subject, row: Row, trees: tuple[Tree, ...], names: Mapping[str, str], source: Random
) -> Written:
    """Text in SymPy's notation."""
    called = labels(about.scene, names)
    head = _head(about, row, source)
    text = plain.sympy_text(about.scene, row, trees, called, source, head)
    return Written(text, {"notation": "text"} | _told(names), text)


def matlab_form(
    about: Subject, row: Row, trees: tuple[Tree, ...], names: Mapping[str, str], source: Random
) -> Written:
    """Text in MATLAB's notation."""
    called = labels(about.scene, names)
    head = _head(about, row, source)
    text = plain.matlab_text(about.scene, row, trees, called, source, head)
    return Written(text, {"notation": "text"} | _told(names), text)


def object_form(
    about: Subject, row: Row, trees: tuple[Tree, ...], names: Mapping[str, str], source: Random
) -> Written:
    """SymPy's own objects, in functions of time or plain symbols."""
    table: dict = {}
    functions = source.random() < 0.6
    for symbol, (base, order) in labels(about.scene, names).items():
        if functions and symbol not in about.scene.parameters:
            function = dynamicsymbols(base)
            table[symbol] = function.diff(dynamicsymbols._t, order) if order else function
        elif base not in (symbol.name, symbol.name.removesuffix(DOTS[order])):
            table[symbol] = sympy.Symbol(plain_name((base, order)))
    sides = [written(tree).xreplace(table) for tree in trees]
    if row.about == "mass matrix":
        size = len(about.scene.u)
        matrix = sympy.Matrix(size, size, sides)
        return Written(matrix, _told(names), str(matrix))
    if not row.equation:
        return Written(sides[0], {"about": row.about} | _told(names), str(sides[0]))
    equation = sympy.Eq(*sides, evaluate=False)
    return Written(equation, _told(names), str(equation))


FORMS: tuple[tuple[str, Form], ...] = (
    ("LaTeX", latex_form),
    ("SymPy text", sympy_form),
    ("MATLAB text", matlab_form),
    ("SymPy object", object_form),
    ("Python function", python),
    ("CasADi function", casadi_function),
    ("C source", c_source),
)
