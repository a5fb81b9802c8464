"""A person's equations in a test suite: what is wrong fails, and says which term.

from mechanics.testing import assert_equivalent
from systems import elastic_pendulum

def test_my_simulator():
    names = {"state": "x theta x_dot theta_dot"}
    assert_equivalent(my_right_hand_side, elastic_pendulum.scene(), names=names)
"""

import warnings
from dataclasses import replace
from typing import Any

from mechanics.equations import Equations
from mechanics.errors import InputError, MechanicsError, wanted
from mechanics.importers import as_scene
from mechanics.judge.check import check, derived
from mechanics.judge.complete import determined
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.sentences import quoted
from mechanics.scene import Scene
from mechanics.scene.system import System

__all__ = ["assert_equivalent"]

SHOWN = (Verdict.PROVED, Verdict.CERTIFIED)
ORDER = (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.SUPPORTED)
"""Of what fails; the rest follows."""


def assert_equivalent(
    equations: Any,
    scene: Any,
    *,
    allow_supported: bool = False,
    partial: bool = False,
    **options: Any,
) -> None:
    """Fail unless equations are shown to be those of a scene.

    Parameters
    ----------
    equations : str, Path, SymPy object, function, BlackBox, or a sequence of them
        As for `mechanics.check`.
    scene : Scene, System or Equations, or a model of SymPy's
    allow_supported : bool
        Whether SUPPORTED is enough, which is the most that a `BlackBox` can reach: numbers only.
    partial : bool
        Whether it is enough that all that is said is right: one equation of several, an energy.
    **options
        As for `mechanics.check`: ``names``, ``notation``, ``about``, ``convention``,
        ``where``, ``only``, ``blame``.

    Raises
    ------
    AssertionError
        When something is refuted, with the wrong term and a state where the sides differ; and, in
        other words, when something is neither shown nor refuted, or when the equations of motion
        among them determine less than the motion. The text is what `mechanics check` prints.
    InputError
        When nothing can be read, or there is nothing to check.

    Warns
    -----
    UserWarning
        With sentences and comments around the equations that nothing was compared with.

    Examples
    --------
    >>> from mechanics.testing import assert_equivalent
    >>> from systems import elastic_pendulum
    >>> assert_equivalent("(M + m)*x'' + 2*k*x + M*L/2*(theta''*cos(theta)"
    ...                   " - theta'^2*sin(theta)) = 0", elastic_pendulum.scene(), partial=True)
    """
    __tracebackhide__ = True
    kinds = (Scene, System, Equations)
    try:
        scene = as_scene(scene)
        wanted(scene, kinds, "assert_equivalent", "pass the equations, then a scene")
        found = _worst_first(check(scene, equations, **options))
    except MechanicsError as error:
        # Where in this program it was found out is of no use to somebody who reads a failed test.
        raise error.with_traceback(None) from None
    if not found.judged:
        raise InputError(
            f"assert_equivalent: there is nothing to check: {'; '.join(found.remarks)}"
        )
    if found.verdict is Verdict.REFUTED:
        raise AssertionError(f"the equations are not those of {found.scene.name}\n\n{found}")
    if found.verdict in SHOWN:
        if not partial and (missing := _missing(found, scene)):
            raise AssertionError(f"{missing}\n\n{found}")
        for words in quoted(found.unjudged, found.scene):
            warnings.warn(words, stacklevel=2)
        return
    if allow_supported and found.verdict is Verdict.SUPPORTED:
        return
    if found.verdict is Verdict.SUPPORTED:
        words = (
            f"only numbers say that the equations are those of {found.scene.name}:"
            " pass allow_supported=True if that is enough"
        )
    else:
        words = f"it is undecided whether the equations are those of {found.scene.name}"
    raise AssertionError(f"{words}\n\n{found}")


def _missing(found: Check, scene: Scene | System | Equations) -> str:
    """What is right, but not enough to determine the motion; empty where it is."""
    truth = scene if isinstance(scene, Equations) else found.derived or derived(found.scene)
    rows, rank, freedoms = determined(truth, found.judged)
    if rank >= freedoms:
        return ""
    said = f"{rank} of {freedoms} independent equations of motion of {found.scene.name}"
    count = "there is no equation of motion" if not rows else f"only {said}"
    if found.aside:
        return f"what only= chose is right, but {count}: choose more, or pass partial=True"
    return f"all of it is right, but {count}: write the others, or pass partial=True"


def _worst_first(found: Check) -> Check:
    """The same, what fails in front."""
    groups = [[e for e in found.judged if e.verdict is verdict] for verdict in ORDER]
    rest = [e for e in found.judged if e.verdict not in ORDER]
    return replace(found, judged=(*(entry for group in groups for entry in group), *rest))
