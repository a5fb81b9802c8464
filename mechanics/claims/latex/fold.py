r"""Items side by side, put together: signs, implied products, functions and their arguments.

sum:      term +- term ...
term:     factor factor ... / factor          the slash takes the next factor only
function: \sin^2 2 \theta \cos \theta         what stands side by side and has no dimension
"""

from fractions import Fraction

from mechanics.claims.arguments import at_one_time, told
from mechanics.claims.columns import (
    DIAGONAL,
    crossed,
    dependent,
    derived_by,
    diagonal,
    stacked,
)
from mechanics.claims.dimension import OF_ANY, arguments, first_with_name
from mechanics.claims.functions import FUNCTIONS, INVERSES
from mechanics.claims.latex.item import DETERMINANT, Item, rate_of
from mechanics.claims.latex.vectors import BY_ARGUMENT, CROSS, DEPENDS, is_time, vectors
from mechanics.claims.names import Naming
from mechanics.claims.partials import partial_of
from mechanics.claims.place import Refused
from mechanics.claims.tree import (
    DEEPEST,
    Call,
    Name,
    Node,
    Number,
    Power,
    constant,
    ended,
    inverse,
    names,
    negative,
    product,
    total,
)

SLASH = "a / b c is read as (a / b) c"
OPTIONAL = "what stands in [+ ...] is read as a term that is there"
ONE, GLUED, ALL = "one", "glued", "all"
"""How many factors stand below a slash: one, those without a space between, or all."""
FIRST = "first"
"""The shortest argument of a function without brackets, where several are possible."""


class Fold:
    """Puts items together; how it read what can be read in two ways is noted."""

    def __init__(
        self, naming: Naming, notes: list[str], below: str = ONE, argument: str = ""
    ) -> None:
        self.naming, self.notes, self.below, self.argument = naming, notes, below, argument
        self.slash: tuple[int, int] | None = None
        self.several = False
        self.depth = 0

    def __call__(self, items: list[Item], at: int) -> Node:
        """One node for all items.

        Raises
        ------
        Refused
            When there is nothing, or something is missing.
        """
        if not items:
            raise Refused(at, "an expression is missing here")
        terms: list[Node] = []
        i = 0
        while i < len(items):
            minus, start = False, items[i].at
            while i < len(items) and items[i].kind == "sign":
                minus ^= items[i].text == "-"
                i += 1
            end = i
            while end < len(items) and not self._ends(items, i, end):
                end += 1
            term = self._term(items[i:end], start)
            terms.append(negative(term) if minus else term)
            i = end
        return total(items[0].at, terms)

    def _ends(self, items: list[Item], begin: int, i: int) -> bool:
        """Whether a term ends before item i: at a sign that does not follow an operator, or at a
        last ``[+ F]``, which is a term that may be left out.
        """
        after = i > begin and items[i - 1].kind in ("times", "slash")
        if items[i].kind == "sign" or i == begin or after:
            return items[i].kind == "sign" and not after
        last = i + 1 == len(items) or items[i + 1].kind == "sign"
        optional = last and items[i].kind == "bracket" and items[i].text == "+"
        if optional and OPTIONAL not in self.notes:
            self.notes.append(OPTIONAL)
        return optional

    def _term(self, items: list[Item], at: int) -> Node:
        if not items:
            raise Refused(at, "a term is missing here")
        factors: list[Node] = []
        queue = list(items)
        divide = operator = False
        while queue:
            item = queue.pop(0)
            if item.text == CROSS and not operator and vectors(self.naming, factors, queue):
                chain = any(one.text == CROSS for one in queue)
                left, right = product(items[0].at, factors), self._term(queue, at)
                factors, queue = [crossed(items[0].at, left, right, chain)], []
                continue
            if item.kind in ("times", "slash"):
                if operator or not factors:
                    raise Refused(item.at, "a factor is missing here")
                operator, divide = True, item.kind == "slash"
                continue
            factor = self._factor(item, queue, factors, operator)
            if divide:
                if queue and queue[0].kind not in ("times", "slash", "sign"):
                    self.notes.append(SLASH)
                factor = inverse(self._below(factor, item, queue))
            factors.append(factor)
            operator = divide = False
        if operator:
            raise Refused(items[-1].at, "a factor is missing behind this")
        node = product(items[0].at, factors)
        return node if len(factors) == 1 else ended(node, max(node.end, items[-1].end))

    def _below(self, factor: Node, item: Item, queue: list[Item]) -> Node:
        """What a slash divides by: one factor, or as many as another reading says."""
        found, end = [factor], max(item.end, factor.end)
        while queue and queue[0].kind not in ("times", "slash", "sign"):
            if self.below == ONE or (self.below == GLUED and queue[0].at > end):
                break
            head = queue.pop(0)
            found.append(self._factor(head, queue, found, False))
            end = max(head.end, found[-1].end)
        if len(found) > 1 and self.slash is None:
            self.slash = (item.at, end)
        return product(item.at, found)

    def _factor(self, item: Item, queue: list[Item], before: list[Node], operator: bool) -> Node:
        """The factor that begins with an item; what belongs to it leaves the queue."""
        self.depth += 1
        if self.depth > DEEPEST:
            raise Refused(item.at, f"nested too deeply: {DEEPEST} levels are the limit")
        factor = self._one(item, queue, before, operator)
        self.depth -= 1
        return factor

    def _one(self, item: Item, queue: list[Item], before: list[Node], operator: bool) -> Node:
        if item.kind == "sign":
            if not queue:
                raise Refused(item.at, "a factor is missing behind this sign")
            factor = self._factor(queue.pop(0), queue, before, True)
            return negative(factor) if item.text == "-" else factor
        if item.kind == "function":
            return self._function(item, queue)
        if item.kind == "rate":
            if not queue:
                raise Refused(item.at, "the operand of the derivative is missing")
            self._all_of(item, queue)
            rest, queue[:] = list(queue), []
            of = self._term(rest, item.at)
            if item.node is not None:
                return partial_of(self.naming, of, item.node, item.at)
            return rate_of(of, item.order, item.at)
        node = item.node
        if node is None:
            raise Refused(item.at, "an operand is missing here")
        if item.kind == "bracket" and len(item.arguments) > 1:
            if before or queue:
                raise Refused(item.at, "a comma is out of place")
            self.notes.append("(a, b) is read as a column")
            return stacked(item.at, item.arguments)
        if item.kind == "bracket" and item.text == "+" and before and not operator:
            words = "[+ ...] between factors is a term that may be left out, or a factor"
            raise Refused(item.at, f"{words}: write it without the bracket, or with \\cdot")
        if isinstance(node, Number) and before and not operator and isinstance(before[-1], Number):
            raise Refused(item.at, "two numbers side by side: write \\cdot between them")
        if isinstance(node, Name) and node.name == DETERMINANT and queue:
            return self._determinant(node, queue)
        if isinstance(node, Name) and queue and is_time(queue[0]):
            return self._of_time(node, queue)
        if isinstance(node, Name) and queue and queue[0].kind == "bracket" and queue[0].node:
            return self._dependent(node, queue)
        return node

    def _all_of(self, item: Item, queue: list[Item]) -> None:
        """Refuse ``d/dt (a) b`` where both may move: it is the rate of the bracket, or of all.

        Raises
        ------
        Refused
            Where these are different.
        """

        def moves(some: list[Item]) -> bool:
            nodes = [n for one in some for n in (one.node, *one.arguments) if n is not None]
            every = [name for node in nodes for name in names(node)]
            return any(self.naming.is_function(name.name) is not False for name in every)

        if queue[0].kind == "bracket" and moves(queue[:1]) and moves(queue[1:]):
            words = "a derivative of the bracket, or of all that follows: add brackets"
            raise Refused(item.at, words)

    def _of_time(self, node: Name, queue: list[Item]) -> Node:
        """A name before ``(t)``: a function of time, or a product if the scene says so."""
        if self.naming.knows("t"):
            return node
        if self.naming.is_function(node.name) is False:
            self.notes.append(f"{node.name}(t) is read as a product: {node.name} is a constant")
            return node
        bracket = queue.pop(0)
        self.notes.append(f"{node.name}(t) is read as a function of time, not as a product")
        named = Name(node.at, node.name, node.order, True)
        if bracket.power is not None:
            return ended(Power(node.at, named, bracket.power), bracket.end)
        return ended(named, bracket.end)

    def _determinant(self, node: Name, queue: list[Item]) -> Node:
        r"""``\det(M)`` and ``\det M``, which the text may define: a name of its own."""
        of = queue[0].node
        if not isinstance(of, Name) or self.naming.knows(DETERMINANT):
            return node
        head = queue.pop(0)
        named = ended(Name(node.at, f"{DETERMINANT}({of.name})"), head.end)
        return named if head.power is None else ended(Power(node.at, named, head.power), head.end)

    def _dependent(self, node: Name, queue: list[Item]) -> Node:
        r"""A name before ``(q, \dot q)``: it depends on these, or is a factor."""
        bracket = queue[0]
        if node.name == DIAGONAL and len(bracket.arguments) > 1 and bracket.power is None:
            del queue[0]
            return ended(diagonal(node.at, bracket.arguments), bracket.end)
        if (by := derived_by(self.naming, node, bracket.arguments)) is not None:
            del queue[0]
            return self._derivative(node, by, bracket)
        named = dependent(self.naming, node, bracket.arguments)
        if named is None and node.name in self.naming.applied:
            named = node
        if named is None:
            at_one_time(self.naming, node, bracket.arguments[0])
            return node
        del queue[0]
        self.notes.append(DEPENDS.format(name=node.name))
        given = told(self.naming, node.name, bracket.arguments)
        primes = named.primes
        name = Name(named.at, named.name, named.order, given=given, primes=primes)
        whole = ended(name, bracket.end)
        if bracket.power is None:
            return whole
        return ended(Power(node.at, whole, bracket.power), bracket.end)

    def _derivative(self, node: Name, by: Name, bracket: Item) -> Node:
        """``V'(x)``, which is dV/dx."""
        found: Node = Name(node.at, node.name, node.order - node.primes, given=node.given)
        for _ in range(node.primes):
            found = partial_of(self.naming, found, by, node.at)
        self.notes.append(BY_ARGUMENT.format(name=node.name, by=by.name))
        found = ended(found, bracket.end)
        return found if bracket.power is None else Power(node.at, found, bracket.power)

    def _function(self, item: Item, queue: list[Item]) -> Node:
        """A function, its power and its argument."""
        name, power = item.text, item.power
        if not queue:
            raise Refused(item.at, f"the argument of {name} is missing")
        arguments: tuple[Node, ...]
        end = -1
        if queue[0].kind == "bracket":
            bracket = queue.pop(0)
            end = bracket.end
            arguments = bracket.arguments
            if bracket.power is not None:
                self.notes.append(f"{name}(...)^n is read as the power of {name}(...)")
                if power is not None:
                    raise Refused(item.at, f"two exponents of {name}")
                power = bracket.power
        else:
            arguments = (self._argument(item, queue),)
        if power is not None and constant(power) == -1:
            if name not in INVERSES:
                raise Refused(item.at, f"{name}^{{-1}} can be read in two ways")
            self.notes.append(f"{name}^(-1) is read as the inverse function")
            name, power = INVERSES[name], None
        least, most, _ = FUNCTIONS[name]
        if not least <= len(arguments) <= most:
            raise Refused(item.at, f"{name} with {len(arguments)} arguments")
        called = Call(item.at, name, arguments)
        end = max(end, called.end)
        if power is None:
            return ended(called, end)
        return ended(Power(item.at, ended(called, -1), power), end)

    def _argument(self, item: Item, queue: list[Item]) -> Node:
        r"""What stands side by side and is a number: ``\sin 2 \theta x`` is sin(2 theta) x."""
        minus = False
        if queue[0].kind == "sign":
            minus = queue.pop(0).text == "-"
        factors, left, apart = self._side_by_side(item, queue)
        if not factors:
            raise Refused(item.at, f"the argument of {item.text} is missing")
        ways = [] if item.text in OF_ANY else arguments(self.naming, factors, apart)
        ways = ways or [first_with_name(factors)]
        count = min(ways) if self.argument == FIRST else ways[0]
        self.several = self.several or len(ways) > 1
        queue[:] = left[count - 1]
        taken = factors[:count]
        if sum(constant(one) is None for one in taken) > 1:
            words = " ".join(map(_word, taken))
            self.notes.append(f"\\{item.text} {words} is read as {item.text}({words})")
        if minus:
            taken.insert(0, Number(taken[0].at, Fraction(-1)))
        return product(taken[0].at, taken)

    def _side_by_side(
        self, item: Item, queue: list[Item]
    ) -> tuple[list[Node], list[list[Item]], set[int]]:
        """Factors to the next function or operator, what follows each, and which stand apart."""
        rest, factors = list(queue), list[Node]()
        left: list[list[Item]] = []
        apart: set[int] = set()
        while rest:
            head = rest[0]
            if head.kind == "function" and not any(constant(f) is None for f in factors):
                raise Refused(head.at, f"the argument of {item.text}: write brackets around it")
            comma = head.kind == "bracket" and len(head.arguments) > 1
            if head.kind in ("function", "sign", "rate") or (comma and factors):
                break
            if head.kind == "slash":
                # cos 2 pi t / T, with t in s: no number without what stands below
                if item.text in OF_ANY or not factors or arguments(self.naming, factors, apart):
                    break
                below = rest[1:]
                if not below or below[0].kind in ("sign", "times", "slash"):
                    break
                rest[:] = below[1:]
                factors.append(inverse(self._factor(below[0], rest, factors, True)))
                left.append(list(rest))
                continue
            rest.pop(0)
            if head.kind == "times" and not factors:
                raise Refused(head.at, f"the argument of {item.text} is missing")
            if head.kind in ("times", "bracket"):
                apart.add(len(factors))
            if head.kind != "times":
                factors.append(self._factor(head, rest, factors, True))
                left.append(list(rest))
        return factors, left, apart


def _word(node: Node) -> str:
    """A factor in a note."""
    if isinstance(node, Name):
        return node.name + "'" * node.order
    return str(node.value) if isinstance(node, Number) else "..."
