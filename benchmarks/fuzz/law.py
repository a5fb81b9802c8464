"""The law that every input keeps, and what it costs.

    bytes  ->  a Check, or a MechanicsError of one line with "line N, column M"
    Check  ->  its answer for a terminal, in JSON and as a page

Reading takes less than 2 s and 500 MB; a verdict, that of a wrong equation with its blame
included, less than `LONGEST_VERDICT`, and its answers together less than `LONGEST_ANSWERS`.
Nothing that the bytes say is run.
"""

import gc
import json
import re
import resource
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from time import process_time
from typing import Any

from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.judge.check import Check, check
from mechanics.judge.check_json import to_json
from mechanics.judge.readers import read
from mechanics.report.answer.page import check_html

LONGEST_READING = 2.0
LONGEST_VERDICT = 30.0
LONGEST_ANSWERS = 10.0
"""Seconds of the processor."""

LARGEST_MEMORY = 500.0
"""Megabytes."""

PLACE = re.compile(r"line \d+, column \d+: ")


@dataclass(frozen=True)
class Outcome:
    """What became of an input.

    Attributes
    ----------
    kind : str
        The worst verdict, or ``"refused"``.
    broken : str
        How it breaks the law; empty where it does not.
    reading, verdict, answers : float
        Seconds of the processor.
    memory : float
        Megabytes that the process grew by.
    """

    kind: str
    broken: str
    reading: float
    verdict: float
    answers: float
    memory: float


def outcome(truth: Equations, notation: str, data: bytes, *, blame: bool = True) -> Outcome:
    """Read an input, judge it, write its answers; time and memory are measured, not judged.

    Parameters
    ----------
    truth : Equations
        Of the scene that the input is about.
    notation : str
        ``"latex"``, ``"text"`` or ``"c"``.
    blame : bool
        Whether what is wrong is looked for, too.
    """
    before = memory()
    _, broken, reading = _timed(lambda: read(truth.scene, data, None, notation, None))
    kind, verdict, answers = "read", 0.0, 0.0
    if not broken:
        found, broken, verdict = _timed(lambda: check(truth, data, notation=notation, blame=blame))
        kind = found.verdict.name if isinstance(found, Check) else "refused"
        if isinstance(found, Check) and not broken:
            _, broken, answers = _timed(lambda: _answers(found))
            broken = broken or _doubts(found)
    return Outcome(kind, broken, reading, verdict, answers, memory() - before)


def over(found: Outcome) -> str:
    """Which limit an outcome is beyond; empty where none."""
    if found.reading > LONGEST_READING:
        return f"reading took {found.reading:.1f} s"
    if found.memory > LARGEST_MEMORY:
        return f"{found.memory:.0f} MB"
    if found.verdict > LONGEST_VERDICT:
        return f"the verdict took {found.verdict:.1f} s"
    if found.answers > LONGEST_ANSWERS:
        return f"the answers took {found.answers:.1f} s"
    return ""


def memory() -> float:
    """Most megabytes that this process had."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def _timed(act: Callable[[], Any]) -> tuple[Any, str, float]:
    """What an act returns, how it breaks the law, and its seconds."""
    found, broken = None, ""
    gc.freeze()  # else a collection looks through all that the process had before
    start = process_time()
    try:
        found = act()
    except MechanicsError as error:
        broken = _line(str(error))
    except Exception as error:
        broken = f"{type(error).__name__} {_origin(error)}"
    finally:
        took = process_time() - start
        gc.unfreeze()
    return found, broken, took


def _answers(found: Check) -> tuple[str, str, str]:
    """What a person sees of a verdict."""
    return str(found), json.dumps(to_json(found)), check_html(found)


def _line(words: str) -> str:
    if len(words.splitlines()) != 1:
        return "an error of more than one line"
    if not PLACE.search(words):
        return f"an error without a place: {re.sub(r'[0-9]+', '0', words)[:60]}"
    return ""


def _doubts(found: Check) -> str:
    """A statement that could not be read says where, in one line."""
    for entry in found.judged:
        doubt = entry.statement.doubt
        if len(doubt.splitlines()) > 1:
            return "a doubt of more than one line"
        if entry.statement.row is None and not PLACE.search(doubt):
            return f"a doubt without a place: {doubt[:60]}"
    return ""


def _origin(error: BaseException) -> str:
    """The last line of ours that an error came through."""
    frames = [f for f in traceback.extract_tb(error.__traceback__) if "mechanics" in f.filename]
    last = frames[-1] if frames else None
    return f"at {last.filename.rpartition('mechanics/')[2]}, {last.name}" if last else ""
