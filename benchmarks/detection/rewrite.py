"""Right statements written otherwise, which stay right.

expanded, factored, scaled, combined with another row, sides swapped, terms moved, fractions nested
half and double angles, products as sums, 1 - sin^2, tan;  other names;  other conventions, declared
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from random import Random

import sympy
from sympy import Expr, Symbol, cos, sin, tan
from sympy.simplify.fu import TR5, TR6, TR7, TR8, TR10

from benchmarks.detection.rows import Row, Subject
from benchmarks.detection.tree import Tree, negative, number, power, product, read, total, written
from mechanics.claims.conventions import combined_table, conventions
from mechanics.scene.rates import coordinate_rate_table, rate
from mechanics.scene.symbols import plain_symbol, plain_table, to_plain

Sides = tuple[Tree, ...]


@dataclass(frozen=True)
class Rewriting:
    """A right statement, written otherwise.

    Attributes
    ----------
    trees : tuple of Tree
    names : mapping of str to str
        Names of the scene, and what the person calls them.
    convention : tuple of str
        How the person counts otherwise than the scene.
    meant : tuple of Tree
        In the scene's own convention, where the person has another.
    """

    trees: Sides
    names: Mapping[str, str] = field(default_factory=dict)
    convention: tuple[str, ...] = ()
    meant: Sides = ()


Rewriter = Callable[[Subject, Row, Random], Rewriting | None]


def _each(change: Callable[[Expr], Expr]) -> Rewriter:
    """Every side changed on its own."""

    def rewritten(about: Subject, row: Row, source: Random) -> Rewriting | None:
        found = tuple(read(change(written(tree))) for tree in row.trees)
        return Rewriting(found) if found != row.trees else None

    return rewritten


def _factored(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """Collected by a symbol, common factors in front."""

    def collected(tree: Tree) -> Tree:
        expr = sympy.expand(written(tree))
        names = sorted(expr.free_symbols, key=str)
        expr = sympy.collect(expr, source.choice(names)) if names else expr
        return read(sympy.factor_terms(expr))

    found = tuple(map(collected, row.trees))
    return Rewriting(found) if found != row.trees else None


def _weight(about: Subject, source: Random) -> Tree:
    """What rows are scaled and combined with."""
    p = list(about.scene.parameters)
    one, two = (Tree("symbol", source.choice(p)) for _ in range(2))
    return source.choice((
        number(source.choice((2, -1, -3))), one, power(one, -1), product(one, two),
        product(one, power(two, -1)), total(one, number(1)), power(one, 2),
    ))  # fmt: skip


def _times(weight: Tree, side: Tree, source: Random) -> Tree:
    """Into each term of a sum, or in front of it."""
    if side.kind == "sum" and source.random() < 0.5:
        return total(*(product(weight, term) for term in side.parts))
    return product(weight, side)


def _scaled(about: Subject, row: Row, source: Random) -> Rewriting | None:
    if not row.equation:
        return None
    weight = _weight(about, source)
    return Rewriting(tuple(_times(weight, side, source) for side in row.trees))


def _combined(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """The row plus a multiple of another equation of motion; the multiple may depend on the state.

    A combination in which all accelerations cancel is none: it is drawn again elsewhere.
    """
    others = [r for r in about.rows if r.about == "motion" and r.trees != row.trees]
    if row.about not in ("motion", "acceleration") or not others:
        return None
    other, weight = source.choice(others), _weight(about, source)
    if source.random() < 0.3:
        weight = product(weight, Tree("cos", None, (Tree("symbol", about.scene.q[-1]),)))
    sides = zip(row.trees, other.trees, strict=True)
    trees = tuple(total(one, _times(weight, two, source)) for one, two in sides)
    residual = written(trees[0]) - written(trees[1])
    if all(sympy.expand(residual.diff(s)) == 0 for s in about.scene.ud):
        return None
    return Rewriting(trees)


def _swapped(about: Subject, row: Row, source: Random) -> Rewriting | None:
    return Rewriting(row.trees[::-1]) if row.equation else None


def _moved(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """Some terms to the other side, or all of them."""
    if not row.equation:
        return None
    sides = [list(t.parts) if t.kind == "sum" else [t] for t in row.trees]
    every = source.random() < 0.3
    left = [t for t in sides[0] if every or source.random() < 0.6]
    right = [] if every else [t for t in sides[1] if source.random() < 0.6]
    gone = [negative(t) for t in sides[0] if t not in left]
    come = [negative(t) for t in sides[1] if t not in right]
    zero = number(0)
    trees = tuple(
        total(*(t for t in side if t != zero)) for side in ([*left, *come], [*right, *gone])
    )
    return Rewriting(trees) if trees != row.trees else None


def _nested(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """A side (a + b) as (a/c + b/c) / (1/c), with c a parameter."""
    c = Tree("symbol", source.choice(about.scene.parameters))
    under = power(c, -1)

    def nested(tree: Tree) -> Tree:
        if tree == number(0):
            return tree
        terms = tree.parts if tree.kind == "sum" else (tree,)
        return Tree("product", None, (
            total(*(product(term, under) for term in terms)),
            Tree("power", None, (under, number(-1))),
        ))  # fmt: skip

    side = source.randrange(len(row.trees))
    trees = tuple(nested(t) if i == side else t for i, t in enumerate(row.trees))
    return Rewriting(trees) if trees != row.trees else None


def _half_angles(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """sin a = 2 sin a/2 cos a/2, and one of the three forms of cos a."""
    way = source.randrange(3)

    def cosine(a: Expr) -> Expr:
        c, s = cos(a / 2), sin(a / 2)
        return (1 - 2 * s**2, 2 * c**2 - 1, c**2 - s**2)[way]

    def halved(expr: Expr) -> Expr:
        table = {sin(a): 2 * sin(a / 2) * cos(a / 2) for (a,) in (f.args for f in expr.atoms(sin))}
        table |= {cos(a): cosine(a) for (a,) in (f.args for f in expr.atoms(cos))}
        return expr.xreplace(table)

    return _each(halved)(about, row, source)


def _tangents(expr: Expr) -> Expr:
    return expr.replace(sin, lambda a: tan(a) * cos(a))


def _padded(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """The same term added on both sides, or added and taken away."""
    states = [Tree("symbol", s) for s in (*about.scene.q, *about.scene.u, *about.scene.parameters)]
    term = product(source.choice(states), source.choice(states))
    if row.equation:
        return Rewriting(tuple(total(side, term) for side in row.trees))
    first, *others = row.trees
    return Rewriting((total(first, term, negative(term)), *others))


LETTERS = ("phi", "psi", "alpha", "beta", "gamma", "xi", "eta", "kappa", "A", "B", "C", "D", "J",
           "P", "W", "b", "c", "h", "j", "n", "p", "r", "w", "z")  # fmt: skip


def _renamed(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """Other names for some coordinates, inputs and parameters."""
    scene = about.scene
    old = [s.name for s in (*scene.q, *scene.input_symbols, *scene.parameters)]
    taken = {s.name for s in about.states.all[0]}
    free = [name for name in LETTERS if name not in taken]
    source.shuffle(free)
    names = {name: new for name, new in zip(old, free, strict=False) if source.random() < 0.6}
    return Rewriting(row.trees, names) if names else None


def _other_speeds(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """Generalized speeds that are no rates, written in the rates of the coordinates."""
    scene = about.scene
    if not scene.speeds:
        return None
    known, rates = plain_table(scene.coordinates), coordinate_rate_table(scene)
    slow = {plain_symbol(u): to_plain(d, known, "a speed") for u, d in scene.speeds}
    fast = {plain_symbol(u, 1): rate(slow[plain_symbol(u)], rates) for u, _ in scene.speeds}
    trees = tuple(read(written(tree).xreplace(slow | fast)) for tree in row.trees)
    return Rewriting(trees) if trees != row.trees else None


def _convention(about: Subject, row: Row, source: Random) -> Rewriting | None:
    """Counted as another person counts, who says so."""
    if row.about == "mass matrix":
        return None  # it belongs to the person's coordinates: more than symbols changes
    known = conventions(about.scene)
    single = [change for change in known if len(change) == 1]
    change = source.choice(single if source.random() < 0.6 else known)
    table = combined_table(change)
    (back,) = sympy.linsolve([table[s] - Symbol(f"{s}_") for s in table], *table)
    own = {s: e.xreplace({Symbol(f"{t}_"): t for t in table})
           for s, e in zip(table, back, strict=True)}  # fmt: skip
    trees = tuple(read(written(tree).xreplace(own)) for tree in row.trees)
    meant = tuple(read(written(tree).xreplace(table)) for tree in trees)
    names = tuple(c.name for c in change)
    return Rewriting(trees, {}, names, meant) if trees != row.trees else None


REWRITERS: tuple[tuple[str, Rewriter], ...] = (
    ("as written", lambda about, row, source: Rewriting(row.trees)),
    ("expanded", _each(sympy.expand)),
    ("factored", _factored),
    ("scaled", _scaled),
    ("combined", _combined),
    ("sides swapped", _swapped),
    ("terms moved", _moved),
    ("nested fractions", _nested),
    ("half angles", _half_angles),
    ("double angles", _each(lambda e: TR7(sympy.expand(e)))),
    ("products to sums", _each(lambda e: TR8(sympy.expand(e)))),
    ("1 - cos^2", _each(TR5)),
    ("1 - sin^2", _each(TR6)),
    ("sums of angles", _each(TR10)),
    ("tangents", _each(_tangents)),
    ("padded", _padded),
    ("other names", _renamed),
    ("other speeds", _other_speeds),
    ("other convention", _convention),
)
