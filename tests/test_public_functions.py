"""Public functions: another kind of thing than they take is refused, and how to get it is told."""

import re
from collections.abc import Callable

import pytest

import mechanics
from mechanics.testing import assert_equivalent
from systems import rocker

SCENE = rocker.scene()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda: mechanics.compile("a.py"),
            "compile: Equations or Scene wanted, str found: pass derive(",
        ),
        (
            lambda: mechanics.simulate(SCENE, 1),
            "simulate: Model wanted, Scene found: pass compile(",
        ),
        (
            lambda: mechanics.trade(SCENE, 1),
            "trade: Equations wanted, Scene found",
        ),
        (
            lambda: mechanics.extremes(SCENE),
            "extremes: Equations wanted, Scene found",
        ),
        (
            lambda: mechanics.linearize(SCENE, {}),
            "linearize: Equations wanted, Scene found",
        ),
        (lambda: mechanics.modes(SCENE), "modes: Linear wanted, Scene found: pass linearize("),
        (lambda: mechanics.write_c(SCENE, "c"), "write_c: Model wanted, Scene found"),
        (lambda: mechanics.write_fmu(SCENE, "a.fmu"), "write_fmu: Model wanted, Scene found"),
        (lambda: mechanics.Feedback(30.0), "Feedback: a function of t, q and u wanted, float"),
        (lambda: mechanics.crosscheck("a.py"), "crosscheck: System or Scene wanted, str found"),
        (lambda: mechanics.check("a.py", ""), "check: Scene or System or Equations wanted, str"),
        (lambda: mechanics.check(SCENE, 3), "check: int found: pass LaTeX, text, a Path, a SymPy"),
        (lambda: mechanics.check_html(SCENE), "check_html: Check wanted, Scene found: pass check("),
        (lambda: mechanics.check_json(SCENE), "check_json: Check wanted, Scene found: pass check("),
        (
            lambda: assert_equivalent(SCENE, "a = b"),
            "assert_equivalent: Scene or System or Equations wanted, str found: pass the equations",
        ),
        (lambda: mechanics.derive("a.py"), "derive: Scene wanted, str found"),
    ],
)
def test_what_a_function_does_not_take_is_refused(call: Callable[[], object], words: str) -> None:
    with pytest.raises(TypeError, match=re.escape(words)) as caught:
        call()
    assert isinstance(caught.value, mechanics.MechanicsError)
    assert "\n" not in str(caught.value)
