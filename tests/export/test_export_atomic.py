"""What is written appears whole or not at all, and what is REFUTED never."""

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from mechanics.compiled import Model
from mechanics.crosscheck.fmu import write_fmu
from mechanics.errors import InputError, RefutedError
from mechanics.export import implementation, write_c
from mechanics.export.atomic import replace_in_folder, replaced_file
from mechanics.export.evidence.verify import chain
from mechanics.export.fmu import unit

Modelled = Callable[[str, str], Model]
FEW: dict[str, Any] = {"functions": ["energy"], "batch": False, "measure": False}
# The package has the function under the name of its module.
write_c_module = sys.modules["mechanics.export.write_c"]


def tree(folder: Path) -> dict[str, bytes | None]:
    """Every name below a folder, and what is in the files."""
    return {
        str(path.relative_to(folder)): None if path.is_dir() else path.read_bytes()
        for path in sorted(folder.rglob("*"))
    }


@pytest.fixture(autouse=True)
def proved(without_chain: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """Proofs are made here, unlike in the other tests of the folder."""
    monkeypatch.setattr(write_c_module, "chain", chain)


@pytest.fixture
def wrong_sign(monkeypatch: pytest.MonkeyPatch) -> None:
    """Printers that put a minus for a plus."""

    def changed(make: Callable[..., str]) -> Callable[..., str]:
        return lambda *given: make(*given).replace(" + ", " - ")

    monkeypatch.setattr(implementation, "implementation", changed(implementation.implementation))
    monkeypatch.setattr(unit, "model_source", changed(unit.model_source))


def c_of(model: Model, place: Path) -> None:
    write_c(model, place / "c", **FEW)


def unit_of(model: Model, place: Path) -> None:
    write_fmu(model, place / "rocker.fmu", step=0.01)


WRITERS = {"write_c": c_of, "write_fmu": unit_of}


@pytest.mark.campaign
@pytest.mark.parametrize("writer", WRITERS)
def test_what_is_refuted_is_not_written(
    modelled: Modelled, tmp_path: Path, wrong_sign: None, writer: str
) -> None:
    with pytest.raises(RefutedError, match=r"^REFUTED .*theta = .* is not written$"):
        WRITERS[writer](modelled("rocker", "kane"), tmp_path)
    assert tree(tmp_path) == {}


@pytest.mark.campaign
@pytest.mark.parametrize("writer", WRITERS)
def test_what_stood_there_before_is_untouched(
    modelled: Modelled, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, request: Any, writer: str
) -> None:
    WRITERS[writer](modelled("rocker", "kane"), tmp_path)
    before = tree(tmp_path)
    assert before
    request.getfixturevalue("wrong_sign")
    with pytest.raises(RefutedError):
        WRITERS[writer](modelled("rocker", "kane"), tmp_path)
    assert tree(tmp_path) == before


@pytest.mark.parametrize("writer", WRITERS)
def test_an_interrupted_proof_leaves_nothing(
    modelled: Modelled, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, writer: str
) -> None:
    def stopped(*given: object, **options: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(write_c_module, "chain", stopped)
    monkeypatch.setattr(unit, "prove_unit", stopped)
    with pytest.raises(KeyboardInterrupt):
        WRITERS[writer](modelled("rocker", "kane"), tmp_path)
    assert tree(tmp_path) == {}


class Stops:
    """Lets the calls of the file system pass but for one, which raises before or after its work."""

    NAMES = ((os, "rename"), (Path, "rename"), (Path, "replace"), (Path, "write_bytes"),
             (Path, "mkdir"))  # fmt: skip

    def __init__(self, patch: pytest.MonkeyPatch, at: int, stop: BaseException, late: bool) -> None:
        self.left = at
        for owner, name in self.NAMES:
            patch.setattr(owner, name, self.counted(getattr(owner, name), stop, late))

    def counted(self, work: Callable[..., Any], stop: BaseException, late: bool) -> Any:
        def call(*given: Any, **options: Any) -> Any:
            self.left -= 1
            if self.left != 0:
                return work(*given, **options)
            if late:
                work(*given, **options)
            raise stop

        return call


def held(place: Path) -> None:
    """A folder with files of ours and of others."""
    (place / "c" / "build").mkdir(parents=True)
    for name in ("a.c", "old.c", "notes.txt", "build/a.o"):
        (place / "c" / name).write_text(f"{name} before", encoding="utf-8")


STATES: dict[str, tuple[Callable[[Path], None], str]] = {
    "a new folder": (lambda place: None, "c"),
    "a new folder in new folders": (lambda place: None, "new/newer/c"),
    "a folder that is held": (held, "c"),
    "an empty folder": (lambda place: (place / "c").mkdir(), "c"),
}


@pytest.mark.parametrize("late", [False, True])
@pytest.mark.parametrize("stop", [KeyboardInterrupt(), OSError(28, "No space left on device")])
@pytest.mark.parametrize("state", STATES)
def test_a_folder_appears_whole_or_not_at_all(
    tmp_path: Path, state: str, stop: BaseException, late: bool
) -> None:
    """At each call of the file system in turn: there is what was, or all there should be."""
    made, name = STATES[state]
    files = {"a.c": b"a", "b.c": b"b", "manifest.json": b"{}"}
    stopped = 0
    for at in range(1, 100):
        place = tmp_path / str(at)
        place.mkdir()
        made(place)
        before = tree(place)
        with pytest.MonkeyPatch.context() as patch:
            Stops(patch, at, stop, late)
            try:
                replace_in_folder(place / name, files, ["old.c"] if made is held else [])
            except (KeyboardInterrupt, OSError) as error:
                assert error is stop
                stopped += 1
                assert tree(place) in (before, whole(before, name, files))
                # All is there only where what was interrupted was the last rename.
                assert tree(place) == before or late
                continue
        assert tree(place) == whole(before, name, files)
        break
    assert stopped >= 5


def whole(
    before: dict[str, bytes | None], name: str, files: dict[str, bytes]
) -> dict[str, bytes | None]:
    folders = {str(path): None for path in (Path(name), *Path(name).parents) if str(path) != "."}
    kept = {path: content for path, content in before.items() if path != f"{name}/old.c"}
    return {**kept, **folders, **{f"{name}/{file}": text for file, text in files.items()}}


@pytest.mark.parametrize("late", [False, True])
@pytest.mark.parametrize("before", [None, b"before"])
def test_a_file_appears_whole_or_not_at_all(
    tmp_path: Path, before: bytes | None, late: bool
) -> None:
    target = tmp_path / "a.fmu"
    if before is not None:
        target.write_bytes(before)
    for at in (1, 2):
        with pytest.MonkeyPatch.context() as patch, pytest.raises(KeyboardInterrupt):
            Stops(patch, at, KeyboardInterrupt(), late)
            with replaced_file(target) as fresh:
                fresh.write_bytes(b"new")
        there = tree(tmp_path)
        # The rename is the second call: once it is done, so is all.
        expected = b"new" if late and at == 2 else before
        assert there == ({} if expected is None else {"a.fmu": expected})


def test_a_file_keeps_its_permissions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target = tmp_path / "a.html"
    target.write_text("before", encoding="utf-8")
    target.chmod(0o640)
    with replaced_file(target) as fresh:
        fresh.write_text("new", encoding="utf-8")
    assert target.stat().st_mode & 0o777 == 0o640
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    with pytest.raises(PermissionError, match="read-only"), replaced_file(target) as fresh:
        fresh.write_text("newer", encoding="utf-8")
    assert tree(tmp_path) == {"a.html": b"new"}


def test_a_pipe_is_written_to(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    reader = os.open(tmp_path / "pipe", os.O_RDONLY | os.O_NONBLOCK)
    with replaced_file(tmp_path / "pipe") as fresh:
        fresh.write_text("new", encoding="utf-8")
    assert os.read(reader, 10) == b"new"
    os.close(reader)
    assert [path.name for path in tmp_path.iterdir()] == ["pipe"]


def test_links_keep_their_places(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "real")
    replace_in_folder(tmp_path / "link", {"a.c": b"a"})
    assert (tmp_path / "link").is_symlink() and tree(tmp_path / "real") == {"a.c": b"a"}
    (tmp_path / "real.fmu").write_bytes(b"before")
    (tmp_path / "link.fmu").symlink_to("real.fmu")
    with replaced_file(tmp_path / "link.fmu") as fresh:
        fresh.write_bytes(b"new")
    assert (tmp_path / "link.fmu").is_symlink()
    assert (tmp_path / "real.fmu").read_bytes() == b"new"


def test_a_link_into_itself_is_one_line(modelled: Modelled, tmp_path: Path) -> None:
    (tmp_path / "c").symlink_to(tmp_path / "c")
    with pytest.raises(InputError, match="c cannot be written: "):
        write_c(modelled("rocker", "kane"), tmp_path / "c", **FEW, prove=False)
    assert [path.name for path in tmp_path.iterdir()] == ["c"]


def test_what_a_link_in_the_folder_leads_to_is_left_alone(
    modelled: Modelled, tmp_path: Path
) -> None:
    folder, victim = tmp_path / "c", tmp_path / "victim"
    write_c(modelled("rocker", "kane"), folder, **FEW, prove=False)
    victim.write_text("mine", encoding="utf-8")
    (folder / "rocker.c").unlink()
    (folder / "rocker.c").symlink_to(victim)
    write_c(modelled("rocker", "kane"), folder, **FEW, prove=False)
    assert victim.read_text(encoding="utf-8") == "mine"
    assert not (folder / "rocker.c").is_symlink()


def test_a_folder_that_is_read_only_is_told_before_the_proofs(
    modelled: Modelled, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "access", lambda path, mode: Path(path) != tmp_path)
    with pytest.raises(InputError, match=f"c cannot be written: {tmp_path} is read-only"):
        write_c(modelled("rocker", "kane"), tmp_path / "c", **FEW)
    with pytest.raises(InputError, match=r"rocker\.fmu cannot be written: .* is read-only"):
        write_fmu(modelled("rocker", "kane"), tmp_path / "rocker.fmu", step=0.01)
