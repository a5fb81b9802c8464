r"""One of the things that stand side by side in LaTeX, and the letters of names.

M \ddot{\theta}^{2} \sin \theta    ->    node M, node theta'' squared, function sin, node theta
"""

import re
from dataclasses import dataclass

from lark import Token, Tree

from mechanics.claims.names import GREEK, Naming
from mechanics.claims.place import Refused
from mechanics.claims.tree import Name, Node, Power, Rate

ACCENTED = re.compile(r"\\(dot|ddot)\s*\{\s*([A-Za-z0-9]*)\s*\}")
COMMAND = re.compile(r"\\([A-Za-z]+)")
DIFFERENCE = re.compile(r"(\d)\s*[-\u2212]\s*(\d)")
"""In a subscript: c_{1-2} is not c_{12}."""
STEP = re.compile(r"([A-Za-z])\s*([-+\u2212])\s*(\\?[A-Za-z0-9])")
"""In a subscript: x_{k-1} is neither x_{k+1} nor x_{k1}; x_{ck-1} no x_{ck}."""


MARK = re.compile(r"[^\w\s{}()',.:;/~\\]")
"""In a subscript: x_{2-} and x_{2^*} are not x_2."""
SUM = re.compile(r"(?<=\d)\s*\+\s*(?=\d)")
"""In a subscript: s_{1+2} is s_{12}."""


@dataclass(frozen=True)
class Item:
    r"""One of the things that stand side by side.

    Attributes
    ----------
    kind : str
        ``"node"``, ``"bracket"``, ``"function"``, ``"rate"`` (d/dt, or by a node), ``"sign"``,
        ``"times"``, ``"slash"``.
    at : int
    node : Node or None
    text : str
        Of a sign, or the name of a function; of a bracket the plus that it begins with.
    power : Node or None
        Of a function: the square of ``\sin^2``; of a bracket.
    arguments : tuple of Node
        What commas separate in a bracket.
    order : int
        Of ``d/dt``.
    end : int
        Where it ends, its brackets included; -1 where that does not matter.
    """

    kind: str
    at: int
    node: Node | None = None
    text: str = ""
    power: Node | None = None
    arguments: tuple[Node, ...] = ()
    order: int = 0
    end: int = -1


def glued(name: str, naming: Naming) -> bool:
    """Whether dx is no name of the scene, but x is."""
    known = naming.lookup(name)
    return name[:1] == "d" and name[1:2] != "_" and known is not None and known[1] > 0


def differential(above: list[Item], below: list[Item], naming: Naming) -> bool:
    """Whether a fraction is d v / d x or d^2 v / d x^2, in which d is no factor."""
    first = below[0].node if below else None
    if isinstance(first, Power):
        first = first.base
    if not (_d(above, naming) and isinstance(first, Name)):
        return False
    if len(below) == 1:
        return glued(first.name, naming)
    return first.name == "d" and below[1].kind in ("node", "bracket")


def _d(above: list[Item], naming: Naming) -> bool:
    """Whether a numerator begins with the d of a differential: that of a power, dx."""
    first = above[0].node if above else None
    if isinstance(first, Name) and first.name == "d":
        return True
    if naming.vocabulary.lookup("d") is not None:
        return False
    if isinstance(first, Power):
        return isinstance(first.base, Name) and first.base.name == "d"
    return isinstance(first, Name) and glued(first.name, naming)


RATIO = re.compile(r"(\d+)\s*/\s*(\d+)|\\[dt]?frac\s*\{?\s*(\d)\s*\}?\s*\{?\s*(\d)\s*\}?")
"""A number of a name: l_{1/2}."""


def bare(text: str) -> str:
    r"""A subscript or command as part of a name: ``_{C_{1}}`` gives ``C1``."""
    return re.sub(r"[^A-Za-z0-9]", "", _spelled(text).replace("'", "prime"))


def unread_mark(text: str) -> str:
    """What of a subscript is no part of a name, and would be lost; empty where nothing is."""
    lost = MARK.search(SUM.sub("", _spelled(text)))
    return lost[0] if lost else ""


def _spelled(text: str) -> str:
    # SymPy prints the symbol theta_ddot as \theta_{\dot{d}}.
    text = ACCENTED.sub(r"\2\1", text)
    text = DIFFERENCE.sub(r"\1minus\2", text)
    text = STEP.sub(lambda m: f"{m[1]}{'plus' if m[2] == '+' else 'minus'} {m[3]}", text)
    text = RATIO.sub(lambda m: f"{m[1] or m[3]}over{m[2] or m[4]}", text)
    return COMMAND.sub(lambda m: "" if m[1] in _FONTS else f" {letter_of(m[1])} ", text)


_FONTS = (
    "mathrm", "text", "textrm", "textit", "rm", "mathbf", "mathit", "mathsf", "operatorname",
)  # fmt: skip


DETERMINANT = "det"
"""A command that is no letter; what stands behind it is a matrix."""


def letter_of(command: str) -> str:
    """The name of a letter that a command prints: ``varphi`` gives ``phi``."""
    name = command.removeprefix("var")
    return {"ell": "l"}.get(command, name if name in GREEK else command)


def rate_of(node: Node, order: int, at: int) -> Node:
    """The time derivative of a node; a name gets dots."""
    if isinstance(node, Name):
        return Name(at, node.name, node.order + order, given=node.given, primes=node.primes)
    return Rate(at, node, order)


def pieces_of(tree: Tree) -> list[Tree | Token]:
    """What stands in an argument or bracket; a single command is one piece."""
    if tree.data == "argument":
        return [Tree("scripted", [_alone(tree)], tree.meta)]
    return list(tree.children)


def _alone(tree: Tree) -> Tree | Token:
    first = tree.children[0]
    if isinstance(first, Token) and first.type == "ACCENT":
        return Tree("accent", list(tree.children), tree.meta)
    if isinstance(first, Token) and first.type in ("WORD", "NUMBER") and len(first.value) > 1:
        # TeX takes one letter or digit, the eye often more.
        raise Refused(int(first.start_pos or 0), f"{first.value}: write braces around an argument")
    if isinstance(first, Token) and first.type in ("ACCENT1", "FRAC2"):
        data = "short_accent" if first.type == "ACCENT1" else "short_fraction"
        return Tree(data, list(tree.children), tree.meta)
    return first


def parted(tree: Tree) -> tuple[Tree, Token | None]:
    r"""A command with one character as its last argument, and the characters behind it.

    ``\frac{1}ml`` is 1/m l, as TeX prints it.
    """
    last = tree.children[-1] if tree.data in ("fraction", "half_fraction", "root") else None
    if not isinstance(last, Tree) or last.data != "argument":
        return tree, None
    word = last.children[0]
    if not isinstance(word, Token) or word.type not in ("WORD", "NUMBER") or len(word) == 1:
        return tree, None
    if word.type == "NUMBER" and not word.isdigit():
        return tree, None
    start, end = int(word.start_pos or 0), int(word.end_pos or 0)
    first = Token(word.type, word[0], start_pos=start, end_pos=start + 1)
    rest = Token(word.type, word[1:], start_pos=start + 1, end_pos=end)
    argument = Tree("argument", [first], last.meta)
    return Tree(tree.data, [*tree.children[:-1], argument], tree.meta), rest


def start_of(tree: Tree, outer: Tree) -> int:
    """Where a tree begins in the text; an empty one where the outer one does."""
    for candidate in (tree, outer):
        if not candidate.meta.empty:
            return int(candidate.meta.start_pos)
    return 0


def end_of(base: Tree | Token, scripts: list[Tree | Token]) -> int:
    """Where a base with its subscripts and primes ends, before its power."""
    ends = [base.end_pos if isinstance(base, Token) else base.meta.end_pos]
    ends += [script.end_pos for script in scripts if isinstance(script, Token)]
    return max(int(end or 0) for end in ends)
