"""What compiled functions need and hold: sine and cosine, and nothing; threads may share them."""

import functools
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from mechanics.export import write_c as write_and_prove

pytestmark = pytest.mark.campaign

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

STRICT = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wconversion"]
STRICT += ["-Wdouble-promotion", "-ffp-contract=off"]
SYSTEMS = ("elastic_pendulum", "rocker", "four_bar")
PRECISIONS = {"": "", "_single": "f"}
"""End of a file's name, and of the functions of the C library."""

THREADS = """\
#include "pendulum.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum {{ COUNT = 8, STEPS = 2000 }};
typedef struct {{ double q[PENDULUM_Q_SIZE], u[PENDULUM_U_SIZE]; int status; }} State;
static const double p[PENDULUM_P_SIZE] = {{1, 1, 9.81, 10, 1}}, h[PENDULUM_H_SIZE] = {{0x1p-10}};

static void *motion(void *argument)
{{
    State *state = argument;
    for (int i = 0; i < STEPS; ++i)
        state->status |= pendulum_step(state->q, state->u, p, h, state->q, state->u);
    return NULL;
}}

int main(void)
{{
    State states[COUNT], alone[COUNT];
    for (int i = 0; i < COUNT; ++i) {{
        memset(&states[i], 0, sizeof states[i]);
        states[i].q[1] = 0.3 * i;
        states[i].u[0] = 0.1 * i;
        alone[i] = states[i];
        motion(&alone[i]);
    }}
    pthread_t threads[COUNT];
    for (int i = 0; i < COUNT; ++i)
        if (pthread_create(&threads[i], NULL, motion, &states[i]))
            return 2;
    for (int i = 0; i < COUNT; ++i)
        pthread_join(threads[i], NULL);
    printf("%d", memcmp(states, alone, sizeof states));
    return alone[1].status;
}}
"""


def undefined_and_held(nm: str, objects: Path) -> tuple[set[str], set[str]]:
    """Names that an object asks for, and those of data that can be written."""
    done = subprocess.run([nm, str(objects)], capture_output=True, text=True, check=True)
    rows = [line.split()[-2:] for line in done.stdout.splitlines()]
    return {name for kind, name in rows if kind == "U"}, {n for k, n in rows if k in "BbDdCGgSs"}


@pytest.fixture(scope="module")
def folders(modelled, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """A folder of each system, in both precisions."""

    @functools.cache
    def folder(system: str) -> Path:
        place, functions = tmp_path_factory.mktemp(system), ["forward_dynamics", "energy", "step"]
        model = modelled(system, "kane")
        write_c(model, place, name="name", functions=functions, precision="both", batch=False)
        return place

    return folder


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("level", ["-O0", "-O2"])
def test_only_sine_and_cosine_are_called_and_nothing_is_held(
    folders, compiler: str, needed: Callable[[str], str], tmp_path: Path, system: str, level: str
) -> None:
    for end, f in PRECISIONS.items():
        source, objects = folders(system) / f"name{end}.c", tmp_path / "name.o"
        command = [compiler, *STRICT, level, "-c", str(source), "-o", str(objects)]
        subprocess.run(command, check=True)
        undefined, held = undefined_and_held(needed("nm"), objects)
        # gcc makes one call of a sine and a cosine of one angle.
        assert undefined <= {f"sin{f}", f"cos{f}", f"sincos{f}"}
        assert held == set()
        inline = f"-DNAME{end.upper()}_INLINE_SINE"
        subprocess.run([*command, inline], check=True)
        assert undefined_and_held(needed("nm"), objects) == (set(), set())


@pytest.mark.sample(1)
@pytest.mark.parametrize("level", ["-O0", "-O2 -march=native"])
@pytest.mark.parametrize("system", SYSTEMS)
def test_inline_sines_pass_the_self_test(
    folders, compiler: str, tmp_path: Path, system: str, level: str
) -> None:
    program = str(tmp_path / "test")
    for end in PRECISIONS:
        sources = [str(folders(system) / f"name{end}{what}.c") for what in ("", "_selftest")]
        options = [*STRICT, *level.split(), f"-DNAME{end.upper()}_INLINE_SINE"]
        subprocess.run([compiler, *options, *sources, "-o", program, "-lm"], check=True)
        done = subprocess.run([program], capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout) == (0, f"name{end}: 0 failures\n")


LARGE = """\
#include "name{end}.h"

int main(void)
{{
    {kind} q[2] = {{0, {angle}}}, u[2] = {{0, 0}}, p[5] = {{1, 1, 1, 1, 1}}, ud[2];
    const int status = name{end}_forward_dynamics(q, u, p, ud);
    return ud[0] == ud[0] ? status : 10 + status;
}}
"""


@pytest.mark.parametrize(("end", "kind"), [("", "double"), ("_single", "float")])
@pytest.mark.parametrize(("angle", "code"), [("1048576", 0), ("-1048577", 12)])
def test_an_angle_too_large_for_an_inline_sine_is_told(
    folders, compiler: str, tmp_path: Path, end: str, kind: str, angle: str, code: int
) -> None:
    folder, program = folders("elastic_pendulum"), str(tmp_path / "large")
    (tmp_path / "large.c").write_text(LARGE.format(end=end, kind=kind, angle=angle))
    options = [f"-I{folder}", f"-DNAME{end.upper()}_INLINE_SINE", "-ffp-contract=off", "-O2"]
    sources = [str(tmp_path / "large.c"), str(folder / f"name{end}.c")]
    subprocess.run([compiler, *options, *sources, "-o", program], check=True)
    assert subprocess.run([program], check=False).returncode == code


def test_nm_would_show_state_and_calls(compiler: str, needed, tmp_path: Path) -> None:
    (tmp_path / "a.c").write_text(
        "#include <stdlib.h>\nstatic int last; int seen = 3;\n"
        "void *f(void) { return malloc((size_t)(last++ + seen)); }\n",
        encoding="ascii",
    )
    command = [compiler, "-c", str(tmp_path / "a.c"), "-o", str(tmp_path / "a.o")]
    subprocess.run(command, check=True)
    assert undefined_and_held(needed("nm"), tmp_path / "a.o") == ({"malloc"}, {"last", "seen"})


@pytest.mark.parametrize(
    "flags", [["-O2"], ["-O1", "-g", "-fsanitize=thread"]], ids=lambda f: f[-1]
)
def test_threads_share_the_functions(
    modelled, compiler: str, tmp_path: Path, flags: list[str]
) -> None:
    write_c(modelled("elastic_pendulum", "kane"), tmp_path, name="pendulum", functions=["step"])
    (tmp_path / "threads.c").write_text(THREADS.format(), encoding="ascii")
    sources = [str(tmp_path / "threads.c"), str(tmp_path / "pendulum.c")]
    program = str(tmp_path / "threads")
    command = [compiler, *STRICT, *flags, *sources, "-o", program, "-pthread", "-lm"]
    subprocess.run(command, check=True)
    done = subprocess.run([program], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "0", "")
