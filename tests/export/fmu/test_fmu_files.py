"""What is in a unit: clean C for every compiler, exact units, the same bytes each time."""

import os
import re
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from fmpy import read_model_description
from fmpy.model_description import read_build_description

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_model
from mechanics.crosscheck.fmu import write_fmu
from mechanics.errors import InputError, MechanicsError
from mechanics.export.fmu.binary import OPTIONS, this_platform
from mechanics.export.fmu.step_size import step_size
from mechanics.export.fmu.unit import METHOD
from mechanics.export.fmu.units import base_powers
from mechanics.routes.derivation import by_route
from mechanics.simulate.run import begin
from systems import elastic_pendulum, four_bar, rocker, rolling_disc

pytestmark = pytest.mark.campaign

Models, Units = Callable[[str], Model], Callable[[str], Path]
GOLDEN = Path(__file__).parent / "golden" / "rocker.xml"
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]
SANITIZED = ["-g", "-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]

# Two units in one program, stepped in turn, copied, reset: what leaks or overlaps is found.
DRIVER = """
#include "fmi3.h"
#include <stdio.h>
#define UNIT(prefix) \\
    extern fmi3Instance prefix##_fmi3InstantiateCoSimulation(fmi3String, fmi3String, fmi3String, \\
        fmi3Boolean, fmi3Boolean, fmi3Boolean, fmi3Boolean, const fmi3ValueReference[], size_t, \\
        fmi3InstanceEnvironment, fmi3LogMessageCallback, fmi3IntermediateUpdateCallback); \\
    extern fmi3Status prefix##_fmi3EnterInitializationMode(fmi3Instance, fmi3Boolean, double, \\
        double, fmi3Boolean, double); \\
    extern fmi3Status prefix##_fmi3ExitInitializationMode(fmi3Instance); \\
    extern fmi3Status prefix##_fmi3DoStep(fmi3Instance, double, double, fmi3Boolean, \\
        fmi3Boolean *, fmi3Boolean *, fmi3Boolean *, double *); \\
    extern fmi3Status prefix##_fmi3GetFMUState(fmi3Instance, fmi3FMUState *); \\
    extern fmi3Status prefix##_fmi3SetFMUState(fmi3Instance, fmi3FMUState); \\
    extern fmi3Status prefix##_fmi3FreeFMUState(fmi3Instance, fmi3FMUState *); \\
    extern fmi3Status prefix##_fmi3GetFloat64(fmi3Instance, const fmi3ValueReference[], size_t, \\
        double[], size_t); \\
    extern fmi3Status prefix##_fmi3Reset(fmi3Instance); \\
    extern void prefix##_fmi3FreeInstance(fmi3Instance); \\
    static fmi3Instance prefix##_made(const char *token) { \\
        return prefix##_fmi3InstantiateCoSimulation("i", token, "", 0, 0, 0, 0, NULL, 0, NULL, \\
            said, NULL); } \\
    static int prefix##_run(fmi3Instance one, int again) { \\
        fmi3Boolean event, end, early; double reached, x[2]; fmi3FMUState kept = NULL; \\
        const fmi3ValueReference at[] = {1, MODEL_LAST}; int bad = 0; \\
        bad |= prefix##_fmi3EnterInitializationMode(one, 0, 0, 0, 0, 0); \\
        bad |= prefix##_fmi3ExitInitializationMode(one); \\
        bad |= prefix##_fmi3GetFMUState(one, &kept); \\
        for (int i = 0; i < 5; ++i) \\
            bad |= prefix##_fmi3DoStep(one, .02 * i, .02, 0, &event, &end, &early, &reached); \\
        bad |= prefix##_fmi3GetFloat64(one, at, 2, x, 2); \\
        printf("%.17g %.17g\\n", x[0], x[1]); \\
        if (again) bad |= prefix##_fmi3SetFMUState(one, kept); \\
        bad |= prefix##_fmi3FreeFMUState(one, &kept); \\
        bad |= prefix##_fmi3Reset(one); \\
        return bad; }
static void said(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
    fmi3String words) { (void)environment; (void)status; puts(category); puts(words); }
"""
MAIN = """
int main(void)
{
    fmi3Instance a = first_made(FIRST), b = second_made(SECOND), c = first_made(SECOND);
    if (!a || !b || c) return 2;
    int bad = first_run(a, 1) | second_run(b, 0) | first_run(a, 0) | second_run(b, 1);
    first_fmi3FreeInstance(a);
    second_fmi3FreeInstance(b);
    return bad;
}
"""


def sources_of(unit: Path, folder: Path) -> Path:
    with zipfile.ZipFile(unit) as archive:
        archive.extractall(folder)
    return folder / "sources"


def run(*command: object, folder: Path) -> str:
    done = subprocess.run(
        list(map(str, command)), cwd=folder, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.parametrize("name", ["elastic_pendulum", "rocker"])
def test_the_sources_compile_without_a_warning(
    unit_of: Units, compiler: str, tmp_path: Path, name: str
) -> None:
    folder = sources_of(unit_of(name), tmp_path)
    files = sorted(path.name for path in folder.glob("*.c"))
    said = run(compiler, *OPTIONS, *STRICT, "-O0", "-shared", *files, "-o", "unit.so", "-lm",
               folder=folder)  # fmt: skip
    assert said == "" and (folder / "unit.so").stat().st_size > 0


def test_two_units_in_one_program_under_sanitizers(
    unit_of: Units, compiler: str, tmp_path: Path
) -> None:
    objects: list[Path] = []
    tokens: dict[str, str] = {}
    for prefix, name in (("first", "rocker"), ("second", "elastic_pendulum")):
        folder = sources_of(unit_of(name), tmp_path / prefix)
        tokens[prefix.upper()] = read_model_description(str(unit_of(name))).instantiationToken
        for file in sorted(folder.glob("*.c")):
            objects.append(folder / f"{prefix}_{file.stem}.o")
            run(compiler, "-std=c99", *SANITIZED, f"-DFMI3_FUNCTION_PREFIX={prefix}_", "-c", file,
                "-o", objects[-1], folder=folder)  # fmt: skip
    text = DRIVER.replace("MODEL_LAST", "0") + "UNIT(first)\nUNIT(second)\n" + MAIN
    (tmp_path / "main.c").write_text(text, encoding="utf-8")
    defines = [f'-D{name}="{token}"' for name, token in tokens.items()]
    run(compiler, "-std=c99", *SANITIZED, *defines, "-I", tmp_path / "first" / "sources", "main.c",
        *objects, "-o", "main", "-lm", folder=tmp_path)  # fmt: skip
    lines = run(tmp_path / "main", folder=tmp_path).splitlines()
    # The second instance of the first unit was given the token of the other.
    assert lines[0] == "logStatusError" and "token is not that of this unit" in lines[1]
    assert lines[2] == lines[4] and lines[3] == lines[5] and lines[2] != lines[3]


def test_fmpy_compiles_the_sources_by_their_build_description(
    unit_of: Units, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # FMPy brings a cmake, which stands beside the interpreter.
    beside = str(Path(sys.executable).parent)
    monkeypatch.setenv("PATH", os.pathsep.join([beside, os.environ["PATH"]]))
    unit = tmp_path / "rocker.fmu"
    with zipfile.ZipFile(unit_of("rocker")) as full, zipfile.ZipFile(unit, "w") as bare:
        for name in full.namelist():
            if not name.startswith("binaries/"):
                bare.writestr(name, full.read(name))
    run(sys.executable, "-m", "fmpy", "compile", unit, "--all-warnings", "--warning-as-error",
        folder=tmp_path)  # fmt: skip
    said = run(sys.executable, "-m", "fmpy", "simulate", unit, "--stop-time", "0.1",
               "--output-file", tmp_path / "out.csv", folder=tmp_path)  # fmt: skip
    assert "error" not in said.lower()
    assert (tmp_path / "out.csv").read_text(encoding="utf-8").startswith('"time","theta"')


def test_the_build_description_names_every_source(unit_of: Units, tmp_path: Path) -> None:
    folder = sources_of(unit_of("rocker"), tmp_path)
    (build,) = read_build_description(str(tmp_path), validate=True)
    (listed,) = build.sourceFileSets
    assert listed.language == "C99"
    assert sorted(listed.sourceFiles) == sorted(path.name for path in folder.glob("*.c"))


def test_the_same_model_gives_the_same_bytes(model_of: Models, tmp_path: Path) -> None:
    texts = []
    for name in ("one.fmu", "other.fmu"):
        with zipfile.ZipFile(write_fmu(model_of("elastic_pendulum"), tmp_path / name)) as archive:
            texts.append({n: archive.read(n) for n in archive.namelist() if "binaries" not in n})
    assert texts[0] == texts[1]
    other = write_fmu(model_of("elastic_pendulum"), tmp_path / "x.fmu", initial={"theta": 1.0})
    tokens = {read_model_description(str(path)).instantiationToken
              for path in (tmp_path / "one.fmu", other)}  # fmt: skip
    assert len(tokens) == 2


def test_golden_description(unit_of: Units, update_golden: bool) -> None:
    """Set UPDATE_GOLDEN=1 to write it. Version and token change without the description."""
    with zipfile.ZipFile(unit_of("rocker")) as archive:
        found = archive.read("modelDescription.xml").decode("utf-8")
    found = re.sub(r' (instantiationToken|generationTool)="[^"]*"', "", found)
    if update_golden:
        GOLDEN.write_text(found, encoding="utf-8")
    assert found == GOLDEN.read_text(encoding="utf-8")


def test_start_values_units_and_meanings_are_the_scene_s(model_of: Models, tmp_path: Path) -> None:
    unit = write_fmu(
        model_of("elastic_pendulum"), tmp_path / "p.fmu",
        initial={"theta": 0.25}, parameters={"k": 12.5},
    )  # fmt: skip
    description = read_model_description(str(unit))
    known = {v.name: v for v in description.modelVariables}
    assert float(known["theta"].start) == 0.25 and known["theta"].unit == "rad"
    assert float(known["k"].start) == 12.5 and known["k"].unit == "N/m"
    assert known["k"].causality == "parameter" and known["k"].variability == "tunable"
    assert known["x_ddot"].derivative is known["x_dot"] and known["x_ddot"].unit == "m/s^2"
    assert known["theta_ddot"].causality == known["kinetic energy"].causality == "output"
    (newton,) = [u for u in description.unitDefinitions if u.name == "N"]
    assert (newton.baseUnit.kg, newton.baseUnit.m, newton.baseUnit.s) == (1, 1, -2)


def test_what_depends_on_what_is_told_exactly(unit_of: Units) -> None:
    """The rocker's acceleration depends on theta, theta' and f; der(theta) on theta' alone."""
    description = read_model_description(str(unit_of("rocker")))
    needs = {u.variable.name: {d.name for d in u.dependencies} for u in description.derivatives}
    assert needs == {"der(theta)": {"theta_dot"}, "theta_ddot": {"theta", "theta_dot", "f"}}
    margins = {u.variable.name: {d.name for d in u.dependencies}
               for u in description.eventIndicators}  # fmt: skip
    assert margins["margin of half disc"] == {"theta"}
    assert margins["margin of contact"] >= {"theta", "theta_dot"}


@pytest.mark.parametrize(
    ("unit", "powers"),
    [
        ("kg*m^2", {"kg": 1, "m": 2}),
        ("N/rad", {"kg": 1, "m": 1, "s": -2, "rad": -1}),
        ("N m", {"kg": 1, "m": 2, "s": -2}),
        ("N*s/m", {"kg": 1, "s": -1}),
        ("kg/m^3", {"kg": 1, "m": -3}),
        ("rad/s/s", {"rad": 1, "s": -2}),
        ("1", {}),
        ("1/s", {"s": -1}),
        ("m**2", {"m": 2}),
        ("furlong", None),
        ("m^", None),
        ("kg m)", None),
    ],
)
def test_units_are_powers_of_base_units(unit: str, powers: dict[str, int] | None) -> None:
    assert base_powers(unit) == powers


def test_every_unit_of_a_system_is_known(unit_of: Units, tmp_path: Path) -> None:
    for name in ("rocker", "two_mass_chain", "rolling_disc", "four_bar"):
        with zipfile.ZipFile(unit_of(name)) as archive:
            root = ElementTree.fromstring(archive.read("modelDescription.xml"))
        units = root.findall("UnitDefinitions/Unit")
        assert units and all(unit.find("BaseUnit") is not None for unit in units)


def test_without_a_compiler_the_unit_holds_its_sources(tmp_path: Path) -> None:
    model = compile_model(by_route("free_body", rocker.scene()), compiler=None)
    with zipfile.ZipFile(write_fmu(model, tmp_path / "rocker.fmu")) as archive:
        names = archive.namelist()
    assert "sources/model.c" in names and not [n for n in names if n.startswith("binaries/")]


def test_fixed_parameters_are_none_of_the_unit(tmp_path: Path) -> None:
    equations = by_route("lagrange", rocker.scene())
    model = compile_model(equations, compiler=None, fixed={"g": "9.81", "R": "1/10"})
    description = read_model_description(str(write_fmu(model, tmp_path / "rocker.fmu")))
    names = {v.name for v in description.modelVariables if v.causality == "parameter"}
    assert names == {"I_C", "M", "mu", "step_size"}
    assert "fixed: R = 1/10; g = 981/100" in description.description
    # Lagrange tells no reactions, and the conditions are watched all the same.
    assert [u.variable.name for u in description.eventIndicators] == [
        "margin of contact", "margin of rolling", "margin of half disc",
    ]  # fmt: skip


def test_a_model_with_few_functions_has_few_outputs(tmp_path: Path) -> None:
    asked = ("coordinate_rates", "forward_dynamics", "energy")
    model = compile_model(by_route("free_body", rocker.scene()), compiler=None, outputs=asked)
    description = read_model_description(str(write_fmu(model, tmp_path / "p.fmu")))
    names = {v.name for v in description.modelVariables if v.causality == "output"}
    assert names > {"theta", "theta_ddot", "total energy", "margin of contact"}
    assert not names & {"N", "T"}


def test_platforms_have_the_names_of_the_standard() -> None:
    assert this_platform("AMD64", "Windows").tuple == "x86_64-windows"
    assert this_platform("arm64", "Darwin").suffix == ".dylib"
    with pytest.raises(InputError, match=r"platform riscv64 Linux: FMI 3.0 units are compiled for"):
        this_platform("riscv64", "Linux")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"initial": {"phi": 1.0}}, "initial value 'phi'"),
        ({"parameters": {"M": -1.0}}, "parameter M: -1 is negative"),
        ({"inputs": {"f": lambda t: t}}, "input f: a function cannot be exported"),
        ({"initial": {"theta": 2.0}}, "the motion starts outside of the domain"),
        ({"step": 0.0}, "step: 0.0 found: a positive number"),
        ({"step": float("nan")}, "step: nan found: a positive number"),
        ({"path": "rocker.zip"}, "a file NAME.fmu in a folder that exists is needed"),
        ({"path": "nowhere/rocker.fmu"}, "a file NAME.fmu in a folder that exists is needed"),
    ],
)
def test_what_cannot_be_exported_is_named(
    model_of: Models, tmp_path: Path, options: dict, words: str
) -> None:
    path = tmp_path / options.pop("path", "rocker.fmu")
    with pytest.raises(MechanicsError, match=re.escape(words)):
        write_fmu(model_of("rocker"), path, **options)
    assert not path.exists()


def test_a_stiff_motion_is_refused_unless_a_step_is_given(tmp_path: Path) -> None:
    model = compile_model(by_route("free_body", elastic_pendulum.scene()), compiler=None)
    with pytest.raises(InputError, match="too stiff for equal explicit steps: give step="):
        write_fmu(model, tmp_path / "p.fmu", parameters={"k": 1e16}, initial={"x": 0.1})
    unit = write_fmu(model, tmp_path / "p.fmu", parameters={"k": 1e16}, step=1e-9)
    (step,) = (v for v in read_model_description(str(unit)).modelVariables if v.name == "step_size")
    assert float(step.start) == 1e-9


def test_the_step_follows_the_fastest_motion() -> None:
    """x'' = -w^2 x: steps in proportion to 1/w, rounded down to 1, 2, 5 times a power of ten."""

    def of(w: float) -> float:
        return step_size(
            lambda v: np.array([v[2], -(w**2) * v[1]]), np.array([0.0, 1.0, 0.0]), 2, METHOD, 10 / w
        ) * w  # fmt: skip

    assert 0.02 < of(1.0) <= 0.1
    assert of(10.0) == pytest.approx(of(1.0)) and of(1000.0) == pytest.approx(of(1.0))


def test_rounding_near_a_singular_form_does_not_shorten_the_step(tmp_path: Path) -> None:
    """Rows of moving_point for the disc are divided by cos(yaw): near its zeros errors are those
    of rounding, which shorter steps only repeat.
    """
    model = compile_model(by_route("moving_point", rolling_disc.scene()), compiler=None)
    unit = write_fmu(model, tmp_path / "disc.fmu")
    (step,) = (v for v in read_model_description(str(unit)).modelVariables if v.name == "step_size")
    assert float(step.start) >= 0.01


def test_a_constrained_scene_starts_where_simulate_does(model_of: Models, unit_of: Units) -> None:
    start = begin(model_of("four_bar"), {})
    known = {v.name: v.start for v in read_model_description(
        str(unit_of("four_bar"))).modelVariables}  # fmt: skip
    scene = four_bar.scene()
    names = [s.name for s in (*scene.q, *scene.u)]
    assert [float(known[name]) for name in names] == start.state.tolist()
