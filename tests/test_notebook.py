"""Notebooks show things: one element each, without scripts, and short texts elsewhere."""

import importlib
import re
import xml.etree.ElementTree as ElementTree

import pytest

import mechanics
from mechanics.kernel import undecided
from mechanics.notebook import SHOWN, register
from systems import EVERY, arm_seven_joints, cartpole, rod_pendulum, rolling_disc


def test_a_finding_is_short() -> None:
    """What it says at length is in its fields."""
    finding = undecided("kane = lagrange", "because " * 100)
    assert repr(finding).startswith("Finding(subject='kane = lagrange', verdict=<Verdict.UNDECIDED")
    assert len(repr(finding)) < 120


def test_every_name_is_that_of_a_type() -> None:
    for module, name in SHOWN:
        found = getattr(importlib.import_module(module), name)
        assert (found.__module__, found.__qualname__) == (module, name)


def shown(thing: object) -> str:
    kind = type(thing)
    return SHOWN[kind.__module__, kind.__qualname__](thing)


@pytest.fixture(scope="module")
def things() -> list[object]:
    scene = rod_pendulum.scene()
    equations = mechanics.derive(scene, "kane")
    model = mechanics.compile(equations)
    linear = mechanics.linearize(equations, {"theta": 0}, inputs={"u": 0})
    return [scene, equations, model, linear, mechanics.simulate(model, 0.5, samples=21)]


@pytest.mark.campaign
def test_each_is_one_element_without_scripts(things: list[object]) -> None:
    for thing in things:
        text = shown(thing)
        ElementTree.fromstring(text.replace("<wbr>", ""))
        assert "<script" not in text
        assert not re.search(r"(?:src|href)=", text)
        assert len(repr(thing)) < 200


@pytest.mark.campaign
def test_a_result_says_that_all_checks_passed() -> None:
    result = mechanics.crosscheck(rod_pendulum.scene())
    assert f"All {len(result.claims)} checks passed" in shown(result)


def test_a_scene_shows_its_coordinates() -> None:
    text = shown(rod_pendulum.scene())
    assert "angle of the rod from the upright, counterclockwise" in text
    assert '<svg class="drawing"' in text
    # No line ends between a number and its unit.
    assert "10\u00a0m/s²" in text


@pytest.mark.campaign
def test_equations_that_are_no_formulas_say_so() -> None:
    text = shown(mechanics.derive(arm_seven_joints.scene(), "kane"))
    assert "kept as a program" in text
    assert len(text) < 10_000


@pytest.mark.campaign
def test_a_running_notebook_shows_them() -> None:
    from IPython.core.interactiveshell import InteractiveShell

    register()  # a plain interpreter has nothing to be told
    shell = InteractiveShell.instance()
    try:
        register()
        shown_as, _ = shell.display_formatter.format(rod_pendulum.scene())
    finally:
        InteractiveShell.clear_instance()
    assert "<svg" in shown_as["text/html"]
    assert len(shown_as["text/plain"]) < 200


@pytest.mark.campaign
def test_what_a_cell_ends_with_is_short() -> None:
    """Of every public class, of what public functions return, and of parts of a scene."""
    scene = rod_pendulum.scene()
    equations = mechanics.derive(scene, "lagrange")
    model = mechanics.compile(equations)
    linear = mechanics.linearize(equations, {"theta": 0}, inputs={"u": 0})
    result = mechanics.crosscheck(scene, mechanics.CrossCheck(("kane", "lagrange"), states=0))
    refuted = mechanics.check(scene, "l**2*m*theta'' = 0")
    disc = rolling_disc.scene()
    made = [
        scene, equations, model, linear, result, refuted, refuted.judged[0],
        mechanics.simulate(model, 0.1, samples=3), mechanics.modes(linear),
        mechanics.ensemble(model, 0.1, initial={"theta": [0.0, 0.5]}),
        mechanics.Feedback(lambda t, q, u: 0.0), mechanics.BlackBox(len), mechanics.CrossCheck(),
        *mechanics.Verdict, *(getattr(mechanics, name) for name in mechanics.__all__),
        *disc.bodies, *disc.loads, *disc.reactions, *disc.constraints, *disc.parameters,
        *EVERY, *(row for system in EVERY for row in system.published),
    ]  # fmt: skip
    long = {type(one).__name__: repr(one) for one in made if len(repr(one)) > 200}
    assert not long


def test_a_symbol_of_two_letters_is_one_symbol_in_a_matrix() -> None:
    equations = mechanics.derive(cartpole.scene())
    linear = mechanics.linearize(equations, {"x": 0, "theta": 0}, inputs={"F": 0})
    found = shown(linear)
    assert "<mi>mp</mi>" in found.replace(' mathvariant="normal"', "")
    assert "<mi>p</mi>" not in found
