"""What agents and tutors call: each tool takes a scene as JSON, and gives JSON.

No code of the caller's is run: scenes are trees of operations, statements are LaTeX, text or C that
is only read, generated folders are verified without compiling them. Nothing names a file here.
"""

import json
import re
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from hashlib import sha256
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory
from typing import Any, Literal

from mechanics.blame.reference import Reference
from mechanics.cli.derive import Format, written
from mechanics.cli.load import built_in
from mechanics.compare import compare as compare_with
from mechanics.compare.record import to_record
from mechanics.compiled import compile
from mechanics.crosscheck import CrossCheck
from mechanics.crosscheck import crosscheck as cross
from mechanics.crosscheck import derive as derive_by
from mechanics.errors import InputError
from mechanics.export import write_c
from mechanics.export.evidence.read import read_folder
from mechanics.export.evidence.record import chain_record
from mechanics.export.evidence.verify import verify as verify_folder
from mechanics.judge.check import check as judge
from mechanics.judge.check import derived
from mechanics.judge.check_json import to_json as check_json
from mechanics.judge.scene_laws import verify as verify_laws
from mechanics.report.json_report import to_json
from mechanics.scene import Scene
from mechanics.scene.json.read import from_json
from mechanics.scene.system import System

SceneText = dict[str, Any] | str
"""A scene as ``docs/scene.schema.json`` says, the id of one that was sent, or a system's name."""

KEPT = 16
"""Scenes that are kept with what was derived of them."""
LARGEST_STATEMENT = 20_000
"""Characters."""
MOST_STATEMENTS = 100
MOST_FILES = 200
LARGEST_FOLDER = 1 << 23
"""Characters."""
MOST_STATES = 1000
ID = re.compile(r"scene-[0-9a-f]{16}")
FILE = re.compile(r"[\w+-][\w.+-]{0,99}", re.ASCII)
PYTHON = re.compile(r"^\s*(def|import|from|class|lambda|@)\b|__\w+__", re.MULTILINE)


class Tools:
    """The tools, and the scenes that they know.

    A scene is known by a hash of its text; the one that was not used for longest is forgotten.
    """

    def __init__(self) -> None:
        self._known: OrderedDict[str, tuple[System | Scene, Reference]] = OrderedDict()

    def example(self, system: str = "elastic_pendulum") -> dict[str, Any]:
        """The JSON of a scene that comes with the program, to begin from."""
        return to_json(built_in(system).scene())

    def derive(
        self,
        scene: SceneText,
        route: Literal["free_body", "moving_point", "kane", "lagrange"] = "free_body",
        form: Literal["text", "latex", "python"] = "text",
    ) -> dict[str, Any]:
        """Equations of motion M u' = f + B lambda, A u' = b; the scene is known by its id then."""
        key, reference = self._reference(scene)
        truth = reference.truth
        equations = truth if route == truth.route else derive_by(truth.scene, route)
        return {"scene": key, "equations": written(equations, Format(form), {})}

    def check(
        self,
        scene: SceneText,
        statements: list[str],
        notation: Literal["latex", "text", "c"] | None = None,
        names: dict[str, str] | None = None,
        about: str | None = None,
        convention: list[str] | None = None,
        values: dict[str, str] | None = None,
        where: list[str] | None = None,
        function: str | None = None,
        only: list[str] | None = None,
        blame: bool = False,
    ) -> dict[str, Any]:
        """Verdicts on equations, energies, reactions or a mass matrix, in LaTeX, text or C.

        With blame the smallest change that makes a refuted statement right is looked for.
        """
        _few("statements", statements, MOST_STATEMENTS)
        for statement in statements:
            _short("a statement", statement, LARGEST_STATEMENT)
            if notation != "c" and PYTHON.search(statement):
                raise InputError(
                    "check: this looks like Python, which is not read here, because reading it"
                    " would run it: send LaTeX, text or C"
                )
        key, reference = self._reference(scene)
        found = judge(
            reference, statements, names=names, notation=notation, about=about,
            convention=convention or (), values=values, where=where or (), function=function,
            only=only or (), blame=blame,
        )  # fmt: skip
        return {"id": key, **check_json(found)}

    def crosscheck(self, scene: SceneText) -> dict[str, Any]:
        """Derive by four routes; prove that they agree, and what is published for the scene."""
        key, system, _ = self._sent(scene)
        result = cross(system, CrossCheck(states=MOST_STATES))
        return {"scene": key, **to_json([result])}

    def compare(
        self,
        scene: SceneText,
        against: Literal[
            "pinocchio", "mujoco", "sympy", "drake", "pybullet", "roboticstoolbox"
        ] = "sympy",
        values: dict[str, float] | None = None,
    ) -> dict[str, Any]:
        """Numbers of another engine beside ours, and the cause where they differ."""
        key, reference = self._reference(scene)
        found = compare_with(reference.truth.scene, against, values=values)
        return {"id": key, **to_record(found)}

    def codegen(
        self,
        scene: SceneText,
        outputs: list[str] | None = None,
        fix: dict[str, str] | None = None,
        precision: Literal["double", "single", "both"] = "double",
    ) -> dict[str, Any]:
        """The files of a C99 folder that was proved, by name."""
        key, reference = self._reference(scene)
        model = compile(reference.truth, fixed=fix, outputs=outputs)
        with TemporaryDirectory() as folder:
            target = Path(folder) / "c"
            paths = write_c(model, target, precision=precision, batch=False)
            files = {
                path.relative_to(target).as_posix(): path.read_text(encoding="utf-8")
                for path in paths
            }
        return {"scene": key, "files": files}

    def verify(self, scene: SceneText, files: dict[str, str]) -> dict[str, Any]:
        """Every step from the physics to the C text, from the files that `codegen` gave.

        The files are read, not compiled.
        """
        _few("files", files, MOST_FILES)
        _short("all files together", "".join(files.values()), LARGEST_FOLDER)
        key, reference = self._reference(scene)
        with TemporaryDirectory() as folder:
            for name, text in files.items():
                parts = PurePosixPath(name).parts
                if not parts or len(parts) > 4 or not all(FILE.fullmatch(part) for part in parts):
                    raise InputError(f"verify: {name[:60]!r} is no name of a file of such a folder")
                path = Path(folder, *parts)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8", newline="")
            read = read_folder(Path(folder))
            found = verify_folder(read, derive_by(reference.truth.scene, read.route), False)
            return {
                "scene": key,
                "outcome": found.outcome.name,
                "changed": list(read.changed),
                "missing": list(read.missing),
                "beyond_manifest": list(read.beyond),
                **chain_record(found.chain),
            }

    def _reference(self, scene: SceneText) -> tuple[str, Reference]:
        """What statements are compared with, derived once."""
        key, _, reference = self._sent(scene)
        return key, reference

    def _sent(self, scene: SceneText) -> tuple[str, System | Scene, Reference]:
        """The id of what was sent, what it is, and what was derived of it."""
        if isinstance(scene, str) and ID.fullmatch(scene):
            if scene not in self._known:
                raise InputError(f"{scene} is not known any more: send the scene itself")
            key = scene
        else:
            name = isinstance(scene, str) and not scene.lstrip().startswith("{")
            text = scene if isinstance(scene, str) else json.dumps(scene, sort_keys=True)
            key = f"scene-{sha256(text.encode()).hexdigest()[:16]}"
            if key not in self._known:
                made = built_in(text) if name else from_json(text)
                truth = derived(made.scene() if isinstance(made, System) else made)
                verify_laws(truth)
                self._known[key] = made, Reference(truth)
                while len(self._known) > KEPT:
                    self._known.popitem(last=False)
        self._known.move_to_end(key)
        return key, *self._known[key]


def _few(what: str, things: Sequence[Any] | Mapping[str, Any], most: int) -> None:
    if len(things) > most:
        raise InputError(f"{what}: {len(things)} found, at most {most} are read")


def _short(what: str, text: str, most: int) -> None:
    if len(text) > most:
        raise InputError(f"{what} has {len(text)} characters, at most {most} are read")
