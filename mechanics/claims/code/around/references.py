"""References of C++ as what they stand for: they are bound once, and never to anything else.

double &th = y[0];  th += h*k[0];     ->      y[0] += h*k[0];
"""

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace

from mechanics.claims.code.around.intermediate_form import Term


def without_references(body: Term) -> Term:
    """A block with the places that references stand for; texts stay as their author wrote them.

    One to a place that is found anew each time, as ``z[i]``, stays another name.

    Parameters
    ----------
    body : Term
    """
    declared = Counter(one.name for one in body.all() if one.kind == "type")
    called = {one.name.partition(".")[0] for one in body.all() if one.kind == "call"}
    known: dict[str, Term] = {}
    for one in body.all():
        for kind, line in zip(one.parts, one.parts[1:], strict=False):
            if kind.kind == "type" and kind.text.endswith("&") and line.kind == "set":
                target, value = line.parts
                if target.name == kind.name and _is_fixed(value) and declared[kind.name] == 1:
                    known[kind.name] = value
    known = {name: value for name, value in known.items() if name not in called}
    return _replaced(body, known) if known else body


def _is_fixed(place: Term) -> bool:
    """Whether a place is the same each time: y, y[0], rod.theta."""
    if place.kind == "entry":
        return _is_fixed(place.parts[0]) and all(p.kind == "number" for p in place.parts[1:])
    if place.kind == "field":
        return _is_fixed(place.parts[0])
    return place.kind == "name" and place.text == place.name


def _replaced(one: Term, known: Mapping[str, Term]) -> Term:
    if one.kind == "name" and one.name in known:
        return _replaced(known[one.name], {n: v for n, v in known.items() if n != one.name})
    parts: list[Term] = []
    for part in one.parts:
        bound = part.parts[0].name if part.kind == "set" else ""
        declares = bound in known and bool(parts) and parts[-1].kind == "type"
        if declares and parts[-1].name == bound:
            parts.pop()
        else:
            parts.append(_replaced(part, known))
    return replace(one, parts=tuple(parts))
