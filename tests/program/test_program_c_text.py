"""C text as arithmetic: what is modelled has the value that C gives it, the rest is refused.

Every row is a function ``void f(const double x[2], double y[1])``, or a change of it.
"""

from fractions import Fraction

import pytest
from sympy import Symbol, cos, pi, sin

from mechanics.errors import ExpressionError
from mechanics.kernel import Statement, decide
from mechanics.program import Builder, Node, sympy_reader
from mechanics.program.as_written import AsWritten
from mechanics.program.c.function import Function, Parameter
from mechanics.program.c.literal import literal
from mechanics.program.c.nodes import Nodes
from mechanics.program.c.parse import parse
from mechanics.program.c.reader import read_function

a, b = Symbol("x0", real=True), Symbol("x1", real=True)
GIVEN = (Parameter("x", "double", 2), Parameter("y", "double", 1, True))
HEAD = "void f(const double x[2], double y[1])"


def read(body: str, before: str = "", head: str = HEAD, builder: Builder | None = None) -> Function:
    builder = builder or Builder()
    x = [builder.input("x0"), builder.input("x1")]
    source = parse(f"{before}\n{head} {{ {body} }}", "f.c")
    return read_function(source, "f", GIVEN, Nodes(builder, [x, ()]))


def operations(builder: Builder, function: Function) -> int:
    nodes = [Node(builder, w.node) for written in function.outputs.values() for w in written]
    return builder.program({"y": nodes}).count


VALUES = [
    ("y[0] = x[0] - x[1] * 2;", a - 2 * b),
    ("y[0] = x[0] - (x[1] - 2.0);", a - b + 2),
    ("y[0] = x[0]; return;", a),
    ("y[0] = 1 / 2 * x[0] + 7 / 2 + -7 % 4;", 0 * a),
    ("y[0] = 1 / 2.0 * x[0];", a / 2),
    ("y[0] = 0x1.8p+1 + 1e1 + .5 + 010;", Fraction(43, 2)),
    ("y[0] = sin(x[0]) + cos(-x[1]);", sin(a) + cos(b)),
    ("double s, c; sincos(x[0], &s, &c); y[0] = s * s + c * c;", 1),
    ("double s = x[0]; s = s * s; s -= x[1]; y[0] = s;", a**2 - b),
    ("double t[3] = {1.0, x[1]}; y[0] = t[0] + t[1] + t[2] * x[0];", 1 + b),
    ("double s = 0.0; for (int i = 0; i < 2; ++i) s += x[i]; y[0] = s;", a + b),
    ("double s = 0.0; for (int i = 1; i < 6; i += 2) s += i * x[0]; y[0] = s;", 9 * a),
    ("const double *p = x + 1; y[0] = p[0] + *x;", a + b),
    ("const int two = 1 + 1; if (two == 2) { y[0] = x[0]; } else { y[0] = x[1]; }", a),
    ("(void)x; y[0] = fma(2.0, 3.0, 1.0);", 7),
    ("y[0] = 0 < 1 ? x[0] : x[1];", a),
]


@pytest.mark.parametrize(("body", "value"), VALUES)
def test_what_is_modelled_has_the_value_of_c(body: str, value: object) -> None:
    for builder in (Builder(), AsWritten()):
        function = read(body, builder=builder)
        ((written,),) = function.outputs.values()
        right = builder.node(value) if isinstance(value, int | Fraction) else None
        sides = {
            "left": [Node(builder, written.node)],
            "right": [right] if right is not None else sympy_reader.read(builder, [value]),
        }
        assert decide(Statement(body, builder.program(sides))).shown
        assert not function.late and not function.beyond


BRANCHES = [
    "double s; if (x[0] < 1.0) s = x[0]; else s = x[1]; y[0] = s;",
    "double s = x[1]; if (x[0] < 1.0) { double t = x[0]; s = t; } y[0] = s;",
    "double s = x[1]; if (x[0] < 1.0) { if (x[0] < 1.0) s = x[0]; else s = 7.0; } y[0] = s;",
    "double t[1] = {x[1]}; if (x[0] < 1.0) t[0] = x[0]; y[0] = t[0];",
    "double t[1]; if (x[0] < 1.0) t[0] = x[0]; else t[0] = x[1]; y[0] = t[0];",
    "double s = 7.0, t[1]; if (x[0] < 1.0) { t[0] = x[0]; s = t[0]; } else s = x[1]; y[0] = s;",
    "y[0] = x[1]; if (x[0] < 1.0) y[0] = x[0]; double s = y[0]; y[0] = 1.0; y[0] = s;",
]


@pytest.mark.parametrize("body", BRANCHES)
def test_a_branch_that_sets_a_number_is_a_choice(body: str) -> None:
    builder = Builder()
    choice = "(x[0] < 1.0) ? x[0] : x[1]"
    for wanted, sign in ((choice, ""), (f"-({choice})", "-")):
        (right,) = read(f"y[0] = {wanted};", builder=builder).outputs.values()
        (left,) = read(f"{body} y[0] = {sign}y[0];", builder=builder).outputs.values()
        nodes = [Node(builder, one[-1].node) for one in (left, right)]
        program = builder.program({"left": nodes[:1], "right": nodes[1:]})
        assert decide(Statement(body, program)).shown


def test_functions_and_macros_of_the_file_are_read() -> None:
    before = """
        #define TWO 2.0   /* a macro */
        static inline double half(double z) { return z / TWO; }
        #ifdef __GNUC__
        #error not here
        #endif
    """
    builder = AsWritten()
    function = read("y[0] = half(x[0] + half(x[1]));", before, builder=builder)
    assert operations(builder, function) == 3 and not function.status


def test_an_error_that_compilers_may_meet_changes_no_text() -> None:
    """What is under the condition but is no #error counts."""
    error = '#if defined(__FAST_MATH__) || __FINITE_MATH_ONLY__\n#error "no"\n#endif'
    source = parse(f"{error}\n{HEAD} {{ y[0] = x[0]; }}", "f.c")
    assert "f" in source.functions and not source.asked
    with pytest.raises(ExpressionError, match="__FINITE_MATH_ONLY__ in #if is not supported"):
        read("y[0] = x[0];", error.replace("#endif", "#define sin cos\n#endif"))
    with pytest.raises(ExpressionError, match=r"f\.c:1: #error \"no\" is not supported"):
        parse('#error "no"\n', "f.c")


REFUSED = [
    ("y[0] = 1.0f * x[0];", "a float stands beside a double"),
    ("float s = x[0]; y[0] = x[0];", "a double stands where a float"),
    ("int n = x[0]; y[0] = x[0];", "an integer is expected"),
    ("y[0] = sinf(x[0]);", "a double stands where a float"),
    ("y[0] = (float)x[0];", "precisions are mixed"),
    ("double s; y[0] = s;", "s is read before it is set"),
    ("double t[2]; y[0] = t[1];", "t[1] is read before it is set"),
    ("const double s = x[0]; s = x[1]; y[0] = s;", "the constant s is changed"),
    ("double s = x[0]; double s = x[1]; y[0] = s;", "s is declared twice"),
    ("x[0] = 1.0; y[0] = 1.0;", "x must not be changed"),
    ("y[1] = x[0];", "y[1] is beyond its 1 entries"),
    ("y[0] = z;", "z is not declared"),
    ("y[0] = x[0] / (1 / 0);", "the integer division of 1 by 0"),
    ("y[0] = 2147483647 + 1;", "does not fit into an int"),
    ("y[0] = 1.0L;", "long double"),
    ("y[0] = gamma(x[0]);", "the call gamma() is not supported"),
    ("y[0] = isfinite(x[0]) ? x[0] : x[1];", "isfinite(...) decides a value"),
    ("if (x[0] < 1.0) y[0] = x[0]; double s = 1.0; while (s < 2.0) s = 3.0;", "While"),
    ("static double s = 1.0; y[0] = s;", "s keeps its value between calls"),
    ("volatile double s = x[0]; y[0] = s;", "volatile is not supported"),
    ("double s; if (x[0] < 1.0) s = 1.0; y[0] = s;", "s is read before it is set"),
    ("double t[1]; if (x[0] < 1.0) t[0] = 1.0; y[0] = t[0];", "t[0] is set under a condition only"),
    (
        "double s; for (int i = 0; i < 2; ++i) { if (x[0] < 1.0) continue; s = 1.0; }",
        "s is set under a condition only",
    ),
    ("goto end; end: y[0] = x[0];", "Goto"),
    ("y[0] = (x[0], x[1]);", "ExprList"),
    ("y[0] = x[0] % 2;", "% of real numbers"),
    ("double x = 1.0; y[0] = x;", "x is declared twice"),
    ("y[0] = sizeof(x);", "sizeof"),
]


@pytest.mark.parametrize(("body", "words"), REFUSED)
def test_what_is_not_modelled_is_refused_by_name(body: str, words: str) -> None:
    with pytest.raises(ExpressionError) as refusal:
        read(body)
    assert words in str(refusal.value) and "\n" not in str(refusal.value)


HEADS = [
    ("void f(double x[2], double y[1])", "x has 2, and is read"),
    ("void f(const float x[2], double y[1])", "x of type double is expected"),
    ("void f(const double x[3], double y[1])", "with 3 entries"),
    ("void f(const double x[2])", "has 1 arguments, 2 are expected"),
    ("double f(const double x[2], double y[1])", "returns nothing"),
]


@pytest.mark.parametrize(("head", "words"), HEADS)
def test_other_arguments_are_refused(head: str, words: str) -> None:
    with pytest.raises(ExpressionError, match=words.replace("[", r"\[")):
        read("y[0] = x[0];", head=head)


DIRECTIVES = [
    ("#define f(x) x", "takes arguments"),
    ("#include <complex.h>", "is not supported"),
    ('#include "none.h"', "is not supported"),
    ('#pragma GCC optimize("fast-math")', "is not supported"),
    ("#if 1", "has no #endif"),
    ("#else", "#else without #if"),
    ("int a ??= 3;", "trigraph"),
    ("int n = 3;", "outside of functions"),
    ("void f(", "no C"),
    ("@", "no token of C"),
]


@pytest.mark.parametrize(("text", "words"), DIRECTIVES)
def test_a_file_that_is_not_known_is_refused(text: str, words: str) -> None:
    with pytest.raises(ExpressionError, match=words):
        parse(f"{text}\n", "f.c")


def test_two_declarations_have_to_agree() -> None:
    with pytest.raises(ExpressionError, match="is declared as"):
        read("y[0] = x[0];", before="void f(const double *x, float *y);")


def test_arguments_are_bound_by_their_place() -> None:
    swapped = read("y[0] = x[0];", head="void f(const double z[2], double y[1])".replace("z", "x"))
    named = read("u[0] = v[0];", head="void f(const double v[2], double u[1])")
    assert swapped == named


def test_reads_beyond_and_after_a_write_are_noted() -> None:
    assert read("y[0] = x[2];").beyond == ("f.c:2:49: x[2]",)
    assert not read("y[0] = x[1];").beyond
    assert read("y[0] = x[1]; const double s = x[0]; y[0] = s;").late


LANES = (
    Parameter("count", "size_t"), Parameter("stride", "size_t"),
    Parameter("x", "double", 2, False, "stride"), Parameter("p", "double", 2),
    Parameter("y", "double", 1, True, "stride"),
)  # fmt: skip
BATCH = """void f(size_t count, size_t stride, const double *x, const double *p, double *y) {
    for (size_t i = 0; i < count; ++i)
        y[i] = x[i] + p[1] * x[1 * stride + i]; }"""


def lanes(text: str, builder: Builder) -> Function:
    groups = ([builder.input(f"{name}{k}") for k in range(2)] for name in "xp")
    return read_function(parse(text), "f", LANES, Nodes(builder, [(), (), *groups, ()]))


def test_one_lane_stands_for_all() -> None:
    builder = Builder()
    function = lanes(BATCH, builder)
    assert function.lanes == "count" and operations(builder, function) == 2


CHANGED = [
    ("x[i]", "x[i + 1]", "is no entry of the lane"),
    ("y[i]", "y[0]", "is no entry of the lane"),
    ("x[1 * stride + i]", "x[2 * i]", "is no entry of the lane"),
    ("i < count", "i < stride", ""),
    ("i < count", "i <= count", "a loop is expected"),
    ("i = 0", "i = 1", "begins with the first"),
    ("++i", "i += 2", "is no entry of the lane"),
    ("y[i]", "y[stride + i]", "beyond its 1 entries"),
    ("y[i] = x[i]", "p[0] = x[i]", "must not be changed"),
]


@pytest.mark.parametrize(("old", "new", "words"), CHANGED)
def test_a_lane_touches_its_own_entries_only(old: str, new: str, words: str) -> None:
    text = BATCH.replace(old, new)
    if not words:
        # The function of another count: the caller compares which argument counts.
        assert lanes(text, Builder()).lanes == "stride"
        return
    with pytest.raises(ExpressionError) as refusal:
        lanes(text, Builder())
    assert words in str(refusal.value)


def test_literals_are_rounded_once_to_their_type() -> None:
    assert literal("0.1").value == Fraction(0.1)
    assert literal("0.1f").value == Fraction(13421773, 2**27)
    # Between two floats, above the middle by less than a double can tell.
    assert literal("1.00000005960464477540").value == Fraction(1 + 2.0**-24)
    assert literal("1.00000005960464477540f").value == Fraction(1 + 2.0**-23)
    assert literal("0x1.000001p+0f").value == 1
    assert literal("0x1p-1074").value == Fraction(2) ** -1074
    with pytest.raises(ExpressionError, match="beyond the largest float"):
        literal("1e39f")


def test_pi_is_no_number_of_c() -> None:
    with pytest.raises(ExpressionError, match="M_PI is not declared"):
        read("y[0] = M_PI;")
    assert pi.is_irrational
