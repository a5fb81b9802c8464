"""How far the argument of a function without brackets goes: as far as it has no dimension."""

import pytest

from tests.notation_scenes import judged, verdicts

FORCED = r"m\ddot x + c\dot x + kx = "
TYPED = "m*x'' + c*x' + k*x = "
SWING = r"l\ddot\theta + "


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("name", "right", "wrong"),
    [
        ("oscillator", FORCED + r"F_0\cos\omega t", FORCED + r"F_0\cos\omega"),
        ("oscillator", FORCED + r"F_0\cos\omega t", FORCED + r"F_0\sin\omega t"),
        ("oscillator", FORCED + r"\cos\omega t\, F_0", FORCED + r"\cos\omega t\,F_0 2"[:-2] + "/2"),
        ("oscillator", FORCED + r"F_0\cos\gamma t", FORCED + r"F_0\sin\gamma t"),
        ("oscillator", FORCED + r"F_0\cos\Omega t", FORCED + r"2F_0\cos\Omega t"),
        ("oscillator", FORCED + r"F_0\cos wt", FORCED + r"F_0\cos 2wt"),
        (
            "oscillator",
            FORCED + r"F_0\cos 2\pi t/T, \quad T = 2\pi/\omega",
            FORCED + r"F_0\cos 2\pi t/T, \quad T = \pi/\omega",
        ),
        (
            "oscillator",
            FORCED + r"F_0(1 - 2\sin^2\tfrac12\omega t)",
            FORCED + r"F_0(1 - 2\sin^2\omega t)",
        ),
        ("pendulum", SWING + r"\sin\theta g = 0", SWING + r"\sin\theta l = 0"),
        (
            "pendulum",
            r"\frac{d}{dt}(\cos\theta\dot\theta)"
            r" = -\sin\theta\dot\theta^2 - \frac gl\sin\theta\cos\theta",
            r"\frac{d}{dt}(\cos\theta\dot\theta)"
            r" = \sin\theta\dot\theta^2 - \frac gl\sin\theta\cos\theta",
        ),
        (
            "pendulum",
            r"2l\ddot\theta\cos\theta + \sin 2\theta g = 0",
            r"2l\ddot\theta\cos\theta + \sin\theta 2g = 0",
        ),
        (
            "pendulum",
            r"\phi = 2\theta,\quad l\ddot\theta + \frac{\sin\phi g}{2\cos\theta} = 0",
            r"\phi = 2\theta,\quad l\ddot\theta + \frac{\sin\phi g}{\cos\theta} = 0",
        ),
        ("oscillator", TYPED + "F0*cos omega t", TYPED + "F0*sin omega t"),
        ("oscillator", TYPED + "F0*cos wt", TYPED + "F0*cos w"),
        ("oscillator", TYPED + "F0*cos(wt)", TYPED + "F0*cos(2*wt)"),
        (
            "oscillator",
            TYPED + "F0*(cos^2 (omega/2*t) - sin^2(omega*t/2))",
            TYPED + "F0*(cos^2 (omega/2*t) + sin^2(omega*t/2))",
        ),
        ("pendulum", "l*theta'' + g*sin theta = 0", "l*theta'' + g*sin 2 theta = 0"),
        (
            "pendulum",
            "2*l*theta''*cos theta + g*sin 2theta = 0",
            "2*l*theta''*cos theta + g*sin theta = 0",
        ),
        ("pendulum", "l*\u03b8'' + g*sin\u03b8 = 0", "l*\u03b8'' + g*sin\u03b8*2 = 0"),
    ],
)
def test_the_argument_is_what_has_no_dimension(name: str, right: str, wrong: str) -> None:
    assert verdicts(name, right) == ["PROVED"]
    assert verdicts(name, wrong) == ["REFUTED"]
    assert not [h for e in judged(name, wrong).judged for h in e.right_if if "argument" in h]


def test_how_it_was_read_is_told() -> None:
    (entry,) = judged("oscillator", FORCED + r"F_0\cos\omega t").judged
    assert r"\cos omega t is read as cos(omega t)" in entry.statement.notes
