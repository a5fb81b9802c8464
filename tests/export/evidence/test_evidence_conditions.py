"""Text that only some compilers read, and declarations that only users see: none of it is SHOWN."""

import json
import shutil
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path

import pytest

from mechanics.equations import Equations
from mechanics.export.evidence.verify import Outcome, Verification, verify
from mechanics.export.write_c import write_c
from mechanics.routes.derivation import by_route
from systems import rocker

pytestmark = pytest.mark.campaign

NAMES = ("forward_dynamics", "energy")
Judged = Callable[[str, str, str], Verification]


@pytest.fixture(scope="module")
def physics() -> Equations:
    return by_route("free_body", rocker.scene())


@pytest.fixture(scope="module")
def honest(modelled, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("honest")
    write_c(modelled("rocker", "free_body"), folder, name="name", functions=NAMES, prove=False)
    return folder


@pytest.fixture
def judged(honest: Path, physics: Equations, tmp_path: Path) -> Judged:
    """The folder with one text put for another, its hash made right."""

    def judge(file: str, old: str, new: str) -> Verification:
        folder = tmp_path / "c"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(honest, folder)
        text = (folder / file).read_bytes().decode()
        assert old in text
        changed = text.replace(old, new, 1).encode()
        (folder / file).write_bytes(changed)
        manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
        manifest["files"][file] = sha256(changed).hexdigest()
        (folder / "manifest.json").write_text(json.dumps(manifest), encoding="utf-8")
        return verify(folder, physics, measure=False)

    return judge


def bad(found: Verification) -> str:
    return "\n".join(
        f"{finding.subject}: {finding.evidence}"
        for _, findings in found.chain.steps for finding in findings if not finding.shown
    )  # fmt: skip


END, OUTPUT = "    return status;", "    ud[0] = "
TWICE = "    ud[0] = 2.0*ud[0];\n"
IN_C = {
    "__cplusplus": f"#ifdef __cplusplus\n{TWICE}#endif\n",
    "NDEBUG": f"#ifdef NDEBUG\n{TWICE}#endif\n",
    "__STDC_VERSION__": f"#if !defined(__STDC_VERSION__)\n{TWICE}#endif\n",
    "_WIN32": f"#ifdef __GNUC__\n#ifdef _WIN32\n{TWICE}#endif\n#endif\n",
    "__x86_64__": f"#ifdef __clang__\n#else\n#if defined(__x86_64__)\n{TWICE}#endif\n#endif\n",
    "OTHER": f"#if 0\n#elif defined(OTHER)\n{TWICE}#endif\n",
    "MECHANICS_G": f"#ifndef MECHANICS_G\n#define MECHANICS_G\n#else\n{TWICE}#endif\n",
    "__GNUC__ in #if": f"#if __GNUC__ > 13\n{TWICE}#endif\n",
}


@pytest.mark.parametrize("name", IN_C)
def test_what_a_compiler_may_read_otherwise_is_refused_by_name(judged: Judged, name: str) -> None:
    found = judged("name.c", END, IN_C[name] + END)
    assert found.outcome is not Outcome.SHOWN
    assert name in bad(found)


@pytest.mark.parametrize("name", ["__GNUC__", "__clang__", "__FMA__", "FP_FAST_FMA"])
def test_what_is_read_both_ways_is_refuted_on_the_wrong_side(judged: Judged, name: str) -> None:
    found = judged("name.c", END, f"#ifdef {name}\n    ud[0] = 2.0*theta;\n#endif\n{END}")
    assert found.outcome is Outcome.REFUTED
    assert f"with {name}" in bad(found)


LINKAGE = '#ifdef __cplusplus\nextern "C" {\n#endif'
SIZE = "#define NAME_P_SIZE 4\n"
LAST = "#endif /* MECHANICS_name_H */"
IN_HEADER = {
    "another size for C++": (SIZE, "#ifdef __cplusplus\n#define NAME_P_SIZE 5\n#else\n"
                             f"{SIZE}#endif\n", "__cplusplus"),
    "a macro in the guard of linkage": (
        LINKAGE, LINKAGE.replace("\n#endif", "\n#define name_energy name_forward_dynamics\n#endif"),
        "__cplusplus"),
    "the guard of linkage with another side": (
        LINKAGE, LINKAGE.replace("#endif", "#else\n#define name_energy name_other\n#endif"),
        "__cplusplus"),
    "no guard of linkage": (LINKAGE, LINKAGE.replace("ifdef", "ifndef"), "__cplusplus"),
    "C++ linkage": (LINKAGE, LINKAGE.replace('"C"', '"C++"'), "__cplusplus"),
    "another size for a compiler": (SIZE, f"#ifdef __GNUC__\n#define NAME_P_SIZE 5\n#else\n{SIZE}"
                                    "#endif\n", "__GNUC__"),
    "a guard with another side": (LAST, f"#else\n#define name_energy name_other\n{LAST}",
                                  "MECHANICS_name_H"),
    "text behind the guard": (LAST, f"{LAST}\n#define name_energy name_other\n", "name_energy"),
    "a guard of another name": ("#ifndef MECHANICS_name_H\n#define MECHANICS_name_H\n",
                                "#ifndef NDEBUG\n#define NDEBUG\n", "NDEBUG"),
    "another size": (SIZE, "#define NAME_P_SIZE 5\n", "NAME_P_SIZE"),
    "no size": (SIZE, "", "NAME_P_SIZE"),
    "another status": ("#define NAME_SINGULAR 1", "#define NAME_SINGULAR 2", "NAME_SINGULAR"),
    "a macro that is no size": (SIZE, f"{SIZE}#define name_energy name_forward_dynamics\n",
                                "name_energy"),
    "a macro for nothing": (SIZE, f"{SIZE}#define name_energy\n", "name_energy"),
    "a word of C": (SIZE, f"{SIZE}#define const\n", "const"),
    "a word of C for another": (SIZE, f"{SIZE}#define double float\n", "double"),
    "a macro with arguments": (SIZE, f"{SIZE}#define name_energy(q, u, i, p, k, v, t) (0)\n",
                               "name_energy"),
    "another type": ("const double u[1]", "const float u[1]", "name_forward_dynamics"),
    "another order": ("const double q[1], const double u[1]",
                      "const double u[1], const double q[1]", "name_forward_dynamics"),
    "another result": ("int name_energy(", "unsigned name_energy(", "name_energy"),
    "another number of entries": ("const double p[4]", "const double p[3]",
                                  "name_forward_dynamics"),
    "a prototype of nothing": (LAST, f"int name_momenta(const double q[1]);\n{LAST}",
                               "name_momenta"),
    "no prototype": ("int name_energy(", "int name_power(", "name_energy"),
    "a struct": (LAST, f"typedef struct {{ double q[1]; }} name_state;\n{LAST}", "a struct"),
    "an enum": (LAST, f"enum {{ NAME_COUNT = 3 }};\n{LAST}", "name.h"),
    "a variable": (LAST, f"extern double name_g;\n{LAST}", "name_g"),
    "a function in the header": (
        LAST, f"static inline double name_g(void) {{ return 9.81; }}\n{LAST}", "name_g"),
    "a name of the library": (LAST, f"double sin(double);\n{LAST}", "sin"),
    "an own sine": (LAST, f"static inline double sin(double x) {{ return x; }}\n{LAST}", "sin"),
    "a header of nobody": (LAST, f'#include "other.h"\n{LAST}', "other.h"),
    "a header of the system": (LAST, f"#include <fenv.h>\n{LAST}", "fenv.h"),
    "a pragma": (LAST, f"#pragma STDC FP_CONTRACT ON\n{LAST}", "STDC"),
    "an attribute": ("int name_energy(", "__attribute__((pure)) int name_energy(", "name.h"),
}  # fmt: skip


@pytest.mark.parametrize("attack", IN_HEADER)
def test_a_header_declares_what_the_sources_define(judged: Judged, attack: str) -> None:
    old, new, named = IN_HEADER[attack]
    found = judged("name.h", old, new)
    assert found.outcome is not Outcome.SHOWN
    assert named in bad(found)


MATH = "#include <math.h>\n"
ELSEWHERE = {
    "joined comment": ("name.c", END, "    ud[0] = 2.0 /\\\n* theta; ud[0] = v1 /* */ ;\n" + END),
    "carriage return": ("name.c", END, f"    // ends here\r{TWICE}{END}"),
    "trigraph": ("name.c", END, f"    // ends here ??/\n{TWICE}{END}"),
    "operator _Pragma": ("name.c", END, f'    _Pragma("STDC FP_CONTRACT ON")\n{END}'),
    "pragma": ("name.c", OUTPUT, f'#pragma GCC optimize ("fast-math")\n{OUTPUT}'),
    "string": ("name.c", END, f'    R"(";\n{TWICE}    ")";\n{END}'),
    "undef": ("name.c", END, f"#undef NAME_OK\n{END}"),
    "line": ("name.c", END, f'#line 3 "other.c"\n{END}'),
    "macro sin": ("name.c", MATH, f"{MATH}#define sin cos\n"),
    "macro isfinite": ("name.c", MATH, f"{MATH}#define isfinite(x) 1\n"),
    "macro if": ("name.c", MATH, f"{MATH}#define if while\n"),
}  # fmt: skip


@pytest.mark.parametrize("attack", ELSEWHERE)
def test_what_compilers_read_in_other_ways_is_not_shown(judged: Judged, attack: str) -> None:
    file, old, new = ELSEWHERE[attack]
    found = judged(file, old, new)
    assert found.outcome is not Outcome.SHOWN, bad(found)
    assert "name.c" in bad(found)


def test_comments_and_blanks_are_no_change(judged: Judged) -> None:
    for old, new in (
        (LINKAGE, '#  ifdef __cplusplus /* for C++ */\n  extern "C"\n  {\n# endif'),
        ("#ifndef MECHANICS_name_H", "/* once */\n#ifndef MECHANICS_name_H // guard"),
    ):
        found = judged("name.h", old, new)
        assert found.outcome is Outcome.SHOWN, bad(found)
