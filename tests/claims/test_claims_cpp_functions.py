"""Methods of C++ as code: structs, members, vectors, casts, numbers of integers."""

from pathlib import Path

import numpy as np
import pytest

import mechanics
from mechanics.claims.code.translation.cpp_functions import in_python
from mechanics.claims.code.translation.python_page import Unread
from mechanics.errors import InputError
from systems import rod_pendulum


def function(text: str):
    (one,) = in_python(text, "page.cpp", None).functions
    return one


def test_a_method_takes_its_members_as_arguments() -> None:
    one = function(
        "std::vector<double> Cart::operator()(std::vector<double> x, double t) const {\n"
        "  const double& rate{x.at(1)};\n"
        "  std::vector<double> dx(2);\n  dx[0] = rate; dx.at(1) = -conf::k/m*x[0] + 1/2;\n"
        "  return dx;\n}"
    )
    assert list(one(x=np.array([3.0, 5.0]), k=4.0, m=2.0)) == [5.0, -6.0]


def test_a_struct_is_its_fields_and_a_cast_is_its_argument() -> None:
    one = function(
        "struct State { double x; double v; };\n"
        "double a(const State &s, void *p) { double *q = static_cast<double *>(p);\n"
        "  return -q[0]*s.x - std::sin(s.v); }"
    )
    assert one(s=[2.0, 0.0], p=[3.0]) == -6.0


def test_what_is_filled_is_returned_and_loops_are_followed() -> None:
    one = function(
        "int f(const double x[], double dx[]) {\n"
        "  for (int i = 0; i < 2; ++i) { dx[i] = x[i]; }\n"
        "  if (x[0] > 1) { dx[0] += 1; } else dx[0] = 0;\n  return 0;\n}"
    )
    assert list(one(x=[3.0, 5.0])) == [4.0, 5.0]


@pytest.mark.parametrize(
    "body",
    [
        "while (x > 1) x -= 1; return x;", "return x.norm();",
        "double& other = x; other = -other; return x;", "int k = 2.9; return k*x;",
        "double a = x; const double& b = a; a = 0; return b;", "long long k = 2.9; return k*x;",
        "double a[1] = {x}; double *b = a; b[0] = 0; return a[0];",
        "int a[1]; a[0] = 2.9; return x;",
        "static double k = 0; k += 1; return k*x;", "double s = x; { double s = 0; } return s;",
        "double s = x; for (int i = 0; i < 3; ++i) { i += 1; s += x; } return s;",
    ],
)  # fmt: skip
def test_what_is_not_known_is_refused_by_its_line(body: str) -> None:
    with pytest.raises(Unread, match="line 2"):
        function(f"double f(double x) {{\n{body}\n}}")


def test_a_method_is_called_with_the_members_that_it_reads() -> None:
    one = function(
        "struct Cart { double a(double u) const { return u/mass(2); }\n"
        "  double mass(int n) const { return n*m; } double m = 1.0; };"
    )
    assert one(u=6.0, m=3.0) == 1.0


@pytest.mark.parametrize(
    "text",
    [
        "double f(double x) { return f(x); }",
        "double f(double x) { return x; }\ndouble f(float x) { return 2*x; }",
        "long half(double x) { return x; }\ndouble f(double x) { return half(x); }",
        "double g(double &x) { x = 0; return x; }\ndouble f(double x) { return g(x) + x; }",
        "double f(double x) { if (x > 1) { double k = 0; return k; } double k = 1; return k*x; }",
        "double sin(double x) { return x; }\ndouble f(double x) { return sin(x); }",
        "double g(double m) { return k*m; }\ndouble f(double k) { return g(k); }",
        "double h(double x) { double c = 1; return c*x; }\n"
        "double f(double x) { double c = 2; return c*h(x); }",
        "struct G { double& x; ~G() { x = -x; } };\ndouble f(double x) { { G g{x}; } return x; }",
        "double half(int n) { return n*0.5; }\ndouble f(double x) { return half(2.9)*x; }",
        "#ifdef FAST\n#define K 2\n#else\n#define K 3\n#endif\ndouble f(double x) { return K*x; }",
    ],
)
def test_what_means_two_things_is_refused(text: str) -> None:
    with pytest.raises(Unread):
        function(text)


def test_an_early_return_ends_the_function() -> None:
    one = function("void f(const double x[], double dx[]) {\n  dx[0] = 1; dx[1] = x[1];\n"
                   "  if (x[0] > 1) return;\n  dx[0] = 2;\n}")  # fmt: skip
    assert list(one(x=[3.0, 5.0])) == [1.0, 5.0]
    assert list(one(x=[0.0, 5.0])) == [2.0, 5.0]


@pytest.mark.parametrize(
    ("quotient", "value"),
    [
        ("(x > 0 ? 3 : 1)/2", 1), ("2*(1 < 2)/4", 0), ("-3/-2", 1), ("-3/2", -1), ("3u/2u", 1),
        ("abs(3)/2", 1), ("(!0 + 2)/2", 1), ("(x > 0 ? 3 : 1.0)/2", 1.5),
    ],
)  # fmt: skip
def test_integers_are_divided_as_c_does(quotient: str, value: float) -> None:
    assert function(f"double f(double x) {{ return x*({quotient}); }}")(x=1.0) == value


def test_what_is_unsigned_is_not_negative() -> None:
    with pytest.raises(ValueError, match="unsigned"):
        function("double f(double x) { unsigned k = 1; return x*(k - 2); }")(x=1.0)


def test_brackets_before_a_sign_are_no_cast() -> None:
    assert function("double f(double x, double y) { return (x) - (y); }")(x=3.0, y=1.0) == 2.0


TWICE = "struct D { double v; D(double x): v(2*x) {} operator double() const { return v; } };\n"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (TWICE + "double f(double x) { D a = x; return a; }", "class D has conversions"),
        (TWICE + "using E = D;\ndouble f(double x) { E a = x; return a; }", "E is made of"),
        (TWICE + "struct E: D { using D::D; };\ndouble f(double x) { E a = x; return a; }", "E is"),
        (TWICE + "D f(D x) { return x; }", "class D has conversions"),
        ("template<class T> struct R { T v; operator T() { return 2*v; } };\n"
         "double f(double x) { R<double> a{x}; return a; }", "class R has conversions"),
        ("struct V { double x; };\nV operator*(double a, V b) { return {0}; }\n"
         "V f(V a, double b) { return b*a; }", "class V has conversions"),
        ("struct S { double x, v; S(double v, double x): x(x), v(v) {} };\n"
         "S f(double a, double b) { return {a, b}; }", "class S has conversions"),
        ("typedef int real;\nreal f(real x) { return x; }", "real is an integer type"),
        ("#define real int\nreal f(real x) { return x; }", "real is an integer type"),
        ("double f(double x) { decltype(1) a = x; return a; }", "write the type"),
        ("double f(int x) { return x/2; }", "x is an integer"),
        ("class P { int g, l; double f(double x) { return g/l*x; } };", "g is an integer"),
        ("int g;\ndouble f(double x) { return g*x; }", "g is an integer"),
        ("enum { g = 3 };\ndouble f(double x) { return g/2*x; }", "g is an integer"),
        ("template<class T> T f(T x) { return x/2; }\ntemplate int f<int>(int);", "for integers"),
        ("class P { double m, l; P(double mass, double l): m(l), l(mass) {}\n"
         "  double f(double x) { return x*m/l; } };", "m of an object is not"),
        ("auto f(double x) -> int { return x; }", "rounded to an integer"),
        ("Eigen::Vector2i f(double x, double v) { return {x, v}; }", "rounded to an"),
        ("union U { double d; long n; };\ndouble f(U x) { return x.d; }", "U is a union"),
        ("#define true 0\ndouble f(double x) { if (true) return x; return 2*x; }", "a macro"),
    ],
)  # fmt: skip
def test_types_that_change_what_they_are_given_are_refused(text: str, words: str) -> None:
    with pytest.raises(Unread, match=words):
        function(text)


@pytest.mark.parametrize(
    "text",
    [
        "double f(double x) { Q15 a = x; return a; }",
        "double f(double x) { lib::Q15 a = x; return a; }",
        "double f(double x) { __int128 a = x; return a; }",
        "double f(double x) { return Q{x}; }",
        "double f(const V& x) { return x(0); }",
        "Q15 g(double x) { return x; }\ndouble f(double x) { return g(x); }",
        "struct P { Q15 g; double f(double x) { return g*x; } };",
        "std::pair<double, int> f(double x) { return {x, x}; }",
        "template<class T = int> T g(double x) { return x; }\ndouble f(double x) { return g(x); }",
        "double f(double x) { thread_local double a = x; return a; }",
        "double f(double x) { return lib::sin(x); }",
        "#include <cmath>\ndouble f(double x) { return abs(x); }",
        "void f(double *x, double *y) { y = x; y[0] = x[0]; }",
    ],
)
def test_a_type_or_function_that_is_not_here_is_not_read(text: str) -> None:
    with pytest.raises(Unread):
        function(text)


@pytest.mark.parametrize(
    "text",
    [
        "using namespace std;\ndouble f(double x, double v) { return abs(x)*v; }",
        "template<class T = double> T f(T x, T v) { return x*v; }",
        "typedef double real;\nreal f(real x, real v) { real a = x*v; return a; }",
        "#define real double\nreal f(real x, real v) { return x*v; }",
        "typedef struct { double x, v; } S;\ndouble f(double x, double v) { return x*v; }",
        "struct S { double x, v; S(): x(0), v(0) {} S(double x_, double v_): x(x_), v(v_) {}\n"
        "  double f() { return x*v; } };",
        TWICE.replace("v", "w") + "double f(double x, double v) { return x*v; }",
    ],
)
def test_types_that_change_nothing_are_read(text: str) -> None:
    assert function(text)(x=3.0, v=2.0) == 6.0


@pytest.mark.parametrize(
    ("turns", "words"), [(10**9, "64 at most"), (60, "more than 300000 operations")]
)
def test_loops_and_formulas_are_bounded(turns: int, words: str, tmp_path: Path) -> None:
    path = tmp_path / "page.cpp"
    path.write_text(
        "double acceleration(double theta, double m) { double y = theta;\n"
        f"for (int i = 0; i < {turns}; ++i) {{ y = y*y + y; }} return y*m; }}",
        encoding="utf-8",
    )
    with pytest.raises(InputError, match=words):
        mechanics.check(mechanics.derive(rod_pendulum.scene(), "free_body"), path)


@pytest.mark.parametrize(
    ("before", "body", "name"),
    [
        ("#define g 9.81", "return 1.5*g/l*std::sin(theta) + 3*u/(m*l*l);", "g"),
        ("#define theta 0.5", "return 1.5*g/l*std::sin(theta) + 3*u/(m*l*l);", "theta"),
        ("", "double sin = 2*cos(theta); return 1.5*g/l*sin(theta) + 3*u/(m*l*l);", "sin"),
    ],
)
def test_no_variable_is_named_like_a_macro_or_a_function_that_is_called(
    before: str, body: str, name: str, tmp_path: Path
) -> None:
    path = tmp_path / "own.cpp"
    head = "double acc(double theta, double theta_dot, double u, double m, double l, double g)"
    path.write_text(f"#include <cmath>\n{before}\n{head} {{ {body} }}\n")
    with pytest.raises(InputError, match=f"{name} is declared twice: rename one"):
        mechanics.check(rod_pendulum.scene(), path)


def test_a_reference_to_a_single_number_rounds_what_it_is_given(tmp_path: Path) -> None:
    path = tmp_path / "own.cpp"
    path.write_text(
        "#include <cmath>\nstatic double half(const float &x) { return 0.5*x; }\n"
        "double acc(double theta, double theta_dot, double u, double m, double l, double g)"
        " { return 3*half(g)/l*std::sin(theta) + 3*u/(m*l*l); }\n"
    )
    found = mechanics.check(rod_pendulum.scene(), path, blame=False)
    assert found.verdict.name == "UNDECIDED"
    assert "right if single precision counts as exact" in found.judged[0].finding.evidence
