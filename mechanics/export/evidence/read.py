"""A folder of generated code, read back: nothing but its files is used."""

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from math import isfinite
from pathlib import Path
from typing import Any

from mechanics.compiled.translation_validation.code import Code
from mechanics.compiled.translation_validation.derived import Derived
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.errors import ExpressionError, InputError
from mechanics.export.evidence import equations, graphs
from mechanics.export.evidence.beyond import may_be_read
from mechanics.export.evidence.chain import Evidence
from mechanics.export.folder import MANIFEST

LARGEST_FILE = 64_000_000
"""Bytes; generated files are a thousandth of it."""
KINDS = ("double", "float")
NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.]*")
"""Names of files that `write_c` writes: no path, no option of a compiler."""
POWER, LONGEST = re.compile(r"[eE][-+]?\d{4}|\*\*"), 1000
"""What no value of a parameter has: an exponent beyond every double, so many characters."""
NEEDED = (equations.FILE, graphs.FILE)
"""Files without which there is nothing to compare the others with."""


@dataclass(frozen=True)
class Folder:
    """What a folder holds.

    Attributes
    ----------
    manifest : mapping
    changed : tuple of str
        Files whose hash is not the one that the manifest has.
    missing : tuple of str
        Files that the manifest has and the folder has not.
    texts : mapping of str to str
        Every file that the manifest has.
    beyond : tuple of str
        What it holds beside these, and no build reads.
    misread : tuple of str
        What it holds beside these, and a build may read in place of a header, source or script.
    """

    path: Path
    manifest: Mapping[str, Any]
    evidence: Evidence
    changed: tuple[str, ...]
    missing: tuple[str, ...]
    texts: Mapping[str, str]
    beyond: tuple[str, ...] = ()
    misread: tuple[str, ...] = ()

    @property
    def system(self) -> str | None:
        """The built-in system that it says it was made from."""
        name = self.manifest.get("system")
        return name if isinstance(name, str) else None

    @property
    def route(self) -> str:
        """Route that derived the equations."""
        return str(self.manifest["route"])

    @property
    def fixed(self) -> dict[str, str]:
        """Exact values of fixed parameters, by name."""
        return {str(name): str(value) for name, value in self.manifest["fixed"].items()}


def read_folder(path: Path) -> Folder:
    """Read a folder that `write_c` wrote.

    Raises
    ------
    InputError
        If it is no such folder, or a file of it cannot be read; the file is named.
    """
    if not path.is_dir():
        what = "is a file" if path.exists() else "does not exist"
        raise InputError(f"{path} {what}: name a folder that `mechanics codegen` wrote")
    manifest = _manifest(path)
    texts: dict[str, str] = {}
    changed, missing = [], []
    for name, digest in manifest["files"].items():
        if not NAME.fullmatch(name):
            raise InputError(f"{path / MANIFEST}: {name!r} is no name of a file in the folder")
        if not (path / name).is_file():
            if name in NEEDED:
                raise InputError(f"{path / name}: the manifest lists it, but the folder lacks it")
            missing.append(name)
            continue
        raw = _bytes(path / name)
        if sha256(raw).hexdigest() != digest:
            changed.append(name)
        texts[name] = _decoded(path / name, raw)
    evidence = _evidence(path, manifest, texts)
    misread, beyond = _beyond(path, {*texts, MANIFEST})
    return Folder(path, manifest, evidence, tuple(changed), tuple(missing), texts, beyond, misread)


def _beyond(path: Path, listed: set[str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What is in a folder and not listed: what a build may read, and the rest."""
    try:
        others = sorted(entry for entry in path.iterdir() if entry.name not in listed)
        read = [entry.name for entry in others if may_be_read(entry)]
    except OSError as error:
        raise InputError(f"{path}: it cannot be read: {error.strerror}") from None
    return tuple(read), tuple(entry.name for entry in others if entry.name not in read)


def _bytes(file: Path) -> bytes:
    try:
        if file.is_symlink():
            raise InputError(f"{file}: it is a link: put the file itself into the folder")
        if file.stat().st_size > LARGEST_FILE:
            raise InputError(
                f"{file}: it is larger than {LARGEST_FILE // 1_000_000} MB: no file"
                " of generated code"
            )
        return file.read_bytes()
    except OSError as error:
        raise InputError(f"{file}: it cannot be read: {error.strerror}") from None


def _decoded(file: Path, raw: bytes) -> str:
    try:
        return raw.decode("utf-8")
    except UnicodeDecodeError as error:
        raise InputError(f"{file}: it is no text in UTF-8: {error}") from None


def _json(file: Path, text: str) -> Any:
    try:
        return json.loads(text, object_pairs_hook=_once, parse_constant=_finite, parse_float=_float)
    except RecursionError:
        raise InputError(f"{file}: it is nested too deeply") from None
    except ValueError as error:
        raise InputError(f"{file}: it is no JSON: {error}") from None


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Who reads a name that stands twice may take the other value."""
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"{twice[:40]!r} stands twice in one place")
    return found


def _finite(word: str) -> float:
    raise ValueError(f"{word} is no number of JSON")


def _float(word: str) -> float:
    value = float(word)
    return value if isfinite(value) else _finite(word)


def _manifest(path: Path) -> dict[str, Any]:
    file = path / MANIFEST
    if not file.is_file():
        raise InputError(
            f"{file}: there is no such file: was the folder made by `mechanics codegen`?"
        )
    content = _json(file, _decoded(file, _bytes(file)))
    wanted = {"files": dict, "fixed": dict, "route": str, "scene": str, "kernels": list}
    for name, kind in wanted.items():
        if not isinstance(content, dict) or not isinstance(content.get(name), kind):
            raise InputError(
                f"{file}: it has no {name!r}: is it the manifest of generated code,"
                " and of this version?"
            )
    for value in content["fixed"].values():
        if not isinstance(value, str) or POWER.search(value) or len(value) > LONGEST:
            raise InputError(
                f"{file}: {str(value)[:40]!r} is no number that a parameter is fixed at"
            )
    if not all(isinstance(digest, str) for digest in content["files"].values()):
        raise InputError(f"{file}: a hash is expected for every file")
    return content


def _evidence(path: Path, manifest: Mapping[str, Any], texts: Mapping[str, str]) -> Evidence:
    for name in (equations.FILE, graphs.FILE):
        if name not in texts:
            raise InputError(
                f"{path / name}: there is no such file, or the manifest does not list it"
            )
    at = path / equations.FILE
    try:
        known = equations.read_equations(_json(at, texts[equations.FILE]))
        at = path / graphs.FILE
        found, rates = graphs.read_graphs(_json(at, texts[graphs.FILE]))
        _fit(known, [*(graph.code for graph in found.values()), *([rates] if rates else [])])
        at = path / MANIFEST
        kernels = tuple(_kernel(record) for record in manifest["kernels"])
    except ExpressionError as error:
        raise InputError(f"{at}: {error}") from None
    code = {name: text for name, text in texts.items() if name.endswith((".c", ".h"))}
    return Evidence(known, found, rates, kernels, code)


def _fit(known: Derived, codes: Sequence[Code]) -> None:
    """The graphs have the arrays of what was derived."""
    for code in codes:
        for group, size in code.inputs:
            if len(known.symbols.get(group, ())) != size:
                raise ExpressionError(
                    f"{code.name}: its input {group} has {size} entries, what was"
                    f" derived {len(known.symbols.get(group, ()))}"
                )


def _kernel(record: Any) -> Kernel:
    words = ("function", "symbol", "file", "kind")
    if not isinstance(record, dict) or not all(isinstance(record.get(w), str) for w in words):
        raise ExpressionError("a kernel has a function, a symbol, a file and a kind")
    shared = record.get("shared")
    if record["kind"] not in KINDS or not (shared is None or isinstance(shared, list)):
        raise ExpressionError(f"kernel {record['symbol'][:60]}: its kind is not known")
    names = None if shared is None else tuple(map(str, shared))
    function, symbol, file, kind = (record[word] for word in words)
    return Kernel(function, symbol, file, kind, names)
