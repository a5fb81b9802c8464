"""A model as a folder of C99: ``write_c(model, folder)``.

    NAME.h             sizes, order and units of every array, one prototype a function
    NAME.c             the functions: plain arguments, no allocation, no global state
    NAME_selftest.c    a program that checks them against enclosed values, exit code 0 or 1
    NAME_batch...      header, functions and self-test for many states at once, vectorised
    NAME_sine.h        sine and cosine for these, and in place of libm's where that is chosen
    NAME_single...     the same in single precision, where it is asked for
    CMakeLists.txt     a library, the self-tests for ctest, a package for find_package
    vectorised.cmake   says after a build which functions of many states are vectorised
    NAME.pc.in         for pkg-config
    NAME_loader.py     calls it from Python
    equations.json     what was derived, as data
    reduction.json     of a reduced model: domain, what was left out, bound of the change
    graphs.json        the graphs that the C was printed from, as data
    manifest.json      what was generated from what: hash of each file, operation counts, versions,
                       and what was shown about it: `mechanics verify` repeats that from the files

The same printer makes the code that `mechanics.compiled` runs.
"""

from collections.abc import Sequence
from pathlib import Path

from mechanics.compiled import Model
from mechanics.compiled.c.lanes import SHARED
from mechanics.compiled.programs.of_model import WHOLE
from mechanics.compiled.reduced import FILE as REDUCTION
from mechanics.errors import wanted
from mechanics.export.atomic import named
from mechanics.export.batch import batched
from mechanics.export.batch_selftest import batch_selftest
from mechanics.export.contents import contents_of
from mechanics.export.evidence.record import chain_record, evidence_files, evidence_of
from mechanics.export.evidence.verify import chain
from mechanics.export.folder import MANIFEST, check_folder, write_folder
from mechanics.export.implementation import code_files
from mechanics.export.loader import loader
from mechanics.export.manifest import manifest
from mechanics.export.package import build_files
from mechanics.export.precision import Part, named_parts
from mechanics.export.prefix import chosen_prefix
from mechanics.export.refusal import refuse_refuted
from mechanics.export.selftest import selftest
from mechanics.export.vectors import vectors


def write_c(
    model: Model,
    folder: str | Path,
    *,
    name: str | None = None,
    functions: Sequence[str] | None = None,
    precision: str = "double",
    batch: bool = True,
    system: str | None = None,
    prove: bool = True,
    measure: bool = True,
) -> tuple[Path, ...]:
    """Write a model as C.

    Parameters
    ----------
    model : Model
    folder : str or Path
        Made if it does not exist; what an earlier call wrote into it is replaced. It is written
        when everything is proved: as a whole, or not at all.
    name : str, optional
        Prefix of files and functions; by default the name of the scene.
    functions : sequence of str, optional
        Names of functions of the model; by default all, and the two parts of forward dynamics,
        ``prepare`` and ``forward_dynamics_prepared``.
    precision : str
        ``"double"``, ``"single"`` (files and functions then begin with NAME_single) or ``"both"``.
    batch : bool
        Whether functions of many states are written, too: those of `mechanics.export.batch.BATCHED`
        that are among the functions.
    system : str, optional
        Name of the built-in system that the model was made of, for the manifest.
    prove : bool
        Whether the chain of translation validation, from the derived equations to the C text, is
        gone through before the files are written, and what is shown noted in the manifest.
    measure : bool
        Whether the C is compiled, too, by every compiler that is found, and its results are
        compared with enclosures.

    Returns
    -------
    tuple of Path
        The files written.

    Raises
    ------
    InputError
        If the folder has no name, is a file, cannot be written, or holds files of these names that
        were not generated; if the name is taken, or there is no such function or precision.
    RefutedError
        If something is REFUTED: nothing is written then.
    SingularError
        If a function has no finite value at any of the states of the self-test.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> model = compile(rod_pendulum.scene(), outputs=["energy"], compiler=None)
    >>> files = write_c(model, "pendulum_c", batch=False, measure=False)
    >>> [path.name for path in files if path.suffix == ".c"]
    ['rod_pendulum.c', 'rod_pendulum_selftest.c']
    """
    wanted(model, Model, "write_c", "pass compile(derive(scene, route))")
    prefix = chosen_prefix(model, name)
    parts = named_parts(prefix, precision)
    names = model.programs.written(functions)
    many = batched(names) if batch else ()
    contents = contents_of(model, names)
    files: dict[str, str] = {}
    for part in parts:
        files |= code_files(contents, part, many) | _selftests(model, part, names, many)
    files |= build_files(model.equations.scene.name, prefix, parts, bool(many))
    files[f"{prefix}_loader.py"] = loader(contents, prefix, parts, many)
    code = {file: text for file, text in files.items() if file.endswith((".c", ".h"))}
    evidence = evidence_of(model, parts, names, many, code)
    files |= evidence_files(evidence)
    reduced = model.casadi.reduced
    files |= {} if reduced is None else {REDUCTION: reduced.record}
    target = named(folder)
    # Told before the proofs, which take their time.
    check_folder(target, prefix, (*files, MANIFEST))
    shown = {}
    if prove:
        found = chain(evidence, measure=measure, sines=False)
        refuse_refuted([f for _, findings in found.steps for f in findings], str(target))
        shown = chain_record(found)
    files[MANIFEST] = manifest(
        contents, prefix, files, evidence.kernels, shown, system,
        model.form if WHOLE in names and reduced is None else None, model.programs.reciprocals,
    )  # fmt: skip
    return write_folder(target, prefix, files)


def _selftests(
    model: Model, part: Part, names: Sequence[str], many: Sequence[str]
) -> dict[str, str]:
    """Self-tests of one precision, by name of file."""
    scene = model.equations.scene.name
    files = {
        f"{part.prefix}_selftest.c": selftest(
            scene, part, names, model.program, lambda name: vectors(model, name, part.digits)
        ),
    }
    if many:
        files[f"{part.prefix}_batch_selftest.c"] = batch_selftest(
            scene, part, many, model.program,
            lambda name: vectors(model, name, part.digits, SHARED),
        )  # fmt: skip
    return files
