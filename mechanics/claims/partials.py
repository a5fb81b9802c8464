r"""Partial derivatives, as in Lagrange's and Hamilton's equations.

d/dt (dL/dq') - dL/dq = Q        q, q' and the momenta count as independent of each other
"""

from collections.abc import Container

from sympy import Expr, Matrix, Symbol
from sympy.matrices import MatrixBase

from mechanics.claims.names import Naming
from mechanics.claims.place import Refused
from mechanics.claims.tree import COMPOSED, Call, Name, Node, ended, negative, parts, with_parts
from mechanics.scene.generalized_forces import from_potential

PARTIAL = "partial"


def partial_of(naming: Naming, of: Node, by: Node, at: int) -> Call:
    """The tree of a partial derivative.

    Raises
    ------
    Refused
        Where it is not by a name, or is that of a constant of the scene.
    """
    if not isinstance(by, Name):
        raise Refused(at, "a partial derivative needs one name below the bar")
    if by.name == "t" and not naming.knows("t"):
        raise Refused(at, "a partial derivative by time: write d/dt if that is meant")
    if isinstance(of, Name) and naming.is_function(of.name) is False:
        words = f"{of.name} is {naming.target(of.name)[0]} of the scene"  # type: ignore[index]
        raise Refused(at, f"the partial derivative of a constant: {words}; rename yours")
    return Call(at, PARTIAL, (of, by))


def partial_value(value: Expr, by: Expr | MatrixBase, at: int) -> Expr | MatrixBase:
    """The derivative by a symbol, or by each of a column, as a column.

    Raises
    ------
    Refused
        For the derivative of a matrix, or by what is no symbol.
    """
    entries = list(by) if isinstance(by, MatrixBase) else [by]
    if isinstance(value, MatrixBase) or not all(isinstance(entry, Symbol) for entry in entries):
        raise Refused(
            at, "a partial derivative has a scalar above the bar and an independent name below it"
        )
    found = [value.diff(entry) for entry in entries]
    return Matrix(found) if isinstance(by, MatrixBase) else found[0]


def canonical(node: Node, naming: Naming, own: Container[str]) -> Node:
    """Partial derivatives of an L or H that the text does not define, which is the scene's.

    dL/dq' = p, dH/dp = q'; where nothing but a potential acts, dL/dq = p' and dH/dq = -p', too.
    """
    if isinstance(node, Call) and node.function == PARTIAL:
        of, by = node.arguments
        known = isinstance(of, Name) and (naming.knows(of.name) or of.name in own)
        if not known and isinstance(of, Name) and of.name in CONJUGATE and isinstance(by, Name):
            return _conjugate(CONJUGATE[of.name], by, naming) or node
    inside = parts(node)
    new = tuple(canonical(part, naming, own) for part in inside)
    return node if new == inside else ended(with_parts(node, new), node.end)


CONJUGATE = {"L": "L", "Lagrangian": "L", "H": "H"}


def _conjugate(letter: str, by: Name, naming: Naming) -> Node | None:
    """What the partial derivative of L or H is along a motion; None where that is open."""
    scene, target = naming.vocabulary.scene, naming.target(by.name)
    if target is None:
        only = tuple(naming.vocabulary.momenta) if by.name == "p" else ()
        target = (only[0], 0) if len(only) == 1 else naming.momentum(by.name)
    if scene.speeds or target is None:
        return None
    name, order = target[0], target[1] + by.order
    if letter == "H" and name in naming.vocabulary.momenta and order == 0:
        return Name(COMPOSED, name.removeprefix("p_"), 1)
    if name not in {q.name for q in scene.q}:
        return None
    momentum = f"p_{name}"
    if letter == "L" and order == 1:
        return Name(COMPOSED, momentum)
    if order != 0 or scene.constraints or not from_potential(scene):
        return None
    rate = Name(COMPOSED, momentum, 1)
    return rate if letter == "L" else negative(rate)


def undifferentiated(node: Node) -> set[str]:
    """Names in a tree that stand elsewhere than alone in a partial derivative."""
    if isinstance(node, Call) and node.function == PARTIAL and isinstance(node.arguments[0], Name):
        return undifferentiated(node.arguments[1])
    if isinstance(node, Name):
        return {node.name}
    return set[str]().union(*map(undifferentiated, parts(node)))
