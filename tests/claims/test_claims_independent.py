r"""Partial derivatives where definitions depend on what they are by: momenta are held."""

import pytest
from particles import on_line
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from mechanics import Scene, force, parameters
from mechanics.errors import InputError
from mechanics.judge.check import derived
from tests.notation_scenes import swinging

V = r"\frac12 k r^2 - m g r\cos\theta"
DEFINED = (
    r"P = m\dot r",
    r"J = m r^2\dot\theta",
    rf"H = \frac{{P^2}}{{2 m}} + \frac{{J^2}}{{2 m r^2}} + {V}",
)
COLUMNS = (r"p = M\dot q", r"M = \begin{pmatrix} m & 0 \\ 0 & m r^2 \end{pmatrix}", rf"V = {V}",
           r"H = \frac12 p^T M^{-1} p + V")  # fmt: skip
LAGRANGIAN = (r"v = r\dot\theta", rf"L = \frac12 m (\dot r^2 + v^2) - ({V})")


def pushed() -> Scene:
    """A mass that a force pushes, with its speed declared."""
    x, v, F = dynamicsymbols("x v F")
    (m,) = parameters("m", units="kg", typical="1")
    return on_line(
        "pushed mass", x, m, lambda N, O, P: [force("F", P, F * N.x, on="mass")],
        speeds=((v, x.diff()),), inputs=(F,),
    )  # fmt: skip


TRUTH = derived(swinging())


def verdicts(*lines: str) -> list[str]:
    text = "\n".join(rf"\[ {line} \]" for line in lines)
    return [e.finding.verdict.name for e in mechanics.check(TRUTH, text, blame=False).judged]


def test_hamilton_s_equations_with_momenta_of_the_person_s_own() -> None:
    rows = (r"\dot P = -\frac{\partial H}{\partial r}",
            r"\dot J = -\frac{\partial H}{\partial\theta}",
            r"\dot\theta = \frac{\partial H}{\partial J}")  # fmt: skip
    assert verdicts(*DEFINED, *rows) == ["PROVED"] * 5  # the momentum P, too


@pytest.mark.parametrize(
    "row",
    [
        # Right if J were put in before the derivative is taken.
        r"\dot P = -\frac{\partial H}{\partial r} + 2 m r\dot\theta^2",
        r"\dot P = \frac{\partial H}{\partial r}",
        r"\dot\theta = 2\frac{\partial H}{\partial J}",
    ],
)
def test_wrong_ones_are_refuted(row: str) -> None:
    assert verdicts(*DEFINED, row) == ["PROVED", "PROVED", "REFUTED"]


def test_a_column_of_momenta() -> None:
    row = r"\dot p = -\frac{\partial H}{\partial q}"
    rates = r"\dot q = \frac{\partial H}{\partial p}"
    assert verdicts(*COLUMNS, row, rates) == ["PROVED"] * 6
    wrong = row + r" + \begin{pmatrix} 2 m r\dot\theta^2 \\ 0 \end{pmatrix}"
    assert verdicts(*COLUMNS, wrong) == ["PROVED", "PROVED", "REFUTED", "PROVED"]


def test_momenta_in_text() -> None:
    text = "J = m*r**2*thetad\nH = m*rd**2/2 + J**2/(2*m*r**2) + k*r**2/2 - m*g*r*cos(theta)\n"
    found = mechanics.check(TRUTH, text + "m*rdd = -diff(H, r) + 2*m*r*thetad**2", blame=False)
    assert [e.finding.verdict.name for e in found.judged] == ["PROVED", "REFUTED"]
    found = mechanics.check(TRUTH, text + "m*rdd = -diff(H, r)", blame=False)
    assert [e.finding.verdict.name for e in found.judged] == ["PROVED", "PROVED"]


def test_abbreviations_in_a_lagrangian_are_put_in() -> None:
    rows = (r"\frac{d}{dt}\frac{\partial L}{\partial\dot r} = \frac{\partial L}{\partial r}",
            r"\frac{d}{dt}\frac{\partial L}{\partial\dot\theta}"
            r" = \frac{\partial L}{\partial\theta}")  # fmt: skip
    assert verdicts(*LAGRANGIAN, *rows) == ["PROVED"] * 3


@pytest.mark.parametrize(
    "lines",
    [
        (r"J = m r^2\dot\theta", rf"L = \frac12 m\dot r^2 + \frac{{J^2}}{{2 m r^2}} - ({V})",
         r"m\ddot r = \frac{\partial L}{\partial r}"),
        (r"v = r\dot\theta", rf"H = \frac12 m (\dot r^2 + v^2) + {V}",
         r"m\ddot r = -\frac{\partial H}{\partial r}"),
    ],
)  # fmt: skip
def test_what_can_be_meant_in_two_ways_is_refused(lines: tuple[str, ...]) -> None:
    text = "\n".join(rf"\[ {line} \]" for line in lines)
    last = mechanics.check(TRUTH, text, blame=False).judged[-1]
    assert last.finding.verdict.name == "UNDECIDED"
    assert "is constant under this derivative" in last.statement.doubt


def test_a_declared_speed_is_no_constant_for_the_rate() -> None:
    """L in v does not depend on x' in letters: F was called wrong, and 0 right."""
    truth = derived(pushed())
    energy = r"\[ L = \frac12 m v^2 \]"
    right = mechanics.check(truth, energy + r"\[ \frac{d}{dt}\frac{\partial L}{\partial v} = F \]")
    assert right.ok
    text = energy + r"\[ m\dot v = F + \frac{\partial L}{\partial\dot x} \]"
    last = mechanics.check(truth, text).judged[-1]
    assert last.finding.verdict.name == "UNDECIDED"
    assert "depends on the variable of this derivative" in last.statement.doubt


def test_a_matrix_that_is_itself_says_nothing() -> None:
    row = r"m r^2\ddot\theta + 2 m r\dot r\dot\theta + m g r\sin\theta = 0"
    for entry in ("m", r"m\ddot\theta"):
        same = rf"\begin{{pmatrix}} {entry} \\ 0 \end{{pmatrix}}"
        assert verdicts(row, f"{same} = {same}") == ["PROVED", "UNDECIDED", "UNDECIDED"]
    with pytest.raises(InputError):
        verdicts(r"\begin{pmatrix} m & 0 \end{pmatrix} = \begin{pmatrix} m \\ 0 \end{pmatrix}")
