r"""LaTeX as people write it, in the many ways in which they do.

M \frac{L}{2} \ddot{\theta} \cos\theta        \tfrac12 M L\,\ddot\theta\cos(\theta)

How brackets, fractions, dots, subscripts and powers of functions are written is drawn for each
statement, and kept in it, as one person would.
"""

import re
from dataclasses import dataclass
from random import Random

from sympy import Symbol

from benchmarks.detection.forms.spelling import Labels, is_negative, quotient
from benchmarks.detection.rows import Row
from benchmarks.detection.tree import Tree
from mechanics.claims.names import GREEK
from mechanics.scene import Scene

ACCENTS = ("", "dot", "ddot", "dddot")
PARTS = re.compile(r"([A-Za-z]+?)_?(\d*)")


@dataclass(frozen=True)
class Style:
    """How one person writes."""

    braces: bool
    """Of dots, subscripts and exponents with one letter."""
    brackets: tuple[str, str]
    argument: bool
    """Brackets around the argument of a function even where it is one letter."""
    outside: bool
    """(sin x)^2 for sin^2 x."""
    product: str
    front: bool
    """A number in front of the fraction: 1/2 M L for M L / 2."""
    fraction: str
    of_time: bool
    frame: tuple[str, str]
    equals: str


def style(source: Random) -> Style:
    """Draw a style."""
    environment = source.choice((
        ("", ""), ("", ""), (r"\[ ", r" \]"), ("$$", "$$"),
        ("\\begin{equation}\n", "\n\\end{equation}"),
        ("\\begin{align}\n", " \\tag{6}\n\\end{align}"),
    ))  # fmt: skip
    aligned = "align" in environment[0]
    return Style(
        braces=source.random() < 0.7,
        brackets=source.choice(((r"\left(", r"\right)"), ("(", ")"), (r"\left[", r"\right]"))),
        argument=source.random() < 0.4,
        outside=source.random() < 0.15,
        product=source.choice((" ", " ", r" \, ", r" \cdot ")),
        front=source.random() < 0.4,
        fraction=source.choice((r"\frac", r"\frac", r"\dfrac")),
        of_time=source.random() < 0.2,
        frame=environment,
        equals=" &= " if aligned else " = ",
    )


class Latex:
    """Writes trees of one scene in one style."""

    def __init__(self, scene: Scene, labels: Labels, style: Style) -> None:
        self.style, self.labels = style, labels
        self.inputs = set(scene.input_symbols)

    def __call__(self, tree: Tree) -> str:
        """A whole side."""
        if tree.kind != "sum":
            return self.term(tree, first=True)
        return " ".join(self.term(term, first=i == 0) for i, term in enumerate(tree.parts))

    def term(self, tree: Tree, first: bool) -> str:
        """A term with its sign."""
        sign = "-" if is_negative(tree) else "" if first else "+"
        return f"{sign} {self.unsigned(tree)}".strip()

    def unsigned(self, tree: Tree) -> str:
        """A product without its sign."""
        parts = quotient(tree)
        if not parts.below:
            return self.factors(parts.above)
        above, below = list(parts.above), list(parts.below)
        if self.style.front and len(above) > (above[0].kind == "number"):
            front = [[f for f in side if f.kind == "number"] for side in (above, below)]
            rest = [[f for f in side if f.kind != "number"] for side in (above, below)]
            if front[1] or front[0]:
                words = [self.over(*front)] if front[1] else [self.factors(front[0])]
                words.append(self.over(*rest) if rest[1] else self.factors(rest[0]))
                return self.style.product.join(words)
        return self.over(above, below)

    def over(self, above: list[Tree], below: list[Tree]) -> str:
        """A fraction; what stands alone in it needs no brackets."""
        lines = [self(side[0]) if len(side) == 1 else self.factors(side) for side in (above, below)]
        return f"{self.style.fraction}{{{lines[0] or '1'}}}{{{lines[1]}}}"

    def factors(self, factors: list[Tree] | tuple[Tree, ...]) -> str:
        """Factors side by side; two numbers never are."""
        if not factors:
            return "1"
        return self.style.product.join(self.factor(factor) for factor in factors)

    def factor(self, tree: Tree) -> str:
        """One factor, in brackets where it is a sum or has a sign."""
        match tree.kind:
            case "number" if tree.value.denominator == 1 and tree.value >= 0:
                return str(tree.value)
            case "symbol":
                return self.name(tree.value)
            case "pi":
                return r"\pi"
            case "power":
                return self.power(*tree.parts)
            case "sin" | "cos" | "tan":
                return self.function(tree, "")
            case "sign":
                return rf"\operatorname{{sgn}} \left( {self(tree.parts[0])} \right)"
            case "Abs":
                return rf"\left| {self(tree.parts[0])} \right|"
        return self.bracket(tree)

    def bracket(self, tree: Tree) -> str:
        left, right = self.style.brackets
        return f"{left} {self(tree)} {right}"

    def power(self, base: Tree, exponent: Tree) -> str:
        value = exponent.value
        if value.numerator == 1 and value.denominator == 2:
            return rf"\sqrt{{{self(base)}}}"
        if value < 0:
            return self.unsigned(Tree("power", None, (base, exponent)))
        words = str(value) if value.denominator == 1 else f"{value.numerator}/{value.denominator}"
        raised = f"^{{{words}}}" if self.style.braces or len(words) > 1 else f"^{words}"
        if base.kind in ("sin", "cos", "tan") and not self.style.outside:
            return self.function(base, raised)
        inner = self.factor(base)
        plain = base.kind in ("symbol", "number") and "(t)" not in inner
        return f"{inner if plain else self.bracket(base)}{raised}"

    def function(self, tree: Tree, raised: str) -> str:
        (inside,) = tree.parts
        if inside.kind == "symbol" and not self.style.argument:
            return rf"\{tree.kind}{raised} {self.name(inside.value)}"
        if inside.kind in ("symbol", "product", "number", "sum", "pi"):
            left, right = (r"\left(", r"\right)") if "left" in self.style.brackets[0] else "()"
            return rf"\{tree.kind}{raised} {left} {self(inside)} {right}"
        return rf"\{tree.kind}{raised} \left( {self(inside)} \right)"

    def name(self, symbol: Symbol) -> str:
        """A symbol: letter, index below, dots above."""
        base, order = self.labels.get(symbol, (symbol.name, 0))
        letter, below = self._split(base)
        if order:
            braces = self.style.braces or (len(letter) > 1 and not letter.startswith("\\"))
            gap = "" if letter.startswith("\\") else " "
            letter = (
                rf"\{ACCENTS[order]}{{{letter}}}" if braces else rf"\{ACCENTS[order]}{gap}{letter}"
            )
        if below:
            letter += f"_{{{below}}}" if self.style.braces or len(below) > 1 else f"_{below}"
        timed = self.style.of_time and symbol in self.inputs
        return f"{letter}(t)" if timed else letter

    def _split(self, base: str) -> tuple[str, str]:
        head, _, tail = base.partition("_")
        match = PARTS.fullmatch(head)
        if match and not tail:
            head, tail = match[1], match[2]
        if head in GREEK:
            return f"\\{head}", tail
        return (head if len(head) == 1 else rf"\mathrm{{{head}}}"), tail


def statement(
    scene: Scene, row: Row, trees: tuple[Tree, ...], labels: Labels, source: Random, head: str
) -> str:
    """A statement as LaTeX; `head` is the name of an energy."""
    chosen = style(source)
    write = Latex(scene, labels, chosen)
    left, right = chosen.frame
    if row.about == "mass matrix":
        size = len(scene.u)
        rows = [" & ".join(map(write, trees[i : i + size])) for i in range(0, size * size, size)]
        kind = source.choice(("bmatrix", "pmatrix"))
        return rf"\begin{{{kind}}} " + r" \\ ".join(rows) + rf" \end{{{kind}}}"
    if row.equation:
        return left + chosen.equals.join(map(write, trees)) + right
    return f"{left}{head}{chosen.equals}{write(trees[0])}{right}"
