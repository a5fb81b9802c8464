"""Files that are written for a compiler."""

import os
from pathlib import Path

import pytest

from mechanics.compiled.machine.process import write_source


def test_a_full_disk_is_told_with_the_name_of_the_file(tmp_path: Path) -> None:
    if not os.path.exists("/dev/full"):
        pytest.skip("no /dev/full here")
    (tmp_path / "name.c").symlink_to("/dev/full")
    with pytest.raises(OSError, match=r"No space left on device: '.*name\.c'"):
        write_source(tmp_path / "name.c", "int x;")
