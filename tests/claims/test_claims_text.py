"""Plain text in SymPy's or MATLAB's notation, read and judged."""

import re
from pathlib import Path

import pytest
from sympy import Eq, Expr
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from mechanics import check
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import elastic_pendulum, pendulum_chain, rod_pendulum, rolling_disc

T = dynamicsymbols._t

PENDULUM = derived(elastic_pendulum.scene())
CART = derived(pendulum_chain.scene(1))
DISC = derived(rolling_disc.scene())


@pytest.mark.parametrize(
    "text",
    [
        "(M + m)*x.diff(t, 2) + 2*k*x + M*L/2*(thetadd*cos(theta) - thetad**2*sin(theta)) = 0",
        "eq = Eq((M + m)*Derivative(x(t), (t, 2)) + 2*k*x(t) + M*L/2*(theta(t).diff(t, t)*"
        "sp.cos(theta(t)) - theta(t).diff(t)**2*sp.sin(theta(t))), 0)",
        "(M+m)*diff(x(t),t,2) + 2*k*x(t) == -M.*L/2.*(diff(theta,t,2)*cos(theta) ...\n"
        "   - diff(theta,t).^2.*sin(theta));  % comment",
        "(M + m)*x'' + 2*k*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta))",
        "(M + m)·ẍ + 2k·x + Rational(1, 2)*M*L*(θ̈*cos(θ) − θ̇²*sin(θ)) = 0",
        "xdd = -(2*k*x + 0.5*M*L*(theta_ddot*cos(theta) -\n theta_dot**2*sin(theta)))/(M + m)",
        "s = sin(theta)\nc = cos(theta)\n(M+m)*xdd + 2*k*x + M*L/2*(thetadd*c - thetad^2*s) = 0",
    ],
)
def test_ways_to_write_equation_six(text: str) -> None:
    found = mechanics.check(PENDULUM, text, notation="text")
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"]


def test_matrices_of_matlab_and_python() -> None:
    for text in (
        "[M+m M*L/2*cos(theta); M*L/2*cos(theta) M*L^2/3]",
        "[M + m, M*L/2*cos(theta)\n M*L/2*cos(theta), M*L^2/3]",
        "np.array([[M + m, M*L/2*np.cos(theta)],\n  [M*L/2*np.cos(theta), M*L**2/3]])",
        "Matrix([[M + m, M*L/2*cos(theta)], [M*L/2*cos(theta), M*L**2/3]])",
    ):
        found = mechanics.check(PENDULUM, text, notation="text")
        assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"]
    both = mechanics.check(
        PENDULUM,
        "[M+m M*L/2*cos(theta); M*L/2*cos(theta) M*L^2/3]*[xdd; thetadd] ="
        " [M*L/2*thetad^2*sin(theta) - 2*k*x; -M*g*L/2*sin(theta)]",
    )
    assert [entry.finding.verdict.name for entry in both.judged] == ["PROVED", "PROVED"]


def test_names_are_matched_and_told() -> None:
    text = "(mc + mp)*s'' - mp*l*(phi''*cos(phi) - phi'^2*sin(phi)) = u"
    given = mechanics.check(CART, text, names={"mc": "m0", "mp": "m1"})
    assert given.ok
    meanings = {match.name: match.meaning for match in given.names}
    assert meanings == {"mc": "m0", "mp": "m1", "s": "q0", "l": "l0", "phi": "q1", "u": "F"}
    assert all(match.guessed for match in given.names if match.name not in ("mc", "mp"))
    doubtful = mechanics.check(CART, text)
    (entry,) = doubtful.judged
    assert entry.finding.verdict.name == "UNDECIDED"
    assert entry.finding.evidence.startswith("mc, mp: the scene has no such name")


@pytest.mark.campaign
def test_rates_of_declared_speeds() -> None:
    text = "u2' = -2*u1*u3/3\nu3.diff() = (u3*tan(lean) - 2*u2)*u1\nu2' = 2*u1*u3/3"
    found = mechanics.check(DISC, text)
    verdicts = [entry.finding.verdict.name for entry in found.judged]
    assert verdicts[0] in ("PROVED", "CERTIFIED")
    assert verdicts[1] in ("PROVED", "CERTIFIED")
    assert verdicts[2] == "REFUTED"


def test_the_wrong_ones_of_others_are_refuted() -> None:
    """A parallel axis counted twice; th^2 where th'^2 belongs."""
    right = (
        "T = (F + mp*l*w^2*sin(th))/M\nM = m0 + mp\n"
        "wd = (g*sin(th) - T*cos(th))/(l*(1 - mp*cos(th)^2/M))"
    )
    text = "M = m0 + mp\n" + right.replace("\nM = m0 + mp", "")
    names = {"w": "q1_dot", "wd": "q1_ddot", "th": "q1", "mp": "m1", "l": "l0"}
    signs = {"F": "F"}
    for written, verdict in (
        (text.replace("(F +", "(-F +"), "PROVED"),
        (text, "REFUTED"),
        (text.replace("(F +", "(-F +").replace("l*w^2", "l*th^2"), "REFUTED"),
    ):
        found = mechanics.check(CART, written, names=names | signs)
        (entry,) = found.judged
        assert entry.finding.verdict.name == verdict


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("x = __import__('os').system('true')", "line 1, column"),
        ("x = open(F)", "column 5: the function open is not supported"),
        ("x = (lambda: 1)()", "line 1, column"),
        ("x + \n3 = (", "line"),
        ("x = 9**9**9", "column 5: the exponent is too large"),
        ("x = 2**(10**3)", "too large"),
        ("x = 1e999999", "line 1, column"),
        ("x = " + "(" * 5000 + "1" + ")" * 5000, "nested too deeply"),
        ("x = " + "-" * 5000 + "1", "nested too deeply"),
        ("x = sin(1, 2)", "sin with 2 arguments"),
        ("x = log(0)", "no finite real value"),
        ("x.diff(t, 7) = 0", "a derivative of order 7"),
        ("x.diff(y) = 0", "a derivative is by the time t"),
        ("[1, 2; 3] = x", "not equally long"),
        ("\x00\x01", "line 1, column 1"),
    ],
)
def test_what_cannot_be_read_is_one_line_with_its_place(text: str, words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        mechanics.check(PENDULUM, text, notation="text")
    assert "\n" not in str(caught.value)


JULIA = """function f!(dy, y, p, t)
  theta, theta_dot = y
  dy[1] = theta_dot
  dy[2] = 3g/(2l)*sin(theta){}3u/(m*l^2){}
end
"""


@pytest.mark.parametrize(
    ("between", "behind", "ok"),
    [
        (" + ", " #= + 0 =#", True),
        (" + ", " #= + 0 =# * 2", False),
        (" + ", " # * 2", True),
        (" +\n    ", "", True),
        ("\n    + ", "", False),
    ],
)
def test_a_line_of_julia_ends_where_julia_ends_it(between: str, behind: str, ok: bool) -> None:
    text = JULIA.format(between, behind)
    assert check(rod_pendulum.scene(), text, notation="text", blame=False).ok is ok


@pytest.mark.parametrize("moment", [0, 2 * T, T + 1, rod_pendulum.m])
def test_a_function_of_another_moment_is_no_coordinate(moment: Expr) -> None:
    pendulum = rod_pendulum
    right = pendulum.PUBLISHED[0].sides[1]
    angle = pendulum.theta.diff(T, 2)
    assert check(pendulum.scene(), Eq(angle, right), blame=False).ok
    assert not check(pendulum.scene(), Eq(angle, right.subs(T, moment)), blame=False).ok


@pytest.mark.sample(8)
@pytest.mark.parametrize("sign", ["\ue000", "\ue001", "\uf8ff", "\U000f0001"])
@pytest.mark.parametrize("name", ["", "a.tex", "a.txt", "a.m", "a.jl", "a.c", "a.cpp"])
def test_characters_for_private_use_are_refused(sign: str, name: str, tmp_path: Path) -> None:
    text = f"theta'' = 3*g/(2*l)*sin(theta)\n  + {sign}u"
    (tmp_path / (name or "a.txt")).write_text(text)
    with pytest.raises(InputError, match=r"line 2, column 5: U\+[0-9A-F]{4,5} is a character for"):
        check(rod_pendulum.scene(), tmp_path / name if name else text)


@pytest.mark.parametrize(("name", "sign"), [("a.m", "%"), ("a.txt", "#"), ("a.md", "%")])
def test_a_right_side_that_is_a_comment_is_told(name: str, sign: str, tmp_path: Path) -> None:
    right = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
    (tmp_path / name).write_text(f"{right}\ntheta'' {sign} = -3*g/(2*l)*sin(theta)\n")
    told = check(rod_pendulum.scene(), tmp_path / name, blame=False).unjudged
    assert "line 2: = -3*g/(2*l)*sin(theta), which is a comment" in told
    (tmp_path / name).write_text(f"{right} {sign} = what Newton says\n")
    told = check(rod_pendulum.scene(), tmp_path / name, blame=False).unjudged
    assert not any("which is a comment" in words for words in told)


ROD = derived(rod_pendulum.scene())


@pytest.mark.parametrize(
    ("rate", "by_angle", "momentum"),
    [
        ("d/dt[dL/d[dtheta/dt]]", "dL/dtheta", "d/dt[m*l^2/3*dtheta/dt]"),
        ("d/dt(dL/d(dtheta/dt))", "dL/dtheta", "d/dt(m*l^2/3*dtheta/dt)"),
        ("d/dt[∂L/∂θ']", "∂L/∂θ", "m*l^2/3*d^2/dt^2 theta"),
    ],
)
def test_derivatives_of_brackets_by_rates_and_before_names(
    rate: str, by_angle: str, momentum: str
) -> None:
    text = (
        "L = m*l^2/6*(dtheta/dt)^2 - m*g*l/2*cos theta\n"
        f"{rate} = {by_angle} + u\n"
        f"{momentum} = u + m*g*l/2*sin theta"
    )
    found = mechanics.check(ROD, text, notation="text")
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"] * 3
    wrong = mechanics.check(
        ROD, text.replace("u + m", "u - m").replace(f"= {by_angle}", f"= -{by_angle}"),
        notation="text", blame=False,
    )  # fmt: skip
    assert [entry.finding.verdict.name for entry in wrong.judged] == [
        "PROVED",
        "REFUTED",
        "REFUTED",
    ]


def test_an_operator_of_another_power_below_is_no_derivative() -> None:
    found = mechanics.check(ROD, "d^2/dt theta = 3*g/(2*l)*sin(theta)", notation="text")
    assert [entry.finding.verdict.name for entry in found.judged] == ["UNDECIDED"]


@pytest.mark.parametrize("words", ["acceleration", "the angular acceleration", "Acceleration"])
def test_a_word_before_a_name_says_what_it_is(words: str) -> None:
    scene = rod_pendulum.scene()
    plain = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
    assert check(scene, plain, blame=False).verdict.name == "PROVED"
    told = f"torque {plain.replace('3*u', '6*u')}"
    assert check(scene, f"{words} {plain}", blame=False).verdict.name == "PROVED"
    assert check(scene, told, blame=False).verdict.name == "REFUTED"
    product = f"{words.split()[-1]} + {plain}"
    assert check(scene, product, blame=False).verdict.name == "UNDECIDED"
