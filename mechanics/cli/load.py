"""Systems by name or file: ``rocker``, ``pendulum_chain(10)``, ``my_system.py``.

A name runs nothing but what comes with the program; a file is run, so only a person may name it.
"""

import importlib.util
import inspect
import re
import sys
import traceback
from collections.abc import Callable
from contextlib import redirect_stdout
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Annotated, Any

import typer

from mechanics.claims.read import file_text
from mechanics.errors import InputError, MechanicsError
from mechanics.importers import as_scene
from mechanics.importers.assemble import SYMBOLIC, assemble
from mechanics.importers.decimals import Notes
from mechanics.importers.mjcf import read_mjcf
from mechanics.importers.sympy_model import is_model
from mechanics.importers.urdf import read_urdf
from mechanics.nearest import instead
from mechanics.scene import Scene
from mechanics.scene.declaration import DROP
from mechanics.scene.json.read import from_json
from mechanics.scene.published import Published
from mechanics.scene.system import System

SystemArgument = Annotated[
    str, typer.Argument(metavar="SYSTEM", help="A name, or a file: .py, .json, URDF or MJCF.")
]
CALL = re.compile(r"(\w+)(?:\((\d+)\)|:(\d+))")
FILE = re.compile(r"(.*\.py)(?::(\w+))?", re.DOTALL)
ROBOT = re.compile(r"(.*\.(?:urdf|xml))(?::([\w,]+))?", re.DOTALL | re.IGNORECASE)
NUMBERS = "numbers"


JSON = re.compile(r".*\.json", re.DOTALL | re.IGNORECASE)


def load(text: str, multiples: bool = True) -> System:
    """The system that a person named.

    Parameters
    ----------
    text : str
        A name, a name with a size (``pendulum_chain(10)`` or ``pendulum_chain:10``), or the path
        of a Python file with a function ``scene()``, which returns a scene or a model of SymPy's,
        and, perhaps, a tuple ``PUBLISHED``;
        ``file.py:name`` for a function of another name. Or a scene in JSON, ``a.json``, of which
        nothing is run. Or a robot: ``arm.urdf``, or with what
        holds its first link ``dog.urdf:free``; ``arm.xml`` in MJCF, or with what is left out
        ``arm.xml:contact,friction``; ``:numbers`` with both makes no number a parameter. What its
        reader notes is printed.
    multiples : bool
        Whether the reader of a URDF takes angles with few digits for multiples of pi.

    Raises
    ------
    InputError
        When there is no such system, or the file is none.
    """
    if file := FILE.fullmatch(text):
        return _from_file(Path(file[1]), file[2] or "scene")
    if JSON.fullmatch(text):
        return _from_json(Path(text))
    if robot := ROBOT.fullmatch(text):
        return _from_model(Path(robot[1]), robot[2] or "", multiples)
    return built_in(text)


def _from_json(path: Path) -> System:
    """A scene, or a system with the equations published for it."""
    made = from_json(file_text(path))
    return (
        replace(made, name=path.stem, scene=partial(_taken, made.scene, path.stem))
        if isinstance(made, System)
        else System(path.stem, partial(_taken, partial(from_json, file_text(path)), path.stem))
    )


def is_file(text: str) -> bool:
    """Whether a system is named by its file."""
    return any(form.fullmatch(text) is not None for form in (FILE, JSON, ROBOT))


def built_in(text: str) -> System:
    """The system of a name; nothing but what comes with the program is run.

    Raises
    ------
    InputError
        When there is no such system.
    """
    # Ledgers take a second to build, and a file needs none of them.
    from systems import EVERY

    known = {system.name: system for system in EVERY}
    if text in known:
        return known[text]
    sized = CALL.fullmatch(text)
    if sized and sized[1] in known:
        system = known[sized[1]]
        if inspect.signature(system.scene).parameters:
            # Published rows belong to the size that their source has.
            make: Callable[..., Scene] = system.scene
            return System(text, partial(make, int(sized[2] or sized[3])))
        raise InputError(f"system {text!r}: {sized[1]} has no size: write {sized[1]}")
    nearest = instead(text, known, "systems")
    raise InputError(
        f"system {text!r} is not known: {nearest}{'' if nearest.endswith('?') else '.'} Or give the"
        " path of a .py file with a function scene()"
    )


def _from_file(path: Path, name: str) -> System:
    module = run_file(path)
    scene = getattr(module, name, None)
    if not callable(scene):
        raise InputError(
            f"file {path}: it has no function {name}() that returns a Scene"
            + _functions(module, path, name)
        )
    rows = getattr(module, "PUBLISHED", ())
    if not isinstance(rows, tuple | list) or not all(isinstance(row, Published) for row in rows):
        raise InputError(f"file {path}: PUBLISHED has to be a tuple of published(...) rows")
    made = partial(_made, scene, name, path)
    return System(path.stem, partial(_taken, made, path.stem), tuple(rows), model=made)


def _functions(module: ModuleType, path: Path, name: str) -> str:
    """What to write instead, by the functions of a file that need no argument."""
    names = [
        own
        for own, value in vars(module).items()
        if inspect.isfunction(value)
        and value.__module__ == module.__name__
        and not any(p.default is p.empty for p in inspect.signature(value).parameters.values())
    ]
    if names:
        return f": name the function that does, {' or '.join(f'{path}:{own}' for own in names)}"
    return (
        f": write def {name}(): above the lines that make it, indent them, and end with"
        " return Scene(...)"
    )


def _from_model(path: Path, option: str, multiples: bool) -> System:
    """A robot; options of a URDF are its root, of an MJCF what is left out."""
    words = [word for word in option.split(",") if word]
    symbolic = () if NUMBERS in words else SYMBOLIC
    others = [word for word in words if word != NUMBERS]
    if path.suffix.lower() == ".urdf":
        notes = Notes()
        robot = read_urdf(path, notes, multiples)
        root = ",".join(others) or "fixed"
        told, make = notes.lines(), partial(assemble, robot, root, symbolic)
    else:
        robot, field, told = read_mjcf(path, others)
        make = partial(assemble, robot, "fixed", symbolic, field, redundant=DROP)
    for line in told:
        typer.echo(f"{path}: {line}", err=True)
    return System(path.stem, partial(_taken, partial(make, notes=told), path.stem))


def run_file(path: Path) -> ModuleType:
    """Run a person's file; whatever it raises becomes one line that names the place.

    Raises
    ------
    InputError
        When there is no such file, it is no Python, or it fails.
    """
    if not path.is_file():
        raise InputError(f"file {path}: there is no such file")
    try:
        # Compiled anew: bytecode on disk is told apart by its second and size alone.
        code = compile(path.read_text(encoding="utf-8"), str(path), "exec")
    except (SyntaxError, UnicodeDecodeError, ValueError) as error:
        raise InputError(f"file {path}: it is no Python file: {error}") from None
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None:
        raise InputError(f"file {path}: Python cannot load it")
    module = importlib.util.module_from_spec(spec)
    try:
        with redirect_stdout(sys.stderr):  # the answer alone is on stdout
            exec(code, module.__dict__)
    except MechanicsError:
        raise
    except (Exception, SystemExit) as error:
        raise InputError(_located(path, error)) from None
    return module


def _made(scene: object, name: str, path: Path) -> Any:
    """A scene, or a model that is taken as one."""
    try:
        with redirect_stdout(sys.stderr):
            made = scene()  # type: ignore[operator]
    except MechanicsError:
        raise
    except (Exception, SystemExit) as error:
        raise InputError(_located(path, error)) from None
    if not isinstance(made, Scene) and not is_model(made):
        kind = type(made).__name__
        article = "an" if kind[0].lower() in "aeiou" else "a"
        raise InputError(
            f"file {path}: {name}() returned {article} {kind}; it has to return a Scene, or"
            " a System, KanesMethod or LagrangesMethod of SymPy's"
        )
    return made


def _taken(made: Callable[[], Any], name: str) -> Scene:
    scene: Scene = as_scene(made(), name)
    return scene


def _located(path: Path, error: BaseException) -> str:
    """``file x.py, line 7: NameError: name 'm' is not defined``."""
    lines = [
        entry.lineno
        for entry in traceback.extract_tb(error.__traceback__)
        if Path(entry.filename) == path or Path(entry.filename).name == path.name
    ]
    place = f", line {lines[-1]}" if lines else ""
    words = " ".join(str(error).split())
    return f"file {path}{place}: {type(error).__name__}: {words}"
