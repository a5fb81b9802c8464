"""What depends on parameters only, computed once: f(q, u, inputs, p) = g(q, u, inputs, h(p)).

    prepare    c = h(p): every value of parameters only that the rest of the function uses
    prepared   g: the rest, with c in place of p

The operations of both are those of the function, in its order, so the same roundings; but for what
the function divides by: where that depends on parameters only, c holds the reciprocal, and the
quotient becomes a product (`mechanics.compiled.programs.reciprocals` has the bound of its error).
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import casadi as ca

from mechanics.compiled.programs.program import Node, Program
from mechanics.compiled.programs.rewriting import Rewriting

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
    prepare : Program
        Of ``p``, with one output ``c``.
    prepared : Program
        With ``c`` in place of ``p``.
    names : tuple of str
        Of the entries of c: a parameter's own name where one is passed on, ``over_`` and the name
        for its reciprocal.
    """

    prepare: Program
    prepared: Program
    names: tuple[str, ...]


def hoisted(code: Program, entries: Mapping[str, Sequence[str]]) -> Hoisted:
    """Split a function; one that has no parameters gives an empty first part.

    Parameters
    ----------
    code : Program
    entries : mapping of str to sequence of str
        For each input the names of its entries.
    """
    groups = [name for name, _ in code.inputs]
    place = groups.index(PARAMETERS)
    known = _known(code, place)
    held = _held(code, known)
    names = tuple(_name(code, each, i, entries[PARAMETERS]) for each, i in held.items())
    return Hoisted(_prepare(code, held), _prepared(code, place, known, held), names)


def _known(code: Program, place: int) -> set[int]:
    """Nodes that depend on parameters only."""
    known: set[int] = set()
    free: set[int] = set()
    for k, node in enumerate(code.nodes):
        if node.constant is not None:
            free.add(k)
        elif node.operation == ca.OP_INPUT:
            if node.operands[0] == place:
                known.add(k)
        elif all(i in known or i in free for i in node.operands):
            (known if any(i in known for i in node.operands) else free).add(k)
    return known


def _held(code: Program, known: set[int]) -> dict[Held, int]:
    """What the rest uses, with its place in c."""
    found: dict[Held, None] = {}
    for k, node in enumerate(code.nodes):
        if k in known or node.constant is not None or node.operation == ca.OP_INPUT:
            continue
        for place, i in enumerate(node.operands):
            if i in known:
                found[i, node.operation == ca.OP_DIV and place == 1] = None
    for nodes in code.outputs:
        found |= {(k, False): None for k in nodes if k in known}
    return {each: i for i, each in enumerate(sorted(found))}


def _name(code: Program, each: Held, place: int, parameters: Sequence[str]) -> str:
    k, inverted = each
    if code.nodes[k].operation != ca.OP_INPUT:
        return f"c{place}"
    name = parameters[code.nodes[k].operands[1]]
    return f"over_{name}" if inverted else name


def _prepare(code: Program, held: Mapping[Held, int]) -> Program:
    new = Rewriting(code.nodes)
    needed = _needed(code, (k for k, _ in held))
    for k, node in enumerate(code.nodes):
        if k in needed:
            at = new.keep(k)
            if node.operation == ca.OP_INPUT:
                new.nodes[at] = node._replace(operands=(0, node.operands[1]))
    outputs = tuple(
        new.add(Node(ca.OP_INV, (new.of[k],), None)) if inverted else new.of[k]
        for k, inverted in held
    )
    size = dict(code.inputs)[PARAMETERS]
    return Program(
        PREPARE,
        tuple(new.nodes),
        (outputs,),
        ((PARAMETERS, size),),
        ((CONSTANTS, (len(outputs), 1)),),
    )


def _prepared(code: Program, place: int, known: set[int], held: Mapping[Held, int]) -> Program:
    new = Rewriting(code.nodes)
    inputs: dict[Held, int] = {}
    for each, entry in held.items():
        inputs[each] = new.add(Node(ca.OP_INPUT, (place, entry), None))
        if not each[1]:
            new.of[each[0]] = inputs[each]
    used = _needed(code, (k for nodes in code.outputs for k in nodes), stop=known)
    for k, node in enumerate(code.nodes):
        if k in known or k not in used:
            continue
        if node.operation == ca.OP_DIV and node.operands[1] in known:
            operands = (new.of[node.operands[0]], inputs[node.operands[1], True])
            new.of[k] = new.add(Node(ca.OP_MUL, operands, None))
        else:
            new.keep(k)
    shorter = new.program(code)
    groups = list(code.inputs)
    groups[place] = (CONSTANTS, len(held))
    return replace(shorter, name=f"{code.name}{PREPARED}", inputs=tuple(groups))


def _needed(code: Program, roots: Iterable[int], stop: Iterable[int] = ()) -> set[int]:
    """Nodes that others are computed from, and these; what `stop` holds is not looked into."""
    found, halt = set(roots), set(stop)
    for k in range(len(code.nodes) - 1, -1, -1):
        node = code.nodes[k]
        computed = node.constant is None and node.operation != ca.OP_INPUT
        if k in found and k not in halt and computed:
            found.update(node.operands)
    return found
