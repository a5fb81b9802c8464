"""Brackets that end elsewhere: what stands before or behind one multiplies more or fewer terms.

m l a - b  ->  m l (a - b)        a + b/c  ->  (a + b)/c        and the other way round
"""

from collections.abc import Iterator, Sequence
from math import prod

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import HINT, SECOND, TOKEN, Change
from mechanics.blame.search.edits import Maker
from mechanics.claims.tree import Node, Product, Sum, parts, product, total

LONGEST = 12
"""Terms of a sum, and factors of a product, in which brackets are moved."""

Values = tuple[int, ...]


def other_extents(make: Maker, index: int, node: Sum | Product) -> Iterator[Change]:
    """A sum or product with one bracket that ends elsewhere."""
    kids = make.tree.kids[index]
    if len(kids) != len(parts(node)) or len(kids) > LONGEST:
        return
    options = _widened(make, node, kids) if isinstance(node, Sum) else _narrowed(make, node, kids)
    for new, values in options:
        cost = TOKEN + SECOND + HINT
        yield make.change(index, new, Mistake.FACTOR, cost, tuple(v % make.p for v in values))


def _widened(make: Maker, node: Sum, kids: Sequence[int]) -> Iterator[tuple[Node, Values]]:
    """Factors of one term that multiply its neighbours, too."""
    whole = _sum(make, kids)
    for k, kid in enumerate(kids):
        factors = _factors(make, kid)
        for cut in range(1, len(factors)):
            above, below = factors[:cut], factors[cut:]
            before, behind = ([node for node, _ in some] for some in (above, below))
            for end in range(k + 2, len(kids) + 1):  # a factor before reaches terms behind it
                rest = product(node.at, behind)
                bracket = total(node.at, [rest, *node.terms[k + 1 : end]])
                new = product(node.at, [*before, bracket])
                grown = _grown(make, [i for _, i in above], kids[k + 1 : end], whole)
                yield total(node.at, [*node.terms[:k], new, *node.terms[end:]]), grown
            for start in range(k):  # one behind reaches terms before it
                bracket = total(node.at, [*node.terms[start:k], product(node.at, before)])
                new = product(node.at, [bracket, *behind])
                grown = _grown(make, [i for _, i in below], kids[start:k], whole)
                yield total(node.at, [*node.terms[:start], new, *node.terms[k + 1 :]]), grown


def _factors(make: Maker, index: int) -> list[tuple[Node, int]]:
    """The factors of a term with their places, those of a part of it, too."""
    node, kids = make.tree.nodes[index], make.tree.kids[index]
    if not isinstance(node, Product) or len(kids) != len(node.factors):
        return [(node, index)]
    return [factor for kid in kids for factor in _factors(make, kid)]


def _narrowed(make: Maker, node: Product, kids: Sequence[int]) -> Iterator[tuple[Node, Values]]:
    """A sum that its last factors, or the first ones, multiply only one part of."""
    for first, at, others in ((True, len(kids) - 1, kids[:-1]), (False, 0, kids[1:])):
        inner = make.tree.kids[kids[at]]
        bracket = node.factors[at]
        if not isinstance(bracket, Sum) or len(inner) != len(bracket.terms):
            continue
        around = node.factors[:-1] if first else node.factors[1:]
        for cut in range(1, len(inner)):
            one, two = bracket.terms[:cut], bracket.terms[cut:]
            held, free = (inner[:cut], inner[cut:]) if first else (inner[cut:], inner[:cut])
            if first:
                terms = [product(node.at, [*around, total(node.at, [*one])]), *two]
            else:
                terms = [*one, product(node.at, [total(node.at, [*two]), *around])]
            pairs = zip(_sum(make, held), _product(make, others), _sum(make, free), strict=True)
            yield total(node.at, terms), tuple(a * b + c for a, b, c in pairs)


def _grown(make: Maker, factors: Sequence[int], terms: Sequence[int], whole: Values) -> Values:
    """The worth of a sum where factors multiply some of its terms."""
    triples = zip(whole, _product(make, factors), _sum(make, terms), strict=True)
    return tuple(all_of + (factor - 1) * some for all_of, factor, some in triples)


def _sum(make: Maker, indices: Sequence[int]) -> Values:
    return tuple(sum(sheet.has[i] for i in indices) for sheet in make.sheets)


def _product(make: Maker, indices: Sequence[int]) -> Values:
    return tuple(prod(sheet.has[i] for i in indices) % make.p for sheet in make.sheets)
