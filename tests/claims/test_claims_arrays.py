"""States in arrays, as MATLAB, Julia and Modelica write them."""

import pytest

from mechanics.judge.check import check, derived
from mechanics.kernel import Verdict
from systems import cartpole
from tests.notation_scenes import judged, verdicts

PENDULUM = [
    "dydt = [y(2); -g/l*sin(y(1))]",
    "dy(1,1) = y(2);\ndy(2,1) = -(g/l)*sin(y(1));",
    "xdot(1) = x(2); xdot(2) = -g./l.*sin(x(1));",
    "th = y(1); w = y(2);\ndydt = [w; -(g/l)*sin(th)];",
    "theta = y(1); thetadot = y(2);\ndydt = [thetadot; -(g/l)*sin(theta)];",
    "theta = y(2); thetadot = y(1);\ndydt = [-(g/l)*sin(theta); thetadot];",
    "du[1] = u[2]\ndu[2] = -g/l*sin(u[1])",
    "dydt = zeros(2,1);\ndydt(1) = y(2); % rate\ndydt(2) = -g/l*sin(y(1));",
    "function dydt = pend(t,y)\ng = 9.81;\ndydt(1) = y(2);\ndydt(2) = -g/l*sin(y(1));\nend",
    "function f!(du,u,p,t)\n  g, l = p\n  du[1] = u[2]\n  du[2] = -g/l*sin(u[1])\nend",
    "der(theta) = w;\nl*der(w) = -g*sin(theta);",
    "model P\n parameter Real g=9.81;\n Real theta; Real w;\nequation\n  der(theta) = w;\n"
    "  l*der(w) = -g*sin(theta);\nend P;",
]


@pytest.mark.sample(2)
@pytest.mark.parametrize("text", PENDULUM)
def test_states_in_arrays(text: str) -> None:
    assert set(verdicts("pendulum", text)) == {"PROVED"}
    assert "REFUTED" in verdicts("pendulum", text.replace("sin", "cos"))


@pytest.mark.parametrize(
    "text",
    [
        "dy(1,1) = y(1);\ndy(2,1) = -(g/l)*sin(y(1));",
        "theta = y(1); thetadot = y(2);\ndydt = [theta; -(g/l)*sin(theta)];",
        "dydt = [y(2); -g/l*sin(y(2))]",
        "dydt = [-g/l*sin(y(1)); y(2)]",
    ],
)
def test_entries_in_the_wrong_place(text: str) -> None:
    assert "REFUTED" in verdicts("pendulum", text)


def test_the_time_of_modelica() -> None:
    text = "der(x) = v;\nm*der(v) = F0*cos(omega*time) - c*v - k*x;"
    assert verdicts("oscillator", text) == ["PROVED"]
    assert verdicts("oscillator", text.replace("cos(", "sin(")) == ["REFUTED"]


BLOCKS = """dz(1) = z(3); dz(2) = z(4);
dz(3) = (-g*(m1+m2)*sin(z(1)) - m2*l2*z(4)^2*sin(z(1)-z(2)) - m2*l2*cos(z(1)-z(2))*dz(4))/((m1+m2)*l1)
"""  # noqa: E501
IN_PAIRS = BLOCKS.translate(str.maketrans("23", "32")).replace("m3", "m2").replace("l3", "l2")
IN_PAIRS = IN_PAIRS.replace("^3", "^2")
SOLVED = """M = [(m1+m2)*l1^2, m2*l1*l2*cos(z(1)-z(2)); m2*l1*l2*cos(z(1)-z(2)), m2*l2^2];
f = [-(m1+m2)*g*l1*sin(z(1)) - m2*l1*l2*sin(z(1)-z(2))*z(4)^2;
     -m2*g*l2*sin(z(2)) + m2*l1*l2*sin(z(1)-z(2))*z(3)^2];
qdd = M\\f;
dz = [z(3); z(4); qdd(1); qdd(2)];"""


@pytest.mark.campaign
@pytest.mark.parametrize("text", [BLOCKS, IN_PAIRS, SOLVED], ids=["blocks", "pairs", "solved"])
def test_states_of_two_freedoms(text: str) -> None:
    assert set(verdicts("double", text)) == {"PROVED"}
    assert "REFUTED" in verdicts("double", text.replace("- m2*l", "+ m2*l", 1))


def test_the_mistake_is_named_in_the_authors_entries() -> None:
    found = judged("pendulum", "dydt = [y(2); -g/l*cos(y(1))]", blame=True)
    (entry,) = found.judged
    assert entry.blame is not None
    assert "y(1)" in str(entry.blame)


UNPACKED = """function dz = f(t, z)
x = z(1); th = z(2); xd = z(3); thd = z(4);
A = [mc+mp, mp*l*cos(th); mp*l*cos(th), 4/3*mp*l^2];
b = [F + mp*l*thd^2*sin(th); mp*g*l*sin(th)];
qdd = A\\b;
dz = [xd; thd; qdd];
end
"""


@pytest.mark.campaign
def test_a_state_taken_apart_by_names_and_a_column_stacked_under_speeds() -> None:
    truth = derived(cartpole.scene())
    assert check(truth, UNPACKED, blame=False).ok
    for right, wrong in (("4/3", "1/3"), ("thd^2", "xd^2"), ("xd; thd", "thd; xd")):
        found = check(truth, UNPACKED.replace(right, wrong), blame=False)
        assert found.verdict is Verdict.REFUTED


OVER_TIMES = """function r = swing(t, s)
th = s(1,:); w = s(2,:);
r(1,:) = w;
r(2,:) = -g*sin(th);
r(2,:) = r(2,:)./l;
end"""


def test_rows_over_many_times_and_a_result_that_is_filled_entry_by_entry() -> None:
    assert set(verdicts("pendulum", OVER_TIMES)) == {"PROVED"}
    for right, wrong in (("sin", "cos"), ("= w", "= th"), ("./l", ".*l"), ("s(2,:)", "s(1,:)")):
        assert "REFUTED" in verdicts("pendulum", OVER_TIMES.replace(right, wrong))
    columns = OVER_TIMES.replace("1,:", ":,1").replace("2,:", ":,2")
    assert set(verdicts("pendulum", columns)) == {"PROVED"}


def test_the_name_of_a_rate_is_used_where_only_its_own_rate_is_written() -> None:
    text = "der(theta) = omega;\nl*der(omega) = -g*sin(theta);"
    assert verdicts("pendulum", text) == ["PROVED"]
    assert verdicts("pendulum", text.replace("sin", "cos")) == ["REFUTED"]


def test_what_lacks_is_told_with_the_authors_name_of_a_rate() -> None:
    text = "der(x) = v;\nm*der(v) = F0*cos(omega*time) - k*x;"
    (entry,) = judged("oscillator", text, blame=True).judged
    assert entry.blame is not None
    (edit,) = entry.blame.repairs[0].edits
    assert edit.right in ("- v*c", "- c*v")
