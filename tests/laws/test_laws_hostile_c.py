"""Statements put into a right function of C and C++: what a compiler's numbers refute is not shown.

Each text is compiled and called at drawn states, and judged. A text that computes something else
than the equation of motion may be refuted, in doubt or not read, and is never PROVED or CERTIFIED.
"""

import ctypes
import math
import random
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import rod_pendulum

ROD = rod_pendulum.scene()
COMPILERS = {".c": ("gcc", "-std=gnu11"), ".cpp": ("g++", "-std=c++17")}
PAGE = """#include <math.h>
#ifdef __cplusplus
extern "C" {{
#endif
double acc(double theta, double w, double u, double m, double l, double g) {{
  {inside}
  return 3*g/(2*l)*sin(theta) + 3*u/(m*l*l);
}}
#ifdef __cplusplus
}}
#endif
"""
INSIDE = (
    "", "l *= 2;", "l = l*2/2;", "g++;", "--g;", "{ double g = 0; g++; }", "g = (g, 0);",
    "if ((u = 0)) m = 2;", "static double c = 0; c += u; u = c;", "double *p = &l; *p = 2;",
    "for (;;) { m++; break; }", "while (l > 5) l--;", "do { m *= 2; } while (0);",
    "switch ((int)m) { case 0: m = 3; default: l = 2; }", "goto end; m = 2; end: ;",
    "theta = (int)theta;", "int i = theta; theta = i;", "unsigned k = -1; m = m*k;",
    "l = pow(l, 1/2);", "l = pow(l, 1/2.)*pow(l, 0.5);", "m += 1, l += 1;", "if (0) ; m = 2;",
    "if (1) {} else m = 2;", "// comment \\\nm = 2;", "m = m /* ; l = 2; */ ;", "(void)(m = 2);",
    "(void)m;", "m = !m;", "m = m > 0 && m;", "m = m || 0;", "m = (m > 5) + m;",
    "for (int i = 0; i < 3; i += 2) m++;", "for (int i = 0; i < 3; ++i) ; m++;",
    "for (int i = 0; i < 3; ++i) m *= i + 1; m /= 6;", "for (int i = 0; i <= 3; ++i) m *= 2;",
    "for (int i = 0; i < 3; ++i) { if (i == 1) continue; m *= 2; } m /= 4;",
    "for (int i = 0; i < 3; ++i) { if (i == 1) break; m *= 2; } m /= 4;",
    "int i; i = 3; for (i = 0; i < 1; i++) {} m = i*m/3;",
    "int n = 4; double s = 1; for (int i = 0; i < n; ++i) { n = 2; s *= 2; } m *= s/16;",
    "double a[2] = {1, 2}; m *= a[1]/2;", "double a[2] = {1, 2}; m *= a[0]/2;",
    "double a[3] = {1, 2}; m += a[2];", "double a[2] = {1, 2}; double *b = a; b[0] = 0; m *= a[0];",
    "double A[2][2] = {{1, 2}, {3, 4}}; m *= A[1][0]/2;",
    "double A[2][2] = {{1, 2}, {3, 4}}; m *= A[1][0]/3;", "float n; n = 0.1; m *= 10*n;",
    "float n = m; m = n;", "float q[1]; q[0] = m; m = q[0];", "m = (float)m;",
    "u = sinf(u)/sin(u)*u;",
    "int n = 5; m *= n/5; m += n/2 - 2;", "int n = 5; m *= n/2;",
    "short n = 70000; m *= n/70000.0;",
    "m = (1u - 2)*m;", "m = -1 < 1u ? m : 2*m;", "m = -7/2*m/-3;", "m = -7/2*m/-4;",
    "m = 010*m/10;", "m = 010*m/8;", "m = 'a'*m/97;", "m = 1e1*m/10;", "m = 1/2*m;",
    "m = m*1/2*2;", "m = m*(3/2);",
    "double k = 1; m *= k++; m /= k;", "double k = 2; double j = k; k = 1; m *= k*j/2;",
    "int k = 3; k *= 1.5; m *= k/4.5;", "double k = 3; k /= 3/2; m *= k/3;", "theta += 2*M_PI;",
    "theta += 2*3.1416;", "u = sqrt(u*u);", "theta = asin(sin(theta));", "m = fmax(m, 5);",
    "if (theta > 0) return 0;", "m = theta > 0 ? m : 1;", "m = 0 < theta < 1 ? m : 2*m;",
    "theta = fmod(theta, 3.141592653589793);", "m *= 1 + (0.1 + 0.2 == 0.3);",
)  # fmt: skip


def right(function: ctypes._CFuncPtr) -> bool:
    """Whether a function gives the acceleration at drawn states, but for rounding."""
    draw = random.Random(3)
    for _ in range(40):
        theta, w, u = (draw.uniform(-3, 3) for _ in range(3))
        m, l, g = (draw.uniform(0.3, 12) for _ in range(3))
        parts = 3 * g / (2 * l) * math.sin(theta), 3 * u / (m * l * l)
        found = function(theta, w, u, m, l, g)
        if not abs(found - sum(parts)) <= 1e-11 * sum(map(abs, parts)):
            return False
    return True


@pytest.mark.campaign
@pytest.mark.parametrize("suffix", COMPILERS)
@pytest.mark.parametrize("inside", INSIDE)
def test_what_is_shown_is_what_is_computed(tmp_path: Path, suffix: str, inside: str) -> None:
    compiler, standard = COMPILERS[suffix]
    if shutil.which(compiler) is None or sys.platform == "win32":
        pytest.skip(f"{compiler} is not installed")
    path, library = tmp_path / f"page{suffix}", tmp_path / "page.so"
    path.write_text(PAGE.format(inside=inside))
    flags = ("-w", "-O0", "-shared", "-fPIC", str(path), "-o", str(library), "-lm")
    if subprocess.run([compiler, standard, *flags], capture_output=True, check=False).returncode:
        pytest.skip("it is no text of this language")
    function = ctypes.CDLL(str(library)).acc
    function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double] * 6
    try:
        shown = mechanics.check(ROD, path, blame=False).verdict
    except InputError:
        return
    if shown in (Verdict.PROVED, Verdict.CERTIFIED):
        assert right(function)
    else:
        assert inside  # what is right without it is shown
