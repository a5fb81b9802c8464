"""What is reached from some nodes of a graph, as functions from the calls of others."""

from collections.abc import Collection, Mapping


def reachable(starts: Collection[str], edges: Mapping[str, Collection[str]]) -> set[str]:
    """The starts, and all that edges lead to from them."""
    reached, frontier = {*starts}, [*starts]
    while frontier:
        new = {*edges.get(frontier.pop(), ())} - reached
        reached |= new
        frontier += new
    return reached
