"""Integers of C around a judged function, arrays that it reads and fills, classes of MATLAB."""

from pathlib import Path

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import rod_pendulum

ROD = rod_pendulum.scene()
SKETCH = """double th = 0.1, om = 0;
double acc(double th, double w, double u, double m, double l, double g) {
  return 3*g/(2*l)*sin(th) + 3*u/(m*l*l);
}
"""
STEP = "om += acc(th, om, 0, 1.0, 2.0, 9.81) * dt; th += om * dt;"
RATE = """#include <math.h>
void rate(const double *y, double *dy, double u, double m, double l, double g) {
  dy[0] = y[1];
  dy[1] = 3*g/(2*l)*sin(y[0]) + 3*u/(m*l*l);
}
"""
JULIA = """function rate!(dy, y, p, t)
    theta, w = y
    m, l, g, u = p
    dy[1] = w
    dy[2] = 3g/(2l)*sin(theta) + 3u/(m*l^2)
end
y = [0.3, 0.0]
"""
AROUND = (
    "for i in 1:100\n    rate!(dy, y, (1.0, 2.0, 9.81, 0.0), 0.0)\n    y[1] += h*dy[1]\n"
    "    y[2] += h*dy[2]\nend\n"
)


def sketch(line: str, above: str = "") -> tuple[str, str]:
    lines = f"void setup() {{}}\nvoid loop() {{ {line} {STEP} }}\n"
    return ".ino", SKETCH + above + lines


def program(call: str, given: str = "") -> tuple[str, str]:
    loop = f"for (int i = 0; i < 100; i++) {{ {call} y[0] += h * d[0]; y[1] += h * d[1]; }}"
    return ".c", RATE + f"int main(void) {{ double y[2] = {{0.3, 0}}, d[2]; {given} {loop} }}\n"


def rates(arguments: str) -> str:
    return f"rate({arguments}, 0, 1.0, 2.0, 9.81);"


def matlab(step: str) -> tuple[str, str]:
    return ".m", MAIN.format(step)


MAIN = """function main()
y = [1; 0];
h = {};
for i = 1:100
y = y + h*rate(0, y, 1, 2, 9.81, 0);
end
end
function dy = rate(t, y, m, l, g, u)
dy = [y(2); 3*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)];
end
"""
LAST = "unsigned long last = 0;\n"
NOW = "unsigned long now = millis(); "
PLAIN = rates("y, d")
WRONG = [
    sketch("double dt = DT_MS / 1000;", "const int DT_MS = 10;\n"),
    sketch("double dt = DT_MS / 1000;", "#define DT_MS 10\n"),
    sketch("double dt = DT;", "#define DT (10/1000)\n"),
    sketch(NOW + "double dt = (now - last) / 1000; last = now;", LAST),
    sketch(NOW + "double dt = (double)((now - last) / 1000); last = now;", LAST),
    sketch(NOW + "int dt = (now - last) / 1000.0; last = now;", LAST),
    sketch("double dt = PERIOD / N;", "const int PERIOD = 1000, N = 3000;\n"),
    sketch("const byte dt = 0.01;"),
    sketch("int ms = 60 * 1000; double dt = ms / 1000.0;"),
    sketch("uint8_t ms = 300; double dt = ms / 1000.0;"),
    sketch("double dt = 8 >> 10;"),
    program(PLAIN, "int hz = 100; double h = 1 / hz;"),
    program(PLAIN, "const auto hz = 60; const auto h = 1 / hz;"),
    program(PLAIN, "int h = 0.01;"),
    program(rates("y, y"), "double h = 0.01;"),
    program(rates("y, p"), "double h = 0.01, *p = y;"),
    program(rates("y, y + 1"), "double h = 0.01;"),
    program(rates("y, &y[0]"), "double h = 0.01;"),
    matlab("int32(10)/1000"),
    matlab("double(1/int32(100))"),
    matlab("floor(1/100)"),
    (".jl", JULIA + "dy = y; h = 0.01\n" + AROUND),
    (".jl", JULIA + "dy = similar(y); h = 1 ÷ 100\n" + AROUND),
    (".jl", JULIA + "dy = similar(y); h = div(1, 100)\n" + AROUND),
]
RIGHT = [
    matlab("10/1000"),
    matlab("floor(10.5)/1000"),
    sketch("double dt = DT_MS / 1000.0;", "const int DT_MS = 10;\n"),
    sketch("double dt = DT_MS * 1e-3;", "#define DT_MS 10\n"),
    sketch("double dt = DT;", "#define DT (10/1000.0)\n"),
    sketch(NOW + "double dt = (now - last) / 1000.0; last = now;", LAST),
    sketch(NOW + "double dt = (double)(now - last) / 1000; last = now;", LAST),
    sketch("int ms = 20 * 1000; double dt = ms / 1e6;"),
    sketch("uint8_t ms = 10; double dt = ms / 1000.0;"),
    program(PLAIN, "int hz = 100; double h = 1.0 / hz;"),
    program(PLAIN, "int n = 4 / 2; double h = 0.01 / n;"),
    program(PLAIN, "double span = 1; int n = span / 0.01; double h = span / n;"),
    (".jl", JULIA + "dy = similar(y); h = 1 // 100\n" + AROUND),
]


def beside(folder: Path, suffix: str, text: str) -> tuple[str, ...]:
    path = folder / f"page{suffix}"
    path.write_text(text)
    found = mechanics.check(ROD, path, blame=False, function="acc" if suffix == ".ino" else None)
    assert found.verdict in (Verdict.PROVED, Verdict.CERTIFIED)
    return found.beside


@pytest.mark.sample(6)
@pytest.mark.parametrize(("suffix", "text"), WRONG)
def test_a_step_of_rounded_numbers_or_in_the_array_it_reads_is_quoted(
    tmp_path: Path, suffix: str, text: str
) -> None:
    assert beside(tmp_path, suffix, text)


@pytest.mark.sample(4)
@pytest.mark.parametrize(("suffix", "text"), RIGHT)
def test_a_step_of_numbers_that_are_not_rounded_is_not(
    tmp_path: Path, suffix: str, text: str
) -> None:
    assert not beside(tmp_path, suffix, text)


MATLAB = """function a = acc(theta, u, m, l, g)
arguments
    {0}
    m (1,1) double = 1
end
a = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);
end
"""


@pytest.mark.parametrize("kind", ["int32", "single", "logical", "char"])
def test_a_class_of_matlab_that_changes_an_argument_is_refused(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "acc.m"
    for line in (f"l (1,1) {kind}", f"l {kind} {{mustBePositive}} = 2"):
        path.write_text(MATLAB.format(line))
        with pytest.raises(InputError, match=f"class {kind} changes"):
            mechanics.check(ROD, path)
    for line in ("l (1,1) double", "l {mustBePositive} = 2", "l (1,1) double {mustBePositive}"):
        path.write_text(MATLAB.format(line))
        assert mechanics.check(ROD, path).verdict in (Verdict.PROVED, Verdict.CERTIFIED)


CLASS = """classdef Rod
properties
    m (1,1) double = 1
    l (1,1) {0} = 2
end
methods
function a = acc(o, theta, u, g)
a = 3*g/(2*o.l)*sin(theta) + 3*u/(o.m*o.l^2);
end
end
end
"""


def test_so_is_one_of_a_property(tmp_path: Path) -> None:
    path = tmp_path / "Rod.m"
    path.write_text(CLASS.format("int32"))
    with pytest.raises(InputError, match="class int32 changes"):
        mechanics.check(ROD, path)
    path.write_text(CLASS.format("double"))
    assert mechanics.check(ROD, path).verdict in (Verdict.PROVED, Verdict.CERTIFIED)
