"""C as controllers have it: macros with arguments, constants, arrays of arrays, loops."""

import pytest

from mechanics import check
from mechanics.errors import InputError
from systems import acrobot, cartpole, rod_pendulum

ROD, CART, ACROBOT = rod_pendulum.scene(), cartpole.scene(), acrobot.scene()
HEAD = "double theta_ddot(double theta, double theta_dot, double u, double m, double l, double g)"


def _verdict(scene: object, code: str) -> str:
    found = check(scene, code, notation="c", blame=False)  # type: ignore[arg-type]
    return found.verdict.name


MACROS = {
    "#define SQ(x) ((x)*(x))\n#define I(m, l) ((m)*SQ(l)/3)": "PROVED",
    "#define SQ(x) x*x\n#define I(m, l) (m*SQ(l)/3)": "PROVED",
    "#define SQ(x) x*x\n#define I(m, l) (m*SQ(l/2 + l/2)/3)": "REFUTED",
    "#define I(m, l) ((m)* \\\n    pow(l, 2) /* about the end */ /3)": "PROVED",
    "#ifndef I\n#define I(m, l) (m*l*l/3)\n#endif": "PROVED",
    "#define TWICE(f, x) f(f(x))\n#define HALF(x) ((x)/2)\n"
    "#define I(m, l) (4*(m)*TWICE(HALF, (l))*(l)/3)": "PROVED",
    "#define I(l, m) (m*l*l/3)": "REFUTED",
}


@pytest.mark.sample(2)
@pytest.mark.parametrize(("macros", "verdict"), MACROS.items())
def test_macros_with_arguments(macros: str, verdict: str) -> None:
    body = "return (m*g*l/2*sin(theta) + u)/I(m,\n l);"
    assert _verdict(ROD, f"#include <math.h>\n{macros}\n{HEAD}\n{{ {body} }}\n") == verdict


@pytest.mark.parametrize(
    ("macros", "words"),
    [
        ("#if defined(FAST)\n#define I(m, l) (m*l)\n#endif", "line 3, .*under a condition"),
        ("#define I(m, l) (m*l)\n#define I(m, l) (m+l)", "line 3, .*defined twice"),
        ("#define I(m) (m)", "takes 1 arguments, 2 found"),
        ("#define I(m, l) m ## l", "write a function"),
        ("#define I(m, l) I(m, l)", "the call I"),
        ("#define A(x) B(x)*B(x)\n#define B(x) A(x)*A(x)\n#define I(m, l) A(A(A(m)))", "line"),
        ("\n".join(f"#define A{k}(x) A{k + 1}(x)*A{k + 1}(x)" for k in range(30))
         + "\n#define I(m, l) A0(m)", "macros expand to more than"),
    ],
)  # fmt: skip
def test_macros_that_are_refused(macros: str, words: str) -> None:
    text = f"#include <math.h>\n{macros}\n{HEAD}\n{{ return u/I(m, l); }}\n"
    with pytest.raises(InputError, match=words):
        check(ROD, text, notation="c")


CONSTANTS = """#include <math.h>
static const double mc = 1.0, mp = 0.1;
const float l = 0.5f;
static double g = 9.8;
static double weight(double m) {{ return m*g; }}
void f(const double state[4], double force, double dxdt[4])
{{
    double s = sin(state[2]), c = cos(state[2]), total = mc + mp;
    double temp = (force {sign} mp*l*pow(state[3], 2)*s)/total;
    dxdt[0] = state[1];
    dxdt[2] = state[3];
    dxdt[3] = (weight(1)*s - c*temp)/(l*(4.0/3.0 - mp*c*c/total));
    dxdt[1] = temp - mp*l*dxdt[3]*c/total;
}}
"""


def test_constants_of_the_file() -> None:
    found = check(CART, CONSTANTS.format(sign="+"), notation="c", blame=False)
    assert found.verdict.name == "PROVED"  # of all values, as they have the scene's names
    assert "g = 9.8 is read as g: values in the code are not used" in str(found)
    wrong = check(CART, CONSTANTS.format(sign="-"), notation="c", blame=False)
    assert wrong.judged[1].verdict.name == "REFUTED"


@pytest.mark.parametrize("change", ["g = 3;", "g *= 2;", "g++;", "double *p = &g; *p = 3;"])
def test_a_number_of_the_file_that_changes_is_refused(change: str) -> None:
    text = CONSTANTS.format(sign="+").replace("{ return m*g", f"{{ {change} return m*g")
    with pytest.raises(InputError, match=r"line 4, .* outside of functions|may write"):
        check(CART, text, notation="c")


SOLVE = """#include <math.h>
#define DOF 2
static void solve(double A[DOF][DOF], double b[DOF], double x[DOF])
{{
    int i, j, k;
    for (k = 0; k < DOF; k++)
        for (i = k + 1; i <= DOF - 1; i++) {{
            double f = A[i][k]/A[k][k];
            for (j = k; j < DOF; j++) A[i][j] -= f*A[k][j];
            b[i] -= f*b[k];
        }}
    for (i = DOF - 1; i >= 0; i--) {{
        double s = b[i];
        for (j = i + 1; j < DOF; j++) s {sign}= A[i][j]*x[j];
        x[i] = s/A[i][i];
    }}
}}
void acrobot(const double *q, const double *qd, double tau, double m1, double m2, double l1,
             double lc1, double lc2, double I1, double I2, double g, double *qdd)
{{
    double c2 = cos(q[1]), s2 = sin(q[1]), d = m2*(lc2*lc2 + l1*lc2*c2) + I2;
    double A[DOF][DOF] = {{
        {{m1*lc1*lc1 + m2*(l1*l1 + lc2*lc2 + 2*l1*lc2*c2) + I1 + I2, 0}}, {{0, m2*lc2*lc2 + I2}}}};
    double b[DOF];
    A[0][1] = A[1][0] = d;
    b[0] = m2*l1*lc2*s2*(2*qd[0]*qd[1] + qd[1]*qd[1]) - (m1*lc1 + m2*l1)*g*sin(q[0])
         - m2*lc2*g*sin(q[0] + q[1]);
    b[1] = tau - m2*l1*lc2*s2*qd[0]*qd[0] - m2*lc2*g*sin(q[0] + q[1]);
    solve(A, b, qdd);
}}
"""


def test_arrays_of_arrays_and_loops() -> None:
    assert _verdict(ACROBOT, SOLVE.format(sign="-")) == "PROVED"
    assert _verdict(ACROBOT, SOLVE.format(sign="+")) == "REFUTED"
    other = SOLVE.format(sign="-").replace("{0, m2", "{m2")
    assert _verdict(ACROBOT, other) == "REFUTED"


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("b[1] = tau", "A[0] = 0; b[1] = tau", "line 28, .*give both places"),
        ("A[0][1] = A[1][0] = d;", "A[0][2] = A[1][0] = d;", "has 2 columns"),
        ("double A[DOF][DOF], double b", "double A[DOF][3], double b", "with 3 columns"),
        ("{0, m2*lc2*lc2 + I2}", "{0, m2*lc2*lc2 + I2, 0}", "is longer than 2"),
        ("s/A[i][i];", "s/A[i][i]; }\n{ x[i] = 0;", "code.c, line"),
    ],
)
def test_arrays_of_arrays_that_are_refused(old: str, new: str, words: str) -> None:
    text = SOLVE.format(sign="-").replace(old, new)
    with pytest.raises(InputError, match=words):
        check(ACROBOT, text, notation="c")


def test_fields_of_a_struct_may_be_of_all_kinds() -> None:
    text = """#include <math.h>
struct Pendulum { float theta, theta_dot; float m, l, g; };
float theta_ddot(struct Pendulum p, float u)
{ return 1.5f*p.g/p.l*sinf(p.theta) + 3.0f*u/(p.m*powf(p.l, 2.0f)); }
"""
    assert _verdict(ROD, text) == "PROVED"
    assert _verdict(ROD, text.replace("1.5f*p.g", "1.5f*p.m")) == "REFUTED"


SIDES = {
    "one result": "double push = m*g*l/2*sin(theta); if (u > 0) push += u; else push += u;"
                  "return push/(m*l*l/3);",
    "ways out": "if (u > 0) { double push = u; return (m*g*l/2*sin(theta) + push)/(m*l*l/3); }"
                "else if (theta < 0) return (u + m*g*l/2*sin(theta))/(m*l*l/3);"
                "double s = sin(theta); return (m*g*l/2*s + u)/(m*l*l/3);",
    "turns": "return (m*g*l/2*sin(fmod(theta, 2*M_PI)) + u)/(m*l*l/3);",
    "half turns": "return (u - m*g*l/2*sin(theta + M_PI))/(m*l*l/3);",
}  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("body", SIDES.values(), ids=SIDES.keys())
@pytest.mark.parametrize(("sign", "verdict"), [("", "PROVED"), ("2*", "REFUTED")])
def test_branches_and_constants_of_the_header(body: str, sign: str, verdict: str) -> None:
    body = body.replace("/(m*l*l/3)", f"/({sign}m*l*l/3)", 1)
    assert _verdict(ROD, f"#include <math.h>\n{HEAD}\n{{ {body} }}\n") == verdict


ARRAYS = {
    "both write": "if (u > 0) dx[1] = a; else dx[1] = b; dx[0] = x[1];",
    "one writes again": "dx[1] = b; dx[0] = x[1]; if (u > 0) { dx[1] = a; }",
    "read again": "dx[0] = x[1]; dx[1] = b; if (u > 0) dx[1] = a; double s = dx[1]; dx[1] = s;",
    "one ends": "dx[0] = x[1]; if (u > 0) { dx[1] = a; return; } dx[1] = b;",
}
RIGHT = "(m*g*l/2*sin(x[0]) + u)/(m*l*l/3)"


@pytest.mark.sample(2)
@pytest.mark.parametrize("body", ARRAYS.values(), ids=ARRAYS.keys())
@pytest.mark.parametrize("wrong", ["", "a", "b"])
def test_outputs_by_cases_are_all_judged(body: str, wrong: str) -> None:
    head = "void f(const double *x, double u, double m, double l, double g, double *dx)"
    sides = "".join(f"double {n} = {RIGHT.replace('+', '-' if n == wrong else '+')};" for n in "ab")
    found = _verdict(ROD, f"#include <math.h>\n{head}\n{{ {sides} {body} }}\n")
    assert found == ("REFUTED" if wrong else "PROVED")


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("double s; if (u > 0) s = 1; return s;", "s is read before it is set"),
        ("if (u > 0) return 1;", "Return is not supported"),
        ("if (u > 0) return 1; return 2; return 3;", "Return is not supported"),
        ("return M_PI;", "M_PI is not declared"),
    ],
)
def test_cases_without_a_value_are_refused(body: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        check(ROD, f"{HEAD} {{ {body} }}", notation="c")
