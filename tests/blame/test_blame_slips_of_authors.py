"""Slips that authors make, named where they stand: exchanged names, |v| v, a cotangent, a half."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from sympy import Rational, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, of_one_particle, on_walls, pendulum
from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.blame.result import Edit, Mistake
from mechanics.scene import Scene, force, gravity
from systems import bead_on_hoop, spinning_top

TYPED = HERE / "scenes" / "typed.py"


def edits(scene: str, text: str) -> tuple[Edit, ...]:
    """Of the first repair."""
    (entry,) = (e for e in check(scene_of(TYPED, scene), text).judged if not e.finding.shown)
    assert entry.blame is not None and entry.blame.repairs
    return entry.blame.repairs[0].edits


MOMENTUM = r"p_\phi = (I_3\sin^2\theta + I_1\cos^2\theta)\dot\phi + I_3\dot\psi\cos\theta"


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("scene", "text", "mistake", "right"),
    [
        ("cone", r"U = mgr\tan\alpha", Mistake.FUNCTION, r"\cot \alpha"),
        ("cone", r"U = mgr\sin\alpha/\sin\alpha", Mistake.FUNCTION, r"\cos \alpha"),
        ("quadratic", r"m\ddot x + b\dot x^2 + kx = 0", Mistake.POWER,
         r"\left|\dot x\right| \dot x"),
        ("orbit", r"r\ddot\theta + \dot r\dot\theta = 0", Mistake.FACTOR, r"2 \dot r \dot\theta"),
        ("top", r"V = Mgl\sin\theta", Mistake.FUNCTION, r"\cos \theta"),
        ("parabola", r"\ddot x + \frac{2agx}{1+4a^2x^2} = 0", Mistake.MISSING,
         r"+ \frac{4 a^{2} x \dot{x}^{2}}{1+4a^2x^2}"),
    ],
)  # fmt: skip
def test_one_edit(scene: str, text: str, mistake: Mistake, right: str) -> None:
    (edit,) = edits(scene, rf"\[ {text} \]")
    assert (edit.mistake, edit.right) == (mistake, right)


def test_two_names_are_exchanged_in_one_bracket() -> None:
    found = edits("top", rf"\[ {MOMENTUM} \]")
    assert [(e.written, e.right) for e in found] == [("I_3", "I_{1}"), ("I_1", "I_{3}")]


def test_a_factor_in_a_sum_below_a_sine() -> None:
    text = (
        "theta_1'' = -(g*(2*m_1 + m_2)*sin(theta_1) + m_2*(g*sin(theta_1 - theta_2)"
        " + 2*(L_2*theta_2'^2 + L_1*theta_1'^2*cos(theta_1 - theta_2))*sin(theta_1 - theta_2)))"
        "/(2*L_1*(m_1 + m_2 - m_2*cos(theta_1 - theta_2)^2))"
    )
    (edit,) = edits("two_rods", text)
    assert (edit.written, edit.right) == ("theta_2", "2*theta_2")


def test_a_length_that_turns_a_wheel_is_no_angle() -> None:
    text = r"E = \frac12 (m_1 + m_2 + I/R^2)\dot x^2 + (m_2 + m_1) g x"
    (edit,) = edits("atwood", rf"\[ {text} \]")
    assert edit.mistake is Mistake.SIGN


def _first(scene: Scene, text: str) -> list[tuple[str, str]]:
    """What is written and right, of the first repair of the first statement that is refuted."""
    entry = next(e for e in check(scene, text).judged if e.blame is not None)
    assert entry.blame is not None and entry.blame.repairs
    return [(edit.written, edit.right) for edit in entry.blame.repairs[0].edits]


def on_an_arc() -> Scene:
    """A bead in a circular bowl of radius R, by its arc s from the lowest point."""
    s, (m, R, g) = dynamicsymbols("s"), P("m:kg R:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    out = sin(s / R) * N.x - cos(s / R) * N.y
    C = O.locatenew("C", R * out)
    weight = gravity(-g * N.y)
    return of_one_particle("bowl", N, O, (s,), ("bead", C, m), (weight,), F_N=-out, side=N.z)


def attracted() -> Scene:
    """A planet in its plane, drawn to the origin by mu/r^2."""
    (x, y), (m, mu) = dynamicsymbols("x y"), P("m:kg mu:m^3/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + y * N.y)
    pull = force("pull", C, -m * mu * (x * N.x + y * N.y) / (x**2 + y**2) ** Rational(3, 2), on="p")
    return of_one_particle("planet", N, O, (x, y), ("p", C, m), (pull,), side=N.z)


@pytest.mark.parametrize(
    ("scene", "text", "edit"),
    [
        (on_an_arc, "s'' = -g*sin(s)", ("s", "s/R")),
        (attracted, "x'' = -mu*x/(x^2 + y^2)", ("x^2 + y^2", "((x^2 + y^2)^(3/2))")),
        (attracted, "y'' = -mu/y^2", ("-mu/y^2", "-y*mu/((x^2 + y^2)^(3/2))")),
        (attracted, "x'' = -mu*x/(x^2 + y^2)^(5/2)", ("(x^2 + y^2)^(5/2)", "((x^2 + y^2)^(3/2))")),
    ],
)
def test_a_radius_is_divided_by(
    scene: Callable[[], Scene], text: str, edit: tuple[str, str]
) -> None:
    assert _first(scene(), text) == [edit]


def driven() -> Scene:
    """A bob of a rod without mass, turned by a moment u."""
    m, l, g = P("m:kg l:m g:m/s^2")
    u = dynamicsymbols("u")
    return pendulum(dynamicsymbols("theta"), m, 0, l, g, u, (u,))


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("theta'' = u - m*g*l*sin(theta)/(m*l^2)", "(u - m*g*l*sin(theta))/(m*l^2)"),
        ("m*l*(l*theta'' + g*sin(theta) - u) = 0", "m*l*(l*theta'' + g*sin(theta)) - u"),
    ],
)
def test_a_bracket_ends_elsewhere(text: str, right: str) -> None:
    ((written, new),) = _first(driven(), text)
    assert written in text and new == right


def test_code_is_blamed_with_the_values_that_it_gives(tmp_path: Path) -> None:
    """A half stands for half of a length of 1, and is no mistake."""
    text = (
        "function dx = rates(x, u)\n m = 2;\n l = 1;\n g = 9.81;\n lc = 0.5;\n J = m*l^2/%s;\n"
        " dx = [x(2); (u - m*g*lc*sin(x(1)))/J];\nend\n"
    )
    m, l, g, u = (*P("m:kg l:m g:m/s^2"), dynamicsymbols("u"))
    rod = pendulum(dynamicsymbols("q"), m, m * l**2 / 12, l / 2, g, u, (u,))
    path = tmp_path / "rod.m"
    path.write_text(text % 3)
    right = check(rod, path)
    assert right.verdict.name != "REFUTED" and right.judged[1].right_if
    path.write_text(text % 12)
    assert _first(rod, path) == [("12", "3")]


def test_a_missing_term_stands_beside_its_like() -> None:
    """The kinetic energy of the second mass, before the potential energies."""
    m1, m2, k = P("m_1:kg m_2:kg k:N/m")
    scene = on_walls("x_1 x_2", m1, m2, k, k, k)
    text = r"L = \frac12 m_1 \dot x_1^2 - \frac12 k (x_1^2 + x_2^2 + (x_2 - x_1)^2)"
    (entry,) = check(scene, rf"\[ {text} \]").judged
    assert entry.blame is not None
    repaired = entry.blame.repairs[0].repaired
    assert 0 < repaired.index("m_{2}") < repaired.index("k")


def test_no_edit_multiplies_by_what_is_always_zero() -> None:
    """The speed about the axis of a symmetric top stays: ``I_3 w_z' = w_z' (...)`` says nothing."""
    (entry,) = check(spinning_top.scene(), r"$I_3\dot w_z = I_1 w_x w_y$").judged
    assert entry.blame is not None
    assert {edit.right for repair in entry.blame.repairs for edit in repair.edits} == {"0"}


def test_a_number_in_place_of_a_factor_is_no_part_of_the_power_before_it() -> None:
    text = r"\[ \ddot\theta = \omega^2\cos^2\theta\sin\theta\cos\theta - \frac gR\sin\theta \]"
    (entry,) = check(bead_on_hoop.scene(), text).judged
    repairs = [repair.repaired for repair in entry.blame.repairs]
    assert repairs
    assert not [one for one in repairs if re.search(r"\^\d{2}", one)]
