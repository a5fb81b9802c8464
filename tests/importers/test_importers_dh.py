"""Arms by Denavit-Hartenberg parameters: both conventions, against matrices in numbers."""

import numpy as np
import pytest
from sympy import Symbol, pi

import mechanics
from mechanics.errors import InputError

BODY = {"mass": 1.5, "com": (0.1, -0.05, 0.02), "inertia": (0.02, 0.03, 0.04, 0.001, 0.002, -0.003)}
# The first four axes of a Stanford-like arm: two that turn, one that slides, one that turns.
ROWS = (
    {"a": 0.1, "alpha": -1.5708, "d": 0.4, "theta": "0.3"},
    {"alpha": pi / 2, "d": 0.15, "theta": 0.7},
    {"joint": "prismatic", "d": 0.3, "alpha": 0.2, "theta": -1.1},
    {"a": 0.05, "alpha": 1.1, "theta": pi / 3, "d": -0.1},
)


def turn(axis, angle):
    c, s = np.cos(angle), np.sin(angle)
    found = np.eye(4)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    found[j, j] = found[k, k] = c
    found[j, k], found[k, j] = -s, s
    return found


def move(x, y, z):
    found = np.eye(4)
    found[:3, 3] = x, y, z
    return found


def matrix(convention, row, q):
    a, alpha, d, theta = (float(row.get(key, 0)) for key in ("a", "alpha", "d", "theta"))
    alpha = -np.pi / 2 if alpha == -1.5708 else alpha
    theta, d = (theta, d + q) if row.get("joint") == "prismatic" else (theta + q, d)
    if convention == "standard":
        return turn(2, theta) @ move(0, 0, d) @ move(a, 0, 0) @ turn(0, alpha)
    return turn(0, alpha) @ move(a, 0, 0) @ turn(2, theta) @ move(0, 0, d)


@pytest.mark.campaign
@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_frames_and_energy_are_those_of_the_convention(convention):
    scene = mechanics.from_dh([row | BODY for row in ROWS], convention, symbolic=())
    assert scene.notes == ("read -1.5708 as -pi/2: row 1: alpha",)
    model = mechanics.compile(mechanics.derive(scene), outputs=["tool_position", "energy",
                              "tool_orientation", "mass_matrix"])  # fmt: skip
    q, u, zeros = np.array([0.2, -0.4, 0.1, 0.9]), np.array([0.3, 0.2, -0.5, 0.7]), np.zeros(4)

    def frames(q):
        found = [np.eye(4)]
        for row, own in zip(ROWS, q, strict=True):
            found.append(found[-1] @ matrix(convention, row, own))
        return found[1:]

    *_, last = frames(q)
    assert model.output("tool_position", q) == pytest.approx(last[:3, 3], abs=1e-14)
    assert model.output("tool_orientation", q) == pytest.approx(last[:3, :3], abs=1e-14)
    # T by differences of the frames: velocities of the mass centres, angular velocities.
    h, kinetic, height = 1e-6, 0.0, 0.0
    xx, yy, zz, xy, yz, xz = BODY["inertia"]
    moments = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    for now, ahead, back in zip(frames(q), frames(q + h * u), frames(q - h * u), strict=True):
        rate, centre = (ahead - back) / (2 * h), np.array([*BODY["com"], 1])
        skew = now[:3, :3].T @ rate[:3, :3]
        omega = np.array([skew[2, 1], skew[0, 2], skew[1, 0]])
        velocity = (rate @ centre)[:3]
        kinetic += (BODY["mass"] * velocity @ velocity + omega @ moments @ omega) / 2
        height += (now @ centre)[2]
    found = model.energy(q, u, p=[9.81], inputs=zeros)
    assert found["kinetic"] == pytest.approx(kinetic, rel=1e-8)
    zero = sum((now @ [*BODY["com"], 1])[2] for now in frames(zeros))
    rest = model.energy(zeros, zeros, p=[9.81], inputs=zeros)
    lifted = found["potential"] - rest["potential"]
    assert lifted == pytest.approx(BODY["mass"] * 9.81 * (height - zero), rel=1e-12)


def test_what_is_missing_becomes_parameters():
    scene = mechanics.from_dh([{"a": Symbol("L", positive=True)}, {"a": 0.5}])
    names = {symbol.name for symbol in scene.parameters}
    assert {"L", "m1", "m2", "Izz1", "cx2", "g"} <= names


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ([], "no rows"),
        ([(1, 0, 0, 0)], "row 1 is a tuple"),
        ([{"b": 1}], "row 1 has 'b'"),
        ([{"joint": "ball"}], "row 1: joint is 'ball'"),
        ([{"a": "nan"}], "row 1: a is 'nan'"),
        ([{"com": (1, 2)}], "row 1: com has 2 numbers"),
        ([{"a": 10**5000}], "row 1: a is a number of 16610 bits: give a number between 1e-308"),
        ([{"theta": pi / 10**5000}], "row 1: theta is a number of 16610 bits"),
        ([{"mass": "1" * 5000}], "row 1: mass is '1111"),
    ],
)
def test_rows_that_are_none_get_one_line(table, words):
    with pytest.raises(InputError, match=words):
        mechanics.from_dh(table)


def test_conventions_that_there_are_not_are_refused():
    with pytest.raises(InputError, match="standard"):
        mechanics.from_dh([{"a": 1}], "paul")
