"""A folder of parts, which a run fills and goes on with after a stop.

    ensemble.json                        what is computed; another run is refused
    motions/part-000000000.parquet       there: the part is done
    samples/part-000000000.parquet       before its motions, where samples are wanted

A file appears whole or not at all, and is on the disk before it appears.
"""

import json
import os
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

from mechanics.errors import InputError
from mechanics.simulate.ensembles.files import FRESH, MOTIONS, SAMPLES, fresh, writable
from mechanics.simulate.ensembles.tables import ENDING, MACHINE
from mechanics.simulate.parquet import parquet

try:
    import fcntl
except ImportError:  # Windows: two runs at once write the same files twice.
    fcntl = None  # type: ignore[assignment]

Content = Any
"""Bytes, what gives them without a copy, or the path of a fresh file that holds them."""
MANIFEST, LOCK = "ensemble.json", ".lock"
PART = "part"
"""Motions in a part: chosen when a folder is begun, and kept."""


@dataclass(frozen=True)
class Folder:
    """Where parts are written.

    Attributes
    ----------
    part : int
        Motions in a part.
    done : frozenset of int
        Parts that were there already.
    """

    path: Path
    part: int
    done: frozenset[int]

    def add(self, number: int, motions: Content, samples: Content | None) -> None:
        """Add a part: what `tables.written` gives."""
        with writable(self.path):
            if samples is not None:
                _put(_file(self.path / SAMPLES, number), samples)
            _put(_file(self.path / MOTIONS, number), motions)


@contextmanager
def opened(path: Path, about: Mapping[str, Any]) -> Iterator[Folder]:
    """A folder that is ours alone: made, or gone on with.

    Parameters
    ----------
    about : mapping
        What is computed, as JSON has it, and the motions in a part.

    Raises
    ------
    InputError
        For a folder that holds something else, or another run, or that another process writes to;
        for one that cannot be written.
    """
    with ExitStack() as stack:
        with writable(path):
            _made(path)
            _lock(path, stack.enter_context((path / LOCK).open("w")))
            part = _begun(path, about)
            _clean(path)
            done = frozenset(int(file.stem.split("-")[1]) for file in _parts(path))
        yield Folder(path, part, done)
        _clean(path)


def _clean(path: Path) -> None:
    for file in path.glob(f"*/*{FRESH}"):
        file.unlink(missing_ok=True)


def _lock(path: Path, file: IO[str]) -> None:
    """Until it is closed, no other process writes there."""
    if fcntl is not None:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise InputError(
                f"folder {path}: another process is writing there: wait for it, or name another"
                " folder"
            ) from None


def summary(path: Path) -> tuple[Counter[str], tuple[str, ...]]:
    """How many motions ended how, and the kinds of machines that integrated them."""
    _, reader = parquet(f"folder {path}")
    endings: Counter[str] = Counter()
    machines = dict[str, None]()
    for file in _parts(path):
        with reader.ParquetFile(file) as opened:
            about = opened.schema_arrow.metadata or {}
            machines[about.get(MACHINE, b"").decode()] = None
            for entry in opened.read([ENDING])[ENDING].value_counts().to_pylist():
                endings[entry["values"]] += entry["counts"]
    return endings, tuple(machines)


def _parts(path: Path) -> list[Path]:
    return sorted((path / MOTIONS).glob("part-*.parquet"))


def _file(folder: Path, number: int) -> Path:
    return folder / f"part-{number:09d}.parquet"


def _made(path: Path) -> None:
    if path.exists() and not path.is_dir():
        raise InputError(f"folder {path}: it is a file: name a folder")
    if not path.parent.is_dir():
        raise InputError(f"folder {path}: there is no folder {path.parent}: make it first")
    if path.is_dir() and {*os.listdir(path)} - {LOCK} and not (path / MANIFEST).is_file():
        raise InputError(f"folder {path}: it holds other files: name a new or an empty folder")
    for folder in (path, path / MOTIONS, path / SAMPLES):
        folder.mkdir(exist_ok=True)


def _begun(path: Path, about: Mapping[str, Any]) -> int:
    """Motions in a part of this run: as it was begun."""
    manifest = path / MANIFEST
    if not manifest.exists():
        _put(manifest, (json.dumps(about, indent=2) + "\n").encode())
        return int(about[PART])
    try:
        before = json.loads(manifest.read_text(encoding="utf-8"))
        part = int(before[PART])
    except (ValueError, KeyError, TypeError):
        raise InputError(
            f"folder {path}: its {MANIFEST} cannot be read: name a new or an empty folder"
        ) from None
    for name in (*about, *before):
        if name != PART and about.get(name) != before.get(name):
            raise InputError(
                f"folder {path}: it holds another run, with {name}"
                f" {json.dumps(before.get(name))[:200]}, not {json.dumps(about.get(name))[:200]}:"
                " name another folder"
            )
    if part < 1:
        raise InputError(f"folder {path}: its {MANIFEST} has parts of {part} motions")
    return part


def _put(file: Path, content: Content) -> None:
    """Whole, or not at all, whatever stops this machine."""
    there = isinstance(content, Path)
    path = content if there else fresh(file.parent)
    with path.open("r+b" if there else "wb") as stream:
        if not there:
            stream.write(content)
            stream.flush()
        os.fsync(stream.fileno())
    os.replace(path, file)
