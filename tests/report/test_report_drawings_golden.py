"""The drawing of every system is the one that was looked at last.

`MECHANICS_UPDATE_GOLDEN=1 pytest -m "" FILE` with this file
writes them anew; `python -m benchmarks.drawings FOLDER` shows them all.
"""

import os
from pathlib import Path

import pytest

from benchmarks.drawings import picture
from mechanics.scene.system import System
from systems import EVERY

GOLDEN = Path(__file__).parent / "golden" / "drawings"


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", EVERY, ids=lambda system: system.name)
def test_a_drawing_is_the_one_that_was_looked_at(system: System) -> None:
    file = GOLDEN / f"{system.name}.svg"
    drawn = picture(system)
    if os.environ.get("MECHANICS_UPDATE_GOLDEN") == "1":
        GOLDEN.mkdir(exist_ok=True)
        file.write_text(drawn, encoding="utf-8")
    assert drawn == file.read_text(encoding="utf-8")


def test_every_golden_drawing_is_of_a_system() -> None:
    assert {file.stem for file in GOLDEN.glob("*.svg")} == {system.name for system in EVERY}
