"""C++, Arduino's dialect and GSL's ``void *params``: the formulas count, right and wrong."""

from pathlib import Path

import pytest

import mechanics
from mechanics.errors import InputError
from systems import bead_on_hoop, rod_pendulum

HOOP = mechanics.derive(bead_on_hoop.scene(), "free_body")
ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
FILES = {
    "struct.c": """
#include <math.h>
struct hoop { double R, omega, g; };
int rhs(double t, const double y[], double f[], void *params)
{
    struct hoop *p = (struct hoop *) params;
    (void) t;
    f[0] = y[1];
    f[1] = (p->omega*p->omega*cos(y[0]) - p->g/p->R)*sin(y[0]);
    return GSL_SUCCESS;
}
""",
    "array.c": """
#include <math.h>
int rhs(double t, const double y[], double f[], void *params)
{
    double *p = (double *)params;
    double R = p[0], omega = p[1], g = p[2];
    f[0] = y[1];
    f[1] = (omega*omega*cos(y[0]) - g/R)*sin(y[0]);
    return 0;
}
""",
    "functions.cpp": """
// a rod on a pivot
#include <cmath>
#include <array>
using namespace std;
double inertia(const double m, const double l) { return m*l*l/3; }  // about the pivot
void f(const std::array<double, 2>& y, double u, double m, double l, double g, double* dydt) {
    const auto s = std::sin(y[0]);
    dydt[0] = y[1];
    dydt[1] = 3*g/(2*l)*s + u/inertia(m, l);
}
""",
    "sketch.ino": """
#include <Arduino.h>
const float GAIN = 3.0f;
float acceleration(float theta, float u, float m, float l, float g) {
  float s = sinf(theta); // sine
  return 3*g/(2*l)*s + GAIN/(m*l*l)*u;
}
""",
    "class.cpp": """
#include <cmath>
class Pendulum {
 public:
  explicit Pendulum(double mass) : m(mass) {}
  double acceleration(double theta, double u) const {
    return 3*g/(2*l)*std::sin(theta) + u/inertia();
  }
 private:
  double inertia() const { return m*l*l/3; }
  double m = 1.0, l = 1.0;
  double g = 9.81;
};
""",
}
WRONG = {"struct.c": ("p->omega*p->omega", "p->omega"), "array.c": ("- g/R", "- 2*g/R"),
         "functions.cpp": ("l*l/3", "l*l/12"), "sketch.ino": ("3.0f", "12.0f"),
         "class.cpp": ("l*l/3", "l*l/12")}  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", FILES)
def test_files(tmp_path: Path, name: str) -> None:
    truth = HOOP if name.endswith(".c") else ROD
    options = {"function": "acceleration"} if name == "class.cpp" else {}
    for text, verdict in ((FILES[name], "PROVED"), (FILES[name].replace(*WRONG[name]), "REFUTED")):
        (tmp_path / name).write_text(text, encoding="utf-8")
        found = mechanics.check(truth, tmp_path / name, blame=False, **options)
        assert found.verdict.name == verdict


def test_void_that_is_cast_to_nothing_is_refused_by_its_place(tmp_path: Path) -> None:
    (tmp_path / "a.c").write_text("double f(double x, void *p)\n{\n return p ? x : -x;\n}\n")
    with pytest.raises(InputError, match=r"line 1, column 20: argument p is void"):
        mechanics.check(ROD, tmp_path / "a.c")


RETURNED = """
#include <array>
#include <cmath>
std::array<double, 2> rhs(const std::array<double, 2>& y, double R, double omega, double g) {
  const auto [th, w] = y;
  return {w, (omega*omega*std::cos(th) - g/R)*std::sin(th)};
}
"""


@pytest.mark.parametrize(
    ("old", "new", "verdict"),
    [("", "", "PROVED"), ("[th, w]", "[w, th]", "REFUTED"), ("omega*omega*", "omega*", "REFUTED")],
)
def test_a_list_that_is_returned_and_one_that_is_taken_apart(
    tmp_path: Path, old: str, new: str, verdict: str
) -> None:
    file = tmp_path / "rhs.cpp"
    file.write_text(RETURNED.replace(old, new) if old else RETURNED, encoding="utf-8")
    assert mechanics.check(HOOP, file, blame=False).verdict.name == verdict


SQUARE = """
float accelerationOf(float theta, float u, float m, float l, float g) {
  return 3*g/(2*l)*sin(theta) + 3*u/(m*sq(l));
}
"""


@pytest.mark.parametrize(
    ("old", "new", "verdict"), [("", "", "PROVED"), ("sq(l)", "sq(m)", "REFUTED"),
                                ("m*sq(l)", "sq(m)*l", "REFUTED")]
)  # fmt: skip
def test_the_square_of_arduino(tmp_path: Path, old: str, new: str, verdict: str) -> None:
    """It is a macro of its header: ((x)*(x))."""
    file = tmp_path / "rod.ino"
    file.write_text(SQUARE.replace(old, new) if old else SQUARE, encoding="utf-8")
    answer = mechanics.check(ROD, file, function="accelerationOf", blame=False)
    assert answer.verdict.name == verdict


@pytest.mark.parametrize(
    ("name", "above", "old", "new"),
    [("a.cpp", "", "", ""), ("a.ino", "#define sq(x) (2*(x))", "", ""),
     ("b.ino", "", "sq(l)", "sq(2)"), ("c.ino", "", "sq(l)", "sq(l++)")],
)  # fmt: skip
def test_another_square_is_refused(
    tmp_path: Path, name: str, above: str, old: str, new: str
) -> None:
    file = tmp_path / name
    text = f"{above}\n#include <Arduino.h>{SQUARE.replace(old, new) if old else SQUARE}"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=r"line \d, column"):
        mechanics.check(ROD, file, function="accelerationOf", blame=False)
