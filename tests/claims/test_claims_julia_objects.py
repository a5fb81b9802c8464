"""Julia: what objects are called with, fields in functions that others call, arguments unused."""

from functools import partial
from pathlib import Path

import pytest

from mechanics import check
from mechanics.errors import InputError
from systems import double_pendulum, rod_pendulum
from tests.verdict_of import verdict_in

SCENE = rod_pendulum.scene()
ROD = """struct Rod
    m
    l
    g
end
function push(rod::Rod, x)
    (; m, l, g) = rod
    θ, ω = x
    return 3g/(2l)*sin(θ)
end
function (rod::Rod)(dx, x, u, t)
    dx[1] = x[2]
    dx[2] = push(rod, x) + 3u/(rod.m*rod.l^2)
end
"""
PLAIN = """function f!(dx, x, u, t; m, l, g, kwargs...)
    dx[1] = x[2]
    dx[2] = 3g/(2l)*sin(x[1]) + 3u/(m*l^2)
end
"""
ONE = "function f(ddθ, dθ, θ, u, m, l, g)\n    ddθ[1] = 3g/(2l)*sin(θ[1]) + 3u/(m*l^2)\nend\n"


_verdict = partial(verdict_in, SCENE, "rod.jl")


@pytest.mark.parametrize(
    "text",
    [ROD, PLAIN, ONE, ROD.replace("(; m, l, g) = rod", "m, l, g = rod.m, rod.l, rod.g"),
     ROD.replace("push(rod, x) +", "push(rod, [x[1], 0]) +"),
     PLAIN.replace("t; m", "t, more...; m")],
)  # fmt: skip
def test_what_is_right_is_proved(text: str, tmp_path: Path) -> None:
    assert _verdict(text, tmp_path) == "PROVED"


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("text", "old", "new"),
    [
        (ROD, "3g/(2l)", "3g/l"),
        (ROD, "+ 3u/", "- u/"),
        (ROD, "θ, ω = x", "ω, θ = x"),
        (ROD, "push(rod, x)", "push(other, x)"),
        (ROD, "push(rod, x)", "push(x, rod)"),
        (ROD, "push(rod, x)", "push(Rod(1, 2, 3), x)"),
        (ROD, "push(rod, x)", "2push(rod, x)"),
        (ROD, "    dx[1] = x[2]\n", "    dx[1] = x[2]\n    l = 2rod.l\n"),
        (ROD, "    dx[1] = x[2]\n", "    rod = x\n    dx[1] = x[2]\n"),
        (ROD, "push(rod, x)", "push(u, x)"),
        (ROD, "(; m, l, g) = rod", "(; m, l, g) = rod; l = 2l"),
        (ROD, "function push", "sin(x) = x\nfunction push"),
        (ROD, "function (rod::Rod)(dx", "function (rod::Rod)(dx, x)\n dx[1] = x\nend\n"
         "function (rod::Rod)(dx"),
        (PLAIN, "3g/(2l)", "3g/(2l)*kwargs"),
        (PLAIN, "dx[2] = 3", "dx[2] = kwargs[:a]*3"),
        (PLAIN, "3g/(2l)", "g/l"),
        (PLAIN, "dx[1] = x[2]", "dx[1] = x[1]"),
        (ONE, "θ[1]", "θ[2]"),
        (ONE, "sin(θ[1])", "sin(dθ[1])"),
        (ONE, "3g/(2l)", "g/l"),
        (ONE, "    ddθ", "    θ[1] = 2θ[1]\n    ddθ"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_not_proved(text: str, old: str, new: str, tmp_path: Path) -> None:
    assert old in text
    assert _verdict(text.replace(old, new), tmp_path) in ("REFUTED", "UNDECIDED", "not read")


def test_a_wrong_factor_of_an_object_is_refuted(tmp_path: Path) -> None:
    assert _verdict(ROD.replace("3g/(2l)", "3g/l"), tmp_path) == "REFUTED"
    assert _verdict(ONE.replace("3u", "5u"), tmp_path) == "REFUTED"
    assert _verdict(PLAIN.replace("3u", "5u"), tmp_path) == "REFUTED"


def test_an_entry_with_the_name_of_a_momentum_is_no_speed(tmp_path: Path) -> None:
    scene = double_pendulum.scene()
    first, second = (str(q) for q in scene.q)
    text = f"function f(dy, y, p, t)\n    {first}, {second}, p_{first}, p_{second} = y\n"
    text += f"    dy[1] = p_{first}\n    dy[2] = p_{second}\n    dy[3] = 0*{first}\n"
    text += f"    dy[4] = 0*{second}\nend\n"
    path = tmp_path / "own.jl"
    path.write_text(text)
    with pytest.raises(InputError, match="argument y: nothing says what it is"):
        check(scene, path, blame=False)


@pytest.mark.parametrize(
    "text",
    [
        PLAIN.replace("dx[1] =", "for g in 1:2\n    end\n    dx[1] ="),
        PLAIN.replace("dx[1] =", "k = 3\n    for k in 1:2\n    end\n    dx[1] =")
        .replace("3g/", "k*g/"),
        PLAIN.replace("sin(x[1])", "(q = x[1]; sin(q))"),
    ],
)  # fmt: skip
def test_a_name_of_a_loop_is_another_one_outside(text: str, tmp_path: Path) -> None:
    assert _verdict(text, tmp_path) == "not read"
    loop = PLAIN.replace("dx[1] = x[2]", "for k in 1:1\n    dx[k] = x[k + 1]\n    end")
    assert _verdict(loop, tmp_path) == "PROVED"
