"""A folder of Coq files, a theorem each, and what `coqc` says of them.

What a file shows is algebra: that a statement follows from the balance laws that stand in it, for
all real numbers, sines and cosines on their circles. That these are the laws of the scene is not
shown by Coq; a person can read them.
"""

import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from textwrap import wrap

from sympy import Dummy

from mechanics.coq.polynomial import Names, NotPolynomialError, equation, symbols_of, text
from mechanics.coq.theorems import Statement, Theorem, theorems
from mechanics.errors import ExpressionError, InputError, SceneError
from mechanics.scene.system import System

SECONDS = 120
"""For one file."""
LONGEST = 40_000
"""Characters of a file."""
WIDTH = 96


@dataclass(frozen=True)
class Written:
    """A file, and what became of it.

    Attributes
    ----------
    name : str
        Of the theorem.
    path : Path or None
        None where nothing was written.
    reason : str
        Why nothing was written, or what `coqc` objects to; empty where it accepts the file or is
        not there.
    """

    name: str
    path: Path | None
    reason: str = ""


def write_coq(system: System, folder: Path) -> tuple[Written, ...]:
    """Write a file for every theorem of a system.

    Parameters
    ----------
    system : System
    folder : Path
        Made where it is not there.

    Returns
    -------
    tuple of Written

    Raises
    ------
    InputError
        Where the folder cannot be made.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"folder {folder}: it cannot be made: {error.strerror}") from None
    found = []
    for name, theorem in theorems(system).items():
        try:
            words = file_text(system.name, name, theorem())
        except (NotPolynomialError, SceneError) as error:
            found.append(Written(name, None, str(error)))
            continue
        except ExpressionError:
            words = ""
        if not 0 < len(words) <= LONGEST:
            found.append(Written(name, None, "it is too long for a person and for nsatz"))
            continue
        path = folder / f"{name}.v"
        path.write_text(words, encoding="utf-8")
        found.append(Written(name, path))
    return tuple(found)


def file_text(system: str, name: str, theorem: Theorem) -> str:
    """The file of a theorem.

    Raises
    ------
    NotPolynomialError
        For a law or goal that is no polynomial.
    """
    lemmas = [_lemma(f"{name}_{k + 1}", theorem.laws, goal) for k, goal in enumerate(theorem.goals)]
    head = _comment(
        f"{system}: {theorem.words}. Every variable is a real number; s_a and c_a are the sine and"
        " cosine of the angle a. Quotients are multiplied out: nothing is said where a denominator"
        " is zero. In each lemma the last equation follows from the others."
    )
    return "\n".join(
        [*wrap(head, WIDTH), "Require Import Reals Nsatz.", "Open Scope R_scope.", "", *lemmas]
    )


def _lemma(name: str, laws: Sequence[Statement], goal: Statement) -> str:
    names = Names()
    sides = [equation(statement.left, statement.right, names) for statement in (*laws, goal)]
    used = symbols_of(side for pair in sides for side in pair)
    inverses = [(symbol, Dummy(f"inverse_{symbol.name}"))
                for symbol in used if symbol in goal.nonzero]  # fmt: skip
    circles = [pair for pair in names.circles.values() if {*pair} & {*used}]
    every = sorted({*used, *chain(*circles, *inverses)}, key=lambda symbol: symbol.name)
    lines = [f"Lemma {name} :"]
    if every:
        lines += _wrapped(f"forall {' '.join(map(names.of, every))} : R,")
    for sine, cosine in (map(names.of, pair) for pair in circles):
        lines.append(f"  {sine}*{sine} + {cosine}*{cosine} = 1 ->")
    for symbol, inverse in inverses:
        lines.append(f"  {names.of(symbol)}*{names.of(inverse)} = 1 ->")
    for statement, (left, right) in zip((*laws, goal), sides, strict=True):
        lines += _wrapped(_comment(statement.words))
        end = "." if statement is goal else " ->"
        lines += _wrapped(f"{text(left, names)} = {text(right, names)}{end}")
    return "\n".join([*lines, "Proof. intros. nsatz. Qed.", ""])


def _wrapped(words: str) -> list[str]:
    return wrap(words, WIDTH, initial_indent="  ", subsequent_indent="    ",
                break_long_words=False, break_on_hyphens=False)  # fmt: skip


def _comment(words: str) -> str:
    """A comment; what would end it is taken apart."""
    return f"(* {words.replace('(*', '( *').replace('*)', '* )')} *)"


def checked(written: Sequence[Written]) -> tuple[Written, ...] | None:
    """The same with what `coqc` objects to; None where there is no `coqc`."""
    program = shutil.which("coqc")
    if program is None:
        return None
    return tuple(entry if entry.path is None else _checked(program, entry) for entry in written)


def _checked(program: str, entry: Written) -> Written:
    assert entry.path is not None
    try:
        run = subprocess.run(
            [program, "-q", entry.path.name], cwd=entry.path.parent, capture_output=True,
            text=True, timeout=SECONDS, check=False,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return Written(entry.name, entry.path, f"coqc took more than {SECONDS} s")
    lines = [line for line in run.stderr.splitlines() if line.strip()]
    reason = "" if run.returncode == 0 else " ".join(lines)[-200:] or "coqc failed"
    return Written(entry.name, entry.path, reason)
