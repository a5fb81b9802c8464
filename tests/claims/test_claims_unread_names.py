"""A name of which a text says what is not read is not guessed: what uses it is UNDECIDED."""

import pytest

import mechanics
from mechanics.claims.unread_names import assigned_names, mentioned
from mechanics.judge.check import derived
from systems import bead_on_hoop, rod_pendulum

BEAD = derived(bead_on_hoop.scene())
ROD = derived(rod_pendulum.scene())
HOOP = "theta'' = (omega^2*cos(theta) - g/r)*sin(theta)"
LATEX = r"$$\ddot\theta = (\omega^2\cos\theta-\frac gr)\sin\theta$$"
RIGHT = "theta'' = (omega^2*cos(theta) - 2*g/d)*sin(theta)"
MODEL = """model B
  Real theta, w, r; parameter Real R, g, omega;
equation
  der(theta) = w; der(w) = (omega^2*cos(theta) - g/r)*sin(theta);
  assert(r == 2*R, "r is the diameter");
end B;
"""


def verdicts(truth, text: str) -> dict[str, str]:
    found = mechanics.check(truth, text, blame=False)
    return {e.statement.source: f"{e.verdict.name} {e.statement.doubt}" for e in found.judged}


@pytest.mark.parametrize(
    "text",
    [
        f"r ← 2*R\n{HOOP}", f"{HOOP}\nr += R", f"r ∶= 2*R\n{HOOP}", f"d <- 2*R\n{RIGHT}",
        rf"$$r\widehat{{=}} 2R$$ {LATEX}",
        rf"$$\xrightarrow{{r=2R}}$$ {LATEX}", rf"$$r \mathrel{{:=}} R + R$$ {LATEX}",
        MODEL,
    ],
)  # fmt: skip
def test_what_is_defined_on_a_line_that_is_not_read_is_not_guessed(text: str) -> None:
    found = verdicts(BEAD, text)
    assert {words.split()[0] for words in found.values()} == {"UNDECIDED"}
    assert any("not read: say what it means" in words for words in found.values())


@pytest.mark.parametrize(
    "text",
    [
        f"# r = 2*R\n{HOOP}", f"// r = 2*R\n{HOOP}", f"{HOOP}  % r = 2*R", f"{HOOP};  // r = 2*R",
        f"# d = 2*R\n{RIGHT}", rf"\verb|r=2R| {LATEX}",
        "\\begin{lstlisting}[language=C]\nr = 2*R;\n\\end{lstlisting}\n" + LATEX,
    ],
)  # fmt: skip
def test_what_stands_beside_formulas_defines_names_too(text: str) -> None:
    found = mechanics.check(BEAD, text, blame=False)
    assert {e.verdict.name for e in found.judged} == {"UNDECIDED"}
    assert len(found.unjudged) == 1


def test_verbatim_words_deny_what_they_stand_beside() -> None:
    text = r"\verb|This is wrong.| $$\ddot\theta = (\omega^2\cos\theta-\frac gR)\sin\theta$$"
    assert mechanics.check(BEAD, text, blame=False).verdict.name == "UNDECIDED"


def test_values_and_words_beside_a_formula_leave_a_guess() -> None:
    text = "% J = 2 kg\n% tau = torque\ntheta'' = 3*g/(2*l)*sin(theta) + 3*tau/(m*l^2)"
    assert mechanics.check(ROD, text, blame=False).verdict.name == "PROVED"


def test_a_name_of_the_scene_is_what_the_scene_calls_so() -> None:
    text = "# theta = 2*q\ntheta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
    assert mechanics.check(ROD, text, blame=False).verdict.name == "PROVED"


def test_names_of_a_formula() -> None:
    assert {*mentioned(r"m_{\mathrm{p}}\ddot\varphi_1 = ab_2")} >= {"mp", "phi1", "a", "b2"}
    assert [*assigned_names("r = 2*R, g = 9.81 m/s^2, F = force of the wind")] == ["r", "R"]
