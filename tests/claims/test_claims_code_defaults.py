"""Numbers of a person's code that are named like parameters stand for them."""

from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import particles
import pytest
from sympy.physics.mechanics import dynamicsymbols

from mechanics import Scene, check, gravity, parameters
from mechanics.cli.load import run_file
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.scene import force

q, F = dynamicsymbols("q F")
m, c, g = parameters("m c g", units="kg N*s/m m/s^2", typical="2 0.5 9.81")


def _mass() -> Scene:
    """A mass that falls, damped and pulled: m q'' = F - c q' - m g."""
    return particles.on_line(
        "falling mass", q, m,
        lambda N, O, P: [
            gravity(-g * N.x), force("F", P, F * N.x), force("c", P, -c * q.diff() * N.x)
        ],
        inputs=(F,),
    )  # fmt: skip


SCENE = _mass()
RIGHT, REFUTED = "PROVED", "REFUTED"


def _verdict(function: object, **options: object) -> str:
    return check(SCENE, function, blame=False, **options).verdict.name


def test_defaults_are_symbols_and_that_is_said() -> None:
    def rate(t, y, F, m=2.0, c=0.5, g=9.81, tolerance=1e-6):  # type: ignore[no-untyped-def]
        return np.array([y[1], (F - c * y[1]) / m - g])

    found = check(SCENE, rate)
    assert found.verdict is Verdict.PROVED
    assert "rate: m = 2.0, c = 0.5, g = 9.81: read as the scene's" in str(found)
    assert "tolerance = 1e-06: the default" in str(found)


@pytest.mark.parametrize(("value", "verdict"), [("9.81", RIGHT), ("-9.81", REFUTED)])
def test_a_number_that_somebody_names_has_the_sign_of_the_parameter(
    tmp_path: Path, value: str, verdict: str
) -> None:
    path = tmp_path / "mine.py"
    path.write_text(
        f"gravity = {value}\ndef rate(y, F, m, c):\n    return [y[1], (F - c*y[1])/m - gravity]\n"
    )
    assert _verdict(run_file(path).rate, names={"gravity": "g"}) == verdict


def test_what_is_no_number_stands_for_no_parameter(tmp_path: Path) -> None:
    path = tmp_path / "mine.py"
    path.write_text(
        "m = float('inf')\ndef rate(y, F, c, g):\n    return [y[1], (F - c*y[1])/m - g]\n"
    )
    with pytest.raises(InputError, match="the constant inf has no exact value"):
        check(SCENE, run_file(path).rate)


def test_a_default_that_is_no_number_is_said() -> None:
    def rate(y, F, m, c, g, unit="SI", drag=True):  # type: ignore[no-untyped-def]
        return np.array([y[1], (F - (c * y[1] if drag else 0)) / m - g])

    found = check(SCENE, rate)
    assert found.verdict is Verdict.PROVED
    assert "unit = 'SI', drag = True: the default" in str(found)


def test_an_input_that_a_partial_gives_one_value_is_not_read_as_the_input() -> None:
    def rate(y, F, m, c, g):  # type: ignore[no-untyped-def]
        return np.array([y[1], (F - c * y[1]) / m - g])

    with pytest.raises(InputError, match="F has one value in a partial"):
        check(SCENE, partial(rate, F=0.0))
    assert _verdict(partial(rate, m=2.0)) == RIGHT


def test_a_default_that_the_parameter_cannot_be_stays_a_number() -> None:
    def down(y, F, m, c, g=-9.81):  # type: ignore[no-untyped-def]
        return np.array([y[1], (F - c * y[1]) / m - g])

    assert _verdict(down) == REFUTED


CAPITALS = """
M = 2.0
C = 0.5
G = 9.81
def rate(y, F):
    return [y[1], (F - C*y[1])/M - G]
def inside(y, F):
    M = 2.0
    return [y[1], (F - C*y[1])/M - G]
def wrong(y, F):
    return [y[1], (F + C*y[1])/M - G]
"""


@pytest.mark.parametrize(
    ("name", "before", "after", "verdict"),
    [
        ("rate", "", "", RIGHT),
        ("inside", "", "", RIGHT),
        ("wrong", "", "", REFUTED),
        ("rate", "G = 9.81", "G = -9.81", REFUTED),
        ("rate", "M = 2.0", "m = 1.0\nM = 2.0", REFUTED),
    ],
)
def test_constants_in_capitals_are_parameters_where_no_other_name_is(
    tmp_path: Path, name: str, before: str, after: str, verdict: str
) -> None:
    path = tmp_path / "mine.py"
    path.write_text(CAPITALS.replace(before, after, 1))
    found = check(SCENE, getattr(run_file(path), name), blame=False)
    assert found.verdict.name == verdict
    assert verdict != RIGHT or "G = 9.81 (g)" in str(found)


FILE = """
import numpy as np
m, c, g = 2, 0.5, 9.81
mass = 2.0

def weight():
    return m*g

def right(y, F):
    return np.array([y[1], (F - c*y[1] - weight())/m])

def wrong(y, F):
    return np.array([y[1], (F + c*y[1] - weight())/m])

def by_other_name(y, F):
    return np.array([y[1], (F - c*y[1])/mass - g])

def counting(y, F):
    global c
    c = c + 1
    return np.array([y[1], (F - c*y[1] - weight())/m])

def around(m=3.0):
    def inner(y, F):
        return np.array([y[1], (F - c*y[1])/m - g])
    return inner
inner = around()

class Fall:
    g = 9.81
    def __init__(self):
        self.m, self.c = 2.0, 0.5
    def rate(self, y, F):
        return np.array([y[1], (F - self.c*y[1])/self.m - self.g])
    def wrong(self, y, F):
        return np.array([y[1], (F - self.c*y[1])/self.m - 2*self.g])
    def __call__(self, y, F):
        return self.rate(y, F)
fall = Fall()
"""


@pytest.fixture(name="module")
def _module(tmp_path: Path):  # type: ignore[no-untyped-def]
    path = tmp_path / "falls.py"
    path.write_text(FILE, encoding="utf-8")
    return run_file(path)


def test_numbers_of_the_file(module: SimpleNamespace) -> None:
    found = check(SCENE, module.right)
    assert found.verdict is Verdict.PROVED
    words = "right: c = 0.5, m = 2, g = 9.81 of the code: read as the scene's, for all values"
    assert words in " ".join(str(found).split())
    assert module.m == 2
    assert _verdict(module.wrong) == REFUTED
    assert _verdict(module.inner) == RIGHT
    # What changes what it holds is not what it was traced as.
    assert _verdict(module.counting) not in (RIGHT, "CERTIFIED")


def test_numbers_of_the_file_by_other_names(module: SimpleNamespace) -> None:
    assert _verdict(module.by_other_name) == REFUTED
    assert _verdict(module.by_other_name, names={"mass": "m"}) == RIGHT


def test_numbers_of_an_object(module: SimpleNamespace) -> None:
    assert _verdict(module.fall.rate) == RIGHT
    assert _verdict(module.fall) == RIGHT
    assert _verdict(module.fall.wrong) == REFUTED
    assert module.fall.m == 2.0


def test_arguments_by_the_names_of_their_entries() -> None:
    def by_key(y, F, p):  # type: ignore[no-untyped-def]
        return np.array([y[1], (F - p["c"] * y[1]) / p["m"] - p["g"]])

    def by_attribute(y, F, p):  # type: ignore[no-untyped-def]
        return np.array([y[1], (F - p.c * y[1]) / p.m - p.g])

    def at_once(y, F, p):  # type: ignore[no-untyped-def]
        g, m, c = p
        return np.array([y[1], (F - c * y[1]) / m - g])

    def one_by_one(y, F, p):  # type: ignore[no-untyped-def]
        g = p[0]
        m = p[1]
        c = p[2]
        return np.array([y[1], (F - c * y[1]) / m - g])

    for function in (by_key, by_attribute, at_once, one_by_one):
        assert _verdict(function) == RIGHT, function.__name__

    def other_key(y, F, p):  # type: ignore[no-untyped-def]
        return np.array([y[1], (F - p["c"] * y[1]) / p["mass"] - p["g"]])

    with pytest.raises(InputError, match=r"p\[\"mass\"\] in line \d+: the scene has no 'mass'"):
        check(SCENE, other_key)
    assert _verdict(other_key, names={"mass": "m"}) == RIGHT


def test_u_beside_a_state_is_the_input_and_a_guessed_order_is_said() -> None:
    def rate(t, y, u, p):  # type: ignore[no-untyped-def]
        return np.array([y[1], (u - p[0] * y[1]) / p[2] - p[1]])

    found = check(SCENE, rate)
    assert found.verdict is Verdict.PROVED
    told = {match.name: (match.meaning, match.why) for match in found.names}
    assert told["u"][0] == "F"
    assert "--name 'p=c g m'" in told["p"][1]


def test_what_fails_is_named_with_its_line_and_what_to_say() -> None:
    def rate(y, F, p):  # type: ignore[no-untyped-def]
        first, second = p[:2]
        _a, _b, _d, _e = list(p)
        return np.array([first, second])

    words = r"too many|not enough values to unpack.*in line \d+: _a, _b, _d, _e = list\(p\)"
    with pytest.raises(InputError, match=words) as caught:
        check(SCENE, rate)
    assert "p is read as c g m: if it is not, give --name 'p=...'" in str(caught.value)
    assert "\n" not in str(caught.value)


C = """
void fall(const double p[3], const double y[2], double F, double dy[2])
{
    double g = p[0], m = p[1] /* kg */, c = p[2];
    dy[0] = y[1]; dy[1] = (F - c*y[1])/m - g;
}
"""


def test_c_takes_its_parameters_apart_in_its_own_order() -> None:
    found = check(SCENE, C, notation="c")
    assert found.verdict is Verdict.PROVED
    assert any(match.name == "p" and match.meaning == "g m c" for match in found.names)


def test_all_that_is_missing_is_told_at_once_with_the_options_that_give_it() -> None:
    scene = _mass()
    text = (
        "double f(double psi, double omega_9, const double *zeta) { return psi*omega_9*zeta[0]; }"
    )
    with pytest.raises(InputError) as told:
        check(scene, text, notation="c")
    for name in ("psi", "omega_9", "zeta"):
        assert f"--name '{name}=...'" in str(told.value)

    def of_records(p):
        return p["mass"] * p["m"] / p["length"]

    with pytest.raises(InputError) as told:
        check(scene, of_records)
    for name in ("mass", "length"):
        assert f"--name '{name}=...'" in str(told.value)
    assert "'m=" not in str(told.value)
