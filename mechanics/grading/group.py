"""All submissions of a class against one key, each in a worker of its own.

key  --derived once-->  reference  --a copy for each worker-->  grades, in the order of the files
"""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from mechanics.blame.reference import Reference
from mechanics.errors import InputError
from mechanics.grading.grade import INCOMPLETE, REQUIRE, RIGHT, UNJUDGED, WRONG, Grade, grade
from mechanics.grading.submission import things_in
from mechanics.judge.at_values import read_values
from mechanics.judge.check import derived
from mechanics.judge.options import takes_function
from mechanics.judge.scene_laws import verify
from mechanics.scene import Scene
from mechanics.worker import Failed, Limits, Stopped, outcomes


@dataclass(frozen=True)
class Group:
    """The grades of a class.

    Attributes
    ----------
    scene : Scene
        The key.
    """

    scene: Scene
    grades: tuple[Grade, ...]

    @property
    def mistakes(self) -> list[tuple[str, int]]:
        """Which mistakes, and in how many submissions, the commonest first."""
        found: Counter[str] = Counter()
        for one in self.grades:
            found.update({line.mistake for line in one.lines if line.mistake})
            found.update(["something is missing"] if one.missing else [])
        return found.most_common()

    @property
    def verdicts(self) -> list[tuple[str, int]]:
        """How many of each verdict."""
        return Counter(one.verdict for one in self.grades).most_common()

    @property
    def some_wrong(self) -> bool:
        """Whether a submission is wrong or incomplete."""
        return any(one.verdict in (WRONG, INCOMPLETE) for one in self.grades)

    @property
    def all_right(self) -> bool:
        """Whether every submission is right."""
        return all(one.verdict == RIGHT for one in self.grades)


def grade_files(
    scene: Scene, files: Sequence[Path], *, require: str = "all", pages: bool = False,
    function: str | None = None, run_python: bool = False, jobs: int = 1,
    limits: Limits | None = None, options: Mapping[str, Any] | None = None,
    done: Callable[[], None] = lambda: None,
) -> Group:  # fmt: skip
    """Grade files.

    Parameters
    ----------
    scene : Scene
        The key; its laws are verified first.
    require : str
        One of `mechanics.grading.grade.REQUIRE`.
    pages : bool
        Whether each grade has its page.
    function : str, optional
        Which function of code; pages and texts have none.
    run_python : bool
        Whether code in Python is run. Limits are no sandbox.
    jobs : int
        Workers at a time.
    limits : Limits, optional
        Of each worker.
    options : mapping, optional
        For `mechanics.check`.
    done : callable
        Called after each.

    Raises
    ------
    SceneError
        When the key is not right.
    InputError
        When there is no file, another requirement, or a value that the key cannot have.
    """
    if not files:
        raise InputError("grade: there is no submission: name files")
    if require not in REQUIRE:
        raise InputError(f"require {require!r}: it can be {', '.join(REQUIRE)}")
    if function is not None and not any(map(_has_functions, files)):
        raise InputError(
            f"--function (function=) {function}: no submission is code in C, C++, MATLAB, Julia or"
            " Python: leave it out"
        )
    reference = Reference(derived(scene))
    verify(reference.truth)
    read_values(scene, (options or {}).get("values") or {})  # a bad one is no submission's fault
    found: dict[int, Grade] = {}

    def one(path: Path) -> Grade:
        things = things_in(path, function=function, run_python=run_python)
        own = {**(options or {}), "function": function if takes_function(path) else None}
        return grade(reference, path.name, things, require=require, page=pages, options=own)

    for index, outcome in outcomes(one, list(files), limits or Limits(), jobs):
        found[index] = _grade(files[index].name, outcome)
        done()
    return Group(scene, tuple(found[k] for k in range(len(files))))


def _has_functions(path: Path) -> bool:
    return path.suffix.lower() in (".py", ".ipynb", ".md") or takes_function(path)


def _grade(name: str, outcome: Grade | Stopped | Failed) -> Grade:
    if isinstance(outcome, Grade):
        return outcome
    reason = outcome.reason if isinstance(outcome, Stopped) else outcome.message
    return Grade(name, UNJUDGED, None, remarks=(reason,))
