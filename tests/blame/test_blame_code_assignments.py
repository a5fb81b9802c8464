"""Blame of code with local names: the line of the file, the author's names, the change marked."""

import numpy as np
import pytest

import mechanics
from mechanics.blame.result import Mistake
from mechanics.cli.load import run_file
from mechanics.kernel import Verdict
from systems import cartpole, rod_pendulum

CART = mechanics.derive(cartpole.scene(), "free_body")
ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
FILE = """
import numpy as np

def rates(x, theta, x_dot, theta_dot, force, masscart, masspole, length, gravity):
    total_mass = masspole + masscart
    polemass_length = masspole * length
    sintheta = np.sin(theta)
    costheta = np.cos(theta)
    temp = (force + polemass_length * theta_dot**2 * sintheta) / total_mass
    thetaacc = (gravity * sintheta - costheta * temp) / (
        length * (4.0 / 3.0 - masspole * costheta**2 / total_mass)
    )
    xacc = temp - polemass_length * thetaacc * costheta / total_mass
    return np.array([xacc, thetaacc])
"""


def _told(tmp_path, old: str, new: str):
    assert old in FILE
    (tmp_path / "cart.py").write_text(FILE.replace(old, new), encoding="utf-8")
    rates = run_file(tmp_path / "cart.py").rates
    return mechanics.check(CART, rates, names={"force": "F"})


def test_the_line_and_the_local_names_of_a_wrong_assignment(tmp_path) -> None:
    found = _told(tmp_path, "force + polemass", "force - polemass")
    assert [entry.finding.verdict.name for entry in found.judged] == ["REFUTED", "REFUTED"]
    for entry in found.judged:
        (edit,) = entry.blame.repairs[0].edits
        assert (edit.definition, edit.place) == ("temp", "cart.py, line 9")
        right = "(force + polemass_length*theta_dot**2*sintheta)/total_mass"
        assert entry.blame.repairs[0].repaired == f"cart.py, line 9: temp = {right}"
    assert "cart.py, line 9: temp = (force -\n" in str(found)
    assert "write + for - in the definition of temp, cart.py, line 9" in str(found).replace(
        "\n      ", " "
    )


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("old", "new", "name", "line"),
    [
        ("4.0 / 3.0", "4.0 / 6.0", "thetaacc", 10),
        ("masspole + masscart", "masspole - masscart", "total_mass", 5),
        ("gravity * sintheta", "gravity * costheta", "thetaacc", 10),
        ("temp - polemass", "temp + polemass", "xacc", 13),
    ],
)
def test_other_slips_in_other_lines(tmp_path, old, new, name, line) -> None:
    found = _told(tmp_path, old, new)
    wrong = [entry for entry in found.judged if not entry.finding.shown]
    edits = [edit for entry in wrong for edit in entry.blame.repairs[0].edits]
    assert {edit.definition for edit in edits} == {name}
    assert int(edits[0].place.rpartition(" ")[2]) - line in (0, 1, 2)


def test_the_wrong_branch_of_code_that_decides_by_its_local_names() -> None:
    def rate(theta, u, m, l, g):
        gravity = 3 * g / (2 * l) * np.sin(theta)
        inertia = m * l**2 / 3
        if theta > 0:
            drive = u / inertia
            return gravity + drive
        drive = 2 * u / inertia
        return gravity + drive

    (entry,) = mechanics.check(ROD, rate).judged
    assert entry.finding.verdict.name == "REFUTED"
    (edit,) = entry.blame.repairs[0].edits
    assert edit.definition == "drive" and edit.mistake.name == "FACTOR"
    assert "this is the branch where theta <= 0" in entry.blame.searched


def test_names_of_the_scene_and_names_that_change_are_no_definitions() -> None:
    def rate(theta, u, m, l, g):
        l = l / 2
        a = 3 * g / (4 * l) * np.sin(theta)
        a = a + 3 / (m * l**2) * u
        return a

    (entry,) = mechanics.check(ROD, rate).judged
    assert entry.finding.verdict.name == "REFUTED"
    assert all(name != "l" for name, _ in entry.statement.written.definitions)
    (edit,) = entry.blame.repairs[0].edits
    assert edit.mistake.name == "FACTOR"


C = """
#include <math.h>
double theta_ddot(double theta, double u, double m, double l, double g)
{
    double gravity = 3*g/(2*l)*sin(theta);
    double inertia = m*l*l/3;
    double drive;
    if (u > 0) {
        drive = u/inertia;
    } else {
        drive = 2*u/inertia;
    }
    return gravity + drive;
}
"""


def test_c_by_its_assignments_on_the_branch_where_it_is_wrong() -> None:
    plain = C.replace("if (u > 0) {\n        drive = u/inertia;\n    } else {", "{")
    (entry,) = mechanics.check(ROD, plain, notation="c").judged
    (edit,) = entry.blame.repairs[0].edits
    assert (edit.definition, edit.place) == ("drive", "code.c, line 9")
    (entry,) = mechanics.check(ROD, C, notation="c").judged
    assert entry.finding.verdict.name == "REFUTED"
    (edit,) = entry.blame.repairs[0].edits
    assert (edit.definition, edit.place) == ("drive", "code.c, line 11")
    assert "this is the branch where u <= 0" in entry.blame.searched
    ternary = C.replace("double drive;", "double drive = u > 0 ? u/inertia : u/inertia;")
    right = ternary[: ternary.index("    if (u")] + "    return gravity + drive;\n}\n"
    assert mechanics.check(ROD, right, notation="c").verdict.name == "PROVED"


SOLVED = """
import numpy as np

def rates(q, qd, force, masscart, masspole, length, gravity):
    x, th = q
    dx, dth = qd
    coupling = masspole*length*np.cos(th)
    M = np.array([[masscart + masspole, coupling],
                  [coupling, masspole*length**2*4/3]])
    f = np.array([force + masspole*length*dth**2*np.sin(th), masspole*gravity*length*np.sin(th)])
    return np.linalg.solve(M, f)
"""


def test_a_linear_system_by_the_line_of_the_entry_that_is_wrong(tmp_path) -> None:
    for old, new, name, line in (("force +", "force -", "f[0]", 10), ("4/3", "1/3", "M[1, 1]", 9)):
        (tmp_path / "cart.py").write_text(SOLVED.replace(old, new), encoding="utf-8")
        rates = run_file(tmp_path / "cart.py").rates
        found = mechanics.check(CART, rates, names={"force": "F"})
        for entry in found.judged:
            assert entry.finding.verdict.name == "REFUTED"
            (edit,) = entry.blame.repairs[0].edits
            assert edit.definition == name
            assert int(edit.place.rpartition(" ")[2]) in (line, line - 1)


FORGOTTEN = """
from math import cos, sin

def rates(x, th, dx, dth, force, masscart, masspole, length, gravity):
    total = masscart + masspole
    temp = (force + masspole*length*dth**2*sin(th))/total
    thacc = (gravity*sin(th) - cos(th)*temp)/(length*(4/3 - masspole*cos(th)**2/total))
    xacc = temp - masspole*length*thacc*cos(th)
    return xacc, thacc
"""


@pytest.mark.campaign
def test_code_is_mended_neither_by_another_output_nor_by_what_it_has_not(tmp_path) -> None:
    (tmp_path / "cart.py").write_text(FORGOTTEN, encoding="utf-8")
    rates = run_file(tmp_path / "cart.py").rates
    wrong, right = mechanics.check(CART, rates, names={"force": "F"}).judged
    assert (wrong.finding.verdict.name, right.finding.verdict.name) == ("REFUTED", "PROVED")
    for repair in wrong.blame.repairs:
        assert not any("_ddot" in edit.written + edit.right for edit in repair.edits)


def test_what_is_put_in_has_the_authors_name_where_the_code_has_one(tmp_path) -> None:
    found = _told(tmp_path, "costheta**2 / total_mass", "costheta**2 / masscart")
    (entry,) = [e for e in found.judged if e.statement.tag == "theta_ddot"]
    (edit,) = entry.blame.repairs[0].edits
    assert (edit.definition, edit.written, edit.right) == ("thetaacc", "masscart", "total_mass")


MACROS = """#define INERTIA (m*l*l/3)
#define WEIGHT (m*g)
void rates(double theta, double w, double u, double m, double l, double g, double d[2])
{
    d[0] = w;
    d[1] = (u - WEIGHT*l/2*sin(theta))/INERTIA;
}"""


def test_a_macro_of_c_is_a_definition_with_its_name() -> None:
    right = MACROS.replace("u - WEIGHT", "u + WEIGHT")
    assert mechanics.check(ROD, right, notation="c").ok
    found = mechanics.check(ROD, right.replace("l*l/3", "l/3"), notation="c")
    (entry,) = [e for e in found.judged if not e.finding.shown]
    (edit,) = entry.blame.repairs[0].edits
    assert edit.definition == "INERTIA"


def test_states_are_told_by_the_names_that_the_code_takes_them_apart_into() -> None:
    def rates(state, u, m, l, g):
        angle, dangle = state
        return dangle, 3 * u / (m * l**2) + 3 * g / l * np.sin(angle)

    found = mechanics.check(ROD, rates)
    (entry,) = [e for e in found.judged if not e.finding.shown]
    assert entry.blame is not None
    assert entry.verdict.name == "REFUTED"
    repaired = entry.blame.repairs[0].repaired
    assert "sin(angle)" in repaired
    assert "theta" not in repaired


COLUMNS = {
    "rod.m": ("function dy = f(y, m, l, g, u)\ndy = zeros(2, 1);\ndy(1) = y(2);\ndy(2) = %s;\nend",
              "3*g/(2*l)*sin(y(1))", "dy(2)"),
    "row.m": ("function dy = f(y, m, l, g, u)\n\n\ndy = [y(2), %s];\nend",
              "3*g/(2*l)*sin(y(1))", "dy(2)"),
    "rod.jl": ("function f!(dy, y, p, t)\nm, l, g, u = p\ndy[1] = y[2]\ndy[2] = %s\nend",
               "3*g/(2*l)*sin(y[1])", "dy[2]"),
    "rod.cpp": ("void f(const double y[2], double dy[2], double m, double l, double g, double u) {"
                "\n\ndy[0] = y[1];\ndy[1] = %s;}", "3*g/(2*l)*std::sin(y[0])", "dy[1]"),
}  # fmt: skip


@pytest.mark.parametrize("file", COLUMNS)
def test_an_entry_has_the_index_that_its_language_gives_it(tmp_path, file) -> None:
    text, gravity, name = COLUMNS[file]
    (tmp_path / file).write_text(text % f"{gravity} + 2*u/(m*l^2)".replace("l^2", "l*l"))
    entry = mechanics.check(ROD, tmp_path / file).judged[1]
    (edit,) = entry.blame.repairs[0].edits
    assert (edit.definition, edit.place) == (name, "line 4")


def test_outputs_in_each_others_place_are_named() -> None:
    def rates(t, theta, theta_dot, m, l, g, u):  # type: ignore[no-untyped-def]
        acceleration = 3 * g / (2 * l) * np.sin(theta) + 3 * u / (m * l**2)
        return acceleration, theta_dot

    first, second = mechanics.check(ROD, rates).judged
    assert first.verdict is second.verdict is Verdict.REFUTED
    for one, other in ((first, second), (second, first)):
        assert one.blame is not None and other.blame is not None
        (repair,) = one.blame.repairs
        assert repair.finding.shown
        (edit,), (back,) = repair.edits, other.blame.repairs[0].edits
        assert (edit.written, edit.right) == (back.right, back.written)
        assert edit.mistake is Mistake.ORDER
