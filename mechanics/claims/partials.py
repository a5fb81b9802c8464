r"""Partial derivatives, as in Lagrange's and Hamilton's equations.

d/dt (dL/dq') - dL/dq = Q        q, q' and the momenta count as independent of each other
"""

from sympy import Expr, Matrix, Symbol
from sympy.matrices import MatrixBase

from mechanics.claims.names import Naming
from mechanics.claims.place import Refused
from mechanics.claims.tree import Call, Name, Node, parts

PARTIAL = "partial"


def partial_of(naming: Naming, of: Node, by: Node, at: int) -> Call:
    """The tree of a partial derivative.

    Raises
    ------
    Refused
        Where it is not by a name, or is that of a constant of the scene.
    """
    if not isinstance(by, Name):
        raise Refused(at, "a partial derivative is by one name")
    if by.name == "t" and not naming.knows("t"):
        raise Refused(at, "a partial derivative by the time: write d/dt, if that is meant")
    if isinstance(of, Name) and naming.is_function(of.name) is False:
        words = f"{of.name} is {naming.target(of.name)[0]} of the scene"  # type: ignore[index]
        raise Refused(at, f"the partial derivative of a constant: {words}; call yours otherwise")
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
            at, "a partial derivative is that of a number, by a name that nothing defines"
        )
    found = [value.diff(entry) for entry in entries]
    return Matrix(found) if isinstance(by, MatrixBase) else found[0]


def undifferentiated(node: Node) -> set[str]:
    """Names in a tree that stand elsewhere than alone in a partial derivative."""
    if isinstance(node, Call) and node.function == PARTIAL and isinstance(node.arguments[0], Name):
        return undifferentiated(node.arguments[1])
    if isinstance(node, Name):
        return {node.name}
    return set[str]().union(*map(undifferentiated, parts(node)))
