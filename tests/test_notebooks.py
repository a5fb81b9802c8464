"""The notebooks of the documentation run, and show everything that a notebook can show."""

import importlib.util
import json
from pathlib import Path
from types import ModuleType

import pytest

DOCS = Path(__file__).parents[1] / "docs"
NOTEBOOKS = sorted((DOCS / "notebooks").glob("*.ipynb"))


@pytest.fixture(scope="module")
def pages() -> ModuleType:
    """The module that makes pages of notebooks."""
    spec = importlib.util.spec_from_file_location("notebook_pages", DOCS / "notebook_pages.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_no_output_is_kept(path: Path) -> None:
    whole = json.loads(path.read_text(encoding="utf-8"))
    assert (whole["nbformat"], whole["nbformat_minor"]) == (4, 5)
    ids = [cell["id"] for cell in whole["cells"]]
    assert len({*ids}) == len(ids)
    for cell in whole["cells"]:
        if cell["cell_type"] == "code":
            compile("".join(cell["source"]), path.name, "exec")
            assert (cell["outputs"], cell["execution_count"]) == ([], None)


SHOWN = {
    "pendulum": ("Scene", "Equations", "SystemResult", "Model", "Trajectory"),
    "check": ("Scene", "Check"),
    "control": ("Scene", "Linear", "Trajectory"),
}
SIGNS = {
    "Scene": '<svg class="drawing"',
    "Equations": "by <code>kane</code>",
    "SystemResult": "checks passed.",
    "Model": "<code>forward_dynamics(",
    "Trajectory": "<animate ",
    "Linear": "<p>states: ",
    "Check": "<iframe ",
}


@pytest.mark.campaign
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(pages: ModuleType, path: Path) -> None:
    cells = pages.run(path)
    shown = [cell.shown["text/html"] for cell in cells if "text/html" in cell.shown]
    for name in SHOWN[path.stem]:
        assert any(SIGNS[name] in html for html in shown), name
    assert all(len(cell.shown.get("text/plain", "")) < 200 for cell in cells)
    assert "False" not in "".join(cell.printed for cell in cells)


@pytest.mark.campaign
def test_a_cell_that_fails_is_no_page(pages: ModuleType, tmp_path: Path) -> None:
    path = tmp_path / "wrong.ipynb"
    path.write_text(json.dumps({"cells": [{"cell_type": "code", "source": ["1 / 0"]}]}))
    with pytest.raises(ZeroDivisionError):
        pages.page(path)
