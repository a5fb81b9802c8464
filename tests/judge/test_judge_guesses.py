"""What nobody said: a refutation under a guess stands where other ways to guess refute it, too."""

import numpy as np
import pytest
from sympy import sin

from benchmarks.corpus.scenes.bobs_rods_springs import elastic, hanging_rod, rods, simple_phi
from benchmarks.corpus.scenes.carts_with_friction import pole
from mechanics import check
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.judge.numbers_of_parameters import values_for
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion
from systems import rod_pendulum

SHOWN = ("PROVED", "CERTIFIED")
ROD = derived(hanging_rod())
POLE = derived(pole())

JULIA = """
function pendulum!(du,u,p,t)
    du[1] = u[2]
    du[2] = -3g/({})*sin(u[1]) + 3/(m*l^2)*p(t)
end
"""
HAMILTON = """
function dy_dt!(f, y, t; p)
    L = p[1]
    θ1, θ2, pθ1, pθ2 = y
    c = cos(θ1 - θ2)
    k = 6.0/(16.0 - 9.0*c^2)
    f[1] = (2.0*pθ1 - {}*pθ2*c) * k
    f[2] = (8.0*pθ2 - 3.0*pθ1*c) * k
    w = f[1] * f[2] * sin(θ1 - θ2)
    f[3] = -(w + 3.0*sin(θ1)*g/L) / 2.0
    f[4] = (w - sin(θ2)*g/L) / 2.0
end
"""
CART = """
function [dx] = cart(t,x,u)
% x1 = position of cart (x)
% x3 = pendulum angle (theta)
k = (u + 0.05*x(4)^2*sin(x(3)))/1.1;
a = (9.8*sin(x(3))-cos(x(3))*k)/(0.5*(4/3-0.1*cos(x(3))^2/1.1));
dx(1,1) = x(2);
dx(2,1) = k - {}*a*cos(x(3))/1.1;
dx(3,1) = x(4);
dx(4,1) = a;
end
"""


def verdicts(scene: object, thing: object, **options: object) -> list[str]:
    return [e.verdict.name for e in check(scene, thing, blame=False, **options).judged]


def test_the_only_momentum_may_be_an_input() -> None:
    (_, entry) = check(ROD, JULIA.format("2l"), notation="text", blame=False).judged
    assert (entry.verdict.name, entry.right_if) == ("UNDECIDED", ("p is M: --name p=M",))
    assert verdicts(ROD, JULIA.format("l"), notation="text")[1] == "REFUTED"
    said = check(ROD, JULIA.format("2l"), notation="text", names={"p": "M"}, blame=False)
    assert said.verdict.name == "PROVED"


def test_momenta_may_be_counted_in_those_of_a_mass_and_a_length() -> None:
    found = check(rods(), HAMILTON.format("3.0"), notation="text", blame=False)
    assert {e.verdict.name for e in found.judged} == {"UNDECIDED"}
    assert found.judged[0].right_if == ("momenta are counted in L**2*m",)
    wrong = verdicts(rods(), HAMILTON.format("2.0"), notation="text")
    assert wrong[:2] == ["REFUTED", "UNDECIDED"]


def test_numbers_may_stand_for_four_parameters() -> None:
    found = check(POLE, CART.format("0.05"), notation="text", blame=False)
    assert found.verdict.name == "UNDECIDED"
    assert found.judged[1].right_if == ("M = 1, g = 9.8, l = 0.5, m = 0.1",)
    assert check(POLE, CART.format("0.5"), notation="text", blame=False).verdict.name == "REFUTED"


def test_a_side_without_any_parameter_has_numbers_for_all() -> None:
    def bob(t, s):
        return [s[1] + 0, -9.80665 * np.sin(s[0])]

    def wrong(t, s):
        return [s[1] + 0, -9.80665 * np.cos(s[0])]

    entry = check(simple_phi(), bob, blame=False).judged[1]
    assert (entry.verdict.name, entry.right_if) == ("UNDECIDED", ("g = 9.80665, l = 1",))
    assert check(simple_phi(), wrong, blame=False).verdict.name == "REFUTED"


def test_what_follows_another_value_is_one() -> None:
    names = {s.name: s for s in ROD.scene.parameters}
    row = published(
        "row", EquationOfMotion(), ROD.scene.ud[0], -15 * sin(ROD.scene.q[0]), label="row"
    )
    assert values_for(ROD, [row], [*names.values()]) == {}  # the torque moves it, too
    free = derived(simple_phi())
    row = published(
        "row", EquationOfMotion(), free.scene.ud[0], -15 * sin(free.scene.q[0]), label="row"
    )
    found = values_for(free, [row], [*free.scene.parameters])
    (g, l) = (next(v for s, v in found.items() if s.name == name) for name in "gl")
    assert (g / l, 1 in (g, l), len(found)) == (15, True, 2)


def test_a_coordinate_that_scales_a_length_has_no_unit() -> None:
    right = "E = 0.5*m*l**2*(nu'**2 + (1 + nu)**2*th'**2) - m*g*l*(1 + nu)*cos(th)"
    right += " + 0.5*k*l**2*(nu + m*g/k/l)**2"
    assert verdicts(elastic(), right) == ["PROVED"]
    assert verdicts(elastic(), right.replace("(1 + nu)*cos", "(1 - nu)*cos")) == ["REFUTED"]


def test_slashes_of_both_kinds_in_one_line() -> None:
    text = "θ̈ = (-3g/2l)sin(θ) + (3/ml²)M"
    assert verdicts(ROD, text) == ["PROVED"]
    assert verdicts(ROD, text.replace("2l", "3l")) == ["REFUTED"]


def test_a_term_in_a_bracket_that_begins_with_a_plus_is_no_factor() -> None:
    with pytest.raises(InputError, match="may be left out"):
        check(ROD, r"\ddot\theta = -\frac{3g}{2l}\sin(\theta)[+\frac{3M}{m l^2}]\cos\theta")
    for sign in ("", " + "):
        text = rf"\ddot\theta = -\frac{{3g}}{{2l}}\sin(\theta){sign}[+\frac{{3M}}{{m l^2}}]"
        assert verdicts(ROD, text) == ["PROVED"]
        assert verdicts(ROD, text.replace("3M", "2M")) == ["REFUTED"]


def test_a_vector_in_an_order_that_nobody_said_is_tried_in_all_orders() -> None:
    def rod(y, u, p):
        return np.array(
            [y[1] + 0, -3 * p[2] / (2 * p[0]) * np.sin(y[0]) + 3 * u / (p[1] * p[0] ** 2)]
        )

    def wrong(y, u, p):
        return np.array(
            [y[1] + 0, -3 * p[2] / (2 * p[0]) * np.sin(y[0]) + 2 * u / (p[1] * p[0] ** 2)]
        )

    (entry,) = (e for e in check(ROD, rod, blame=False).judged if not e.finding.shown)
    assert (entry.verdict.name, entry.right_if) == ("UNDECIDED", ("p is l m g: --name 'p=l m g'",))
    assert check(ROD, wrong, blame=False).verdict.name == "REFUTED"
    assert check(ROD, rod, names={"p": "l m g"}, blame=False).verdict.name == "PROVED"


def test_exchanged_angles_of_a_state_are_another_order() -> None:
    text = """
dy(1) = y(3);
dy(2) = y(4);
dy(3) = {};
dy(4) = {};
"""
    truth = derived(rods())
    one, two = truth.textbook.mass.LUsolve(truth.textbook.forcing)
    names = dict(zip(("theta1", "theta2", "theta1_dot", "theta2_dot"), range(1, 5), strict=True))

    def written(*rates: object) -> str:
        found = [str(rate) for rate in rates]
        for name, k in sorted(names.items(), key=lambda item: -len(item[0])):
            found = [rate.replace(name, f"y({k})") for rate in found]
        return text.format(*found)

    assert check(truth, written(one, two), notation="text", blame=False).verdict.name in SHOWN
    swap = {3: 4, 4: 3, 1: 2, 2: 1}
    names = {name: swap[k] for name, k in names.items()}
    found = check(truth, written(two, one), notation="text", blame=False)
    assert found.verdict.name == "UNDECIDED"
    assert "the state is in the order theta2 theta1" in found.judged[-1].right_if


def test_a_name_without_a_letter_is_guessed_like_any_other() -> None:
    found = check(rod_pendulum.scene(), "_'' = 3*g/(2*l)*sin(_) + 3*u/(m*l^2)", blame=False)
    assert found.verdict.name == "PROVED"
    assert any(match.name == "_" for match in found.names)
