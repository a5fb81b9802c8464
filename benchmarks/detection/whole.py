"""What people hand over whole: models built with SymPy, and functions that can only be called.

k17    a wrong model, as a KanesMethod, LagrangesMethod or System
b17    a function of accelerations with one or two mistakes, called with numbers only
s17    a right one, written otherwise
"""

from collections.abc import Sequence
from dataclasses import dataclass
from random import Random
from time import process_time
from typing import Any

import mechanics
from benchmarks.detection.case import MOST_DRAWS, Case, NothingToDrawError, mutant, rewriting
from benchmarks.detection.forms.code import python
from benchmarks.detection.models import OBJECTS, wrong_model
from benchmarks.detection.rows import Subject, subject
from benchmarks.detection.trial import Result, judged
from mechanics import BlackBox
from mechanics.errors import MechanicsError
from mechanics.scene.actions import frictions

WHOLE = ("k", "b", "s")
"""First letters of their names."""


@dataclass(frozen=True)
class Whole:
    """What `mechanics.check` is given, and what is known of it.

    Attributes
    ----------
    thing : KanesMethod, LagrangesMethod, System or BlackBox
    options : dict
    form, row, text : str
        For people.
    kinds, made : tuple of str
        Of mistakes or rewriting, and what each mistake changed.
    """

    about: Subject
    thing: object
    options: dict[str, Any]
    form: str
    row: str
    text: str
    kinds: tuple[str, ...]
    made: tuple[str, ...]


def whole(name: str, seed: int, systems: Sequence[str]) -> Whole:
    """The case of a name.

    Raises
    ------
    NothingToDrawError
        When none is found in several hundred draws.
    """
    source = Random(f"{seed} {name}")
    # Off the constraints states of a box mean nothing, and SymPy's loads hold no reactions.
    known = [s for s in systems if not (scene := subject(s).scene).constraints
             and not frictions(scene)]  # fmt: skip
    for _ in range(MOST_DRAWS if known else 0):
        about = subject(source.choice(known))
        found = _model(about, source) if name[0] == "k" else _box(name, about, source)
        if found is not None:
            return found
    raise NothingToDrawError(f"{name}: nothing to draw from {', '.join(systems)}")


def _model(about: Subject, source: Random) -> Whole | None:
    model = wrong_model(about, source)
    if model is None:
        return None
    form, build = source.choice(OBJECTS)
    kinds, words = zip(*((m.kind, m.words) for m in model.mutations), strict=True)
    text = f"{form} with a wrong {model.where}: {'; '.join(words)}"
    return Whole(about, build(model.scene), {}, form, model.where, text, kinds, words)


def _box(name: str, about: Subject, source: Random) -> Whole | None:
    rows = [row for row in about.rows if row.about == "acceleration"]
    if not rows:
        return None
    make = mutant if name[0] == "b" else rewriting
    drawn = make(name, about, source.choice(rows), source, (("Python function", python),))
    if not isinstance(drawn, Case) or drawn.written.options.get("about"):
        return None
    model: Any = drawn.written.thing
    box = BlackBox(model)
    words = tuple(mutation.words for mutation in drawn.mutations)
    options = {k: v for k, v in drawn.written.options.items() if v is not None}
    return Whole(about, box, options, "black box", drawn.row.name, drawn.written.text,
                 drawn.kinds, words)  # fmt: skip


def judged_whole(name: str, seed: int, systems: Sequence[str]) -> Result:
    """Draw a case, and check it."""
    drawn = whole(name, seed, systems)
    verdict, words, count, start = "error", "", 1, process_time()
    try:
        found = mechanics.check(drawn.about.free_body, drawn.thing, blame=False, **drawn.options)
        verdict, count = found.verdict.name, len(found.judged)
        words = "; ".join(f"{e.statement.tag}: {e.finding.evidence}" for e in found.judged)
    except MechanicsError as error:
        words = f"{type(error).__name__}: {error}"
    seconds = (process_time() - start) / count
    return Result(name, drawn.about.system.name, drawn.row, drawn.form, drawn.form, drawn.kinds,
                  drawn.made, verdict, words, (), seconds, drawn.text)  # fmt: skip


def judged_all(
    wanted: list[str], seed: int, systems: tuple[str, ...], blamed: int, errors: int | None
) -> list[Result]:
    """Cases of all kinds; the first `blamed` mutants are blamed too."""
    return [
        judged_whole(name, seed, systems)
        if name[0] in WHOLE
        else judged(name, seed, systems, name[0] == "m" and int(name[1:]) < blamed, errors)
        for name in wanted
    ]
