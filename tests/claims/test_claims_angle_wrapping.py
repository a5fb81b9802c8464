"""A step that brings an angle back into one turn, and rates of a state as an argument."""

from pathlib import Path

import pytest
from sympy import sin
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from benchmarks.corpus.builders import P, pendulum
from benchmarks.corpus.load import HERE, scene_of
from mechanics.errors import InputError
from tests.verdict_of import NOT_READ, verdict_in

STEP = """function x = step(x, u, dt, M, m, l)
g = 9.81;
v = x(2);
th = x(3);
w = x(4);
a = (-l*m*sin(th)*w^2 + u + g*m*cos(th)*sin(th))/(M + m - m*cos(th)^2);
b = (-l*m*cos(th)*sin(th)*w^2 + u*cos(th) + g*m*sin(th) + M*g*sin(th))/(l*(M + m - m*cos(th)^2));
x = x + dt*[v; a; w; b];
%s
end
"""


def _verdict(scene: str, text: str, folder: Path) -> str:
    file, _, function = scene.partition(":")
    return verdict_in(scene_of(HERE / "scenes" / file, function), "own.m", text, folder)


CART = "carts_with_friction.py:left"
WRAPS = (
    "x(3) = wrapToPi(x(3));", "x(3) = mod(x(3) + pi, 2*pi) - pi;", "x(3) = mod(x(3), 2*pi);",
    "x(3) = mod(x(3), 4*pi);",
)  # fmt: skip


@pytest.mark.parametrize("wrap", WRAPS)
def test_an_angle_without_whole_turns_is_the_same(wrap: str, tmp_path: Path) -> None:
    assert _verdict(CART, STEP % wrap, tmp_path) == "PROVED"
    wrong = (STEP % wrap).replace("+ M*g*sin(th)", "- M*g*sin(th)")
    assert _verdict(CART, wrong, tmp_path) == "REFUTED"


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    "wrap",
    ["x(1) = wrapToPi(x(1));", "x(4) = wrapToPi(x(4));", "x(3) = mod(x(3), pi);",
     "x(3) = mod(x(3), 2*pi) + 1;", "x(3) = mod(x(3), 2*3.14159265358979);",
     "x(3) = wrapToPi(-x(3));", "x(3) = mod(2*x(3), 2*pi)/2;"],
)  # fmt: skip
def test_what_is_no_whole_turn_of_an_angle_counts(wrap: str, tmp_path: Path) -> None:
    assert _verdict(CART, STEP % wrap, tmp_path) not in ("PROVED", "CERTIFIED")


SPRING = """function x = step(x, dt, m, l, g, k)
th = x(1);
w = x(2);
x = x + dt*[w; -g/l*sin(th) - k*%s/(m*l^2)];
%s
end
"""


@pytest.mark.parametrize(("of", "shown"), [("th", False), ("sin(th)", True)])
def test_turns_count_where_a_spring_counts_them(of: str, shown: bool, tmp_path: Path) -> None:
    (th,) = dynamicsymbols("th,")
    m, length, g, k = P("m:kg l:m g:m/s^2 k:N*m")
    moment = -k * (sin(th) if of == "sin(th)" else th)
    scene = pendulum(th, m, 0, length, g, moment)
    path = tmp_path / "own.m"
    for wrap, right in (("", True), ("x(1) = wrapToPi(x(1));", shown)):
        path.write_text(SPRING % (of, wrap))
        try:
            verdict = mechanics.check(scene, path, blame=False).verdict.name
        except InputError:
            verdict = ""
        assert (verdict == "PROVED") is right


ARGUMENTS = """function phi = pend(z, %s, t)
global m1 m2 l1 l2 g
M = [1, 0, 0, 0; 0, 1, 0, 0;
     0, 0, l1^2*(m1+m2), m2*l1*l2*cos(z(1)-z(2));
     0, 0, l1*cos(z(1)-z(2)), l2];
V = [-z(3); -z(4);
     m2*l1*l2*z(4)^2*sin(z(1)-z(2)) + g*l1*(m1+m2)*sin(z(1));
     -l1*z(3)^2*sin(z(1)-z(2)) + g*sin(z(2))];
phi = M*[%s(1); %s(2); %s(3); %s(4)] + V;
end
"""
PLAIN = "rigid_pendulums.py:plain"


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["zdot", "zp", "z_dot", "dz", "dzdt"])
def test_residuals_take_the_rates_of_their_state(name: str, tmp_path: Path) -> None:
    text = ARGUMENTS % ((name,) * 5)
    assert _verdict(PLAIN, text, tmp_path) == "PROVED"
    for right, wrong in (("+ g*sin", "- g*sin"), ("m2*l1*l2*cos", "m1*l1*l2*cos")):
        assert _verdict(PLAIN, text.replace(right, wrong), tmp_path) == "REFUTED"


@pytest.mark.parametrize(
    ("right", "other"),
    [("-z(3);", "z(3);"), ("M = [1, 0", "M = [1, 1"), ("phi = M", "phi = 0*M"),
     ("-z(3); -z(4)", "-z(4); -z(3)")],
)  # fmt: skip
def test_rows_that_say_another_thing_of_speeds_are_not_shown(
    right: str, other: str, tmp_path: Path
) -> None:
    text = ARGUMENTS % (("zdot",) * 5)
    assert right in text
    assert _verdict(PLAIN, text.replace(right, other), tmp_path) not in ("PROVED", "CERTIFIED")


@pytest.mark.parametrize("name", ["ydot", "w", "rates"])
def test_another_name_is_not_taken_for_the_rates(name: str, tmp_path: Path) -> None:
    assert _verdict(PLAIN, ARGUMENTS % ((name,) * 5), tmp_path) == NOT_READ
