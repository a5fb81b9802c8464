"""What a person's code prints is no part of an answer: it goes to standard error."""

import csv
import io
import json
import subprocess
import sys
from pathlib import Path

import pytest

CODE = """
import numpy as np
print("loaded")
def rate(t, y, m, l, g, u):
    print("called")
    return np.array([y[1], 1.5*g/l*np.sin(y[0]) + 3*u/(m*l**2)])
"""
SCENE = """
from systems import rod_pendulum
print("scene loaded")
def scene():
    print("scene made")
    return rod_pendulum.scene()
"""


def printed(folder: Path, *arguments: str) -> tuple[str, str]:
    (folder / "rate.py").write_text(CODE)
    (folder / "key.py").write_text(SCENE)
    ran = subprocess.run(
        [sys.executable, "-m", "mechanics", *arguments],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ran.returncode in (0, 3), ran.stderr
    return ran.stdout, ran.stderr


@pytest.mark.sample(1)
@pytest.mark.parametrize(
    "arguments",
    [
        ("check", "key.py", "rate.py:rate", "--name", "y=theta theta_dot"),
        ("grade", "key.py", "rate.py", "--run-python", "--name", "y=theta theta_dot"),
    ],
)
def test_json_is_all_of_standard_output(tmp_path: Path, arguments: tuple[str, ...]) -> None:
    answer, rest = printed(tmp_path, *arguments, "--json", "-")
    assert isinstance(json.loads(answer), dict)
    words = {"scene loaded", "scene made", "loaded", "called"}
    assert words <= {*rest.splitlines()}


def test_a_table_is_all_of_standard_output(tmp_path: Path) -> None:
    answer, _ = printed(tmp_path, "grade", "key.py", "rate.py", "--run-python", "--csv", "-")
    rows = [*csv.reader(io.StringIO(answer))]
    assert [len(row) for row in rows] == [len(rows[0])] * 2
    assert rows[1][0] == "rate.py"
