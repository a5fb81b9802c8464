"""A scene in a JSON file is a system."""

import json
from pathlib import Path

import pytest

from mechanics import to_json
from mechanics.cli.load import is_file, load
from mechanics.errors import InputError
from systems import rod_pendulum


def test_a_scene_in_json_is_a_system(tmp_path: Path) -> None:
    file = tmp_path / "rod.json"
    file.write_text(json.dumps(to_json(rod_pendulum.scene())))
    system = load(str(file))
    assert system.name == "rod"
    assert is_file(str(file))
    assert to_json(system.scene()) == to_json(rod_pendulum.scene())


def test_a_file_that_is_no_scene_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "rod.json"
    with pytest.raises(InputError, match="it cannot be read"):
        load(str(file))
    file.write_text("{}")
    with pytest.raises(InputError, match="expected"):
        load(str(file)).scene()
