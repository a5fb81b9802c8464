"""Small matrices of nodes: products, differences, inverses."""

from mechanics.linear.operating_point import pivots
from mechanics.program import Builder, Node
from mechanics.program.elimination import solve_with_pivots
from mechanics.program.vectors import dot

Rows = list[list[Node]]


def product(left: Rows, right: Rows) -> Rows:
    """Of two matrices of nodes; entries that are 0 cost nothing."""
    columns = list(zip(*right, strict=True))
    return [[dot(row, column) for column in columns] for row in left]


def difference(left: Rows, right: Rows) -> Rows:
    """Of two matrices of nodes."""
    pairs = zip(left, right, strict=True)
    return [[a - b for a, b in zip(one, two, strict=True)] for one, two in pairs]


def padded(builder: Builder, matrix: Rows, columns: int) -> Rows:
    """A matrix with columns of 0 appended."""
    return [[*row, *[builder.zero] * (columns - len(row))] for row in matrix]


def inverse(builder: Builder, matrix: Rows) -> Rows:
    """Of a matrix of nodes that is regular, its pivots chosen at one point of a field."""
    size = range(len(matrix))
    order = pivots(builder, matrix)
    sides = [[builder.node(int(i == j)) for i in size] for j in size]
    columns = [solve_with_pivots(matrix, side, order) for side in sides]
    return [list(row) for row in zip(*columns, strict=True)]
