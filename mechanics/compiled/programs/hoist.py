"""What depends on parameters only, computed once: f(q, u, inputs, p) = g(q, u, inputs, h(p)).

    prepare    c = h(p): every value of parameters only that the rest of the function uses
    prepared   g: the rest, with c in place of p

The operations of both are those of the function, in its order, so the same roundings; but for what
the function divides by: where that depends on parameters only, c holds the reciprocal, and the
quotient becomes a product (`mechanics.compiled.programs.reciprocals` has the bound of its error).
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from mechanics.compiled.programs.rewriting import Rewriting
from mechanics.program.operations import DIVIDE, INPUT, MULTIPLY
from mechanics.program.routine import Routine, routine

PARAMETERS, CONSTANTS = "p", "c"
PREPARE, PREPARED = "prepare", "_prepared"
"""Name of the first function, and the end of the name of the second."""

Held = tuple[int, bool]
"""A node of the function, and whether its reciprocal is held instead."""


@dataclass(frozen=True)
class Hoisted:
    """A function in two parts.

    Attributes
    ----------
    prepare : Routine
        Of ``p``, with one output ``c``.
    prepared : Routine
        With ``c`` in place of ``p``.
    names : tuple of str
        Of the entries of c: a parameter's own name where one is passed on, ``over_`` and the name
        for its reciprocal.
    """

    prepare: Routine
    prepared: Routine
    names: tuple[str, ...]


def hoisted(code: Routine, entries: Mapping[str, Sequence[str]]) -> Hoisted:
    """Split a function; one that has no parameters gives an empty first part.

    Parameters
    ----------
    entries : mapping of str to sequence of str
        For each input the names of its entries.
    """
    groups = [name for name, _ in code.inputs]
    place = groups.index(PARAMETERS)
    known = _known(code, place)
    held = _held(code, known)
    names = tuple(_name(code, each, i, entries[PARAMETERS]) for each, i in held.items())
    return Hoisted(_prepare(code, held), _prepared(code, place, known, held), names)


def _known(code: Routine, place: int) -> set[int]:
    """Nodes that depend on parameters only."""
    known: set[int] = set()
    free: set[int] = set()
    for k, node in enumerate(code.nodes):
        if node.constant is not None:
            free.add(k)
        elif node.operation == INPUT:
            if node.operands[0] == place:
                known.add(k)
        elif all(i in known or i in free for i in node.operands):
            (known if any(i in known for i in node.operands) else free).add(k)
    return known


def _held(code: Routine, known: set[int]) -> dict[Held, int]:
    """What the rest uses, with its place in c."""
    found: dict[Held, None] = {}
    for k, node in enumerate(code.nodes):
        if k in known or node.constant is not None or node.operation == INPUT:
            continue
        for place, i in enumerate(node.operands):
            if i in known:
                found[i, node.operation == DIVIDE and place == 1] = None
    for nodes in code.outputs:
        found |= {(k, False): None for k in nodes if k in known}
    return {each: i for i, each in enumerate(sorted(found))}


def _name(code: Routine, each: Held, place: int, parameters: Sequence[str]) -> str:
    k, inverted = each
    if code.nodes[k].operation != INPUT:
        return f"c{place}"
    name = parameters[code.nodes[k].operands[1]]
    return f"over_{name}" if inverted else name


def _prepare(code: Routine, held: Mapping[Held, int]) -> Routine:
    new = Rewriting(code.nodes)
    needed = _needed(code, (k for k, _ in held))
    for k, node in enumerate(code.nodes):
        if k in needed:
            at = new.keep(k)
            if node.operation == INPUT:
                new.nodes[at] = node._replace(operands=(0, node.operands[1]))
    outputs = [
        new.add(DIVIDE, new.one(), new.of[k]) if inverted else new.of[k] for k, inverted in held
    ]
    size = dict(code.inputs)[PARAMETERS]
    shapes = ((CONSTANTS, (len(outputs), 1)),)
    return routine(PREPARE, new.nodes, [outputs], ((PARAMETERS, size),), shapes)


def _prepared(code: Routine, place: int, known: set[int], held: Mapping[Held, int]) -> Routine:
    new = Rewriting(code.nodes)
    inputs: dict[Held, int] = {}
    for each, entry in held.items():
        inputs[each] = new.add(INPUT, place, entry)
        if not each[1]:
            new.of[each[0]] = inputs[each]
    used = _needed(code, (k for nodes in code.outputs for k in nodes), stop=known)
    for k, node in enumerate(code.nodes):
        if k in known or k not in used:
            continue
        if node.operation == DIVIDE and node.operands[1] in known:
            inverse = inputs[node.operands[1], True]
            new.of[k] = new.add(MULTIPLY, new.of[node.operands[0]], inverse)
        else:
            new.keep(k)
    groups = list(code.inputs)
    groups[place] = (CONSTANTS, len(held))
    return new.routine(code, f"{code.name}{PREPARED}", tuple(groups))


def _needed(code: Routine, roots: Iterable[int], stop: Iterable[int] = ()) -> set[int]:
    """Nodes that others are computed from, and these; what `stop` holds is not looked into."""
    found, halt = set(roots), set(stop)
    for k in range(len(code.nodes) - 1, -1, -1):
        node = code.nodes[k]
        computed = node.constant is None and node.operation != INPUT
        if k in found and k not in halt and computed:
            found.update(node.operands)
    return found
