"""Public names are imported when they are asked for, and are what they are called."""

import ast
import inspect
import pydoc
import re
import subprocess
import sys

import pytest

import mechanics


@pytest.mark.parametrize("name", mechanics.__all__)
def test_every_name_is_there_and_no_module(name: str) -> None:
    assert not inspect.ismodule(getattr(mechanics, name))
    assert name in dir(mechanics)


def test_names_for_type_checkers_are_those_that_are_imported() -> None:
    tree = ast.parse(inspect.getsource(mechanics))
    block = next(node for node in tree.body if isinstance(node, ast.If))
    typed = {
        alias.asname or alias.name: (found.module, alias.name)
        for found in block.body
        if isinstance(found, ast.ImportFrom)
        for alias in found.names
    }
    assert typed == mechanics._MODULES
    assert sorted(typed) == sorted(mechanics.__all__)


@pytest.mark.campaign
def test_a_function_is_not_hidden_by_the_module_of_its_name() -> None:
    code = (
        "import mechanics.crosscheck.system, mechanics.trade, mechanics;"
        "assert callable(mechanics.crosscheck) and callable(mechanics.trade)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_name_that_is_not_there_is_no_attribute() -> None:
    with pytest.raises(AttributeError, match="nothing"):
        _ = mechanics.nothing


def test_help_fits_a_screen_and_names_everything() -> None:
    page = pydoc.plain(pydoc.render_doc(mechanics))
    shown, contents = page.split("PACKAGE CONTENTS")
    assert len(shown.splitlines()) <= 44
    assert max(map(len, shown.splitlines())) <= 80
    assert set(mechanics.__all__) <= set(re.findall(r"\w+", shown))
    # Nothing follows but the list of folders and the file's name.
    assert re.findall("^[A-Z]+$", contents, re.MULTILINE) == ["FILE"]
