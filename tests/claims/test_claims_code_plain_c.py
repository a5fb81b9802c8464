"""C with structs of numbers and in single precision."""

import pytest

from mechanics import check
from mechanics.errors import InputError
from systems import elastic_pendulum

SCENE = elastic_pendulum.scene()
BODY = """
  {real} s = sin{f}(theta), c = cos{f}(theta), d = M/3*(M + m) - M*M/4{one}*c*c;
  {real} push = M*L*0.5{one}*theta_dot*theta_dot*s - 2*k*x;
  return (-(M + m)*M*g*s/2 - M*c/2*push)/(d*L);
"""
NAMES = ("x", "theta", "theta_dot", "M", "m", "L", "k", "g")


def _verdict(code: str) -> str:
    return check(SCENE, code, notation="c", blame=False).verdict.name


def test_single_precision_is_read_as_exact() -> None:
    head = ", ".join(f"float {name}" for name in NAMES)
    body = BODY.format(real="const float", f="f", one=".f")
    text = f"#include <math.h>\nfloat theta_ddot({head}) {{{body}}}\n"
    found = check(SCENE, text.replace("4.f", "4.0f").replace("0.5.f", "0.5f"), notation="c")
    assert found.verdict.name == "PROVED"
    assert "single precision (float, sinf, 0.5f) is read as exact numbers" in str(found)


STRUCT = """#include <math.h>
typedef struct {{
  double g, L; /* of the rod */
  double M, m, k;
}} par_t;
static double weight({kind}p) {{ return p{dot}M*p{dot}g; }}
double theta_ddot({kind}p, double x, double theta, double theta_dot)
{{
  double M = p{dot}M, m = p{dot}m, L = p{dot}L, k = p{dot}k;
  double s = sin(theta), c = cos(theta), d = M/3*(M + m) - M*M/4*c*c;
  double push = M*L*0.5*theta_dot*theta_dot*s - 2*k*x;
  return (-(M + m)*weight(p)*s/2 - M*c/2*push)/(d*L);
}}
"""


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("kind", "dot"),
    [("const par_t *", "->"), ("par_t *", "->"), ("par_t ", "."), ("const par_t * const ", "->")],
)
def test_a_struct_of_numbers_is_an_array_of_named_entries(kind: str, dot: str) -> None:
    found = check(SCENE, STRUCT.format(kind=kind, dot=dot), notation="c")
    assert found.verdict.name == "PROVED"
    assert any(match.name == "p" and match.meaning == "g L M m k" for match in found.names)
    wrong = STRUCT.format(kind=kind, dot=dot).replace(
        "return p" + dot + "M", "return p" + dot + "m"
    )
    assert _verdict(wrong) == "REFUTED"


def test_a_struct_with_a_tag() -> None:
    text = STRUCT.format(kind="const struct par *", dot="->")
    assert (
        _verdict(text.replace("typedef struct", "struct par").replace("} par_t;", "};")) == "PROVED"
    )


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("typedef struct { double a[3]; } p_t;\ndouble f(const p_t *p) { return p->a[0]; }",
         r"line 1, column 1: p_t has 'double a\[3\]': structs of double alone are known"),
        ("typedef struct { int n; } p_t;\ndouble f(const p_t *p) { return p->n; }",
         "p_t has 'int n': structs of double alone"),
        ("typedef struct { double m; } p_t;\ndouble f(double x) { p_t p = {1.0}; return x*p.m; }",
         "line 2, column 22: p_t is known here as the type of an argument only"),
        ("typedef struct { double m; } p_t;\nvoid g(p_t p) { p.m = 0; }\n"
         "double f(p_t p) { g(p); return p.m; }", "p is a p_t that is changed, or of two types"),
        ("typedef struct { double m; } p_t;\ndouble h(const double *p) { return p[0]; }\n"
         "double f(const p_t *p) { return p->m; }", "or of two types"),
        ("#include <math.h>\n#define sinf cosf\ndouble f(double x) { return sinf(x)*sin(x); }",
         "sinf is a word of C, and a macro here"),
        ("#define float int\ndouble f(double x) { return x/2; }",
         "float is a word of C, and a macro gives it another"),
        ("#include <math.h>\n#define sin cos\ndouble f(double x) { return sinf(x); }",
         "sin is a word of C"),
        ("typedef struct { double m; } p_t;\n" * 9 + "double f(double x) { return x; }",
         "it has 9 structs"),
    ],
)  # fmt: skip
def test_structs_that_are_not_known(text: str, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        check(SCENE, text, notation="c")
    assert "\n" not in str(caught.value)
