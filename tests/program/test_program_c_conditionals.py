"""Names that decide what a compiler reads, in branches that are taken and in others."""

import pytest

from mechanics.errors import ExpressionError
from mechanics.program.c.conditionals import asked_names

LINKAGE = '#ifdef __cplusplus\nextern "C" {\n#endif\nint f(void);\n#ifdef __cplusplus\n}\n#endif\n'

ASKED = [
    ("int x;\n", ""),
    (LINKAGE, ""),
    ("#ifndef A_H\n#define A_H\n" + LINKAGE + "#endif /* A_H */\n", ""),
    ("/* a\n*/\n# ifndef A\n#   define A // once\nint x;\n# endif\n\n", ""),
    ('#if defined(A) || (defined B && !__C__)\n#error "no"\n#endif\n', ""),
    ("#if 0\nint x;\n#elif 1\n#else\n#endif\n", ""),
    # Not in these words.
    (LINKAGE.replace("ifdef", "ifndef", 1), "__cplusplus:1"),
    (LINKAGE.replace("{", "{ int g;", 1), "__cplusplus:1"),
    (LINKAGE.replace("}\n", "}\n#else\nint g;\n"), "__cplusplus:5"),
    ("#if __cplusplus\nextern \"C\" {\n#endif\n", "__cplusplus:1"),
    ("#ifdef __cplusplus\nextern \"C++\" {\n#endif\n", "__cplusplus:1"),
    ("#ifndef A\n#define A 1\nint x;\n#endif\n", "A:1"),
    ("#ifndef A\n#define B\nint x;\n#endif\n", "A:1"),
    ("#ifndef A\n#define A\n#else\nint x;\n#endif\n", "A:1"),
    ("int y;\n#ifndef A\n#define A\nint x;\n#endif\n", "A:2"),
    ("#ifndef A\n#define A\nint x;\n#endif\nint y;\n", "A:1"),
    ("#ifdef A\n#error no\nint x;\n#endif\n", "A:1"),
    ("#ifdef A\n#error no\n#else\nint x;\n#endif\n", "A:1"),
    # In branches that are not taken, over lines that are joined, in brackets.
    ("#if 0\n#ifdef A\nint x;\n#elif defined(B) && \\\n C > 2\nint y;\n#endif\n#endif\n",
     "A:2 B:4 C:4"),
    ("#ifdef A\n#if defined B\nint x;\n#endif\n#endif\n", "A:1 B:2"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "names"), ASKED)
def test_names_of_conditions(text: str, names: str) -> None:
    found = asked_names(text, "a.c")
    assert " ".join(f"{one.name}:{one.line}" for one in found) == names


def test_a_guard_may_have_to_begin_with_a_name() -> None:
    text = "#ifndef NDEBUG\n#define NDEBUG\nint x;\n#endif\n"
    assert [one.name for one in asked_names(text, "a.h", "MECHANICS_")] == ["NDEBUG"]
    assert not asked_names(text.replace("NDEBUG", "MECHANICS_A"), "a.h", "MECHANICS_")


@pytest.mark.parametrize("text", ["#if 1\n", "#endif\n", "#else\n", "#ifdef A\n#elif B\n"])
def test_conditions_have_ends(text: str) -> None:
    with pytest.raises(ExpressionError, match="#"):
        asked_names(text, "a.c")
