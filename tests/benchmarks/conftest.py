"""A compiler for the tests that need one."""

import pytest

from mechanics.compiled.machine.native import find_compiler


@pytest.fixture(scope="session")
def compiler() -> str:
    found = find_compiler()
    if found is None:
        pytest.skip("no C compiler here")
    return found
