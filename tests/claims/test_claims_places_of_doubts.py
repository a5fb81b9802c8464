"""What is not read says where it stands, whichever step of the reading gave it up."""

import re

import pytest

from mechanics.claims.read import read_source
from mechanics.errors import InputError
from systems import rod_pendulum

TEXTS = {
    "characters": "theta_dd = 3*u/(m*l^2) + \nE = m*l^2*w @ 2",
    "a name without its value": "D = m +* l;\nE = D*theta_d^2/2;\ntheta_dd = 3*u/(m*l^2);",
    "another step than Euler's": "function zn = f(z, h)\nzn(1) = z(1) + h*h*z(2);\n"
    "zn(2) = z(2) + 2*h*3*g/(2*l)*sin(z(1));\nend\n",
    "parts of a model": "model Arm\n  Real theta;\nequation\n  der(der(theta)) = g/l;\nend Arm;\n"
    "model Two\n  Arm a;\n  Arm b;\nequation\n  a.theta = b.theta;\nend Two;\n",
    "a display": r"\[ \ddot\theta = \frac{3u}{ml^2} \] and \[ E = ml^2 @ 2 \]",
}


@pytest.mark.parametrize("name", TEXTS)
def test_what_is_not_read_has_a_line_and_a_column(name: str) -> None:
    text = TEXTS[name]
    notation = "latex" if "\\" in text else "text"
    try:
        found = read_source(rod_pendulum.scene(), text, notation=notation, origin="page")
        doubts = [s.doubt for s in found.statements if s.row is None]
    except InputError as error:
        doubts = [str(error)]
    assert doubts
    for doubt in doubts:
        assert re.match(r"page, line \d+, column \d+: ", doubt), doubt
        assert doubt.count(", line ") == 1
