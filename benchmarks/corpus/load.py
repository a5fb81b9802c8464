"""Cases from files: a source, a scene, statements."""

import importlib.util
import tarfile
import tempfile
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from mechanics.scene import Scene

HERE = Path(__file__).parent
ARCHIVE = HERE / "sealed.tar.xz"
SUFFIXES = {
    "latex": ".tex", "text": ".txt", "python": ".py", "c": ".c", "cpp": ".cpp", "arduino": ".ino",
    "matlab": ".m", "julia": ".jl", "modelica": ".txt", "markdown": ".md",
}  # fmt: skip


@dataclass(frozen=True)
class Case:
    """One statement as its author typed it.

    Attributes
    ----------
    scene : Path
        The file of the scene, and its function.
    written, mended : str
        The mistake of a wrong one.
    options : dict
        For `mechanics.check`: what a person would have to say.
    """

    source: str
    kind: str
    scene: Path
    function: str
    name: str
    input: str
    text: str
    right: bool
    written: str = ""
    mended: str = ""
    origin: str = ""
    options: dict[str, Any] = field(default_factory=dict)


def cases(folder: Path = HERE) -> Iterator[Case]:
    """All cases of a folder with ``cases`` and ``scenes``, in the order of their files."""
    for path in sorted((folder / "cases").glob("*.toml")):
        data = tomllib.loads(path.read_text(encoding="utf-8"))
        for one in data["statement"]:
            file, _, function = one.get("scene", data.get("scene", "")).partition(":")
            mistake = one.get("mistake", {})
            yield Case(
                data["source"], data["kind"], folder / "scenes" / file, function or "make_scene",
                f"{path.stem}/{one['name']}", one["input"], one["text"], one["right"],
                mistake.get("as_written", ""), mistake.get("mended", ""), one.get("origin", ""),
                one.get("options", {}),
            )  # fmt: skip


def sealed() -> Iterator[Case]:
    """Cases of the part that nobody who writes the program has seen."""
    if not ARCHIVE.exists():
        raise SystemExit(f"no {ARCHIVE.name} here: all sealed statements are open (SEALED.md)")
    with tempfile.TemporaryDirectory(prefix="corpus_") as folder:
        with tarfile.open(ARCHIVE) as archive:
            archive.extractall(folder, filter="data")
        (root,) = {path.parent for path in Path(folder).rglob("cases")}
        yield from cases(root)


@cache
def scene_of(file: Path, function: str) -> Scene:
    """The scene of a case."""
    if not file.exists():
        from mechanics.cli.load import load

        return load(str(file.name)).scene()
    spec = importlib.util.spec_from_file_location(file.stem, file)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, function)()
