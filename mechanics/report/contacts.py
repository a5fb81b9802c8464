"""Where bodies roll on the ground: what touches it there is at rest, and the contact moves on."""

import numpy as np
from numpy.typing import NDArray
from sympy import Matrix
from sympy.physics.vector import Point

from mechanics.report.projection import View, closed
from mechanics.scene import Body, RigidBody, Scene

SMALL = 1e-9
"""Velocities per rate of a coordinate that are none."""
LONG = 4
"""Letters of the name of a point that no drawing shows: a joint makes it."""


def rolling_words(scene: Scene) -> str:
    """Which bodies roll without slip, and where, as prose with LaTeX; empty where none does.

    The point of a body that coincides with a contact has no velocity in any motion that the
    constraints admit, though the contact itself moves.
    """
    example = dict(scene.example)
    other = {q.name: example.get(q.name, 0.0) + 0.1 + 0.03 * k for k, q in enumerate(scene.q)}
    views = [View(scene, closed(scene, state)) for state in (example, other)]
    contacts = dict.fromkeys(
        (r.on, r.at) for r in scene.reactions if r.by is None and r.at is not None and not r.parts
    )
    if not contacts:
        return ""
    admitted = [(view, _admitted(view)) for view in views]
    return " ".join(
        _sentence(name, at)
        for name, at in contacts
        if all(_rolls(view, free, scene.body(name), at) for view, free in admitted)
    )


def _sentence(name: str, at: Point) -> str:
    place = f"$<<{at.name}>>$" if len(at.name) < LONG else "the contact"
    return (
        f"The {name.replace('_', ' ')} rolls without slip: the point of it that is at {place} is at"
        f" rest, while {place} moves on."
    )


def _rolls(view: View, free: NDArray[np.float64], body: Body, at: Point) -> bool:
    """Whether the point of a body that is at the contact rests while the contact moves."""
    if not isinstance(body, RigidBody):
        return False
    scene = view.scene
    arm = view.frame(body.frame).T @ (view.place(at) - view.place(body.centre))
    contact, centre = scene.position(at), scene.position(body.centre)
    turned = scene.rotation(body.frame)
    moves = np.column_stack([view.numbers(contact, q).ravel() for q in scene.q])
    own = np.column_stack(
        [view.numbers(centre, q).ravel() + view.numbers(turned, q) @ arm for q in scene.q]
    )
    return bool(np.abs(own @ free).max() < SMALL < np.abs(moves @ free).max())


def _admitted(view: View) -> NDArray[np.float64]:
    """The matrix that leaves of any rates those which the constraints admit."""
    rows = _constraints(view)
    admitted: NDArray[np.float64] = np.eye(rows.shape[1]) - np.linalg.pinv(rows) @ rows
    return admitted


def _constraints(view: View) -> NDArray[np.float64]:
    """Rows that the rates of the coordinates are normal to."""
    scene = view.scene
    rows = [np.zeros(len(scene.q))]
    for constraint in scene.constraints:
        expression = scene.rates(constraint.expression)
        by = scene.q if constraint.holonomic else scene.qd
        rows.append(view.numbers(Matrix([[expression.diff(s) for s in by]])).ravel())
    return np.array(rows)
