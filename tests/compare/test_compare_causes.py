"""Causes of the table that no thread above has, together, and what has none."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import numpy_trees as other
import pytest
import small_trees

from mechanics.compare import compare
from mechanics.kernel import Verdict

ARM = other.answers(other.arm_joints(2))


def flipped() -> dict[str, Callable[..., Any]]:
    S = np.array([1.0, -1.0])
    return {
        "mass_matrix": lambda q, v: S[:, None] * ARM["mass_matrix"](S * q, v) * S,
        "inverse_dynamics": lambda q, v, a: S * ARM["inverse_dynamics"](S * q, S * v, S * a),
    }


def exchanged() -> dict[str, Callable[..., Any]]:
    return {"bias": lambda q, v: ARM["bias"](q[::-1], v[::-1])[::-1]}


def implicit(h: float = 0.002, b: float = 0.4) -> dict[str, Callable[..., Any]]:
    damped = other.answers(other.arm_joints(2), added=lambda q, v, a: b * v)

    def forward(q: Any, v: Any, f: Any) -> Any:
        whole = damped["mass_matrix"](q, v) + h * b * np.eye(2)
        return np.linalg.solve(whole, f - damped["bias"](q, v))

    return {"bias": damped["bias"], "forward_dynamics": forward}


def one_locked() -> dict[str, Callable[..., Any]]:
    def answer(q: Any, v: Any) -> Any:
        return ARM["mass_matrix"](np.array([q[0], np.pi / 2]), v)[:1, :1]

    return {"mass_matrix": answer}


def fingers() -> dict[str, Callable[..., Any]]:
    """Two pendulums, which know nothing of each other."""

    def inverse(q: Any, v: Any, a: Any) -> Any:
        found = []
        for i, mass in enumerate((2.5, 3.0)):
            c, inertia = other.CENTRE, other.INERTIA
            R = other.turn(1, q[i])
            whole = inertia[1, 1] + mass * (c[0] ** 2 + c[2] ** 2)
            found.append(whole * a[i] - np.cross(R @ c, mass * other.GRAVITY)[1])
        return np.array(found)

    def forward(q: Any, v: Any, f: Any) -> Any:
        rest = inverse(q, v, np.zeros(2))
        return (f - rest) / (inverse(q, v, np.ones(2)) - rest)

    return {"inverse_dynamics": inverse, "forward_dynamics": forward}


def gravity(*field: float) -> Callable[[], dict[str, Callable[..., Any]]]:
    def answers() -> dict[str, Callable[..., Any]]:
        own = other.answers(other.arm_joints(2), gravity=np.array(field))
        return {"bias": own["bias"]}

    return answers


def reversed_speeds() -> dict[str, Callable[..., Any]]:
    S = np.array([1.0, -1.0])
    return {"inverse_dynamics": lambda q, v, a: S * ARM["inverse_dynamics"](q, S * v, S * a)}


def rubbing() -> dict[str, Callable[..., Any]]:
    own = other.answers(other.arm_joints(2), added=lambda q, v, a: 0.2 * np.sign(v))
    return {"bias": own["bias"]}


def undamped() -> dict[str, Callable[..., Any]]:
    return {"bias": ARM["bias"]}


def unsprung() -> dict[str, Callable[..., Any]]:
    own = other.answers(other.arm_joints(2), added=lambda q, v, a: 0.4 * v)
    return {name: own[name] for name in ("bias", "inverse_dynamics", "forward_dynamics")}


def stale() -> dict[str, Callable[..., Any]]:
    """The buffer is read before it is filled."""
    kept: list[Any] = [np.zeros((2, 2))]

    def answer(q: Any, v: Any) -> Any:
        kept.append(ARM["mass_matrix"](q, v))
        return kept[-2]

    return {"mass_matrix": answer}


def lighter() -> dict[str, Callable[..., Any]]:
    one, two = other.arm_joints(2)
    own = other.answers([one, replace(two, mass=2.5)])
    return {name: own[name] for name in ("mass_matrix", "inverse_dynamics")}


def heavy_tool() -> dict[str, Callable[..., Any]]:
    own = other.answers(other.with_tool(other.arm_joints(2)))
    return {name: own[name] for name in ("mass_matrix", "inverse_dynamics")}


def both() -> dict[str, Callable[..., Any]]:
    own = other.answers(other.arm_joints(2), gravity=-other.GRAVITY, added=lambda q, v, a: 0.1 * a)
    return {name: own[name] for name in ("mass_matrix", "inverse_dynamics")}


CASES = {
    "sign": (lambda: small_trees.arm(2), flipped, ("sign of a joint axis",), "q2 point the other"),
    "order": (lambda: small_trees.arm(2), exchanged, ("order of the joints",), "q2, q1"),
    "implicit": (lambda: small_trees.arm(2, "0.4"), implicit, ("implicit integration",),
                 "an implicit step of 0.002 s"),
    "locked": (lambda: small_trees.arm(2), one_locked, ("locked joint",), "q2 is locked at 1.5708"),
    "mimic": (small_trees.gripper, fingers, ("mimic ignored",), "left out: mimic"),
    "sign of gravity": (lambda: small_trees.arm(2), gravity(0, 0, 9.81), ("gravity",),
                        "opposite sign"),
    "size of gravity": (lambda: small_trees.arm(2), gravity(0, 0, -9.8), ("gravity",),
                        "another size: (0, 0, -9.8) in place of (0, 0, -9.81)"),
    "no gravity": (lambda: small_trees.arm(2), gravity(0, 0, 0), ("gravity",), "left out"),
    "gravity along y": (lambda: small_trees.arm(2), gravity(0, -9.81, 0), ("gravity",),
                        "another direction: (0, -9.81, 0)"),
    "reversed speeds": (lambda: small_trees.arm(2), reversed_speeds, ("sign of a joint axis",),
                        "q2 point the other way for speeds and forces, not for angles"),
    "dry friction": (lambda: small_trees.arm(2), rubbing, ("dry friction",),
                     "joints rub: 0.2 N m at q1, 0.2 N m at q2"),
    "no damping": (lambda: small_trees.arm(2, "0.4"), undamped, ("joint damping",),
                   "damping of joints is left out: 0.4 N m s/rad at q1"),
    "stale": (lambda: small_trees.arm(2), stale, ("not computed",),
              "mass_matrix is that of the state before"),
    "mass": (lambda: small_trees.arm(2), lighter, ("mass",),
             "2.5 in place of 3 kg of link2"),
    "no spring": (small_trees.sprung, unsprung, ("a load left out",),
                  "left out of the loads: spring"),
    "a default": (lambda: small_trees.arm(2, tool=True), heavy_tool, ("a link without inertia",),
                  "are given 1 kg and 1 kg m^2: tool"),
}  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("case", CASES)
def test_a_cause_is_named(case: str) -> None:
    scene, answers, names, words = CASES[case]
    found = compare(scene(), answers(), states=5)
    assert not found.agree and not found.unexplained
    (cause,) = found.causes
    assert cause.names == names and words in cause.words
    assert cause.finding.verdict is Verdict.SUPPORTED


@pytest.mark.campaign
def test_two_causes_together_are_named() -> None:
    (cause,) = compare(small_trees.arm(2), both(), states=5).causes
    assert cause.names == ("gravity", "armature")
    assert "opposite sign: (0, 0, 9.81)" in cause.words and "0.1 kg m^2 at q2" in cause.words


@pytest.mark.campaign
def test_two_quantities_may_differ_for_causes_of_their_own() -> None:
    """M is half filled, and the forward dynamics is damped."""
    damped = other.answers(other.arm_joints(2), added=lambda q, v, a: 0.3 * v)
    answers = {
        "mass_matrix": lambda q, v: np.tril(ARM["mass_matrix"](q, v)),
        "bias": ARM["bias"],
        "inverse_dynamics": damped["inverse_dynamics"],
    }
    found = compare(small_trees.arm(2), answers, states=5)
    assert {cause.names[0]: cause.quantities for cause in found.causes} == {
        "upper triangle only": ("mass_matrix",),
        "joint damping": ("inverse_dynamics",),
    }


@pytest.mark.campaign
def test_what_no_row_explains_is_said_to_be_unexplained() -> None:
    odd = other.answers(other.arm_joints(2), added=lambda q, v, a: np.sin(q))
    found = compare(small_trees.arm(2), {"bias": odd["bias"]}, states=5)
    assert found.causes == () and found.unexplained == ("bias",)
    (row,) = found.rows
    assert row.finding.verdict is Verdict.REFUTED
    assert row.finding.witness is not None and dict(row.finding.witness.state).keys() == {
        "q1", "q2", "q1_dot", "q2_dot",
    }  # fmt: skip


def test_a_cause_that_would_break_what_agrees_is_none() -> None:
    """Gravity of the other sign explains the bias, but the inverse dynamics has it right."""
    up = other.answers(other.arm_joints(2), gravity=-other.GRAVITY)
    answers = {"bias": up["bias"], "inverse_dynamics": ARM["inverse_dynamics"]}
    found = compare(small_trees.arm(2), answers, states=5)
    (cause,) = found.causes
    assert cause.quantities == ("bias",) and "(bias alone)" in cause.words
