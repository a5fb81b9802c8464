"""Vectors and matrices of nodes, as tuples; written for the sizes of mechanics: 3 and n."""

from collections.abc import Sequence

from mechanics.program.builder import Builder, Node

Vector = tuple[Node, ...]
Matrix = tuple[Vector, ...]


def add(*vectors: Sequence[Node]) -> Vector:
    """Sum of vectors of equal length."""
    total = list(vectors[0])
    for vector in vectors[1:]:
        total = [a + b for a, b in zip(total, vector, strict=True)]
    return tuple(total)


def subtract(a: Sequence[Node], b: Sequence[Node]) -> Vector:
    """a - b."""
    return tuple(x - y for x, y in zip(a, b, strict=True))


def scale(factor: Node | int, vector: Sequence[Node]) -> Vector:
    """A number times a vector."""
    return tuple(x * factor for x in vector)


def dot(a: Sequence[Node], b: Sequence[Node]) -> Node:
    """a . b, of at least one component."""
    total = a[0] * b[0]
    for x, y in zip(a[1:], b[1:], strict=True):
        total = total + x * y
    return total


def cross(a: Sequence[Node], b: Sequence[Node]) -> Vector:
    """a x b, in three dimensions."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def times(matrix: Sequence[Sequence[Node]], vector: Sequence[Node]) -> Vector:
    """matrix vector."""
    return tuple(dot(row, vector) for row in matrix)


def transpose(matrix: Sequence[Sequence[Node]]) -> Matrix:
    """Its columns as rows."""
    return tuple(zip(*matrix, strict=True))


def product(a: Sequence[Sequence[Node]], b: Sequence[Sequence[Node]]) -> Matrix:
    """a b."""
    columns = transpose(b)
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def zeros(builder: Builder, size: int = 3) -> Vector:
    """The zero vector."""
    return (builder.zero,) * size


def identity(builder: Builder, size: int = 3) -> Matrix:
    """The unit matrix."""
    return tuple(
        tuple(builder.one if i == j else builder.zero for j in range(size)) for i in range(size)
    )
