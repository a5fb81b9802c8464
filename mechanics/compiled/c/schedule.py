"""The order of the statements of a long function: while a call runs, what does not wait for it.

The machine looks some hundred instructions ahead. A recursion along a chain of bodies is a chain of
roundings that wait for each other; a sine and cosine in the midst of it are done at the same time,
at the beginning they only add to it. So a function is simulated on a machine with one unit for
calls and one for the rest, and at every moment that node is next that has the longest way to an
output (list scheduling). What a call is given is computed just before it: gcc joins the sine and
cosine of an angle where the angle is made, wherever they stand.

Chains of 5 to 50 links, measured in turn: 10 to 25 percent less time than calls first.
"""

import heapq
from collections.abc import Iterator

from mechanics.program.c_printer import CALLS as LIBRARY
from mechanics.program.operations import ABS, DIVIDE, SQRT
from mechanics.program.postorder import postorder
from mechanics.program.routine import Routine, routine

LEAST = 3
"""Different arguments of calls from which on the order matters."""
CALL, SLOW, QUICK, STEP = 120.0, 13.0, 4.0, 0.5
"""Cycles: a call and what fits beside it, until a quotient or root is there, until another value
is, and until the next operation can begin."""

SLOWLY = frozenset({SQRT, DIVIDE})
CALLS = frozenset(LIBRARY) - {SQRT, ABS}
"""Functions of the C library that are no instructions."""


def scheduled(code: Routine) -> Routine:
    """The same program with its nodes in another order; one with few calls stays as it is."""
    if len({node.operands for node in code.nodes if node.operation in CALLS}) < LEAST:
        return code
    order = list(_emitted(code, _starts(code)))
    place = {k: i for i, k in enumerate(order)}
    nodes = [
        code.nodes[k]._replace(operands=tuple(place[i] for i in operands))
        if (operands := code.operands(k))
        else code.nodes[k]
        for k in order
    ]
    outputs = [[place[k] for k in entries] for entries in code.outputs]
    return routine(code.name, nodes, outputs, code.inputs, code.shapes)


def _emitted(code: Routine, wanted: Iterator[int]) -> Iterator[int]:
    """The nodes in the order wanted, each after what it is computed from, and the rest."""
    done: set[int] = set()
    for first in (*wanted, *range(len(code.nodes))):
        for k in postorder(first, lambda n: code.operands(n)[::-1], done):
            done.add(k)
            yield k


def _starts(code: Routine) -> Iterator[int]:
    """Nodes as they begin on the machine; inputs, and what only calls are given, have no time."""
    users: list[list[int]] = [[] for _ in code.nodes]
    for k in range(len(code.nodes)):
        for i in set(code.operands(k)):
            users[i].append(k)
    late, way = _late(code, users), _ways(code, users)
    left = {k: len(set(code.operands(k)) - late) for k in range(len(users)) if k not in late}
    there = dict.fromkeys(left, 0.0)
    # Nodes by the time when their operands are there, and those that can begin, unit by unit.
    coming = [(0.0, k) for k, count in left.items() if count == 0]
    ready: tuple[list[tuple[float, int]], ...] = ([], [])
    free, now = [0.0, 0.0], 0.0
    while coming or any(ready):
        while coming and coming[0][0] <= now:
            _, k = heapq.heappop(coming)
            heapq.heappush(ready[code.nodes[k].operation in CALLS], (-way[k], k))
        for unit, busy in enumerate((STEP, CALL)):
            if not ready[unit] or free[unit] > now:
                continue
            free[unit] = now + busy
            for k in _taken(code, ready[unit]) if unit else [heapq.heappop(ready[unit])[1]]:
                yield k
                for user in users[k]:
                    left[user] -= 1
                    there[user] = max(there[user], now + _time(code, k))
                    if left[user] == 0:
                        heapq.heappush(coming, (there[user], user))
        moments = [free[unit] for unit in (0, 1) if ready[unit]] + [time for time, _ in coming[:1]]
        now = max(now, min(moments, default=now))


def _taken(code: Routine, ready: list[tuple[float, int]]) -> list[int]:
    """The next call, and what else is called with the same: a sine comes with its cosine."""
    given = code.nodes[ready[0][1]].operands
    found = sorted(k for _, k in ready if code.nodes[k].operands == given)
    ready[:] = [each for each in ready if each[1] not in found]
    heapq.heapify(ready)
    return found


def _late(code: Routine, users: list[list[int]]) -> set[int]:
    """Inputs, numbers, and what is made of these for calls only: they wait for who needs them."""
    outputs = {k for entries in code.outputs for k in entries}
    asked: set[int] = set()
    for k in reversed(range(len(users))):
        calls = all(code.nodes[u].operation in CALLS or u in asked for u in users[k])
        if calls and k not in outputs and code.nodes[k].operation not in CALLS:
            asked.add(k)
    found: set[int] = set()
    for k in range(len(users)):
        operands = code.operands(k)
        if not operands or (k in asked and all(i in found for i in operands)):
            found.add(k)
    return found


def _ways(code: Routine, users: list[list[int]]) -> list[float]:
    """Cycles from the beginning of a node to the end of the longest chain after it."""
    way = [0.0] * len(users)
    for k in reversed(range(len(users))):
        way[k] = _time(code, k) + max((way[user] for user in users[k]), default=0.0)
    return way


def _time(code: Routine, k: int) -> float:
    if not code.operands(k):
        return 0.0
    operation = code.nodes[k].operation
    return CALL if operation in CALLS else SLOW if operation in SLOWLY else QUICK
