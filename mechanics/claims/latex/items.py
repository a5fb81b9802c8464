r"""From the tree of the LaTeX grammar to items that stand side by side.

M \ddot{\theta}^{2} \sin \theta    ->    M, theta'' squared, function sine, theta
"""

import re
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from lark import Token, Tree

from mechanics.claims.columns import transposed
from mechanics.claims.latex.bars import OPENING
from mechanics.claims.latex.item import (
    Item,
    bare,
    differential,
    end_of,
    glued,
    parted,
    pieces_of,
    rate_of,
    start_of,
    unread_mark,
)
from mechanics.claims.latex.numbered import numbered
from mechanics.claims.latex.partials import partial
from mechanics.claims.latex.pieces import inside
from mechanics.claims.latex.words import Words, named, summed
from mechanics.claims.names import Naming
from mechanics.claims.partials import partial_of
from mechanics.claims.place import Refused
from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Rate,
    Table,
    Total,
    constant,
    ended,
    inverse,
    product,
)

Fold = Callable[[list[Item], int], Node]

BARS = ("|", "vert", OPENING)
DEEPEST_BRACKETS = 40
MOST_ENTRIES = 50
"""Of a bracket with commas."""
SPANNED = (
    "accent", "short_accent", "fraction", "half_fraction", "short_fraction", "root", "matrix",
)  # fmt: skip
"""What a node is made of as a whole; of a bracket the node is what stands inside."""
SIGNS = ("+", "-", "\u2212", "*")
ORDERS = {"dot": 1, "ddot": 2, "dddot": 3}
ORDER = re.compile(r"\^\s*\{\s*\(\s*([1-3])\s*\)\s*\}")
PER_TIME = re.compile(
    r"(?:d|\\(?:mathrm|text|rm)\s*(?:\{\s*d\s*\}|\s+d)|\{\s*\\rm\s+d\s*\})\s*t\s*(?:\^\s*\{?\s*([1-3])\s*\}?)?\s*"
)


class Items:
    """Reads trees of the grammar; `fold` puts items together.

    `by_time` is whether primes are dots: a whole text that has dots may mean something else.
    """

    def __init__(
        self, text: str, naming: Naming, fold: Fold, notes: list[str], by_time: bool
    ) -> None:
        self.text, self.naming, self.fold, self.notes = text, naming, fold, notes
        self.by_time = by_time
        self.depth = 0
        self.known: dict[int, tuple[Tree, list[Item]]] = {}
        self.taken: dict[int, tuple[Tree, list[Tree | Token]]] = {}

    def of(self, pieces: list[Tree | Token]) -> list[Item]:
        """The items of pieces that stand side by side."""
        found: list[Item] = []
        for piece in numbered(pieces, self.naming):
            if isinstance(piece, Token):
                kind = {"SIGN": "sign", "TIMES": "times", "SLASH": "slash"}.get(piece.type)
                if piece.type == "TAG":
                    continue
                if kind is None:
                    raise Refused(piece.start_pos, f"{piece.value!r} is out of place")
                text = "-" if piece.value == "\u2212" else str(piece.value)
                found.append(Item(kind, piece.start_pos, text=text))
            elif inside(piece, "braces") != []:  # {} only holds a place
                found += self._scripted(piece)
        return summed(self._with_primes(found))

    def _pieces(self, tree: Tree) -> list[Tree | Token]:
        """What stands in an argument or bracket, taken apart once, so that it is read once."""
        if id(tree) not in self.taken:
            self.taken[id(tree)] = tree, pieces_of(tree)
        return self.taken[id(tree)][1]

    def _with_primes(self, found: list[Item]) -> list[Item]:
        """The items; primes that are dots are by time, but for ``V'(x)``."""
        if not self.by_time:
            return found
        for k, item in enumerate(found):
            before_bracket = k + 1 < len(found) and found[k + 1].kind == "bracket"
            if isinstance(item.node, Name) and item.node.primes and not before_bracket:
                plain = ended(replace(item.node, primes=0), item.node.end)
                found[k] = replace(item, node=plain)
        return found

    def group(self, tree: Tree, at: int) -> Node:
        """What stands in a bracket or argument, as one node."""
        (node,) = self._separated(tree, at, 1)
        return node

    def _separated(self, tree: Tree, at: int, most: int = MOST_ENTRIES) -> list[Node]:
        """What stands between the commas of a bracket."""
        self.depth += 1
        if self.depth > DEEPEST_BRACKETS:
            raise Refused(at, f"brackets nested too deeply: {DEEPEST_BRACKETS} are the limit")
        parts: list[list[Tree | Token]] = [[]]
        for piece in self._pieces(tree):
            if isinstance(piece, Token) and piece.type == "COMMA" and len(parts) < most:
                parts.append([])
            else:
                parts[-1].append(piece)
        nodes = [self._over(part, at) for part in parts]
        self.depth -= 1
        return nodes

    def _over(self, part: list[Tree | Token], at: int) -> Node:
        r"""A part of a bracket, which may be a fraction: ``{a \over b}``."""
        bars = [i for i, p in enumerate(part) if isinstance(p, Token) and p.type == "OVER"]
        if not bars:
            return self.fold(self.of(part), at)
        above, below = part[: bars[0]], part[bars[0] + 1 :]
        parts = [self.fold(self.of(above), at), inverse(self.fold(self.of(below), at))]
        return product(at, parts)

    def _scripted(self, tree: Tree) -> list[Item]:
        """The items of a tree, read once: a fraction looks at its parts before it is put together.

        Without that, fractions within fractions would be read twice as often at every level.
        """
        if id(tree) not in self.known:
            self.known[id(tree)] = tree, self._read(tree)  # the tree is kept, so that its id is
        return self.known[id(tree)][1]

    def _read(self, tree: Tree) -> list[Item]:
        base, *scripts = tree.children
        at = base.start_pos if isinstance(base, Token) else start_of(base, tree)
        sub, primes, power = self._scripts(scripts)
        *before, last = self._base(base, sub, at) or [Item("bracket", at)]
        if last.node is not None and (isinstance(base, Token) or base.data in SPANNED):
            ended(last.node, end_of(base, scripts))
        if primes:
            if not (isinstance(last.node, Name) or (last.kind == "bracket" and last.node)):
                raise Refused(at, "a prime belongs behind a name or bracket")
            rate = rate_of(last.node, primes, at)
            if isinstance(rate, Name):
                rate = Name(at, rate.name, rate.order, given=rate.given, primes=primes)
            last = Item("node", at, ended(rate, end_of(base, scripts)))
        end = int(tree.meta.end_pos)
        if power is not None:
            last = self._raised(last, power)
            if last.node is not None:
                ended(last.node, end)
        return [*before, replace(last, end=end)]

    def _scripts(self, scripts: list[Tree | Token]) -> tuple[str, int, Node | None]:
        sub, primes = "", 0
        power: Node | None = None
        for script in scripts:
            if isinstance(script, Token) and script.type == "PRIME":
                primes += len(script.value)
            elif isinstance(script, Token):
                part = bare(script.value[1:])
                if mark := unread_mark(script.value[1:]):
                    what = "a sign" if mark in SIGNS else mark
                    words = f"{what} as a subscript is not supported: write a letter"
                    raise Refused(int(script.start_pos or 0), words)
                sub += part
            else:
                (inside,) = script.children
                where = inside.start_pos if isinstance(inside, Token) else start_of(inside, script)
                if isinstance(inside, Token) and inside.type == "SUPC":
                    if "circ" in inside.value:
                        raise Refused(where, "degrees are not supported: write radians")
                    turned = re.search("top|intercal", inside.value)
                    power = Name(where, turned[0]) if turned else power
                    primes += inside.value.count("prime") + inside.value.count("'")
                elif order := ORDER.fullmatch(self._slice(script)):
                    primes += int(order[1])
                elif power is not None:
                    raise Refused(where, "two exponents")
                elif isinstance(inside, Token):
                    at = int(inside.end_pos or 1) - 1
                    power = ended(_single(inside.value[-1], at), at + 1)
                else:
                    power = self.group(inside, where)
        return sub, primes, power

    def _raised(self, item: Item, power: Node) -> Item:
        if item.kind == "function":
            return Item("function", item.at, text=item.text, power=power)
        if item.node is None:
            raise Refused(item.at, "this cannot have an exponent")
        if turned := transposed(self.naming, item.node, item.arguments, power):
            return Item("node", item.at, turned)
        if len(item.arguments) > 1:
            raise Refused(item.at, "a comma is out of place")
        euler = isinstance(item.node, Name) and item.node.name == "e"
        if euler and not self.naming.knows("e"):
            return Item("node", item.at, Call(item.at, "exp", (power,)))
        raised = Power(item.at, item.node, power)
        if item.kind == "bracket":
            return Item("bracket", item.at, raised, power=power, arguments=(item.node,))
        return Item("node", item.at, raised)

    def _base(self, base: Tree | Token, sub: str, at: int) -> list[Item]:
        if isinstance(base, Token):
            return Words(self.naming, self.notes).of(base, sub, at)
        base, rest = parted(base)
        if rest is not None:
            words = Words(self.naming, self.notes).of(rest, sub, int(rest.start_pos or 0))
            return [*self._base(base, "", at), *words]
        match base.data:
            case "accent" | "short_accent":
                return [self._accent(base, sub, at)]
            case "style":
                inside = self.of(self._pieces(base.children[1]))
                script = "cal" in str(base.children[0]) or "scr" in str(base.children[0])
                node = inside[0].node if len(inside) == 1 else None
                length = self.naming.is_function("L") is False
                if script and length and isinstance(node, Name) and node.name == "L" and not sub:
                    return [named("Lagrangian", "", at)]
                if sub and len(inside) == 1 and isinstance(inside[0].node, Name):
                    return [named(inside[0].node.name, sub, at)]
                items = inside
            case "fraction" | "half_fraction" | "short_fraction":
                items = [self._fraction(base, at)]
            case "root":
                items = [Item("node", at, self._root(base, at))]
            case "matrix":
                items = [Item("node", at, self._matrix(base, at))]
            case _:
                items = [self._bracket(base, at)]
                node = items[0].node
                if sub and base.data == "braces" and isinstance(node, Name):
                    name = replace(node, at=at, name=f"{node.name}_{sub}")
                    return [Item("node", at, name)]
        if sub:
            raise Refused(at, f"the subscript {sub} belongs behind a name")
        return items

    def _bracket(self, base: Tree, at: int) -> Item:
        inner = next(c for c in base.children if isinstance(c, Tree))
        left = base.children[0]
        if isinstance(left, Token) and left.type == "LEFT" and left.value.endswith(BARS):
            return Item("node", at, Call(at, "abs", (self.group(inner, at),)))
        pieces = self._pieces(inner)
        nodes = self._separated(inner, at)
        node = nodes[0]
        kind = "bracket" if base.data == "leftright" else "node"
        if isinstance(node, Table) and len(pieces) == 1:
            kind = "node"
        first = pieces[0] if pieces else None
        added = isinstance(first, Token) and first.type == "SIGN" and first.value == "+"
        return Item(kind, at, node, text="+" if added else "", arguments=tuple(nodes))

    def _accent(self, base: Tree, sub: str, at: int) -> Item:
        mark = base.children[0]
        order = ORDERS[re.match(r"\\(d+ot)", mark.value)[1]]  # type: ignore[index]
        if base.data == "short_accent":
            node: Node = Name(at, mark.value[-1])
        else:
            node = self.group(base.children[1], at)
        if not isinstance(node, Name):
            if sub:
                raise Refused(at, f"the subscript {sub} belongs behind a name")
            return Item("node", at, Rate(at, node, order))
        name = f"{node.name}_{sub}" if sub else node.name
        return Item("node", at, Name(at, name, node.order + order, given=node.given))

    def _fraction(self, base: Tree, at: int) -> Item:
        if base.data == "short_fraction":
            over, under = re.findall(r"[A-Za-z0-9]", base.children[0].value)[-2:]
            ratio = [_single(over, at), inverse(_single(under, at))]
            return Item("node", at, product(at, ratio))
        if base.data == "half_fraction":
            token, below = base.children
            half: list[Node] = [Number(at, Fraction(token.value[-1]))]
            return Item("node", at, product(at, [*half, inverse(self.group(below, at))]))
        _, above, below = base.children
        per_time = PER_TIME.fullmatch(self._slice(below))
        if per_time and not self.naming.knows("t"):
            rate = self._rate(above, int(per_time[1] or 1), at)
            if rate is not None:
                return rate
        if (pieces := partial(above, below)) is not None:
            return self._partial(*pieces, at)
        if differential(self.of(self._pieces(above)), self.of(self._pieces(below)), self.naming):
            return self._by_a_name(self.of(self._pieces(above)), self.of(self._pieces(below)), at)
        parts = [self.group(above, at), inverse(self.group(below, at))]
        return Item("node", at, product(at, parts))

    def _partial(self, of: list[Tree | Token], by: list[Tree | Token], at: int) -> Item:
        name = self.fold(self.of(by), at)
        if not of:
            return Item("rate", at, name)
        return Item("node", at, partial_of(self.naming, self.fold(self.of(of), at), name, at))

    def _by_a_name(self, above: list[Item], below: list[Item], at: int) -> Item:
        """dV/dx of one name by another; nothing else is told from a fraction."""
        once = isinstance(above[0].node, Name) and above[0].node.name == "d"
        of = self.fold(above[1:], at) if len(above) == 2 and once else None
        by = below[-1].node
        if len(below) == 1 and isinstance(by, Name):
            by = ended(Name(by.at + 1, by.name[1:], by.order), by.end)
        plain = isinstance(of, Name) and self.naming.lookup(of.name) is None and len(below) < 3
        if of is None or not isinstance(by, Name) or not plain:
            raise Refused(at, "a derivative by something other than time is not supported")
        found = partial_of(self.naming, of, by, at)
        return Item("node", at, Total(at, found.function, found.arguments))

    def _rate(self, above: Tree, order: int, at: int) -> Item | None:
        """d/dt, d^2/dt^2, or dx/dt; None for a fraction whose numerator has no d."""
        items = self.of(self._pieces(above))
        if not items:
            return None
        first, *rest = items
        d, power = first.node, 1
        if isinstance(d, Power):
            power = int(constant(d.exponent) or 0)
            d = d.base
        if isinstance(d, Name) and glued(d.name, self.naming):
            rest.insert(0, Item("node", d.at + 1, ended(Name(d.at + 1, d.name[1:]), d.end)))
        elif not (isinstance(d, Name) and d.name == "d" and d.order == 0):
            return None
        if power != order:
            raise Refused(at, f"d^{power} over dt^{order}")
        if not rest:
            return Item("rate", at, order=order)
        return Item("node", at, rate_of(self.fold(rest, at), order, at))

    def _root(self, base: Tree, at: int) -> Node:
        *degree, radicand = base.children[1:]
        index = self.group(degree[0], at) if degree else Number(at, Fraction(2))
        return Power(at, self.group(radicand, at), inverse(index))

    def _matrix(self, base: Tree, at: int) -> Node:
        begin, table, *_ = base.children
        if "vmatrix" in str(begin).lower():
            raise Refused(at, "a determinant is not read: write it out")
        rows = [r.children for r in table.children if isinstance(r, Tree)]
        kept = [[c for c in row if isinstance(c, Tree)] for row in rows]
        kept = [row for row in kept if any(cell.children for cell in row)]
        return Table(at, tuple(tuple(self.group(cell, at) for cell in row) for row in kept))

    def _slice(self, tree: Tree) -> str:
        """The text of a tree; empty for an empty one."""
        return "" if tree.meta.empty else self.text[tree.meta.start_pos : tree.meta.end_pos]


def _single(character: str, at: int) -> Node:
    """A number of one digit, or a name of one letter."""
    return Number(at, Fraction(character)) if character.isdigit() else Name(at, character)
