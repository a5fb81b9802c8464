"""MATLAB's anonymous functions and structs of elsewhere, compared with Octave itself."""

import shutil
import subprocess
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from mechanics.claims.code.translation.matlab import Unread, in_python
from systems import rod_pendulum
from tests.verdict_of import verdict_in

SCENE = rod_pendulum.scene()
MODEL = """function dx = model(x, u, m, l, g)
  J = @(a) a*l^2/3;
  T = @(q, v) m*g*l/2*sin(q(1)) + u;
  dx = [x(2); T(x(1), x(2))/J(m)];
end
"""
BODIES = (
    "k = 2; f = @(q) k*q; k = 3; y = f(x);",
    "k = 2; f = @(q) k*q; g = @(q) f(q) + k; k = 5; y = g(x);",
    "q = 4; f = @(q) 2*q; y = f(x) + q;",
    "f = @(q) [q(1); q(1)*2]; v = f([x; 3]); y = v(2);",
    "f = @() 3; y = f()*x;",
    "f = @(a, b) a - b; y = f(x, 2*x);",
    "x = 2*x; f = @(q) q + x; x = 7; y = f(1);",
    "k = 1; k = k + 1; f = @(k) k^2; y = f(3) + k + x;",
    "M = @(q) [cos(q) 0; 0 2]; v = M(x)\\[1; 2]; y = v(1) + v(2);",
    "f = @(sin) sin*2; y = f(x) + sin(x);",
    "a = [1 2 3]; f = @(k) a(k); a = [4 5 6]; y = f(2)*x;",
)


@pytest.mark.sample(4)
@pytest.mark.skipif(shutil.which("octave") is None, reason="octave is not installed")
@pytest.mark.parametrize("body", BODIES)
def test_a_handle_computes_what_octave_computes(body: str, tmp_path: Path) -> None:
    (tmp_path / "own.m").write_text(f"function y = own(x)\n  {body}\nend\n")
    command = ["octave", "-q", "--no-gui", "--eval", 'printf("%.17g", own(0.7))']
    told = subprocess.run(command, cwd=tmp_path, capture_output=True, check=True, text=True).stdout
    text = (tmp_path / "own.m").read_text()
    (function,) = in_python(text, "own.m", set().__contains__).functions
    assert np.ravel(function(x=0.7)) == pytest.approx([float(told)], rel=1e-15)


_verdict = partial(verdict_in, SCENE, "model.m")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("", ""),
        ("(x, u, m, l, g)", "(x, u)"),
        ("J = @(a) a*l^2/3;", "J = @(m) m*l^2/3;"),
        ("T = @", "s = @(t) sin(t); T = @"),
        ("dx = [x", "m = 2*m; m = m/2; dx = [x"),
    ],
)
def test_a_handle_is_read(old: str, new: str, tmp_path: Path) -> None:
    assert _verdict(MODEL.replace(old, new) if old else MODEL, tmp_path) == "PROVED"


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("l^2/3", "l/3"),
        ("+ u", "- 2*u"),
        ("J(m)", "J(2*m)"),
        ("T(x(1), x(2))", "T(x(2), x(1))"),
        ("  J = @", "  m = 2*m;\n  J = @"),
        ("  dx =", "  J = @(a) a*l^2;\n  dx ="),
        ("  dx =", "  J = 2;\n  dx ="),
        ("@(q, v) m", "@(g, v) m"),
        ("@(q, v) m", "@(q, l) m"),
        ("@(a) a*l^2/3", "@(~) m*l^2"),
        ("sin(q(1))", "sin(v(1))"),
        ("  J = @", "  sin = @(t) t;\n  J = @"),
        ("  J = @", "  l = @(t) t;\n  J = @"),
        ("(x(1), x(2))", "(x(1))"),
        ("/J(m)", "/J"),
        ("T = @(q, v) m*g", "T = @(q, v) (m = 2)*g"),
        ("end\n", "end\nfunction y = sin(x)\n  y = x;\nend\n"),
        ("[x(2); T(x(1), x(2))/J(m)]", "[T(x(1), x(2))/J(m); x(2)]"),
        ("  dx =", "  if u > 0\n    J = @(a) a*l^2;\n  end\n  dx ="),
    ],
)  # fmt: skip
def test_what_a_handle_hides_is_not_proved(old: str, new: str, tmp_path: Path) -> None:
    assert old in MODEL
    assert _verdict(MODEL.replace(old, new), tmp_path) in ("REFUTED", "UNDECIDED", "not read")


FIELDS = """function dx = model(x, u)
  m = config.rod_mass; l = config.rod_length; unused = config.color;
  dx = [x(2); 3*config.g/(2*l)*sin(x(1)) + 3*u/(m*l^2)];
end
"""


def test_fields_of_a_struct_of_elsewhere_are_parameters_of_their_names(tmp_path: Path) -> None:
    assert _verdict(FIELDS, tmp_path) == "PROVED"
    for old, new in (
        ("3*u/", "u/"),
        ("  dx", "  config.g = 2;\n  dx"),
        ("  dx", "  config = other;\n  dx"),
        ("  m =", "  config.g = 2*config.g;\n  m ="),
        ("config.g", "config.rod_mass"),
        ("config.rod_length", "config.second.m"),
    ):
        wrong = FIELDS.replace(old, new)
        assert wrong != FIELDS
        assert _verdict(wrong, tmp_path) in ("REFUTED", "UNDECIDED", "not read"), new


def test_a_handle_keeps_a_field_of_elsewhere_as_it_was(tmp_path: Path) -> None:
    text = """function dx = model(x, u)
  m = config.m; l = config.l; f = @(q) 3*config.g/(2*l)*sin(q) + 3*u/(m*l^2);
  m = 2*m; dx = [x(2); f(x(1))];
end
"""
    assert _verdict(text, tmp_path) == "PROVED"
    late = text.replace(" f = @", " m = 2*m; f = @").replace("  m = 2*m; dx", "  m = m/2; dx")
    assert _verdict(late, tmp_path) == "REFUTED"


def test_names_of_a_step_are_the_state_where_all_entries_have_them(tmp_path: Path) -> None:
    text = "function a = model(theta_t, theta_dot_t, u, m, l, g)\n  a = {};\nend\n"
    right = text.format("[theta_dot_t; 3*g/(2*l)*sin(theta_t) + 3*u/(m*l^2)]")
    assert _verdict(right, tmp_path) == "PROVED"
    assert _verdict(right.replace("sin(theta_t)", "sin(2*theta_t)"), tmp_path) == "REFUTED"
    two = right.replace("model(theta_t,", "model(theta_t, theta,").replace("+ 3", "+ theta + 3")
    assert _verdict(two, tmp_path) == "not read"


def test_numbers_of_a_person_may_be_made_of_each_other(tmp_path: Path) -> None:
    """half = 0.5 is half of l = 1: wrong for all other lengths, and right as the code stands."""
    text = """function dx = model(x, u)
  m = 1; l = 1; half = 0.5; J = m*l^2/3;
  dx = [x(2); (m*g*half*sin(x(1)) + u)/J];
end
"""
    assert _verdict(text, tmp_path) == "UNDECIDED"
    assert _verdict(text.replace("0.5", "0.6"), tmp_path) == "REFUTED"
    assert _verdict(text.replace("/3", "/4"), tmp_path) == "REFUTED"


def test_what_no_handle_is_is_not_read() -> None:
    with pytest.raises(Unread):
        in_python("function y = f(x)\n g = @sin;\n y = g(x);\nend", "f.m", set().__contains__)
