r"""LaTeX that is wider than a phone, as pieces between which a page may break its lines.

    \frac{a + b + ...}{c}    ->    <span class="fraction">  a  + b  + ...  over  c  </span>
    A (a + b + ...) x        ->    A ( a    + b    + ... ) x

MathML breaks no lines by itself. What fits on one line is one element.
"""

from collections.abc import Callable
from dataclasses import dataclass

from markupsafe import Markup

from mechanics.report.latex_items import CLOSES, HELD, OPENS, TABLE, TOKEN, items, terms, width

WIDEST, NARROWER, NARROWEST = 30, 4, 14
"""Characters of a piece that fit on the screen of a phone; less by so many inside another one."""

LINE = 36
"""Characters of a whole equation that fit on one line there."""

DEEPEST = 12
"""Brackets and fractions inside each other that are opened."""

NESTED, LONGEST = 40, 20_000
"""Brackets inside each other, and characters, of what is looked into at all."""

Maths = Callable[[str], Markup | None]


@dataclass(frozen=True)
class Stack:
    """A fraction, or a marked part, whose own pieces may break."""

    kind: str
    parts: tuple[str, ...]
    deepest: int


Unit = list[str | Stack]
"""What stays on one line."""


def broken(latex: str, maths: Maths, deepest: int = DEEPEST) -> Markup | None:
    """Elements of a page with places to break between them; None where one cannot be typeset."""
    whole: list[Unit] = [[latex]]
    parts = _units(latex, deepest) if _readable(latex) else whole
    shown = [_unit(unit, maths) for unit in parts]
    found = [part for part in shown if part is not None]
    return Markup("<wbr>").join(found) if len(found) == len(shown) and found else None


def fits(latex: str) -> bool:
    """Whether one line of a phone has room for the whole of it."""
    return width(latex) <= LINE


def line_box(shown: Markup, latex: str, reach: Markup | str = "") -> Markup:
    """The box of an equation; one that is set in pieces is mathematics, called by its LaTeX."""
    whole = Markup(' role="math" aria-label="{}"').format(latex) if "<wbr>" in shown else ""
    return Markup('<div class="terms"{}{}>{}</div>').format(whole, reach, shown)


def _readable(latex: str) -> bool:
    """Whether LaTeX of somebody else is small enough to be looked into."""
    depth = deepest = 0
    for token in TOKEN.findall(latex[:LONGEST]):
        depth += bool(OPENS.fullmatch(token)) - bool(CLOSES.fullmatch(token))
        deepest = max(deepest, depth)
    return deepest <= NESTED and len(latex) <= LONGEST


def _limit(deepest: int) -> int:
    return max(WIDEST - NARROWER * (DEEPEST - deepest), NARROWEST)


def _units(latex: str, deepest: int) -> list[Unit]:
    if deepest == DEEPEST and fits(latex):
        return [[latex]]
    found: list[Unit] = []
    for term in terms(latex):
        if width(term) <= _limit(deepest) or deepest == 0 or TABLE.search(term):
            found.append([term])
        else:
            found += _opened(term, deepest)
    return found


def _opened(term: str, deepest: int) -> list[Unit]:
    """A wide term: its wide fractions and brackets opened."""
    found: list[Unit] = [[""]]

    def add(text: str) -> None:
        last = found[-1]
        if last and isinstance(last[-1], str):
            last[-1] += text
        else:
            last.append(text)

    for item in items(term):
        wide = bool(item.parts) and width(item.text) > _limit(deepest)
        if wide and item.kind == "fraction":
            found[-1].append(Stack("fraction", item.parts, deepest - 1))
        elif wide and item.kind in ("wrong", "right"):
            found.append([Stack(item.kind, item.parts, deepest - 1)])
        elif wide and item.kind == "group":
            first, *others = _units(item.parts[0], deepest - 1)
            for piece in first:
                add(piece) if isinstance(piece, str) else found[-1].append(piece)
            found += others
        elif wide and item.kind == "bracket":
            tall = r"\Big" if r"\frac" in item.text else r"\big"
            first, *others = _units(item.parts[0], deepest - 1)
            if _parts(found, 6):
                found.append([""])
            add(rf"{tall}l{item.open} ")
            for piece in _signed(first):
                add(piece) if isinstance(piece, str) else found[-1].append(piece)
            found += others
            add(rf" {tall}r{item.close}")
        elif item.kind == "bracket" and _parts(found, 1):
            found.append([item.text])
        else:
            add(item.text)
    return [[p for p in unit if not isinstance(p, str) or p.strip()] for unit in found if any(unit)]


def _text(found: list[Unit]) -> str:
    """What stands last on the line so far, where it is text."""
    last = found[-1][-1] if found[-1] else ""
    return last.rstrip() if isinstance(last, str) else ""


def _parts(found: list[Unit], least: int) -> bool:
    """Whether a line may end before a bracket: behind a factor that is no mere coefficient."""
    before = _text(found)
    return width(before) > least and not HELD.search(before)


def _signed(unit: Unit) -> Unit:
    """The first unit in a bracket; in braces a minus is a sign, no difference."""
    first, *others = unit
    if isinstance(first, str) and first.startswith("-") and others == []:
        return [f"{{{first}}}"]
    return unit


def _unit(unit: Unit, maths: Maths) -> Markup | None:
    shown = [maths(part) if isinstance(part, str) else _stack(part, maths) for part in unit]
    found = [part for part in shown if part is not None]
    if len(found) < len(shown):
        return None
    body = Markup("").join(found)
    lines = any(isinstance(part, Stack) and part.kind == "fraction" for part in unit)
    return Markup('<span class="unit">{}</span>').format(body) if lines else body


def _stack(stack: Stack, maths: Maths) -> Markup | None:
    shown = [broken(part, maths, stack.deepest) for part in stack.parts]
    if any(part is None for part in shown):
        return None
    rows = Markup("").join(Markup("<span>{}</span>").format(part) for part in shown)
    return Markup('<span class="{}">{}</span>').format(stack.kind, rows)
