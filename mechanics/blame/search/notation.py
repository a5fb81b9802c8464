r"""Edits in the person's own notation, with their places in the source.

sign: "-" -> "+"       term added: "" -> "+ 2 k x"       anything else: what stands there -> instead
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, takewhile

from sympy.matrices import MatrixBase

from mechanics.blame.result import Edit, Mistake
from mechanics.blame.search.change import Change, is_minus, minus
from mechanics.blame.search.claim import Claim
from mechanics.blame.search.syntax_tree import SyntaxTree
from mechanics.claims.claim import Trees
from mechanics.claims.spelling import Spelling, hidden_minus
from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Sum,
    constant,
    names,
    parts,
    with_parts,
)
from mechanics.scene.published import Published

SIGN = re.compile(r"[-+\u2212]\s*$")
FACTOR = re.compile(r"(?<!frac)(?<!frac )(?:\d|(?<![\\A-Za-z])[A-Za-z]+)\s*$")
"""What a number behind would be a part of; the argument of a fraction is none."""
PLUS = re.compile(r"\s*\+\s*")
TIMES_AFTER = re.compile(r"\s*(?:\.?\*(?!\*)|\\cdot(?![A-Za-z])|\\times(?![A-Za-z]))\s*")
TIMES_BEFORE = re.compile(r"\s*(?:(?<!\*)\.?\*|\\cdot|\\times)\s*$")
OPENS = re.compile(r"(?:\\left\s*)?\(\s*$")
CLOSES = re.compile(r"\s*(?:\\right\s*)?\)")
Span = tuple[int, int]


def edit_of(claim: Claim, spelling: Spelling, tree: SyntaxTree, change: Change) -> Edit:
    """An edit as a person makes it, with the names that the person has for parts of it."""
    home = tree.place[change.index][0]
    if change.node is not None:
        change = replace(change, node=_in_own_names(claim, home, change.node))
    if isinstance(home, str):
        place = claim.written.places.get(home, "")
        if _adds(tree, change) and change.wrap and tree.side(change.index):
            term = change.wrap(Number(0, Fraction(0)))
            return Edit(change.mistake, "", _signed(spelling, term), None, home, place)
        # It stands elsewhere, so that a sign alone would say nothing.
        return Edit(change.mistake, *_without_place(tree, change, spelling), None, home, place)
    node, new = tree.nodes[change.index], change.node
    span = spelling.span(node)
    above = tree.parent[change.index]
    around = tree.nodes[above] if above >= 0 else None
    if span is None and isinstance(around, Power) and new is not None and spelling.span(around):
        # The sine of sin^2(x) has no place of its own.
        power = Power(around.at, new, around.exponent)
        return edit_of(claim, spelling, tree, replace(change, index=above, node=power, wrap=None))
    if span is None and isinstance(around, Call) and new is not None and spelling.span(around):
        # Nor has the angle of c_2.
        kids = tree.kids[above]
        arguments = [new if k == change.index else tree.nodes[k] for k in kids]
        call = with_parts(around, tuple(arguments))
        return edit_of(claim, spelling, tree, replace(change, index=above, node=call, wrap=None))
    above_line = constant(new.exponent) if isinstance(new, Power) else None
    if _divides(node) and isinstance(new, Power) and above_line is not None and above_line < 0:
        # r^2 for r below a line, not 1/r^2.
        exponent = Number(new.at, -above_line)
        below = new.base if above_line == -1 else Power(new.base.at, new.base, exponent)
        base = tree.kids[change.index][0]
        return edit_of(claim, spelling, tree, replace(change, index=base, node=below, wrap=None))
    sign = None if span is None else _sign_before(claim, span)
    if change.mistake is Mistake.SIGN and sign is not None:
        mark = claim.written.text[sign[0]]
        return _edit(claim, change, mark, "-" if mark == "+" else "+", sign)
    if _adds(tree, change) and isinstance(new, Sum):
        beside = spelling.span(_neighbour(new)) if span else None
        end = _with_brackets(claim.written.text, beside)[1] if beside else (span or (0, 0))[1]
        at = (end, end) if span else None
        return _edit(claim, change, "", _signed(spelling, new.terms[-1]), at)
    if new is None and tree.side(change.index):
        return _edit(claim, change, spelling(node), "0", span)
    if span is None or (sign is None and hidden_minus(node)):
        return _edit(claim, change, *_without_place(tree, change, spelling), None)
    if new is None and isinstance(around, Sum):
        # A bracket of its own goes with a term, and the sign before it.
        span = _with_brackets(claim.written.text, span)
        sign = _sign_before(claim, span)
    written = " ".join(claim.written.text[slice(*span)].split())
    if new is None:
        if sign is not None and isinstance(around, Sum):
            written, span = f"{claim.written.text[sign[0]]} {written}", (sign[0], span[1])
            return _edit(claim, change, written, "", span)
        if isinstance(around, Sum) and (plus := PLUS.match(claim.written.text, span[1])):
            return _edit(claim, change, written, "", (span[0], plus.end()))
        span, right = _left_out(claim.written.text, span)
        return _edit(claim, change, written, right, span)
    if hidden_minus(node) and is_minus(new):
        return _edit(claim, change, written, spelling(minus(new)), span)
    in_sum = tree.parent[change.index] >= 0 and isinstance(
        tree.nodes[tree.parent[change.index]], Sum
    )
    if sign is not None and in_sum and (is_minus(new) or hidden_minus(node)):
        written = f"{claim.written.text[sign[0]]} {written}"
        return _edit(claim, change, written, _signed(spelling, new), (sign[0], span[1]))
    return _edit(claim, change, written, _fitting(tree, change, spelling), span)


def _in_own_names(claim: Claim, home: int | str, node: Node) -> Node:
    """A new sum or product by the name that an earlier definition gives it: total_mass."""
    before = takewhile(lambda pair: pair[0] != home, claim.written.definitions)
    own = {_shape(tree): name for name, tree in before if isinstance(tree, Sum | Product)}

    def named(part: Node) -> Node:
        if isinstance(part, Sum | Product) and part.end < 0 and _shape(part) in own:
            return Name(part.at, own[_shape(part)])
        inside = parts(part)
        new = tuple(map(named, inside))
        return part if new == inside else with_parts(part, new)

    return named(node) if own else node


def _shape(node: Node) -> str:
    """What a tree is but for the order of terms and factors, and for its place."""
    inside = [_shape(part) for part in parts(node)]
    if isinstance(node, Sum | Product):
        inside.sort()
    if isinstance(node, Number):
        return str(node.value)
    own = f"{node.name}{node.order}" if isinstance(node, Name) else type(node).__name__
    function = node.function if isinstance(node, Call) else ""
    return f"{own}{function}({','.join(inside)})"


def _neighbour(new: Sum) -> Node:
    """The term that the last one of a sum belongs behind: of the same rates, with its names."""
    *terms, added = new.terms

    def alike(term: Node) -> tuple[bool, int]:
        one, other = ({name for name in names(node)} for node in (term, added))
        rates = [max((name.order for name in some), default=0) for some in (one, other)]
        return rates[0] == rates[1], len({n.name for n in one} & {n.name for n in other})

    return max(reversed(terms), key=alike)


def _divides(node: Node) -> bool:
    """Whether a node is what stands below a line or behind a slash, where no exponent was typed."""
    exponent = constant(node.exponent) if isinstance(node, Power) else None
    typed = isinstance(node, Power) and node.exponent.end >= 0
    return exponent is not None and exponent < 0 and exponent.denominator == 1 and not typed


def _left_out(text: str, span: Span) -> tuple[Span, str]:
    """Where a factor is left out, with the sign of multiplication; what has to stand there."""
    span = start, end = _with_brackets(text, span)
    if after := TIMES_AFTER.match(text, end):
        return (start, after.end()), ""
    if before := TIMES_BEFORE.search(text, 0, start):
        return (before.start(), end), ""
    alone = text[:start].rstrip()[-1:] in ("{", "/") and text[end:].lstrip()[:1] in ("}", "")
    return span, "1" if alone or text[:start].rstrip()[-1:] == "/" else ""


def _with_brackets(text: str, span: Span) -> Span:
    """The place of a part with all brackets that hold nothing else."""
    start, end = span
    while (opens := OPENS.search(text, 0, start)) and (closes := CLOSES.match(text, end)):
        start, end = opens.start(), closes.end()
    return start, end


def _edit(claim: Claim, change: Change, written: str, right: str, span: Span | None) -> Edit:
    return Edit(change.mistake, written, right, _within(claim, span))


def _adds(tree: SyntaxTree, change: Change) -> bool:
    """Whether a term is added to a sum, or to what stands alone as a term."""
    if change.mistake not in (Mistake.MISSING, Mistake.TERM) or change.wrap is None:
        return False
    return isinstance(tree.nodes[change.index], Sum) or tree.term(change.index)


def _signed(spelling: Spelling, node: Node) -> str:
    """A term with its sign in front."""
    text = spelling.tight(node, 1) if isinstance(node, Sum) else spelling(node)
    return f"- {text[1:].lstrip()}" if text.startswith("-") else f"+ {text}"


def _fitting(tree: SyntaxTree, change: Change, spelling: Spelling) -> str:
    """The new text, in brackets where it would fall apart at its place."""
    new = change.node
    if new is None:
        return ""
    above = tree.parent[change.index]
    if above < 0 or tree.side(change.index):
        return spelling(new)
    around = tree.nodes[above]
    level = 0
    if isinstance(around, Product):
        level = 2 if spelling.written.notation == "text" and isinstance(new, Product) else 1
    if isinstance(around, Power):
        level = 2 if _divides(around) and not spelling.latex else 3
        # A denominator has its own braces, unless a slash stands before it; an exponent, too.
        fraction = around.exponent.end < 0 and _in_braces(spelling, tree.nodes[change.index])
        if spelling.latex and (fraction or change.index != tree.kids[above][0]):
            level = 0
    if isinstance(around, Sum) and is_minus(new):
        level = 0 if change.index == tree.kids[above][0] else 1
    if isinstance(around, Call) and spelling.latex:
        level = 0 if _in_brackets(spelling, tree.nodes[change.index]) else 1
    return spelling.tight(new, level)


def _without_place(tree: SyntaxTree, change: Change, spelling: Spelling) -> tuple[str, str]:
    """What stood there and has to, where nobody can look; both without the sign that they share."""
    node, new = tree.nodes[change.index], change.node
    if new is not None and is_minus(node) and is_minus(new):
        change, node = replace(change, node=minus(new)), minus(node)
    if isinstance(node, Sum) and isinstance(change.node, Sum):
        return spelling(node), spelling(change.node)  # in the brackets that stand there
    return spelling(node), _fitting(tree, change, spelling)


def _in_brackets(spelling: Spelling, node: Node) -> bool:
    """Whether brackets stand around a node: cos(q_2), not cos q_2."""
    span, text = spelling.span(node), spelling.written.text
    return span is not None and _with_brackets(text, span) != span


def _in_braces(spelling: Spelling, node: Node) -> bool:
    return spelling.written.text[: max(node.at, 0)].rstrip()[-1:] == "{"


def _sign_before(claim: Claim, span: Span) -> Span | None:
    """Where the sign stands that belongs to what begins at a place."""
    match = SIGN.search(claim.written.text, 0, span[0])
    return None if match is None else (match.start(), match.start() + 1)


def _within(claim: Claim, span: Span | None) -> Span | None:
    """A span of the text as one of the source of the statement, which has single blanks."""
    if span is None or span[0] < claim.written.start:
        return None
    text, start = claim.written.text, claim.written.start

    def place(at: int) -> int:
        return len(re.sub(r"\s+", " ", text[start:at]))

    return place(span[0]), place(span[1])


def spliced(
    spelling: Spelling, source: str, edits: Sequence[Edit], entries: Trees, row: Published
) -> str:
    """The source with the edits put in; spelled anew where they have no place there."""
    here = [edit for edit in edits if not edit.definition]
    spans = sorted((edit.span, edit.right) for edit in here if edit.span is not None)
    apart = all(a[0][1] <= b[0][0] for a, b in pairwise(spans))
    if len(spans) < len(here) or not apart:
        sides = sides_of(map(spelling, entries), row)
        named = spelling.written.sides[: len(spelling.written.sides) - len(row.sides)]
        return " = ".join((*map(spelling, named), *sides))
    found, at, times = "", 0, r" \cdot " if spelling.latex else "*"
    for (start, end), right in spans:
        gap = " " if start == end and start and source[start - 1] != " " else ""
        found += source[at:start] + gap
        # omega^2 times 1 is no power of 21, and 2 l times 3 without l is 2 times 3, not 23.
        found += (times if right[:1].isdigit() and FACTOR.search(found) else "") + right
        if found.rstrip()[-1:].isdigit() and source[end:].lstrip()[:1].isdigit():
            found += times
        at = end
    return " ".join((found + source[at:]).split())


def sides_of(texts: Iterator[str], row: Published) -> Iterator[str]:
    """Texts of the entries, put together to the sides of the row; matrices row by row."""
    for side in row.sides:
        if isinstance(side, MatrixBase):
            lines = (", ".join(next(texts) for _ in range(side.cols)) for _ in range(side.rows))
            yield "[" + ", ".join(f"[{line}]" for line in lines) + "]"
        else:
            yield next(texts)
