"""Each node after its operands, by an explicit stack: graphs are deeper than Python's recursion."""

from collections.abc import Callable, Container, Iterable, Iterator
from typing import TypeVar

T = TypeVar("T")


def postorder(root: T, operands: Callable[[T], Iterable[T]], done: Container[T]) -> Iterator[T]:
    """What the root needs and is not done, each after its operands; the last of these come first.

    Parameters
    ----------
    operands : callable
        What a node is made of.
    done : container
        The caller puts every node in before it takes the next one.

    Examples
    --------
    >>> sizes = {}
    >>> for n in postorder(6, lambda n: [n // 2] if n > 1 else [], sizes):
    ...     sizes[n] = 1 + sizes.get(n // 2, 0)
    >>> sizes
    {1: 1, 3: 2, 6: 3}
    """
    stack = [root]
    while stack:
        node = stack[-1]
        missing = () if node in done else [part for part in operands(node) if part not in done]
        if missing:
            stack.extend(missing)
            continue
        if node not in done:
            yield node
        stack.pop()
