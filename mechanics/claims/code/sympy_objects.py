"""SymPy's own objects: expressions, equations, matrices, KanesMethod, LagrangesMethod, System.

x(t), Derivative(x(t), t), x_dot        are matched by name with the scene's x, x_dot, x_dot
KanesMethod: M u' = f, with u solved for q'       LagrangesMethod: its equations, one a row
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Any

from sympy import (
    Basic,
    Derivative,
    Eq,
    Expr,
    Float,
    Function,
    Matrix,
    MatrixSymbol,
    S,
    Symbol,
    linsolve,
    sympify,
)
from sympy.core.function import AppliedUndef
from sympy.matrices import MatrixBase
from sympy.physics.mechanics import KanesMethod
from sympy.physics.vector import dynamicsymbols

from mechanics.claims.about import WORDS, as_asked, named_quantity
from mechanics.claims.code.constants import constant_of
from mechanics.claims.demands import Demand, Demands, within
from mechanics.claims.guess import guess
from mechanics.claims.kind import kind_of
from mechanics.claims.names import Naming, Vocabulary, unexplained
from mechanics.claims.statement import Reading, Statement
from mechanics.claims.tree import Name
from mechanics.errors import WrongKindError
from mechanics.importers.sympy_model import KINDS as MODELS
from mechanics.importers.sympy_model import form_equations, is_model, parts_replaced
from mechanics.scene import Scene
from mechanics.scene.declared import decimals
from mechanics.scene.published import published
from mechanics.scene.quantities import Identity, MassMatrix
from mechanics.scene.symbols import TIME, entries
from mechanics.symbolic import is_zero

Sides = tuple[Any, ...]
KINDS = (Expr, MatrixBase, Eq, *MODELS)
DOUBLE = 53
"""Binary digits of a double."""
FORMULA = re.compile(r"[-+*/^<>=&|]|\*\*|^\d|\d\s+[^\W\d]|[^\W\d]\s+[^\W\d]")
"""What no name holds."""


def read_sympy(
    scene: Scene, thing: Any, names: Mapping[str, str] | None = None, about: str | None = None
) -> Reading:
    """Statements of one of SymPy's objects.

    Parameters
    ----------
    scene : Scene
    thing : Expr, Eq, Matrix, KanesMethod, LagrangesMethod, System or a tuple of them
        An expression alone is taken to be zero where it holds an acceleration.
    names, about
        As for `read_source`.
    """
    things = thing if isinstance(thing, tuple) else (thing,)
    rows = [row for one in things for row in sides_of(one)]
    used = [name for sides in rows for side in sides for name in _names(side)]
    given = {n: m for n, m in (names or {}).items() if m not in WORDS}
    naming = Naming(Vocabulary(scene), given)
    named = [name for name in used if "(" not in name.name and not FORMULA.search(name.name)]
    naming = replace(naming, guessed=guess(naming, named, ()))
    statements = [
        _statement(scene, naming, sides, str(i), about) for i, sides in enumerate(rows, 1)
    ]
    return Reading(tuple(statements), naming.matches(n.name for n in used), ())


def sides_of(thing: Any) -> list[Sides]:
    """The sides of every row that an object claims.

    Raises
    ------
    WrongKindError
        For another kind of object, and one whose parts are not SymPy's.
    """
    if is_model(thing):
        if replaced := parts_replaced(thing):
            raise WrongKindError(
                f"check: {replaced} is not SymPy's: pass a model with SymPy's own methods"
            )
        method = form_equations(thing)
        if isinstance(method, KanesMethod):
            return _kane(method)
        return [(row, S.Zero) for row in method.eom]
    if isinstance(thing, Basic | MatrixBase) and (symbols := thing.atoms(MatrixSymbol)):
        names = ", ".join(sorted(str(symbol) for symbol in symbols))
        raise WrongKindError(f"check: {names} is a matrix without entries: pass one with entries")
    if isinstance(thing, Eq):
        left, right = thing.args
        if isinstance(left, MatrixBase) and isinstance(right, MatrixBase) and left.cols == 1:
            return list(zip(left, right, strict=True))
        return [(left, right)]
    if isinstance(thing, MatrixBase):
        held = {n.order for n in _names(thing)}
        if thing.rows == thing.cols > 1 and 2 not in held:
            return [(Matrix(thing),)]
        return [(entry,) for entry in thing]
    if isinstance(thing, Expr):
        done = thing.doit()  # of an equation with something put into it, the equation
        return sides_of(done) if isinstance(done, Eq | MatrixBase) else [(thing,)]
    raise WrongKindError(
        f"check: {type(thing).__name__} found: pass LaTeX, text, a Path, a SymPy object, a CasADi"
        " Function or a Python function"
    )


def _kane(method: KanesMethod) -> list[Sides]:
    """M u' = f row by row, with u and u' in terms of q' and q''."""
    t = dynamicsymbols._t
    rates, speeds = [q.diff(t) for q in method.q], list(method.u)
    known = method.kindiffdict()
    rows = [rate - known[rate] for rate in rates if rate in known]
    (solution,) = linsolve(rows, *speeds)
    table = {u: value for u, value in zip(speeds, solution, strict=True) if u != value}
    fast = {u.diff(t): table.get(u, u).diff(t) for u in speeds}
    left = method.mass_matrix * Matrix([u.diff(t) for u in speeds])

    def written(entry: Expr) -> Expr:
        return entry.xreplace(fast).xreplace(table)

    pairs = [(a, b) for a, b in zip(left, method.forcing, strict=True) if a != 0 or b != 0]
    # What it would integrate q' with has to be the definition of the speeds.
    count = len(rates)
    whole = method.mass_matrix_full[:count, :count] * Matrix(rates)
    kinematic = (written(e) for e in whole - Matrix(method.forcing_full[:count]))
    other = [(row, S.Zero) for row in kinematic if not is_zero(row)]
    return [*((written(a), written(b)) for a, b in pairs), *other]


def _names(side: Any) -> list[Name]:
    """Every name in an expression, with the order of its derivative, in order of their names."""
    side = _done(side)
    found = [Name(0, *_function(d)) for d in side.atoms(Derivative)]
    found += [Name(0, *_function(f), True) for f in side.atoms(AppliedUndef)]
    found += [Name(0, s.name) for s in side.free_symbols if s != dynamicsymbols._t]
    return sorted(found, key=lambda name: (name.name, name.order))


def _function(entry: Expr) -> tuple[str, int]:
    """Name and order of a function of time; what has another argument is no name of the scene's.

    theta(t) is theta, theta(t + 1), theta(0) and a derivative by anything else are themselves.
    """
    base, by = (entry.expr, entry.variables) if isinstance(entry, Derivative) else (entry, ())
    applied = isinstance(base, AppliedUndef)
    if any(str(v) != TIME.name for v in (*by, *(base.args if applied else ()))):
        return str(entry), 0
    return base.func.__name__ if applied else str(base), len(by)


NARROW = (
    "negative", "nonpositive", "zero", "imaginary", "infinite", "prime", "composite", "even", "odd",
    "integer", "rational", "irrational", "algebraic", "transcendental",
)  # fmt: skip
"""What a symbol may be assumed to be, and no quantity of a scene is."""
WIDE = ("real", "finite", "complex", "commutative")
"""What every quantity of a scene is."""


def _assumed(atom: Expr, symbol: Symbol) -> str:
    """What a person's symbol is assumed to be and the scene's is not; empty for nothing."""
    base = atom.expr if isinstance(atom, Derivative) else atom
    facts = [(name, "") for name in NARROW if getattr(base, f"is_{name}")]
    facts = [(name, no) for name, no in facts if not getattr(symbol, f"is_{name}")]
    facts += [(name, "not ") for name in WIDE if getattr(base, f"is_{name}") is False]
    return next((f"{base} is assumed to be {no}{name}" for name, no in facts), "")


def _plain(naming: Naming, side: Any, unknown: list[str], told: list[str] | None = None) -> Any:
    """A side in the scene's plain symbols, and what is assumed of them otherwise."""
    told = [] if told is None else told
    if isinstance(side, MatrixBase):
        return Matrix(side).applyfunc(lambda entry: _plain(naming, entry, unknown, told))
    side = sympify(side, strict=True).doit()
    side = decimals(side.xreplace({number: value for number, value, _ in _doubles(side)}))
    table: dict[Any, Any] = {}
    atoms = (side.atoms(Derivative), side.atoms(AppliedUndef), side.free_symbols)
    for atom in (atom for kind in atoms for atom in sorted(kind, key=str)):
        if isinstance(atom, Derivative | AppliedUndef):
            name, order = _function(atom)
        elif atom == dynamicsymbols._t:
            continue
        else:
            name, order = atom.name, 0
        table[atom] = _symbol(naming, name, order, unknown)
        told += filter(None, [_assumed(atom, table[atom])])
    return side.xreplace(table)


def _doubles(side: Any) -> Iterator[tuple[Float, Expr, str]]:
    """Doubles with what each stands for, as in code, and a sentence where it prints another."""
    for number in sorted(side.atoms(Float), key=float) if isinstance(side, Basic) else ():
        if number._prec == DOUBLE and number.is_finite:
            yield number, *constant_of(float(number))


def _other_time(naming: Naming, sides: Sides) -> str:
    """What is applied to anything but the time, or depends on it and is constant in the scene."""
    held = naming.vocabulary.scene.parameters
    found = [f for side in sides for f in _done(side).atoms(AppliedUndef)]
    for function in sorted(found, key=str):
        name, _ = _function(function)
        if "(" in name and not naming.knows(name):
            return f"{name} is not at the time t: it is no name of the scene's"
        constant = naming.lookup(name)
        if constant is not None and any(p.name == constant[0] for p in held):
            return f"{function} is a function of time: {constant[0]} of the scene is constant"
    return ""


def _two_of_a_name(sides: Sides) -> str:
    """Different symbols of one name, and functions of a person's own under SymPy's name."""
    done = [_done(side) for side in sides]
    symbols = sorted(
        {s for side in done for s in side.free_symbols}, key=lambda symbol: symbol.name
    )
    for one, other in pairwise(symbols):
        if one.name == other.name != TIME.name:
            return f"two different symbols are called {one.name}"
    for function in sorted({f for side in done for f in side.atoms(Function)}, key=str):
        own = type(function).__module__ or ""
        if not isinstance(function, AppliedUndef) and own.split(".")[0] != "sympy":
            return f"{type(function).__name__} is a function of {own or 'nobody'}, not SymPy's"
    return ""


def _formula_as_name(naming: Naming, sides: Sides) -> str:
    """A symbol whose name is a formula: nobody computes with it."""
    names = dict.fromkeys(n.name for side in sides for n in _names(side) if "(" not in n.name)
    found = (n for n in names if FORMULA.search(n) and n not in naming.given)
    return next((f"{n!r} is the name of one symbol: write it as a formula" for n in found), "")


def _done(side: Any) -> Any:
    """With all derivatives formed that can be."""
    return side.doit() if hasattr(side, "doit") else sympify(side, strict=True)


def _symbol(naming: Naming, name: str, order: int, unknown: list[str]) -> Symbol:
    try:
        symbol = naming.symbol(name, order)
    except KeyError:
        symbol = None
    if symbol is None:
        unknown.append(name)
        return Symbol(name + "'" * order, real=True)
    return symbol


def _statement(
    scene: Scene, naming: Naming, sides: Sides, tag: str, about: str | None
) -> Statement:
    unknown: list[str] = []
    told: list[str] = []
    plain = tuple(_plain(naming, side, unknown, told) for side in sides)
    source = " = ".join(str(side) for side in sides)
    note = ""
    if about is not None:
        quantity = named_quantity(about)
        plain = as_asked(quantity, plain)
    elif isinstance(plain[0], MatrixBase):
        quantity, note = MassMatrix(), "a square matrix alone is read as the mass matrix"
    else:
        quantity, plain, note = kind_of(scene, plain)
    doubt = _other_time(naming, sides) or _two_of_a_name(sides) or _formula_as_name(naming, sides)
    doubt = doubt or (unexplained(scene, unknown) if unknown else "")
    doubt = doubt or (f"{told[0]}, the scene's is not" if told else "")
    if not doubt and isinstance(quantity, Identity) and len(plain) == 1:
        doubt = "an expression without an equals sign: say what it is about"
    row = published(tag, quantity, *plain, label=source)
    read = (
        words for side in sides for entry in entries(_done(side)) for *_, words in _doubles(entry)
    )
    notes = tuple(dict.fromkeys(filter(None, (note, *read))))
    asked = dict.fromkeys(d for side in sides for entry in entries(side) for d in within(entry))
    demands = Demands(tuple(_in_plain(naming, demand) for demand in asked))
    return Statement(row, source, tag, notes=notes, doubt=doubt, demands=demands)


def _in_plain(naming: Naming, demand: Demand) -> Demand:
    operands = tuple(_plain(naming, operand, []) for operand in demand.operands)
    conditions = tuple((_plain(naming, c, []), answer) for c, answer in demand.conditions)
    return Demand(demand.operation, operands, conditions)


def is_sympy(thing: Any) -> bool:
    """Whether it is one of the objects that `read_sympy` takes."""
    return isinstance(thing, KINDS)
