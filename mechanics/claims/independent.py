"""What counts as independent under a partial derivative: q, and q' or the momenta.

J = m r^2 theta',  H = J^2/(2 m r^2)        dH/dr = -J^2/(m r^3)        J is a momentum, and held
v = r theta',      L = m v^2/2              dL/dr = m r theta'^2        v is an abbreviation

Where both readings of a definition are possible and differ, it is refused.
"""

from collections.abc import Container, Iterator, Mapping
from typing import Any, Protocol

from sympy import Expr, Matrix, Symbol
from sympy.matrices import MatrixBase

from mechanics.claims.about import ENERGY_NAMES
from mechanics.claims.names import Naming
from mechanics.claims.partials import partial_value
from mechanics.claims.place import Refused
from mechanics.claims.tree import Name, Node, names
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.rates import speeds_in_rates
from mechanics.scene.symbols import by_name, entries
from mechanics.symbolic import is_zero

ENERGIES = ("energy", "Hamiltonian")
AMBIGUOUS = "it is unclear whether {} is constant under this derivative: write out what it is"


class Values(Protocol):
    """Values of trees, and of the definitions that they use."""

    naming: Naming
    defined: Mapping[str, Any]
    trees: Mapping[str, Node]
    held: frozenset[Symbol]

    def value(self, node: Node) -> Any:
        """The value of a part of a tree."""

    def beside(self, defined: Mapping[str, Any]) -> "Values":
        """The same with other values for the definitions."""


def partial_derivative(builder: Values, of: Node, by: Node, at: int) -> Any:
    """The value of a partial derivative, with what is independent of the name that it is by.

    Raises
    ------
    Refused
        Where it is not clear what is held, or it is by what is no symbol.
    """
    moving = [n for n in _reached(builder, of) if _is_speed(builder, builder.defined[n])]
    momenta = [n for n in moving if _is_momentum(builder, builder.defined[n])]
    if isinstance(by, Name) and by.name in momenta and not by.order:
        return _held(builder, momenta, of, by, at)
    value = builder.value(of)
    variable = builder.value(by)
    _declared_speeds(builder, value, variable, at)
    plain = partial_value(value, variable, at)
    hamiltonian = isinstance(of, Name) and ENERGY_NAMES.get(of.name) in ENERGIES
    if not (momenta or (moving and hamiltonian)):
        return plain
    if _same(plain, _held(builder, moving, of, by, at)):
        return plain
    told = AMBIGUOUS.format(", ".join(moving))
    if hamiltonian:
        found = _held(builder, momenta, of, by, at)
        if momenta != moving and not _same(found, _held(builder, moving, of, by, at)):
            raise Refused(at, told)
        return found
    if momenta and not _same(plain, _held(builder, momenta, of, by, at)):
        raise Refused(at, told)
    return plain


def _reached(builder: Values, of: Node) -> list[str]:
    """Definitions that a tree uses, and that these use in turn, in the order of what they need."""
    todo, found = [n.name for n in names(of)], set[str]()
    while todo:
        name = todo.pop()
        if name in builder.trees and name in builder.defined and name not in found:
            found.add(name)
            todo += [n.name for n in names(builder.trees[name])]
    return [name for name in builder.trees if name in found]


def _is_speed(builder: Values, value: Any) -> bool:
    """Whether what a name stands for holds rates, in the first degree only."""
    scene = builder.naming.vocabulary.scene
    rates = {*scene.qd, *scene.u}
    held = sorted(set().union(*(e.free_symbols for e in entries(value))) & rates, key=by_name)
    return bool(held) and all(
        not entry.diff(rate).expand().free_symbols & rates
        for entry in entries(value)
        for rate in held
    )


def _is_momentum(builder: Values, value: Any) -> bool:
    """Whether it is a generalized momentum of the scene, or a column of them."""
    kinematics = builder.naming.vocabulary.kinematics
    return all(_momentum(kinematics, entry) for entry in entries(value))


def _momentum(kinematics: Kinematics, value: Expr) -> bool:
    plain = value.xreplace(kinematics.scene.coordinate_rates)
    return any(is_zero(plain - momentum) for momentum in kinematics.momenta.values())


def _held(builder: Values, held: Container[str], of: Node, by: Node, at: int) -> Any:
    """The derivative with some definitions as symbols of their own, which are put in behind."""
    table = dict(builder.defined)
    put_in: dict[Symbol, Expr] = {}
    inner = builder.beside(table)
    for name in _reached(builder, of):
        if name in held:
            table[name] = _symbols(name, builder.defined[name], put_in)
        else:
            table[name] = inner.value(builder.trees[name])
    inner.held = frozenset(put_in)
    found = partial_value(inner.value(of), inner.value(by), at)
    if isinstance(found, MatrixBase):
        return found.applyfunc(lambda entry: entry.xreplace(put_in))
    return found.xreplace(put_in)


def _symbols(name: str, value: Any, put_in: dict[Symbol, Expr]) -> Any:
    """A symbol for a definition, or one for each entry."""

    def symbols() -> Iterator[Symbol]:
        for i, entry in enumerate(entries(value)):
            symbol = Symbol(f"[{name}]{i}", real=True)
            put_in[symbol] = entry
            yield symbol

    found = list(symbols())
    return Matrix(*value.shape, found) if isinstance(value, MatrixBase) else found[0]


def _same(one: Any, other: Any) -> bool:
    pairs = zip(entries(one), entries(other), strict=True)
    return all(is_zero(a - b) for a, b in pairs)


def _declared_speeds(builder: Values, value: Any, by: Any, at: int) -> None:
    """Refuse derivatives by what speeds of the scene depend on, where these are in the value."""
    if isinstance(value, MatrixBase):
        return
    scene: Scene = builder.naming.vocabulary.scene
    table = speeds_in_rates(scene)
    variables = {*entries(by)}
    depends = {u for u, definition in table.items() if definition.free_symbols & variables}
    wrong = value.free_symbols & (depends | ({*scene.qd} if variables & table.keys() else set()))
    for symbol in sorted(wrong - variables, key=by_name):
        words = (
            f"{symbol} depends on the variable of this derivative: write both in the same variables"
        )
        raise Refused(at, words)
