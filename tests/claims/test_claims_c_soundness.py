"""C whose meaning the file alone does not tell is refused; what it tells is read as C has it."""

import re

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.program.c.tokens import lines, tokens
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
HEAD = "double theta_ddot(double th, double w, double u, double m, double l, double g)"
REST = "*g/(2*l)*sin(th) + 3*u/(m*l*l); }\n"


def file_of(body: str = "return 3", above: str = "#include <math.h>\n") -> str:
    return f"{above}{HEAD} {{ {body}{REST}"


def verdict(text: str) -> str:
    (judged,) = mechanics.check(SCENE, text, notation="c", blame=False).judged
    return judged.finding.verdict.name


ACCEPTED = {
    "plain": file_of(),
    "guard": f"#ifndef ROD_H\n#define ROD_H\n{file_of()}#endif\n",
    "reserved guard": f"#ifndef __ROD_H__\n#define __ROD_H__\n{file_of()}#endif\n",
    "extern C": file_of(
        above='#ifdef __cplusplus\nextern "C" {\n#endif\n'
        f"{HEAD};\n#ifdef __cplusplus\n}}\n#endif\n#include <math.h>\n"
    ),
    "own switch": file_of(above="#define FULL\n#ifdef FULL\n#define N 3\n#endif\n").replace(
        "return 3", "return N"
    ),
    "pi where the header has none": file_of(
        "return 3*(M_PI/M_PI)", "#ifndef M_PI\n#define M_PI 3.14159265358979323846\n#endif\n"
    ),
    "both sides alike": file_of(
        above="#ifndef M_PI\n#define M_PI 3.14159265358979323846\n#endif\n"
    ),
    "nothing but an error": file_of(above='#ifndef __STDC__\n#error "no C"\n#endif\n'),
    "never": file_of(above="#if 0\n#define sin cos\n#endif\n"),
    "guards of what was put together": file_of(
        above="#ifndef A_H\n#define A_H\ndouble a(double x);\n#endif\n"
        "#ifndef B_H\n#define B_H\nstatic double b(double x) { return x; }\n#endif\n"
    ),
    "a guard of any name": f"#ifndef ROD\n#define ROD\n{file_of()}#endif\n",
    "prototype of the library": file_of(above="double sin(double);\n"),
    "macro for a library function": file_of(above="#define SINE sin\n").replace("*sin(", "*SINE("),
    "macro that is undone": file_of(above="#define cos sin\n").replace("*sin(", "*cos("),
    "a local called cos": file_of("double cos = 3; return cos"),
    "unsigned counter": file_of(
        "double k = 0; for (size_t i = 0; i < 3; ++i) k = k + -1; return -1*k"
    ),
    "unsigned quotient": file_of("return 7u/2"),
    "signed comparison": file_of("double k = 4; if (-1 < 1) k = 3; return k"),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("text", ACCEPTED.values(), ids=ACCEPTED.keys())
def test_what_every_compiler_reads_alike_is_proved(text: str) -> None:
    assert verdict(text) == "PROVED"


def test_a_macro_that_makes_sin_cos_is_followed() -> None:
    assert verdict(file_of(above="#define sin cos\n#include <math.h>\n")) == "REFUTED"


OWN = [
    f"{storage}double {name}(double x{more}) {{ return x; }}\n"
    for storage in ("", "static ", "static inline ")
    for name, more in (
        ("sin", ""), ("cos", ""), ("sqrt", ""), ("fabs", ""), ("pow", ", double y"),
        ("fma", ", double y, double z"), ("mechanics_sin", ""), ("isfinite", ""),
    )
]  # fmt: skip

CONDITIONS = [
    f"{condition}\n#define N 4\n#else\n#define N 3\n#endif\n"
    for condition in (
        "#ifdef __GNUC__", "#ifndef _MSC_VER", "#if defined(__x86_64__)", "#if !defined __clang__",
        "#ifdef __cplusplus", "#ifdef __STDC_VERSION__", "#if __STDC_VERSION__ >= 199901L",
        "#ifdef linux", "#ifdef M_PI", "#ifdef NAN", "#ifdef DBL_MAX", "#ifdef isfinite",
        "#ifdef OWN\n#elif defined(__GNUC__)", "#ifdef /* which? */ __GNUC__",
        "#ifdef NDEBUG", "#ifndef USE_FRICTION", "#if defined(FAST) || 0", "#ifdef ROD_H",
        "#if 0\n#elif defined NDEBUG", "#if !defined(FAST) && !defined(SLOW)",
        "#if \\\n defined(__GNUC__)", "  #  if 0 || (defined(__GNUC__) && 1)",
    )
]  # fmt: skip

UNSIGNED = [
    "return (-1 < 1u ? 4 : 3)",
    "return (1u > -1 ? 3 : 4)",
    "return (-1 == 4294967295u ? 4 : 3)",
    "unsigned a = 1; return ((a - 2) + 1)*0 + 3",
    "unsigned a = 1; int b = -1; return (b < a ? 3 : 4)",
    "unsigned a = -1; return a + 4",
    "size_t a = 1; return (a - 2 < 0 ? 3 : 4)",
    "return (-7/2u) + 6",
    "return -1u + 4",
    "return (unsigned) -1 + 4",
    "return (uint32_t) -1*w + w + 3",
    "return (1 ? -1 : 1u) + 4",
    "return 3 + (0u - 1 >> 31)",
    "unsigned a = 3; return -a + 6.0",
]

SETTINGS = [
    "#ifdef NDEBUG\n#define N 4\n#endif\n#ifndef N\n#define N 3\n#endif\n",
    "#ifndef FAST\n#define FAST\n#define N 3\n#endif\n#ifndef N\n#define N 4\n#endif\n",
    "#ifndef ROD_H\n#define ROD_H\n#define N 3\n#endif\n#ifndef N\n#define N 4\n#endif\n",
    "#ifndef ROD_H\n#define ROD_H\n#define N 3\n#else\n#define N 4\n#endif\n",
    '#ifdef __cplusplus\nextern "C" {\n#define N 4\n#else\n#define N 3\n#endif\n',
    "#ifdef A\n#ifdef B\n#define N 4\n#endif\n#endif\n#ifndef N\n#define N 3\n#endif\n",
]

SPELLING = [
    "#define double float\n", "#define return\n", "#define if while\n", "#define const\n",
    "#undef sin\n", "#line 3\n", "#pragma STDC FENV_ACCESS ON\n", '#include "own.h"\n',
    "#include <tgmath.h>\n", '_Pragma("STDC FP_CONTRACT ON")\n', "// ??/\n", "// a\rint b;\n",
    "#define N 3 /\\\n* */ 4\n", "#define N 1\\\n3\n", "%:define N 3\n", "// a \x1a b\n",
]  # fmt: skip

REFUSED = [
    *(file_of("return N", above) for above in SETTINGS),
    *(file_of(above=above) for above in SPELLING),
    *(file_of(above=own) for own in OWN),
    *(file_of("return N", above) for above in CONDITIONS),
    *(file_of(body) for body in UNSIGNED),
    file_of(above="float sin(float);\n"),
    file_of(above="double sin(float);\n"),
    file_of(above="double sin(void);\n"),
    file_of(above="static double sin(double);\n"),
    file_of("double sin = 3; return sin"),
    file_of("return M_PI", "#define M_PI 3\n#include <math.h>\n"),
    file_of("return M_PI", "#ifndef M_PI\n#define M_PI 3\n#endif\n"),
    file_of("return NAN", "#define NAN 3\n#include <math.h>\n"),
    f"#ifndef _MATH_H\n#define _MATH_H\n{file_of()}#endif\n",
    f"#ifndef __GNUC__\n#define __GNUC__\n{file_of()}#endif\n",
    file_of("double k = 3; // joined \\ \nk = 4;\nreturn k"),
    file_of("double sin(double x) { return x; } return 3"),
]


@pytest.mark.sample(2)
@pytest.mark.parametrize("text", REFUSED)
def test_what_a_compiler_may_read_otherwise_is_refused_by_line_and_column(text: str) -> None:
    with pytest.raises(InputError, match=r"^code\.c, line \d+, column \d+: [^\n]+$"):
        verdict(text)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        (file_of(above="\nstatic double sin(double x) { return x; }\n"), "line 2, column 15: sin"),
        (file_of("return N", CONDITIONS[0]), "line 1, column 8: __GNUC__ in a condition"),
        (file_of("return N", "/* a\n*/ " + CONDITIONS[2]), "line 2, column 16: __x86_64__"),
        (file_of("return M_PI", "\n#define M_PI 3\n"), "line 2, column 1: M_PI"),
        (file_of("return (-1 < 1u ? 3 : 4)"), "line 2, column 91: a negative integer"),
    ],
)
def test_the_refusal_names_the_place(text: str, place: str) -> None:
    with pytest.raises(InputError, match=re.escape(place)):
        verdict(text)


def test_lines_keep_their_numbers_behind_joined_ones() -> None:
    text = "#define A \\\n 1 \\\n + 2\n// b \\\n still\nint c; /* \\\n */ int d;\nlast"
    found = lines(tokens(text, "code.c"))
    assert len(found) == len(text.split("\n"))
    assert [i for i, line in enumerate(found, 1) if ("name", "last") in line] == [8]
    with pytest.raises(InputError, match="line 4, column"):
        verdict(f"#define A \\\n 1\n\n{file_of('return nothing', '')}")


def test_a_default_is_taken_and_told() -> None:
    text = file_of("return N", "#ifndef N\n#define N 3\n#endif\n")
    found = mechanics.check(SCENE, text, notation="c", blame=False)
    assert found.verdict.name == "PROVED"
    assert "N is taken as the file defines it; a compiler that is given another one" in str(found)


def test_one_setting_of_a_macro_is_not_proved() -> None:
    """Whichever side is right, and whatever stands there."""
    for right, wrong in (("3", "4"), ("3*1", "0")):
        for first, second in ((right, wrong), (wrong, right)):
            text = f"#ifdef NDEBUG\n#define N {first}\n#else\n#define N {second}\n#endif\n"
            with pytest.raises(InputError, match="column 8: NDEBUG in a condition: what is comp"):
                verdict(file_of("return N", text))
