"""Put a unit together: ``NAME.fmu``, a zip archive with the layout of FMI 3.0.

    modelDescription.xml          variables, units, what depends on what
    sources/                      C of the interface and of the model, buildDescription.xml
    binaries/x86_64-linux/        the library for the machine that writes it

The same model and the same start values give the same bytes. The archive appears when its text,
read back, and the graphs of the model are not refuted: whole, or not at all.
"""

import os
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from importlib.resources import files
from pathlib import Path

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled import Model
from mechanics.compiled.c.names import identifier
from mechanics.compiled.machine.evaluator import evaluator
from mechanics.compiled.machine.native import affordable
from mechanics.compiled.tableaus import TABLEAUX
from mechanics.errors import InputError
from mechanics.export.atomic import named, replaced_file
from mechanics.export.fmu.binary import OPTIONS, Platform, compiled_library, this_platform
from mechanics.export.fmu.description import build_description, model_description
from mechanics.export.fmu.functions import Functions, functions
from mechanics.export.fmu.model_text import model_header, model_source
from mechanics.export.fmu.proof import prove_unit
from mechanics.export.fmu.step_size import ALLOWED, Rates, step_size
from mechanics.export.fmu.tables_text import tables_header, tables_source
from mechanics.export.fmu.variables import Variables, variables
from mechanics.export.manifest import version_of
from mechanics.export.refusal import refuse_refuted
from mechanics.kernel import Finding
from mechanics.program.casadi_reader import read_routine

SUFFIX = ".fmu"
# The method of highest order: few long steps, and errors near rounding.
METHOD = TABLEAUX[-1]
# What importers suggest to simulate, in s: what `mechanics simulate` does.
DURATION = 10.0
# Archives hold no earlier date; with a fixed one the bytes depend on the contents only.
DATE = (1980, 1, 1, 0, 0, 0)


@dataclass(frozen=True)
class Start:
    """Where a unit starts, by name.

    Attributes
    ----------
    values : mapping of str to float
        Of every coordinate, speed, parameter and input that is not zero.
    step : float or None
        Longest internal step of co-simulation, in s; measured where it is None.
    beyond_domain : bool
        Whether to go on where a condition of the scene does not hold.
    """

    values: Mapping[str, float] = field(default_factory=dict)
    step: float | None = None
    beyond_domain: bool = False


def write_unit(
    model: Model, path: str | Path, start: Start, compiler: str | None, prove: bool = True
) -> tuple[Finding, ...]:
    """Write a unit, and tell what was shown about it.

    Parameters
    ----------
    model : Model
    path : str or Path
        ``NAME.fmu``; replaced.
    start : Start
    compiler : str or None
        Of the library for this machine; None writes the sources only.
    prove : bool
        Whether the graphs are compared with what was derived, and the C text with the graphs.

    Raises
    ------
    InputError
        If the path does not end in .fmu, its folder does not exist, the step is no positive number,
        or this platform is none of the standard's, or the file cannot be written.
    CompilerError
        If the compiler refuses the code.
    RefutedError
        If something is REFUTED: nothing is written then.
    """
    target = named(path)
    if target.suffix != SUFFIX or not target.parent.is_dir() or target.is_dir():
        raise InputError(f"{target}: a file NAME{SUFFIX} in a folder that exists is needed")
    if not os.access(target.parent, os.W_OK):
        raise InputError(
            f"{target} cannot be written: {target.parent} is read-only: name another folder"
        )
    where = this_platform() if compiler else None
    known = functions(model)
    names = [e.name for e in (*model.quantities.q, *model.quantities.u, *known.inputs, *known.p)]
    values = {name: float(start.values.get(name, 0.0)) for name in names}
    found = variables(model, known, values, 1.0)
    step = _measured(model, known, found) if start.step is None else start.step
    if not 0 < step < float("inf"):
        raise InputError(f"step: {start.step!r} found: a positive number of seconds is needed")
    contents = _contents(model, known, variables(model, known, values, step), start.beyond_domain)
    binary = _binary(model, known, contents, where, compiler)
    findings: tuple[Finding, ...] = ()
    try:
        with replaced_file(target) as fresh:
            _archive(fresh, contents | binary)
            if prove:
                findings = prove_unit(model, fresh)
                refuse_refuted(findings, str(target))
    except OSError as error:
        raise InputError(
            f"{target} cannot be written: {error.strerror}: name a file that can be"
        ) from error
    return findings


def _measured(model: Model, known: Functions, found: Variables) -> float:
    start = np.array([variable.start or 0.0 for variable in found.given])
    return step_size(_rates(model, known), start, len(found.states), METHOD, DURATION)


def _rates(model: Model, known: Functions) -> Rates:
    """The rates of a unit as a function in this process."""
    function: ca.Function = known.graphs["rates"]
    given, wanted = np.zeros(function.numel_in(0)), np.zeros(function.numel_out(0))
    entries = {"given": tuple(f"v{i}" for i in range(len(given)))}
    kernel = evaluator(
        function, read_routine(function), entries, np.float64, model.compiler, model.flags
    )
    run = kernel.bound([given], [wanted])

    def rates(values: NDArray[np.float64]) -> NDArray[np.float64]:
        given[:] = values
        run()
        return wanted

    return rates


def _contents(model: Model, known: Functions, found: Variables, beyond: bool) -> dict[str, bytes]:
    """Every file but the library, by its name in the archive."""
    scene = model.equations.scene
    conditions = scene.conditions if found.margins else ()
    name, title = identifier(scene.name), f"{scene.name}, derived by {model.equations.route}"
    fixed = "; ".join(f"{parameter} = {value}" for parameter, value in sorted(model.fixed.items()))
    own = _texts()
    own["model.h"] = model_header(title, name, found, known)
    own["model.c"] = model_source(title, name, found, known)
    own["tables.c"] = tables_source(found, conditions, METHOD)
    token = _token(fixed, str(beyond), *own.values())
    own["tables.h"] = tables_header(title, name, token, beyond, bool(conditions), METHOD)
    words = {
        "modelName": scene.name,
        "instantiationToken": token,
        "description": f"{title}; fixed: {fixed}" if fixed else title,
        "generationTool": f"mechanics {version_of('mechanics')}",
    }
    experiment = {"startTime": 0.0, "stopTime": DURATION, "tolerance": ALLOWED}
    texts = {
        "modelDescription.xml": model_description(name, words, found, known, experiment),
        **{f"sources/{file}": text for file, text in own.items()},
        "sources/buildDescription.xml": build_description(
            name, sorted(file for file in own if file.endswith(".c")), " ".join(["-O2", *OPTIONS])
        ),
    }
    return {file: text.encode("utf-8") for file, text in texts.items()}


def _texts() -> dict[str, str]:
    """The C that is the same for every unit, by file name."""
    folder = files("mechanics.export.fmu") / "c"
    found = {f.name: f.read_text(encoding="utf-8") for f in folder.iterdir()}
    return {name: found[name] for name in sorted(found) if name.endswith((".c", ".h"))}


def _token(*texts: str) -> str:
    """A name for this export: library and description of different ones are kept apart by it."""
    return "{" + sha256("\0".join(texts).encode("utf-8")).hexdigest()[:32] + "}"


def _binary(
    model: Model, known: Functions, contents: Mapping[str, bytes], where: Platform | None,
    compiler: str | None,
) -> dict[str, bytes]:  # fmt: skip
    if where is None or compiler is None:
        return {}
    folder = "sources/"
    sources = {
        file.removeprefix(folder): text.decode("utf-8")
        for file, text in contents.items()
        if file.startswith(folder) and file.endswith((".c", ".h"))
    }
    longest = max(read_routine(function).operations for function in known.graphs.values())
    library = compiled_library(sources, compiler, affordable(model.flags, longest))
    name = identifier(model.equations.scene.name)
    return {f"binaries/{where.tuple}/{name}{where.suffix}": library}


def _archive(target: Path, contents: Mapping[str, bytes]) -> None:
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in contents.items():
            archive.writestr(zipfile.ZipInfo(name, DATE), content, zipfile.ZIP_DEFLATED)
