"""Libraries that several threads ask for at once are all made, in one folder."""

import subprocess
import sys

import pytest

from mechanics.compiled.machine.native import find_compiler

SOURCE = """
from concurrent.futures import ThreadPoolExecutor
from mechanics.compiled.machine.library import build, find_compiler

compiler = find_compiler()
with ThreadPoolExecutor(8) as pool:
    made = list(pool.map(
        lambda k: build("int f(void) { return %d; }" % k, compiler, ["-O0"]),
        range(16),
    ))
assert all(file.exists() for file in made)
assert len({file.parent for file in made}) == 1
"""


@pytest.mark.campaign
@pytest.mark.skipif(find_compiler() is None, reason="needs a C compiler")
def test_the_first_libraries_of_a_process_are_made_side_by_side() -> None:
    """In a process of its own: the folder is made by whoever comes first."""
    found = subprocess.run([sys.executable, "-c", SOURCE], capture_output=True, text=True)
    assert found.returncode == 0, found.stderr
