"""One case of the campaign, the same for the same number: what is written, and what is known of it.

m17    a wrong statement: one or two mistakes in a right one, or as many as are asked for
r17    a right statement, written otherwise
c17    a right statement in another convention, which is not declared
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from random import Random

from benchmarks.detection.equivalent import same
from benchmarks.detection.forms.every import FORMS, Form
from benchmarks.detection.forms.spelling import Written
from benchmarks.detection.mutate import KINDS, Mutation, draw, made
from benchmarks.detection.rewrite import REWRITERS, Rewriting
from benchmarks.detection.rows import Row, Subject, holds, subject
from benchmarks.detection.tree import Tree
from benchmarks.detection.vocabulary import vocabulary

MOST_DRAWS = 400
LARGEST_REWRITTEN = 2000
"""Nodes of a rewritten side: products to sums make millions of some."""
DOUBLE = 0.4
"""Share of mutants with two mistakes."""


@dataclass(frozen=True, eq=False)
class Case:
    """What `mechanics.check` is given.

    Attributes
    ----------
    name : str
        ``"m17"``.
    row : Row
        The right statement that it was made from.
    trees : tuple of Tree
        As it is written.
    kinds : tuple of str
        Of mistakes, or of rewriting.
    equivalent : tuple of bool
        For each mutant that was drawn before and is right: whether the normal form proves it.
    """

    name: str
    about: Subject
    row: Row
    trees: tuple[Tree, ...]
    form: str
    written: Written
    kinds: tuple[str, ...]
    mutations: tuple[Mutation, ...] = ()
    equivalent: tuple[bool, ...] = ()


Maker = Callable[[str, Subject, Row, Random], Case | bool | None]


class NothingToDrawError(ValueError):
    """No case of this kind can be made of these systems."""


def case(name: str, seed: int, systems: Sequence[str], errors: int | None = None) -> Case:
    """The case of a name; of a mutant with so many mistakes, or one or two.

    Raises
    ------
    NothingToDrawError
        When none is found in several hundred draws.
    """
    makers: dict[str, Maker] = {"m": partial(mutant, errors=errors), "r": rewriting,
                                "c": _undeclared}  # fmt: skip
    make = makers[name[0]]
    source = Random(f"{seed} {name}")
    equivalent: list[bool] = []
    for _ in range(MOST_DRAWS):
        about = subject(source.choice(systems))
        row = _row(about, source)
        found = make(name, about, row, source)
        if isinstance(found, Case):
            return replace(found, equivalent=tuple(equivalent))
        if found is not None:
            equivalent.append(found)
    raise NothingToDrawError(f"{name}: nothing to draw from {', '.join(systems)}")


def _row(about: Subject, source: Random) -> Row:
    """A statement: what it is about first, so that rare ones are not lost among many."""
    kinds = sorted({row.about for row in about.rows})
    weights = [4 if kind in ("motion", "acceleration") else 1 for kind in kinds]
    (kind,) = source.choices(kinds, weights)
    return source.choice([row for row in about.rows if row.about == kind])


def mutant(
    name: str, about: Subject, row: Row, source: Random, forms: Sequence[tuple[str, Form]] = FORMS,
    errors: int | None = None,
) -> Case | bool | None:  # fmt: skip
    """A mutant; for one that is right whether that is proved; None where there is none."""
    count = errors or (2 if source.random() < DOUBLE else 1)
    kinds = tuple(source.choice([kind for kind, _ in KINDS]) for _ in range(count))
    # The name on the left of a reaction or an acceleration is what the statement is about.
    changed = row.trees[1:] if row.about in ("acceleration", "reaction") else row.trees
    mutations = draw(source, kinds, changed, vocabulary(about.scene))
    if mutations is None:
        return None
    kept = row.trees[: len(row.trees) - len(changed)]
    trees = (*kept, *made(changed, mutations))
    right = holds(about, row, trees)
    if right:
        return same(about, row, trees)
    if right is None:
        return None
    form, make = source.choice(forms)
    written = make(about, row, trees, {}, source)
    if written is None:
        return None
    return Case(name, about, row, trees, form, written, kinds, mutations)


def rewriting(
    name: str, about: Subject, row: Row, source: Random, forms: Sequence[tuple[str, Form]] = FORMS
) -> Case | None:
    """A right statement, written otherwise; None where that cannot be."""
    kind, rewrite = source.choice(REWRITERS)
    done = rewrite(about, row, source)
    if done is None:
        return None
    return _rewritten(name, about, row, (kind,), done, source, forms)


def _undeclared(name: str, about: Subject, row: Row, source: Random) -> Case | None:
    """A statement in another convention that is wrong as it stands."""
    rewrite = dict(REWRITERS)["other convention"]
    done = rewrite(about, row, source)
    if done is None or holds(about, row, done.trees) is not False:
        return None
    kinds, done = done.convention, replace(done, convention=())
    return _rewritten(name, about, row, kinds, done, source, FORMS)


def _rewritten(
    name: str, about: Subject, row: Row, kinds: tuple[str, ...], done: Rewriting, source: Random,
    forms: Sequence[tuple[str, Form]],
) -> Case | None:  # fmt: skip
    if max(tree.size for tree in done.trees) > LARGEST_REWRITTEN:
        return None
    if holds(about, row, done.meant or done.trees) is not True:
        raise ValueError(f"{name}: {kinds} made a wrong statement of {row.name}")
    form, make = source.choice(forms)
    # Beside an acceleration in another convention a function would have to return others in it.
    alone = Row(row.name, "motion", row.trees) if done.meant and row.equation else row
    written = make(about, alone, done.trees, done.names, source)
    if written is None:
        return None
    options = written.options | ({"convention": done.convention} if done.convention else {})
    written = Written(written.thing, options, written.text, written.place)
    return Case(name, about, row, done.trees, form, written, kinds)
