"""A right equation in another convention is right where that is declared, and no other one is.

right:  r(q_p) with what the scene's symbols are in the person's       wrong: one term of it changed
"""

from functools import cache
from random import Random

import pytest
from sympy import Add, Eq, Expr, Rational, Symbol, expand, linsolve

import mechanics
from mechanics.blame.derivation import Derivation
from mechanics.claims.angle_directions import directed
from mechanics.claims.convention import POINT_MASS, Change, combined_table
from mechanics.claims.conventions import conventions
from mechanics.claims.directions import counted
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.judge.other_conventions import targets_of
from systems import ALL

pytestmark = pytest.mark.campaign

NAMES = [system.name for system in ALL]
PENDULUMS = ("elastic_pendulum", "double_pendulum", "rod_pendulum", "cartpole", "acrobot")
SHOWN = ("PROVED", "CERTIFIED")
LARGEST = 30
"""Terms of a row that is looked at."""
MOST_BARE = 1
"""Conventions of a system that change none of its rows but those that are too large."""


@cache
def truth(name: str) -> Equations:
    (system,) = (system for system in ALL if system.name == name)
    return derived(system.scene())


def changes(name: str) -> list[Change]:
    """Conventions that may be declared for a system, the first ones alone, and some pairs."""
    scene = truth(name).scene
    found: list[Change] = [(c,) for _, _, c in directed(scene, counted(scene))]
    found += [change for change in conventions(scene) if len(change) == 1]
    found += [(POINT_MASS,)] if targets_of(truth(name), [(POINT_MASS,)]) != [None] else []
    pairs = [change for change in conventions(scene) if len(change) == 2]
    source = Random(name)
    return source.sample(found, min(12, len(found))) + source.sample(pairs, min(4, len(pairs)))


def rows_under(name: str, change: Change) -> list[Expr]:
    """Right rows, expanded, in which the convention can be seen."""
    (target,) = targets_of(truth(name), [change])
    assert target is not None
    table = combined_table(change)
    solved = linsolve([table[s] - Symbol(f"{s}_") for s in table], *table) if table else {()}
    (back,) = solved
    own = {s: e.xreplace({Symbol(f"{t}_"): t for t in table})
           for s, e in zip(table, back, strict=True)}  # fmt: skip
    plain = [target.scene.plain(row.value) for row in Derivation(target).generalized_rows]
    seen = [row for row in plain if not table or row.free_symbols & table.keys()]
    rows = [expand(row.xreplace(own), trig=False) for row in seen]
    return [row for row in rows if 1 < len(Add.make_args(row)) <= LARGEST]


def mutants(row: Expr, factors: tuple[Expr, ...]) -> list[Expr]:
    """Copies of a row with one term changed."""
    terms = Add.make_args(row)
    return [row + (factor - 1) * term for term in terms for factor in factors]


def verdict(name: str, row: Expr, *names: str) -> str:
    claim = Eq(row, 0, evaluate=False)
    (entry,) = mechanics.check(truth(name), claim, blame=False, convention=names).judged
    return entry.finding.verdict.name


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", PENDULUMS)
def test_each_wrong_sign_is_refuted_under_each_definite_direction(name: str) -> None:
    level = 0
    scene = truth(name).scene
    for quarter, _, convention in directed(scene, counted(scene)):
        if quarter not in (0, 2):
            continue  # the verticals: `test_each_convention`
        rows = rows_under(name, (convention,))
        level += bool(rows)
        for row in rows:
            assert verdict(name, row, convention.name) in SHOWN
            assert verdict(name, row, "from the horizontal") == "UNDECIDED"
            for wrong in mutants(row, (Rational(-1),)):
                assert verdict(name, wrong, convention.name) == "REFUTED", (convention.name, wrong)
    assert level == 4  # from the left and from the right, each in two senses


@pytest.mark.sample(1)
@pytest.mark.parametrize("name", NAMES)
def test_each_convention(name: str) -> None:
    """Right if undeclared, shown declared; with a term changed it is neither."""
    source = Random(name)
    bare, every = 0, changes(name)
    for change in every:
        names = [c.name for c in change]
        rows = rows_under(name, change)
        if not rows:
            bare += 1
            continue
        row = source.choice(sorted(rows, key=lambda r: len(Add.make_args(r)))[:2])
        assert verdict(name, row, *names) in SHOWN, (names, row)
        (entry,) = mechanics.check(truth(name), Eq(row, 0, evaluate=False), blame=False).judged
        if entry.finding.verdict.name == "REFUTED":
            assert entry.right_if, (names, row)
        else:
            assert entry.finding.shown  # it is the same row in the scene's own convention
        wrong = source.choice(mutants(row, (Rational(-1), Rational(2), Rational(1, 2))))
        assert verdict(name, wrong, *names) == "REFUTED", (names, wrong)
    assert every and bare <= MOST_BARE
